"""What the symbols of a domain are called, compiled for matching: the vocabulary.

A landmark's phrases become expressions: a place ("site 1"), a state ("the tank" + "full") or an
act ("use" + "a tool"). Beside each state stands its antonym, which says that it does not hold.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from difflib import SequenceMatcher
from enum import StrEnum, auto
from functools import cached_property
from itertools import pairwise

from plainspoken.language.word import Word, stems, words
from plainspoken.world.landmark import Landmark, Landmarks, LandmarkType
from plainspoken.world.symbol import SymbolId

ARTICLES = frozenset(("the", "a", "an"))
_COPULA_WORDS = """
    is are be am was were been being gets get becomes become turns turn has have
"""
COPULAS = frozenset(_COPULA_WORDS.split())
_PREPOSITION_WORDS = """
    in into inside on onto at to from of off by for with near up down over out under
"""
PREPOSITIONS = frozenset(_PREPOSITION_WORDS.split())

_ANTONYMS = """full empty; open closed; open shut; locked unlocked; ripe unripe; on off;
    clean dirty; busy free; busy idle; hot cold; wet dry; occupied free; occupied vacant;
    present absent; awake asleep; visible hidden; available unavailable; lit dark; known unknown;
    alive dead; intact broken; safe dangerous; safe unsafe; enabled disabled; active inactive;
    full drained; charged drained; charged flat; loaded unloaded; blocked clear; blocked free;
    tidy untidy; tidy messy; finished unfinished; ready unready; clear cluttered; high low;
    occupied unoccupied; covered uncovered; connected disconnected; plugged unplugged"""
_ALIKE = """full fill; full filled; empty emptied; call summon; call fetch; call ring; call page;
    check inspect; check examine; check verify; check test; drop place; drop put; drop deposit;
    put place; pick grab; pick collect; get fetch; get collect; human person;
    human worker; human someone; robot machine; start begin; finish complete; clean tidy;
    clean wash; repair fix; mend fix; ask query; ask consult; closed shut; close shut; big large;
    small little; bring deliver; deliver carry; carry bring; trash rubbish;
    trash garbage; photo picture; photograph picture; help assist; help assistance; helper robot;
    hand gripper; load fill; see spot; notify alert; notify warn; alert warn; tell inform;
    notify tell; notify inform; reset restart; hold carry; stock store; dock charge; refill fill;
    buy purchase; send dispatch; release free; seal close; look inspect; throw discard;
    activate enable; activate start; deactivate disable; unload empty"""


def _pairs(text: str) -> dict[str, frozenset[str]]:
    found: dict[str, frozenset[str]] = {}
    for entry in text.split(";"):
        one, other = entry.split()
        found[one] = found.get(one, frozenset()) | {other}
        found[other] = found.get(other, frozenset()) | {one}
    return found


ANTONYMS = _pairs(_ANTONYMS)
ALIKE = _pairs(_ALIKE)


class Shape(StrEnum):
    """How an expression is built, which decides how it may be inflected."""

    PLACE = auto()
    STATE = auto()
    ACT = auto()


@dataclass(frozen=True, slots=True)
class Part:
    """One content word of an expression: its stems, and words that mean nearly the same."""

    stems: frozenset[str]
    alike: frozenset[str] = frozenset()

    def quality(self, found: frozenset[str]) -> float:
        """How well a word's stems fit: 1 the word itself, less a synonym, 0 another word."""
        if self.stems & found:
            return 1.0
        return 0.8 if self.alike & found else 0.0


@dataclass(frozen=True, slots=True)
class Expression:
    """One way to say a symbol.

    parts:   content words in order
    subject: how many of them come before the predicate, in a state
    weight:  1 for the landmark's own words, less for an antonym
    negated: whether it says that the symbol does not hold
    """

    symbol: SymbolId
    shape: Shape
    parts: tuple[Part, ...]
    subject: int = 0
    weight: float = 1.0
    negated: bool = False


@dataclass(frozen=True)
class Vocabulary:
    """The symbols of a domain and every way to say them."""

    landmarks: Landmarks
    expressions: tuple[Expression, ...] = field(repr=False)

    @classmethod
    def of(cls, landmarks: Landmarks) -> Vocabulary:
        """The vocabulary of a landmarks file, or of landmarks derived from a problem."""
        found = [each for landmark in landmarks.values() for each in _expressions(landmark)]
        plain = {(each.shape, _stems(each.parts)) for each in found if not each.negated}
        return cls(
            landmarks,
            tuple(
                each
                for each in found
                if not each.negated or (each.shape, _stems(each.parts)) not in plain
            ),
        )

    @cached_property
    def by_stem(self) -> Mapping[str, tuple[Expression, ...]]:
        """The expressions that have a word, by each of its stems and near synonyms."""
        found: dict[str, dict[Expression, None]] = {}
        for expression in self.expressions:
            for part in expression.parts:
                for stem in part.stems | part.alike:
                    found.setdefault(stem, {})[expression] = None
        return {stem: tuple(each) for stem, each in found.items()}

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


def _stems(parts: Iterable[Part]) -> tuple[frozenset[str], ...]:
    return tuple(part.stems for part in parts)


def _part(word: Word) -> Part:
    own = word.stems
    alike = frozenset(other for stem in own for other in ALIKE.get(stem, ()))
    return Part(own, alike - own)


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
    content = _content(said, ARTICLES | PREPOSITIONS)
    yield Expression(symbol, Shape.ACT, tuple(map(_part, content)))


def _state(symbol: SymbolId, said: tuple[Word, ...]) -> Iterator[Expression]:
    dropped = ARTICLES | COPULAS | PREPOSITIONS | {"not"}
    negated = any(word.text == "not" for word in said)
    cut = next((i for i, word in enumerate(said) if word.text in COPULAS and i), None)
    if cut is None:
        parts = tuple(map(_part, _content(said, ARTICLES)))
        yield Expression(symbol, Shape.STATE, parts, negated=negated)
        return
    subject = tuple(map(_part, _content(said[:cut], ARTICLES)))
    predicate = _content(said[cut:], dropped)
    parts = tuple(map(_part, predicate))
    yield Expression(symbol, Shape.STATE, (*subject, *parts), len(subject), negated=negated)
    if len(predicate) == 1:
        for opposite in sorted(_opposites(predicate[0])):
            other = Part(stems(opposite))
            yield Expression(
                symbol, Shape.STATE, (*subject, other), len(subject), 0.9, negated=not negated
            )


def _opposites(word: Word) -> frozenset[str]:
    found: set[str] = set()
    for stem in word.stems:
        found |= ANTONYMS.get(stem, frozenset())
        found |= {"un" + stem} if not stem.startswith("un") else {stem[2:]}
    return frozenset(found)
