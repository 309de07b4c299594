"""Robots whose services are HTTP requests with JSON, long ones asked about until they end.

    http: {base: "http://127.0.0.1:8800", timeout: 5, headers: {X-Key: "{env.ROBOT_KEY}"}}
    services:
      drive:
        via: http
        begin: POST /robots/{h}/drive     # fields that the path does not take make the body
        poll: GET /goals/{call}           # without it, the answer to `begin` is the result
        going: {state: [accepted, driving]}
        cancel: DELETE /goals/{call}
        id: goal.id                       # where the robot gives ids of its own: then {id}

Each `begin` carries the call's id as `Idempotency-Key`. What a status means: 2xx is an answer;
408, 425, 429, 502, 503, 504 and a broken connection are "unreachable"; 404 and 410 to a poll mean
that the robot has no such call; any other is a refusal, whose text is the reason.

Python's own client does: a handful of small requests a second, in threads of their own.
"""

from __future__ import annotations

import http.client
import json
import os
import re
import urllib.error
import urllib.request
from collections.abc import Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import Any
from urllib.parse import quote, urlsplit

from plainspoken.backends.activities.adapter import COMMON, Around
from plainspoken.backends.activities.document import Section, Value
from plainspoken.backends.activities.journal import Journal
from plainspoken.backends.activities.reading import expected
from plainspoken.mission.robot import Seconds, Unheard, Unreachable
from plainspoken.mission.service import CallId, CallStatus, Done, Fields, Going, NotDone
from plainspoken.mission.template import UnfilledError, filled, meets, paths_in, value_at

PATIENCE: Seconds = 5.0
"""How long a request may take, where nobody says."""
AT_ONCE = 8
"""Requests that are under way at the same time."""
AWAY = frozenset({408, 425, 429, 502, 503, 504})
"""Statuses by which a server says that it, or its robot, cannot answer now."""
GONE = frozenset({404, 410})
_REQUEST = re.compile(r"(GET|POST|PUT|PATCH|DELETE) (\S+)")


@dataclass(frozen=True, slots=True)
class Request:
    """A request as a template: `POST /robots/{h}/drive`."""

    method: str
    path: str

    @property
    def does_something(self) -> bool:
        """Whether it may not simply be made again; `GET` only reads."""
        return self.method != "GET"

    @property
    def named(self) -> frozenset[str]:
        """The fields that go into the path."""
        return frozenset(path.partition(".")[0] for path in paths_in(self.path))


@dataclass(frozen=True)
class Reply:
    """What came back; body: the JSON, under `value` where it is no object."""

    status: int
    body: Mapping[str, Any]

    @property
    def reason(self) -> str:
        """What it says against a request, for people."""
        told = next((self.body[key] for key in TELLING if self.body.get(key)), None)
        text = str(told if told is not None else dict(self.body) or "no reason given")
        return f"refused with status {self.status}: {text}"


TELLING = ("reason", "message", "error", "detail", "value")
"""Where servers put their reasons."""


def open_adapter(settings: Section | None, around: Around) -> HttpAdapter:
    """The adapter, with what the file says under `http`."""
    base, patience, headers = "", PATIENCE, {}
    if settings is not None:
        settings.only("base", "timeout", "headers")
        given = settings.get("base")
        base = "" if given is None else _base(given)
        patience = settings.positive("timeout", PATIENCE)
        headers = _headers(settings)
    return HttpAdapter(base, patience, headers, around.journal)


