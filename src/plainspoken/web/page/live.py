"""Missions as they go on, for everybody who watches them here: one thread reads for all."""

from __future__ import annotations

import asyncio
import threading
from collections import OrderedDict
from collections.abc import Callable, Mapping, Sequence

from plainspoken.mission.mission import MissionId
from plainspoken.pipeline import accepted_of
from plainspoken.questions.moment import lexicon_of
from plainspoken.web.desk import Desk
from plainspoken.web.page.drawing import Drawing
from plainspoken.web.page.ground import Ground
from plainspoken.web.page.layout import Layout
from plainspoken.web.page.speech import Talk
from plainspoken.web.page.view import View
from plainspoken.world.event import Entry, Step

_KEPT = 8
"""Views of a mission that are kept: those that go by are looked at by many at once."""
_PATIENCE = 5.0


class Feed:
    """The log of one mission as it grows."""

    def __init__(self, desk: Desk, mission: MissionId, layout: Layout) -> None:
        """Read the log so far.

        raises PlainspokenError: when there is no such mission
        """
        self.mission = mission
        self.talk = Talk()
        self._desk = desk
        self._entries: list[Entry] = list(desk.entries(mission))
        self._accepted = accepted_of(self._entries)
        self._layout = layout
        self._drawing: Drawing | None = None
        self._views: OrderedDict[Step, View] = OrderedDict()
        self._lock = threading.Lock()
        self._told: dict[int, Callable[[], object]] = {}
        self._next = 0
        self._thread: threading.Thread | None = None

    @property
    def entries(self) -> Sequence[Entry]:
        return self._entries

    @property
    def last(self) -> Step:
        return len(self._entries) - 1

    def view(self, at: Step | None = None) -> View:
        """The mission at a step, None for the last; takes a while, and may be called anywhere."""
        with self._lock:
            step = self.last if at is None else max(0, min(at, self.last))
            found = self._views.get(step)
            if found is None:
                if self._drawing is None:
                    self._drawing = Drawing(Ground(lexicon_of(self._accepted), self._layout))
                found = View(self._entries[: step + 1], self._drawing)
                self._views[step] = found
                while len(self._views) > _KEPT:
                    self._views.popitem(last=False)
            return found

    def watch(self, told: Callable[[], object]) -> Callable[[], None]:
        """Have somebody told, on this event loop, of every news; gives what ends it."""
        loop = asyncio.get_running_loop()
        number = self._next
        self._next += 1
        self._told[number] = lambda: loop.call_soon_threadsafe(told)
        if self._thread is None or not self._thread.is_alive():
            self._thread = threading.Thread(
                target=self._follow, name=f"feed {self.mission}", daemon=True
            )
            self._thread.start()
        return lambda: self._told.pop(number, None) and None

    def _follow(self) -> None:
        """Read what comes, as long as somebody watches."""
        for some in self._desk.follow(self.mission, len(self._entries), patience=_PATIENCE):
            if some:
                with self._lock:
                    self._entries.extend(some)
                self.tell()
            if not self._told:
                return

    def tell(self) -> None:
        """Tell everybody who watches that there is something new."""
        for told in list(self._told.values()):
            told()


class Feeds:
    """The feeds of all missions that are watched here."""

    def __init__(self, desk: Desk, layouts: Mapping[str, Layout]) -> None:
        self._desk = desk
        self._layouts = layouts
        self._feeds: dict[MissionId, Feed] = {}

    def of(self, mission: MissionId) -> Feed:
        """The feed of a mission.

        raises PlainspokenError: when there is no such mission
        """
        if mission not in self._feeds:
            problem = self._desk.site(mission).problem
            layout = self._layouts.get(problem.name, Layout())
            self._feeds[mission] = Feed(self._desk, mission, layout)
        return self._feeds[mission]
