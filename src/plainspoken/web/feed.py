"""The logs of missions as they grow, for many who watch: each log is followed once.

A thread follows a mission's log for as long as somebody watches it, and wakes the event loop when
there is something new. Whoever watches has only a place in the log: who reads slowly is behind, and
nothing is kept for them.
"""

from __future__ import annotations

import asyncio
import json
import threading
from collections import deque
from collections.abc import AsyncIterator
from contextlib import suppress
from dataclasses import dataclass, field

from plainspoken.knowledge.database import StoreError
from plainspoken.mission.mission import MissionId
from plainspoken.web.desk import Desk
from plainspoken.world.event import Entry, MissionEnded, Step

MOST_KEPT = 512
"""Entries that are kept ready for those who watch; earlier ones come from the store."""
MOST_AT_ONCE = 512
PATIENCE = 1.0
"""Seconds after which a thread looks whether anybody still watches."""


@dataclass(frozen=True, slots=True)
class Line:
    """An entry as it is sent; ends: whether nothing follows."""

    step: Step
    kind: str
    document: str
    ends: bool


@dataclass
class _Channel:
    """What is followed of one mission, by the event loop alone.

    length: how many entries the log is known to have
    """

    loop: asyncio.AbstractEventLoop
    length: Step = 0
    lines: deque[Line] = field(default_factory=lambda: deque(maxlen=MOST_KEPT))
    watched_by: int = 0
    news: asyncio.Event = field(default_factory=asyncio.Event)
    over: threading.Event = field(default_factory=threading.Event)

    def add(self, lines: list[Line]) -> None:
        self.lines.extend(lines)
        self.length = lines[-1].step + 1
        self.news.set()
        self.news = asyncio.Event()

    def since(self, step: Step) -> list[Line] | None:
        """The lines from a step on; None where they are no longer kept here."""
        if not self.lines or step < self.lines[0].step:
            return None
        first = self.lines[0].step
        return [self.lines[index] for index in range(step - first, len(self.lines))]


class Feed:
    """Follows logs for those who watch them from one event loop."""

    def __init__(self, desk: Desk) -> None:
        self._desk = desk
        self._channels: dict[MissionId, _Channel] = {}
        self._closed = False

    def close(self) -> None:
        """Have everyone who watches see an end."""
        self._closed = True
        for channel in self._channels.values():
            channel.news.set()

    async def follow(
        self, mission: MissionId, since: Step = 0, *, patience: float = 15.0
    ) -> AsyncIterator[list[Line]]:
        """The entries from a step on, as they come; an empty list where nothing came for long.

        Ends with the mission. since: not beyond the end of the log
        """
        channel = self._joined(mission, since)
        try:
            while not self._closed:
                news = channel.news
                lines = await self._lines(mission, channel, since)
                if not lines:
                    lines = await self._waited(channel, news, since, patience)
                yield lines
                if lines:
                    since = lines[-1].step + 1
                    if lines[-1].ends:
                        return
        finally:
            self._left(mission, channel)

    async def _lines(self, mission: MissionId, channel: _Channel, since: Step) -> list[Line]:
        if since >= channel.length:
            return []
        kept = channel.since(since)
        if kept is None:
            entries = await asyncio.to_thread(self._desk.entries, mission, since, MOST_AT_ONCE)
            return [line_of(entry) for entry in entries]
        return kept[:MOST_AT_ONCE]

    async def _waited(
        self, channel: _Channel, news: asyncio.Event, since: Step, patience: float
    ) -> list[Line]:
        with suppress(TimeoutError):
            async with asyncio.timeout(patience):
                await news.wait()
        return (channel.since(since) or [])[:MOST_AT_ONCE] if since < channel.length else []

    def _joined(self, mission: MissionId, since: Step) -> _Channel:
        channel = self._channels.get(mission)
        if channel is None:
            channel = _Channel(asyncio.get_running_loop(), since)
            self._channels[mission] = channel
            threading.Thread(
                target=self._run,
                args=(mission, channel, since),
                name=f"feed {mission}",
                daemon=True,
            ).start()
        channel.watched_by += 1
        return channel

    def _left(self, mission: MissionId, channel: _Channel) -> None:
        channel.watched_by -= 1
        if not channel.watched_by:
            channel.over.set()
            if self._channels.get(mission) is channel:
                del self._channels[mission]

    def _run(self, mission: MissionId, channel: _Channel, since: Step) -> None:
        """Follow a log, off the event loop, until nobody watches it."""
        while not channel.over.is_set():
            try:
                for entries in self._desk.follow(mission, since, patience=PATIENCE):
                    if channel.over.is_set():
                        return
                    if entries:
                        since = entries[-1].step + 1
                        lines = [line_of(entry) for entry in entries]
                        channel.loop.call_soon_threadsafe(channel.add, lines)
            except StoreError:  # it may come back
                channel.over.wait(PATIENCE)
            except RuntimeError:  # the event loop is gone, and with it all who watch
                return
            else:
                return


def line_of(entry: Entry) -> Line:
    """An entry as JSON: made once, for everyone."""
    document = json.dumps(entry.to_json(), separators=(",", ":"))
    return Line(entry.step, entry.kind, document, isinstance(entry.event, MissionEnded))
