"""The loop at the edge: stores what was decided, obeys, observes, and decides again."""

from __future__ import annotations

import time
from collections.abc import Callable, Generator, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Protocol, assert_never, runtime_checkable

from plainspoken.logic.formula import Formula
from plainspoken.mission.command import Attach, CancelAction, Look, Plan, Reconnect, Send, Sense
from plainspoken.mission.executive import Advance, advance
from plainspoken.mission.mission import ActionInFlight, GoalId, Mission
from plainspoken.mission.observation import (
    ActionDone,
    ActionNotDone,
    FactsTold,
    Found,
    Lost,
    NeverHeard,
    NotPlanned,
    Observation,
    Overdue,
    PauseAsked,
    Planned,
    Progressed,
    Sensed,
    Stuck,
)
from plainspoken.mission.robot import (
    Failed,
    Robot,
    Seconds,
    Succeeded,
    UnderWay,
    Unheard,
    Unreachable,
)
from plainspoken.mission.sensing import Senser, Telling
from plainspoken.planning.policy import Policy
from plainspoken.world.domain import GroundAction, GroundAtom, State
from plainspoken.world.event import Entry, Event, Instant, ObservationMade, ReportReceived

Record = Callable[[Instant, Sequence[Event]], Sequence[Entry]]
"""Stores events, all or none, before it returns."""
Heed = Callable[[], None]
"""Called again and again by whoever takes long; what it raises ends the work."""
Replanner = Callable[[State, Formula, Heed], Policy | NotPlanned]
"""Finds a policy from a state (static atoms included) to a goal, or says why there is none."""
Requests = Callable[[], Observation | None]
"""What people, or another process, ask for meanwhile: one request at a time, never waiting."""


Stale = Callable[[], State]
"""The atoms that were seen too long ago to rest a decision on."""


@dataclass(frozen=True, slots=True)
class Patience:
    """How long the task manager waits, in seconds of a clock.

    news:      for the robot, before requests are looked at again
    action:    for an action to end before it is given up; None is for ever
    given_up:  for an action that was given up to end
    lost:      for a robot that cannot be reached
    clock, sleep: what the seconds are measured by; simulated time is the simulator's own
    """

    news: Seconds = 0.2
    action: Callable[[GroundAction], Seconds | None] = lambda _: None
    given_up: Seconds = 10.0
    lost: Seconds = 60.0
    clock: Callable[[], Seconds] = time.monotonic
    sleep: Callable[[Seconds], None] = time.sleep


def run_mission(
    start: Advance,
    robot: Robot,
    record: Record,
    plan: Replanner,
    *,
    requests: Requests = lambda: None,
    patience: Patience | None = None,
    stale: Stale = frozenset,
) -> Generator[Entry, None, Mission]:
    """Carry a mission out, giving each entry of its log once it is stored.

    start: from `accept`, or from `advance(mission_from(entries), ResumeAsked(...))`
    returns the mission when it is over, or paused with nothing under way

    Ctrl-C pauses: the action under way comes to its end and no other is started; a second one
    leaves at once. Whoever stops taking entries pauses the mission too. Either is in the log.
    """
    edge = _Edge(robot, plan, requests, patience or Patience())
    now = start
    while True:
        entries = record(now.mission.instant, now.events) if now.events else ()
        try:
            yield from entries
        except GeneratorExit:
            left = advance(now.mission, PauseAsked("closed"))
            if left.events:
                record(left.mission.instant, left.events)
            raise
        if now.mission.is_at_rest:
            edge.rest(now.mission)
            return now.mission
        now = advance(now.mission, edge.observed(now), stale())


@runtime_checkable
class _Believer(Protocol):
    """A robot that cannot see all that is so, and can be told."""

    def believe(self, added: Iterable[GroundAtom], deleted: Iterable[GroundAtom]) -> None: ...


def heeding(robot: Robot, record: Record) -> Record:
    """Have a robot that only believes what the world is like believe what the log says, too.

    That is what people report, and what follows from facts that were looked at.
    """

    def heeded(instant: Instant, events: Sequence[Event]) -> Sequence[Entry]:
        entries = record(instant, events)
        for event in events:
            if isinstance(event, ReportReceived | ObservationMade) and isinstance(robot, _Believer):
                robot.believe(event.added, event.deleted)
        return entries

    return heeded


class _Interrupted(Exception):
    """Somebody asks for something while a policy is being looked for."""

    def __init__(self, request: Observation) -> None:
        super().__init__()
        self.request = request


