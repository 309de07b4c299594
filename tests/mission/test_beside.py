"""Robots at work at once: it comes to what one after the other does, whoever ends first."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.mission.two_robots import APART, GOALS, PROBLEM, SITE, Recorder, accepted, policy_for

from plainspoken.knowledge.facts import facts_after
from plainspoken.logic.formula import atoms
from plainspoken.logic.syntax import parse
from plainspoken.logic.trace import holds
from plainspoken.mission.command import Attach, CancelAction, Send
from plainspoken.mission.executive import Advance, accept, advance
from plainspoken.mission.fault import Fault, FaultKind, FaultyRobot
from plainspoken.mission.footprint import footprints_of
from plainspoken.mission.mission import Limits, Mission, Status, mission_from
from plainspoken.mission.observation import (
    ActionDone,
    ActionNotDone,
    CancelAsked,
    NeverHeard,
    PauseAsked,
    ResumeAsked,
    TakeUpAsked,
)
from plainspoken.mission.robot import GoalStatus, Seconds, Succeeded, UnderWay
from plainspoken.mission.run import Patience, run_mission
from plainspoken.mission.simulator import Simulator
from plainspoken.pipeline import replanner
from plainspoken.world.domain import GroundAction, State
from plainspoken.world.event import (
    ActionFailed,
    ActionFinished,
    ActionStarted,
    Entry,
    MissionEnded,
    PolicyChosen,
)
from plainspoken.world.scene import applicable_actions, successors
from plainspoken.world.symbol import resolve_all

ROBOTS = {"cart", "fork"}


class Shuffled(Simulator):
    """Robots whose actions end in whatever order is drawn, one or both between two looks."""

    def __init__(self, seed: int, data: st.DataObject) -> None:
        super().__init__(PROBLEM, seed=seed)
        self._data = data
        self._waiting: dict[str, GroundAction] = {}
        self._ended: dict[str, GoalStatus] = {}

    def send(self, goal_id: str, action: GroundAction) -> None:
        assert goal_id not in self._waiting | self._ended
        robot = action.split()[1]
        assert robot not in {other.split()[1] for other in self._waiting.values()}
        self._waiting[goal_id] = action

    def wait(self, goal_id: str, timeout: Seconds) -> GoalStatus:
        if goal_id in self._ended:
            return self._ended[goal_id]
        goals = sorted(self._waiting)
        for goal in self._data.draw(st.permutations(goals))[: self._data.draw(st.integers(1, 2))]:
            self._carry_out(goal)
        return self._ended.get(goal_id, UnderWay())

    def _carry_out(self, goal_id: str) -> None:
        outcomes = successors(PROBLEM, self.state(), self._waiting.pop(goal_id))
        then = self._data.draw(st.sampled_from(outcomes))
        now = self.state()
        self.disturb(added=then - now, deleted=now - then)
        self._ended[goal_id] = Succeeded(then)


def ran(goal: str, robot: Simulator | FaultyRobot, **waits: object) -> tuple[Mission, list[Entry]]:
    record = Recorder()
    start = accept(accepted(goal), policy_for(goal), Limits(revisits=40))
    patience = replace(Patience(), **waits)
    run = run_mission(start, robot, record, replanner(SITE), patience=patience)
    while True:
        try:
            next(run)
        except StopIteration as end:
            mission = end.value
            assert isinstance(mission, Mission)
            return mission, record.entries


def check(goal: str, entries: Sequence[Entry]) -> None:
    """The log's verdict is that of the semantics, and no robot has two commands at once."""
    facts = facts_after(entries)
    ended = entries[-1].event
    assert isinstance(ended, MissionEnded)
    trace = facts.letters(resolve_all(atoms(parse(goal)), PROBLEM))
    assert ended.satisfied == holds(parse(goal), trace)
    under_way: dict[str, set[str]] = {}
    for entry in entries:
        match entry.event:
            case ActionStarted(action, _, goal_id):
                robots = ROBOTS.intersection(action.split())
                assert not any(robots & others for others in under_way.values())
                under_way[goal_id] = robots
            case ActionFinished(goal_id=goal_id) | ActionFailed(goal_id=goal_id):
                del under_way[goal_id]
            case _:
                pass
    given_up = ("did not come to an end", "cannot be reached", "the robot forgot")
    assert not under_way or any(why in (ended.reason or "") for why in given_up)


def check_every_step(entries: Sequence[Entry]) -> None:
    """Each instant is what the domain says the action before it may lead to."""
    facts = facts_after(entries)
    for before, now in pairwise(facts.trace):
        assert now.action is not None
        possible = successors(PROBLEM, before.state | facts.static, now.action)
        assert now.state | facts.static in possible


