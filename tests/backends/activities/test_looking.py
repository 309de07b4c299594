"""Services and people are asked about single facts: in order, a few times, and never for long."""

from __future__ import annotations

import json
import threading
from collections.abc import Mapping
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import ClassVar

import pytest
from tests.backends.activities.errands import PROBLEM, file_of, robot_of
from tests.backends.activities.scripted import CALLED, SCRIPTS
from tests.mission.conformance import ended

from plainspoken.backends.activities.looking import Looking
from plainspoken.backends.human import HumanService
from plainspoken.backends.questions import Questions
from plainspoken.errors import InputFileError
from plainspoken.knowledge.sqlite import SqliteDatabase
from plainspoken.mission.repertoire import Ask, Offer, Sensor
from plainspoken.mission.robot import Succeeded, Unreachable
from plainspoken.mission.sensing import Telling
from plainspoken.mission.service import CallStatus, Done, Fields, Going, NotDone, Service
from plainspoken.world.domain import Parameter


class Clock:
    """Time that passes only while somebody waits."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        return self.now

    def sleep(self, seconds: float) -> None:
        self.now += seconds


@dataclass
class Scripted:
    """A service that gives these, one a call; the last one for good."""

    gives: list[CallStatus | Unreachable]
    calls: list[tuple[str, Fields]] = field(default_factory=list)
    cancelled: list[str] = field(default_factory=list)

    def objection(self, fields: Fields) -> str | None:
        del fields
        return None

    def begin(self, call: str, fields: Fields) -> None:
        self.calls.append((call, fields))

    def status(self, call: str) -> CallStatus:
        del call
        found = self.gives[min(len(self.calls), len(self.gives)) - 1]
        if isinstance(found, Unreachable):
            raise found
        return found

    def cancel(self, call: str) -> None:
        self.cancelled.append(call)

    def reach(self) -> None: ...


CAMERA = Ask("camera", {"box": "{b}"}, {"full": True}, {"full": False})
PERSON = Ask("person", {"question": "Is {b} full?"}, {"answer": "yes"}, {"answer": "no"})


def looking(services: Mapping[str, Service], *ways: Ask) -> tuple[Looking, Clock]:
    clock = Clock()
    sensor = Sensor("full {b}", (Parameter("b", ("object",)),), ways, needed=True)
    offers = dict.fromkeys(services, Offer(limit=5.0))
    return Looking([sensor], services, offers, {}, clock=clock, sleep=clock.sleep), clock


def told(look: Looking, seconds: float = 100.0) -> Telling:
    found = look.sense("m/look-1", ["full b1"], seconds)
    assert found is not None
    return found[0]


@pytest.mark.parametrize(("result", "holds"), [(True, True), (False, False), (None, None)])
def test_a_service_tells_that_a_fact_holds_or_does_not_or_that_it_cannot_tell(
    result: bool | None,  # noqa: FBT001 - what the service gave
    holds: bool | None,  # noqa: FBT001 - what it means
) -> None:
    camera = Scripted([Done({"full": result})])
    look, _ = looking({"camera": camera}, CAMERA)
    found = told(look)
    assert (found.atom, found.holds, found.by) == ("full b1", holds, "camera")
    assert camera.calls == [("m/look-1:full_b1#0.0", {"box": "b1"})]
    assert (found.why is None) is (holds is not None)


def test_the_next_one_is_asked_where_the_first_cannot_tell() -> None:
    person = Scripted([Done({"answer": "yes", "reporter": "ada"})])
    services = {"camera": Scripted([NotDone("it is dark")]), "person": person}
    look, _ = looking(services, CAMERA, PERSON)
    found = told(look)
    assert (found.holds, found.by, found.reporter) == (True, "person", "ada")


def test_what_cannot_be_reached_is_tried_three_times_and_no_more() -> None:
    camera = Scripted([Unreachable("no route")])
    look, _ = looking({"camera": camera}, CAMERA)
    found = told(look)
    assert found.holds is None
    assert found.why == "no route"
    assert len(camera.calls) == 3


def test_it_may_be_reached_the_second_time() -> None:
    camera = Scripted([Unreachable("no route"), Done({"full": True})])
    look, _ = looking({"camera": camera}, CAMERA)
    assert told(look).holds is True


def test_what_takes_too_long_is_taken_back_and_tried_again() -> None:
    camera = Scripted([Going({})])
    look, clock = looking({"camera": camera}, CAMERA)
    assert told(look).why == "no answer from camera in 5 s"
    assert camera.cancelled == [call for call, _ in camera.calls]
    assert 15 <= clock.now <= 20


def test_nobody_waits_longer_than_asked_and_what_was_begun_goes_on() -> None:
    camera = Scripted([Going({})])
    look, clock = looking({"camera": camera}, CAMERA)
    assert look.sense("m/look-1", ["full b1"], 0.2) is None
    assert clock.now <= 0.3
    camera.gives = [Done({"full": False})]
    assert told(look).holds is False
    assert len(camera.calls) == 1


def test_a_look_that_nobody_waits_for_is_taken_back() -> None:
    camera = Scripted([Going({})])
    look, _ = looking({"camera": camera}, CAMERA)
    look.sense("m/look-1", ["full b1"], 0.0)
    look.dismiss("m/look-1")
    assert camera.cancelled == ["m/look-1:full_b1#0.0"]


def test_of_a_look_only_what_nobody_needs_any_more_is_taken_back() -> None:
    camera = Scripted([Going({})])
    look, _ = looking({"camera": camera}, CAMERA)
    look.sense("m/look-1", ["full b1", "full b2"], 0.0)
    look.sense("m/look-1", ["full b2"], 0.0)
    assert camera.cancelled == ["m/look-1:full_b1#0.0"]


def test_a_look_that_was_taken_back_can_be_asked_for_again(tmp_path: Path) -> None:
    questions = Questions(SqliteDatabase(tmp_path / "store"))
    look, _ = looking({"person": HumanService(questions)}, PERSON)
    assert look.sense("m/look-1", ["full b1", "full b2"], 0.0) is None
    first, second = questions.open()
    questions.answer(first.call, "yes", "ada")
    assert look.sense("m/look-1", ["full b1", "full b2"], 0.0) is None
    look.dismiss("m/look-1")
    assert questions.open() == ()
    assert look.sense("m/look-1", ["full b1", "full b2"], 0.0) is None
    assert questions.open() == (second,)
    questions.answer(second.call, "no", "bob")
    found = look.sense("m/look-1", ["full b1", "full b2"], 0.0)
    assert found is not None
    assert [(each.holds, each.reporter) for each in found] == [(True, "ada"), (False, "bob")]


def test_what_nothing_can_be_asked_about_is_not_known() -> None:
    look, _ = looking({}, CAMERA)
    found = look.sense("m/look-1", ["lit lamp"], 0.0)
    assert found is not None
    assert (found[0].holds, found[0].by) == (None, "nobody")


def test_a_person_is_asked_once_whichever_process_asks(tmp_path: Path) -> None:
    questions = Questions(SqliteDatabase(tmp_path / "store"))
    for _ in range(2):
        look, _ = looking({"person": HumanService(questions)}, PERSON)
        assert look.sense("m/look-1", ["full b1"], 0.0) is None
    (question,) = questions.open()
    questions.answer(question.call, "no", "ada")
    look, _ = looking({"person": HumanService(questions)}, PERSON)
    found = told(look, 0.0)
    assert (found.holds, found.reporter) == (False, "ada")


FACT = """facts:
  "held {x}": {call: arm, when: {holding: true}, MORE}
