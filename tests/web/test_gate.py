import asyncio
from collections.abc import AsyncIterator
from contextlib import suppress
from typing import Any

import pytest
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import Route, WebSocketRoute
from starlette.testclient import TestClient
from starlette.websockets import WebSocket, WebSocketDisconnect
from tests.web.bench import HERE, granted

from plainspoken.web import gate
from plainspoken.web.access import Access, Role
from plainspoken.web.address import Names
from plainspoken.web.gate import CALLER, COOKIE, REFUSALS, REQUESTS, STATIC, Gate
from plainspoken.web.rate import Rate, Rates

SOCKET = HERE.replace("http", "ws") + "/socket"
OPEN = Access(None, everyone="ada")


async def tell(request: Request) -> Response:
    return PlainTextResponse(f"{request.scope[CALLER].name} sent {len(await request.body())}")


async def echo(socket: WebSocket) -> None:
    await socket.accept()
    with suppress(WebSocketDisconnect):
        while True:
            await socket.send_text(f"{socket.scope[CALLER].name}: {await socket.receive_text()}")


def client(access: Access = OPEN, *, now: list[float] | None = None, **more: Any) -> TestClient:
    inside = Starlette(
        routes=[
            WebSocketRoute("/socket", echo),
            Route("/{path:path}", tell, methods=["GET", "POST"]),
        ]
    )
    rates = Rates(lambda: now[0]) if now else Rates()
    return TestClient(Gate(inside, access, Names.of("127.0.0.1"), rates=rates), HERE, **more)


def bearer(token: str) -> dict[str, str]:
    return {"Authorization": f"Bearer {token}"}


def test_without_tokens_everyone_on_this_computer_comes_in() -> None:
    assert client().get("/").text == "ada sent 0"


@pytest.mark.parametrize(
    "headers",
    [{"Host": "evil.example"}, {"Origin": "http://evil.example"}, {"Origin": "null"},
     {"Origin": "http://127.0.0.1:3000"}, {"Sec-Fetch-Site": "cross-site"},
     {"X-Forwarded-For": "192.168.1.9"}, {"Forwarded": "for=192.168.1.9"}],
)  # fmt: skip
def test_pages_and_names_of_others_are_kept_out_of_requests_and_websockets(
    headers: dict[str, str],
) -> None:
    refused = client().post("/", headers=headers)
    assert refused.status_code == 403
    assert set(refused.json()) == {"what", "where", "hint", "unseen"}
    with pytest.raises(WebSocketDisconnect), client().websocket_connect(SOCKET, headers=headers):
        pass


def test_a_page_of_ours_comes_in() -> None:
    assert client().post("/", headers={"Origin": HERE}).status_code == 200
    with client().websocket_connect(SOCKET, headers={"Origin": HERE}) as socket:
        socket.send_text("hello")
        assert socket.receive_text() == "ada: hello"


def test_a_link_from_elsewhere_opens_the_page() -> None:
    headers = {"Sec-Fetch-Site": "cross-site", "Sec-Fetch-Mode": "navigate"}
    assert client().get("/", headers=headers).status_code == 200
    assert client().post("/", headers=headers).status_code == 403


def test_with_tokens_nobody_comes_in_without_one() -> None:
    tokens, access = granted((Role.VIEWER, "vic"))
    outside = client(access, follow_redirects=False)
    assert outside.get("/api/v1/missions").status_code == 401
    assert outside.get("/", headers=bearer("ps-made-up")).status_code == 401
    assert outside.get("/", headers={"Authorization": f"Basic {tokens['vic']}"}).status_code == 401
    assert outside.get("/", headers=bearer(tokens["vic"])).text == "vic sent 0"
    with pytest.raises(WebSocketDisconnect), outside.websocket_connect(SOCKET):
        pass


def test_a_person_is_asked_to_log_in_and_brought_back() -> None:
    _, access = granted((Role.VIEWER, "vic"))
    outside = client(access, follow_redirects=False)
    sent = outside.get("/missions/m?at=3", headers={"Accept": "text/html"})
    assert (sent.status_code, sent.headers["location"]) == (
        303,
        "/login?next=%2Fmissions%2Fm%3Fat%3D3",
    )


def test_a_login_opens_pages_and_websockets() -> None:
    tokens, access = granted((Role.OPERATOR, "ada"))
    found = access.login(tokens["ada"])
    assert found is not None
    inside = client(access, cookies={COOKIE: found[0]})
    assert inside.get("/").text == "ada sent 0"
    with inside.websocket_connect(SOCKET) as socket:
        socket.send_text("hello")
        assert socket.receive_text() == "ada: hello"


