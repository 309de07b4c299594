"""The desk behind the page: what can be asked for here, and the missions that go on.

A desk knows some places and works on a store: it carries missions out as any worker does, and what
people ask of a mission reaches it wherever it is carried out. Whoever watches is told by number:
there is something new in the log of this mission. Nothing is held only here: when a desk is killed,
its missions are taken over by another worker, or by the next desk.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator, Mapping
from datetime import datetime
from typing import Any

from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.store import Store
from plainspoken.language.extraction import Extraction
from plainspoken.logic.formula import Formula
from plainspoken.mission.executive import queued
from plainspoken.mission.mailbox import Asked, to_message
from plainspoken.mission.mission import Mission, MissionId, mission_from
from plainspoken.mission.observation import CancelAsked, ChangeAsked, PauseAsked, ResumeAsked, Told
from plainspoken.pipeline import (
    Request,
    Site,
    accepted_as,
    accepted_of,
    find_policy,
    site_of,
    understand,
)
from plainspoken.planning.policy import Policy
from plainspoken.planning.solver import Ending
from plainspoken.planning.watch import Progress
from plainspoken.questions.conversation import Conversation, Said, message_of
from plainspoken.questions.dialogue import Dialogue
from plainspoken.questions.length import Length
from plainspoken.questions.moment import Moment
from plainspoken.work.shift import robots_of, utc_now
from plainspoken.work.worker import RobotFor, Worker
from plainspoken.world.event import Entry, Step

PlaceName = str

ELSEWHERE = 0.5
"""Seconds until the log is looked at again for what other processes wrote."""


class PlanningStopped(Exception):
    """Somebody did not want to wait for a policy any longer."""


class Desk:
    """Places, missions, and the people who watch them. All methods may be called by any thread."""

    def __init__(
        self,
        places: Mapping[PlaceName, Site],
        store: Store,
        robot_for: RobotFor,
        *,
        most: int = 32,
        now: Callable[[], datetime] = utc_now,
    ) -> None:
        """Open a desk, which is at work until it is closed; most: missions at once."""
        self.places = places
        self.store = store
        self._now = now
        self._news = threading.Condition()
        self._count = 0
        self._worker = Worker(store, robot_for, most=most, heard=self._heard, now=now)
        self._thread = threading.Thread(target=self._worker.run, name="desk", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Hand every mission back as it is."""
        self._worker.stop()
        self._thread.join()

    # -- before a mission ----------------------------------------------------------------------

    def understand(self, place: PlaceName, text: str) -> Extraction:
        """What a sentence asks for, at a place."""
        return understand(text, self._site(place))

    def plan(
        self,
        place: PlaceName,
        goal: Formula,
        *,
        timeout: float | None = None,
        stopped: threading.Event | None = None,
        on_progress: Callable[[Progress], None] | None = None,
    ) -> Ending:
        """Find a policy.

        raises PlanningStopped: soon after `stopped` was set
        """
        if stopped is not None and stopped.is_set():
            raise PlanningStopped

        def heard(progress: Progress) -> None:
            if stopped is not None and stopped.is_set():
                raise PlanningStopped
            if on_progress is not None:
                on_progress(progress)

        return find_policy(self._site(place).problem, goal, timeout=timeout, on_progress=heard)

    def start(self, place: PlaceName, request: Request, policy: Policy) -> MissionId:
        """Have a mission carried out; it is in the log when this returns.

        raises OvertakenError: when there is a mission of that name
        """
        accepted = accepted_as(self._site(place), request)
        time = self._now().isoformat(timespec="milliseconds")
        self.store.begin(request.mission, time, queued(accepted, policy), robots_of(accepted))
        self._tell()
        return request.mission

    # -- missions ------------------------------------------------------------------------------

    def missions(self) -> tuple[MissionId, ...]:
        """Every mission of the log, oldest first."""
        return self.store.missions()

    def entries(self, mission: MissionId, since: Step = 0) -> tuple[Entry, ...]:
        return self.store.entries(mission, since)

    def mission(self, mission: MissionId) -> Mission:
        """Where a mission stands.

        raises PlainspokenError: when there is no such mission
        """
        return mission_from(self._entries(mission))

    def site(self, mission: MissionId) -> Site:
        """Where a mission takes place, by its log alone."""
        return site_of(accepted_of(self._entries(mission)))

    def is_running(self, mission: MissionId) -> bool:
        """Whether some worker carries it out, here or elsewhere."""
        place = self.store.place(mission)
        return place is not None and place.worker is not None

    def trouble(self, mission: MissionId) -> str | None:
        """Why a worker broke off, where one did."""
        place = self.store.place(mission)
        return None if place is None else place.trouble

    def pause(self, mission: MissionId, by: str) -> None:
        self._ask_of(mission, PauseAsked(by))

    def cancel(self, mission: MissionId, by: str) -> None:
        self._ask_of(mission, CancelAsked(by))

    def report(self, mission: MissionId, told: Told) -> None:
        self._ask_of(mission, told)

    def change(self, mission: MissionId, asked: ChangeAsked) -> None:
        self._ask_of(mission, asked)

    def resume(self, mission: MissionId, by: str) -> None:
        """Go on with a mission that was paused."""
        self._ask_of(mission, ResumeAsked(by))

    # -- questions -----------------------------------------------------------------------------

    def ask(
        self,
        mission: MissionId,
        text: str,
        *,
        at: Step | None = None,
        dialogue: Dialogue | None = None,
        full: bool = False,
    ) -> tuple[Any, Dialogue]:
        """Answer a question about a mission; also the dialogue after it."""
        moment = Moment(self._entries(mission), at)
        length = Length.FULL if full else Length.BRIEF
        return (dialogue or Dialogue()).ask(text, moment, length=length)

    def say(
        self, mission: MissionId, text: str, by: str, conversation: Conversation | None = None
    ) -> Said:
        """Take a question, a report or a change of mind; what is agreed to, the mission is told.

        by: who says it
        """
        said = (conversation or Conversation()).say(text, Moment(self._entries(mission)))
        if said.agreed is not None:
            self._ask_of(mission, message_of(said.agreed, by))
        return said

    # -- watching ------------------------------------------------------------------------------

    def follow(
        self, mission: MissionId, since: Step = 0, *, patience: float = 15.0
    ) -> Iterator[tuple[Entry, ...]]:
        """The entries from a step on, as they come; an empty tuple where nothing came for long.

        Ends with the mission.
        """
        while True:
            found = self._next_entries(mission, since, time.monotonic() + patience)
            yield found
            since += len(found)
            if any(entry.kind == "mission_ended" for entry in found):
                return

    # -- inside --------------------------------------------------------------------------------

    def _site(self, place: PlaceName) -> Site:
        if place not in self.places:
            raise PlainspokenError(
                f"no place is called {place!r}", hint=f"there are {', '.join(self.places)}"
            )
        return self.places[place]

    def _entries(self, mission: MissionId) -> tuple[Entry, ...]:
        entries = self.store.entries(mission)
        if not entries:
            raise PlainspokenError(f"no mission {mission!r}")
        return entries

    def _next_entries(self, mission: MissionId, since: Step, deadline: float) -> tuple[Entry, ...]:
        while True:
            with self._news:
                seen = self._count
            found = self.entries(mission, since)
            left = deadline - time.monotonic()
            if found or left <= 0:
                return found
            with self._news:
                if self._count == seen:
                    self._news.wait(min(left, ELSEWHERE))

    def _ask_of(self, mission: MissionId, asked: Asked) -> None:
        """Put a request where whoever carries the mission out finds it."""
        entries = self._entries(mission)
        if mission_from(entries).is_over:
            raise PlainspokenError(f"the mission {mission} is over")
        if self.store.place(mission) is None:  # it was run before there were places
            self.store.enlist(mission, robots_of(accepted_of(entries)))
        self.store.post(mission, to_message(asked))

    def _heard(self, _mission: MissionId, _entry: Entry) -> None:
        self._tell()

    def _tell(self) -> None:
        with self._news:
            self._count += 1
            self._news.notify_all()
