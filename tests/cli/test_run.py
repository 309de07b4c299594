import json
import subprocess
import sys
from pathlib import Path

import pytest

Finished = subprocess.CompletedProcess[str]


@pytest.fixture(autouse=True)
def _own_store(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PLAINSPOKEN_HOME", str(tmp_path))


def run(*options: str) -> Finished:
    command = [sys.executable, "-m", "plainspoken", "run", "--say", "Clear line 2", *options]
    return subprocess.run(command, capture_output=True, text=True, check=False)


@pytest.mark.parametrize("fault", ["hanging:1", "failing:1", "lost:1", "lying", "person"])
def test_a_robot_that_faults_strike_ends_with_a_reason_or_with_what_was_asked(
    fault: str, tmp_path: Path
) -> None:
    log = tmp_path / "run.jsonl"
    done = run("--fault", fault, "--log", str(log))
    last = json.loads(log.read_text().splitlines()[-1])
    assert last["kind"] == "mission_ended"
    assert done.returncode == (0 if last["satisfied"] else 3), done.stderr
    assert last["satisfied"] or last["reason"]


def test_the_faults_are_in_the_log() -> None:
    done = run("--fault", "lying:0.5", "--json")
    accepted = json.loads(done.stdout.splitlines()[0])
    assert accepted["robot"]["faults"] == ["lying:0.5"]


def test_a_fault_that_does_not_exist_is_named_with_those_that_do() -> None:
    done = run("--fault", "sulking")
    assert done.returncode == 2
    assert "failing, hanging" in done.stderr


def test_a_run_whose_output_nobody_reads_any_more_is_paused_without_a_word() -> None:
    command = [sys.executable, "-m", "plainspoken"]
    with subprocess.Popen(
        [*command, "run", "--say", "Clear line 2", "--pace", "0.02", "--json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as running:
        assert running.stdout is not None
        assert running.stderr is not None
        running.stdout.readline()
        running.stdout.close()
        said = running.stderr.read()
    assert "Traceback" not in said, said
    listed = subprocess.run([*command, "missions", "--json"], capture_output=True, check=True)
    (mission,) = json.loads(listed.stdout)
    assert mission["status"] == "paused"
    assert mission["worker"] is None


def test_verdicts_tells_how_the_request_stands_after_each_instant(tmp_path: Path) -> None:
    log = tmp_path / "run.jsonl"
    assert run("--log", str(log)).returncode == 0
    told = [sys.executable, "-m", "plainspoken", "missions", "verdicts", "--log", str(log)]
    done = subprocess.run([*told, "--json"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    judged = [json.loads(line) for line in done.stdout.splitlines()]
    last = json.loads(log.read_text().splitlines()[-1])
    assert [each["instant"] for each in judged] == list(range(last["instant"] + 1))
    assert [each["verdict"] for each in judged] == ["open"] * last["instant"] + ["satisfied"]
    table = subprocess.run(told, capture_output=True, text=True, check=False)
    assert "F cleared_l2: satisfied" in table.stdout
