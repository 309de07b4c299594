"""What an act is done to, where the act is named by its verb: "prune" of "prune the rose".

The general act is meant where its object is any one of a kind ("to prune a plant") and the thing
that is named may be one of them. Done to a place, or to a robot, it is another act, and unknown.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from plainspoken.language.agency import mover_at
from plainspoken.language.expression import Shape
from plainspoken.language.frame import ARTICLES
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.reference import Form, Reference
from plainspoken.language.word import Word

_INSTANCE = 0.8
"""What the general act is worth where one thing is named that it is done to."""
_SMALL = ARTICLES | frozenset(("of", "its", "their", "your", "all"))


def with_objects(
    said: Sequence[Word], found: Sequence[Reference], vocabulary: Vocabulary
) -> tuple[Reference, ...]:
    """The references, with acts that take in what they are done to, and without mistaken ones."""
    made: list[Reference] = []
    for each in found:
        if made and each.first < made[-1].last:
            continue
        if each.shape is not Shape.ACT or each.rivals:
            made.append(each)
            continue
        kept = _with_object(each, said, found, vocabulary)
        if kept is not None:
            made.append(kept)
    return tuple(made)


def _with_object(
    each: Reference, said: Sequence[Word], found: Sequence[Reference], vocabulary: Vocabulary
) -> Reference | None:
    general = each.symbol in vocabulary.general
    last = said[each.last - 1]
    if each.last < len(said) and said[each.last].number.isdigit() and each.parts > 1:
        # "sweep yard 2" for "to sweep a yard"
        named = vocabulary.frames.mentioned(said, each.last - 1)
        if named is not None and general and named.thing[-1] == said[each.last].number:
            return replace(each, last=each.last + 1, score=min(each.score, _INSTANCE))
    if each.last - each.first > 1 or each.form is Form.FINITE or each.score >= 1.0:
        return each
    start = each.last
    while start < len(said) and said[start].text in _SMALL:
        start += 1
    if start >= len(said) or last.is_mark:
        return each
    if mover_at(said, start, vocabulary.frames) is not None:
        return None
    thing = vocabulary.frames.mentioned(said, start)
    if thing is None:
        return each
    kinds = vocabulary.general.get(each.symbol, frozenset())
    if thing.thing in vocabulary.frames.places or not general:
        return None
    if any(kind in other for kind in kinds for other in vocabulary.frames.things):
        return None  # it is done to one of a kind, and this is none of them
    if any(other.first < thing.last and thing.first < other.last for other in found):
        return each
    return replace(each, last=thing.last, score=min(each.score, _INSTANCE))
