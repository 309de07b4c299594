"""What the symbols of a domain are called, compiled for matching: the vocabulary.

A landmark's phrases become expressions: a place ("site 1"), a state ("the tank" + "full") or an
act ("use" + "a tool"). Beside each state stands its antonym, which says that it does not hold.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from difflib import SequenceMatcher
from enum import StrEnum, auto
from functools import cached_property
from itertools import pairwise

from plainspoken.language.frame import ARTICLES, Frames, aliased
from plainspoken.language.kinship import alike, nouns, opposites
from plainspoken.language.word import Word, stems, words
from plainspoken.world.landmark import Landmark, Landmarks, LandmarkType
from plainspoken.world.symbol import SymbolId

_COPULA_WORDS = """
    is are be am was were been being gets get becomes become turns turn has have
"""
COPULAS = frozenset(_COPULA_WORDS.split())
PARTICLES = frozenset(("on", "off"))
"""Small words that tell two acts or states apart: "turn the lamp on", "turn the lamp off"."""
_PREPOSITION_WORDS = """
    in into inside on onto at to from of off by for with near up down over out under
"""
PREPOSITIONS = frozenset(_PREPOSITION_WORDS.split())


class Shape(StrEnum):
    """How an expression is built, which decides how it may be inflected."""

    PLACE = auto()
    STATE = auto()
    ACT = auto()


@dataclass(frozen=True, slots=True)
class Part:
    """One content word of an expression: its stems, nouns of it, and what means nearly the same."""

    stems: frozenset[str]
    alike: frozenset[str] = frozenset()
    nouns: frozenset[str] = frozenset()

    @property
    def is_number(self) -> bool:
        return any(stem.isdigit() for stem in self.stems)

    def quality(self, found: frozenset[str]) -> float:
        """How well a word's stems fit: 1 the word itself, less its noun or a synonym."""
        if self.stems & found:
            return 1.0
        if self.nouns & found:
            return 0.95
        return 0.8 if self.alike & found else 0.0


@dataclass(frozen=True, slots=True)
class Expression:
    """One way to say a symbol.

    parts:   content words in order
    subject: how many of them come before the predicate, in a state
    weight:  1 for the landmark's own words, less for an antonym
    negated: whether it says that the symbol does not hold
    instance: whether it is one case of an act that is a symbol of its own
    head:     whether "the museum" is enough, because no other place is called so
    """

    symbol: SymbolId
    shape: Shape
    parts: tuple[Part, ...]
    subject: int = 0
    weight: float = 1.0
    negated: bool = False
    instance: bool = False
    head: bool = False

    @property
    def head_part(self) -> int:
        """The part that says what kind of place it is: the last, or the one before "of"."""
        return next(
            (i - 1 for i, part in enumerate(self.parts) if i and "of" in part.stems),
            len(self.parts) - 1,
        )

    @property
    def agentless(self) -> bool:
        """Whether it is a state told without its subject: "hold the jar"."""
        return self.shape is Shape.STATE and not self.subject and self.weight < 1.0


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
        found = [
            replace(each, instance=True) if each.symbol in cases else each
            for landmark in known.values()
            for each in _expressions(landmark)
        ]
        found = _with_heads(found)
        plain = {(each.shape, _stems(each.parts)) for each in found if not each.negated}
        return cls(
            landmarks,
            tuple(
                each
                for each in found
                if not each.negated or (each.shape, _stems(each.parts)) not in plain
            ),
            Frames.of(known),
        )

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

    def members(self, noun: Word) -> tuple[tuple[str, ...], ...]:
        """The words of each thing of a name: "site 0", "site 1"; "red site", "blue site"."""
        found = {each for stem in noun.stems for each in self._members.get(stem, ())}
        return tuple(sorted(found, key=lambda each: tuple((len(text), text) for text in each)))

    @cached_property
    def _members(self) -> Mapping[str, frozenset[tuple[str, ...]]]:
        found: dict[str, set[tuple[str, ...]]] = {}
        for landmark in self.landmarks.values():
            for phrase in landmark.phrases:
                content = _content(words(phrase), ARTICLES)
                for word, following in pairwise(content):
                    if following.number.isdigit() and not word.number.isdigit():
                        for stem in word.stems:
                            found.setdefault(stem, set()).add((stem, following.number))
                if landmark.type is LandmarkType.LOCATION and len(content) > 1:
                    for word in (content[-1], content[0]):
                        for stem in word.stems if not word.number.isdigit() else ():
                            found.setdefault(stem, set()).add(tuple(each.text for each in content))
        return {stem: frozenset(members) for stem, members in found.items()}

    def persists(self, symbol: SymbolId) -> bool:
        """Whether a symbol stays true until something changes it."""
        return self.landmarks[symbol].persists

    def nearest(self, text: str, most: int = 3) -> tuple[Landmark, ...]:
        """The landmarks whose words are most like a text."""
        wanted = text.lower()
        own = frozenset(stem for word in words(wanted) for stem in word.stems)

        def likeness(landmark: Landmark) -> float:
            best = 0.0
            for phrase in landmark.phrases:
                shared = sum(1 for word in words(phrase) if word.stems & own)
                ratio = SequenceMatcher(None, wanted, phrase.lower(), autojunk=False).ratio()
                best = max(best, ratio + 0.5 * shared)
            return best

        ranked = sorted(self.landmarks.values(), key=lambda each: (-likeness(each), each.id))
        return tuple(ranked[:most])