@dataclass
class HttpAdapter:
    """Makes services that share a pool of connections."""

    base: str
    patience: Seconds
    headers: Mapping[str, str]
    journal: Journal
    pool: ThreadPoolExecutor = field(
        default_factory=lambda: ThreadPoolExecutor(AT_ONCE, thread_name_prefix="http robot")
    )

    def service(self, settings: Section) -> HttpService:
        settings.only(*COMMON, "base", "begin", "poll", "cancel", "going", "id")
        own = settings.get("base")
        base = self.base if own is None else _base(own)
        if not base:
            raise settings.at.error(
                "the key 'base' is missing", "give it here, or once for all under `http`"
            )
        going, id = settings.get("going"), settings.get("id")
        poll, cancel = settings.get("poll"), settings.get("cancel")
        begin = _request(settings.need("begin", "the request, such as POST /drive"))
        for value in (poll, cancel):
            if value is not None and not _request(value).named <= {"call", "id"}:
                raise value.error("there is only {call} and {id} to name", "and no field of a call")
        return HttpService(
            self,
            base,
            begin,
            poll=None if poll is None else _request(poll),
            cancelling=None if cancel is None else _request(cancel),
            going={} if going is None else expected(going),
            id=None if id is None else id.text(),
        )

    def asked(self, request: Request, url: str, body: Any, call: CallId) -> Reply:
        """Make a request, and wait for what comes back.

        raises Unreachable: when nothing does, or that nobody can answer now
        """
        headers = {"Accept": "application/json", **self.headers}
        content = None
        if request.method in ("POST", "PUT", "PATCH"):
            content = json.dumps(body).encode()
            headers |= {"Content-Type": "application/json", "Idempotency-Key": call}
        asked = urllib.request.Request(  # noqa: S310 - _base let only http and https in
            url, content, headers, method=request.method
        )
        try:
            with urllib.request.urlopen(asked, timeout=self.patience) as answer:  # noqa: S310
                return Reply(answer.status, _read(answer.read()))
        except urllib.error.HTTPError as error:
            with error:
                reply = Reply(error.code, _read(error.read()))
            if error.code in AWAY:
                raise Unreachable(f"{url}: {reply.reason}") from error
            return reply
        except (OSError, http.client.HTTPException) as error:
            reason = getattr(error, "reason", error)
            never = isinstance(reason, ConnectionRefusedError)
            raise (NeverSent if never else Unreachable)(f"{url}: {reason}") from error

    def close(self) -> None:
        self.pool.shutdown(wait=False, cancel_futures=True)


class NeverSent(Unreachable):
    """Nobody listened, so nobody heard it."""


