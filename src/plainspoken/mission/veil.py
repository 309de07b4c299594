"""A simulated robot that does not see everything: what the problem calls unknown is hidden.

It sees a hidden fact where it is told to look at it, or where an action of its own may have
changed it. Everything else it believes until then.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from random import Random

from plainspoken.mission.mission import GoalId
from plainspoken.mission.robot import (
    Failed,
    GoalStatus,
    Robot,
    Seconds,
    Succeeded,
    Unreachable,
)
from plainspoken.mission.sensing import LookId, Telling
from plainspoken.mission.simulator import Steering
from plainspoken.world.domain import GroundAction, GroundAtom, Problem, State
from plainspoken.world.scene import touched_by
from plainspoken.world.sense import Sense

BY = "simulator"
TRIES = 3
"""How often a robot that cannot be reached is asked for a fact."""


def utc_now() -> datetime:
    """The clock that looks are dated by."""
    return datetime.now(UTC)


def drawn(problem: Problem, seed: int, steering: Sequence[Steering] = ()) -> Problem:
    """The problem with what nobody knows decided by chance, and by wishes where there are some."""
    chance = Random(f"{seed}:hidden")
    wishes = {wish.atom: wish.wanted for wish in reversed(steering)}
    true: set[GroundAtom] = set()
    grouped = {atom for group in problem.oneofs for atom in group}
    for atom in sorted(problem.unknown - grouped):
        fell = chance.random() < 0.5
        if wishes.get(atom, fell):
            true.add(atom)
    for group in problem.oneofs:
        wanted = [atom for atom in group if wishes.get(atom)]
        allowed = [atom for atom in group if wishes.get(atom) is not False]
        true.add(chance.choice(wanted or allowed or group))
    return replace(problem, initial=(problem.initial - problem.unknown) | true)


class VeiledRobot:
    """A robot some facts of whose world are hidden."""

    def __init__(
        self,
        robot: Robot,
        problem: Problem,
        *,
        belief: State | None = None,
        under_way: Mapping[GoalId, GroundAction] | None = None,
        now: Callable[[], datetime] = utc_now,
    ) -> None:
        """Veil a robot that sees everything.

        problem:   says what is hidden
        belief:    the world as it is believed to be, None for what the problem assumes
        under_way: what it was told by a process before this one
        """
        self._robot, self._problem = robot, problem
        self._hidden = problem.unknown
        believed = problem.initial if belief is None else belief
        self._belief = believed & self._hidden
        self._changing = {
            goal: touched_by(problem, believed, action)
            for goal, action in (under_way or {}).items()
        }
        self._tries: dict[LookId, int] = {}
        self._now = now

    def send(self, goal_id: GoalId, action: GroundAction) -> None:
        # By the time that somebody asks for it, it may have ended, and not be possible any more.
        self._changing[goal_id] = touched_by(self._problem, self.state(), action)
        self._robot.send(goal_id, action)

    def wait(self, goal_id: GoalId, timeout: Seconds) -> GoalStatus:
        """What became of a command; what it changed is seen."""
        status = self._robot.wait(goal_id, timeout)
        match status:
            case Succeeded(state):
                self._see(self._changing.pop(goal_id, frozenset()), state)
                return Succeeded(self._seen(state))
            case Failed(reason, state):
                return Failed(reason, self._seen(state))
            case _:
                return status

    def cancel(self, goal_id: GoalId) -> None:
        self._robot.cancel(goal_id)

    def state(self) -> State:
        return self._seen(self._robot.state())

    def believe(self, added: Iterable[GroundAtom] = (), deleted: Iterable[GroundAtom] = ()) -> None:
        """Take in what a person reports."""
        self._belief = (self._belief - frozenset(deleted)) | (frozenset(added) & self._hidden)

    # -- what can be asked for -----------------------------------------------------------------

    @property
    def senses(self) -> Sequence[Sense]:
        return tuple(Sense(atom, (BY,), needed=True) for atom in sorted(self._hidden))

    def unknown_at_first(self) -> State:
        return self._hidden

    def sense(
        self, look: LookId, atoms: Sequence[GroundAtom], timeout: Seconds
    ) -> tuple[Telling, ...] | None:
        del timeout  # it sees at once
        time = self._now().isoformat(timespec="milliseconds")
        try:
            real = self._robot.state()
        except Unreachable as error:
            self._tries[look] = self._tries.get(look, 0) + 1
            if self._tries[look] < TRIES:
                return None
            return tuple(Telling(atom, None, BY, time, why=error.what) for atom in atoms)
        self._see(frozenset(atoms), real)
        return tuple(Telling(atom, atom in real, BY, time) for atom in atoms)

    def dismiss(self, look: LookId) -> None:
        self._tries.pop(look, None)

    # -- inside --------------------------------------------------------------------------------

    def _see(self, atoms: frozenset[GroundAtom], real: State) -> None:
        seen = atoms & self._hidden
        self._belief = (self._belief - seen) | (real & seen)

    def _seen(self, real: State) -> State:
        return (real - self._hidden) | self._belief
