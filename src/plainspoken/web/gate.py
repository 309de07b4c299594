"""The gate before everything that is served, to pages, programs and websockets alike.

In this order: is it called by one of our names, from a page of ours, with a body that is not too
large; who is it; do they ask too often. What comes through carries who it is in its scope, under
`CALLER`, and what tells whether they still may, under `STILL`: whatever stays open asks that now
and then, so that it ends with the login or the token that it came in with.
"""

from __future__ import annotations

import asyncio
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from http.cookies import CookieError, SimpleCookie
from urllib.parse import quote

from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import HTTPConnection
from starlette.responses import RedirectResponse, Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from plainspoken.errors import PlainspokenError
from plainspoken.web.access import Access, Caller
from plainspoken.web.address import Names, is_same_origin
from plainspoken.web.hearing import MOST_BYTES
from plainspoken.web.problem import Problem, refusal, response_of
from plainspoken.web.rate import Rate, Rates, Seats, TooManyError

CALLER = "plainspoken.caller"
COOKIE = "plainspoken_login"
STILL = "plainspoken.still"
LOGIN, LOGOUT = "/login", "/logout"
API = "/api/"
SPEECH = "/api/v1/transcripts"
STATIC = "/_nicegui/"
"""Files of the page's framework: the same for everyone, and many for each page."""

REQUESTS = Rate("requests", 50, 200)
REFUSALS = Rate("wrong tokens", 0.2, 10)
FRAMES = Rate("messages on this connection", 100, 1000)

KILOBYTE = 1024
LOOK_AGAIN = 10.0
"""Seconds after which it is looked whether somebody still may be in."""
BODY_WITHIN = 30.0
"""Seconds in which a body has to be here."""
CLOSED_POLICY, CLOSED_LOGIN = 1008, 4401

_PAGE_POLICY = (
    # NiceGUI draws elements from scripts in its page, and evaluates what it is sent to run.
    "default-src 'self'; script-src 'self' 'unsafe-inline' 'unsafe-eval'; "
    "style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; font-src 'self' data:; "
    "media-src 'self' blob:; worker-src 'self' blob:; connect-src 'self'; object-src 'none'; "
    "base-uri 'none'; form-action 'self'; frame-ancestors 'none'"
)
_API_POLICY = "default-src 'none'; frame-ancestors 'none'"
_HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Referrer-Policy": "same-origin",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Permissions-Policy": "microphone=(self), camera=(), geolocation=()",
}
_PATH = re.compile(r"[^\x00-\x1f\x7f]*")
_FORWARDED = ("forwarded", "x-forwarded-for", "x-forwarded-host", "x-real-ip")


@dataclass(frozen=True)
class Limits:
    """How much is taken in.

    bodies: bytes of a body by the beginning of its path; the longest that fits counts
    """

    bodies: Mapping[str, int] = field(
        default_factory=lambda: {
            "/": 1024 * KILOBYTE,
            API: 64 * KILOBYTE,
            SPEECH: MOST_BYTES,
            LOGIN: 4 * KILOBYTE,
        }
    )

    def body(self, path: str) -> int:
        """How large a body may be there."""
        return self.bodies[max((each for each in self.bodies if path.startswith(each)), key=len)]


