"""What the symbols of a domain have in common: things, and what is said of several of them.

Two descriptions that differ in one thing only share a frame: "the jar is sealed" and "the can is
sealed" are the frame "_ sealed" with two fillings. From frames comes what "the jar and the can are
sealed", "all of them", or "it" with a thing named before, may stand for. A frame whose filling is
a place and whose subject moves says where that mover is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from plainspoken.language.kinship import alike
from plainspoken.language.word import Word, stems, words
from plainspoken.world.landmark import Landmark, Landmarks, LandmarkType
from plainspoken.world.symbol import SymbolId

ARTICLES = frozenset(("the", "a", "an"))
_JOINTS = """
    is are be am was were been being gets get becomes become turns turn has have
    in into inside onto at to from of by for with near over under visits visit goes go
"""
_PARTICLES = frozenset(("on", "off"))
_SMALL = ARTICLES | frozenset(_JOINTS.split())
_COPULAS = frozenset(("is", "are", "was", "were", "gets", "becomes", "has", "have", "needs", "can"))
_WHERE = frozenset(
    ("in", "into", "inside", "on", "onto", "at", "to", "visits", "goes", "by", "near")
)

Thing = tuple[str, ...]
"""The words of something that the domain speaks of: ("tank", "2")."""
Frame = tuple[str, ...]
"""The words that are said of a thing, with "_" in its place."""


@dataclass(frozen=True, slots=True)
class Mention:
    """Where an utterance names a thing. first, last: its first word and the one after its last."""

    thing: Thing
    first: int
    last: int


@dataclass(frozen=True)
class Frames:
    """The things of a domain and the frames that hold them.

    places:  the things that are places, by their symbols
    movers:  for each thing that moves: the symbol that says it is there, by the place's symbol
    classes: nouns for any one of several things, as "an egg" in "to break an egg"
    """

    places: Mapping[Thing, tuple[SymbolId, ...]]
    movers: Mapping[Thing, Mapping[SymbolId, SymbolId]]
    classes: frozenset[str]
    fillings: Mapping[Frame, Mapping[Thing, SymbolId]] = field(repr=False)
    of_symbol: Mapping[SymbolId, tuple[tuple[Frame, Thing], ...]] = field(repr=False)
    by_stem: Mapping[str, tuple[Thing, ...]] = field(repr=False)
    things: tuple[Thing, ...] = field(repr=False)

    @classmethod
    def of(cls, landmarks: Landmarks) -> Frames:
        """The frames of a domain, from the words of its landmarks."""
        places = _places(landmarks)
        things = dict.fromkeys((*_subjects(landmarks), *places, *_objects(landmarks)))
        movers = _movers(landmarks, places)
        fillings: dict[Frame, dict[Thing, SymbolId]] = {}
        of_symbol: dict[SymbolId, list[tuple[Frame, Thing]]] = {}
        for landmark in landmarks.values():
            for phrase in landmark.phrases:
                content = _texts(phrase, _SMALL)
                for frame, thing in _framed(content, things):
                    fillings.setdefault(frame, {}).setdefault(thing, landmark.id)
                    of_symbol.setdefault(landmark.id, []).append((frame, thing))
        by_stem: dict[str, list[Thing]] = {}
        for thing in sorted((*things, *movers), key=lambda each: (-len(each), each)):
            for stem in stems(thing[0]):
                known = by_stem.setdefault(stem, [])
                if thing not in known:
                    known.append(thing)
        return cls(
            places,
            movers,
            frozenset((*_classes(landmarks), *(each[0] for each in things if len(each) > 1))),
            fillings,
            {symbol: tuple(each) for symbol, each in of_symbol.items()},
            {stem: tuple(each) for stem, each in by_stem.items()},
            tuple(things),
        )

    def swapped(self, symbol: SymbolId, thing: Thing, other: Thing) -> SymbolId | None:
        """The symbol that says of another thing what a symbol says of a thing."""
        for frame, filling in self.of_symbol.get(symbol, ()):
            if filling == thing and other in self.fillings[frame]:
                return self.fillings[frame][other]
        return None

    def mentioned(self, said: Sequence[Word], index: int) -> Mention | None:
        """The longest thing that is named from a word on."""
        for stem in said[index].stems:
            for thing in self.by_stem.get(stem, ()):
                last = _matches(thing, said, index)
                if last is not None:
                    return Mention(thing, index, last)
        return None

    def said_of(self, wanted: frozenset[str]) -> Iterator[tuple[int, tuple[Thing, ...]]]:
        """The things of each frame whose words are all among the wanted ones, and how many."""
        for frame, fillings in self.fillings.items():
            rest = [word for word in frame if word != "_"]
            if len(fillings) > 1 and rest and all(
                (stems(word) | alike(stems(word))) & wanted for word in rest
            ):  # fmt: skip
                # One name of each: what has two is still one thing.
                once = {symbol: thing for thing, symbol in reversed(tuple(fillings.items()))}
                # "water the fern" and "water at the gate": what it is done to, not where.
                once = {s: t for s, t in once.items() if t not in self.places} or once
                if len(once) > 1:
                    yield len(rest), tuple(reversed(tuple(once.values())))


def _matches(thing: Thing, said: Sequence[Word], index: int) -> int | None:
    place = index
    for number, text in enumerate(thing):
        if number and place < len(said) and said[place].text in ("number", "no", "nr", "#"):
            place += 1
        if place >= len(said) or not said[place].stems & stems(text):
            return None
        place += 1
    return place


def _texts(phrase: str, dropped: frozenset[str]) -> Thing:
    found = [word for word in words(phrase) if not word.is_mark]
    return tuple(
        word.number
        for place, word in enumerate(found)
        if word.text not in dropped or (place == len(found) - 1 and len(word.text) == 1)
    )


def _places(landmarks: Landmarks) -> dict[Thing, tuple[SymbolId, ...]]:
    found: dict[Thing, tuple[SymbolId, ...]] = {}
    for landmark in landmarks.values():
        if landmark.type is LandmarkType.LOCATION:
            for phrase in landmark.phrases:
                if not any(word.text in _COPULAS for word in words(phrase)):
                    thing = _texts(phrase, ARTICLES)
                    found[thing] = (*found.get(thing, ()), landmark.id)
    return found


def _subjects(landmarks: Landmarks) -> Iterator[Thing]:
    """What conditions speak of: the noun before "is", after "of" where there is one."""
    for landmark in landmarks.values():
        if landmark.type is LandmarkType.LOCATION:
            continue
        for phrase in landmark.phrases:
            texts = [word.number for word in words(phrase) if not word.is_mark]
            cut = next((i for i, text in enumerate(texts) if i and text in _COPULAS), None)
            if cut is None:
                continue
            subject = texts[:cut]
            if "of" in subject:
                subject = subject[len(subject) - subject[::-1].index("of") :]
            thing = tuple(text for text in subject if text not in ARTICLES)
            if thing and not set(thing) & {"to", "that", "not"}:
                yield thing


def _objects(landmarks: Landmarks) -> Iterator[Thing]:
    """What acts are done to: the noun behind "the", or one with a number."""
    for landmark in landmarks.values():
        if landmark.type is LandmarkType.ACTION:
            for phrase in landmark.phrases:
                texts = [word.number for word in words(phrase) if not word.is_mark]
                for noun, number in pairwise(texts):
                    if number.isdigit() and noun.isalpha() and noun not in _SMALL:
                        yield noun, number
                if "the" in texts[:-1] and texts[0] != "the":
                    rest = texts[texts.index("the") + 1 :]
                    ends = (i for i, text in enumerate(rest) if text in _SMALL | _PARTICLES)
                    cut = next(ends, len(rest))
                    if cut:
                        yield tuple(rest[:cut])


def _classes(landmarks: Landmarks) -> Iterator[str]:
    for landmark in landmarks.values():
        if landmark.type is LandmarkType.ACTION:
            for phrase in landmark.phrases:
                texts = [word.text for word in words(phrase)]
                for article, noun in pairwise(texts):
                    if article in ("a", "an"):
                        yield noun


def _framed(content: Thing, things: Mapping[Thing, None]) -> Iterator[tuple[Frame, Thing]]:
    for first in range(len(content)):
        for last in range(first + 1, len(content) + 1):
            thing = content[first:last]
            if thing in things and (first, last) != (0, len(content)):
                yield (*content[:first], "_", *content[last:]), thing


def _movers(
    landmarks: Landmarks, places: Mapping[Thing, tuple[SymbolId, ...]]
) -> dict[Thing, dict[SymbolId, SymbolId]]:
    """Who may be where, from "the crane is at the gate" and "crane 1 at the gate"."""
    found: dict[Thing, dict[SymbolId, SymbolId]] = {}
    for landmark in landmarks.values():
        for phrase in landmark.phrases:
            texts = [word.number for word in words(phrase) if not word.is_mark]
            for cut, text in enumerate(texts[:-1]):
                if not cut or text not in _WHERE:
                    continue
                if any(text in _COPULAS for text in texts[:cut]) and texts[cut - 1] not in _COPULAS:
                    continue  # "the jar is broken at the gate" tells of the jar, not who moves
                behind = texts[cut + 1 :]
                # The last may be a name that looks like an article: "site a".
                place = (*(each for each in behind[:-1] if each not in ARTICLES), *behind[-1:])
                subject = tuple(
                    each for each in texts[:cut] if each not in ARTICLES and each not in _COPULAS
                )
                if place in places and subject and landmark.type is not LandmarkType.ACTION:
                    own = found.setdefault(subject, {})
                    for symbol in places[place]:
                        own.setdefault(symbol, landmark.id)
    return found


def aliased(landmarks: Landmarks) -> Landmarks:
    """Landmarks whose conditions call a thing by every name that it has elsewhere.

    Where "the gate" and "the entrance" are one place, "the gate is open" may be said of both.
    """
    names = _aliases(landmarks)
    if not names:
        return landmarks
    found = {}
    for id, landmark in landmarks.items():
        ways = dict.fromkeys(landmark.phrases)
        for phrase in landmark.phrases:
            texts = tuple(word.number for word in words(phrase) if not word.is_mark)
            for thing, others in names.items():
                place = _place_of(thing, texts)
                if place is not None and landmark.type is not LandmarkType.LOCATION:
                    for other in others:
                        said = (*texts[:place], *other, *texts[place + len(thing) :])
                        ways.setdefault(" ".join(said))
        description, *more = ways
        found[id] = Landmark(id, description, landmark.type, tuple(more))
    return found


def _place_of(thing: Thing, texts: Thing) -> int | None:
    return next(
        (i for i in range(len(texts)) if texts[i : i + len(thing)] == thing and len(texts) > i + 1),
        None,
    )


def _aliases(landmarks: Landmarks) -> dict[Thing, tuple[Thing, ...]]:
    """The names that stand for the same thing: of one place, or of one condition's subject."""
    groups: dict[tuple[object, ...], dict[Thing, None]] = {}
    for thing, symbols in _places(landmarks).items():
        if len(symbols) == 1:
            groups.setdefault(symbols, {})[thing] = None
    things = dict.fromkeys(_subjects(landmarks))
    for landmark in landmarks.values():
        if landmark.type is LandmarkType.CONDITION:
            for phrase in landmark.phrases:
                for frame, thing in _framed(_texts(phrase, _SMALL), things):
                    groups.setdefault((landmark.id, frame), {})[thing] = None
    found: dict[Thing, dict[Thing, None]] = {}
    for group in groups.values():
        for thing in group:
            for other in group:
                if other != thing:
                    found.setdefault(thing, {})[other] = None
    return {thing: tuple(others) for thing, others in found.items()}
