"""What the task manager is told: by the robot, by people, and by whoever plans."""

from __future__ import annotations

from dataclasses import dataclass

from plainspoken.mission.mission import GoalId
from plainspoken.planning.policy import Policy
from plainspoken.world.domain import GroundAtom, State


@dataclass(frozen=True, slots=True)
class ActionDone:
    """The robot did the action; state is what it sees now."""

    goal_id: GoalId
    state: State


@dataclass(frozen=True, slots=True)
class ActionNotDone:
    """The robot rejected, gave up or cancelled the action; state is what it sees now."""

    goal_id: GoalId
    reason: str
    state: State


@dataclass(frozen=True, slots=True)
class NeverHeard:
    """The robot is certain that it never began what this goal id names."""

    goal_id: GoalId


@dataclass(frozen=True, slots=True)
class Sensed:
    """Somebody looked at the world between actions, or while one is under way."""

    source: str
    state: State


@dataclass(frozen=True, slots=True)
class Told:
    """A person says what they did or saw."""

    reporter: str
    text: str
    added: frozenset[GroundAtom] = frozenset()
    deleted: frozenset[GroundAtom] = frozenset()


@dataclass(frozen=True, slots=True)
class Planned:
    """A policy for the current state and what is left of the goal."""

    policy: Policy


@dataclass(frozen=True, slots=True)
class NotPlanned:
    """There is no policy; reason is for people."""

    reason: str


@dataclass(frozen=True, slots=True)
class PauseAsked:
    by: str


@dataclass(frozen=True, slots=True)
class ResumeAsked:
    by: str


@dataclass(frozen=True, slots=True)
class CancelAsked:
    by: str


Observation = (
    ActionDone
    | ActionNotDone
    | NeverHeard
    | Sensed
    | Told
    | Planned
    | NotPlanned
    | PauseAsked
    | ResumeAsked
    | CancelAsked
)
