"""The log of a mission: in pages, as it grows, and as a file."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable
from contextlib import suppress
from typing import Annotated

import anyio
from fastapi import APIRouter, Header, HTTPException, Query, Request, Response
from starlette.responses import StreamingResponse
from starlette.types import Message, Receive, Scope, Send

from plainspoken.knowledge.jsonl import sealed
from plainspoken.web.api.calling import MissionName, TheCaller, TheOffice
from plainspoken.web.api.model import MOST_STEPS, Event, Events
from plainspoken.web.api.office import Office
from plainspoken.web.gate import STILL

router = APIRouter(tags=["events"])

MOST_EVENTS = 500
HEARTBEAT = 15.0
"""Seconds after which something is sent where nothing happens: proxies cut off what is silent."""
SLOWEST = 30.0
"""Seconds in which a client has to take what it is sent."""


_SENT = {
    "type": "object",
    "properties": {each: {"type": "string"} for each in ("id", "event", "data")},
    "required": ["id", "event", "data"],
}


@router.get("/missions/{mission:path}/events")
def events(
    mission: MissionName,
    office: TheOffice,
    _: TheCaller,
    since: Annotated[int, Query(ge=0, le=MOST_STEPS)] = 0,
    most: Annotated[int, Query(ge=1, le=MOST_EVENTS)] = 100,
) -> Events:
    """Entries of the log from a step on."""
    found = office.desk.entries(mission, since, most)
    if not found:
        office.standings.of(mission)  # there may be no such mission
    listed = [Event.model_validate(entry.to_json()) for entry in found]
    return Events(events=listed, since=found[-1].step + 1 if len(found) == most else None)


@router.get(
    "/missions/{mission:path}/stream",
    response_class=Response,
    responses={
        200: {
            "description": "Server-sent events: `id` is the step, `event` the kind of the entry.",
            "content": {"text/event-stream": {"schema": _SENT}},
        },
        204: {"description": "The mission is over, and you have seen all of it."},
    },
)
def stream(
    *,
    mission: MissionName,
    office: TheOffice,
    caller: TheCaller,
    request: Request,
    since: Annotated[int, Query(ge=0, le=MOST_STEPS)] = 0,
    last_event_id: Annotated[str | None, Header(max_length=20)] = None,
) -> Response:
    """The log as it grows, from a step on, or after the one that `Last-Event-ID` names.

    Ends with the mission.
    """
    standing = office.standings.of(mission)
    first = _after(last_event_id, since)
    if standing.mission.is_over and first > standing.seen:
        return Response(status_code=204)
    office.viewers.take(caller.name)
    lines = _lines(office, mission, min(first, standing.seen + 1), request.scope[STILL])
    return _Stream(lines, on_end=lambda: office.viewers.leave(caller.name))


@router.get(
    "/missions/{mission:path}/log",
    response_class=Response,
    responses={
        200: {
            "description": "One JSON object a line, each with the hash of the chain up to it.",
            "content": {"application/x-ndjson": {"schema": {"type": "string"}}},
        }
    },
)
def export(mission: MissionName, office: TheOffice, _: TheCaller) -> Response:
    """The whole log as `plainspoken ask --log` reads it, after checking that nobody changed it."""
    store = office.desk.store
    links = store.links(mission)
    if not links:
        office.standings.of(mission)
    broken = store.verify(mission)
    if broken is not None:
        raise HTTPException(
            409, f"the log is not as it was written: step {broken.step}: {broken.what}"
        )
    name = "".join(letter if letter.isascii() and letter.isalnum() else "-" for letter in mission)
    return StreamingResponse(
        (sealed(link.text, link.hash) for link in links),
        media_type="application/x-ndjson",
        headers={"Content-Disposition": f'attachment; filename="{name}.jsonl"'},
    )


def _after(last_event_id: str | None, since: int) -> int:
    """The step that follows the last one that was received."""
    if not last_event_id:
        return since
    if not last_event_id.isascii() or not last_event_id.isdecimal():
        raise HTTPException(422, f"Last-Event-ID is the number of a step, not {last_event_id!r}")
    return int(last_event_id) + 1


async def _lines(
    office: Office, mission: str, since: int, still: Callable[[], bool]
) -> AsyncIterator[str]:
    yield "retry: 1000\n\n"
    async for lines in office.feed.follow(mission, since, patience=HEARTBEAT):
        if not still():
            return
        if not lines:
            yield ": nothing new\n\n"
        for line in lines:
            yield f"id: {line.step}\nevent: {line.kind}\ndata: {line.document}\n\n"


class _Stream(StreamingResponse):
    """Events for one client, as long as it takes them."""

    def __init__(self, lines: AsyncIterator[str], *, on_end: Callable[[], None]) -> None:
        super().__init__(
            lines,
            media_type="text/event-stream",
            headers={"X-Accel-Buffering": "no"},  # nginx would keep them back otherwise
        )
        self._on_end = on_end

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        try:
            await super().__call__(scope, receive, send)
        finally:
            self._on_end()

    async def stream_response(self, send: Send) -> None:
        """Send, and give a client up that takes nothing any more."""

        async def patiently(message: Message) -> None:
            with anyio.fail_after(SLOWEST):
                await send(message)

        with suppress(TimeoutError):
            await super().stream_response(patiently)
