"""A mission that waits for a look is killed, gone on with, paused and asked, as by a stranger."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TypeVar

import pytest
from click.testing import CliRunner
from tests.mission.store_room import FOLDER

from plainspoken.backends.questions import Question, Questions
from plainspoken.cli import plainspoken
from plainspoken.knowledge.sqlite import SqliteDatabase

T = TypeVar("T")
PATIENCE = 100.0
"""Seconds, for a machine that has much else to do."""
PLACE = ("--domain", str(FOLDER / "domain.pddl"), "--problem", str(FOLDER / "problem.pddl"))


class Room:
    """A store, the programs that use it, and the people who are asked."""

    def __init__(self, folder: Path) -> None:
        self.store = folder / "store.sqlite"
        self.questions = Questions(SqliteDatabase(self.store))
        self.environment = {**os.environ, "PLAINSPOKEN_STORE": str(self.store)}
        self.begun: list[subprocess.Popen[str]] = []

    def begin(self, *arguments: str) -> subprocess.Popen[str]:
        program = subprocess.Popen(
            [sys.executable, "-m", "plainspoken", *arguments],
            env=self.environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.begun.append(program)
        return program

    def run(self, *arguments: str) -> str:
        """What a command prints that nobody kills; in this process, for one that is loaded."""
        done = CliRunner().invoke(
            plainspoken, arguments, env={"PLAINSPOKEN_STORE": str(self.store)}
        )
        assert done.exit_code == 0, done.output
        return done.stdout

    def begin_mission(self) -> subprocess.Popen[str]:
        robots = str(FOLDER / "people.yaml")
        return self.begin("run", *PLACE, "--goal", "F in_parcel_ramp", "--robots", robots)

    @property
    def mission(self) -> str:
        (only,) = json.loads(self.run("missions", "--json"))
        return str(only["mission"])

    def asked(self) -> Question:
        """The question that is open, once there is one."""
        return until(lambda: next(iter(self.questions.open()), None))

    def answer(self, program: subprocess.Popen[str], facts: dict[str, str]) -> list[str]:
        """Answer all that is asked until the program ends; what was asked."""
        heard = []
        while program.poll() is None:
            for question in self.questions.open():
                heard.append(question.text)
                said = "done" if "done" in question.answers else facts.get(question.text, "no")
                self.questions.answer(question.call, said, "ada")
            time.sleep(0.05)
        return heard


def until(found: Callable[[], T | None]) -> T:
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        one = found()
        if one is not None:
            return one
        time.sleep(0.05)
    raise AssertionError("it did not come")


@pytest.fixture
def room(tmp_path: Path) -> Iterator[Room]:
    here = Room(tmp_path)
    yield here
    for program in here.begun:
        if program.poll() is None:
            program.kill()
        program.communicate()


def test_a_mission_that_was_killed_while_it_looks_asks_the_same_question_and_goes_on(
    room: Room,
) -> None:
    first = room.begin_mission()
    question = room.asked()
    assert question.text == "Is the red-room locked?"
    first.kill()
    first.communicate()
    mission = room.mission
    again = room.begin("missions", "resume", mission)
    until(lambda: "resumed" in kinds(room, mission) or None)
    assert [each.call for each in room.questions.open()] == [question.call]
    heard = room.answer(again, {"Is the parcel in the red-room?": "yes"})
    assert again.returncode == 0
    assert heard == [
        "Is the red-room locked?",
        "Go to the red-room",
        "Is the parcel in the red-room?",
        "Take the parcel",
        "Go to the hall",
        "Go to the ramp",
        "Is the ramp full?",
        "Put the parcel down",
    ]
    facts = {
        one["atom"]: one for one in json.loads(room.run("missions", "facts", mission, "--json"))
    }
    assert facts["full ramp"]["holds"] is False
    assert facts["full ramp"]["by"] == "ada"
    assert facts["locked blue-room"]["holds"] is None
    assert facts["in parcel blue-room"]["by"] == "model"
    said = room.run("ask", "How do you know that the ramp is not full?")
    assert said.startswith("Ada told me")


def test_a_mission_that_looks_can_be_paused_and_cancelled(room: Room) -> None:
    looking = room.begin_mission()
    room.asked()
    mission = room.mission
    assert room.run("missions", "pause", mission).startswith("paused")
    looking.communicate(timeout=PATIENCE)
    assert room.run("missions", "cancel", mission).startswith("cancelled")


def test_what_no_person_can_tell_stops_the_mission_with_its_reason(room: Room) -> None:
    looking = room.begin_mission()
    room.questions.answer(room.asked().call, "unsure", "ada")
    _, trouble = looking.communicate(timeout=PATIENCE)
    assert looking.returncode == 3
    assert "nothing could tell whether locked red-room" in trouble


def test_a_question_has_a_worker_look_and_only_then_answer(room: Room, tmp_path: Path) -> None:
    world = ("--pace", "30", "--world", str(tmp_path / "world"), "--robot-name", "rob")
    room.run(
        "run", *PLACE, "--goal", "F in_parcel_ramp", *world, "--steer", "full ramp", "--detach"
    )
    mission = room.mission
    unseen = room.run("ask", "Is the ramp full?")
    assert unseen.startswith("I don't know whether the ramp is full")
    room.begin("work")
    until(lambda: "action_started" in kinds(room, mission) or None)
    assert room.run("ask", "Is the ramp full?").startswith("Let me look. Yes, the ramp is full")
    assert kinds(room, mission).count("look_requested") == 1


def kinds(room: Room, mission: str) -> list[str]:
    """The kinds of the events of a mission so far."""
    from plainspoken.knowledge.log import SqliteLog

    with SqliteLog(room.store) as log:
        return [entry.kind for entry in log.entries(mission)]
