"""What a mission knows that it does not know, and what it wants to have looked at."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from plainspoken.world.domain import GroundAtom, Problem, State
from plainspoken.world.event import (
    ActionFinished,
    Event,
    LookRequested,
    MissionAccepted,
    ObservationMade,
    ReportReceived,
    Resumed,
    Stated,
)
from plainspoken.world.sense import Senses, left_open, told_by


@dataclass(frozen=True)
class Lookout:
    """A mission's doubts at one moment.

    senses:  how facts come to be known
    unknown: atoms of which nobody has said yet whether they are true; the state assumes it
    groups:  unknown atoms of which exactly one is true
    wanted:  what somebody wants to know
    vain:    what could not be told since the last action
    looks:   how often single facts were looked at
    """

    senses: Senses = field(default_factory=Senses)
    unknown: State = frozenset()
    groups: tuple[tuple[GroundAtom, ...], ...] = ()
    wanted: frozenset[GroundAtom] = frozenset()
    vain: frozenset[GroundAtom] = frozenset()
    looks: int = 0

    @classmethod
    def of(cls, accepted: MissionAccepted, problem: Problem) -> Lookout:
        """At s0."""
        unknown = frozenset(accepted.unknown)
        groups = tuple(group for group in problem.oneofs if unknown.issuperset(group))
        return cls(Senses.of(accepted), unknown, groups)

    def unsure(self, stale: State = frozenset()) -> State:
        """The atoms that should be looked at before anything rests on them, and can be.

        stale: those that were seen too long ago
        """
        return frozenset(atom for atom in self.unknown | stale if self.senses.can_tell(atom))

    def after(self, event: Event, state: State, static: State, problem: Problem) -> Lookout:
        """The doubts after an event of the log; state, static: what is true before it."""
        match event:
            case LookRequested(atoms=atoms):
                return replace(self, wanted=self.wanted | frozenset(atoms))
            case Resumed():
                return replace(self, vain=frozenset())
            case _:
                pass
        if not isinstance(event, Stated):
            return self
        sensed = event.sensed if isinstance(event, ObservationMade) else ()
        reported = (
            frozenset(each["atom"] for each in event.told)
            if isinstance(event, ReportReceived)
            else frozenset()
        )
        told = (
            told_by(event, state | static, self.unknown, self.senses, problem)
            if self.unknown
            else {}
        )
        vain = frozenset() if isinstance(event, ActionFinished) else self.vain
        if not (sensed or told or reported):
            return self if vain == self.vain else replace(self, vain=vain)
        untold = frozenset(each["atom"] for each in sensed if each["holds"] is None)
        found = {each["atom"]: bool(each["holds"]) for each in sensed if each["holds"] is not None}
        return replace(
            self,
            unknown=self.unknown - told.keys(),
            groups=left_open(self.groups, found, told.keys() - found.keys()),
            wanted=self.wanted - untold - found.keys() - reported,
            vain=(vain | untold) - found.keys() - reported,
            looks=self.looks + bool(sensed),
        )
