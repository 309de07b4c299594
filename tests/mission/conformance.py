"""What every robot has to do, whatever is behind it: one suite, which each adapter passes.

To put a new adapter to the test, give it a `Bench` and a class in a file of its own:

    class TestMyRobot(RobotConformance):
        @pytest.fixture
        def bench(self) -> Iterator[Bench]: ...
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Protocol

import pytest

from plainspoken.mission.robot import (
    Failed,
    GoalStatus,
    Robot,
    Succeeded,
    UnderWay,
    Unheard,
    Unreachable,
)
from plainspoken.world.domain import GroundAction, Problem, State
from plainspoken.world.scene import successors

PATIENCE = 60.0


class Bench(Protocol):
    """A robot at the far end, and ways to come to it.

    action:   one that can be done at s0, takes a moment and has one outcome
    rejected: one that the robot refuses at s0
    """

    problem: Problem
    action: GroundAction
    rejected: GroundAction

    def robot(self) -> Robot:
        """The robot, as a process sees it that has just been started."""

    def begun(self) -> int:
        """How many actions the far end has begun."""

    def lose(self) -> None:
        """Have the connection break; the far end goes on."""

    def restore(self) -> None: ...


def ended(robot: Robot, goal_id: str) -> GoalStatus:
    """What became of a goal, waiting for it."""
    until = time.monotonic() + PATIENCE
    status: GoalStatus = UnderWay()
    while isinstance(status, UnderWay) and time.monotonic() < until:
        status = robot.wait(goal_id, 0.2)
    return status


def raises_unreachable(ask: Callable[[], object]) -> bool:
    """Whether it is noticed, in time, that nobody answers."""
    until = time.monotonic() + PATIENCE
    while time.monotonic() < until:
        try:
            ask()
        except Unreachable:
            return True
        time.sleep(0.02)
    return False


class RobotConformance:
    """The suite. Every test has a bench of its own."""

    @pytest.fixture
    def bench(self) -> Bench:
        raise NotImplementedError

    def expected(self, bench: Bench) -> State:
        (after,) = successors(bench.problem, bench.problem.initial, bench.action)
        return after

    def test_at_first_it_sees_the_initial_state(self, bench: Bench) -> None:
        assert changing(bench, bench.robot().state()) == changing(bench, bench.problem.initial)

    def test_an_action_comes_to_its_end_and_the_state_is_what_it_made(self, bench: Bench) -> None:
        robot = bench.robot()
        robot.send("m/1", bench.action)
        status = ended(robot, "m/1")
        assert isinstance(status, Succeeded), status
        assert changing(bench, status.state) == changing(bench, self.expected(bench))
        assert changing(bench, robot.state()) == changing(bench, status.state)

    def test_it_returns_at_once_and_waits_no_longer_than_it_may(self, bench: Bench) -> None:
        robot = bench.robot()
        before = time.monotonic()
        robot.send("m/1", bench.action)
        assert isinstance(robot.wait("m/1", 0.0), UnderWay)
        assert time.monotonic() - before < 1.0
        ended(robot, "m/1")

    def test_it_tells_of_an_action_under_way(self, bench: Bench) -> None:
        robot = bench.robot()
        robot.send("m/1", bench.action)
        told = []
        status = robot.wait("m/1", 0.05)
        while isinstance(status, UnderWay):
            told.append(status)
            status = robot.wait("m/1", 0.05)
        assert any(each.progress is not None or each.doing for each in told)
        assert all(each.progress is None or 0.0 <= each.progress <= 1.0 for each in told)

    def test_the_same_goal_id_twice_is_one_action(self, bench: Bench) -> None:
        robot = bench.robot()
        robot.send("m/1", bench.action)
        robot.send("m/1", bench.action)
        first = ended(robot, "m/1")
        robot.send("m/1", bench.action)
        assert robot.wait("m/1", 0.2) == first
        assert bench.begun() == 1

    def test_what_became_of_a_goal_can_be_asked_again(self, bench: Bench) -> None:
        robot = bench.robot()
        robot.send("m/1", bench.action)
        first = ended(robot, "m/1")
        assert [robot.wait("m/1", 0.0) for _ in range(3)] == [first] * 3

    def test_a_goal_that_was_never_sent_is_unheard(self, bench: Bench) -> None:
        robot = bench.robot()
        assert robot.wait("m/7", 0.0) == Unheard()
        robot.cancel("m/7")
        assert bench.begun() == 0

    def test_a_refusal_has_a_reason_and_changes_nothing(self, bench: Bench) -> None:
        robot = bench.robot()
        robot.send("m/1", bench.rejected)
        status = ended(robot, "m/1")
        assert isinstance(status, Failed), status
        assert status.reason
        assert changing(bench, status.state) == changing(bench, bench.problem.initial)
        robot.send("m/2", bench.action)
        assert isinstance(ended(robot, "m/2"), Succeeded), "a refusal does not block the robot"

    def test_an_action_that_is_cancelled_fails_and_changes_nothing(self, bench: Bench) -> None:
        robot = bench.robot()
        robot.send("m/1", bench.action)
        assert isinstance(robot.wait("m/1", 0.1), UnderWay)
        robot.cancel("m/1")
        robot.cancel("m/1")
        status = ended(robot, "m/1")
        assert isinstance(status, Failed), status
        assert changing(bench, status.state) == changing(bench, bench.problem.initial)

    def test_an_end_cannot_be_cancelled(self, bench: Bench) -> None:
        robot = bench.robot()
        robot.send("m/1", bench.action)
        status = ended(robot, "m/1")
        robot.cancel("m/1")
        assert robot.wait("m/1", 0.1) == status

    def test_while_nobody_answers_it_says_so_and_afterwards_it_goes_on(self, bench: Bench) -> None:
        robot = bench.robot()
        robot.send("m/1", bench.action)
        assert isinstance(robot.wait("m/1", 0.1), UnderWay)
        bench.lose()
        assert raises_unreachable(lambda: robot.wait("m/1", 0.0))
        with pytest.raises(Unreachable):
            robot.state()
        bench.restore()
        until = time.monotonic() + PATIENCE
        while time.monotonic() < until:
            try:
                robot.state()
                break
            except Unreachable:
                time.sleep(0.05)
        status = ended(robot, "m/1")
        assert isinstance(status, Succeeded), status
        assert bench.begun() == 1

    def test_a_goal_is_found_again_by_a_new_process(self, bench: Bench) -> None:
        robot = bench.robot()
        robot.send("m/1", bench.action)
        assert isinstance(robot.wait("m/1", 0.1), UnderWay)
        again = bench.robot()
        assert isinstance(again.wait("m/1", 0.0), UnderWay)
        status = ended(again, "m/1")
        assert isinstance(status, Succeeded), status
        assert changing(bench, status.state) == changing(bench, self.expected(bench))
        assert bench.begun() == 1

    def test_an_end_that_nobody_waited_for_is_known_to_a_new_process(self, bench: Bench) -> None:
        bench.robot().send("m/1", bench.action)
        ended(bench.robot(), "m/1")
        again = bench.robot()
        again.send("m/1", bench.action)
        status = ended(again, "m/1")
        assert isinstance(status, Succeeded), status
        assert changing(bench, status.state) == changing(bench, self.expected(bench))
        assert bench.begun() == 1


def changing(bench: Bench, state: State) -> State:
    """A state without what never changes, which a robot may leave out."""
    return frozenset(a for a in state if a.split()[0] in bench.problem.changing_predicates)
