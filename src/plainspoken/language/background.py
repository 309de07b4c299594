"""What stands behind a demand and is none itself: why it is made, and the mission as a whole.

"Site 3 is flooded, so keep out of it" demands nothing of the flood; the words of such a clause may
be unknown, as long as what follows is a demand that the clause only gives a reason for. An unknown
word within the demand itself, or in a condition ("if it is flooded"), is never passed over.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from plainspoken.language.item import Item
from plainspoken.language.lexicon import Kind
from plainspoken.language.reference import Form

_TELLER_WORDS = """
    i we they he she it this that there here nobody everybody everyone somebody someone
    the a an my our their his her some these those all another
"""
_TELLERS = frozenset(_TELLER_WORDS.split())
_REASONS = frozenset(("since", "because", "now that", "given that", "seeing that"))
_HENCE = frozenset(("so", "hence", "therefore", "thus", "consequently", "accordingly"))
_BACK = frozenset(("there", "it", "that", "them", "here", "those", "this", "these"))
_MARKS = frozenset((Kind.COMMA, Kind.STOP))
_DEMANDS = frozenset(
    (Kind.GO, Kind.AVOID, Kind.STAY, Kind.LEAVE, Kind.PATROL, Kind.NOT, Kind.NEVER, Kind.MUST,
     Kind.ENSURE, Kind.FORBIDDEN)
)  # fmt: skip
_FORCE = frozenset(
    (Kind.MUST, Kind.MAY, Kind.ENSURE, Kind.COUNT, Kind.NEVER, Kind.FORBIDDEN, Kind.WHEN,
     Kind.WHENEVER, Kind.AFTER, Kind.PROMPTLY, Kind.BEFORE, Kind.UNTIL, Kind.UNLESS, Kind.WHILE,
     Kind.WITHOUT, Kind.ONLY_IF, Kind.ONLY_AFTER, Kind.ONLY_RIGHT_AFTER, Kind.IFF,
     Kind.ELSEWHERE, Kind.LEADS, Kind.PRECEDED, Kind.OR, Kind.ALWAYS)
)  # fmt: skip
_ENDING_WORDS = """
    complete completes completed completing finish finishes finished finishing end ends ended
    ending conclude concludes concluded concluding done doing stop stops stopped accomplish
    accomplishing accomplished wrap fulfil fulfill carry
"""
_ENDING = frozenset(_ENDING_WORDS.split())
_JOINTS = frozenset((Kind.COMMA, Kind.STOP, Kind.THEN, Kind.AND, Kind.BUT, Kind.ONLY_THEN))
_ROUNDS = frozenset((Kind.PATROL, Kind.ALTERNATE, Kind.AGAIN_AND_AGAIN))
_OPERATING = frozenset(
    ("operate", "run", "running", "work", "working", "live", "lasts", "last", "active", "operating",
     "powered", "duty", "function", "continue", "continues", "exist", "shift")
)  # fmt: skip
_MISSION_WORDS = """
    mission task tasks job jobs assignment goal goals everything errand errands plan run tour
    trip route work
