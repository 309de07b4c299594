"""Looking at single facts: when a mission has to, and what robots that can do it are like."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol, runtime_checkable

from plainspoken.mission.mission import Mission
from plainspoken.mission.robot import Seconds
from plainspoken.world.domain import GroundAtom, State
from plainspoken.world.scene import relevant_to
from plainspoken.world.sense import Sense, implied
from plainspoken.world.symbol import AtomSymbol

LookId = str
"""Names one look at some facts: `<mission>/look-<how many, this one included>`."""
MODEL = "model"
"""What tells of a fact that follows from others that were told."""


@dataclass(frozen=True, slots=True)
class Telling:
    """What was told of one fact.

    holds: None where nobody could tell; why says why
    by:    the service that told it; reporter: the person who answered it
    time:  when, ISO 8601
    """

    atom: GroundAtom
    holds: bool | None
    by: str
    time: str | None = None
    reporter: str | None = None
    why: str | None = None

    def to_json(self) -> dict[str, Any]:
        """An item of the field `sensed` of an observation."""
        document = {"atom": self.atom, "holds": self.holds, "by": self.by, "time": self.time}
        more = {"reporter": self.reporter, "why": self.why}
        return {**document, **{key: value for key, value in more.items() if value is not None}}


@runtime_checkable
class Senser(Protocol):
    """A robot that can be asked about single facts."""

    @property
    def senses(self) -> Sequence[Sense]:
        """How facts come to be known."""

    def unknown_at_first(self) -> State:
        """The atoms of which nobody knows at s0, beside those that the problem names."""

    def sense(
        self, look: LookId, atoms: Sequence[GroundAtom], timeout: Seconds
    ) -> tuple[Telling, ...] | None:
        """What is told of each fact, waiting at most so long; None while something is still asked.

        One look may be asked for again, also by another process: it goes on. What cannot be
        reached is tried a few times, then told as not known.
        """

    def dismiss(self, look: LookId) -> None:
        """Nobody waits for this look any longer."""


def needed(mission: Mission, stale: State) -> frozenset[GroundAtom]:
    """The facts to be looked at before the mission goes on, or because somebody asked."""
    lookout = mission.lookout
    if mission.is_over or mission.lost is not None or mission.cancelled_by is not None:
        return frozenset()
    if mission.in_flight is not None or mission.paused_by is not None or mission.looking:
        return lookout.wanted
    return lookout.wanted | (_doubts(mission, stale) - lookout.vain)


def in_vain(mission: Mission, stale: State) -> frozenset[GroundAtom]:
    """The facts that the next step depends on, and that nothing could tell."""
    return _doubts(mission, stale) & mission.lookout.vain


def is_verdict_open(mission: Mission) -> bool:
    """Whether the request is about facts that are only assumed, and that can be looked at."""
    return bool(_asked_for(mission) & mission.lookout.unsure())


def told(mission: Mission, tellings: Sequence[Telling]) -> tuple[Telling, ...]:
    """What was told, with what follows from it."""
    known = {each.atom: each.holds for each in tellings if each.holds is not None}
    more = implied(known, mission.lookout.groups)
    return (*tellings, *(Telling(atom, holds, MODEL) for atom, holds in sorted(more.items())))


def seen_state(mission: Mission, tellings: Sequence[Telling]) -> State:
    """The state with what was told."""
    holds: Mapping[GroundAtom, bool | None] = {each.atom: each.holds for each in tellings}
    true = frozenset(atom for atom, so in holds.items() if so)
    false = frozenset(atom for atom, so in holds.items() if so is False)
    return (mission.state - false) | (true - mission.brief.static)


def _doubts(mission: Mission, stale: State) -> frozenset[GroundAtom]:
    unsure = mission.lookout.unsure(stale)
    if not unsure:
        return frozenset()
    relevant = _asked_for(mission)
    if mission.policy is not None and mission.node is not None:
        action = mission.policy.node(mission.node).action
        if action is not None:
            relevant |= relevant_to(mission.brief.problem, action)
    return relevant & unsure


def _asked_for(mission: Mission) -> frozenset[GroundAtom]:
    """The facts that the request speaks of."""
    symbols = mission.brief.symbols
    return frozenset(symbol.atom for symbol in symbols if isinstance(symbol, AtomSymbol))