def _with_heads(found: Iterable[Expression]) -> list[Expression]:
    """Mark the names of places of which the noun alone says which one is meant."""
    listed = list(found)
    owners: dict[frozenset[str], set[SymbolId]] = {}
    for each in listed:
        if each.shape is Shape.PLACE:
            owners.setdefault(each.parts[each.head_part].stems, set()).add(each.symbol)
    return [
        replace(each, head=True)
        if each.shape is Shape.PLACE
        and len(each.parts) > 1
        and len(owners[each.parts[each.head_part].stems]) == 1
        and not each.parts[each.head_part].is_number
        else each
        for each in listed
    ]


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


def _stems(parts: Iterable[Part]) -> tuple[frozenset[str], ...]:
    return tuple(part.stems for part in parts)


def _part(word: Word) -> Part:
    own = word.stems
    return Part(own, alike(own), nouns(own))


def _content(found: Iterable[Word], dropped: frozenset[str]) -> tuple[Word, ...]:
    """The words that carry meaning; all of them where none would be left.

    An article at the end is a name: "site a".
    """
    everything = tuple(word for word in found if not word.is_mark)
    kept = tuple(
        word
        for word in everything
        if word.text not in dropped or (word is everything[-1] and word.text in ARTICLES)
    )
    return kept or everything


def _expressions(landmark: Landmark) -> Iterator[Expression]:
    for phrase in dict.fromkeys(landmark.phrases):
        said = words(phrase)
        if not said or not any(not word.is_mark for word in said):
            continue
        match landmark.type:
            case LandmarkType.LOCATION if any(word.text in COPULAS for word in said):
                continue  # "the crane is at the gate" tells who moves: see agency
            case LandmarkType.LOCATION:
                yield from _place(landmark.id, said)
            case LandmarkType.ACTION:
                yield from _act(landmark.id, said)
            case LandmarkType.CONDITION:
                yield from _state(landmark.id, said)


def _place(symbol: SymbolId, said: tuple[Word, ...]) -> Iterator[Expression]:
    parts = tuple(map(_part, _content(said, ARTICLES)))
    # A place is a name: near synonyms of its words would name other places.
    yield Expression(symbol, Shape.PLACE, tuple(Part(part.stems) for part in parts))


def _act(symbol: SymbolId, said: tuple[Word, ...]) -> Iterator[Expression]:
    if said[0].text == "to":
        said = said[1:]
    if said[0].text in ARTICLES:
        yield from _doing(symbol, said)
        return
    verb, *rest = _verbal(said)
    # A verb is no comparative: "lower" is not "low".
    own = verb.stems - {verb.text[:-2], verb.text[:-1]} if verb.text.endswith("er") else verb.stems
    yield Expression(symbol, Shape.ACT, (Part(own, alike(own), nouns(own)), *map(_part, rest)))


def _doing(symbol: SymbolId, said: tuple[Word, ...]) -> Iterator[Expression]:
    """Read "the crane lifts" as what is so of a subject."""
    content = _verbal(said)
    cut = next((i for i, word in enumerate(content) if i and word.text.endswith("s")), 1)
    if len(content) > cut:
        yield Expression(symbol, Shape.STATE, tuple(map(_part, content)), cut)


def _verbal(said: tuple[Word, ...]) -> tuple[Word, ...]:
    """The content words of an act, with a particle right behind the verb or at the end."""
    place = next((i for i in (1, len(said) - 1) if said[i:] and said[i].text in PARTICLES), None)
    if len(said) < 2 or place is None:
        return _content(said, ARTICLES | PREPOSITIONS)
    before = _content(said[:place], ARTICLES | PREPOSITIONS)
    rest = said[place + 1 :]
    return (*before, said[place], *(_content(rest, ARTICLES | PREPOSITIONS) if rest else ()))


def _state(symbol: SymbolId, said: tuple[Word, ...]) -> Iterator[Expression]:
    dropped = ARTICLES | COPULAS | PREPOSITIONS | {"not"}
    negated = any(word.text == "not" for word in said)
    cut = next((i for i, word in enumerate(said) if word.text in COPULAS and i), None)
    if cut is None:
        parts = tuple(map(_part, _content(said, ARTICLES)))
        yield Expression(symbol, Shape.STATE, parts, negated=negated)
        return
    subject = tuple(map(_part, _content(said[:cut], ARTICLES | {"of"})))
    predicate = _content(said[cut + 1 :] or said[cut:], dropped)
    parts = tuple(map(_part, predicate))
    yield Expression(symbol, Shape.STATE, (*subject, *parts), len(subject), negated=negated)
    if said[:cut][-1].text == "robot" and len(subject) == 1 and len(parts) > 1:
        # The robot that is spoken to needs no name: "hold the jar".
        yield Expression(symbol, Shape.STATE, parts, 0, 0.95, negated=negated)
    if len(predicate) == 1:
        for opposite in sorted(opposites(predicate[0].stems)):
            other = Part(stems(opposite))
            yield Expression(
                symbol, Shape.STATE, (*subject, other), len(subject), 0.9, negated=not negated
            )
