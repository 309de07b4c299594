"""What every robot looks like to the task manager: simulated, over ROS 2 or over HTTP."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from plainspoken.errors import PlainspokenError
from plainspoken.mission.mission import GoalId
from plainspoken.world.domain import GroundAction, State

Seconds = float


@dataclass(frozen=True, slots=True)
class UnderWay:
    """The robot is at it.

    progress: from 0 to 1, None where the robot cannot say
    doing:    which part of it, in words, where there are parts
    """

    progress: float | None = None
    doing: str | None = None


@dataclass(frozen=True, slots=True)
class Succeeded:
    """The action came to its end; state is what the robot sees, whatever was expected."""

    state: State


@dataclass(frozen=True, slots=True)
class Failed:
    """The action was rejected, given up or cancelled; state is what the robot sees."""

    reason: str
    state: State


@dataclass(frozen=True, slots=True)
class Unheard:
    """The robot never began this. One that cannot be certain says `Failed`, and what it sees."""


GoalStatus = UnderWay | Succeeded | Failed | Unheard


class Unreachable(PlainspokenError):
    """The connection to a robot is lost, for now or for good; what it does is not known."""


class Robot(Protocol):
    """Takes one command at a time; several, where missions may go on side by side.

    Then it stands for several robots, each of which is given one command at a time.
    Its states hold every true atom that some action changes; static atoms may be left out.
    Each method may raise Unreachable. A command that raised it may have been heard or not:
    it is asked about, by `wait`, once the robot can be reached again.
    """

    def send(self, goal_id: GoalId, action: GroundAction) -> None:
        """Begin an action, and return at once. A goal id heard before is ignored."""

    def wait(self, goal_id: GoalId, timeout: Seconds) -> GoalStatus:
        """What became of a command, waiting at most so long for its end."""

    def cancel(self, goal_id: GoalId) -> None:
        """Give an action up, if possible; `wait` says what became of it."""

    def state(self) -> State:
        """What is true now, as far as the robot can see."""
