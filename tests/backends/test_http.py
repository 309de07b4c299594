"""A robot behind HTTP: the suite of all robots, and what is HTTP's own, over loopback."""

from __future__ import annotations

import json
import socket
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, closing
from email.message import Message
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
from tests.backends.activities.errands import ARRIVED, GO, GRASP, PROBLEM, robot_of
from tests.backends.http_bench import HttpBench
from tests.mission.conformance import RobotConformance, ended

from plainspoken.errors import InputFileError
from plainspoken.mission.robot import Failed, GoalStatus, Succeeded, Unreachable


class TestHttpRobot(RobotConformance):
    @pytest.fixture
    def bench(self, tmp_path: Path) -> Iterator[HttpBench]:
        with ExitStack() as stack:
            yield HttpBench(tmp_path, stack)


Answer = tuple[int, object]


class ScriptedServer:
    """Answers each request with the next of its answers; None breaks the connection."""

    def __init__(self) -> None:
        self.answers: list[Answer | None] = []
        self.by_method: dict[str, list[Answer | None]] = {}
        self.asked: list[tuple[str, str, object]] = []
        self.headers: list[Message] = []
        script = self

        class Handler(BaseHTTPRequestHandler):
            def _answer(self) -> None:
                body = self.rfile.read(int(self.headers.get("Content-Length", 0)))
                script.asked.append((self.command, self.path, json.loads(body or b"null")))
                script.headers.append(self.headers)
                answer = script.answer(self.command)
                if answer is None:
                    self.connection.shutdown(socket.SHUT_RDWR)
                    return
                status, said = answer
                content = said.encode() if isinstance(said, str) else json.dumps(said).encode()
                self.send_response(status)
                self.send_header("Content-Length", str(len(content)))
                self.end_headers()
                self.wfile.write(content)

            do_GET = do_POST = do_PUT = do_DELETE = _answer  # noqa: N815 - http.server's names

            def log_message(self, *_: object) -> None: ...

        self._server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.base = f"http://127.0.0.1:{self._server.server_port}"
        threading.Thread(target=self._server.serve_forever, args=(0.01,), daemon=True).start()

    @property
    def methods(self) -> list[str]:
        return [method for method, _, _ in self.asked]

    def answer(self, method: str) -> Answer | None:
        """The next answer; where some are for a method, the next of those."""
        return (self.by_method.get(method) or self.answers).pop(0)

    def close(self) -> None:
        self._server.shutdown()
        self._server.server_close()


@pytest.fixture
def server() -> Iterator[ScriptedServer]:
    with closing(ScriptedServer()) as server:
        yield server


LONG = (
    "begin: 'POST /drive', poll: 'GET /goals/{call}', going: {state: going}, "
    "cancel: 'DELETE /goals/{call}'"
)
SHORT = "begin: 'POST /drive'"


def outcome(
    server: ScriptedServer, folder: Path, service: str = LONG, call: str = "{call: drive}"
) -> GoalStatus:
    """What an action comes to that is one call of a service."""
    with robot_of(file_of(server.base, service, call), folder) as robot:
        robot.send("m/1", GO)
        return ended(robot, "m/1")


def file_of(base: str, service: str, call: str) -> str:
    return f"""\
http: {{base: "{base}", timeout: 1, headers: {{X-Key: "{{env.ROBOT_KEY}}"}}}}
services:
  drive: {{via: http, {service}}}
actions:
  go: {{do: {call}}}
{GRASP.replace("call: arm", "call: drive").replace('with: {thing: "{t}"}', WITH)}
"""


WITH = 'with: {to: "{p}"}'


