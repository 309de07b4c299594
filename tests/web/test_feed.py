import asyncio
import gc
import threading
from collections.abc import AsyncIterator, Callable
from typing import Any

import pytest
from tests.web.bench import Bench, bench, granted, until

from plainspoken.web import feed as following
from plainspoken.web.access import Role
from plainspoken.web.api import events
from plainspoken.web.feed import Feed, Line

API = "/api/v1"


async def collected(lines: AsyncIterator[list[Line]]) -> list[Line]:
    return [line async for some in lines for line in some]


def test_many_who_watch_see_the_same_log_from_wherever_they_begin(here: Bench) -> None:
    name = here.started()

    async def watch() -> list[list[Line]]:
        feed = Feed(here.desk)
        watching = [collected(feed.follow(name, since)) for since in (0, 0, 1, 2)]
        return await asyncio.wait_for(asyncio.gather(*watching), 60)

    first, second, *later = asyncio.run(watch())
    assert [line.step for line in first] == [e.step for e in here.desk.entries(name)]
    assert second == first
    assert later == [first[1:], first[2:]]


def test_what_is_no_longer_kept_comes_from_the_store(
    here: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(following, "MOST_KEPT", 2)
    monkeypatch.setattr(following, "MOST_AT_ONCE", 3)
    name = here.started()

    async def watch() -> tuple[list[Line], list[Line]]:
        feed = Feed(here.desk)
        late = feed.follow(name, 1)
        await anext(late)  # the log is followed from here on, and only its end is kept
        return await collected(feed.follow(name)), await collected(late)

    found, _ = asyncio.run(asyncio.wait_for(watch(), 60))
    assert [line.step for line in found] == [e.step for e in here.desk.entries(name)]


def test_where_nothing_happens_whoever_watches_hears_that(standstill: Bench) -> None:
    name = standstill.started()
    until(lambda: standstill.desk.entries(name)[-1].kind == "action_started")

    async def watch() -> list[Line]:
        lines = Feed(standstill.desk).follow(name, patience=0.01)
        while some := await anext(lines):
            del some
        await lines.aclose()  # type: ignore[attr-defined]
        return some

    assert asyncio.run(asyncio.wait_for(watch(), 60)) == []


def test_a_log_is_followed_only_while_somebody_watches(
    standstill: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(following, "PATIENCE", 0.01)
    name = standstill.started()

    def following_it() -> bool:
        return any(thread.name == f"feed {name}" for thread in threading.enumerate())

    async def watch() -> None:
        feed = Feed(standstill.desk)
        lines = [feed.follow(name) for _ in range(3)]
        for each in lines:
            await anext(each)
        assert following_it()
        for each in lines:
            await each.aclose()  # type: ignore[attr-defined]
        assert not feed._channels
        await asyncio.to_thread(until, lambda: not following_it())

    asyncio.run(asyncio.wait_for(watch(), 60))


def test_closing_ends_it_for_everyone(standstill: Bench) -> None:
    name = standstill.started()

    async def watch() -> None:
        feed = Feed(standstill.desk)
        watching = asyncio.ensure_future(collected(feed.follow(name)))
        await asyncio.sleep(0)
        feed.close()
        await watching

    asyncio.run(asyncio.wait_for(watch(), 60))


# -- as server-sent events ---------------------------------------------------------------------


def fields(text: str) -> list[tuple[str, str, str]]:
    found = []
    for block in text.split("\n\n"):
        parts = dict(line.split(": ", 1) for line in block.splitlines() if not line.startswith(":"))
        if "id" in parts:
            found.append((parts["id"], parts["event"], parts["data"]))
    return found


def test_events_are_sent_with_their_step_and_kind_until_the_mission_ends(here: Bench) -> None:
    client, name = here.client(), here.started()
    stream = client.get(f"{API}/missions/{name}/stream")
    assert stream.headers["content-type"].startswith("text/event-stream")
    entries = here.desk.entries(name)
    assert [(id, kind) for id, kind, _ in fields(stream.text)] == [
        (str(entry.step), entry.kind) for entry in entries
    ]


def test_whoever_comes_back_goes_on_after_the_last_event_they_had(here: Bench) -> None:
    client, name = here.client(), here.started()
    until(lambda: here.desk.mission(name).is_over)
    last = here.desk.entries(name)[-1].step
    at = f"{API}/missions/{name}/stream"
    again = client.get(at, headers={"Last-Event-ID": str(last - 2)})
    assert [id for id, *_ in fields(again.text)] == [str(last - 1), str(last)]
    assert [id for id, *_ in fields(client.get(at, params={"since": last}).text)] == [str(last)]
    assert client.get(at, headers={"Last-Event-ID": str(last)}).status_code == 204
    assert client.get(at, headers={"Last-Event-ID": "9" * 20}).status_code == 204
    for odd in ("-1", "x", "1.0", "1" * 21):
        assert client.get(at, headers={"Last-Event-ID": odd}).status_code == 422


async def streamed(
    it: Bench, name: str, enough: Callable[[bytes], bool], headers: dict[str, str] | None = None
) -> bytes:
    """Read a stream until there is enough, and hang up."""
    found = bytearray()
    gone = asyncio.Event()

    async def receive() -> dict[str, Any]:
        await gone.wait()
        return {"type": "http.disconnect"}

    async def send(message: Any) -> None:
        found.extend(message.get("body", b""))
        if enough(bytes(found)):
            gone.set()

    started = False

    async def first() -> dict[str, Any]:
        nonlocal started
        if started:
            return await receive()
        started = True
        return {"type": "http.request", "body": b""}

    scope = {
        "type": "http", "method": "GET", "path": f"{API}/missions/{name}/stream",
        "raw_path": b"", "root_path": "", "query_string": b"", "scheme": "http",
        "headers": [
            (b"host", b"127.0.0.1"),
            *((key.lower().encode(), text.encode()) for key, text in (headers or {}).items()),
        ],
        "client": ("127.0.0.1", 5), "http_version": "1.1", "asgi": {"spec_version": "2.3"},
    }  # fmt: skip
    await asyncio.wait_for(it.app(scope, first, send), 60)  # type: ignore[arg-type]
    return bytes(found)


def test_whoever_hangs_up_leaves_nothing_behind(standstill: Bench) -> None:
    name = standstill.started()
    found = asyncio.run(streamed(standstill, name, lambda text: b"event: policy_chosen" in text))
    assert found.startswith(b"retry: ")
    gc.collect()
    assert not standstill.office.viewers._taken
    assert not standstill.office.feed._channels


def test_a_silent_stream_has_a_heartbeat(
    standstill: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(events, "HEARTBEAT", 0.01)
    name = standstill.started()
    asyncio.run(streamed(standstill, name, lambda text: b"\n: nothing new\n\n" in text))


def test_a_stream_ends_with_the_token_that_it_was_opened_with(
    standstill: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(events, "HEARTBEAT", 0.01)
    name = standstill.started()
    tokens, access = granted((Role.VIEWER, "vic"))
    it = bench(standstill.desk, access)
    grants, known = access._grants, [True]
    assert grants is not None
    access._grants = lambda: grants() if known[0] else ()

    def taken_away(text: bytes) -> bool:
        if b"nothing new" in text:
            known[0] = False
        return False

    shown = {"Authorization": f"Bearer {tokens['vic']}"}
    asyncio.run(streamed(it, name, taken_away, shown))  # it ends by itself


def test_one_caller_has_so_many_streams(standstill: Bench) -> None:
    name = standstill.started()
    seats = standstill.office.viewers
    for _ in range(seats._each):
        seats.take("ada")
    refused = standstill.client().get(f"{API}/missions/{name}/stream")
    assert refused.status_code == 429
    assert "Retry-After" in refused.headers
