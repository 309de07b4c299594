"""What only colours an utterance, told from what it asks for: time frames, courtesy, remarks.

A word that neither the lexicon nor the domain knows may be an argument or a condition, and then
the utterance is not understood. It is passed over only where its surroundings show that it is
neither: it names a stretch of time, it stands in a piece between marks that speaks of nothing in
the domain and orders nothing, or it is a verb of motion before a place.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from plainspoken.language.background import without_background
from plainspoken.language.item import Item
from plainspoken.language.lexicon import Kind
from plainspoken.language.ordering import with_orders
from plainspoken.language.pronoun import with_pronouns
from plainspoken.language.reference import Form
from plainspoken.language.word import Word

_TIME_WORDS = """
    day days night nights evening morning afternoon shift run tour session hour hours week
    month year closing opening start beginning end finish tomorrow tonight noon midnight dawn
    dusk period service weekend season course rest remainder duration long round rounds while
    occasion stage
"""
_TIME = frozenset(_TIME_WORDS.split())
_REMAINING = frozenset(("rest", "remainder"))
_LASTING = frozenset(("whole", "entire", "all", "throughout", "complete", "full", "long"))
_COURTESY_WORDS = """
    mate pal buddy friend dear folks guys chief boss sir madam yeah yep yes right lad love
    cheers ta honestly frankly basically seriously definitely certainly absolutely naturally
    obviously actually somehow anyway anyhow simply special simple old single sort mean though
    strictly otherwise next fine merely presence attendance appearance destination target
    entrance arrival dispatch yourself itself first fully altogether roughly plainly
"""
_COURTESY = frozenset(_COURTESY_WORDS.split())
_EMPHASIS_WORDS = """
    exceptions exception excuses excuse rush hurry dawdling dallying delay doubt worries worry
    problem need ifs buts matter questions question hesitation discussion debate more fewer less
    breaks break shortcuts detours often zero several extra additional fewer seldom rarely
