"""What the task manager asks of the world. The edge obeys only after the events are stored."""

from __future__ import annotations

from dataclasses import dataclass

from plainspoken.logic.formula import Formula
from plainspoken.mission.mission import GoalId
from plainspoken.world.domain import GroundAction, GroundAtom, State


@dataclass(frozen=True, slots=True)
class Send:
    """Have the robot do an action. The same goal id twice is one action, not two."""

    goal_id: GoalId
    action: GroundAction


@dataclass(frozen=True, slots=True)
class Attach:
    """Ask the robot what became of an action that it may have been told to do."""

    goal_id: GoalId


@dataclass(frozen=True, slots=True)
class CancelAction:
    """Have the robot give an action up, if it can."""

    goal_id: GoalId


@dataclass(frozen=True, slots=True)
class Look:
    """Observe the world."""


@dataclass(frozen=True, slots=True)
class Sense:
    """Have these facts looked at. The same look twice is one look."""

    look: str
    atoms: tuple[GroundAtom, ...]


@dataclass(frozen=True, slots=True)
class Reconnect:
    """Try until the robot can be reached again, or long enough."""


@dataclass(frozen=True, slots=True)
class Plan:
    """Find a policy from a state.

    remaining: what is left of the goal, for a trace that begins in this state
    """

    state: State
    remaining: Formula


Command = Send | Attach | CancelAction | Look | Sense | Reconnect | Plan
