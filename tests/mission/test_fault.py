from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.mission.small_vineyard import PROBLEM, accepted, policy_for, replanned

from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.facts import facts_after
from plainspoken.logic.formula import atoms
from plainspoken.logic.syntax import parse
from plainspoken.logic.trace import holds
from plainspoken.mission.executive import accept
from plainspoken.mission.fault import Fault, FaultKind, FaultyRobot, fault_from
from plainspoken.mission.mission import Limits, Mission, mission_from
from plainspoken.mission.robot import Succeeded, Unreachable
from plainspoken.mission.run import Patience, run_mission
from plainspoken.mission.simulator import Simulator
from plainspoken.world.event import ActionFinished, Entry, Event, MissionEnded
from plainspoken.world.symbol import resolve_all

GOAL = parse("F(cleared_l0 & F robot_at_rob_wh) & G(full_b -> F !full_b)")
POLICY = policy_for(GOAL)
PATIENCE = Patience(action=lambda _: 60.0, lost=90.0)
GO = "move rob wh l0"


def robot_with(*faults: Fault, seed: int = 0) -> FaultyRobot:
    return FaultyRobot(PROBLEM, Simulator(PROBLEM, seed=seed), faults, seed=seed)


def ran(robot: FaultyRobot) -> tuple[Mission, list[Entry]]:
    entries: list[Entry] = []

    def record(instant: int, events: Sequence[Event]) -> list[Entry]:
        new = [Entry(len(entries) + n, "t", instant, event) for n, event in enumerate(events)]
        entries.extend(new)
        return new

    start = accept(accepted(GOAL), POLICY, Limits(revisits=50))
    patience = replace(PATIENCE, clock=lambda: robot.elapsed, sleep=robot.sleep)
    run = run_mission(start, robot, record, replanned, patience=patience)
    ended: list[Mission] = []

    def to_the_end() -> Iterator[Entry]:
        ended.append((yield from run))

    assert list(to_the_end()) == entries
    return ended[0], entries


def kinds(entries: Sequence[Entry]) -> set[str]:
    return {entry.kind for entry in entries}


@given(
    st.lists(st.builds(Fault, st.sampled_from(FaultKind), st.floats(0, 1)), max_size=4),
    st.integers(0, 2**32),
)
def test_whatever_goes_wrong_a_mission_ends_with_a_true_verdict_and_a_reason(
    faults: list[Fault], seed: int
) -> None:
    mission, entries = ran(robot_with(*faults, seed=seed))
    ended = entries[-1].event
    assert isinstance(ended, MissionEnded)
    letters = facts_after(entries).letters(resolve_all(atoms(GOAL), PROBLEM))
    assert ended.satisfied == holds(GOAL, letters)
    assert ended.outcome == "finished" or ended.reason
    assert mission_from(entries, mission.limits) == mission


def test_an_action_that_always_fails_stops_the_mission_after_a_few_tries() -> None:
    mission, entries = ran(robot_with(Fault(FaultKind.FAILING, 1.0)))
    assert [entry.kind for entry in entries].count("action_failed") == 4
    assert mission.ended is not None
    assert mission.ended.reason == f"the robot failed 4 times in a row, last at {GO}"


@pytest.mark.parametrize("seed", range(8))
def test_an_action_that_hangs_is_given_up_and_never_passed_over_while_under_way(seed: int) -> None:
    mission, entries = ran(robot_with(Fault(FaultKind.HANGING, 1.0), seed=seed))
    assert "action_overdue" in kinds(entries)
    assert mission.ended is not None
    assert mission.ended.reason is not None
    for one, other in pairwise(entries):
        assert not one.kind == other.kind == "action_started"


def test_what_a_robot_claims_is_not_believed_against_what_is_seen() -> None:
    mission, entries = ran(robot_with(Fault(FaultKind.LYING, 1.0), seed=3))
    lies = [e.event for e in entries if isinstance(e.event, ActionFinished) and e.event.misreported]
    assert lies
    assert mission.satisfied


def test_a_robot_that_comes_back_is_asked_what_became_of_its_action() -> None:
    robot = robot_with(Fault(FaultKind.LOST, 1.0))
    robot.send("m/1", GO)
    with pytest.raises(Unreachable):
        robot.state()
    robot.sleep(200.0)
    assert isinstance(robot.wait("m/1", 1.0), Succeeded)


def test_a_robot_that_stays_away_stops_the_mission() -> None:
    missions = [ran(robot_with(Fault(FaultKind.LOST, 1.0), seed=seed)) for seed in range(8)]
    reasons = {mission.ended.reason for mission, _ in missions if mission.ended}
    assert "the robot cannot be reached: no answer from the robot" in reasons
    assert any({"robot_lost", "robot_found"} <= kinds(entries) for _, entries in missions)


@pytest.mark.parametrize(
    ("text", "fault"),
    [("hanging", Fault(FaultKind.HANGING)), ("Person:0.5", Fault(FaultKind.PERSON, 0.5))],
)
def test_a_fault_is_read_with_its_chance(text: str, fault: Fault) -> None:
    assert fault_from(text) == fault


@pytest.mark.parametrize("text", ["", "sulking", "hanging:often", "hanging:2", "hanging:nan"])
def test_what_is_no_fault_is_refused(text: str) -> None:
    with pytest.raises(PlainspokenError):
        fault_from(text)
