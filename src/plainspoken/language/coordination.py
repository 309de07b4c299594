"""What is said of several things at once, spread over each of them.

"The jar and the can are sealed", "all jars", "every site but site 2", "none of them": the words
that are said of one are repeated for the others, so that each has its own referring expression.
Words that are repeated carry the place of the thing that they are repeated for.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from plainspoken.language.expression import PREPOSITIONS, Shape
from plainspoken.language.frame import Mention
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.lexicon import PHRASES, Kind
from plainspoken.language.quantifier import members_of, quantified
from plainspoken.language.reference import Form, Reference, references
from plainspoken.language.relative import unfolded
from plainspoken.language.repetition import Repeated, of_each
from plainspoken.language.word import Word

_JOINTS = {"and": "and", "or": "or", "nor": "nor", "&": "and"}
_PASSING = frozenset(("at", "least", "just", "exactly", "of", "them", "these", "the", ","))
_OF = {"either": "or", "any": "or", "both": "and", "each": "and", "all": "and"}
_CHOOSING = {"one": "or", "either": "or", "both": "and", "each": "and", "all": "and"}


def spread(said: tuple[Word, ...], vocabulary: Vocabulary) -> tuple[Word, ...]:
    """Repeat what is said of several things for each of them."""
    said = unfolded(said, vocabulary, members_of)
    return _listed(quantified(said, vocabulary), vocabulary)


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
        own = _own_words(said, mentions)
        if _is_visited(said, first, mentions, vocabulary):
            longer = _done_at_each(said, (first, after), own, joint, vocabulary)
        elif not _are_told(said, mentions, vocabulary):
            longer = of_each(said, (first, after), own, joint, vocabulary)
        if longer is None or longer.count < len(mentions):
            index = mentions[-1].last
            continue
        said, index = longer.said, longer.after
    return said


def _done_at_each(
    said: tuple[Word, ...],
    span: tuple[int, int],
    places: Sequence[tuple[Word, ...]],
    joint: str,
    vocabulary: Vocabulary,
) -> Repeated | None:
    """Repeat an act for each place where it is to be done: "ring a bell at one and two"."""
    first, after = span
    act = next(
        (
            each
            for each in references(said, vocabulary)
            if each.shape is Shape.ACT and each.last == first - 1 and each.errand is None
        ),
        None,
    )
    if act is None or said[first - 1].text not in PREPOSITIONS:
        return None
    doing = said[act.first : first]
    repeated: list[Word] = []
    for number, place in enumerate(places):
        if number:
            repeated.append(Word(joint, place[0].start, place[-1].end))
        repeated += (replace(doing[0], joined=number > 0 and joint == "or"), *doing[1:], *place)
    longer = (*said[: act.first], *repeated, *said[after:])
    return Repeated(longer, act.first + len(repeated), len(places))


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
    if start > 1 and said[start - 1].text == "of" and said[start - 2].text in _OF:
        start -= 2
        joint = _OF[said[start].text]
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
    letter = len(said[place].text) == 1 and len(before.thing[-1]) == 1 and len(before.thing) > 1
    if found is None and (
        (said[place].number.isdigit() and before.thing[-1].isdigit())
        or (letter and (*before.thing[:-1], said[place].text) in vocabulary.frames.places)
    ):
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
