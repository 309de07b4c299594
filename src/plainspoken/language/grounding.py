"""What the symbols of a domain are called, compiled for matching: the vocabulary.

A landmark's phrases become expressions: a place ("site 1"), a state ("the tank" + "full") or an
act ("use" + "a tool"). Beside each state stands its antonym, which says that it does not hold.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, field, replace
from difflib import SequenceMatcher
from enum import StrEnum, auto
from functools import cached_property
from itertools import pairwise

from plainspoken.language.frame import ARTICLES, Frames, Thing, aliased
from plainspoken.language.handling import Handling
from plainspoken.language.kinship import alike, nouns, opposites, verbs_of
from plainspoken.language.own_name import own_name
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

_HOLDING = frozenset(("hold", "carry", "grip", "grasp", "transport", "wear"))
_SOUNDING = frozenset(("ring", "sound", "beep", "blare", "wail", "buzz", "flash"))
_LIGHT = frozenset(("make", "take", "give", "do", "have"))
_DUMMIES = frozenset(("it", "there"))
"""Subjects that stand for nothing: "it is dark", "there are people"."""


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

    @property
    def words(self) -> frozenset[str]:
        """All that it may be said by."""
        return self.stems | self.alike | self.nouns

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
        frames = Frames.of(known)
        agents = frozenset((*frames.things, *frames.movers))
        found = [
            replace(each, instance=True) if each.symbol in cases else each
            for landmark in known.values()
            for each in _expressions(landmark, agents)
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
                who = _stems(told.parts[: told.subject])
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
                if thing is not None and _agree(
                    _stems(told.parts[told.subject :]), _stems(act.parts)
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


def _agree(one: Sequence[frozenset[str]], other: Sequence[frozenset[str]]) -> bool:
    return len(one) == len(other) and all(a & b for a, b in zip(one, other, strict=True))


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


def _expressions(landmark: Landmark, agents: AbstractSet[Thing]) -> Iterator[Expression]:
    for phrase in dict.fromkeys(landmark.phrases):
        said = words(phrase)
        if not said or not any(not word.is_mark for word in said):
            continue
        match landmark.type:
            case LandmarkType.LOCATION if _tells_who(phrase, said, landmark):
                continue  # "the crane is at the gate" tells who moves: see agency
            case LandmarkType.LOCATION:
                yield from _place(landmark.id, said)
            case LandmarkType.ACTION if _names_agent(said, agents) or _is_their_own(
                landmark.id, said
            ):
                yield from _doing(landmark.id, said)
            case LandmarkType.ACTION:
                yield from _act(landmark.id, said)
            case LandmarkType.CONDITION:
                yield from _state(landmark.id, said)


def _tells_who(phrase: str, said: Iterable[Word], landmark: Landmark) -> bool:
    """Whether a place is told by who is there, and not by a name of its own."""
    full = phrase.replace(" at ", " is at ", 1)
    return any(word.text in COPULAS for word in said) or (
        full != phrase and full in landmark.phrases
    )


def _place(symbol: SymbolId, said: tuple[Word, ...]) -> Iterator[Expression]:
    parts = tuple(map(_part, _content(said, ARTICLES)))
    # A place is a name: near synonyms of its words would name other places.
    yield Expression(symbol, Shape.PLACE, tuple(Part(part.stems) for part in parts))


def _act(symbol: SymbolId, said: tuple[Word, ...]) -> Iterator[Expression]:
    if said[0].text == "to":
        said = said[1:]
    verb, *rest = _verbal(said)
    # A verb is no comparative: "lower" is not "low".
    own = verb.stems - {verb.text[:-2], verb.text[:-1]} if verb.text.endswith("er") else verb.stems
    yield Expression(symbol, Shape.ACT, (Part(own, alike(own), nouns(own)), *map(_part, rest)))
    if own & _LIGHT and len(rest) == 1 and len(said) == 3 and said[1].text in ("a", "an"):
        # "no announcements": the noun says what the verb only says to be done
        noun = rest[0].stems
        verbs = frozenset(verb for stem in noun for verb in verbs_of(stem))
        yield Expression(symbol, Shape.ACT, (Part(noun, verbs),), weight=0.9)


def _names_agent(said: Sequence[Word], agents: AbstractSet[Thing]) -> bool:
    """Whether an act is told of somebody: "Mary waters the plants", "the crane lifts"."""
    texts = tuple(word.text for word in said)
    return texts[0] in ARTICLES or any(
        texts[: len(each)] == each and texts[len(each)].endswith("s")
        for each in agents
        if len(each) < len(texts)
    )


def _is_their_own(symbol: SymbolId, said: Sequence[Word]) -> bool:
    """Whether an act belongs to somebody by its symbol: "bob_executes_lift", "Bob lifts"."""
    actor, executes, _ = symbol.partition("_executes_")
    return bool(executes) and said[0].text == actor and len(said) > 1


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


def _impersonal(symbol: SymbolId, said: Sequence[Word], *, negated: bool) -> Iterator[Expression]:
    """Read "it is raining" and "there are people in the yard" without their empty subject."""
    dropped = ARTICLES | PREPOSITIONS | {"not"}
    cut = next((i for i, word in enumerate(said) if i and word.text in PREPOSITIONS), None)
    subject = _content(said[:cut], dropped) if cut else ()
    predicate = _content(said[cut:], dropped) if cut else _content(said, dropped)
    parts = tuple(map(_part, (*subject, *predicate)))
    yield Expression(symbol, Shape.STATE, parts, len(subject), negated=negated)


def _state(symbol: SymbolId, said: tuple[Word, ...]) -> Iterator[Expression]:
    dropped = ARTICLES | COPULAS | PREPOSITIONS | {"not"}
    negated = any(word.text == "not" for word in said)
    cut = next((i for i, word in enumerate(said) if word.text in COPULAS and i), None)
    if cut and said[:cut][-1].text in _DUMMIES and len(said) > cut + 1:
        yield from _impersonal(symbol, said[cut + 1 :], negated=negated)
        return
    if cut is None:
        parts = tuple(map(_part, _content(said, ARTICLES)))
        yield Expression(symbol, Shape.STATE, parts, negated=negated)
        return
    subject = tuple(map(_part, _content(said[:cut], ARTICLES | {"of"})))
    predicate = _content(said[cut + 1 :] or said[cut:], dropped)
    parts = tuple(map(_part, predicate))
    yield Expression(symbol, Shape.STATE, (*subject, *parts), len(subject), negated=negated)
    if len(predicate) == 1 and predicate[0].stems & _SOUNDING:
        # An alarm that goes off sounds, though one that is off does not.
        off = (Part(frozenset(("go",))), Part(frozenset(("off",))))
        yield Expression(symbol, Shape.STATE, (*subject, *off), len(subject))
    held = bool(predicate[0].stems & _HOLDING) and predicate[0].text.endswith("ing")
    if (held or said[:cut][-1].text == "robot") and len(subject) == 1 and len(parts) > 1:
        # The robot that is spoken to needs no name: "hold the jar".
        yield Expression(symbol, Shape.STATE, parts, 0, 0.95, negated=negated)
    if len(predicate) == 1:
        for opposite in sorted(opposites(predicate[0].stems)):
            other = Part(stems(opposite))
            yield Expression(
                symbol, Shape.STATE, (*subject, other), len(subject), 0.9, negated=not negated
            )
