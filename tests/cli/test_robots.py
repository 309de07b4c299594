"""`run --robots FILE`, `answer`, `missions resume` and `doctor` with a robot behind HTTP."""

from __future__ import annotations

import io
import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path
from random import Random
from typing import Any

import click
import pytest
from tests.backends.http_bench import EXAMPLES, SERVER

from plainspoken.backends.questions import Questions
from plainspoken.cli.robots import Robots, asking_here, chosen_robot, reach, robot_in
from plainspoken.cli.simulated import Settings
from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.store import Store
from plainspoken.mission.robot import Robot
from plainspoken.mission.run import heeding
from plainspoken.pipeline import bundled, open_site
from plainspoken.world.event import Entry, ReportReceived

SEED_OF_DOUBT = 4
"""With it, the robot cannot judge the grape on line 1."""
PATIENCE = 100.0
"""Seconds, for a machine that has much else to do."""
Finished = subprocess.CompletedProcess[str]


class Far:
    """The reference server, with a robot in the bundled vineyard."""

    def __init__(self, folder: Path, seed: int, pace: float) -> None:
        site = bundled("vineyard")
        problem = open_site(site / "domain.pddl", site / "problem.pddl").problem
        self.robot: Any = SERVER.VineyardRobot(problem, seed=seed, pace=pace)
        self._server = SERVER.served(self.robot)
        threading.Thread(target=self._server.serve_forever, args=(0.01,), daemon=True).start()
        self.file = folder / "robots.yaml"
        text = (EXAMPLES / "http.yaml").read_text()
        self.file.write_text(text.replace(":8800", f":{self._server.server_port}"))

    def close(self) -> None:
        self._server.shutdown()
        self._server.server_close()


@pytest.fixture
def far(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Far]:
    monkeypatch.setenv("PLAINSPOKEN_HOME", str(tmp_path))
    with closing(Far(tmp_path, SEED_OF_DOUBT, 0.02)) as far:
        yield far


@pytest.fixture
def kept(far: Far, store_url: str, monkeypatch: pytest.MonkeyPatch) -> Far:
    """The same, with the missions in a store of each kind."""
    monkeypatch.setenv("PLAINSPOKEN_STORE", store_url)
    return far


def command(*arguments: str | Path) -> list[str | Path]:
    return [sys.executable, "-m", "plainspoken", *arguments]


def plainspoken(*arguments: str | Path) -> Finished:
    return subprocess.run(command(*arguments), capture_output=True, text=True, check=False)


def started(*arguments: str | Path) -> subprocess.Popen[str]:
    return subprocess.Popen(
        command(*arguments), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, text=True
    )


def question() -> dict[str, Any]:
    """What a mission asks, as soon as it does."""
    until = time.monotonic() + PATIENCE
    while time.monotonic() < until:
        found = json.loads(plainspoken("answer", "--json").stdout)
        if found:
            only: dict[str, Any] = found[0]
            return only
    raise AssertionError("nobody was asked anything")


def events_in(log: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in log.read_text().splitlines()]


def test_a_mission_asks_a_person_waits_and_goes_on_with_the_answer(
    kept: Far, tmp_path: Path
) -> None:
    log = tmp_path / "run.jsonl"
    run = started("run", "--goal", "F cleared_l1", "--robots", kept.file, "--log", log)
    asked = question()
    assert asked["question"] == "Is the grape g1 on l1 ripe or unripe?"
    assert plainspoken("answer", "blue").returncode == 2
    told = plainspoken("ask", "What are you doing now?", "--log", log).stdout
    assert "a person is asked: Is the grape g1 on l1 ripe or unripe?" in told
    assert plainspoken("answer", "ripe", "--by", "ada").returncode == 0
    assert run.wait(timeout=PATIENCE) == 0
    kinds = [event["kind"] for event in events_in(log)]
    assert "action_progressed" in kinds
    finished = [e["action"].split()[0] for e in events_in(log) if e["kind"] == "action_finished"]
    assert finished == [
        "move",
        "check-grape",
        "ask-human",
        "harvest-grape",
        "drop-grape",
        "sign-off",
    ]


