"""Workers in processes of their own, killed at random moments: `benchmarks/crash.py` does more."""

import signal
import subprocess
import sys
import time
from pathlib import Path
from random import Random

from benchmarks.processes import stop
from tests.work.workshop import deeds, finished_goals, kinds, queue_up, standing

from plainspoken.knowledge.store import Store
from plainspoken.mission.mission import Status

ROUNDS = 3
ROUND_TRIPS = "".join(["F(robot_at_rob_l0 & F(robot_at_rob_wh & "] * ROUNDS)
MISSION = ROUND_TRIPS + "true" + "))" * ROUNDS
WAIT = 90.0
PACE = 0.006
"""An action takes some 50 ms: long enough to be killed in the middle of one."""


def worker(url: str) -> "subprocess.Popen[bytes]":
    command = [sys.executable, "-m", "plainspoken", "work", "--store", url, "--until-done"]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def test_a_mission_whose_worker_is_killed_again_and_again_is_finished_by_others(
    store: Store, store_url: str, tmp_path: Path
) -> None:
    queue_up(store, "m", tmp_path / "world", goal=MISSION, pace=PACE)
    chance = Random(5)
    seen = 0
    for _ in range(5):
        life = worker(store_url)
        deadline = time.monotonic() + WAIT
        wanted = seen + chance.randint(1, 3)
        while len(store.links("m")) <= wanted and life.poll() is None:
            assert time.monotonic() < deadline
            time.sleep(0.002)
        time.sleep(chance.uniform(0.0, 0.06))
        life.kill()
        life.wait()
        seen = len(store.links("m"))
    assert worker(store_url).wait(timeout=WAIT) == 0
    assert standing(store, "m").status is Status.FINISHED
    assert store.verify("m") is None
    told = deeds(tmp_path / "world", "m")
    assert [deed.goal_id for deed in told] == finished_goals(store, "m")
    assert [deed.repeats for deed in told] == [0] * 2 * ROUNDS


def test_a_worker_that_is_stopped_for_long_and_woken_does_no_harm(
    store: Store, store_url: str, tmp_path: Path
) -> None:
    queue_up(store, "m", tmp_path / "world", goal=MISSION, pace=PACE)
    sleeper = worker(store_url)
    deadline = time.monotonic() + WAIT
    while "action_started" not in kinds(store, "m"):
        assert time.monotonic() < deadline
        time.sleep(0.005)
    # One that is stopped in the middle of writing to a SQLite file keeps everybody from it.
    files = [tmp_path / "world", *([] if "://" in store_url else [Path(store_url)])]
    stop(sleeper, *files)
    try:
        other = worker(store_url)
        while kinds(store, "m").count("taken_up") < 2:
            assert time.monotonic() < deadline
            time.sleep(0.02)
    finally:
        sleeper.send_signal(signal.SIGCONT)
    assert other.wait(timeout=WAIT) == 0
    assert sleeper.wait(timeout=WAIT) == 0
    assert standing(store, "m").status is Status.FINISHED
    assert store.verify("m") is None
    told = deeds(tmp_path / "world", "m")
    assert [deed.goal_id for deed in told] == finished_goals(store, "m")
    # Stopped right between its last check and its command, it sends a goal id that is known.
    assert sum(deed.repeats for deed in told) <= 1


def test_two_workers_share_what_waits_and_one_goes_on_when_the_other_is_killed(
    store: Store, store_url: str, tmp_path: Path
) -> None:
    missions = [f"m{number}" for number in range(6)]
    for number, mission in enumerate(missions):
        queue_up(store, mission, tmp_path / f"w{number % 3}", robot=f"r{number % 3}", pace=PACE)
    first, second = worker(store_url), worker(store_url)
    deadline = time.monotonic() + WAIT
    while not any(standing(store, mission).is_over for mission in missions):
        assert time.monotonic() < deadline
        time.sleep(0.01)
    first.kill()
    first.wait()
    assert second.wait(timeout=WAIT) == 0
    for number, mission in enumerate(missions):
        assert standing(store, mission).status is Status.FINISHED
        assert store.verify(mission) is None
        told = deeds(tmp_path / f"w{number % 3}", mission)
        assert [deed.goal_id for deed in told] == finished_goals(store, mission)
        assert all(deed.repeats == 0 for deed in told)
