"""`plainspoken serve` as others meet it: a process, tokens, and the examples of docs/serving.md."""

import os
import re
import secrets
import shutil
import socket
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from random import Random
from typing import Any

import httpx
import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

from plainspoken.web.access import Role, append_grant, new_grant

pytestmark = pytest.mark.timeout(300)

WIDE = "0.0.0.0"  # noqa: S104 - guarded by tokens, or refused
PAGE = Path(__file__).parents[2] / "docs" / "serving.md"
FENCED = re.compile(r"^```sh\n(.*?)^```", re.MULTILINE | re.DOTALL)


@dataclass
class Server:
    """A server that runs, its tokens, and what it has written."""

    base: str
    tokens: Mapping[str, str]
    written: Path
    process: subprocess.Popen[bytes]

    def headers(self, who: str) -> dict[str, str]:
        return {"Authorization": f"Bearer {self.tokens[who]}"}

    def get(self, path: str, who: str = "ada", **more: Any) -> httpx.Response:
        return httpx.get(self.base + path, headers=self.headers(who), timeout=60, **more)


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


def command(*arguments: str) -> list[str]:
    return [sys.executable, "-m", "plainspoken", *arguments]


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    folder: Path = tmp_path_factory.mktemp("serving")
    tokens = {}
    for role, name in ((Role.OPERATOR, "ada"), (Role.VIEWER, "vic")):
        tokens[name], grant = new_grant(role, name)
        append_grant(folder / "tokens", grant)
    port, written = free_port(), folder / "written"
    with written.open("wb") as file:
        kept = ["--tokens", str(folder / "tokens"), "--store", str(folder / "store.sqlite")]
        process = subprocess.Popen(
            command("serve", "--host", WIDE, "--port", str(port), *kept),
            stdout=file,
            stderr=subprocess.STDOUT,
            cwd=folder,
        )
    it = Server(f"http://127.0.0.1:{port}", tokens, written, process)
    try:
        wait_until_open(it)
        yield it
    finally:
        process.terminate()
        try:
            process.wait(60)
        finally:
            process.kill()


def wait_until_open(it: Server) -> None:
    deadline = time.monotonic() + 120
    while it.process.poll() is None and time.monotonic() < deadline:
        try:
            httpx.get(f"{it.base}/login", timeout=60)
        except httpx.TransportError:
            time.sleep(0.1)
        else:
            return
    raise AssertionError(it.written.read_text())


def test_the_examples_for_programmers_run_as_they_stand(server: Server, tmp_path: Path) -> None:
    if shutil.which("curl") is None:
        pytest.skip("there is no curl here")
    _, programs = PAGE.read_text().split("## For programs")
    script = "set -euo pipefail\n" + "\n".join(FENCED.findall(programs))
    assert script.count("$BASE") >= 12
    here = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    known = {"BASE": server.base, "TOKEN": server.tokens["ada"], "PATH": here}
    ran = subprocess.run(
        ["bash", "-c", script],
        cwd=tmp_path,
        env={**os.environ, **known},
        capture_output=True,
        text=True,
        timeout=280,
        check=False,
    )
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert '"status":"ok"' in ran.stdout
    assert "event: policy_chosen" not in ran.stdout  # it was behind Last-Event-ID
    assert (tmp_path / "run.jsonl").read_text().startswith('{"step":0,')


def test_the_page_is_shown_to_who_has_a_token_and_nobody_else(server: Server) -> None:
    browser = {"Accept": "text/html"}
    sent = httpx.get(server.base, headers=browser, timeout=60)
    assert (sent.status_code, sent.headers["location"]) == (303, "/login?next=%2F")
    with httpx.Client(base_url=server.base, headers=browser, timeout=60) as visitor:
        assert visitor.post("/login", data={"token": server.tokens["vic"]}).status_code == 303
        page = visitor.get("/")
    assert page.status_code == 200
    assert "frame-ancestors 'none'" in page.headers["content-security-policy"]
    assert server.tokens["vic"] not in page.text


def test_nothing_that_is_sent_to_the_page_breaks_it(server: Server) -> None:
    chance = Random(7)
    odd = ["/_nicegui_ws/socket.io/?EIO=4&transport=polling", "/_nicegui/client/x/upload/1",
           "/missions/%00", "/missions/../../etc/passwd", "/_nicegui/auto/static/..%2f..%2fx",
           "/" + "a" * 5000, "/?" + "x=1&" * 2000, "/_nicegui/3/components/%ff"]  # fmt: skip
    with httpx.Client(base_url=server.base, headers=server.headers("ada"), timeout=60) as client:
        for path in odd:
            for method in ("GET", "POST", "PUT", "OPTIONS"):
                body = chance.randbytes(2000) if method != "GET" else None
                answer = client.request(method, path, content=body)
                assert answer.status_code < 500, (method, path, answer.text[:300])
            upload = {"file": ("../../x\x00.wav", chance.randbytes(5000), "audio/wav")}
            assert client.post(path, files=upload).status_code < 500
        too_large = client.post("/_nicegui/client/x/upload/1", content=b"x" * 2_000_000)
        assert too_large.status_code == 413