def test_a_mission_that_was_killed_while_it_waited_is_resumed_and_nothing_is_done_twice(
    kept: Far,
) -> None:
    run = started("run", "--goal", "F cleared_l1", "--robots", kept.file)
    mission, _, _ = question()["call"].partition("/")
    run.send_signal(signal.SIGKILL)
    run.wait()
    assert plainspoken("answer", "unripe").returncode == 0, "it may be answered meanwhile"
    again = plainspoken("missions", "resume", mission, "--json")
    assert again.returncode == 0, again.stderr
    assert len(kept.robot.begun) == 3, "to go there, to look, to sign off: each of them once"
    assert json.loads(again.stdout.splitlines()[-1])["satisfied"]


def test_a_mission_that_is_killed_in_the_middle_of_an_action_finds_it_again(
    far: Far, tmp_path: Path
) -> None:
    log = tmp_path / "run.jsonl"
    run = started("run", "--goal", "F robot_at_rob_l2", "--robots", far.file, "--log", log)
    until = time.monotonic() + PATIENCE
    while not far.robot.begun and time.monotonic() < until:
        time.sleep(0.005)
    run.send_signal(signal.SIGKILL)
    run.wait()
    mission = events_in(log)[0]["mission"]
    again = plainspoken("missions", "resume", mission, "--json")
    assert again.returncode == 0, again.stderr
    moves = [call for call in far.robot.begun if ":0.0#1" in call]
    assert len(far.robot.begun) == len(set(moves)) == 2, "two moves, each begun once"


def test_a_mission_that_is_killed_again_and_again_has_its_robot_do_everything_once(
    far: Far, tmp_path: Path
) -> None:
    log = tmp_path / "run.jsonl"
    goal = "F(robot_at_rob_l2 & F(robot_at_rob_l0 & F(robot_at_rob_wh & F robot_at_rob_l2)))"
    chance = Random(5)
    run = started("run", "--goal", goal, "--robots", far.file, "--log", log)
    wait_until(lambda: log.exists() and log.read_text().count("\n") > 1)
    mission = events_in(log)[0]["mission"]
    killed = 0
    while run.poll() is None and killed < 6:
        before = len(far.robot.begun)
        wait_until(lambda b=before, r=run: len(far.robot.begun) > b or r.poll() is not None)
        time.sleep(chance.uniform(0.0, 0.2))
        run.kill()
        run.wait()
        killed += 1
        run = started("missions", "resume", mission)
    assert run.wait(timeout=PATIENCE) in (0, 2), "2 where it was over before it was resumed"
    done = tmp_path / "done.jsonl"
    assert plainspoken("missions", "log", mission, "--out", done).returncode == 0
    finished = [e["action"] for e in events_in(done) if e["kind"] == "action_finished"]
    driven = [far.robot.action(call) for call in far.robot.begun]
    assert driven == finished
    assert killed > 2
    assert events_in(done)[-1]["satisfied"]


def wait_until(is_so: Callable[[], object]) -> None:
    until = time.monotonic() + PATIENCE
    while not is_so():
        assert time.monotonic() < until
        time.sleep(0.005)


def listed() -> dict[str, dict[str, Any]]:
    found = json.loads(plainspoken("missions", "--json").stdout)
    return {one["mission"]: one for one in found}


def test_a_mission_that_is_left_to_a_worker_asks_waits_and_is_carried_out_by_it(far: Far) -> None:
    left = plainspoken("run", "--goal", "F cleared_l1", "--robots", far.file, "--detach")
    mission = left.stdout.strip()
    assert listed()[mission]["robots"] == [str(far.file)]
    assert not far.robot.begun
    worker = started("work", "--until-done")
    assert question()["call"].partition("/")[0] == mission
    assert plainspoken("answer", "unripe").returncode == 0
    assert worker.wait(timeout=PATIENCE) == 0
    assert listed()[mission]["satisfied"]
    assert len(far.robot.begun) == 3, "to go there, to look, to sign off"


