"""An utterance as a network reads it: its words, with a mark where a symbol is spoken of.

A mark stands for the words that speak of its symbol; those of them that are not the symbol's own
("not", "must", "again") stay behind it. After the utterance come further symbols that share a word
with it, each a mark and its description: the network may find that one of them is meant.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass

from plainspoken.language.grounding import Vocabulary
from plainspoken.language.reference import Form, Reference
from plainspoken.language.sentence import Sentence
from plainspoken.language.word import Word, words
from plainspoken.world.landmark import LandmarkType
from plainspoken.world.symbol import SymbolId

MOST_OFFERED = 6
"""Symbols that are offered beside those that were found."""
MOST_COVERED = 2
"""Those of them that share only words that a reference stands for already."""
_COVERED = 0.25
"""What a word is worth that a reference stands for already."""


@dataclass(frozen=True, slots=True)
class Mark:
    """A symbol that is, or may be, spoken of.

    form:    how it is spoken of, None where it is only offered
    carried: whether it is one stop of an errand
    length:  words behind the mark that belong to it: of its description, where it is offered
    """

    symbol: SymbolId
    type: LandmarkType
    form: Form | None = None
    negated: bool = False
    carried: bool = False
    length: int = 0


Marked = Sequence[str | Mark]


def marked(sentence: Sentence) -> tuple[str | Mark, ...]:
    """The words of a sentence, its references marked, and what else it may speak of."""
    starts: dict[int, list[Reference]] = {}
    for each in sentence.references:
        starts.setdefault(each.first, []).append(each)
    found: list[str | Mark] = []
    covered: set[str] = set()
    end = 0
    own: AbstractSet[str] = frozenset()
    for index, word in enumerate(sentence.words):
        for reference in starts.get(index, ()):
            found += _marks(reference, sentence.vocabulary)
            own = sentence.vocabulary.stems_of_symbols[reference.symbol] - _TURNING | _PLAIN
            end = max(end, reference.last)
        if index >= end or own.isdisjoint(word.stems):
            found.append(word.text)
        else:
            covered |= word.stems
    known = {each.symbol for each in found if isinstance(each, Mark)}
    for symbol in offered(sentence.words, sentence.vocabulary, known, covered):
        landmark = sentence.vocabulary.landmarks[symbol]
        described = [word.text for word in words(landmark.description)]
        found += [Mark(symbol, landmark.type, length=len(described)), *described]
    return tuple(found)


_PLAIN = frozenset(
    ("the", "a", "an", "is", "are", "be", "to", "of", "at", "in", "on", "it", "has", "have")
)
"""Words that say nothing of what a reference speaks of."""


_TURNING = frozenset(["not", "no", "never", "without", "off", "out"])
"""Words that may turn what is spoken of into its opposite, whoever's they are."""


def _marks(reference: Reference, vocabulary: Vocabulary) -> Iterator[Mark]:
    stops = reference.errand.stops if reference.errand else ((reference.symbol,),)
    for symbol in (symbol for stop in stops for symbol in stop):
        yield Mark(
            symbol,
            vocabulary.landmarks[symbol].type,
            reference.form,
            reference.negated,
            reference.errand is not None,
        )


def offered(
    said: Sequence[Word],
    vocabulary: Vocabulary,
    known: AbstractSet[SymbolId],
    covered: AbstractSet[str],
) -> tuple[SymbolId, ...]:
    """Symbols that share a telling word with what is said, the likeliest first.

    A word tells the more, the fewer symbols have it; it tells little where a reference has it.
    """
    weights = vocabulary.weight_of_stem
    stems = frozenset(stem for word in said for stem in word.stems)
    # Who sprays is a sprayer, what buzzes a buzzer.
    doers = (stem + end for stem in stems if len(stem) > 3 for end in ("r", "er", stem[-1] + "er"))
    spoken = stems | {doer for doer in doers if doer in weights}
    scores: dict[SymbolId, tuple[bool, float]] = {}
    for symbol, own in vocabulary.telling_stems.items():
        shared = own & spoken
        if shared and symbol not in known:
            worth = sum(weights[stem] * (_COVERED if stem in covered else 1) for stem in shared)
            scores[symbol] = (not shared <= covered, worth / math.sqrt(1 + len(own)))
    ranked = sorted(sorted(scores), key=scores.__getitem__, reverse=True)
    fresh = [symbol for symbol in ranked if scores[symbol][0]]
    return tuple([*fresh, *ranked[len(fresh) :][:MOST_COVERED]][:MOST_OFFERED])
