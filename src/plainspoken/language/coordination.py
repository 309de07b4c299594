"""What is said of several things at once, spread over each of them.

"The jar and the can are sealed", "all jars", "every site but site 2", "none of them": the words
that are said of one are repeated for the others, so that each has its own referring expression.
Words that are repeated carry the place of the thing that they are repeated for.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from plainspoken.language.frame import ARTICLES, Mention, Thing
from plainspoken.language.grounding import PREPOSITIONS, Shape, Vocabulary
from plainspoken.language.lexicon import PHRASES, Kind, is_general
from plainspoken.language.reference import Form, Reference, references
from plainspoken.language.relative import unfolded
from plainspoken.language.repetition import of_each
from plainspoken.language.word import Word, stems

_EACH = frozenset(("every", "each", "all", "any", "both", "none", "no", "either", "neither"))
_WHOLE = frozenset(("everything", "anything", "nothing", "everyone", "anyone"))
_THINGS = frozenset(("thing", "things", "item", "items", "object", "objects", "them", "those"))
_EXCEPT = frozenset(("except", "but", "save"))
_JOINTS = {"and": "and", "or": "or", "nor": "nor", "&": "and"}
_DENIALS = frozenset(("never", "not", "no", "avoid", "without", "none", "neither", "nor"))
_BOUNDS_WORDS = """
    if when whenever while once until till unless before after that which where . ; ! ?
    :
