"""A simulated robot: does what the domain says, and draws which outcome comes about.

Every draw depends on the seed and on how many actions were carried out before, not on what was
drawn: so a run that was interrupted and resumed goes on as it would have.
"""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from random import Random

from plainspoken.errors import PlainspokenError
from plainspoken.mission.mission import GoalId
from plainspoken.mission.robot import Failed, GoalStatus, Seconds, Succeeded, UnderWay, Unheard
from plainspoken.world.domain import GroundAction, GroundAtom, Problem, State
from plainspoken.world.scene import is_applicable, successors
from plainspoken.world.symbol import AtomSymbol, flat, resolve

USUAL_DURATION: tuple[Seconds, Seconds] = (4.0, 12.0)
"""How long an action takes in simulated time, at least and at most, where nobody says."""
FORCED_TRIES = 3
"""How often steering decides one action in one state before chance does.

Without an end, steering towards "the support robot does not come" would be unfair: a mission
that tries again until it comes would never end, and no policy could help it.
"""


@dataclass(frozen=True, slots=True)
class Steering:
    """A wish for how chance should fall: outcomes where the atom is, or is not, true."""

    atom: GroundAtom
    wanted: bool = True

    def __str__(self) -> str:
        return self.atom if self.wanted else f"not {self.atom}"


def steering_from(text: str, problem: Problem) -> Steering:
    """Read `unripe g1`, `not full b`, or the same as ids: `unripe_g1`, `!full_b`.

    raises UnknownSymbolError: when the problem has no such atom
    raises PlainspokenError: when it is not an atom
    """
    words = text.lower().replace("!", " not ").split()
    wanted = words[:1] != ["not"]
    id = flat(" ".join(words if wanted else words[1:]))
    symbol = resolve(id, problem)
    if not isinstance(symbol, AtomSymbol):
        raise PlainspokenError(
            f"cannot steer by {text!r}: it is an action, not a fact",
            hint="say what an action should bring about, such as 'unripe g1' or 'not full b'",
        )
    return Steering(symbol.atom, wanted)


@dataclass(slots=True)
class _Goal:
    action: GroundAction
    begins: Seconds
    ends: Seconds
    status: GoalStatus


class Simulator:
    """A robot, or several, in a world that follows a planning problem."""

    def __init__(
        self,
        problem: Problem,
        *,
        seed: int = 0,
        steering: Sequence[Steering] = (),
        state: State | None = None,
        history: Iterable[tuple[State, GroundAction]] = (),
        durations: Mapping[str, tuple[Seconds, Seconds]] | None = None,
        pace: float = 0.0,
        sleep: Callable[[Seconds], None] = time.sleep,
    ) -> None:
        """Set a simulated world up.

        steering:  wishes, the first one goes before the next
        state:     where it begins, None for the problem's s0
        history:   the actions carried out before, each with the state it was done in; where a
                   run is resumed. Their states may leave static atoms out
        durations: simulated seconds by the name of the action, at least and at most
        pace:      real seconds to wait for each simulated one; 0 is not to wait at all
        """
        self._problem = problem
        self._static = frozenset(
            atom for atom in problem.initial if atom.split()[0] not in problem.changing_predicates
        )
        self._state = (problem.initial if state is None else state) | self._static
        self._seed = seed
        self._steering = tuple(steering)
        self._tries = Counter((before | self._static, action) for before, action in history)
        self._durations = durations or {}
        self._pace = pace
        self._sleep = sleep
        self._goals: dict[GoalId, _Goal] = {}
        self.elapsed: Seconds = 0.0
        """Simulated time since this simulator began."""

    def state(self) -> State:
        """Every true atom, static ones too: a simulator sees everything."""
        return self._state

    def disturb(self, added: Iterable[GroundAtom] = (), deleted: Iterable[GroundAtom] = ()) -> None:
        """Change the world from outside, as a person does who walks in."""
        self._state = (self._state - frozenset(deleted)) | frozenset(added)

    def send(self, goal_id: GoalId, action: GroundAction) -> None:
        """Begin an action. A goal id heard before is ignored."""
        if goal_id not in self._goals:
            at_least, at_most = self._durations.get(action.split()[0], USUAL_DURATION)
            use = f"duration of {action}" if self._under_way() else "duration"
            duration = self._chance(use).uniform(at_least, at_most)
            ends = self.elapsed + duration
            self._goals[goal_id] = _Goal(action, self.elapsed, ends, UnderWay(0.0))

    def wait(self, goal_id: GoalId, timeout: Seconds) -> GoalStatus:
        """What became of a command; timeout is in real seconds.

        Without a pace, time goes on to the end of whichever action under way ends first.
        """
        goal = self._goals.get(goal_id)
        if goal is None:
            return Unheard()
        if isinstance(goal.status, UnderWay):
            if self._pace > 0.0:
                nap = min(goal.ends - self.elapsed, timeout / self._pace)
                self._sleep(nap * self._pace)
                # What is left is told in full: a sum of naps may miss the end by a hair.
                self.elapsed = goal.ends - max(goal.ends - self.elapsed - nap, 0.0)
            else:
                self.elapsed = min(other.ends for other in self._under_way())
            self._end_what_is_due()
            if isinstance(goal.status, UnderWay):
                share = (self.elapsed - goal.begins) / (goal.ends - goal.begins)
                goal.status = UnderWay(share)
        return goal.status

    def _under_way(self) -> list[_Goal]:
        return [goal for goal in self._goals.values() if isinstance(goal.status, UnderWay)]

    def _end_what_is_due(self) -> None:
        for goal in sorted(self._under_way(), key=lambda goal: goal.ends):
            if goal.ends <= self.elapsed:
                goal.status = self._carried_out(goal.action)

    def cancel(self, goal_id: GoalId) -> None:
        """Give an action up: it changes nothing."""
        goal = self._goals.get(goal_id)
        if goal is not None and isinstance(goal.status, UnderWay):
            goal.status = Failed("cancelled", self._state)

    def _carried_out(self, action: GroundAction) -> GoalStatus:
        if not is_applicable(self._problem, self._state, action):
            return Failed("its precondition does not hold", self._state)
        outcomes = successors(self._problem, self._state, action)
        if self._tries[self._state, action] < FORCED_TRIES:
            outcomes = self._steered(outcomes)
        chance = self._chance("outcome")
        self._tries[self._state, action] += 1
        # Each distinct state is as likely as the next: the domain gives no numbers.
        self._state = chance.choice(outcomes)
        return Succeeded(self._state)

    def _steered(self, outcomes: tuple[State, ...]) -> tuple[State, ...]:
        """The outcomes that the wishes leave; a wish that no outcome grants is passed over."""
        for wish in self._steering:
            granted = tuple(o for o in outcomes if (wish.atom in o) == wish.wanted)
            outcomes = granted or outcomes
        return outcomes

    def _chance(self, use: str) -> Random:
        return Random(f"{self._seed}:{self._tries.total()}:{use}")