class _Edge:
    """Where a mission meets its robot, its planner and the people who ask."""

    def __init__(
        self,
        robot: Robot,
        plan: Replanner,
        requests: Requests,
        patience: Patience,
    ) -> None:
        self._robot = robot
        self._plan = plan
        self._requests = requests
        self._patience = patience
        self._clock = patience.clock
        self._lost_since = self._clock()
        self._timed: dict[GoalId, _Timed] = {}
        self._look: Sense | None = None

    def rest(self, mission: Mission) -> None:
        """Nothing more is waited for; a mission that goes on later asks again for a look."""
        if mission.is_over:
            self._look_at(None)

    def observed(self, now: Advance) -> Observation:
        """Obey the commands, and wait for the next thing that is worth deciding on."""
        mission = now.mission
        self._look_at(next((each for each in now.commands if isinstance(each, Sense)), None))
        try:
            # A request is decided on as soon as it is taken; while an action is under way, that
            # is after the robot has the command.
            request = None if mission.under_way else self._requests()
            answer = request or self._reached(partial(self._obeyed, now))
            while answer is None:
                request = self._requests()
                if request is not None:
                    return request
                answer = self._waited(mission)
        except KeyboardInterrupt:
            if mission.paused_by is not None:
                raise
            return PauseAsked("keyboard")
        return answer

    def _waited(self, mission: Mission) -> Observation | None:
        """Wait a moment for what the mission waits for."""
        goals, look = mission.under_way, self._look
        if mission.lost is not None:
            return self._reconnected()
        if look is not None:
            seen = self._glanced(look, 0.0 if goals else self._patience.news)
            if seen is not None or not goals:
                return seen
        if not goals:
            raise AssertionError("a mission that waits for nothing is at rest")
        return self._reached(partial(self._news_of_one, goals))

    def _glanced(self, look: Sense, timeout: Seconds) -> Observation | None:
        """What was told of single facts; None while somebody is still asked."""
        if not isinstance(self._robot, Senser):
            return FactsTold(tuple(Telling(atom, None, "nobody") for atom in look.atoms))
        told = self._robot.sense(look.look, look.atoms, timeout)
        return None if told is None else FactsTold(told)

    def _look_at(self, look: Sense | None) -> None:
        """Look at other facts from now on, or at none."""
        before, self._look = self._look, look
        if before is None or (look is not None and look.look == before.look):
            return
        if isinstance(self._robot, Senser):
            self._robot.dismiss(before.look)

    def _reached(self, ask: Callable[[], Observation | None]) -> Observation | None:
        try:
            return ask()
        except Unreachable as error:
            self._lost_since = self._clock()
            return Lost(str(error))

    def _reconnected(self) -> Observation | None:
        """Whether the robot can be reached again; None where it cannot, and is waited for."""
        try:
            self._robot.state()
        except Unreachable as error:
            if self._clock() - self._lost_since > self._patience.lost:
                return Lost(str(error), for_good=True)
            self._patience.sleep(self._patience.news)
            return None
        self._timed.clear()  # what goes on is timed anew
        return Found()

    def _obeyed(self, now: Advance) -> Observation | None:
        """Carry the commands out; the answer of those that have one at once."""
        for command in now.commands:
            match command:
                case Send(goal_id, action):
                    self._clocked(goal_id)
                    self._robot.send(goal_id, action)
                case Attach(goal_id):
                    self._clocked(goal_id)  # waiting for it is asking about it
                case CancelAction(goal_id):
                    timed = self._clocked(goal_id)
                    timed.given_up = self._clock() if timed.given_up is None else timed.given_up
                    self._robot.cancel(goal_id)
                case Look():
                    return Sensed("robot", self._robot.state())
                case Sense() | Reconnect():
                    pass  # what is told is waited for; asking for its state is trying
                case Plan(state, remaining):
                    return self._planned(state, remaining)
                case _:
                    assert_never(command)
        return None

    def _planned(self, state: State, remaining: Formula) -> Observation:
        """What the planner finds, or the request that came before it was done.

        After a request the mission decides anew whether it still wants a policy, and from where.
        """
        try:
            policy = self._plan(state, remaining, self._heed)
        except _Interrupted as interrupted:
            return interrupted.request
        return policy if isinstance(policy, NotPlanned) else Planned(policy)

    def _heed(self) -> None:
        request = self._requests()
        if request is not None:
            raise _Interrupted(request)

    def _clocked(self, goal: GoalId) -> _Timed:
        """The seconds of an action, counted from here on where it is new."""
        return self._timed.setdefault(goal, _Timed(self._clock()))

    def _news_of_one(self, goals: Sequence[ActionInFlight]) -> Observation | None:
        """What the robots say of the actions under way, each asked in turn."""
        for goal in goals:
            answer = self._news(goal, self._patience.news / len(goals))
            if answer is not None:
                return answer
        return None

    def _news(self, goal: ActionInFlight, patience: Seconds) -> Observation | None:
        """What the robot says of an action; None while it is at it."""
        status = self._robot.wait(goal.goal_id, patience)
        timed = self._clocked(goal.goal_id)
        if isinstance(status, Succeeded | Failed):
            del self._timed[goal.goal_id]
        match status:
            case UnderWay(progress, doing):
                if doing != timed.doing:
                    timed.doing = doing
                    return Progressed(goal.goal_id, progress, doing)
                return self._late(goal, timed)
            case Succeeded(state):
                seen = self._robot.state()
                return ActionDone(goal.goal_id, seen, state if state != seen else None)
            case Failed(reason, _):
                return ActionNotDone(goal.goal_id, reason, self._robot.state())
            case Unheard():
                return NeverHeard(goal.goal_id)
            case _:
                assert_never(status)

    def _late(self, goal: ActionInFlight, timed: _Timed) -> Observation | None:
        """Whether an action takes longer than it may, to end or to be given up."""
        now = self._clock()
        if timed.given_up is not None:
            late = now - timed.given_up
            return Stuck(goal.goal_id, late) if late > self._patience.given_up else None
        limit = self._patience.action(goal.action)
        if limit is None or now - timed.since <= limit:
            return None
        return Overdue(goal.goal_id, now - timed.since)


@dataclass(slots=True)
class _Timed:
    """When an action began here, when it was given up, and what it was at last."""

    since: Seconds
    given_up: Seconds | None = None
    doing: str | None = None