@given(st.sampled_from(GOALS), st.data())
@settings(max_examples=50)
def test_in_whatever_order_the_robots_end_the_trace_is_one_of_the_domain_and_meets_the_request(
    goal: str, data: st.DataObject
) -> None:
    mission, entries = ran(goal, Shuffled(0, data))
    check(goal, entries)
    check_every_step(entries)
    kinds = [entry.kind for entry in entries]
    assert "deviation_noticed" not in kinds
    if mission.status is not Status.FINISHED:  # the draws may be unlucky for ever
        assert mission.ended is not None
        assert (mission.ended.reason or "").startswith("no luck with")
    assert mission_from(entries, mission.limits) == mission


@given(
    st.sampled_from(GOALS),
    st.lists(st.builds(Fault, st.sampled_from(FaultKind), st.floats(0, 0.5)), max_size=3),
    st.integers(0, 2**32),
)
@settings(max_examples=25)
def test_whatever_goes_wrong_side_by_side_the_verdict_is_that_of_the_semantics(
    goal: str, faults: list[Fault], seed: int
) -> None:
    robot = FaultyRobot(PROBLEM, Simulator(PROBLEM, seed=seed), tuple(faults), seed=seed)
    mission, entries = ran(
        goal, robot, action=lambda _: 60.0, lost=100.0, clock=lambda: robot.elapsed,
        sleep=robot.sleep,
    )  # fmt: skip
    check(goal, entries)
    assert mission_from(entries, mission.limits) == mission
    assert mission.status is Status.FINISHED or (mission.ended is not None and mission.ended.reason)


def overlaps(goal: str, seed: int = 0) -> bool:
    _, entries = ran(goal, Simulator(PROBLEM, seed=seed))
    under_way = 0
    for entry in entries:
        under_way += isinstance(entry.event, ActionStarted)
        under_way -= isinstance(entry.event, ActionFinished)
        if under_way == 2:
            return True
    return False


@pytest.mark.parametrize(
    ("goal", "at_once"),
    [
        (APART, True),
        ("F delivered_crate & F delivered_drum", True),
        # The order is asked for.
        (GOALS[3], False),
        # The one has to be the very next thing after the other.
        ("F(robot_at_cart_aisle_1 & drive_executed & X robot_at_fork_aisle_2)", False),
        # Only one robot has anything to do.
        ("F robot_at_cart_desk", False),
    ],
)
def test_robots_are_at_work_at_once_only_where_the_request_does_not_care(
    goal: str, *, at_once: bool
) -> None:
    assert any(overlaps(goal, seed) for seed in range(4)) == at_once


def test_without_being_asked_for_nothing_goes_on_side_by_side() -> None:
    now = accept(accepted(APART, robot={}), policy_for(APART))
    assert [event.kind for event in now.events].count("action_started") == 1


def test_two_ways_take_as_long_as_the_longer_one() -> None:
    lasts = {"drive": (10.0, 10.0)}
    spent = []
    for robot in ({}, {"side_by_side": True}):
        simulator = Simulator(PROBLEM, durations=lasts)
        start = accept(accepted(APART, robot=robot), policy_for(APART))
        for _ in run_mission(start, simulator, Recorder(), replanner(SITE)):
            pass
        spent.append(simulator.elapsed)
    assert spent == [30.0, 20.0]


# -- step by step ------------------------------------------------------------------------------


def both() -> Advance:
    """The first actions of two robots, under way."""
    now = accept(accepted(APART), policy_for(APART))
    first, second = (each for each in now.commands if isinstance(each, Send))
    assert {first.action.split()[1], second.action.split()[1]} == ROBOTS
    return now


def done(now: Advance, action: GroundAction) -> State:
    return successors(PROBLEM, now.mission.world, action)[0]


def test_one_that_ends_before_its_turn_has_the_policy_rearranged_not_the_mission_astray() -> None:
    now = both()
    goal = now.mission.beside
    assert goal is not None
    later = advance(now.mission, ActionDone(goal.goal_id, done(now, goal.action)))
    kinds = [event.kind for event in later.events]
    assert kinds[:2] == ["action_finished", "policy_chosen"]
    assert "deviation_noticed" not in kinds
    chosen = later.events[1]
    assert isinstance(chosen, PolicyChosen)
    assert chosen.repeats
    assert later.mission.replans == 0
    assert later.mission.in_flight is not None
    assert later.mission.in_flight.goal_id == now.mission.in_flight.goal_id


def test_what_another_robot_may_be_changing_is_believed_when_its_action_ends() -> None:
    now = both()
    first, second = now.mission.under_way
    seen = successors(PROBLEM, done(now, first.action), second.action)[0]
    now = advance(now.mission, ActionDone(first.goal_id, seen))
    assert now.mission.world == done(both(), first.action)
    now = advance(now.mission, ActionDone(second.goal_id, seen))
    assert now.mission.world == seen
    assert now.mission.instant == 2


