import json
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

Finished = subprocess.CompletedProcess[str]


@pytest.fixture(autouse=True)
def _own_store(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PLAINSPOKEN_STORE", str(tmp_path / "store.sqlite"))


def plainspoken(*arguments: str, code: int = 0) -> Finished:
    command = [sys.executable, "-m", "plainspoken", *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == code, done.stderr
    return done


def detached(*options: str) -> str:
    return plainspoken("run", "--say", "Clear line 2", "--detach", *options).stdout.strip()


def listed() -> dict[str, dict[str, object]]:
    found = json.loads(plainspoken("missions", "--json").stdout)
    return {one["mission"]: one for one in found}


def test_what_is_detached_waits_for_a_worker_and_is_carried_out_by_it() -> None:
    done = plainspoken("run", "--say", "Clear line 2", "--detach", "--robot-name", "rob")
    mission = done.stdout.strip()
    assert "plainspoken work" in done.stderr
    assert listed()[mission]["robots"] == ["rob"]
    assert listed()[mission]["instant"] == 0
    worked = plainspoken("work", "--until-done")
    assert f"{mission}  finished" in worked.stdout
    assert listed()[mission]["status"] == "finished"


def test_a_worker_prints_every_event_as_json_where_it_is_asked_to() -> None:
    mission = detached()
    lines = plainspoken("work", "--until-done", "--json").stdout.splitlines()
    events = [json.loads(line) for line in lines]
    assert {event["mission"] for event in events} == {mission}
    assert [events[0]["kind"], events[-1]["kind"]] == ["taken_up", "mission_ended"]


def test_a_mission_that_waits_is_paused_resumed_and_cancelled() -> None:
    mission = detached()
    assert plainspoken("missions", "pause", mission).stdout == "paused\n"
    assert listed()[mission]["status"] == "paused"
    plainspoken("work", "--until-done")
    assert listed()[mission]["status"] == "paused"
    assert "nobody carries" in plainspoken("missions", "resume", mission, "--detach").stdout
    assert plainspoken("missions", "cancel", mission).stdout == "cancelled\n"
    assert listed()[mission]["status"] == "cancelled"
    again = plainspoken("missions", "cancel", mission, code=2)
    assert "is over" in again.stderr


def test_a_paused_mission_is_resumed_in_the_foreground() -> None:
    mission = detached()
    plainspoken("missions", "pause", mission)
    plainspoken("missions", "resume", mission)
    assert listed()[mission]["status"] == "finished"


def test_a_run_that_is_killed_is_gone_on_with_by_a_worker(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "plainspoken", "run", "--say", "Clear line 2"]
    command += ["--world", str(tmp_path / "world"), "--pace", "0.05", "--json"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as running:
        assert running.stdout is not None
        for line in running.stdout:
            if json.loads(line)["kind"] == "action_started":
                break
        running.kill()
    plainspoken("work", "--until-done")
    ((_, one),) = listed().items()
    assert one["status"] == "finished"


def test_a_running_mission_hears_a_request_within_a_second() -> None:
    mission = detached("--pace", "0.1")
    command = [sys.executable, "-m", "plainspoken", "work", "--json"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as worker:
        assert worker.stdout is not None
        for line in worker.stdout:
            if json.loads(line)["kind"] == "action_started":
                break
        done = plainspoken("missions", "pause", mission)
        assert "under way" in done.stdout
        worker.terminate()
        assert worker.wait(timeout=10) == 0
    assert listed()[mission]["status"] == "paused"


def test_a_foreground_run_waits_for_the_missions_that_have_its_robot() -> None:
    first = detached("--robot-name", "rob")
    command = [sys.executable, "-m", "plainspoken", "run", "--say", "Clear line 2"]
    command += ["--robot-name", "rob", "--json"]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as second:
        assert second.stderr is not None
        assert first in second.stderr.readline()
        plainspoken("missions", "cancel", first)
        out, _ = second.communicate(timeout=30)
    kinds = [json.loads(line)["kind"] for line in out.splitlines()]
    assert kinds[0] == "mission_accepted"
    assert kinds[-1] == "mission_ended"


def test_a_mission_of_several_robots_waits_for_each_of_them() -> None:
    first, second = detached("--robot-name", "rob"), detached("--robot-name", "sup")
    command = [sys.executable, "-m", "plainspoken", "run", "--say", "Clear line 2"]
    command += ["--robot-name", "sup", "--robot-name", "rob"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as third:
        assert third.stderr is not None
        assert f"{first}, {second}" in third.stderr.readline()
        plainspoken("work", "--until-done", "--missions", "2")
        assert third.wait(timeout=30) == 0
    assert {one["status"] for one in listed().values()} == {"finished"}


def test_a_run_that_is_interrupted_rests_and_no_worker_goes_on_with_it() -> None:
    command = [sys.executable, "-m", "plainspoken", "run", "--say", "Clear line 2"]
    command += ["--pace", "0.05", "--json"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as running:
        assert running.stdout is not None
        for line in running.stdout:
            if json.loads(line)["kind"] == "action_started":
                break
        running.send_signal(signal.SIGINT)
        running.communicate(timeout=20)
    plainspoken("work", "--until-done")
    ((mission, one),) = listed().items()
    assert (one["status"], one["worker"]) == ("paused", None)
    plainspoken("missions", "resume", mission)
    assert listed()[mission]["status"] == "finished"


def test_watching_and_detaching_exclude_each_other() -> None:
    done = plainspoken("run", "--say", "Clear line 2", "--detach", "--json", code=2)
    assert "--detach" in done.stderr


def test_a_worker_that_is_told_to_stop_hands_its_missions_back() -> None:
    mission = detached("--pace", "0.1")
    command = [sys.executable, "-m", "plainspoken", "work", "--json"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as worker:
        assert worker.stdout is not None
        worker.stdout.readline()
        started = time.monotonic()
        worker.terminate()
        assert worker.wait(timeout=10) == 0
    assert time.monotonic() - started < 3.0
    assert listed()[mission]["worker"] is None