"""
_BOUNDS = frozenset(_BOUNDS_WORDS.split())
_FAR = 10
"""Words to either side in which what is said of "all of them" is looked for."""
_SMALL = ARTICLES | frozenset(("of", "these", "those", "my", "our", "your", "its", "their"))
_PASSING = frozenset(("at", "least", "just", "exactly", "of", "them", "these", "the", ","))
_CHOOSING = {"one": "or", "either": "or", "both": "and", "each": "and", "all": "and"}


def spread(said: tuple[Word, ...], vocabulary: Vocabulary) -> tuple[Word, ...]:
    """Repeat what is said of several things for each of them."""
    said = unfolded(said, vocabulary, _members)
    return _listed(_quantified(said, vocabulary), vocabulary)


# Lists: "the jar, the can or the tin".


def _listed(said: tuple[Word, ...], vocabulary: Vocabulary) -> tuple[Word, ...]:
    index = 0
    while index < len(said):
        found = _mentions(said, index, vocabulary)
        if found is None:
            index += 1
            continue
        mentions, joint, first, after = found
        longer = None
        if joint == "nor":
            # "neither the one nor the other" is no one or other, in a condition, too.
            joint = "or"
            if first and said[first - 1].text == "neither":
                said = (*said[: first - 1], replace(said[first - 1], text="no"), *said[first:])
        if not _is_visited(said, first, mentions, vocabulary) and not _are_told(
            said, mentions, vocabulary
        ):
            longer = of_each(said, (first, after), _own_words(said, mentions), joint, vocabulary)
        if longer is None or longer.count < len(mentions):
            index = mentions[-1].last
            continue
        said, index = longer.said, longer.after
    return said


def _own_words(said: Sequence[Word], mentions: Sequence[Mention]) -> list[tuple[Word, ...]]:
    """The words of each thing of a list; a number that stands alone gets its noun."""
    found = []
    for each in mentions:
        own = said[each.first : each.last]
        if len(own) < len(each.thing):
            own = tuple(Word(text, own[0].start, own[-1].end) for text in each.thing)
        found.append(tuple(own))
    return found


def _mentions(
    said: Sequence[Word], index: int, vocabulary: Vocabulary
) -> tuple[list[Mention], str, int, int] | None:
    """A list of things from a word on: its members, how they are joined, where it is."""
    frames = vocabulary.frames
    first = frames.mentioned(said, index)
    if first is None:
        return None
    members, joint, place = [first], "", first.last
    while True:
        link, behind = _link(said, place)
        member = _member(said, behind, members[-1], vocabulary) if link else None
        if member is None:
            break
        members.append(member)
        joint = _JOINTS.get(link, joint)
        place = member.last
    if not joint or len(members) < 2 or len({each.thing for each in members}) < len(members):
        return None
    start = index
    while start and said[start - 1].text in ("the", "both", "either"):
        start -= 1
        joint = "or" if said[start].text == "either" else joint
    if start > 1 and [word.text for word in said[start - 2 : start]] == ["one", "of"]:
        least = [word.text for word in said[max(start - 4, 0) : start - 2]] == ["at", "least"]
        start, joint = start - (4 if least else 2), "or"
    after = place
    while after < len(said) and said[after].text in _PASSING:
        after += 1
    if after > place and after < len(said) and said[after].text in _CHOOSING:
        joint = _CHOOSING[said[after].text]
        after += 1
        while after < len(said) and said[after].text in ("of", "them", "the", "two", "three"):
            after += 1
        place = after
    elif place < len(said) and said[place].text in ("all", "both", "each"):
        place += 1
    return members, joint, start, place


def _link(said: Sequence[Word], place: int) -> tuple[str, int]:
    """What joins the next member of a list, and where that member may begin."""
    link = ""
    while place < len(said):
        text = said[place].text
        if text == ",":
            link = link or ","
        elif text in _JOINTS:
            link = text
        elif not link or text not in ("the", "a", "an", "also", "either"):
            break
        place += 1
    return link, place


def _member(
    said: Sequence[Word], place: int, before: Mention, vocabulary: Vocabulary
) -> Mention | None:
    if place >= len(said):
        return None
    found = vocabulary.frames.mentioned(said, place)
    if found is None and said[place].number.isdigit() and before.thing[-1].isdigit():
        thing = (*before.thing[:-1], said[place].number)
        return Mention(thing, place, place + 1)
    return found


def _are_told(said: Sequence[Word], mentions: Sequence[Mention], vocabulary: Vocabulary) -> bool:
    """Whether something is said of each already: "the jar is sealed or the can is empty"."""
    told = [
        next((i for i, each in enumerate(found) if each.first <= mention.first < each.last), None)
        for found in [[r for r in references(said, vocabulary) if _is_told(r, said)]]
        for mention in mentions
    ]
    return None not in told and len(set(told)) == len(told)


def _is_told(each: Reference, said: Sequence[Word]) -> bool:
    return each.form is Form.FINITE or said[each.first].joined


def _is_visited(
    said: Sequence[Word], first: int, mentions: Sequence[Mention], vocabulary: Vocabulary
) -> bool:
    """Whether a list of places says where to be: "at one and two", "visit one and two"."""
    if not all(each.thing in vocabulary.frames.places for each in mentions) or not first:
        return False
    before = said[first - 1]
    return before.text in PREPOSITIONS or any(
        pattern == ("~" + stem,) and kind is Kind.GO
        for stem in before.stems
        for pattern, kind in PHRASES.get(stem, ())
    )


# Quantifiers: "every jar", "none of the jars", "everything but the jar".


def _quantified(said: tuple[Word, ...], vocabulary: Vocabulary) -> tuple[Word, ...]:
    index = 0
    while index < len(said):
        word = said[index]
        whole = word.text in _WHOLE
        form = _said_as(said, index, vocabulary) if word.text in _EACH else None
        if (whole and not _is_general_act(said, index, vocabulary)) or (
            index + 1 < len(said) and word.text in _EACH and form in (None, Form.FINITE)
        ):
            start = index if whole else _noun_of(said, index)
            members = _members(said, index, start, vocabulary)
            if len(members) > 1:
                wider = _over(said, index, start, members, vocabulary, only=form is not None)
                if wider is not None:
                    said, index = wider
                    continue
        span = _range(said, index, vocabulary)
        if span is not None:
            listed = _as_list(word, span, "and")
            said = (*said[:index], *listed, *said[index + 4 :])
            index += len(listed)
            continue
        index += 1
    return said


def _is_general_act(said: Sequence[Word], index: int, vocabulary: Vocabulary) -> bool:
    """Whether "sweep anything" is the act itself, done to whatever."""
    return said[index].text in ("anything", "anyone") and any(
        each.last in (index, index + 1) and each.shape is Shape.ACT and each.parts == 1
        for each in references(said, vocabulary)
    )


def _noun_of(said: Sequence[Word], index: int) -> int:
    """The noun behind "each", "none of the three", "any of"."""
    start = index + 1
    while start < len(said) - 1 and (
        said[start].text in _SMALL or said[start].text in _EACH or _is_number_of(said, start)
    ):
        start += 1
    return start


def _is_number_of(said: Sequence[Word], index: int) -> bool:
    """Whether a number counts what follows: the "three" of "all three sites"."""
    return said[index].number.isdigit() and said[index + 1].text.endswith("s")


def _over(
    said: tuple[Word, ...],
    index: int,
    start: int,
    members: Sequence[Thing],
    vocabulary: Vocabulary,
    *,
    only: bool,
) -> tuple[tuple[Word, ...], int] | None:
    """The things in place of "every site". only: where something is said of each of them."""
    after, left_out = _exceptions(said, start, members)
    chosen = [each for each in members if each not in left_out]
    joint = _either(said, index)
    denied = said[index].text in ("no", "none", "neither", "nothing")
    noun = said[start]
    own = [tuple(Word(text, noun.start, noun.end) for text in member) for member in chosen]
    first = index
    if denied:
        # The denial stays in front of what it denies.
        said = (*said[:index], replace(said[index], text="no"), *said[index + 1 :])
        first = index + 1
        joint = "or"
    longer = of_each(said, (first, after), own, joint, vocabulary)
    if longer is not None:
        return longer.said, longer.after
    if only or not all(each in vocabulary.frames.places or each[-1].isdigit() for each in chosen):
        return None
    listed = _as_list(noun, chosen, joint)
    return (*said[:first], *listed, *said[after:]), first + len(listed)


def _members(
    said: Sequence[Word], index: int, start: int, vocabulary: Vocabulary
) -> tuple[Thing, ...]:
    """The things that a noun is a name for: those called so, or those of what is said of it."""
    if start >= len(said) or vocabulary.frames.mentioned(said, start) is not None:
        return ()
    noun = said[start]
    named = vocabulary.members(noun)
    if len(named) > 1:
        return named
    frames = vocabulary.frames
    general = noun.text in _WHOLE | _THINGS or bool(noun.stems & frames.classes)
    if not general and (not noun.text.endswith("s") or is_general(noun)):
        return ()
    around = _clause_around(said, index, start)
    wanted = frozenset(stem for place in around for stem in said[place].stems)
    best = max(frames.said_of(wanted), key=lambda each: (each[0], len(each[1])), default=None)
    return best[1] if best is not None else ()


def _clause_around(said: Sequence[Word], index: int, start: int) -> Iterator[int]:
    for place in range(index - 1, max(index - _FAR, -1), -1):
        if said[place].text in _BOUNDS:
            break
        yield place
    for place in range(start + 1, min(start + _FAR, len(said))):
        if said[place].text in _BOUNDS - {"that", "which"}:
            break
        yield place


def _either(said: Sequence[Word], index: int) -> str:
    """The word that joins the members: "any" is any one of them, unless it is denied."""
    if said[index].text not in ("any", "either", "anything", "anyone"):
        return "and"
    before = {word.text for word in said[:index]}
    return "and" if before & _DENIALS else "or"


def _said_as(said: Sequence[Word], index: int, vocabulary: Vocabulary) -> Form | None:
    """How the words as they are name something: "any tool" of "use any tool".

    What is said of every tool ("every tool has to be cleaned", FINITE) may be so of each.
    """
    for each in references(said, vocabulary):
        if each.first <= index + 1 < each.last and each.score == 1.0 and not each.rivals:
            return each.form if each.shape is Shape.ACT else Form.BASE
    return None


def _exceptions(
    said: Sequence[Word], start: int, members: Sequence[Thing]
) -> tuple[int, frozenset[Thing]]:
    """Where "every site except site 2" ends, and which ones it leaves out."""
    after = start + 1
    if after >= len(said) or said[after].text not in _EXCEPT:
        return after, frozenset()
    left_out: set[Thing] = set()
    place = after + 1
    while place < len(said):
        found = next(
            (
                each
                for each in members
                if all(
                    place + i < len(said) and said[place + i].stems & stems(word)
                    for i, word in enumerate(each)
                )
            ),
            None,
        )
        if found is not None:
            left_out.add(found)
            place += len(found)
        elif said[place].text in ("for", "and", "or", "the"):
            place += 1
        else:
            break
    return (place, frozenset(left_out)) if left_out else (after, frozenset())


def _range(said: Sequence[Word], index: int, vocabulary: Vocabulary) -> list[Thing] | None:
    """The things of "sites 1 to 3"."""
    if index + 3 >= len(said) or said[index + 2].text not in ("to", "through", "\u2013", "-"):
        return None
    first, last = said[index + 1].number, said[index + 3].number
    if not (first.isdigit() and last.isdigit() and said[index].text.endswith("s")):
        return None
    members = [each for each in vocabulary.members(said[index]) if each[-1].isdigit()]
    span = [each for each in members if int(first) <= int(each[-1]) <= int(last)]
    return span if {first, last} <= {each[-1] for each in span} else None


def _as_list(noun: Word, members: Sequence[Thing], joint: str) -> tuple[Word, ...]:
    found: list[Word] = []
    for place, member in enumerate(members):
        if place:
            found.append(Word(joint, noun.start, noun.end))
        found += [Word(text, noun.start, noun.end) for text in member]
    return tuple(found)
