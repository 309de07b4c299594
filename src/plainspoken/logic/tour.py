"""The mission patterns of places: visited in which order, how often, by turns."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from itertools import pairwise

from plainspoken.logic.formula import (
    Always,
    And,
    Eventually,
    Formula,
    Implies,
    Next,
    Not,
    Until,
    WeakNext,
    WeakUntil,
    conjunction,
    disjunction,
)


class SameReading(ABC):
    """A pattern whose two readings are one."""

    __slots__ = ()

    @property
    @abstractmethod
    def literal(self) -> Formula:
        """The formula of both."""

    @property
    def executable(self) -> Formula:
        return self.literal


@dataclass(frozen=True, slots=True)
class Visit(SameReading):
    """Each place at some instant, in any order. One place or more."""

    places: tuple[Formula, ...]

    @property
    def literal(self) -> Formula:
        return conjunction(*map(Eventually, self.places))


@dataclass(frozen=True, slots=True)
class SequencedVisit(SameReading):
    """Each place, and after it the next one."""

    places: tuple[Formula, ...]

    @property
    def literal(self) -> Formula:
        *before, last = self.places
        formula: Formula = Eventually(last)
        for place in reversed(before):
            formula = Eventually(conjunction(place, formula))
        return formula


@dataclass(frozen=True, slots=True)
class OrderedVisit(SameReading):
    """A sequenced visit in which no place comes before the one in front of it."""

    places: tuple[Formula, ...]

    @property
    def literal(self) -> Formula:
        guards = (Until(negated(later), earlier) for earlier, later in pairwise(self.places))
        return conjunction(SequencedVisit(self.places).literal, *guards)


@dataclass(frozen=True, slots=True)
class StrictOrderedVisit(SameReading):
    """An ordered visit that enters no place twice before the next one."""

    places: tuple[Formula, ...]

    @property
    def literal(self) -> Formula:
        once = (
            Until(negated(here), Until(here, Until(negated(here), there)))
            for here, there in pairwise(self.places)
        )
        return conjunction(OrderedVisit(self.places).literal, *once)


@dataclass(frozen=True, slots=True)
class GuardedVisit(SameReading):
    """A place, and not before another one, which is only named as a guard."""

    place: Formula
    guard: Formula

    @property
    def literal(self) -> Formula:
        return conjunction(Eventually(self.place), Until(negated(self.place), self.guard))


@dataclass(frozen=True, slots=True)
class FairVisit:
    """Each place, and none of them again before the one that follows it in the round."""

    places: tuple[Formula, ...]

    @property
    def literal(self) -> Formula:
        return conjunction(
            Visit(self.places).literal, *(Always(Implies(a, Next(w))) for a, w in self._waits())
        )

    @property
    def executable(self) -> Formula:
        return conjunction(
            Visit(self.places).literal,
            *(Always(Implies(a, WeakNext(w))) for a, w in self._waits()),
        )

    def _waits(self) -> tuple[tuple[Formula, Formula], ...]:
        following = (*self.places[1:], self.places[0])
        return tuple(
            (here, WeakUntil(negated(here), there))
            for here, there in zip(self.places, following, strict=True)
        )


@dataclass(frozen=True, slots=True)
class Patrolling(SameReading):
    """Each place again and again. One place or more.

    On finite traces `G F a` says "a at the last instant", so that two disjoint places are
    unsatisfiable; what a person can have instead is rounds, a sequenced visit repeated.
    """

    places: tuple[Formula, ...]

    @property
    def literal(self) -> Formula:
        return conjunction(*(Always(Eventually(place)) for place in self.places))

    def rounds(self, times: int) -> SequencedVisit:
        """The places one after another, `times` times over."""
        return SequencedVisit(self.places * times)


@dataclass(frozen=True, slots=True)
class AtLeast(SameReading):
    """At least `times` separate entries (lower restricted avoidance)."""

    place: Formula
    times: int

    @property
    def literal(self) -> Formula:
        here, away = self.place, negated(self.place)
        formula: Formula = Eventually(here)
        for _ in range(self.times - 1):
            again = conjunction(away, Until(away, formula))
            formula = Eventually(conjunction(here, Until(here, again)))
        return formula


@dataclass(frozen=True, slots=True)
class AtMost(SameReading):
    """At most `times` separate entries (upper restricted avoidance)."""

    place: Formula
    times: int

    @property
    def literal(self) -> Formula:
        return Not(AtLeast(self.place, self.times + 1).literal)


@dataclass(frozen=True, slots=True)
class Exactly(SameReading):
    """Exactly `times` separate entries (exact restricted avoidance)."""

    place: Formula
    times: int

    @property
    def literal(self) -> Formula:
        return conjunction(
            AtLeast(self.place, self.times).literal, AtMost(self.place, self.times).literal
        )


def negated(formula: Formula) -> Formula:
    """The negation, without a double one; of a boolean combination, on its parts."""
    match formula:
        case Not(operand):
            return operand
        case And(operands):
            return disjunction(*map(negated, operands))
        case _:
            return Not(formula)