SOCKET = "/_nicegui_ws/socket.io/?EIO=4&transport=websocket"
FRAMES = [
    *("", "0", "1", "2", "2probe", "3", "4", "40", "40{}", "40/x,", "41", "42", "42[]", "42{}"),
    *("42null", "45-1[]", "5", "6", "9", "\x00", "42" + "[" * 20_000, "\U0001d53d" * 900),
    *('42["handshake"]', '42["handshake",null]', '42["handshake",{}]', '42["handshake",[]]'),
    '42["handshake",{"client_id":[],"tab_id":1,"document_id":{}}]',
    *('42["event",{}]', '42["event",5]', '42["event",{"client_id":"x","id":0,"args":["{"]}]'),
    *('42["ack",{}]', '42["log",{"level":"x"}]', '42["javascript_response",{"client_id":"x"}]'),
    *('420["handshake",{"client_id":"x"}]', '451-["event",{"_placeholder":true,"num":0}]'),
]


def test_no_frame_of_a_websocket_breaks_the_server(server: Server) -> None:
    chance = Random(11)
    at = server.base.replace("http", "ws") + SOCKET
    for number in range(25):
        frames: list[str | bytes] = chance.sample(FRAMES, 12)
        frames += [chance.randbytes(chance.randrange(200)) for _ in range(3)]
        frames += ["".join(map(chr, chance.sample(range(1, 0xD7FF), 30)))]
        chance.shuffle(frames)
        with connect(at, additional_headers=server.headers("vic"), open_timeout=60) as link:
            try:
                for frame in (["40"] if number % 2 else []) + frames:
                    link.send(frame)
            except ConnectionClosed:
                continue
    assert server.get("/").status_code == 200
    assert server.process.poll() is None


def test_a_frame_that_is_too_large_closes_its_connection(server: Server) -> None:
    at = server.base.replace("http", "ws") + SOCKET
    with connect(at, additional_headers=server.headers("vic"), open_timeout=60) as link:
        with suppress(ConnectionClosed):
            link.send("4" + "x" * 3_000_000)
            list(link)
        with pytest.raises(ConnectionClosed):
            link.recv(timeout=60)
    assert server.get("/").status_code == 200


@pytest.mark.parametrize(
    ("who", "more"),
    [(None, {}), ("vic", {"Origin": "http://evil.example"}), ("vic", {"Host": "evil.example"})],
)  # fmt: skip
def test_a_websocket_of_a_stranger_is_not_opened(
    server: Server, who: str | None, more: dict[str, str]
) -> None:
    at = server.base.replace("http", "ws") + SOCKET
    shown = {**(server.headers(who) if who else {}), **more}
    with pytest.raises(InvalidStatus) as refused:
        connect(at, additional_headers=shown, open_timeout=60)
    assert refused.value.response.status_code == 403


def test_no_token_and_no_login_is_ever_written_down(server: Server) -> None:
    """Last, after all of the above."""
    wrong = f"ps-{secrets.token_urlsafe(32)}"
    with httpx.Client(base_url=server.base, timeout=60) as visitor:
        visitor.post("/login", data={"token": server.tokens["ada"]})
        login = visitor.cookies["plainspoken_login"]
        assert visitor.get("/").status_code == 200
        visitor.post("/login", data={"token": wrong})
    written = server.written.read_text(errors="replace")
    for secret in (*server.tokens.values(), login, login.rpartition(".")[2], wrong):
        assert secret not in written


def test_a_server_for_others_without_tokens_does_not_start(tmp_path: Path) -> None:
    for wide in (["--host", WIDE], ["--name", "farm.example"]):
        ran = subprocess.run(
            command("serve", *wide, "--store", str(tmp_path / "s.sqlite")),
            capture_output=True,
            text=True,
            timeout=120,
            check=False,
            env={key: text for key, text in os.environ.items() if key != "PLAINSPOKEN_TOKENS"},
        )
        assert ran.returncode == 2
        assert "could command the robots" in ran.stderr
        assert "Traceback" not in ran.stderr
