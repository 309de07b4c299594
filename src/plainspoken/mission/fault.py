"""What goes wrong with robots, on purpose: a simulated robot with faults, seeded.

Each action that is sent draws whether a fault strikes it. The task manager sees what it would see
of a real robot: an error, silence, a result that is not so, a lost connection, a changed world.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from random import Random

from plainspoken.errors import PlainspokenError
from plainspoken.mission.mission import GoalId
from plainspoken.mission.robot import (
    Failed,
    GoalStatus,
    Seconds,
    Succeeded,
    UnderWay,
    Unreachable,
)
from plainspoken.mission.simulator import Simulator
from plainspoken.world.domain import GroundAction, GroundAtom, Problem, State
from plainspoken.world.scene import applicable_actions, successors

STRIKES = 0.3
"""How likely a fault is for each action, where nobody says."""
STEADFAST = 0.25
"""The share of hanging actions that not even a cancellation ends."""
AWAY: tuple[Seconds, Seconds] = (5.0, 120.0)
"""How long a connection is lost, at least and at most."""
MOST_STRANGE = 3
"""How many facts a strange outcome gets wrong, at most."""
MOMENT: Seconds = 5.0
"""How much simulated time passes while nothing is heard."""


class FaultKind(StrEnum):
    """What can go wrong."""

    FAILING = "failing"
    """The action is given up by the robot, and changes nothing."""
    HANGING = "hanging"
    """The action never ends; a cancellation mostly helps."""
    LYING = "lying"
    """The result says another outcome than the one that came about."""
    LOST = "lost"
    """The robot cannot be reached for a while, and goes on meanwhile."""
    PERSON = "person"
    """Somebody walks in and does something that some action would do."""
    DRIFT = "drift"
    """A fact changes by itself, to something that may make no sense at all."""
    STRANGE = "strange"
    """The action turns out as no outcome of the domain has it."""
    UNLUCKY = "unlucky"
    """Of the outcomes that may come about, it is the one that leads back to where all began."""


@dataclass(frozen=True, slots=True)
class Fault:
    """A fault and how likely it strikes an action."""

    kind: FaultKind
    chance: float = STRIKES


def fault_from(text: str) -> Fault:
    """Read `hanging` or `hanging:0.1`.

    raises PlainspokenError: when there is no such fault, or the chance is no share of one
    """
    name, _, share = text.partition(":")
    try:
        fault = Fault(FaultKind(name.strip().lower()), float(share) if share else STRIKES)
    except ValueError as error:
        raise PlainspokenError(
            f"no fault is called {text!r}",
            hint=f"one of {', '.join(FaultKind)}, with its chance if wanted: hanging:0.1",
        ) from error
    if not 0.0 <= fault.chance <= 1.0:
        raise PlainspokenError(f"a chance is from 0 to 1, not {share}", where=text)
    return fault


class FaultyRobot:
    """A simulated robot that faults strike; everything else is as the simulator has it."""

    def __init__(
        self, problem: Problem, simulator: Simulator, faults: tuple[Fault, ...], *, seed: int = 0
    ) -> None:
        self._problem = problem
        self._simulator = simulator
        self._faults = faults
        self._chance = Random(f"{seed}:faults")
        self._struck: dict[GoalId, FaultKind | None] = {}
        self._ended: dict[GoalId, GoalStatus] = {}
        self._before: dict[GoalId, State] = {}
        self._actions: dict[GoalId, GroundAction] = {}
        self._steadfast: set[GoalId] = set()
        self._seen: Counter[State] = Counter()
        self._atoms = fluents_of(problem)
        self._back_at: Seconds = 0.0
        self._idle: Seconds = 0.0

    @property
    def elapsed(self) -> Seconds:
        """Simulated time, with that in which nothing was heard."""
        return self._simulator.elapsed + self._idle

    def sleep(self, seconds: Seconds) -> None:
        """Let simulated time pass."""
        self._idle += max(seconds, MOMENT)

    def lose(self, seconds: Seconds) -> None:
        """Have the connection break for so long."""
        self._back_at = self.elapsed + seconds

    def state(self) -> State:
        self._reach()
        return self._simulator.state()

    def send(self, goal_id: GoalId, action: GroundAction) -> None:
        """Begin an action, and draw whether a fault strikes it."""
        self._reach()
        if goal_id in self._struck:
            return
        kind = self._drawn()
        self._struck[goal_id], self._actions[goal_id] = kind, action
        self._before[goal_id] = self._simulator.state()
        self._seen[self._simulator.state()] += 1
        self._simulator.send(goal_id, action)
        if kind is FaultKind.PERSON:
            self._somebody_does_something()
        elif kind is FaultKind.DRIFT:
            self._change(self._chance.sample(self._atoms, 1))
        elif kind is FaultKind.HANGING and self._chance.random() < STEADFAST:
            self._steadfast.add(goal_id)
        elif kind is FaultKind.LOST:
            self.lose(self._chance.uniform(*AWAY))

    def wait(self, goal_id: GoalId, timeout: Seconds) -> GoalStatus:
        self._reach()
        if goal_id in self._ended:
            return self._ended[goal_id]
        kind = self._struck.get(goal_id)
        if kind is FaultKind.HANGING:
            self.sleep(timeout)
            return UnderWay(0.5)
        if kind is FaultKind.FAILING:
            self._simulator.cancel(goal_id)
            return self._end(goal_id, Failed("the gripper did not close", self._simulator.state()))
        status = self._simulator.wait(goal_id, timeout)
        if isinstance(status, UnderWay):
            return status
        if kind is FaultKind.LYING and isinstance(status, Succeeded):
            status = Succeeded(self._other_outcome(goal_id, status.state))
        elif isinstance(status, Succeeded) and kind in (FaultKind.STRANGE, FaultKind.UNLUCKY):
            if kind is FaultKind.STRANGE:
                most = min(len(self._atoms), MOST_STRANGE)
                self._change(self._chance.sample(self._atoms, self._chance.randint(1, most)))
            else:
                self._set(self._worst_outcome(goal_id))
            status = Succeeded(self._simulator.state())
        return self._end(goal_id, status)

    def cancel(self, goal_id: GoalId) -> None:
        self._reach()
        if self._struck.get(goal_id) is FaultKind.HANGING and goal_id not in self._ended:
            if goal_id in self._steadfast:
                return
            self._end(goal_id, Failed("cancelled", self._simulator.state()))
        self._simulator.cancel(goal_id)

    def _reach(self) -> None:
        if self.elapsed < self._back_at:
            self.sleep(0.0)
            raise Unreachable("no answer from the robot")

    def _drawn(self) -> FaultKind | None:
        for fault in self._faults:
            if self._chance.random() < fault.chance:
                return fault.kind
        return None

    def _end(self, goal_id: GoalId, status: GoalStatus) -> GoalStatus:
        self._ended[goal_id] = status
        return status

    def _other_outcome(self, goal_id: GoalId, true: State) -> State:
        """An outcome that did not come about; where there is one only, that nothing happened."""
        before, action = self._before[goal_id], self._actions[goal_id]
        others = [s for s in successors(self._problem, before, action) if s != true]
        return self._chance.choice(others) if others else before

    def _worst_outcome(self, goal_id: GoalId) -> State:
        """The outcome that has led nowhere most often."""
        outcomes = successors(self._problem, self._before[goal_id], self._actions[goal_id])
        most = max(self._seen[state] for state in outcomes)
        return self._chance.choice([each for each in outcomes if self._seen[each] == most])

    def _somebody_does_something(self) -> None:
        """Have the world change as some action would change it."""
        now = self._simulator.state()
        actions = list(applicable_actions(self._problem, now))
        if actions:
            self._set(
                self._chance.choice(successors(self._problem, now, self._chance.choice(actions)))
            )

    def _change(self, atoms: Sequence[GroundAtom]) -> None:
        """Have each of the atoms become what it was not."""
        self._set(self._simulator.state() ^ frozenset(atoms))

    def _set(self, then: State) -> None:
        now = self._simulator.state()
        self._simulator.disturb(added=then - now, deleted=now - then)


def fluents_of(problem: Problem) -> list[GroundAtom]:
    """Every ground atom of the predicates that some action changes, sensible or not."""
    return sorted(
        " ".join([name, *binding.values()])
        for name, parameters in problem.domain.predicates.items()
        if name in problem.changing_predicates
        for binding in problem.bindings(parameters)
    )