"""
_MISSION = frozenset(_MISSION_WORDS.split())


def without_background(found: Sequence[Item]) -> tuple[Item, ...]:
    """The items with what only gives a reason, or speaks of the mission as a whole, set aside."""
    made = _framed(list(found))
    pieces = list(_pieces(made))
    kept: list[Item] = []
    for place, piece in enumerate(pieces):
        demands = [each for each in (*pieces[:place], *pieces[place + 1 :]) if _demands(each)]
        led = place + 1 < len(pieces) and _is_led(piece, pieces[place + 1])
        if _is_reason(piece, place) and demands and (led or _is_trailing(pieces, place)):
            kept += [replace(each, kind=Kind.FILLER) for each in piece if each.reference]
            kept += [each for each in piece if each.kind is Kind.STOP]
            if led and pieces[place + 1][0].text in _HENCE:
                del pieces[place + 1][0]
        else:
            kept += piece
    return tuple(kept)


def _pieces(made: Sequence[Item]) -> Iterator[list[Item]]:
    """The items between marks and before "so" and "because"."""
    piece: list[Item] = []
    for item in made:
        if piece and (item.text in _HENCE or _gives_reason(item)):
            yield piece
            piece = []
        piece.append(item)
        if item.kind in _MARKS:
            yield piece
            piece = []
    if piece:
        yield piece


def _gives_reason(item: Item) -> bool:
    return item.kind is Kind.WHEN and item.text in _REASONS


def _demands(piece: Sequence[Item]) -> bool:
    return any(item.kind in _DEMANDS for item in piece)


def _is_reason(piece: Sequence[Item], place: int) -> bool:
    """Whether a piece tells, in words that are not all known, how things are."""
    own = [item for item in piece if item.kind not in _MARKS]
    given = bool(own) and _gives_reason(own[0])
    own = own[1:] if given else own
    if not any(item.kind is Kind.UNKNOWN for item in own) or own[0].text in _HENCE:
        return False
    if any(item.kind in _FORCE for item in own):
        return False
    for index, item in enumerate(own):
        denies = item.kind is Kind.NOT and index and own[index - 1].kind is not Kind.BE
        if denies and item.text != "no":
            return False
    first = own[0]
    told = first.text.split()[0] in _TELLERS or first.form is Form.NOUN
    finite = any(item.kind is Kind.BE or item.text in ("have", "has", "had") for item in own)
    relative = first.kind is Kind.RELATIVE and first.text in ("which", "that", "who")
    if relative:
        return finite and bool(place) and not any(item.reference for item in own)
    return (told and (finite or first.text.split()[0] in _TELLERS)) or (given and told) or (
        finite and first.kind is Kind.UNKNOWN
    )  # fmt: skip


def _is_led(piece: Sequence[Item], following: Sequence[Item]) -> bool:
    """Whether a demand follows that the piece gives the reason for."""
    if not _demands(following):
        return False
    if _gives_reason(piece[0]) or following[0].text in _HENCE:
        return True
    named = {item.reference.symbol for item in piece if item.reference is not None}
    return any(
        item.text in _BACK or item.filled
        or (item.reference is not None and item.reference.symbol in named)
        for item in following
    )  # fmt: skip


def _is_trailing(pieces: Sequence[Sequence[Item]], place: int) -> bool:
    """Whether a piece follows a demand and only says why: "..., it is flooded"."""
    piece = pieces[place]
    if not place or not _demands(pieces[place - 1]):
        return False
    first = next((item for item in piece if item.kind not in _MARKS), piece[0])
    if _gives_reason(first) or first.kind is Kind.RELATIVE:
        return True
    named = {item.reference.symbol for item in pieces[place - 1] if item.reference is not None}
    points = first.filled or first.text.split()[0] in ("it", "there", "that", "they") or (
        first.reference is not None and first.reference.symbol in named
    )  # fmt: skip
    return points and any(item.kind is Kind.BE for item in piece)


def _framed(made: list[Item]) -> list[Item]:
    """Pass over "before completing the mission"; "not finish without" asks, "finish without" bars.

    What is to be done of the mission as a whole is no demand, only what is said along with it.
    """
    for index, item in enumerate(made):
        if item.kind is Kind.BEFORE and _ends_mission(made, index + 1):
            for place in range(index, _mission_end(made, index + 1)):
                made[place] = replace(made[place], kind=Kind.FILLER)
            # "do not revisit it before completing the mission"
            made[index] = replace(made[index], kind=Kind.NO_RETURN)
        if item.text == "between" and any(each.kind in _ROUNDS for each in made):
            made[index] = replace(item, kind=Kind.FILLER)
        if item.kind is Kind.WHILE and _lasts(made[index + 1 :]):
            for place in range(index + 1, len(made)):
                if made[place].kind in _MARKS:
                    break
                made[place] = replace(made[place], kind=Kind.FILLER)
            made[index] = replace(item, kind=Kind.ALWAYS)
        if item.kind is Kind.WITHOUT and _elsewhere(made[index + 1 :]):
            end = next((i for i in range(index, len(made)) if made[i].kind in _JOINTS), len(made))
            made[index] = replace(item, kind=Kind.IN_ORDER)  # "... any other place, then b"
            for place in range(index + 1, end):
                made[place] = replace(made[place], kind=Kind.FILLER)
            continue
        if item.kind is not Kind.WITHOUT:
            continue
        start = next(
            (
                place + 1
                for place in range(index - 1, -1, -1)
                if made[place].kind in (*_MARKS, Kind.AND, Kind.BUT, Kind.THEN)
            ),
            0,
        )
        lead = made[start:index]
        said = {word for each in lead for word in each.text.split()}
        if not said & _ENDING or any(each.reference for each in lead):
            continue
        denied = sum(
            each.kind in (Kind.NOT, Kind.NEVER, Kind.FORBIDDEN, Kind.ONLY_AFTER) for each in lead
        )
        turned = Item(Kind.ENSURE, lead[0].first, item.last, "make sure")
        rest = made[index + 1 :]
        if denied % 2 == 0:
            turned = Item(Kind.NOT, lead[0].first, item.last, "not")
        else:
            rest = [_at_least(each) for each in rest]
        if rest and rest[0].kind is Kind.AFTER and rest[0].text.startswith("having"):
            rest[0] = replace(rest[0], kind=Kind.GO, form=Form.BASE)
        return [*made[:start], turned, *_framed(rest)]
    return made


def _elsewhere(rest: Sequence[Item]) -> bool:
    """Whether "visiting any other place", "stopping anywhere else" follows."""
    end = next((i for i, item in enumerate(rest) if item.kind in _JOINTS), len(rest))
    words = {word for item in rest[:end] for word in item.text.split()}
    return bool(words & {"other", "else", "others", "elsewhere"}) and not any(
        item.reference for item in rest[:end]
    )


def _lasts(rest: Sequence[Item]) -> bool:
    """Whether "as long as you operate" follows, up to the next mark."""
    end = next((i for i, item in enumerate(rest) if item.kind in _MARKS), len(rest))
    words = {word for item in rest[:end] for word in item.text.split()}
    return not words.isdisjoint(_OPERATING) and not any(item.reference for item in rest[:end])


def _at_least(item: Item) -> Item:
    """Read "not without going there twice" as twice or more."""
    if item.count is None or item.count.bound:
        return item
    return replace(item, count=replace(item.count, bound=">="))


def _ends_mission(made: Sequence[Item], index: int) -> bool:
    words = [word for item in made[index : index + 5] for word in item.text.split()][:5]
    return bool(words) and words[0] in _ENDING and any(word in _MISSION for word in words)


def _mission_end(made: Sequence[Item], index: int) -> int:
    """The item after the one that says "the mission"."""
    return next(
        place + 1
        for place in range(index, len(made))
        if not _MISSION.isdisjoint(made[place].text.split())
    )
