"""How likely a reading is the one that is meant: a probability from what the sentence gave away.

A logistic regression over a few features that tell where the translator stood on thin ice. The
weights are fitted, and how well the probabilities come true is measured, on the corpora by
`python benchmarks/confidence.py`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from plainspoken.language.clause import statements
from plainspoken.language.lexicon import Kind
from plainspoken.language.sentence import Meaning, Sentence
from plainspoken.logic.formula import And, Formula, atoms
from plainspoken.logic.pattern import (
    BoundDelay,
    BoundReaction,
    DelayedReaction,
    GuardedVisit,
    InstantaneousReaction,
    PastAvoidance,
    Pattern,
    PromptPrecedence,
    PromptReaction,
    Visit,
    Wait,
)
from plainspoken.world.landmark import LandmarkType

LEAST_CONFIDENT = 0.35
"""What is less likely than this is asked about before it is accepted."""

Features = Mapping[str, float]

WEIGHTS: Features = {
    "bias": 5.402,
    "weakest": -0.328,
    "inexact": -0.515,
    "skipped": -0.544,
    "words": -0.617,
    "clauses": -0.384,
    "patterns": -0.603,
    "empty": -0.222,
    "pointing": -0.043,
    "together": -0.943,
    "marked": -0.281,
    "joints": 0.558,
    "heaped": -0.34,
    "denied": 0.44,
    "either": -0.15,
    "pieces": 0.103,
    "counted": 0.149,
    "allowed": -0.913,
    "senseless": -1.06,
}


def confidence(found: Features) -> float:
    """The probability that a reading with these features is the one that is meant."""
    total = sum(WEIGHTS.get(name, 0.0) * value for name, value in found.items())
    return round(1 / (1 + math.exp(-total)), 3)


def features(sentence: Sentence, meaning: Meaning) -> Features:
    """What a sentence and its meaning give away about how sure that is.

    weakest:  how far the worst reference is from the landmark's own words
    inexact:  references that are not in the landmark's own words
    skipped:  the share of words that were passed over
    words, clauses, patterns: how much there was to get wrong
    empty:    clauses that name nothing
    pointing: references that stand for a pronoun or for what was left out
    together: places that are to be reached at one instant
    marked:   what was said of time and order
    joints:   clauses that belong to another one; heaped: two of them to the same
    denied, either, pieces, counted, allowed: "not", "or", commas, numbers of times, "may"
    senseless: a pattern that relates a thing to itself
    """
    skipped = sum(item.last - item.first for item in sentence.items if item.kind is Kind.FILLER)
    kinds = [item.kind for item in sentence.items]
    flags = frozenset[Kind]().union(*(each.flags for each in sentence.clauses))
    return {
        "bias": 1.0,
        "weakest": 1 - min((each.score for each in sentence.references), default=1.0),
        "inexact": float(min(sum(each.score < 1 for each in sentence.references), 3)),
        "skipped": skipped / max(len(sentence.words), 1),
        "words": min(len(sentence.words), 40) / 10,
        "clauses": float(min(len(sentence.clauses), 8)),
        "patterns": float(min(len(meaning.patterns), 6)),
        "empty": float(min(sum(not each.operands for each in sentence.clauses), 3)),
        "pointing": float(min(sum(item.filled for item in sentence.items), 3)),
        "together": float(any(_joins_places(each, sentence) for each in _goals(meaning))),
        "marked": float(min(len(flags), 4)),
        "joints": float(min(sum(each.connector is not None for each in sentence.clauses), 4)),
        "heaped": float(any(len(each.subordinates) > 1 for each in statements(sentence.clauses))),
        "denied": float(min(kinds.count(Kind.NOT) + kinds.count(Kind.NEVER), 3)),
        "either": float(min(kinds.count(Kind.OR), 2)),
        "pieces": float(min(kinds.count(Kind.COMMA), 4)),
        "counted": float(Kind.COUNT in kinds),
        "allowed": float(Kind.MAY in kinds),
        "senseless": float(any(map(is_senseless, meaning.patterns))),
    }


def is_senseless(pattern: Pattern) -> bool:
    """Whether a pattern relates a thing to itself: "not a until a"."""
    match pattern:
        case PastAvoidance(a, b) | Wait(a, b) | GuardedVisit(a, b):
            return a == b
        case InstantaneousReaction(a, b) | DelayedReaction(a, b) | BoundReaction(a, b):
            return a == b
        case PromptReaction(a, b) | PromptPrecedence(a, b) | BoundDelay(a, b):
            return a == b
        case _:
            return False


def _goals(meaning: Meaning) -> list[Formula]:
    found: list[Formula] = []
    for each in meaning.patterns:
        if isinstance(each, Visit):
            found += each.places
        elif isinstance(each, DelayedReaction):
            found.append(each.response)
    return found


def _joins_places(goal: Formula, sentence: Sentence) -> bool:
    if not isinstance(goal, And):
        return False
    known = sentence.vocabulary.landmarks
    places = [
        name for name in atoms(goal) if name in known and known[name].type is LandmarkType.LOCATION
    ]
    return len(places) > 1