class HttpService:
    """One kind of request, with how to ask about it and how to give it up."""

    def __init__(
        self,
        adapter: HttpAdapter,
        base: str,
        begin: Request,
        *,
        poll: Request | None,
        cancelling: Request | None,
        going: Mapping[str, Any],
        id: str | None,
    ) -> None:
        self._adapter = adapter
        self._base = base
        self._begin, self._poll, self._cancelling = begin, poll, cancelling
        self._going = going
        self._id = id
        self._begun: dict[CallId, Future[Reply]] = {}
        self._asked: dict[CallId, Future[Reply]] = {}
        self._last: dict[CallId, Going] = {}
        self._cancelled: dict[CallId, Future[Reply]] = {}
        self._ended: dict[CallId, Done | NotDone] = {}

    def objection(self, fields: Fields) -> str | None:
        missing = sorted(self._begin.named - set(fields) - {"call"})
        if missing:
            return f"the path {self._begin.path} needs the fields {', '.join(missing)}"
        return None

    def begin(self, call: CallId, fields: Fields) -> None:
        if call in self._cancelled:  # a look that was given up, and is wanted again
            for known in (self._begun, self._asked, self._last, self._cancelled, self._ended):
                known.pop(call, None)
        if call not in self._begun and call not in self._ended:
            path = self._begin.named
            body = {key: value for key, value in fields.items() if key not in path}
            values = {**fields, "call": call}
            self._begun[call] = self._submitted(self._begin, values, body, call)

    def status(self, call: CallId) -> CallStatus:
        if call in self._ended:
            return self._ended[call]
        cancelled = self._cancelled.get(call)
        if cancelled is not None and cancelled.done() and cancelled.exception() is not None:
            self.cancel(call)  # nobody answered: what is not heard is not given up
        begun = self._begun.get(call)
        if begun is not None and not begun.done():
            return Going({}, heard=False)
        try:
            found = self._news(call, begun)
        except NeverSent:
            self._begun.pop(call, None)
            raise
        if isinstance(found, Done | NotDone):
            self._ended[call] = found
        return found

    def cancel(self, call: CallId) -> None:
        values = self._values(call)
        if self._cancelling is not None and call not in self._ended and values is not None:
            self._cancelled[call] = self._submitted(self._cancelling, values, {}, call)

    def reach(self) -> None:
        """Any answer will do, a refusal too."""
        self._adapter.asked(Request("GET", "/"), self._base + "/", None, "reach")

    def _news(self, call: CallId, begun: Future[Reply] | None) -> CallStatus:
        """What became of a call whose first request has ended, or was made in another life."""
        if begun is not None and call not in self._last:
            try:
                reply = begun.result()
            except Unreachable as error:
                lost = not isinstance(error, NeverSent) and self._begin.does_something
                if self._poll is None and lost:
                    return NotDone(f"it is not known whether it was done: {error.what}")
                del self._begun[call]  # the poll will tell whether it was heard
                raise
            if reply.status >= 400:
                return NotDone(reply.reason)
            if self._poll is None:
                return Done(reply.body)
            self._remember(call, reply)
            self._last[call] = Going({})
        if self._poll is None and not self._begin.does_something:
            return Unheard()
        if self._poll is None:
            return NotDone("it is not known whether it was done: nobody waited for the answer")
        return self._polled(call)

    def _polled(self, call: CallId) -> CallStatus:
        values = self._values(call)
        if values is None or self._poll is None:
            return Unheard()
        asked = self._asked.get(call)
        if asked is None:
            asked = self._asked[call] = self._submitted(self._poll, values, None, call)
        if not asked.done():
            return self._last.get(call, Going({}, heard=False))
        del self._asked[call]
        reply = asked.result()
        if reply.status in GONE:
            return Unheard()
        if reply.status >= 400:
            return NotDone(reply.reason)
        if self._going and meets(reply.body, self._going):
            self._last[call] = Going(reply.body)
            return self._last[call]
        return Done(reply.body)

    def _submitted(
        self, request: Request, values: Mapping[str, Any], body: Any, call: CallId
    ) -> Future[Reply]:
        quoted = {
            key: quote(str(value), safe="") for key, value in values.items() if key in request.named
        }
        url = self._base + str(filled(request.path, quoted))
        return self._adapter.pool.submit(self._adapter.asked, request, url, body, call)

    def _values(self, call: CallId) -> dict[str, Any] | None:
        """What names a call in a path; None where the robot's own id was never told."""
        if self._id is None:
            return {"call": call}
        id = self._adapter.journal.get(call, "http id")
        return None if id is None else {"call": call, "id": id}

    def _remember(self, call: CallId, reply: Reply) -> None:
        if self._id is not None:
            try:
                id = value_at(self._id, reply.body)
            except UnfilledError as error:
                raise Unreachable(f"the answer has no {self._id!r}: {dict(reply.body)}") from error
            self._adapter.journal.note(call, "http id", id)


def _base(value: Value) -> str:
    url = value.text().rstrip("/")
    parts = urlsplit(url)
    if parts.scheme not in ("http", "https") or not parts.netloc:
        raise value.error(f"expected an address such as http://robot:8080, got {url!r}")
    return url


def _headers(settings: Section) -> dict[str, str]:
    """Headers, with secrets from the environment: `{env.ROBOT_KEY}`."""
    headers = {}
    given = settings.get("headers")
    for name, value in () if given is None else given.section():
        try:
            headers[name] = str(filled(value.text(), {"env": os.environ}))
        except UnfilledError as error:
            hint = "headers may name variables of the environment: {env.NAME}, which have to be set"
            raise value.error(f"there is no {error.path}", hint) from error
    return headers


def _request(value: Value) -> Request:
    found = _REQUEST.fullmatch(value.text())
    if found is None or not found[2].startswith("/"):
        raise value.error(
            f"expected a method and a path, such as POST /drive, got {value.text()!r}"
        )
    return Request(found[1], found[2])


def _read(content: bytes) -> dict[str, Any]:
    text = content.decode("utf-8", "replace").strip()
    try:
        read = json.loads(text) if text else {}
    except ValueError:
        read = text[:500]
    return read if isinstance(read, dict) else {"value": read}
