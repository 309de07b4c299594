from pathlib import Path

import pytest
from tests.mission.small_vineyard import PROBLEM
from tests.work.workshop import queue_up

from plainspoken.knowledge.queue import LEASE
from plainspoken.knowledge.store import Store
from plainspoken.mission.robot import Succeeded, UnderWay, Unheard
from plainspoken.mission.simulator import Simulator
from plainspoken.work.fenced import FencedRobot
from plainspoken.work.shift import Held, LetGo, Shift, utc_now

GO = "move rob wh l0"


def held(store: Store, silence: float) -> Held:
    return Held(store, "w", "m", utc_now, lambda: silence)


def test_a_process_that_was_heard_of_in_time_may_command(store: Store) -> None:
    robot = Simulator(PROBLEM)
    FencedRobot(robot, held(store, LEASE / 2)).send("m/1", GO)
    assert robot.wait("m/1", 0.0) != Unheard()


def test_a_process_that_slept_longer_than_its_lease_commands_nothing(store: Store) -> None:
    robot = Simulator(PROBLEM)
    fenced = FencedRobot(robot, held(store, LEASE))
    with pytest.raises(LetGo):
        fenced.send("m/1", GO)
    assert robot.wait("m/1", 0.0) == Unheard()
    robot.send("m/1", GO)
    with pytest.raises(LetGo):
        fenced.cancel("m/1")
    assert fenced.state() == robot.state()


def test_a_process_that_slept_longer_than_its_lease_does_not_wait_on_its_robot_either(
    store: Store,
) -> None:
    robot = Simulator(PROBLEM)
    robot.send("m/1", GO)
    assert FencedRobot(robot, held(store, LEASE)).wait("m/1", 0.01) == UnderWay()
    assert isinstance(FencedRobot(robot, held(store, 0.0)).wait("m/1", 0.01), Succeeded)


def test_what_was_let_go_of_is_not_commanded_any_more(store: Store, tmp_path: Path) -> None:
    queue_up(store, "m", tmp_path / "world")
    with Shift(store) as shift:
        mine = shift.take("m")
        assert mine is not None
        mine.check()
        mine.let_go()
        with pytest.raises(LetGo):
            mine.check()
