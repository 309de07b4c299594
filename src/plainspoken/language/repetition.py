"""What is said of one thing, said of each of several."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from plainspoken.language.expression import Shape
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.reference import Reference, references
from plainspoken.language.word import Word

_NEITHER = frozenset(("neither", "no"))

Span = tuple[int, int]


@dataclass(frozen=True, slots=True)
class Repeated:
    """An utterance in which something is said of each of several things.

    after: the word after the last that is repeated
    count: how many things it is said of
    """

    said: tuple[Word, ...]
    after: int
    count: int


def of_each(
    said: tuple[Word, ...],
    span: Span,
    members: Sequence[tuple[Word, ...]],
    joint: str,
    vocabulary: Vocabulary,
) -> Repeated | None:
    """Repeat a state or an act for each member that has it: "all sites are cleared"."""
    first, after = span
    found: list[tuple[Word, ...]] = []
    reach, apart = span, False
    beside: tuple[int, int] | None = None
    for member in members:
        trial = (*said[:first], *member, *said[after:])
        each = _holding(trial, first, first + len(member), vocabulary)
        if each is None:
            continue
        around = (first - each.first, each.last - first - len(member))
        if beside not in (None, around):
            continue  # "call the one and the other is sealed": not the same is said of both
        beside = around
        own = trial[each.first : each.last]
        found.append(own)
        apart |= each.never or (each.negated and each.obliged)
        reach = (each.first, each.last - len(member) + after - first)
    if len(found) < 2:
        return None
    noun = members[0][0]
    repeated: list[Word] = []
    neither = next((word for part in found for word in part if word.text in _NEITHER), None)
    if neither is not None:
        repeated.append(replace(neither, text="no"))  # "hold neither ..." is "neither hold ..."
        found = [tuple(word for word in part if word.text not in _NEITHER) for part in found]
    for place, part in enumerate(found):
        if place:
            # "The one or the other must never ..." forbids both.
            repeated.append(Word("and" if apart and joint == "or" else joint, noun.start, noun.end))
        repeated += (replace(part[0], joined=place > 0), *part[1:])
    longer = (*said[: reach[0]], *repeated, *said[reach[1] :])
    return Repeated(longer, reach[0] + len(repeated), len(found))


def _holding(
    trial: Sequence[Word], first: int, last: int, vocabulary: Vocabulary
) -> Reference | None:
    """What is said of the words from first to last, a state or an act with its own words."""
    for each in references(trial, vocabulary):
        whole = each.first <= first and each.last >= last and each.last - each.first > last - first
        if whole and each.shape is not Shape.PLACE and each.score >= 0.8:
            return each
    return None
