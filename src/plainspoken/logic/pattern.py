"""The mission patterns, each a value with two readings.

`literal` is the formula as the catalogue and the published datasets print it; `executable` is the
reading a planner can be asked for. They differ where strong next at the last instant, or a
condition that stays true once it is true, makes the literal formula unsatisfiable or satisfied
only by never starting.

Operands are formulas: an atom, a negated atom, or a small boolean combination. Places are two or
more unless a pattern says otherwise. `persists` says whether a trigger stays true until something
changes it (locations and conditions do, action symbols do not): the executable trigger is then the
instant at which it becomes true.

Source: Menghi et al., Specification Patterns for Robotic Missions, TSE 2019; read on finite traces.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

from plainspoken.logic.formula import (
    Always,
    And,
    Eventually,
    Formula,
    Iff,
    Implies,
    Next,
    Not,
    Until,
    WeakNext,
    WeakUntil,
    conjunction,
    disjunction,
)


class _SameReading:
    """A pattern whose two readings are one."""

    __slots__ = ()

    @property
    def literal(self) -> Formula:
        raise NotImplementedError

    @property
    def executable(self) -> Formula:
        return self.literal


@dataclass(frozen=True, slots=True)
class Visit(_SameReading):
    """Each place at some instant, in any order. One place or more."""

    places: tuple[Formula, ...]

    @property
    def literal(self) -> Formula:
        return conjunction(*map(Eventually, self.places))


@dataclass(frozen=True, slots=True)
class SequencedVisit(_SameReading):
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
class OrderedVisit(_SameReading):
    """A sequenced visit in which no place comes before the one in front of it."""

    places: tuple[Formula, ...]

    @property
    def literal(self) -> Formula:
        guards = (Until(negated(later), earlier) for earlier, later in pairwise(self.places))
        return conjunction(SequencedVisit(self.places).literal, *guards)


@dataclass(frozen=True, slots=True)
class StrictOrderedVisit(_SameReading):
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
class GuardedVisit(_SameReading):
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
class Patrolling(_SameReading):
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
class Maintenance(_SameReading):
    """Each of these at every instant. One or more; not in the catalogue."""

    kept: tuple[Formula, ...]

    @property
    def literal(self) -> Formula:
        return conjunction(*map(Always, self.kept))


@dataclass(frozen=True, slots=True)
class Remaining(_SameReading):
    """Each of these from some instant to the end. One or more; not in the catalogue."""

    kept: tuple[Formula, ...]

    @property
    def literal(self) -> Formula:
        return conjunction(*(Eventually(Always(each)) for each in self.kept))


@dataclass(frozen=True, slots=True)
class GlobalAvoidance(_SameReading):
    """None of these at any instant. One or more."""

    avoided: tuple[Formula, ...]

    @property
    def literal(self) -> Formula:
        return conjunction(*(Always(negated(each)) for each in self.avoided))


@dataclass(frozen=True, slots=True)
class PastAvoidance:
    """Not this one until that one.

    demanded: whether the sentence asks for `until` itself, too
    """

    avoided: Formula
    until: Formula
    demanded: bool = False

    @property
    def literal(self) -> Formula:
        return Until(negated(self.avoided), self.until)

    @property
    def executable(self) -> Formula:
        return self.literal if self.demanded else WeakUntil(negated(self.avoided), self.until)


@dataclass(frozen=True, slots=True)
class FutureAvoidance:
    """Not this one any more after that one."""

    after: Formula
    avoided: Formula

    @property
    def literal(self) -> Formula:
        return Always(Implies(self.after, Next(Always(negated(self.avoided)))))

    @property
    def executable(self) -> Formula:
        return Always(Implies(self.after, WeakNext(Always(negated(self.avoided)))))


@dataclass(frozen=True, slots=True)
class AtLeast(_SameReading):
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
class AtMost(_SameReading):
    """At most `times` separate entries (upper restricted avoidance)."""

    place: Formula
    times: int

    @property
    def literal(self) -> Formula:
        return Not(AtLeast(self.place, self.times + 1).literal)


@dataclass(frozen=True, slots=True)
class Exactly(_SameReading):
    """Exactly `times` separate entries (exact restricted avoidance)."""

    place: Formula
    times: int

    @property
    def literal(self) -> Formula:
        return conjunction(
            AtLeast(self.place, self.times).literal, AtMost(self.place, self.times).literal
        )


@dataclass(frozen=True, slots=True)
class Wait(_SameReading):
    """This one until that one."""

    kept: Formula
    until: Formula

    @property
    def literal(self) -> Formula:
        return Until(self.kept, self.until)


@dataclass(frozen=True, slots=True)
class InstantaneousReaction(_SameReading):
    """Whenever the trigger, the response at the same instant."""

    trigger: Formula
    response: Formula

    @property
    def literal(self) -> Formula:
        return Always(Implies(self.trigger, self.response))


@dataclass(frozen=True, slots=True)
class DelayedReaction(_SameReading):
    """Whenever the trigger, the response then or later."""

    trigger: Formula
    response: Formula

    @property
    def literal(self) -> Formula:
        return Always(Implies(self.trigger, Eventually(self.response)))


@dataclass(frozen=True, slots=True)
class PromptReaction:
    """Whenever the trigger, the response at the next instant."""

    trigger: Formula
    response: Formula
    persists: bool = True

    @property
    def literal(self) -> Formula:
        return Always(Implies(self.trigger, Next(self.response)))

    @property
    def executable(self) -> Formula:
        if not self.persists:
            return self.literal
        return conjunction(
            Implies(self.trigger, Next(self.response)),
            Always(Implies(rising(self.trigger), Next(Next(self.response)))),
        )


@dataclass(frozen=True, slots=True)
class PromptPrecedence:
    """The response only at the instant after the trigger; not in the catalogue.

    Together with a prompt reaction it makes a bound delay.
    """

    trigger: Formula
    response: Formula
    persists: bool = True

    @property
    def literal(self) -> Formula:
        return Always(Implies(Next(self.response), self.trigger))

    @property
    def executable(self) -> Formula:
        if not self.persists:
            return self.literal
        return conjunction(
            Implies(Next(self.response), self.trigger),
            Always(Implies(Next(Next(self.response)), rising(self.trigger))),
        )


@dataclass(frozen=True, slots=True)
class BoundReaction(_SameReading):
    """The response exactly when the trigger."""

    trigger: Formula
    response: Formula

    @property
    def literal(self) -> Formula:
        return Always(Iff(self.trigger, self.response))


@dataclass(frozen=True, slots=True)
class BoundDelay:
    """The response at the instant after the trigger, and at no other."""

    trigger: Formula
    response: Formula
    persists: bool = True

    @property
    def literal(self) -> Formula:
        return Always(Iff(self.trigger, Next(self.response)))

    @property
    def executable(self) -> Formula:
        if not self.persists:
            return self.literal
        return conjunction(
            Iff(self.trigger, Next(self.response)),
            Always(Iff(rising(self.trigger), Next(Next(self.response)))),
        )


@dataclass(frozen=True, slots=True)
class Choice:
    """One of several options, each a conjunction of patterns; not in the catalogue."""

    options: tuple[tuple[Pattern, ...], ...]

    @property
    def literal(self) -> Formula:
        return disjunction(*(conjunction(*(p.literal for p in each)) for each in self.options))

    @property
    def executable(self) -> Formula:
        return disjunction(*(conjunction(*(p.executable for p in each)) for each in self.options))


Pattern = (
    Visit
    | SequencedVisit
    | OrderedVisit
    | StrictOrderedVisit
    | GuardedVisit
    | FairVisit
    | Patrolling
    | Maintenance
    | Remaining
    | GlobalAvoidance
    | PastAvoidance
    | FutureAvoidance
    | AtLeast
    | AtMost
    | Exactly
    | Wait
    | InstantaneousReaction
    | DelayedReaction
    | PromptReaction
    | PromptPrecedence
    | BoundReaction
    | BoundDelay
    | Choice
)

NAMES: dict[type[Pattern], str] = {
    Visit: "visit",
    SequencedVisit: "sequenced visit",
    OrderedVisit: "ordered visit",
    StrictOrderedVisit: "strict ordered visit",
    GuardedVisit: "guarded visit",
    FairVisit: "fair visit",
    Patrolling: "patrolling",
    Maintenance: "maintenance",
    Remaining: "remaining",
    GlobalAvoidance: "global avoidance",
    PastAvoidance: "past avoidance",
    FutureAvoidance: "future avoidance",
    AtLeast: "lower restricted avoidance",
    AtMost: "upper restricted avoidance",
    Exactly: "exact restricted avoidance",
    Wait: "wait",
    InstantaneousReaction: "instantaneous reaction",
    DelayedReaction: "delayed reaction",
    PromptReaction: "prompt reaction",
    PromptPrecedence: "prompt precedence",
    BoundReaction: "bound reaction",
    BoundDelay: "bound delay",
    Choice: "choice",
}
"""What the catalogue calls each pattern."""


def negated(formula: Formula) -> Formula:
    """The negation, without a double one; of a boolean combination, on its parts."""
    match formula:
        case Not(operand):
            return operand
        case And(operands):
            return disjunction(*map(negated, operands))
        case _:
            return Not(formula)


def rising(trigger: Formula) -> Formula:
    """The trigger does not hold now and does at the next instant."""
    return conjunction(negated(trigger), Next(trigger))
