from pathlib import Path

import pytest
from tests.mission.small_vineyard import PROBLEM

from plainspoken.errors import InputFileError
from plainspoken.mission.kept_simulator import KeptSimulator
from plainspoken.mission.robot import Failed, Succeeded, UnderWay, Unheard
from plainspoken.mission.simulator import Simulator

GO = "move rob wh l0"
BACK = "move rob l0 wh"


class Clock:
    """Time that passes when somebody waits."""

    def __init__(self) -> None:
        self.now = 1000.0

    def __call__(self) -> float:
        return self.now

    def sleep(self, seconds: float) -> None:
        self.now += seconds


CLOCK = Clock()


def robot(path: Path, clock: Clock = CLOCK, world: str = "w", seed: int = 0) -> KeptSimulator:
    return KeptSimulator(path, world, PROBLEM, seed=seed, pace=1.0, clock=clock, sleep=clock.sleep)


def test_what_it_was_told_ends_at_its_own_time_whoever_asks(tmp_path: Path) -> None:
    path, clock = tmp_path / "world", Clock()
    robot(path, clock).send("m/1", GO)
    again = robot(path, clock)
    status = again.wait("m/1", 1.0)
    assert isinstance(status, UnderWay)
    assert "robot-at rob wh" in again.state()
    clock.sleep(60.0)
    assert "robot-at rob l0" in robot(path, clock).state(), "though nobody waited for it"
    assert robot(path, clock).wait("m/1", 1.0) == Succeeded(again.state())


def test_a_goal_id_that_was_heard_is_not_carried_out_again_but_counted(tmp_path: Path) -> None:
    path, clock = tmp_path / "world", Clock()
    robot(path, clock).send("m/1", GO)
    clock.sleep(60.0)
    robot(path, clock).send("m/1", GO)
    (deed,) = robot(path, clock).deeds()
    assert (deed.goal_id, deed.action, deed.status, deed.repeats) == ("m/1", GO, "done", 1)


def test_it_does_what_the_simulator_in_memory_does(tmp_path: Path) -> None:
    for seed in range(5):
        plain, clock = Simulator(PROBLEM, seed=seed), Clock()
        for number, action in enumerate([GO, "check-grape rob g0 l0", BACK, GO]):
            plain.send(f"m/{number}", action)
            expected = plain.wait(f"m/{number}", 1.0)
            kept = robot(tmp_path / f"{seed}", clock, seed=seed)
            kept.send(f"m/{number}", action)
            assert kept.wait(f"m/{number}", 60.0) == expected
            assert kept.state() == plain.state()


def test_a_cancelled_action_changes_nothing(tmp_path: Path) -> None:
    path, clock = tmp_path / "world", Clock()
    one = robot(path, clock)
    before = one.state()
    one.send("m/1", GO)
    one.cancel("m/1")
    clock.sleep(60.0)
    assert one.wait("m/1", 1.0) == Failed("cancelled", before)
    one.cancel("m/1")
    assert one.state() == before


def test_an_action_that_is_not_possible_fails_and_one_that_was_never_sent_is_unheard(
    tmp_path: Path,
) -> None:
    one = robot(tmp_path / "world")
    one.send("m/1", BACK)
    assert isinstance(one.wait("m/1", 60.0), Failed)
    assert one.wait("m/2", 0.0) == Unheard()


def test_worlds_in_one_file_do_not_touch_each_other(tmp_path: Path) -> None:
    one, other = robot(tmp_path / "w", world="a"), robot(tmp_path / "w", world="b")
    one.send("a/1", GO)
    assert isinstance(one.wait("a/1", 60.0), Succeeded)
    assert other.state() == PROBLEM.initial
    assert other.deeds() == ()


def test_a_file_that_is_no_world_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "notes.txt"
    path.write_text("these are notes, and no world at all" * 10)
    with pytest.raises(InputFileError, match="world"):
        robot(path)
