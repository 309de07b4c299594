"""The desk behind the page: what can be asked for here, and the missions that go on.

A desk knows some places, carries missions out on threads of its own, and keeps every event in an
event log. Whoever watches is told by number: there is something new in the log of this mission.
Nothing is held only here: a desk that was killed finds its missions again, and goes on.
"""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from typing import Any

from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.log import EventLog
from plainspoken.language.extraction import Extraction
from plainspoken.logic.formula import Formula
from plainspoken.mission.executive import advance
from plainspoken.mission.mission import Mission, MissionId, mission_from
from plainspoken.mission.observation import (
    CancelAsked,
    ChangeAsked,
    Observation,
    PauseAsked,
    ResumeAsked,
    Told,
)
from plainspoken.mission.robot import Robot
from plainspoken.pipeline import (
    Request,
    Site,
    accepted_of,
    carry_out,
    find_policy,
    go_on,
    site_of,
    understand,
)
from plainspoken.planning.policy import Policy
from plainspoken.planning.solver import Ending
from plainspoken.planning.watch import Progress
from plainspoken.questions.dialogue import Dialogue
from plainspoken.questions.moment import Moment
from plainspoken.world.event import Entry, Event, Instant, Step

PlaceName = str
RobotFor = Callable[[Site, Mapping[str, Any], Sequence[Entry]], Robot]
"""Makes the robot that a mission is set for; entries: its log so far, empty for a new one."""


class PlanningStopped(Exception):
    """Somebody did not want to wait for a policy any longer."""


@dataclass
class _Running:
    """A mission that a thread carries out; requests are looked at between actions.

    begun: set once something of it is in the log, or nothing ever will be
    """

    requests: queue.SimpleQueue[Observation] = field(default_factory=queue.SimpleQueue)
    thread: threading.Thread | None = None
    begun: threading.Event = field(default_factory=threading.Event)
    error: str | None = None

    @property
    def is_alive(self) -> bool:
        return self.thread is not None and self.thread.is_alive()

    def next(self) -> Observation | None:
        try:
            return self.requests.get_nowait()
        except queue.Empty:
            return None


