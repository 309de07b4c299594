"""The loop at the edge: stores what was decided, obeys, observes, and decides again."""

from __future__ import annotations

import time
from collections.abc import Callable, Generator, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Protocol, assert_never, runtime_checkable

from plainspoken.logic.formula import Formula
from plainspoken.mission.command import Attach, CancelAction, Look, Plan, Reconnect, Send
from plainspoken.mission.executive import Advance, advance
from plainspoken.mission.mission import ActionInFlight, GoalId, Mission
from plainspoken.mission.observation import (
    ActionDone,
    ActionNotDone,
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
from plainspoken.planning.policy import Policy
from plainspoken.world.domain import GroundAction, GroundAtom, State
from plainspoken.world.event import Entry, Event, Instant, ReportReceived

Record = Callable[[Instant, Sequence[Event]], Sequence[Entry]]
"""Stores events, all or none, before it returns."""
Heed = Callable[[], None]
"""Called again and again by whoever takes long; what it raises ends the work."""
Replanner = Callable[[State, Formula, Heed], Policy | str]
"""Finds a policy from a state (static atoms included) to a goal, or says why there is none."""
Requests = Callable[[], Observation | None]
"""What people, or another process, ask for meanwhile: one request at a time, never waiting."""


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
            return now.mission
        now = advance(now.mission, edge.observed(now))


@runtime_checkable
class _Believer(Protocol):
    """A robot that cannot see all that is so, and can be told."""

    def believe(self, added: Iterable[GroundAtom], deleted: Iterable[GroundAtom]) -> None: ...


def heeding(robot: Robot, record: Record) -> Record:
    """Have a robot that only believes what the world is like believe what people report, too."""

    def heeded(instant: Instant, events: Sequence[Event]) -> Sequence[Entry]:
        entries = record(instant, events)
        for event in events:
            if isinstance(event, ReportReceived) and isinstance(robot, _Believer):
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
        self._goal: GoalId | None = None
        self._since = self._given_up_at = self._clock()
        self._doing: str | None = None
        self._given_up: GoalId | None = None

    def observed(self, now: Advance) -> Observation:
        """Obey the commands, and wait for the next thing that is worth deciding on."""
        mission = now.mission
        try:
            # A request is decided on as soon as it is taken; while an action is under way, that
            # is after the robot has the command.
            request = self._requests() if mission.in_flight is None else None
            answer = request or self._reached(partial(self._obeyed, now))
            while answer is None:
                request = self._requests()
                if request is not None:
                    return request
                goal = mission.in_flight
                if mission.lost is None and goal is None:
                    raise AssertionError("a mission that waits for nothing is at rest")
                if goal is None or mission.lost is not None:
                    answer = self._reconnected()
                else:
                    answer = self._reached(partial(self._news, goal))
        except KeyboardInterrupt:
            if mission.paused_by is not None:
                raise
            return PauseAsked("keyboard")
        return answer

    def _reached(self, ask: Callable[[], Observation | None]) -> Observation | None:
        try:
            return ask()
        except Unreachable as error:
            self._since = self._clock()
            return Lost(str(error))

    def _reconnected(self) -> Observation | None:
        """Whether the robot can be reached again; None where it cannot, and is waited for."""
        try:
            self._robot.state()
        except Unreachable as error:
            if self._clock() - self._since > self._patience.lost:
                return Lost(str(error), for_good=True)
            self._patience.sleep(self._patience.news)
            return None
        self._goal = None  # what goes on is timed anew
        return Found()

    def _obeyed(self, now: Advance) -> Observation | None:
        """Carry the commands out; the answer of those that have one at once."""
        for command in now.commands:
            match command:
                case Send(goal_id, action):
                    self._timed(goal_id)
                    self._robot.send(goal_id, action)
                case Attach(goal_id):
                    self._timed(goal_id)  # waiting for it is asking about it
                case CancelAction(goal_id):
                    if self._given_up != goal_id:
                        self._given_up, self._given_up_at = goal_id, self._clock()
                    self._robot.cancel(goal_id)
                case Look():
                    return Sensed("robot", self._robot.state())
                case Reconnect():
                    pass  # asking for its state is trying
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
        return NotPlanned(policy) if isinstance(policy, str) else Planned(policy)

    def _heed(self) -> None:
        request = self._requests()
        if request is not None:
            raise _Interrupted(request)

    def _timed(self, goal: GoalId) -> None:
        """Begin to count the seconds of an action that is new here."""
        if self._goal != goal:
            self._goal, self._doing = goal, None
            self._since = self._given_up_at = self._clock()

    def _news(self, goal: ActionInFlight) -> Observation | None:
        """What the robot says of an action; None while it is at it."""
        status = self._robot.wait(goal.goal_id, self._patience.news)
        match status:
            case UnderWay(progress, doing):
                if doing != self._doing:
                    self._doing = doing
                    return Progressed(goal.goal_id, progress, doing)
                return self._late(goal)
            case Succeeded(state):
                seen = self._robot.state()
                return ActionDone(goal.goal_id, seen, state if state != seen else None)
            case Failed(reason, _):
                return ActionNotDone(goal.goal_id, reason, self._robot.state())
            case Unheard():
                return NeverHeard(goal.goal_id)
            case _:
                assert_never(status)

    def _late(self, goal: ActionInFlight) -> Observation | None:
        """Whether an action takes longer than it may, to end or to be given up."""
        now = self._clock()
        if self._given_up == goal.goal_id:
            late = now - self._given_up_at
            return Stuck(goal.goal_id, late) if late > self._patience.given_up else None
        limit = self._patience.action(goal.action)
        if limit is None or now - self._since <= limit:
            return None
        return Overdue(goal.goal_id, now - self._since)