@pytest.fixture(autouse=True)
def _key(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROBOT_KEY", "s3cret")


def test_fields_go_into_the_path_and_the_body_and_the_call_is_named(
    server: ScriptedServer, tmp_path: Path
) -> None:
    server.answers = [(200, {"fine": True})]
    service = "begin: 'POST /to/{to}/drive'"
    call = '{call: drive, with: {to: "{to}", fast: true, from: "{from}"}}'
    text = file_of(server.base, service, call)
    with robot_of(text, tmp_path) as robot:
        robot.send("m/1", GO)
        assert ended(robot, "m/1") == Succeeded(ARRIVED)
    assert server.asked == [("POST", "/to/kitchen/drive", {"fast": True, "from": "hall"})]
    assert server.headers[0]["Idempotency-Key"] == "m/1:0#1"
    assert server.headers[0]["X-Key"] == "s3cret"


def test_a_long_call_is_asked_about_until_it_has_ended(
    server: ScriptedServer, tmp_path: Path
) -> None:
    server.answers = [(202, {}), (200, {"state": "going"}), (200, {"state": "done"})]
    assert outcome(server, tmp_path) == Succeeded(ARRIVED)
    assert [each[:2] for each in server.asked] == [
        ("POST", "/drive"),
        *[("GET", "/goals/m%2F1%3A0%231")] * 2,
    ]


def test_the_robots_own_id_is_kept_for_whoever_takes_over(
    server: ScriptedServer, tmp_path: Path
) -> None:
    service = "begin: POST /drive, poll: 'GET /g/{id}', going: {state: going}, id: goal.id"
    server.answers = [(202, {"goal": {"id": 12}}), (200, {"state": "going"})]
    with robot_of(file_of(server.base, service, "{call: drive}"), tmp_path) as robot:
        robot.send("m/1", GO)
        while len(server.asked) < 2:
            robot.wait("m/1", 0.01)
    server.answers = [(200, {"state": "done"})]
    with robot_of(file_of(server.base, service, "{call: drive}"), tmp_path) as again:
        assert ended(again, "m/1") == Succeeded(ARRIVED)
    assert [each[1] for each in server.asked] == ["/drive", "/g/12", "/g/12"]


@pytest.mark.parametrize(
    ("answer", "reason"),
    [
        ((400, {"reason": "no such place"}), "refused with status 400: no such place"),
        ((409, {"detail": "busy"}), "refused with status 409: busy"),
        ((500, "a plain text"), "refused with status 500: a plain text"),
        ((422, ""), "refused with status 422: no reason given"),
    ],
)
@pytest.mark.parametrize("service", [LONG, SHORT])
def test_a_refusal_is_a_failure_with_what_the_server_says(
    answer: Answer, reason: str, service: str, server: ScriptedServer, tmp_path: Path
) -> None:
    server.answers = [answer]
    assert outcome(server, tmp_path, service) == Failed(reason, PROBLEM.initial)


@pytest.mark.parametrize("away", [(503, {}), (429, {}), None])
def test_a_server_that_cannot_answer_now_is_asked_again_and_not_told_again(
    away: Answer | None, server: ScriptedServer, tmp_path: Path
) -> None:
    server.answers = [(202, {}), away, (200, {"state": "done"})]
    with robot_of(file_of(server.base, LONG, "{call: drive}"), tmp_path) as robot:
        robot.send("m/1", GO)
        with pytest.raises(Unreachable, match="/goals/"):
            ended(robot, "m/1")
        assert ended(robot, "m/1") == Succeeded(ARRIVED)
    assert [each[0] for each in server.asked] == ["POST", "GET", "GET"]


def test_whether_a_lost_request_was_heard_is_asked_before_it_is_made_again(
    server: ScriptedServer, tmp_path: Path
) -> None:
    server.answers = [None, (404, {}), (202, {}), (200, {"state": "done"})]
    with robot_of(file_of(server.base, LONG, "{call: drive}"), tmp_path) as robot:
        robot.send("m/1", GO)
        with pytest.raises(Unreachable):
            ended(robot, "m/1")
        assert ended(robot, "m/1") == Succeeded(ARRIVED)
    assert [each[0] for each in server.asked] == ["POST", "GET", "POST", "GET"]


def test_a_lost_request_that_cannot_be_asked_about_is_not_made_again(
    server: ScriptedServer, tmp_path: Path
) -> None:
    server.answers = [None]
    status = outcome(server, tmp_path, SHORT)
    assert isinstance(status, Failed)
    assert "not known whether it was done" in status.reason
    assert len(server.asked) == 1


def test_a_cancellation_that_nobody_heard_is_made_again(
    server: ScriptedServer, tmp_path: Path
) -> None:
    going: Answer = (200, {"state": "going"})
    server.by_method = {"POST": [(202, {})], "GET": [going] * 9999, "DELETE": [None, (202, {})]}
    with robot_of(file_of(server.base, LONG, "{call: drive}"), tmp_path) as robot:
        robot.send("m/1", GO)
        while len(server.asked) < 2:
            robot.wait("m/1", 0.01)
        robot.cancel("m/1")
        until = time.monotonic() + 30
        while server.methods.count("DELETE") < 2 and time.monotonic() < until:
            robot.wait("m/1", 0.01)
    assert server.methods.count("DELETE") == 2


def test_a_call_that_the_server_has_forgotten_is_not_made_again(
    server: ScriptedServer, tmp_path: Path
) -> None:
    server.answers = [(202, {}), (200, {"state": "going"}), (404, {})]
    status = outcome(server, tmp_path)
    assert status == Failed("drive has forgotten the call", PROBLEM.initial)


def test_a_request_that_takes_too_long_is_a_lost_connection(tmp_path: Path) -> None:
    silent = socket.create_server(("127.0.0.1", 0))
    with (
        silent,
        robot_of(
            file_of(f"http://127.0.0.1:{silent.getsockname()[1]}", LONG, "{call: drive}"), tmp_path
        ) as robot,
    ):
        robot.send("m/1", GO)
        before = time.monotonic()
        with pytest.raises(Unreachable, match="timed out"):
            ended(robot, "m/1")
        assert time.monotonic() - before < 5


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("POST /drive", "SEND /drive", "a method and a path"),
        ("POST /drive", "POST drive", "a method and a path"),
        ("POST /drive", "POST /drive/{to}", "needs the fields to"),
        ("{call}", "{robot}", "only {call} and {id}"),
        ("http://", "ftp://", "an address such as http"),
        ("{env.ROBOT_KEY}", "{env.NO_SUCH_KEY}", "no env.NO_SUCH_KEY"),
        ("begin:", "start:", "no key 'start'"),
        ("timeout: 1", "timeout: 0", "greater than 0"),
    ],
)
def test_settings_that_cannot_be_are_refused_with_their_line(
    old: str, new: str, said: str, tmp_path: Path
) -> None:
    text = file_of("http://robot:1", LONG, "{call: drive}")
    assert old in text
    with (
        pytest.raises(InputFileError) as caught,
        robot_of(text.replace(old, new), tmp_path),
    ):
        pass
    assert said in f"{caught.value.what} {caught.value.hint}"
    assert caught.value.line is not None
    assert "s3cret" not in str(caught.value)
