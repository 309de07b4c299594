"""The loop at the edge: stores what was decided, obeys, observes, and decides again."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from typing import assert_never

from plainspoken.logic.formula import Formula
from plainspoken.mission.command import Attach, CancelAction, Look, Plan, Send
from plainspoken.mission.executive import Advance, advance
from plainspoken.mission.mission import ActionInFlight, Mission
from plainspoken.mission.observation import (
    ActionDone,
    ActionNotDone,
    NeverHeard,
    NotPlanned,
    Observation,
    PauseAsked,
    Planned,
    Sensed,
)
from plainspoken.mission.robot import Failed, Robot, Seconds, Succeeded, UnderWay, Unheard
from plainspoken.planning.policy import Policy
from plainspoken.world.domain import State
from plainspoken.world.event import Entry, Event, Instant

Record = Callable[[Instant, Sequence[Event]], Sequence[Entry]]
"""Stores events, all or none, before it returns."""
Replanner = Callable[[State, Formula], Policy | str]
"""Finds a policy from a state (static atoms included) to a goal, or says why there is none."""
Requests = Callable[[], Observation | None]
"""What people, or another process, ask for meanwhile: one request at a time, never waiting."""


def run_mission(
    start: Advance,
    robot: Robot,
    record: Record,
    plan: Replanner,
    *,
    requests: Requests = lambda: None,
    patience: Seconds = 0.2,
) -> Generator[Entry, None, Mission]:
    """Carry a mission out, giving each entry of its log once it is stored.

    start:    from `accept`, or from `advance(mission_from(entries), ResumeAsked(...))`
    patience: how long to wait for the robot before requests are looked at again
    returns the mission when it is over, or paused with nothing under way

    Ctrl-C pauses: the action under way comes to its end and no other is started; a second one
    leaves at once. Whoever stops taking entries pauses the mission too. Either is in the log.
    """
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
        now = advance(now.mission, _observed(now, robot, plan, requests, patience))


def _observed(
    now: Advance, robot: Robot, plan: Replanner, requests: Requests, patience: Seconds
) -> Observation:
    """Obey the commands, and wait for the next thing that is worth deciding on."""
    try:
        request = requests()
        if request is not None and now.mission.in_flight is None:
            return request
        answer = _obeyed(now, robot, plan)
        while answer is None:
            # A request that came with a command waits until the robot has the command.
            if request is not None:
                return request
            if now.mission.in_flight is None:
                raise AssertionError("a mission that waits for nothing is at rest")
            answer = _news(now.mission.in_flight, robot, patience)
            request = requests() if answer is None else None
    except KeyboardInterrupt:
        if now.mission.paused_by is not None:
            raise
        return PauseAsked("keyboard")
    return answer


def _obeyed(now: Advance, robot: Robot, plan: Replanner) -> Observation | None:
    """Carry the commands out; the answer of those that have one at once."""
    for command in now.commands:
        match command:
            case Send(goal_id, action):
                robot.send(goal_id, action)
            case Attach():
                pass  # waiting for it is asking about it
            case CancelAction(goal_id):
                robot.cancel(goal_id)
            case Look():
                return Sensed("robot", robot.state())
            case Plan(state, remaining):
                policy = plan(state, remaining)
                return NotPlanned(policy) if isinstance(policy, str) else Planned(policy)
            case _:
                assert_never(command)
    return None


def _news(goal: ActionInFlight, robot: Robot, patience: Seconds) -> Observation | None:
    """What the robot says of an action; None while it is at it."""
    status = robot.wait(goal.goal_id, patience)
    match status:
        case UnderWay():
            return None
        case Succeeded(state):
            return ActionDone(goal.goal_id, state)
        case Failed(reason, state):
            return ActionNotDone(goal.goal_id, reason, state)
        case Unheard():
            return NeverHeard(goal.goal_id)
        case _:
            assert_never(status)