"""
_EMPHASIS = frozenset(_EMPHASIS_WORDS.split())
_TELLERS = frozenset(
    ("i", "we", "they", "he", "she", "it", "this", "that", "there", "nobody", "everybody",
     "everyone", "somebody", "someone", "whatever", "whichever", "the", "a", "an", "my", "our",
     "your", "their", "his", "her", "its", "some", "these", "those", "all")
)  # fmt: skip
_SPEECH = frozenset(("ask", "say", "want", "order", "insist", "demand", "request", "wish",
                     "suggest", "expect", "require", "command"))  # fmt: skip
_ORDERS = frozenset(("order", "sequence"))
_TOWARDS = frozenset(
    ("to", "into", "in", "at", "by", "past", "through", "over", "via", "towards", "toward",
     "onto", "on", "across", "along", "for", "inside", "near", "round", "around", "beyond",
     "down", "up", "out", "off", "back", "away", "about", "ahead", "way", "your", "its")
)  # fmt: skip
_PARTICLES = frozenset(("down", "up", "out", "off", "back", "away", "about", "ahead", "way",
                        "your", "its", "round", "over", "along", "yourself", "on"))  # fmt: skip
_STATIC = frozenset(("in", "at", "on", "inside", "near", "for"))
"""Where something is done, not where it leads to: "juggle in the yard"."""
_JOINTS = frozenset((Kind.COMMA, Kind.STOP))
_STARTS = frozenset(
    (Kind.COMMA, Kind.STOP, Kind.AND, Kind.OR, Kind.BUT, Kind.THEN, Kind.ONLY_THEN, Kind.MUST,
     Kind.MAY, Kind.SUBJECT, Kind.ENSURE, Kind.NOT, Kind.NEVER, Kind.FIRST, Kind.LATER,
     Kind.LATER_ON, Kind.AFTER_THAT, Kind.ALWAYS, Kind.NEXT, Kind.ONLY, Kind.BEFORE_THAT,
     Kind.WHEN, Kind.WHENEVER, Kind.AFTER, Kind.BEFORE, Kind.UNTIL, Kind.PROMPTLY,
     Kind.WITHOUT, Kind.WHILE, Kind.UNLESS)
)  # fmt: skip
_FRAMES = frozenset((Kind.WHILE, Kind.BEFORE, Kind.AFTER, Kind.UNTIL))
_DEMANDS = frozenset((Kind.NOT, Kind.NEVER, Kind.AVOID, Kind.FORBIDDEN, Kind.PATROL, Kind.COUNT))
_FORCE = frozenset(
    (Kind.MUST, Kind.ENSURE, Kind.COUNT, Kind.WHEN, Kind.WHENEVER, Kind.AFTER, Kind.PROMPTLY,
     Kind.BEFORE, Kind.UNTIL, Kind.UNLESS, Kind.WHILE, Kind.WITHOUT, Kind.ONLY_IF,
     Kind.ONLY_AFTER, Kind.ONLY_RIGHT_AFTER, Kind.IFF, Kind.ELSEWHERE, Kind.LEADS,
     Kind.PRECEDED)
)  # fmt: skip


def without_colour(found: Sequence[Item], said: Sequence[Word]) -> tuple[Item, ...]:
    """The items without what only colours them; UNKNOWN is left where a word may matter."""
    if not any(item.kind is Kind.REFERENCE for item in found):
        return tuple(found)
    made = list(found)
    _motion(made)
    _reported(made, said)
    _timed(made, said)
    kept: list[Item] = []
    plain = with_orders(with_pronouns(without_background(made)))
    for piece in _pieces(plain):
        kept += _piece(piece)
    return tuple(kept)


def _motion(made: list[Item]) -> None:
    """Take any verb before a place that it leads to for one of motion: "amble over to"."""
    for index, item in enumerate(made):
        if item.kind is not Kind.UNKNOWN:
            continue
        before = next(
            (each for each in reversed(made[:index]) if each.kind is not Kind.FILLER), None
        )
        own = made[index - 1].text if index else ""
        if own in ("the", "a", "an") or not (before is None or before.kind in _STARTS):
            continue
        after = index + 1
        led = ""
        while after < len(made) and made[after].text in _TOWARDS | {"the", "a", "an"}:
            if made[after].text in _TOWARDS:
                led = made[after].text
            after += 1
        place = after < len(made) and made[after].form is Form.NOUN
        leads = led not in _PARTICLES | _STATIC or led in ("round", "over", "along")
        if place and led and leads:
            form = Form.GERUND if item.text.endswith("ing") else Form.BASE
            made[index] = replace(item, kind=Kind.GO, form=form)
            for place_ in range(index + 1, after):
                if made[place_].kind is Kind.UNKNOWN:
                    made[place_] = replace(made[place_], kind=Kind.FILLER)


def _reported(made: list[Item], said: Sequence[Word]) -> None:
    """Read "the boss asks that you ..." and "it would be lovely if ..." as a wish."""
    for index, item in enumerate(made):
        start = next((i + 1 for i in range(index - 1, -1, -1) if made[i].kind in _JOINTS), 0)
        lead = made[start:index]
        if not any(each.kind is Kind.UNKNOWN for each in lead) or any(
            each.kind in (Kind.REFERENCE, *_FORCE) for each in lead
        ):  # fmt: skip
            continue
        spoken = any(said[each.first].stems & _SPEECH for each in lead)
        polite = any(each.text in ("would", "could") for each in lead) and (
            lead[0].text in ("i", "we", "it", "that")
        )
        if (spoken and item.text == "that") or (polite and item.text == "if"):
            wish = Item(Kind.ENSURE, lead[0].first, item.last, "so that")
            made[start : index + 1] = [wish]
            return


def _timed(made: list[Item], said: Sequence[Word]) -> None:
    """Read "the whole evening" as always, "for the rest of the day" as from then on."""
    for index, item in enumerate(made):
        if item.kind is not Kind.UNKNOWN or item.text not in _TIME:
            continue
        near = {word.text for word in said[max(item.first - 4, 0) : item.last + 1]}
        if near & _REMAINING and item.text not in _REMAINING:
            kind = Kind.AFTER_THAT
        elif near & _LASTING and item.text not in _REMAINING:
            kind = Kind.ALWAYS
        else:
            kind = Kind.FILLER
        made[index] = replace(item, kind=kind)
        back = index - 1
        if back >= 0 and made[back].kind is Kind.BOTH:
            made[back] = replace(made[back], kind=Kind.FILLER)  # "all day"
        while back >= 0 and made[back].kind in (Kind.FILLER, Kind.UNKNOWN) and (
            made[back].text not in ("to", "at") or made[back].text in _TIME
        ):  # fmt: skip
            back -= 1
        if back >= 0 and made[back].kind in _FRAMES and _is_frame(made, back):
            made[back] = replace(made[back], kind=Kind.FILLER)


def _is_frame(made: Sequence[Item], index: int) -> bool:
    """Whether a connector begins a mere time frame: nothing of the domain follows it."""
    for item in made[index + 1 :]:
        if item.kind in _JOINTS:
            return True
        if item.kind in (Kind.REFERENCE, Kind.IT_HAPPENS):
            between = made[index + 1 : made.index(item)]
            return all(each.kind is not Kind.BE for each in between)
    return True


def _pieces(made: Sequence[Item]) -> Iterator[list[Item]]:
    """The items between marks, each piece with the mark that ends it."""
    piece: list[Item] = []
    for item in made:
        piece.append(item)
        if item.kind in _JOINTS:
            yield piece
            piece = []
    if piece:
        yield piece


def _piece(piece: list[Item]) -> list[Item]:
    """A piece without its colour; of one that only colours the rest, the mark alone."""
    if not any(item.kind is Kind.UNKNOWN for item in piece):
        return piece
    end = [item for item in piece if item.kind is Kind.STOP]
    if not any(item.kind is Kind.REFERENCE for item in piece):
        if any(item.text in _ORDERS for item in piece) and not any(
            item.text in ("that", "this", "given") for item in piece
        ):
            free = next(item for item in piece if item.text in _ORDERS)
            return [replace(free, kind=Kind.ANY_ORDER), *end]
        if _is_colour(piece):
            return end
    return [
        replace(item, kind=Kind.FILLER)
        if item.kind is Kind.UNKNOWN and item.text in _COURTESY
        else item
        for item in piece
    ]


def _is_colour(piece: Sequence[Item]) -> bool:
    """Whether a piece that speaks of nothing in the domain orders nothing, either."""
    own = [item for item in piece if item.kind not in _JOINTS]
    if any(item.kind in _FORCE for item in own):
        return False
    if own[0].text == "however" and len(own) > 1:
        return True  # "..., however much later, ..."
    first = own[0]
    unknown = [item for item in own if item.kind is Kind.UNKNOWN]
    if all(item.text in _EMPHASIS | _COURTESY | _TIME for item in unknown):
        return True
    if piece[-1].text == ":" and not any(item.kind in _DEMANDS for item in own):
        return True  # "four rooms want a visit: ..."
    if any(item.text.isdigit() for item in unknown):
        return False
    if first.kind in (Kind.NOT, Kind.NEVER):
        return first.text.split()[0] in ("nobody", "no") and len(own) > 2
    return first.text.split()[0] in _TELLERS or _is_owned(own)


def _is_owned(own: Sequence[Item]) -> bool:
    """Whether it begins with whose it is: "cook's orders"."""
    return len(own) > 2 and own[1].text == "'s" and own[0].kind is Kind.UNKNOWN