class Desk:
    """Places, missions, and the people who watch them. All methods may be called by any thread."""

    def __init__(
        self,
        places: Mapping[PlaceName, Site],
        log: EventLog,
        robot_for: RobotFor,
        *,
        now: Callable[[], datetime] = lambda: datetime.now(UTC),
    ) -> None:
        self.places = places
        self.log = log
        self._robot_for = robot_for
        self._now = now
        self._running: dict[MissionId, _Running] = {}
        self._lock = threading.Lock()
        self._news = threading.Condition()
        self._count = 0

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

    def start(
        self,
        place: PlaceName,
        request: Request,
        policy: Policy,
    ) -> MissionId:
        """Carry a mission out on a thread of its own; it is in the log when this returns."""
        site = self._site(place)
        robot = self._robot_for(site, request.robot, ())
        running = _Running()

        def carried_out(record: Callable[[Instant, Sequence[Event]], Sequence[Entry]]) -> None:
            for _ in carry_out(site, request, policy, robot, record, requests=running.next):
                pass

        self._set_off(request.mission, running, carried_out)
        return request.mission

    # -- missions ------------------------------------------------------------------------------

    def missions(self) -> tuple[MissionId, ...]:
        """Every mission of the log, oldest first."""
        return self.log.missions()

    def entries(self, mission: MissionId, since: Step = 0) -> tuple[Entry, ...]:
        return self.log.entries(mission, since)

    def mission(self, mission: MissionId) -> Mission:
        """Where a mission stands.

        raises PlainspokenError: when there is no such mission
        """
        return mission_from(self._entries(mission))

    def site(self, mission: MissionId) -> Site:
        """Where a mission takes place, by its log alone."""
        return site_of(accepted_of(self._entries(mission)))

    def is_running(self, mission: MissionId) -> bool:
        """Whether a thread of this desk carries it out."""
        running = self._running.get(mission)
        return running is not None and running.is_alive

    def trouble(self, mission: MissionId) -> str | None:
        """Why a thread of this desk broke off, where one did."""
        running = self._running.get(mission)
        return None if running is None else running.error

    def pause(self, mission: MissionId, by: str) -> None:
        self._ask_of(mission, PauseAsked(by))

    def cancel(self, mission: MissionId, by: str) -> None:
        self._ask_of(mission, CancelAsked(by))

    def report(self, mission: MissionId, told: Told) -> None:
        self._ask_of(mission, told)

    def change(self, mission: MissionId, asked: ChangeAsked) -> None:
        self._ask_of(mission, asked)

    def resume(self, mission: MissionId, by: str) -> None:
        """Go on with a mission that was paused, or that a killed desk left behind."""
        if self.is_running(mission):
            self._ask_of(mission, ResumeAsked(by))
        else:
            self._go_on(mission, by, ())

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
        return (dialogue or Dialogue()).ask(text, moment, full=full)

    # -- watching ------------------------------------------------------------------------------

    def follow(
        self, mission: MissionId, since: Step = 0, *, patience: float = 15.0
    ) -> Iterator[tuple[Entry, ...]]:
        """The entries from a step on, as they come; an empty tuple where nothing came for long.

        Ends with the mission.
        """
        while True:
            with self._news:
                seen = self._count
            found = self.entries(mission, since)
            yield found
            since += len(found)
            if any(entry.kind == "mission_ended" for entry in found):
                return
            with self._news:
                if self._count == seen:
                    self._news.wait(patience)

    # -- inside --------------------------------------------------------------------------------

    def _site(self, place: PlaceName) -> Site:
        if place not in self.places:
            raise PlainspokenError(
                f"no place is called {place!r}", hint=f"there are {', '.join(self.places)}"
            )
        return self.places[place]

    def _entries(self, mission: MissionId) -> tuple[Entry, ...]:
        entries = self.log.entries(mission)
        if not entries:
            raise PlainspokenError(f"no mission {mission!r}")
        return entries

    def _ask_of(self, mission: MissionId, asked: Observation) -> None:
        """Hand a request to the thread that carries the mission out, or take it up at once."""
        running = self._running.get(mission)
        if running is not None and running.is_alive:
            running.requests.put(asked)
            return
        standing = self.mission(mission)
        if standing.is_over:
            raise PlainspokenError(f"the mission {mission} is over")
        if standing.is_at_rest:
            learned = advance(standing, asked)
            self._record(mission, learned.mission.instant, learned.events)
        else:
            self._go_on(mission, "the desk", (asked,))  # a desk that was killed left it behind

    def _go_on(self, mission: MissionId, by: str, asked: Sequence[Observation]) -> None:
        entries = self._entries(mission)
        if mission_from(entries).is_over:
            raise PlainspokenError(f"the mission {mission} is over")
        accepted = accepted_of(entries)
        site = site_of(accepted)
        robot = self._robot_for(site, accepted.robot, entries)
        running = _Running()
        for each in asked:
            running.requests.put(each)

        def gone_on(record: Callable[[Instant, Sequence[Event]], Sequence[Entry]]) -> None:
            for _ in go_on(site, entries, robot, record, by=by, requests=running.next):
                pass

        self._set_off(mission, running, gone_on)

    def _set_off(
        self,
        mission: MissionId,
        running: _Running,
        work: Callable[[Callable[[Instant, Sequence[Event]], Sequence[Entry]]], None],
    ) -> None:
        def record(instant: Instant, events: Sequence[Event]) -> Sequence[Entry]:
            entries = self._record(mission, instant, events)
            running.begun.set()
            return entries

        def run() -> None:
            try:
                work(record)
            except Exception as error:  # noqa: BLE001 - whoever watches is told, not the terminal
                running.error = str(error)
            running.begun.set()
            self._tell()

        with self._lock:
            if self.is_running(mission):
                raise PlainspokenError(f"the mission {mission} is being carried out already")
            running.thread = threading.Thread(target=run, name=f"mission {mission}", daemon=True)
            self._running[mission] = running
            running.thread.start()
        running.begun.wait()

    def _record(
        self, mission: MissionId, instant: Instant, events: Sequence[Event]
    ) -> Sequence[Entry]:
        if not events:
            return ()
        time = self._now().isoformat(timespec="milliseconds")
        entries = self.log.append(mission, time, instant, events)
        self._tell()
        return entries

    def _tell(self) -> None:
        with self._news:
            self._count += 1
            self._news.notify_all()
