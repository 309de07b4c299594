"""What is the case and what is done, as small sentences that know their tenses."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

from plainspoken.questions.morphology import (
    PARTICIPLES,
    listed,
    participle,
    past,
    plural,
    progressive,
    third_person,
)

_PARTICLES = frozenset({"away", "back", "down", "in", "off", "on", "out", "over", "up"})
Tense = Literal["now", "was", "has", "will", "may", "still", "stays"]
"""`has`: up to now; `still`: as before, and now; `stays`: now and to the end."""


@dataclass(frozen=True, slots=True)
class Thing:
    """An object of the problem, and the words for it."""

    name: str
    words: str


@dataclass(frozen=True, slots=True)
class Clause:
    """A fact: `the box` `be` `full`. The subject `I` is the robot that speaks."""

    subject: str
    verb: str
    complement: str
    several: bool = False

    def said(self, tense: Tense = "now", *, negative: bool = False) -> str:
        """`the box is full`, `the box wasn't full`, `I'll be at line 1`."""
        if negative and tense == "now" and self.verb == "be" and (done := _undone(self.complement)):
            return f"{self.subject}{_be(self.subject, tense, several=self.several)} already {done}"
        if self.verb == "be":
            text = (
                f"{self.subject}{_be(self.subject, tense, several=self.several, negative=negative)}"
            )
        else:
            text = f"{self.subject}{self._verb(tense, negative=negative)}"
        return f"{text} {self.complement}".strip()

    def never(self) -> str:
        """`the box has never been full`, `I've never been at line 1`."""
        return f"{self.ever('never ')}"

    def ever(self, often: str = "") -> str:
        """`I've been to line 1`, `the box has been full`."""
        complement = self.complement
        if self.subject == "I" and self.verb == "be":
            complement = re.sub("^at ", "to ", complement)  # Who has left it was not just at it.
        have = _have(self.subject, several=self.several)
        return f"{self.subject}{have} {often}{participle(self.verb)} {complement}".strip()

    def asked(self) -> str:
        """The clause without subject, for a list: `full`, `at line 1`."""
        return (
            self.complement if self.verb == "be" else f"{progressive(self.verb)} {self.complement}"
        )

    def _verb(self, tense: Tense, *, negative: bool) -> str:
        many = self.several or self.subject == "I"
        match tense:
            case "now" if negative:
                return f" {'don' if many else 'doesn'}'t {self.verb}"
            case "now":
                return f" {self.verb if many else third_person(self.verb)}"
            case "was" if negative:
                return f" didn't {self.verb}"
            case "was":
                return f" {past(self.verb)}"
            case "has":
                word = " not" if negative else ""
                return f"{_have(self.subject, several=self.several)}{word} {participle(self.verb)}"
            case "will":
                return f"{_will(self.subject, negative=negative)} {self.verb}"
            case "may":
                return f" may {'not ' if negative else ''}{self.verb}"
            case "still":
                return f" still {self._verb('now', negative=negative).strip()}"
            case "stays":
                return f"{_will(self.subject, negative=negative)} still {self.verb}"


def _will(subject: str, *, negative: bool) -> str:
    if negative:
        return " won't"
    return "'ll" if subject in ("I", "it", "they") else " will"


def _have(subject: str, *, several: bool) -> str:
    return "'ve" if subject == "I" else " have" if several else " has"


def _undone(complement: str) -> str:
    """`checked` for `unchecked`: who denies that it is so says that it is done."""
    first, _, rest = complement.partition(" ")
    done = first.removeprefix("un")
    if done == first or not (done.endswith("ed") or done in PARTICIPLES):
        return ""
    return f"{done} {rest}".strip()


def _be(subject: str, tense: Tense, *, several: bool, negative: bool = False) -> str:
    match tense:
        case "has":
            return f"{_have(subject, several=several)}{' not' if negative else ''} been"
        case "now" if subject == "I":
            return "'m not" if negative else "'m"
        case "now":
            form = "are" if several else "is"
            return f" {form}n't" if negative else f" {form}"
        case "was":
            form = "were" if several else "was"
            return f" {form}n't" if negative else f" {form}"
        case "will":
            return f"{_will(subject, negative=negative)} be"
        case "may":
            return f" may {'not ' if negative else ''}be"
        case "still" if negative:
            return f" still{_be(subject, 'now', several=several, negative=True)}"
        case "still":
            return f"{_be(subject, 'now', several=several, negative=False)} still"
        case "stays":
            return f"{_will(subject, negative=negative)} {'be' if negative else 'stay'}"


@dataclass(frozen=True, slots=True)
class Deed:
    """What is done: `check` `mug 1`. The subject `I` is the robot that speaks.

    parts: words and things after the verb, in order
    """

    subject: str
    verb: str
    parts: tuple[str | Thing, ...]

    @property
    def rest(self) -> str:
        words = [part.words if isinstance(part, Thing) else part for part in self.parts]
        return " ".join(word for word in words if word)

    def _with(self, form: str) -> str:
        return f"{form} {self.rest}".strip()

    @property
    def bare(self) -> str:
        """`check mug 1`."""
        return self._with(self.verb)

    @property
    def doing(self) -> str:
        """`checking mug 1`."""
        return self._with(progressive(self.verb))

    @property
    def did(self) -> str:
        """`checked mug 1`."""
        return self._with(past(self.verb))

    @property
    def done(self) -> str:
        """`checked mug 1`, after `have`."""
        return self._with(participle(self.verb))

    def pronoun(self, *, known: Sequence[Thing]) -> Deed:
        """The deed with `it` for its first thing, where that is the one thing just spoken of."""
        if len(known) != 1 or known[0].words[0].isupper():  # A person is no "it".
            return self
        if self.parts[:1] == ("to",):  # Nobody drives "to it".
            return self
        word = "it" if known[0].name else "them"  # Several things as one have no name.
        parts = tuple(
            Thing(part.name, word) if isinstance(part, Thing) and part == known[0] else part
            for part in self.parts
        )
        if parts[:1] and parts[0] in _PARTICLES and parts[1:2] and parts != self.parts:
            # "Pick it up": a pronoun goes before the particle.
            parts = (parts[1], parts[0], *parts[2:])
        return replace(self, parts=parts)


def merged(deeds: Sequence[Deed]) -> Deed | None:
    """One deed for several that differ in one thing: `check mugs 0 and 1`. None if more."""
    first = deeds[0]
    differing = {
        index
        for other in deeds[1:]
        if other.verb == first.verb and len(other.parts) == len(first.parts)
        for index, (one, two) in enumerate(zip(first.parts, other.parts, strict=True))
        if one != two
    }
    if any(
        (other.subject, other.verb, len(other.parts))
        != (first.subject, first.verb, len(first.parts))
        for other in deeds
    ):
        return None
    if not differing:
        return first
    if len(differing) > 1:
        return None
    (index,) = differing
    things = [deed.parts[index] for deed in deeds]
    if not all(isinstance(thing, Thing) for thing in things):
        return None
    words = enumerated([thing.words for thing in things if isinstance(thing, Thing)])
    return replace(first, parts=(*first.parts[:index], Thing("", words), *first.parts[index + 1 :]))


_NUMBERED = re.compile(r"(?P<head>\D+) (?P<number>\d+)$")


def enumerated(words: Sequence[str], conjunction: str = "and") -> str:
    """`mugs 0 and 1`, `line 2 and the warehouse`; each once, in the order given."""
    groups: dict[str, list[str]] = {}
    for each in dict.fromkeys(words):
        found = _NUMBERED.match(each)
        groups.setdefault(found["head"] if found else each, []).append(
            found["number"] if found else ""
        )
    parts = []
    for head, numbers in groups.items():
        if len(numbers) == 1:
            parts.append(f"{head} {numbers[0]}".strip())
        else:
            parts.append(f"{plural(head)} {listed(numbers, conjunction)}")
    return listed(parts, conjunction)
