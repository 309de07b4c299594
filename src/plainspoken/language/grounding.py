"""What the symbols of a domain are called, compiled for matching: the vocabulary.

A landmark's phrases become expressions: a place ("site 1"), a state ("the tank" + "full") or an
act ("use" + "a tool"). Beside each state stands its antonym, which says that it does not hold.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, field, replace
from difflib import SequenceMatcher
from functools import cached_property
from itertools import pairwise

from plainspoken.language.expression import (
    Expression,
    Shape,
    agree,
    content,
    expressions_of,
    stems_of,
    with_heads,
)
from plainspoken.language.frame import ARTICLES, Frames, Thing, aliased
from plainspoken.language.handling import Handling
from plainspoken.language.lexicon import is_general
from plainspoken.language.own_name import own_name
from plainspoken.language.word import Word, stems, words
from plainspoken.world.landmark import Landmark, Landmarks, LandmarkType
from plainspoken.world.symbol import SymbolId


@dataclass(frozen=True)
class Vocabulary:
    """The symbols of a domain and every way to say them."""

    landmarks: Landmarks
    expressions: tuple[Expression, ...] = field(repr=False)
    frames: Frames = field(repr=False)

    @classmethod
    def of(cls, landmarks: Landmarks) -> Vocabulary:
        """The vocabulary of a landmarks file, or of landmarks derived from a problem."""
        known = aliased(landmarks)
        cases = _instances(landmarks)
        frames = Frames.of(known)
        agents = frozenset((*frames.things, *frames.movers))
        found = [
            replace(each, instance=True) if each.symbol in cases else each
            for landmark in known.values()
            for each in expressions_of(landmark, agents)
        ]
        found = with_heads(found)
        plain = {(each.shape, stems_of(each.parts)) for each in found if not each.negated}
        return cls(
            landmarks,
            tuple(
                each
                for each in found
                if not each.negated or (each.shape, stems_of(each.parts)) not in plain
            ),
            frames,
        )

    @cached_property
    def own_name(self) -> str | None:
        """The name of the robot that is spoken to, where the ids of its places tell it."""
        return own_name(self.landmarks)

    @cached_property
    def by_stem(self) -> Mapping[str, tuple[Expression, ...]]:
        """The expressions that have a word, by each of its stems and near synonyms."""
        found: dict[str, dict[Expression, None]] = {}
        for expression in self.expressions:
            for part in expression.parts:
                for stem in part.stems | part.alike | part.nouns:
                    found.setdefault(stem, {})[expression] = None
        return {stem: tuple(each) for stem, each in found.items()}

    @cached_property
    def _by_rarest(self) -> Mapping[str, tuple[Expression, ...]]:
        """The expressions by the words for the part of each that the fewest others have."""
        found: dict[str, dict[Expression, None]] = {}
        for expression in self.expressions:
            rarest = min(
                expression.parts,
                key=lambda part: sum(len(self.by_stem[word]) for word in part.words),
            )
            for word in rarest.words:
                found.setdefault(word, {})[expression] = None
        return {word: tuple(each) for word, each in found.items()}

    def within(self, present: AbstractSet[str]) -> Mapping[str, tuple[Expression, ...]]:
        """The same as `by_stem`, of the expressions that are there whole: all others are not.

        present: the stems of all words of an utterance
        """
        found: dict[str, dict[Expression, None]] = {}
        for word in sorted(present):
            for expression in self._by_rarest.get(word, ()):
                if all(part.words & present for part in expression.parts):
                    for part in expression.parts:
                        for each in part.words & present:
                            found.setdefault(each, {})[expression] = None
        return {word: tuple(each) for word, each in found.items()}

    @cached_property
    def handling(self) -> Handling:
        """The symbols by the part that they have in an errand."""
        return Handling.of(self.landmarks, frozenset(self.frames.movers))

    @cached_property
    def places(self) -> Vocabulary:
        """The same with nothing but the names of places."""
        named = (each for each in self.expressions if each.shape is Shape.PLACE)
        kept = tuple(each for each in named if each.symbol not in self.handling.roles)
        return replace(self, expressions=kept)

    @cached_property
    def general(self) -> Mapping[SymbolId, frozenset[str]]:
        """The acts that are done to any one of a kind, with the kind: "to prune a plant"."""
        found: dict[SymbolId, frozenset[str]] = {}
        for landmark in self.landmarks.values():
            if landmark.type is LandmarkType.ACTION:
                for phrase in landmark.phrases:
                    for word, noun in pairwise(words(phrase)):
                        if word.text in ("a", "an"):
                            kinds = found.get(landmark.id, frozenset())
                            found[landmark.id] = kinds | {noun.text}
        return found

    @cached_property
    def doers(self) -> Mapping[SymbolId, Thing]:
        """Who does what a symbol says that somebody does: "the crane lifts"."""
        found: dict[SymbolId, Thing] = {}
        for told in self.expressions:
            if told.shape is Shape.STATE and told.subject and not self.persists(told.symbol):
                who = stems_of(told.parts[: told.subject])
                for thing in self.frames.movers:
                    if who == tuple(map(stems, thing)):
                        found.setdefault(told.symbol, thing)
        return found

    @cached_property
    def deeds(self) -> Mapping[tuple[Thing, SymbolId], SymbolId]:
        """For somebody and an act, the symbol that says that they do it: "the crane lifts"."""
        acts = [each for each in self.expressions if each.shape is Shape.ACT]
        found: dict[tuple[Thing, SymbolId], SymbolId] = {}
        for told in self.expressions:
            thing = self.doers.get(told.symbol)
            for act in acts if thing is not None and told.subject else ():
                if thing is not None and agree(
                    stems_of(told.parts[told.subject :]), stems_of(act.parts)
                ):
                    found[thing, act.symbol] = told.symbol
        return found

    def members(self, noun: Word) -> tuple[tuple[str, ...], ...]:
        """The words of each thing of a name: "site 0", "site 1"; "red site", "blue site"."""
        found = {each for stem in noun.stems for each in self._members.get(stem, ())}
        return tuple(sorted(found, key=lambda each: tuple((len(text), text) for text in each)))

    @cached_property
    def _members(self) -> Mapping[str, frozenset[tuple[str, ...]]]:
        found: dict[str, set[tuple[str, ...]]] = {}
        for landmark in self.landmarks.values():
            for stem, members in _members_by_stem(landmark).items():
                found.setdefault(stem, set()).update(members)
        return {stem: frozenset(members) for stem, members in found.items()}

    @cached_property
    def stems_of_symbols(self) -> Mapping[SymbolId, frozenset[str]]:
        """The stems of all words of each symbol's phrases."""
        return {
            symbol: frozenset(
                stem for phrase in landmark.phrases for word in words(phrase) for stem in word.stems
            )
            for symbol, landmark in self.landmarks.items()
        }

    @cached_property
    def telling_stems(self) -> Mapping[SymbolId, frozenset[str]]:
        """The stems of each symbol's phrases, without the general words of English."""
        return {
            symbol: frozenset(
                stem
                for phrase in landmark.phrases
                for word in words(phrase)
                if word.text.isdigit() or not (word.is_mark or is_general(word))
                for stem in word.stems
            )
            for symbol, landmark in self.landmarks.items()
        }

    @cached_property
    def weight_of_stem(self) -> Mapping[str, float]:
        """How much a stem tells: the more, the fewer symbols have it."""
        known = self.telling_stems
        counts = Counter(stem for own in known.values() for stem in own)
        return {stem: math.log(1 + len(known) / count) for stem, count in counts.items()}

    def persists(self, symbol: SymbolId) -> bool:
        """Whether a symbol stays true until something changes it."""
        return self.landmarks[symbol].persists

    def nearest(self, text: str, most: int = 3) -> tuple[Landmark, ...]:
        """The landmarks whose words are most like a text."""
        wanted = text.lower()
        own = frozenset(stem for word in words(wanted) for stem in word.stems)
        ratio = SequenceMatcher(None, "", wanted, autojunk=False)

        def likeness(landmark: Landmark) -> float:
            best = 0.0
            for phrase, found in self._phrases[landmark.id]:
                shared = sum(1 for stems in found if stems & own)
                ratio.set_seq1(phrase)
                # The cheaper bounds first: most landmarks are nothing like the text.
                if ratio.real_quick_ratio() + 0.5 * shared > best:
                    best = max(best, ratio.ratio() + 0.5 * shared)
            return best

        ranked = sorted(self.landmarks.values(), key=lambda each: (-likeness(each), each.id))
        return tuple(ranked[:most])

    @cached_property
    def _phrases(self) -> Mapping[SymbolId, tuple[tuple[str, tuple[frozenset[str], ...]], ...]]:
        """What each landmark is called, with the stems of each word."""
        return {
            landmark.id: tuple(
                (phrase.lower(), tuple(word.stems for word in words(phrase)))
                for phrase in landmark.phrases
            )
            for landmark in self.landmarks.values()
        }


