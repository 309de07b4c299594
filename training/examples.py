"""Sentences with their formulas, as what a network reads and what it should write.

An example's input is what `language.marking` makes of the sentence, so that training sees what
use will see, the slips of the reference recogniser among it.
"""

from __future__ import annotations

import json
import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from plainspoken.language.grounding import Vocabulary
from plainspoken.language.marking import Mark, marked
from plainspoken.language.notation import TOKENS, NotationError, written
from plainspoken.language.sentence import Sentence
from plainspoken.language.word import words
from plainspoken.logic.english import say
from plainspoken.logic.formula import Atom, Formula, conjunction, disjunction
from plainspoken.logic.pattern import (
    AtLeast,
    AtMost,
    BoundDelay,
    BoundReaction,
    DelayedReaction,
    Exactly,
    FairVisit,
    FutureAvoidance,
    GlobalAvoidance,
    InstantaneousReaction,
    Maintenance,
    OrderedVisit,
    PastAvoidance,
    Patrolling,
    Pattern,
    PromptReaction,
    Remaining,
    SequencedVisit,
    StrictOrderedVisit,
    Visit,
    Wait,
    negated,
)
from plainspoken.logic.syntax import parse
from plainspoken.world.landmark import Landmarks, LandmarkType, read_landmarks

Said = tuple[str | Mark, ...]


@dataclass(frozen=True)
class Example:
    """An utterance as it is read, and the tokens to write; None where it is no mission.

    described: how the symbols that are marked are described
    """

    said: Said
    tokens: tuple[str, ...] | None
    domain: str
    described: Mapping[str, tuple[str, ...]] = field(default_factory=dict)

    @property
    def symbols(self) -> tuple[str, ...]:
        """The symbols marked, in the order of their first marks."""
        return symbols_of(self.said)

    @property
    def is_reachable(self) -> bool:
        """Whether each symbol to write has a mark."""
        known = set(self.symbols)
        return all(token in TOKENS or token in known for token in self.tokens or ())


def _described(said: Said, vocabulary: Vocabulary) -> Mapping[str, tuple[str, ...]]:
    return {
        symbol: tuple(word.text for word in words(vocabulary.landmarks[symbol].description))
        for symbol in symbols_of(said)
    }


def example_of(
    utterance: str, tokens: tuple[str, ...] | None, vocabulary: Vocabulary, domain: str
) -> Example:
    """An utterance as it is read, with what to write."""
    said = marked(Sentence.of(utterance, vocabulary))
    return Example(said, tokens, domain, _described(said, vocabulary))


def symbols_of(said: Said) -> tuple[str, ...]:
    """The symbols marked, in the order of their first marks."""
    return tuple(dict.fromkeys(each.symbol for each in said if isinstance(each, Mark)))


@cache
def vocabulary_of(path: Path) -> Vocabulary:
    """The landmarks of a file, ready to be looked up."""
    return Vocabulary.of(read_landmarks(path))


def landmarks_beside(path: Path, domain: str | None) -> Path:
    """The landmarks of a row: `landmarks-<domain>.json`, or `landmarks.json`."""
    return path.parent / (f"landmarks-{domain}.json" if domain else "landmarks.json")


def read_examples(path: Path) -> Iterator[Example]:
    """The examples of a file of sentences; rows with a "why" are no missions."""
    for line in path.read_text(encoding="utf-8").splitlines():
        row = json.loads(line)
        if "symbols" in row:
            continue  # places of the row's own: there is nothing else to learn of them
        domain = row.get("domain")
        vocabulary = vocabulary_of(landmarks_beside(path, domain))
        where = f"{path.parent.name}/{domain}"
        if "why" in row:
            # What clashes is found by its formula, not by its words.
            if "contradict" not in row["why"]:
                yield example_of(row["utterance"], None, vocabulary, where)
            continue
        literal = parse(row["literal"])
        tokens = written(literal, parse(row.get("formula", row["literal"])))
        yield example_of(row["utterance"], tokens, vocabulary, where)


def paraphrased(paths: Sequence[Path], count: int, seed: int) -> Iterator[Example]:
    """Random patterns over the landmarks of some sites, said as `logic.english` says them."""
    draw = random.Random(seed)
    vocabularies = [vocabulary_of(path) for path in paths]
    made = 0
    while made < count:
        vocabulary = draw.choice(vocabularies)
        patterns = _drawn(vocabulary.landmarks, draw)
        literal = conjunction(*(each.literal for each in patterns))
        executable = conjunction(*(each.executable for each in patterns))
        try:
            tokens = written(literal, executable)
        except NotationError:
            continue
        said = say(executable, vocabulary.landmarks)
        example = example_of(said, tokens, vocabulary, "paraphrase")
        if example.is_reachable:
            made += 1
            yield example


def _drawn(landmarks: Landmarks, draw: random.Random) -> tuple[Pattern, ...]:
    kinds = list(LandmarkType)
    places, states, acts = (
        [Atom(name) for name, mark in landmarks.items() if mark.type is kind] for kind in kinds
    )
    anything = [each for each in (places, states, acts) if each]

    def one() -> Formula:
        return draw.choice(draw.choice(anything))

    def some(least: int) -> tuple[Formula, ...]:
        group = draw.choice([each for each in anything if len(each) >= 4] or anything)
        return tuple(draw.sample(group, min(len(group), least + draw.choice((0, 0, 1, 2)))))

    def condition() -> Formula:
        chosen = one()
        if chosen in states and draw.random() < 0.4:
            chosen = negated(chosen)
        if draw.random() < 0.12:
            joined = draw.choice((conjunction, disjunction))
            return joined(chosen, one())
        return chosen

    shapes = (
        lambda: Visit(some(1)), lambda: SequencedVisit(some(2)), lambda: OrderedVisit(some(2)),
        lambda: StrictOrderedVisit(some(2)), lambda: FairVisit(some(2)),
        lambda: Patrolling(some(1)), lambda: GlobalAvoidance(some(1)),
        lambda: PastAvoidance(one(), condition()), lambda: FutureAvoidance(one(), one()),
        lambda: AtLeast(one(), draw.randint(2, 5)), lambda: AtMost(one(), draw.randint(1, 5)),
        lambda: Exactly(one(), draw.randint(1, 5)), lambda: Wait(condition(), condition()),
        lambda: InstantaneousReaction(condition(), condition()),
        lambda: InstantaneousReaction(condition(), negated(one())),
        lambda: DelayedReaction(condition(), one()), lambda: PromptReaction(condition(), one()),
        lambda: BoundReaction(condition(), one()), lambda: BoundDelay(condition(), one()),
        lambda: Maintenance((condition(),)), lambda: Remaining((condition(),)),
    )  # fmt: skip
    return tuple(draw.choice(shapes)() for _ in range(draw.choice((1, 1, 1, 2, 2, 3))))