class Gate:
    """Lets in what may come in."""

    def __init__(
        self,
        app: ASGIApp,
        access: Access,
        names: Names,
        *,
        limits: Limits | None = None,
        rates: Rates | None = None,
    ) -> None:
        """Put a gate before an application."""
        self._app = app
        self._access = access
        self._names = names
        self._limits = limits or Limits()
        self._rates = rates or Rates()
        self._sockets = Seats("connections", total=512, each=128)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve one request, or one websocket."""
        if scope["type"] == "http":
            await self._http(scope, receive, _with_headers(scope, send))
        elif scope["type"] == "websocket":
            await self._websocket(scope, receive, send)
        else:
            await self._app(scope, receive, send)

    # -- requests ------------------------------------------------------------------------------

    async def _http(self, scope: Scope, receive: Receive, send: Send) -> None:
        refused = self._stranger(scope)
        caller = None
        if refused is None and not _PATH.fullmatch(scope["path"]):  # routes do not match it either
            refused = refusal(400, Problem(what="an address has no control characters"))
        if refused is None:
            caller, refused = self._known(scope)
        if refused is not None:
            await refused(scope, receive, send)
            return
        body = await _body(scope, receive, self._limits.body(scope["path"]))
        if isinstance(body, Response):
            await body(scope, receive, send)
            return
        scope[CALLER], scope[STILL] = caller, self._still(scope)
        await self._app(scope, _once(body, receive), send)

    def _stranger(self, scope: Scope) -> Response | None:
        """A refusal of what came by another name, or from the page of somebody else."""
        headers = Headers(scope=scope)
        hosts, origins = headers.getlist("host"), headers.getlist("origin")
        host = hosts[0] if len(hosts) == 1 else None  # who says two things hides one of them
        if not self._names.cover(host):
            return _forbidden(
                "this server is not called by that name",
                f"Host: {', '.join(hosts)}",
                "use the address that it prints, or start it with --name for a name of yours",
            )
        foreign = [origin for origin in origins if not is_same_origin(origin, host)]
        if foreign:
            return _forbidden("the page of another site asks", f"Origin: {foreign[0]}", None)
        crossed = headers.get("sec-fetch-site") == "cross-site"
        if crossed and not (
            headers.get("sec-fetch-mode") == "navigate" and scope.get("method") in ("GET", "HEAD")
        ):
            return _forbidden("the page of another site asks", "Sec-Fetch-Site", None)
        if self._access.is_open and any(name in headers for name in _FORWARDED):
            return _forbidden(
                "a proxy brings strangers to a server that asks nobody for a token",
                "X-Forwarded-For",
                "start it with --tokens FILE",
            )
        return None

    def _known(self, scope: Scope) -> tuple[Caller | None, Response | None]:
        """Who it is, or a refusal."""
        path = scope["path"]
        try:
            caller = self._caller(scope)
            if caller is None and path != LOGIN:
                if _shows_something(scope):
                    self._rates.spend(REFUSALS, address_of(scope))
                return None, _unknown(scope)
            if not path.startswith(STATIC):
                self._rates.spend(REQUESTS, self._who(scope, caller))
        except PlainspokenError as error:  # the file of tokens may have become unusable
            return None, response_of(error)
        return caller, None

    def _caller(self, scope: Scope) -> Caller | None:
        """Who it is: by a token, else by a login."""
        headers = Headers(scope=scope)
        shown = headers.get("authorization", "")
        if self._access.is_open:
            return self._access.anyone()
        if shown:
            kind, _, token = shown.partition(" ")
            return self._access.by_token(token.strip()) if kind.lower() == "bearer" else None
        cookie = login_cookie(headers)
        return None if cookie is None else self._access.by_cookie(cookie)

    def _still(self, scope: Scope) -> Callable[[], bool]:
        def still() -> bool:
            try:
                return self._caller(scope) is not None
            except PlainspokenError:
                return False

        return still

    def _who(self, scope: Scope, caller: Caller | None) -> str:
        known = caller is not None and not self._access.is_open
        return f"name {caller.name}" if known and caller else f"address {address_of(scope)}"

    # -- websockets ----------------------------------------------------------------------------

    async def _websocket(self, scope: Scope, receive: Receive, send: Send) -> None:
        caller = None
        if self._stranger(scope) is None:
            caller, _ = self._known(scope)
        if caller is None:
            await receive()
            await send({"type": "websocket.close", "code": CLOSED_POLICY})
            return
        who = self._who(scope, caller)
        try:
            with self._sockets.seat(who):
                scope[CALLER] = caller
                frames = _Frames(receive, send, self._still(scope))
                await self._app(scope, frames.next, frames.send)
        except TooManyError:
            await receive()
            await send({"type": "websocket.close", "code": CLOSED_POLICY})


class _Frames:
    """The messages of a websocket, until there are too many, or the login ends."""

    def __init__(self, receive: Receive, send: Send, still: Callable[[], bool]) -> None:
        self._receive, self._send, self._still = receive, send, still
        self._next: asyncio.Future[Message] | None = None
        self._rates = Rates()
        self._closed = False

    async def next(self) -> Message:
        """The next message; that it is closed, where it is to end."""
        self._next = self._next or asyncio.ensure_future(self._receive())
        try:
            while not self._next.done():
                await asyncio.wait({self._next}, timeout=LOOK_AGAIN)
                if not self._still():
                    return await self._close(CLOSED_LOGIN)
            message, self._next = self._next.result(), None
            if message["type"] == "websocket.receive":
                self._rates.spend(FRAMES, "")
        except TooManyError:
            return await self._close(CLOSED_POLICY)
        except asyncio.CancelledError:
            if self._next is not None:
                self._next.cancel()
            raise
        return message

    async def send(self, message: Message) -> None:
        """Pass a message on, as long as there is somebody to hear it."""
        if not self._closed:
            await self._send(message)

    async def _close(self, code: int) -> Message:
        if self._next is not None:
            self._next.cancel()
        await self.send({"type": "websocket.close", "code": code})
        self._closed = True
        return {"type": "websocket.disconnect", "code": code}


def login_cookie(headers: Headers) -> str | None:
    """The login that a browser shows."""
    try:
        found = SimpleCookie(headers.get("cookie", "")).get(COOKIE)
    except CookieError:
        return None
    return None if found is None else found.value


def _shows_something(scope: Scope) -> bool:
    headers = Headers(scope=scope)
    return "authorization" in headers or login_cookie(headers) is not None


def address_of(scope: Scope) -> str:
    """Where somebody calls from."""
    client = scope.get("client")
    return client[0] if client else "unknown"


def _forbidden(what: str, where: str, hint: str | None) -> Response:
    return refusal(403, Problem(what=what, where=where, hint=hint))


def _unknown(scope: Scope) -> Response:
    """Ask a person to log in, and a program to show a token."""
    if scope["type"] == "http" and not scope["path"].startswith(API):
        accepts = HTTPConnection(scope).headers.get("accept", "")
        if scope["method"] in ("GET", "HEAD") and "text/html" in accepts:
            back = scope["path"] + ("?" + scope["query_string"].decode("latin-1")).rstrip("?")
            return RedirectResponse(f"{LOGIN}?next={quote(back, safe='')}", 303)
    problem = Problem(
        what="nobody is let in without a token, or with a wrong one",
        where="header Authorization",
        hint="Authorization: Bearer TOKEN; whoever started the server gives tokens",
    )
    return refusal(401, problem, {"WWW-Authenticate": "Bearer"})


async def _body(scope: Scope, receive: Receive, most: int) -> bytes | Response:
    """The whole body, or the refusal of one that is too large or does not come."""
    too_large = refusal(
        413,
        Problem(what=f"a body of more than {most} bytes is not taken here", where=scope["path"]),
        {"Connection": "close"},
    )
    length = Headers(scope=scope).get("content-length", "0")
    if not length.isdecimal():
        return refusal(400, Problem(what="no length of a body", where="header Content-Length"))
    if int(length) > most:
        return too_large
    found = bytearray()
    try:
        async with asyncio.timeout(BODY_WITHIN):
            more = True
            while more:
                message = await receive()
                if message["type"] == "http.disconnect":
                    break
                found += message.get("body", b"")
                more = message.get("more_body", False)
                if len(found) > most:
                    return too_large
    except TimeoutError:
        what = f"the body was not here within {BODY_WITHIN:.0f} s"
        return refusal(408, Problem(what=what), {"Connection": "close"})
    return bytes(found)


def _once(body: bytes, receive: Receive) -> Receive:
    """What was read already, then whatever comes."""
    waiting: list[Message] = [{"type": "http.request", "body": body, "more_body": False}]

    async def following() -> Message:
        return waiting.pop() if waiting else await receive()

    return following


def _with_headers(scope: Scope, send: Send) -> Send:
    """Sends the headers that keep a browser from helping others."""
    api = scope["path"].startswith(API)

    async def sending(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = MutableHeaders(scope=message)
            for name, value in _HEADERS.items():
                headers.setdefault(name, value)
            headers.setdefault("Content-Security-Policy", _API_POLICY if api else _PAGE_POLICY)
            if not scope["path"].startswith(STATIC):
                headers["Cache-Control"] = "no-store"
        await send(message)

    return sending