def _instances(landmarks: Landmarks) -> frozenset[SymbolId]:
    """The action symbols that stand for some executions of another action symbol."""
    acts = {id for id, each in landmarks.items() if each.type is LandmarkType.ACTION}
    general = {id.removesuffix("_executed") for id in acts if id.endswith("_executed")}
    return frozenset(
        id
        for id in acts
        if any(id.startswith(f"{name}_") and id != f"{name}_executed" for name in general)
        or any(id.endswith(f"_executes_{name}") for name in general)
    )


def _members_by_stem(landmark: Landmark) -> Mapping[str, set[tuple[str, ...]]]:
    """The things that a landmark speaks of, each by one of its names: by its number, if it has one.

    A place that is "site 1", "site one" and "the first site" is one of three sites, not three.
    """
    numbered: dict[str, set[tuple[str, ...]]] = {}
    named: dict[str, set[tuple[str, ...]]] = {}
    for phrase in landmark.phrases:
        said = content(words(phrase), ARTICLES)
        for word, following in pairwise(said):
            if following.number.isdigit() and not word.number.isdigit():
                for stem in word.stems:
                    numbered.setdefault(stem, set()).add((stem, following.number))
        if landmark.type is LandmarkType.LOCATION and len(said) > 1:
            for word in (said[-1], said[0]):
                for stem in word.stems if not word.number.isdigit() else ():
                    named.setdefault(stem, {tuple(each.text for each in said)})
    return named | numbered
