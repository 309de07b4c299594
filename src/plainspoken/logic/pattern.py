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

from plainspoken.logic.formula import (
    Always,
    Eventually,
    Formula,
    Iff,
    Implies,
    Next,
    Until,
    WeakNext,
    WeakUntil,
    conjunction,
    disjunction,
)
from plainspoken.logic.tour import (
    AtLeast,
    AtMost,
    Exactly,
    FairVisit,
    GuardedVisit,
    OrderedVisit,
    Patrolling,
    SameReading,
    SequencedVisit,
    StrictOrderedVisit,
    Visit,
    negated,
)

__all__ = [
    "NAMES",
    "AtLeast",
    "AtMost",
    "BoundDelay",
    "BoundReaction",
    "Choice",
    "DelayedReaction",
    "Exactly",
    "FairVisit",
    "FutureAvoidance",
    "GlobalAvoidance",
    "GuardedVisit",
    "InstantaneousReaction",
    "Maintenance",
    "OrderedVisit",
    "PastAvoidance",
    "Patrolling",
    "Pattern",
    "PromptPrecedence",
    "PromptReaction",
    "Remaining",
    "SequencedVisit",
    "StrictOrderedVisit",
    "Visit",
    "Wait",
    "negated",
    "rising",
]


@dataclass(frozen=True, slots=True)
class Maintenance(SameReading):
    """Each of these at every instant. One or more; not in the catalogue."""

    kept: tuple[Formula, ...]

    @property
    def literal(self) -> Formula:
        return conjunction(*map(Always, self.kept))


@dataclass(frozen=True, slots=True)
class Remaining(SameReading):
    """Each of these from some instant to the end. One or more; not in the catalogue."""

    kept: tuple[Formula, ...]

    @property
    def literal(self) -> Formula:
        return conjunction(*(Eventually(Always(each)) for each in self.kept))


@dataclass(frozen=True, slots=True)
class GlobalAvoidance(SameReading):
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
class Wait(SameReading):
    """This one until that one."""

    kept: Formula
    until: Formula

    @property
    def literal(self) -> Formula:
        return Until(self.kept, self.until)


@dataclass(frozen=True, slots=True)
class InstantaneousReaction(SameReading):
    """Whenever the trigger, the response at the same instant."""

    trigger: Formula
    response: Formula

    @property
    def literal(self) -> Formula:
        return Always(Implies(self.trigger, self.response))


@dataclass(frozen=True, slots=True)
class DelayedReaction(SameReading):
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
class BoundReaction(SameReading):
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


def rising(trigger: Formula) -> Formula:
    """The trigger does not hold now and does at the next instant."""
    return conjunction(negated(trigger), Next(trigger))