def test_a_websocket_is_closed_when_its_login_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(gate, "LOOK_AGAIN", 0.01)
    tokens, access = granted((Role.OPERATOR, "ada"))
    found = access.login(tokens["ada"])
    assert found is not None
    with client(access, cookies={COOKIE: found[0]}).websocket_connect(SOCKET) as socket:
        socket.send_text("hello")
        assert socket.receive_text() == "ada: hello"
        access.logout(found[0])
        with pytest.raises(WebSocketDisconnect) as closed:
            socket.receive_text()
    assert closed.value.code == gate.CLOSED_LOGIN


def test_a_websocket_that_chatters_is_closed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(gate, "FRAMES", Rate("messages", a_second=0.001, at_once=5))
    with client().websocket_connect(SOCKET) as socket:
        for _ in range(5):
            socket.send_text("hello")
            assert socket.receive_text() == "ada: hello"
        socket.send_text("hello")
        with pytest.raises(WebSocketDisconnect) as closed:
            socket.receive_text()
    assert closed.value.code == gate.CLOSED_POLICY


def test_a_body_that_is_too_large_is_refused_before_it_is_read() -> None:
    inside = client()
    assert inside.post("/api/v1/x", content=b"x" * 64 * 1024).status_code == 200
    refused = inside.post("/api/v1/x", content=b"x" * (64 * 1024 + 1))
    assert refused.status_code == 413
    assert "65536 bytes" in refused.json()["what"]


def test_a_body_of_no_stated_length_is_cut_off_too() -> None:
    async def endless() -> AsyncIterator[bytes]:
        while True:
            yield b"x" * 10_000

    sent: list[dict[str, Any]] = []

    async def post() -> None:
        chunks = endless()

        async def receive() -> dict[str, Any]:
            return {"type": "http.request", "body": await anext(chunks), "more_body": True}

        async def send(message: Any) -> None:
            sent.append(message)

        scope = {
            "type": "http", "method": "POST", "path": "/api/v1/x", "query_string": b"",
            "headers": [(b"host", b"127.0.0.1")], "client": ("127.0.0.1", 5), "scheme": "http",
        }  # fmt: skip
        await asyncio.wait_for(client().app(scope, receive, send), 60)

    asyncio.run(post())
    assert sent[0]["status"] == 413


def test_a_body_that_never_comes_is_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(gate, "BODY_WITHIN", 0.01)
    sent: list[dict[str, Any]] = []

    async def post() -> None:
        async def receive() -> dict[str, Any]:
            await asyncio.Event().wait()
            raise AssertionError

        async def send(message: Any) -> None:
            sent.append(message)

        scope = {
            "type": "http", "method": "POST", "path": "/x", "query_string": b"",
            "headers": [(b"host", b"127.0.0.1")], "client": ("127.0.0.1", 5), "scheme": "http",
        }  # fmt: skip
        await asyncio.wait_for(client().app(scope, receive, send), 60)

    asyncio.run(post())
    assert sent[0]["status"] == 408


def test_whoever_asks_too_often_is_told_when_to_come_again() -> None:
    now = [0.0]
    inside = client(now=now)
    for _ in range(int(REQUESTS.at_once)):
        assert inside.get("/").status_code == 200
    refused = inside.get("/")
    assert (refused.status_code, refused.headers["retry-after"]) == (429, "1")
    assert inside.get(f"{STATIC}3/nicegui.js").status_code == 200
    now[0] += 1
    assert inside.get("/").status_code == 200


def test_wrong_tokens_become_too_many_and_right_ones_still_open() -> None:
    tokens, access = granted((Role.VIEWER, "vic"))
    outside = client(access, now=[0.0])
    seen = [outside.get("/", headers=bearer("ps-made-up")).status_code for _ in range(12)]
    assert seen == [401] * int(REFUSALS.at_once) + [429] * 2
    assert outside.get("/", headers=bearer(tokens["vic"])).status_code == 200


def test_a_browser_is_told_to_help_nobody_else() -> None:
    page, api = client().get("/").headers, client().get("/api/v1/x").headers
    assert "frame-ancestors 'none'" in page["content-security-policy"]
    assert "'self'" in page["content-security-policy"]
    assert api["content-security-policy"].startswith("default-src 'none'")
    for headers in (page, api):
        assert headers["x-content-type-options"] == "nosniff"
        assert headers["x-frame-options"] == "DENY"
        assert headers["cache-control"] == "no-store"


def test_a_broken_cookie_is_no_login() -> None:
    _, access = granted((Role.VIEWER, "vic"))
    for cookie in (b"=;=", b"plainspoken_login=..", b'plainspoken_login="\\', b"\xff=\xfe"):
        shown = {b"Cookie": cookie}
        assert client(access).get("/api/x", headers=shown).status_code == 401


def test_an_address_with_control_characters_is_refused_in_our_form() -> None:
    for path in ("/a%0Ab", "/api/v1/missions/%00", "/%7F"):
        refused = client().get(path)
        assert (refused.status_code, "control" in refused.json()["what"]) == (400, True)
