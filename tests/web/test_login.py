import pytest
from hypothesis import given
from hypothesis import strategies as st
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import Route
from starlette.testclient import TestClient
from tests.web.bench import HERE, granted

from plainspoken.web.access import Access, Role
from plainspoken.web.address import Names
from plainspoken.web.gate import CALLER, COOKIE, REFUSALS, Gate
from plainspoken.web.login import local, login_routes


async def tell(request: Request) -> Response:
    return PlainTextResponse(request.scope[CALLER].name)


def client(access: Access, base: str = HERE) -> TestClient:
    routes = [*login_routes(access), Route("/{path:path}", tell)]
    inside = Gate(Starlette(routes=routes), access, Names.of("127.0.0.1"))
    return TestClient(inside, base, follow_redirects=False)


def test_a_person_logs_in_goes_where_they_were_going_and_leaves() -> None:
    tokens, access = granted((Role.OPERATOR, "ada"))
    browser = client(access)
    assert '<input id="token"' in browser.get("/login?next=/missions/m").text
    come = browser.post("/login", data={"token": tokens["ada"], "next": "/missions/m"})
    assert (come.status_code, come.headers["location"]) == (303, "/missions/m")
    assert browser.get("/").text == "ada"
    cookie = browser.cookies[COOKIE]
    assert browser.post("/logout").headers["location"] == "/login"
    assert browser.get("/").status_code == 401
    assert client(access).get("/", headers={"Cookie": f"{COOKIE}={cookie}"}).status_code == 401


@pytest.mark.parametrize("scheme", ["http", "https"])
def test_no_script_reads_the_login_and_no_other_site_sends_it(scheme: str) -> None:
    tokens, access = granted((Role.OPERATOR, "ada"))
    browser = client(access, f"{scheme}://127.0.0.1:8765")
    set_cookie = browser.post("/login", data={"token": tokens["ada"]}).headers["set-cookie"].lower()
    assert "httponly" in set_cookie
    assert "samesite=lax" in set_cookie
    assert f"max-age={12 * 3600}" in set_cookie
    assert ("secure" in set_cookie) == (scheme == "https")
    assert tokens["ada"].lower() not in set_cookie


def test_a_wrong_token_is_told_and_after_some_not_even_tried() -> None:
    _, access = granted((Role.OPERATOR, "ada"))
    browser = client(access)
    for _ in range(int(REFUSALS.at_once)):
        wrong = browser.post("/login", data={"token": "<script>alert(1)</script>"})
        assert wrong.status_code == 401
        assert "There is no such token" in wrong.text
        assert "<script>" not in wrong.text
    late = browser.post("/login", data={"token": "ps-x"})
    assert late.status_code == 429
    assert int(late.headers["retry-after"]) >= 1


@pytest.mark.parametrize("content", [b"", b"\xff\xfe", b"token", b"token=%ff&token=%00", b"=&&="])
def test_an_odd_form_is_a_wrong_token(content: bytes) -> None:
    _, access = granted((Role.OPERATOR, "ada"))
    assert client(access).post("/login", content=content).status_code == 401


def test_the_form_of_another_site_is_refused() -> None:
    tokens, access = granted((Role.OPERATOR, "ada"))
    sent = client(access).post(
        "/login", data={"token": tokens["ada"]}, headers={"Origin": "http://evil.example"}
    )
    assert sent.status_code == 403


def test_where_nobody_needs_a_token_there_is_nothing_to_log_in_to() -> None:
    assert client(Access(None)).get("/login").headers["location"] == "/"


@pytest.mark.parametrize(
    "path", ["https://evil.example", "//evil.example", "/\\evil.example", "", "evil", "/a\r\nX: y"]
)
def test_nobody_is_led_elsewhere(path: str) -> None:
    assert local(path) == "/"


@given(st.text())
def test_what_a_person_is_led_to_is_a_path_of_ours(path: str) -> None:
    assert local(path).startswith("/")
    assert not local(path).startswith("//")