"""
WRONG: dict[str, tuple[str, str]] = {
    "lasts: soon": ("soon", "expected a number"),
    "lasts: -3": ("-3", "greater than 0"),
    "needed: perhaps": ("perhaps", "true or false"),
    "needed: true, tries: 0": ("0", "at least 1"),
    "needed: true, tries: 1.5": ("1.5", "whole number"),
    "at_first: false": ("false", "expected a text"),
    "at_first: unknwon": ("unknwon", "did you mean 'unknown'"),
    "tries: 2": ("tries", "say `needed: true`"),
    "otherwise: [{call: arm, when: {a: b}}]": ("otherwise", "say `needed: true`"),
    "needed: true, otherwise: [{call: amr, when: {a: b}}]": ("amr", "did you mean 'arm'"),
    "needed: true, otherwise: [{call: arm}]": ("{call: arm}", "'when' is missing"),
    "needed: true, otherwise: [{call: arm, when: {a: b}, lasts: 3}]": ("lasts", "no key 'lasts'"),
    'unless: {a: "{y}"}': ("{y}", r"no {y}"),
    "need: true": ("need", "did you mean 'needed'"),
}


@pytest.mark.parametrize(("more", "expected"), WRONG.items())
def test_a_wrong_fact_is_refused_with_its_line(
    more: str, expected: tuple[str, str], tmp_path: Path
) -> None:
    text = file_of("{call: drive}") + FACT.replace("MORE", more)
    with pytest.raises(InputFileError) as caught, robot_of(text, tmp_path):
        pass
    place, said = expected
    assert caught.value.line is not None
    line = text.splitlines()[caught.value.line - 1]
    assert line[(caught.value.column or 1) - 1 :].lstrip("\"'").startswith(place)
    assert said in f"{caught.value.what} {caught.value.hint}"


GRASPED = """
facts:
  "held {t}":
    call: look
    with: {thing: "{t}"}
    when: {held: true}
    unless: {held: false}
    needed: true
