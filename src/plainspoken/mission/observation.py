"""What the task manager is told: by the robot, by people, and by whoever plans."""

from __future__ import annotations

from dataclasses import dataclass

from plainspoken.mission.mission import GoalId
from plainspoken.mission.request import Clause
from plainspoken.mission.sensing import Telling
from plainspoken.planning.policy import Policy
from plainspoken.world.domain import GroundAtom, State


@dataclass(frozen=True, slots=True)
class ActionDone:
    """The robot did the action; state is what is seen now.

    claimed: the state that the robot's result said, where it was another
    """

    goal_id: GoalId
    state: State
    claimed: State | None = None


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
class Progressed:
    """The robot is at another part of the action."""

    goal_id: GoalId
    progress: float | None
    doing: str | None


@dataclass(frozen=True, slots=True)
class Overdue:
    """The action takes longer than it may."""

    goal_id: GoalId
    seconds: float


@dataclass(frozen=True, slots=True)
class Stuck:
    """An action that was given up has not come to an end all the same."""

    goal_id: GoalId
    seconds: float


@dataclass(frozen=True, slots=True)
class Lost:
    """The robot cannot be reached. for_good: it was waited for long enough."""

    reason: str
    for_good: bool = False


@dataclass(frozen=True, slots=True)
class Found:
    """The robot can be reached again."""


@dataclass(frozen=True, slots=True)
class Sensed:
    """Somebody looked at the world between actions, or while one is under way."""

    source: str
    state: State


@dataclass(frozen=True, slots=True)
class FactsTold:
    """Single facts were looked at."""

    told: tuple[Telling, ...]


@dataclass(frozen=True, slots=True)
class LookAsked:
    """Somebody wants to know of these facts."""

    by: str
    atoms: frozenset[GroundAtom]


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
    """There is no policy; reason is for people.

    hopeless: whether no luck would help: nothing that the domain lets happen meets the request
    """

    reason: str
    hopeless: bool = False


@dataclass(frozen=True, slots=True)
class PauseAsked:
    by: str


@dataclass(frozen=True, slots=True)
class ResumeAsked:
    by: str


@dataclass(frozen=True, slots=True)
class TakeUpAsked:
    """A worker goes on where another process broke off, or where nobody began."""

    by: str


@dataclass(frozen=True, slots=True)
class CancelAsked:
    by: str


@dataclass(frozen=True, slots=True)
class ChangeAsked:
    """Somebody wants other clauses to hold, each from its instant on; english says them all."""

    by: str
    text: str
    clauses: tuple[Clause, ...]
    english: str = ""


Observation = (
    ActionDone
    | ActionNotDone
    | NeverHeard
    | Progressed
    | Overdue
    | Stuck
    | Lost
    | Found
    | ChangeAsked
    | Sensed
    | FactsTold
    | LookAsked
    | Told
    | Planned
    | NotPlanned
    | PauseAsked
    | ResumeAsked
    | TakeUpAsked
    | CancelAsked
)