def test_a_pause_has_both_actions_come_to_their_end() -> None:
    now = advance(both().mission, PauseAsked("ada"))
    for goal in now.mission.under_way:
        assert not now.mission.is_at_rest
        now = advance(now.mission, ActionDone(goal.goal_id, done(now, goal.action)))
        assert not now.commands
    assert now.mission.is_at_rest
    resumed = advance(now.mission, ResumeAsked("ada"))
    assert resumed.mission.looking


def test_a_cancellation_has_both_actions_given_up() -> None:
    now = advance(both().mission, CancelAsked("ada"))
    assert [type(command) for command in now.commands] == [CancelAction, CancelAction]
    for goal in now.mission.under_way:
        assert not now.mission.is_over
        now = advance(now.mission, ActionNotDone(goal.goal_id, "cancelled", now.mission.world))
    assert now.mission.status is Status.CANCELLED


def test_who_takes_over_asks_about_both_and_sends_again_only_what_was_never_heard() -> None:
    first, second = both().mission.under_way
    now = advance(both().mission, TakeUpAsked("another"))
    assert now.commands == (Attach(first.goal_id), Attach(second.goal_id))
    now = advance(now.mission, NeverHeard(second.goal_id))
    assert now.commands == (Send(second.goal_id, second.action),)


def test_an_early_action_that_fails_is_tried_again_and_not_more_often_than_others() -> None:
    now = both()
    for _ in range(3 + Limits().failures):
        beside = now.mission.beside
        if beside is None:
            break
        failed = ActionNotDone(beside.goal_id, "a wheel is stuck", now.mission.world)
        now = advance(now.mission, failed)
        assert now.mission.in_flight is not None
    assert now.mission.beside is None  # it waits for the next action of the policy
    goal = now.mission.in_flight
    assert goal is not None
    now = advance(now.mission, ActionDone(goal.goal_id, done(now, goal.action)))
    assert len(now.mission.under_way) >= 1


def test_a_robot_that_fails_again_and_again_is_given_up_once_the_other_is_done() -> None:
    now = both()
    second = now.mission.beside
    assert second is not None
    for _ in range(Limits().failures + 1):
        goal = now.mission.in_flight
        assert goal is not None
        failed = ActionNotDone(goal.goal_id, "a wheel is stuck", now.mission.world)
        now = advance(now.mission, failed)
    assert now.mission.under_way == (second,)
    assert not now.mission.is_over
    now = advance(now.mission, ActionDone(second.goal_id, done(now, second.action)))
    ended = now.events[-1]
    assert isinstance(ended, MissionEnded)
    assert (ended.reason or "").startswith("the robot failed 4 times in a row")


# -- footprints --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("one", "other", "disturbed"),
    [
        ("drive cart bay aisle-1", "drive fork aisle-1 aisle-2", False),
        ("drive cart bay aisle-1", "drive cart aisle-1 aisle-2", True),
        ("drive cart bay aisle-1", "load-parcel cart crate aisle-1", True),
        ("lower-parcel fork crate aisle-1", "load-parcel cart crate aisle-1", True),
        ("lower-parcel fork crate aisle-1", "load-parcel cart drum aisle-2", False),
        ("scan-parcel cart crate", "call-worker fork crate aisle-1", False),
    ],
)
def test_which_actions_get_in_each_others_way(one: str, other: str, *, disturbed: bool) -> None:
    footprints = footprints_of(PROBLEM)
    assert footprints.of(one).disturbs(footprints.of(other)) == disturbed
    assert footprints.of(other).disturbs(footprints.of(one)) == disturbed


@given(st.data())
def test_actions_that_do_not_disturb_each_other_lead_to_the_same_states_in_either_order(
    data: st.DataObject,
) -> None:
    state = PROBLEM.initial
    for _ in range(data.draw(st.integers(0, 12))):
        action = data.draw(st.sampled_from(sorted(applicable_actions(PROBLEM, state))))
        state = data.draw(st.sampled_from(successors(PROBLEM, state, action)))
    actions = sorted(applicable_actions(PROBLEM, state))
    one, other = data.draw(st.sampled_from(actions)), data.draw(st.sampled_from(actions))
    footprints = footprints_of(PROBLEM)
    if footprints.of(one).disturbs(footprints.of(other)):
        return
    forth = {t for s in successors(PROBLEM, state, one) for t in successors(PROBLEM, s, other)}
    back = {t for s in successors(PROBLEM, state, other) for t in successors(PROBLEM, s, one)}
    assert forth == back
