"""The simulated robots pass the suite that every adapter passes."""

import math

import pytest
from tests.mission.conformance import RobotConformance
from tests.mission.small_vineyard import PROBLEM

from plainspoken.mission.fault import FaultyRobot
from plainspoken.mission.robot import Robot, Seconds
from plainspoken.mission.simulator import Simulator
from plainspoken.world.domain import GroundAction


class CountingSimulator(Simulator):
    """Counts the actions that it begins."""

    begun = 0

    def send(self, goal_id: str, action: GroundAction) -> None:
        known = self._goals.keys()
        self.begun += goal_id not in known
        super().send(goal_id, action)


class SimulatorBench:
    """A simulator outlives the processes that drive it: each sees the same one."""

    problem = PROBLEM
    action = "move rob wh l0"
    rejected = "move rob l0 wh"

    def __init__(self) -> None:
        def sleep(seconds: Seconds) -> None:
            assert seconds >= 0

        self._far = CountingSimulator(PROBLEM, pace=0.05, sleep=sleep)
        self._near = FaultyRobot(PROBLEM, self._far, ())

    def robot(self) -> Robot:
        return self._near

    def begun(self) -> int:
        return self._far.begun

    def lose(self) -> None:
        self._near.lose(math.inf)

    def restore(self) -> None:
        self._near.lose(0.0)


class TestSimulator(RobotConformance):
    @pytest.fixture
    def bench(self) -> SimulatorBench:
        return SimulatorBench()
