"""The desk behind the page: what can be asked for here, and the missions that go on.

A desk knows some places and works on a store: it carries missions out as any worker does, and what
people ask of a mission reaches it wherever it is carried out. Whoever watches is told by number:
there is something new in the log of this mission. Nothing is held only here: when a desk is killed,
its missions are taken over by another worker, or by the next desk.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from datetime import datetime
from typing import Any

from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.queue import MessageNumber
from plainspoken.knowledge.store import AskedMeanwhileError, Store
from plainspoken.language.extraction import Extraction
from plainspoken.logic.formula import Formula
from plainspoken.mission.executive import queued
from plainspoken.mission.mailbox import Asked, asked_by, to_message
from plainspoken.mission.mission import Mission, MissionId, mission_from
from plainspoken.mission.observation import CancelAsked, ChangeAsked, PauseAsked, ResumeAsked, Told
from plainspoken.mission.simulator import Simulator
from plainspoken.mission.veil import VeiledRobot
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
from plainspoken.work.shift import TICK, robots_of, utc_now
from plainspoken.work.worker import RobotFor, Worker
from plainspoken.world.event import Cancelled, ChangeRequested, Entry, Paused, Resumed, Step

PlaceName = str

ELSEWHERE = 0.5
"""Seconds until the log is looked at again for what other processes wrote."""


HEARD_WITHIN = 10.0
"""Seconds that whoever asked something of a mission waits for it to be in the log."""
COMMANDS = (Paused, Resumed, Cancelled, ChangeRequested)
"""What somebody should know of before they ask something else."""


class UnknownPlaceError(PlainspokenError):
    """There is no place of that name."""


class UnknownMissionError(PlainspokenError):
    """There is no mission of that name."""


class MissionOverError(PlainspokenError):
    """Nothing can be asked of a mission any more."""


@dataclass(frozen=True, slots=True)
class Command:
    """What somebody asked of a mission; step: of the entry that says so, None before there is."""

    by: str
    asked: str
    step: Step | None

    def __str__(self) -> str:
        where = "and it is not in the log yet" if self.step is None else f"at step {self.step}"
        return f"{self.by} {self.asked}, {where}"


class UnseenError(PlainspokenError):
    """Somebody else has asked something of a mission, which whoever asks now does not know of."""

    def __init__(self, mission: MissionId, commands: Sequence[Command]) -> None:
        self.commands = tuple(commands)
        super().__init__(
            f"somebody has commanded the mission {mission} meanwhile",
            where="\n".join(map(str, commands)),
            hint="look at the mission, and ask again if it is still what you want",
        )


@dataclass(frozen=True, slots=True)
class Reply:
    """Something that was asked, and is on its way to whoever carries the mission out.

    number:    names it at the store
    meanwhile: what others had asked, which whoever asked did not know of
    """

    number: MessageNumber
    meanwhile: tuple[Command, ...] = ()


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

    def place(self, place: PlaceName) -> Site:
        """A place that is known here.

        raises UnknownPlaceError: when it is not
        """
        if place not in self.places:
            raise UnknownPlaceError(
                f"no place is called {place!r}", hint=f"there are {', '.join(self.places)}"
            )
        return self.places[place]

    def understand(self, place: PlaceName, text: str) -> Extraction:
        """What a sentence asks for, at a place."""
        return understand(text, self.place(place))

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

        return find_policy(self.place(place).problem, goal, timeout=timeout, on_progress=heard)

    def start(self, place: PlaceName, request: Request, policy: Policy) -> MissionId:
        """Have a mission carried out; it is in the log when this returns.

        raises OvertakenError: when there is a mission of that name
        """
        site = self.place(place)
        if "robots" not in request.robot:
            request = request.knowing(VeiledRobot(Simulator(site.problem), site.problem))
        accepted = accepted_as(site, request)
        time = self._now().isoformat(timespec="milliseconds")
        self.store.begin(request.mission, time, queued(accepted, policy), robots_of(accepted))
        self._tell()
        return request.mission

    # -- missions ------------------------------------------------------------------------------

    def missions(self) -> tuple[MissionId, ...]:
        """Every mission of the log, oldest first."""
        return self.store.missions()

    def entries(
        self, mission: MissionId, since: Step = 0, most: int | None = None
    ) -> tuple[Entry, ...]:
        """The entries from a step on, so many at most; none where there is no such mission."""
        return self.store.entries(mission, since, most)

    def log(self, mission: MissionId) -> tuple[Entry, ...]:
        """All entries of a mission.

        raises UnknownMissionError: when there is no such mission
        """
        entries = self.store.entries(mission)
        if not entries:
            raise UnknownMissionError(
                f"no mission {mission!r}", hint="the list of missions has their names"
            )
        return entries

    def mission(self, mission: MissionId) -> Mission:
        """Where a mission stands.

        raises PlainspokenError: when there is no such mission
        """
        return mission_from(self.log(mission))

    def site(self, mission: MissionId) -> Site:
        """Where a mission takes place, by its log alone."""
        return site_of(accepted_of(self.log(mission)))

    def is_running(self, mission: MissionId) -> bool:
        """Whether some worker carries it out, here or elsewhere."""
        place = self.store.place(mission)
        return place is not None and place.worker is not None

    def trouble(self, mission: MissionId) -> str | None:
        """Why a worker broke off, where one did."""
        place = self.store.place(mission)
        return None if place is None else place.trouble

    # `seen` is the last step that whoever asks knows of; None asks whatever happened since.

    def pause(self, mission: MissionId, by: str, *, seen: Step | None = None) -> Reply:
        """Have a mission start nothing more.

        It is never refused, whatever others asked meanwhile: that is told, and the robot stands.
        """
        before = self._unseen(mission, seen)
        return replace(self._ask_of(mission, PauseAsked(by)), meanwhile=before)

    def cancel(self, mission: MissionId, by: str, *, seen: Step | None = None) -> Reply:
        """Give a mission up.

        raises UnseenError: when somebody asked for something after `seen`
        """
        return self._ask_of(mission, CancelAsked(by), seen)

    def report(self, mission: MissionId, told: Told) -> Reply:
        return self._ask_of(mission, told)

    def change(self, mission: MissionId, asked: ChangeAsked, *, seen: Step | None = None) -> Reply:
        """Have a mission be about something else.

        raises UnseenError: when somebody asked for something after `seen`
        """
        return self._ask_of(mission, asked, seen)

    def resume(self, mission: MissionId, by: str, *, seen: Step | None = None) -> Reply:
        """Go on with a mission that was paused.

        raises UnseenError: when somebody asked for something after `seen`
        """
        return self._ask_of(mission, ResumeAsked(by), seen)

    def is_heard(self, mission: MissionId, reply: Reply, *, patience: float = HEARD_WITHIN) -> bool:
        """Whether the log holds what a request led to; waits a moment for it."""
        deadline = time.monotonic() + patience
        while not self.store.is_answered(mission, reply.number):
            if time.monotonic() > deadline:
                return False
            time.sleep(TICK / 2)
        return True

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
        moment = Moment(self.log(mission), at, utc_now() if at is None else None)
        length = Length.FULL if full else Length.BRIEF
        return (dialogue or Dialogue()).ask(text, moment, length=length)

    def say(
        self, mission: MissionId, text: str, by: str, conversation: Conversation | None = None
    ) -> Said:
        """Take a question, a report or a change of mind; what is agreed to, the mission is told.

        by: who says it
        """
        moment = Moment(self.log(mission), now=utc_now())
        said = (conversation or Conversation()).say(text, moment)
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

    def _ask_of(self, mission: MissionId, asked: Asked, seen: Step | None = None) -> Reply:
        """Put a request where whoever carries the mission out finds it."""
        entries = self.log(mission)
        if mission_from(entries).is_over:
            raise MissionOverError(
                f"the mission {mission} is over", hint="it can still be asked about"
            )
        if self.store.place(mission) is None:  # it was run before there were places
            self.store.enlist(mission, robots_of(accepted_of(entries)))
        return Reply(self._post(mission, to_message(asked), seen))

    def _post(self, mission: MissionId, document: str, seen: Step | None) -> MessageNumber:
        if seen is None:
            return self.store.post(mission, document)
        while True:
            last = self.store.last_message(mission)
            unseen = self._unseen(mission, seen)
            if unseen:
                raise UnseenError(mission, unseen)
            with suppress(AskedMeanwhileError):  # then it is looked at what that was
                return self.store.post(mission, document, after=last)

    def _unseen(self, mission: MissionId, seen: Step | None) -> tuple[Command, ...]:
        """What was asked of a mission that the log up to a step does not tell."""
        if seen is None:
            return ()
        # First what is not in the log yet: what gets into it meanwhile is found there.
        waiting = [
            Command(by, f"asked to {ask}", None)
            for message in self.store.unanswered(mission)
            for ask, by in [asked_by(message.document)]
            if ask != "report"
        ]
        told = [
            Command(entry.event.by, entry.kind.replace("_", " "), entry.step)
            for entry in self.store.entries(mission, seen + 1)
            if isinstance(entry.event, COMMANDS)
        ]
        return (*told, *waiting)

    def _heard(self, _mission: MissionId, _entry: Entry) -> None:
        self._tell()

    def _tell(self) -> None:
        with self._news:
            self._count += 1
            self._news.notify_all()