"""


@pytest.mark.parametrize("held", [True, False])
def test_what_an_action_came_to_is_told_by_a_fact_that_is_looked_at_when_needed(
    tmp_path: Path, *, held: bool
) -> None:
    SCRIPTS["look"] = [1, Done({"held": held})]
    text = file_of("{call: drive}", more=GRASPED)
    assert "outcomes:" in text
    text = text[: text.index("    outcomes:")] + text[text.index("\nfacts:") :]
    at_kitchen = (PROBLEM.initial - {"at hall"}) | {"at kitchen"}
    with robot_of(text, tmp_path, at_kitchen) as robot:
        robot.send("m/1", "grasp mug kitchen")
        status = ended(robot, "m/1")
    assert isinstance(status, Succeeded)
    assert ("held mug" in status.state) is held
    assert CALLED[-1] == ("look", {"thing": "mug"})


def test_what_is_looked_at_when_needed_is_not_asked_with_every_look(tmp_path: Path) -> None:
    with robot_of(file_of("{call: drive}", more=GRASPED), tmp_path) as robot:
        robot.state()
        assert not CALLED
        found = robot.sense("m/look-1", ["held mug"], 5.0)
        assert found is not None
        assert found[0].holds is None  # the script gives no such field
        assert [sense.to_json() for sense in robot.senses] == [
            {"atom": "held {t}", "by": ["look"], "lasts": None, "needed": True}
        ]


class Camera(BaseHTTPRequestHandler):
    """Answers `GET /full/b`, and not before it was asked twice."""

    asked: ClassVar[list[str]] = []
    holds: ClassVar[object] = True

    def do_GET(self) -> None:
        self.asked.append(self.path)
        if len(self.asked) == 1:
            self.send_error(503)
            return
        body = json.dumps({"mug": self.holds}).encode()
        self.send_response(200)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, format: str, *args: object) -> None: ...  # noqa: A002 - its name there


@pytest.mark.parametrize("holds", [True, False, None])
def test_a_service_over_http_tells_of_a_fact_though_it_is_away_at_first(
    tmp_path: Path,
    holds: bool | None,  # noqa: FBT001 - what the service says
) -> None:
    Camera.asked.clear()
    Camera.holds = holds
    with ThreadingHTTPServer(("127.0.0.1", 0), Camera) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        url = f"http://127.0.0.1:{server.server_port}"
        more = (
            'facts:\n  "held {t}": {call: camera, with: {t: "{t}"}, when: {mug: true},'
            " unless: {mug: false}, needed: true, lasts: 600}\n"
        )
        text = file_of("{call: drive}", more=more).replace(
            "actions:",
            f'  camera: {{via: http, base: "{url}", begin: "GET /full/{{t}}"}}\nactions:',
            1,
        )
        with robot_of(text, tmp_path) as robot:
            found = robot.sense("m/look-1", ["held mug"], 60.0)
            believed = "held mug" in robot.state()
        server.shutdown()
    assert found is not None
    assert (found[0].holds, found[0].by) == (holds, "camera")
    assert believed is bool(holds)
    assert Camera.asked == ["/full/mug"] * 2
