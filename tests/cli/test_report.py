import json
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from plainspoken.cli import plainspoken as commands
from plainspoken.cli.exit import BAD_INPUT
from plainspoken.errors import PlainspokenError

Run = Callable[..., Result]


@pytest.fixture
def plainspoken(store_url: str, monkeypatch: pytest.MonkeyPatch) -> Run:
    """The command line, in this process: what is tested here starts it a dozen times."""
    monkeypatch.setenv("PLAINSPOKEN_STORE", store_url)

    def run(*arguments: str, code: int = 0, said: str | None = None) -> Result:
        done = CliRunner().invoke(commands, arguments, input=said)
        if isinstance(done.exception, PlainspokenError):
            assert code == BAD_INPUT, done.exception
            done.stderr_bytes = str(done.exception).encode()
        else:
            assert done.exit_code == code, (done.stderr, done.exception)
        return done

    return run


def detached(plainspoken: Run, *options: str) -> str:
    say = "Clear line 2 and line 3"
    return plainspoken("run", "--say", say, "--detach", *options).stdout.strip()


def events(plainspoken: Run, mission: str, folder: Path) -> list[dict[str, Any]]:
    """The log of a mission, its chain checked."""
    out = folder / "log.jsonl"
    plainspoken("missions", "log", mission, "--out", str(out), "--overwrite")
    lines = out.read_text().splitlines()
    return [each for each in map(json.loads, lines) if "kind" in each]


def test_a_report_is_recorded_acted_on_and_told_again(plainspoken: Run, tmp_path: Path) -> None:
    mission = detached(plainspoken)
    done = plainspoken("report", "I cleared line 2 myself", "--by", "Anna", "--yes")
    assert "noted: line 2 is cleared" in done.stdout
    plainspoken("work", "--until-done")
    log = events(plainspoken, mission, tmp_path)
    (report,) = [each for each in log if each["kind"] == "report_received"]
    assert (report["reporter"], report["added"]) == ("Anna", ["cleared l2"])
    assert not any(each.get("action") == "sign-off rob l2" for each in log)
    assert log[-1]["satisfied"]
    assert "Anna reported it at " in plainspoken("ask", "Who cleared line 2?").stdout


def test_what_is_refused_unclear_or_not_confirmed_is_recorded_nowhere(
    plainspoken: Run, tmp_path: Path
) -> None:
    mission = detached(plainspoken)
    for text, said in (
        ("Is line 2 cleared?", "question"),
        ("the moon is made of cheese", "nothing that I keep track of"),
        ("grape 1 is ripe and unripe", "never so together"),
        ("I checked grape 1", "2. grape 1 is unripe"),
    ):
        refused = plainspoken("report", text, "--yes", code=3)
        assert said in refused.stderr
        assert "nothing is recorded" in refused.stderr
    assert "--yes" in plainspoken("report", "line 2 is cleared", code=3).stderr
    shown = json.loads(plainspoken("report", "line 2 is cleared", "--json").stdout)
    assert (shown["facts"], shown["heard"]) == (["cleared l2"], False)
    kinds = [each["kind"] for each in events(plainspoken, mission, tmp_path)]
    assert kinds == ["mission_accepted", "policy_chosen"]
    plainspoken("missions", "cancel", mission)
    assert "no mission goes on" in plainspoken("report", "hi", code=2).stderr


def test_a_paused_mission_hears_a_report_and_a_change_and_goes_on_with_both(
    plainspoken: Run, tmp_path: Path
) -> None:
    mission = detached(plainspoken)
    plainspoken("missions", "pause", mission)
    plainspoken("report", "grape 2 isn't ripe", "--mission", mission, "--yes", "--by", "Anna")
    plainspoken("missions", "change", mission, "skip line 3", "--yes", "--by", "Bea")
    plainspoken("missions", "resume", mission)
    log = events(plainspoken, mission, tmp_path)
    actions = [each["action"] for each in log if each["kind"] == "action_started"]
    assert actions == ["move rob l0 l1", "move rob l1 l2", "sign-off rob l2"]
    (changed,) = [each for each in log if each["kind"] == "request_changed"]
    assert changed["text"] == "skip line 3"
    (listed,) = json.loads(plainspoken("missions", "--json").stdout)
    assert listed["request"] == changed["english"] != ""
    why = plainspoken("ask", "Why aren't you doing line 3?").stdout
    assert "Because Bea told me at " in why


def test_a_change_without_a_plan_leaves_the_mission_as_it_was(
    plainspoken: Run, tmp_path: Path
) -> None:
    mission = detached(plainspoken)
    plainspoken("missions", "pause", mission)
    text = "also never go to line 2"
    plainspoken("missions", "change", mission, text, "--yes", "--besides")
    plainspoken("missions", "resume", mission)
    log = events(plainspoken, mission, tmp_path)
    (refused,) = [each for each in log if each["kind"] == "change_refused"]
    assert refused["reason"]
    assert log[-1]["outcome"] == "finished"
    assert log[-1]["satisfied"]


def worker() -> "subprocess.Popen[str]":
    command = [sys.executable, "-m", "plainspoken", "work", "--json"]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)


def wait_for(running: "subprocess.Popen[str]", kind: str) -> None:
    assert running.stdout is not None
    for line in running.stdout:
        if json.loads(line)["kind"] == kind:
            return
    raise AssertionError(f"the worker ended before {kind}")


def test_a_report_is_neither_lost_nor_heard_twice_when_its_worker_is_killed(
    plainspoken: Run, tmp_path: Path
) -> None:
    world = str(tmp_path / "world")
    mission = detached(plainspoken, "--world", world, "--pace", "0.05")
    with worker() as running:
        wait_for(running, "action_started")
        running.send_signal(signal.SIGSTOP)  # so that the report waits in the store
        posted = plainspoken("report", "I cleared line 3", "--yes", "--by", "Anna", code=3)
        assert "has not answered yet" in posted.stderr
        running.kill()
    plainspoken("work", "--until-done")
    log = events(plainspoken, mission, tmp_path)
    assert [each["text"] for each in log if each["kind"] == "report_received"] == [
        "I cleared line 3"
    ]
    assert log[-1]["satisfied"]
    goals = [each["goal_id"] for each in log if each["kind"] == "action_finished"]
    assert len(goals) == len(set(goals))


def test_a_report_is_in_the_log_once_when_its_worker_is_killed_right_behind_it(
    plainspoken: Run, tmp_path: Path
) -> None:
    world = str(tmp_path / "world")
    mission = detached(plainspoken, "--world", world, "--pace", "0.05")
    with worker() as running:
        wait_for(running, "action_started")
        plainspoken("report", "I cleared line 3", "--yes", "--by", "Anna")
        running.kill()
    plainspoken("work", "--until-done")
    log = events(plainspoken, mission, tmp_path)
    assert [each["kind"] for each in log].count("report_received") == 1
    assert log[-1]["satisfied"]


def test_talking_reports_and_changes_what_is_agreed_to(plainspoken: Run, tmp_path: Path) -> None:
    mission = detached(plainspoken)
    said = "What will you do?\nI cleared line 2 myself\nyes\nskip line 3\nno\n"
    talk = plainspoken("ask", "--talk", "--mission", mission, said=said).stdout
    assert "Is that right?\nNoted: line 2 is cleared.\n" in talk
    assert talk.endswith("Then nothing is changed.\n")
    kinds = [each["kind"] for each in events(plainspoken, mission, tmp_path)]
    assert "report_received" in kinds
    assert "change_requested" not in kinds
