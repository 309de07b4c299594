"""docs/robots.md is true: its example runs as it stands, and its files are read."""

from __future__ import annotations

import json
import os
import re
import shlex
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.backends.activities.errands import DOMAIN_TEXT, PROBLEM_TEXT, VIA, file_of, robot_of

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "robots.md").read_text()


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", PAGE, re.DOTALL)


def shell_commands() -> list[str]:
    lines = (line for block in blocks("sh") for line in block.splitlines())
    return [line for line in lines if not line.startswith("pip ")]


@pytest.fixture
def port() -> int:
    with socket.create_server(("127.0.0.1", 0)) as free:
        number: int = free.getsockname()[1]
        return number


@pytest.fixture
def here(tmp_path: Path, port: int) -> Iterator[Path]:
    """A folder like a clone, where the robot listens at a free port."""
    robots = tmp_path / "examples" / "robots"
    robots.mkdir(parents=True)
    for file in (ROOT / "examples" / "robots").glob("*.*"):
        text = file.read_text()
        (robots / file.name).write_text(text.replace("127.0.0.1:8800", f"127.0.0.1:{port}"))
    return tmp_path


class Terminals:
    """Runs the page's commands as somebody would who reads it."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.environment = {**os.environ, "PLAINSPOKEN_HOME": str(folder), "NO_COLOR": "1"}
        self.running: list[subprocess.Popen[str]] = []

    def start(self, line: str) -> subprocess.Popen[str]:
        words = shlex.split(line.partition(" #")[0])
        program = ["-m", "plainspoken"] if words[0] == "plainspoken" else []
        process = subprocess.Popen(
            [sys.executable, *program, *words[1:]],
            cwd=self.folder,
            env=self.environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        self.running.append(process)
        return process

    def run(self, line: str) -> tuple[int, str]:
        process = self.start(line)
        told, _ = process.communicate(timeout=100)
        return process.returncode, told

    def close(self) -> None:
        for process in self.running:
            process.kill()
            process.wait()
            if process.stdout is not None:
                process.stdout.close()


@pytest.fixture
def terminals(here: Path) -> Iterator[Terminals]:
    terminals = Terminals(here)
    yield terminals
    terminals.close()


def test_the_worked_example_runs_as_it_stands(terminals: Terminals, port: int) -> None:
    doctor, server, check, run, answer, ask, missions, resume = shell_commands()
    assert terminals.run(doctor)[0] == 0
    robot = terminals.start(server.replace("8800", str(port)) + " --pace 0.02")
    assert robot.stdout is not None
    assert str(port) in robot.stdout.readline()
    assert terminals.run(check)[0] == 0

    mission = terminals.start(run)
    wait_for_a_question(terminals)
    told = terminals.run(ask)[1]
    assert "a person is asked: Is the grape g1 on l1 ripe or unripe?" in told
    mission.kill()
    mission.communicate()
    assert terminals.run(answer) == (0, "answered: Is the grape g1 on l1 ripe or unripe?\n")

    accepted = json.loads((terminals.folder / "run.jsonl").read_text().splitlines()[0])
    assert accepted["mission"] in terminals.run(missions)[1]
    status, told = terminals.run(resume.replace("ID", accepted["mission"]))
    assert status == 0, told
    assert "everything asked for is" in told


def wait_for_a_question(terminals: Terminals) -> None:
    until = time.monotonic() + 100
    while time.monotonic() < until:
        if json.loads(terminals.run("plainspoken answer --json")[1]):
            return
    raise AssertionError("nobody was asked anything")


@pytest.mark.parametrize("block", [each for each in blocks("yaml") if each.startswith("do:")])
def test_every_activity_on_the_page_can_be_read(block: str, tmp_path: Path) -> None:
    indented = "".join(f"    {line}\n" for line in block.splitlines())
    text = file_of("{call: drive}")
    text = text.replace("    do:\n      {call: drive}\n", indented)
    assert block.splitlines()[0] in text
    with robot_of(text, tmp_path):
        pass


SERVICES = [each for each in blocks("yaml") if "services:" in each and "via: ros2" not in each]


@pytest.mark.parametrize("block", SERVICES)
def test_every_service_on_the_page_can_be_read(
    block: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROBOT_TOKEN", "s3cret")
    (tmp_path / "line.pddl").write_text(DOMAIN_TEXT)
    (tmp_path / "one-line.pddl").write_text(PROBLEM_TEXT)
    go = '{call: SERVICE, with: {h: rob, l: "{to}"}}'
    (tmp_path / "line.yaml").write_text(file_of("{call: drive}"))
    head, services = block.split("services:\n")
    name = services.split(":")[0].strip()
    text = file_of(go.replace("SERVICE", name)).replace("services:\n", "", 1)
    kept = [line for line in text.splitlines() if not line.startswith(f"  {name}: {{{VIA}")]
    with robot_of(f"{head}services:\n{services}" + "\n".join(kept) + "\n", tmp_path):
        pass


def test_there_is_something_on_the_page_to_read() -> None:
    assert len(SERVICES) == 2
    assert sum(block.startswith("do:") for block in blocks("yaml")) == 3


def test_the_error_on_the_page_is_what_is_said(tmp_path: Path) -> None:
    from plainspoken.errors import InputFileError

    with pytest.raises(InputFileError) as caught, robot_of(file_of("{call: drvie}"), tmp_path):
        pass
    what, place, hint = blocks("text")[0].splitlines()
    assert what == f"plainspoken: {caught.value.what}"
    assert re.fullmatch(r"  robots\.yaml:\d+:\d+, field actions\.\w+\.do\.call", place)
    assert hint.startswith("hint: did you mean 'drive'? expected one of: ")
    assert (caught.value.hint or "").startswith("did you mean 'drive'? expected one of: ")