def test_a_worker_goes_on_where_another_was_killed_and_nothing_is_done_twice(
    kept: Far, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    goal = "F(robot_at_rob_l2 & F(robot_at_rob_l0 & F robot_at_rob_wh))"
    left = plainspoken("run", "--goal", goal, "--robots", kept.file, "--detach")
    killed = 0
    worker = started("work", "--until-done")
    while killed < 3:
        before = len(kept.robot.begun)
        wait_until(lambda b=before, w=worker: len(kept.robot.begun) > b or w.poll() is not None)
        if worker.poll() is not None:
            break
        worker.kill()
        worker.wait()
        killed += 1
        if "://" in os.environ["PLAINSPOKEN_STORE"]:  # as on another machine: no file is shared
            monkeypatch.setenv("PLAINSPOKEN_HOME", str(tmp_path / f"machine {killed}"))
        worker = started("work", "--until-done")
    assert worker.wait(timeout=PATIENCE) == 0
    assert killed > 1
    log = tmp_path / "run.jsonl"
    assert plainspoken("missions", "log", left.stdout.strip(), "--out", log).returncode == 0
    finished = [e["action"] for e in events_in(log) if e["kind"] == "action_finished"]
    assert [kept.robot.action(call) for call in kept.robot.begun] == finished
    assert events_in(log)[-1]["satisfied"]


def test_a_mission_that_asks_is_paused_resumed_and_cancelled_from_elsewhere(far: Far) -> None:
    run = started("run", "--goal", "F cleared_l1", "--robots", far.file)
    mission = question()["call"].partition("/")[0]
    assert "under way" in plainspoken("missions", "pause", mission).stdout
    assert plainspoken("answer", "ripe").returncode == 0
    assert run.wait(timeout=PATIENCE) == 0
    assert listed()[mission]["status"] == "paused"
    resumed = plainspoken("missions", "resume", mission, "--detach")
    assert "nobody carries" in resumed.stdout
    assert plainspoken("missions", "cancel", mission).stdout == "cancelled\n"
    assert listed()[mission]["status"] == "cancelled"


def test_a_question_is_withdrawn_with_the_mission_that_asked_it(far: Far) -> None:
    run = started("run", "--goal", "F cleared_l1", "--robots", far.file)
    mission = question()["call"].partition("/")[0]
    assert "cancelled" in plainspoken("missions", "cancel", mission).stdout
    assert run.wait(timeout=PATIENCE) == 3
    assert json.loads(plainspoken("answer", "--json").stdout) == []


def test_missions_of_one_file_wait_for_each_other_unless_they_have_other_names(far: Far) -> None:
    goal = ("--goal", "F robot_at_rob_l2", "--robots", far.file)
    first = plainspoken("run", *goal, "--detach").stdout.strip()
    other = plainspoken("run", "--goal", "true", "--robots", far.file, "--robot-name", "another")
    assert other.returncode == 0, other.stderr
    with subprocess.Popen(
        command("run", *goal), stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True
    ) as second:
        assert second.stderr is not None
        assert first in second.stderr.readline()
        assert plainspoken("missions", "cancel", first).returncode == 0
        assert second.wait(timeout=PATIENCE) == 0


@pytest.mark.parametrize(
    "arguments", [("run", "--goal", "F cleared_l1", "--robots", "FILE", "--detach"), ("answer",)]
)
def test_a_store_that_cannot_be_reached_is_named_without_its_password(
    far: Far, arguments: tuple[str, ...]
) -> None:
    told = [str(far.file) if each == "FILE" else each for each in arguments]
    done = plainspoken(*told, "--store", "postgresql://farm:secret@nowhere.invalid/missions")
    assert done.returncode == 2
    assert "farm@nowhere.invalid" in done.stderr
    assert "secret" not in done.stderr


def test_a_mission_that_is_an_action_of_another_one_is_left_to_that(tmp_path: Path) -> None:
    with pytest.raises(PlainspokenError) as caught:
        robot_in({"robot": str(tmp_path / "line.yaml"), "part_of": "m"})
    assert caught.value.hint == "plainspoken missions resume m"


def test_doctor_tells_which_services_answer(far: Far) -> None:
    done = plainspoken("doctor", "--robots", far.file, "--json")
    assert done.returncode == 0
    assert json.loads(done.stdout) == {"goal": "", "person": ""}
    far.close()
    done = plainspoken("doctor", "--robots", far.file)
    assert done.returncode == 3
    assert "refused" in done.stdout


def test_a_file_that_is_wrong_stops_it_before_it_plans(far: Far) -> None:
    far.file.write_text(far.file.read_text().replace("harvest-grape:", "harvest-grapes:"))
    done = plainspoken("run", "--goal", "F cleared_l1", "--robots", far.file)
    assert done.returncode == 2
    assert "no action 'harvest-grapes'" in done.stderr
    assert "did you mean 'harvest-grape'?" in done.stderr
    line = far.file.read_text().splitlines().index("  harvest-grapes:") + 1
    assert f"robots.yaml:{line}:" in done.stderr


def test_the_robot_option_says_how_services_are_reached_that_do_not(far: Far) -> None:
    far.file.write_text(far.file.read_text().replace("    via: http\n", ""))
    assert "'via' is missing" in plainspoken("run", "--goal", "true", "--robots", far.file).stderr
    done = plainspoken(
        "run", "--goal", "F cleared_l1 | true", "--robot", "http", "--robots", far.file
    )
    assert done.returncode == 0, done.stderr


def test_without_the_extra_the_error_says_how_to_get_it(
    far: Far, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in [
        each for each in sys.modules if each.startswith("plainspoken.backends.activities")
    ]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "yaml", None)
    site = bundled("vineyard")
    vineyard = open_site(site / "domain.pddl", site / "problem.pddl")
    with pytest.raises(PlainspokenError) as caught:
        reach(far.file, vineyard)
    assert caught.value.hint == "pip install 'plainspoken[robots]'"


def test_doctor_tells_how_to_get_what_robots_need() -> None:
    rows = {row["name"]: row for row in json.loads(plainspoken("doctor", "--json").stdout)}
    assert rows["py-trees"]["found"]
    assert rows["pyyaml"]["remedy"] == "pip install 'plainspoken[robots]'"
    assert "plainspoken[ros2]" in rows["rclpy"]["remedy"]


@pytest.mark.parametrize(
    ("robot", "file", "settings", "said"),
    [
        ("http", None, Settings(), "needs --robots FILE"),
        ("simulator", Path("r.yaml"), Settings(), "not simulated"),
        (None, Path("r.yaml"), Settings(seed=3), "for the simulated robot"),
        (None, Path("r.yaml"), Settings(pace=1.0), "for the simulated robot"),
        (None, Path("r.yaml"), Settings(world="w"), "for the simulated robot"),
    ],
)
def test_options_that_do_not_go_together_are_refused(
    robot: str | None, file: Path | None, settings: Settings, said: str
) -> None:
    with pytest.raises(click.UsageError, match=said):
        chosen_robot(robot, file, settings)


@pytest.mark.parametrize("via", [None, "ros2"])
def test_a_log_says_which_robot_it_was(via: str | None, tmp_path: Path) -> None:
    chosen = Robots(tmp_path / "robots.yaml", via, 30.0, ("rob",))
    assert robot_in(chosen.to_json()) == chosen
    assert robot_in(Settings(seed=7).to_json()) == Settings(7, [])


class Believer:
    def __init__(self) -> None:
        self.told: list[tuple[list[str], list[str]]] = []

    def believe(self, added: tuple[str, ...], deleted: tuple[str, ...]) -> None:
        self.told.append((list(added), list(deleted)))


def test_what_people_report_is_told_to_a_robot_that_only_believes() -> None:
    robot: Any = Believer()
    checked: Robot = robot
    stored: list[Entry] = []
    record = heeding(checked, lambda _, __: stored)
    report = ReportReceived("ada", "it is full", ("full b",), (), frozenset(["full b"]))
    assert record(1, [report]) is stored
    assert robot.told == [(["full b"], [])]


def test_the_person_at_the_terminal_is_asked_until_there_is_an_answer(store: Store) -> None:
    questions = Questions(store.database)
    questions.ask("other/1:0#1", "Not for us?", ["yes"])
    questions.ask("m/1:0#1", "Ripe?", ["ripe", "unripe"])
    said: list[str] = []
    with asking_here(store, "m", io.StringIO("perhaps\nripe\n"), said.append):
        until = time.monotonic() + 10
        while len(questions.open()) == 2 and time.monotonic() < until:
            time.sleep(0.02)
    assert [each.call for each in questions.open()] == ["other/1:0#1"]
    assert said[0] == "Ripe? [ripe / unripe]"
    assert "one of: ripe, unripe, cannot" in said[1]
