"""Every way to say a landmark: its phrases as places, states and acts, word by word.

Beside each state stands its antonym, which says that it does not hold.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace
from enum import StrEnum, auto

from plainspoken.language.frame import ARTICLES, Thing
from plainspoken.language.kinship import alike, nouns, opposites, verbs_of
from plainspoken.language.word import Word, stems, words
from plainspoken.world.landmark import Landmark, LandmarkType
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
        """Whether it is what sets one of a kind apart, a number or a letter: "site 2", "site b"."""
        return any(stem.isdigit() or len(stem) == 1 for stem in self.stems)

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


def with_heads(found: Iterable[Expression]) -> list[Expression]:
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


def stems_of(parts: Iterable[Part]) -> tuple[frozenset[str], ...]:
    """The stems of each part."""
    return tuple(part.stems for part in parts)


def agree(one: Sequence[frozenset[str]], other: Sequence[frozenset[str]]) -> bool:
    """Whether two rows of words are the same, word by word, by some stem of each."""
    return len(one) == len(other) and all(a & b for a, b in zip(one, other, strict=True))


def _part(word: Word) -> Part:
    own = word.stems
    return Part(own, alike(own), nouns(own))


def content(found: Iterable[Word], dropped: frozenset[str]) -> tuple[Word, ...]:
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


def expressions_of(landmark: Landmark, agents: AbstractSet[Thing]) -> Iterator[Expression]:
    """The expressions of a landmark's phrases; agents: who may do things in the domain."""
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
    parts = tuple(map(_part, content(said, ARTICLES)))
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
        return content(said, ARTICLES | PREPOSITIONS)
    before = content(said[:place], ARTICLES | PREPOSITIONS)
    rest = said[place + 1 :]
    return (*before, said[place], *(content(rest, ARTICLES | PREPOSITIONS) if rest else ()))


def _impersonal(symbol: SymbolId, said: Sequence[Word], *, negated: bool) -> Iterator[Expression]:
    """Read "it is raining" and "there are people in the yard" without their empty subject."""
    dropped = ARTICLES | PREPOSITIONS | {"not"}
    cut = next((i for i, word in enumerate(said) if i and word.text in PREPOSITIONS), None)
    subject = content(said[:cut], dropped) if cut else ()
    predicate = content(said[cut:], dropped) if cut else content(said, dropped)
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
        parts = tuple(map(_part, content(said, ARTICLES)))
        yield Expression(symbol, Shape.STATE, parts, negated=negated)
        return
    subject = tuple(map(_part, content(said[:cut], ARTICLES | {"of"})))
    predicate = content(said[cut + 1 :] or said[cut:], dropped)
    if len(said) > cut + 2 and said[-1].text in PARTICLES:
        predicate = (*predicate, said[-1])  # "turned on" is not "turned off"
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
    if said[cut].text == "has" and said[:cut][-1].text == "robot" and not held:
        # "(you) have the jar": what is had says too little without the verb.
        having = Part(frozenset(("have",)))
        yield Expression(symbol, Shape.STATE, (having, *parts), 0, 0.95, negated=negated)
    if len(predicate) == 1:
        for opposite in sorted(opposites(predicate[0].stems)):
            other = Part(stems(opposite))
            yield Expression(
                symbol, Shape.STATE, (*subject, other), len(subject), 0.9, negated=not negated
            )
