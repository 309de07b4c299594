"""One process at work: it is heard of, is told what people ask, and knows what it lost.

    with Shift(store, "here") as shift:
        if shift.take(mission): ...

A mission in its hands is a `Held`: the store refuses what it writes once somebody else has written
to the mission's log, so a process that was taken for dead cannot do harm when it wakes up.
"""

from __future__ import annotations

import os
import queue
import secrets
import socket
import threading
import time
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from datetime import UTC, datetime
from types import TracebackType
from typing import Self

from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.chain import MissionId
from plainspoken.knowledge.database import StoreError, WorkerId
from plainspoken.knowledge.queue import (
    LEASE,
    Message,
    MessageNumber,
    RobotName,
    Seconds,
    Standing,
)
from plainspoken.knowledge.store import Store
from plainspoken.mission.mailbox import Asked, from_message
from plainspoken.mission.mission import Mission
from plainspoken.world.event import Entry, Event, Instant, MissionAccepted, Step

BEAT = LEASE / 6
"""Seconds from one sign of life to the next."""
TICK = 0.1
"""Seconds from one look into the mailbox to the next."""


class LetGo(PlainspokenError):
    """The mission is to be carried out by somebody else from here on."""

    def __init__(self, mission: MissionId) -> None:
        super().__init__(
            f"this process no longer carries the mission {mission} out",
            hint="`plainspoken missions` tells who does",
        )


def new_worker() -> WorkerId:
    """Says where a worker runs, and is not given twice: `farm-7-4021-9c1f`."""
    return f"{socket.gethostname()}-{os.getpid()}-{secrets.token_hex(2)}"


def utc_now() -> datetime:
    """The clock that entries are dated by."""
    return datetime.now(UTC)


def robots_of(accepted: MissionAccepted) -> tuple[RobotName, ...]:
    """The robots that a mission needs for itself; a simulated one without a name is its own."""
    names = accepted.robot.get("names")
    return tuple(names) if names else (f"of mission {accepted.mission}",)


class Held:
    """A mission in the hands of this process."""

    def __init__(
        self,
        store: Store,
        worker: WorkerId,
        mission: MissionId,
        now: Callable[[], datetime],
        silence: Callable[[], Seconds],
        *,
        robots: Iterable[RobotName] = (),
    ) -> None:
        """Take a mission that has a place, or one that is yet to be begun with its robots.

        silence: for how long this process may not have been heard of
        """
        self.mission, self.worker = mission, worker
        self._store = store
        self._step: Step = 0
        self._now = now
        self._silence = silence
        self._robots = tuple(robots)
        self._messages: queue.SimpleQueue[Message] = queue.SimpleQueue()
        self._told: MessageNumber = 0
        self._read: MessageNumber = 0
        self._answered: MessageNumber = 0
        self._let_go = threading.Event()

    def entries(self) -> tuple[Entry, ...]:
        """The log so far; what is recorded from here on has to follow it."""
        entries = self._store.entries(self.mission)
        self._step = len(entries)
        return entries

    def tell(self, message: Message) -> None:
        """Hand a message on, once."""
        if message.number > self._told:
            self._told = message.number
            self._messages.put(message)

    def let_go(self) -> None:
        """Have whoever carries the mission out stop at the next moment, and write nothing more."""
        self._let_go.set()

    def check(self) -> None:
        """Make sure that the mission is still in this process's hands, as far as it can tell.

        raises LetGo: when it is not to go on, or was not heard of for as long as a lease lasts
        """
        if self.is_in_doubt:
            raise LetGo(self.mission)

    @property
    def is_in_doubt(self) -> bool:
        """Whether somebody else may have the mission by now."""
        return self._let_go.is_set() or self._silence() >= LEASE

    def requests(self) -> Asked | None:
        """What was asked, one at a time.

        Whoever asks for the next has decided on the last one: where that led to no entry, it is
        done with, and whoever asked need not wait.
        raises LetGo: when this process is not to go on
        """
        while True:
            if self._let_go.is_set():
                raise LetGo(self.mission)
            with suppress(StoreError):  # it may come back in time
                self.dismiss()
            try:
                message = self._messages.get_nowait()
            except queue.Empty:
                return None
            self._read = message.number
            with suppress(PlainspokenError):  # what nobody can read is dismissed in the end
                return from_message(message.document)

    def record(self, instant: Instant, events: Sequence[Event]) -> Sequence[Entry]:
        """Store events as the next ones of the mission, with what they answer.

        raises OvertakenError: when somebody else goes on with it
        """
        time = self._now().isoformat(timespec="milliseconds")
        if self._step == 0:
            entries = self._store.begin(self.mission, time, events, self._robots, self.worker)
        else:
            answered = self._read if self._read > self._answered else None
            entries = self._store.append(
                self.mission, time, instant, events, at=self._step, answered=answered
            )
        self._step += len(entries)
        self._answered = self._read
        return entries

    def dismiss(self) -> None:
        """Note that what was read, and led to nothing, is done with."""
        if self._read > self._answered:
            self._store.dismiss(self.mission, self._read, self._step)
            self._answered = self._read


def standing_of(mission: Mission) -> Standing:
    """Whether a mission is worth a worker's look."""
    if mission.is_over:
        return Standing.OVER
    return Standing.RESTING if mission.is_at_rest else Standing.GOING


class Shift:
    """A worker's time at the store."""

    def __init__(self, store: Store, *, now: Callable[[], datetime] = utc_now) -> None:
        self.store = store
        self.worker = new_worker()
        self._now = now
        self._held: dict[MissionId, Held] = {}
        self._heard = time.monotonic()
        self._lock = threading.Lock()
        self._ended = threading.Event()
        self._ticking: threading.Thread | None = None

    def __enter__(self) -> Self:
        """Begin, and be heard of from a thread of its own."""
        self.begin()
        self._ticking = threading.Thread(target=self._tick_on, name="shift", daemon=True)
        self._ticking.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._ended.set()
        if self._ticking is not None:
            self._ticking.join()
        with suppress(StoreError):  # the others will notice
            self.end()

    def begin(self) -> None:
        """Be a worker from now on."""
        self._heard = time.monotonic()
        self.store.enrol(self.worker)

    def end(self) -> None:
        """Be no worker any more; what is held can be taken by others."""
        self.store.retire(self.worker)

    @property
    def held(self) -> tuple[Held, ...]:
        with self._lock:
            return tuple(self._held.values())

    def found(self, mission: MissionId, robots: Iterable[RobotName]) -> Held:
        """Hold a mission that is new: its first record gives it a place, and to this worker."""
        return self._hold(mission, robots)

    def take(self, mission: MissionId) -> Held | None:
        """Take one mission, out of turn; None where somebody carries it out, or it is over."""
        if not self.store.claim_this(self.worker, mission):
            return None
        held = self._hold(mission)
        self._hand_on()
        return held

    def take_next(self, most: int) -> tuple[Held, ...]:
        """Take missions that wait, in their order, and those of workers that are gone."""
        held = tuple(self._hold(mission) for mission in self.store.claim(self.worker, most))
        if held:
            self._hand_on()  # a mission at rest is gone on with only for what was asked
        return held

    def _hold(self, mission: MissionId, robots: Iterable[RobotName] = ()) -> Held:
        held = Held(self.store, self.worker, mission, self._now, self._silence, robots=robots)
        with self._lock:
            self._held[mission] = held
        return held

    def hand_back(self, held: Held, standing: Standing, trouble: str | None = None) -> None:
        """Hold a mission no longer."""
        if standing is not Standing.GOING:
            held.dismiss()
        self.store.release(held.worker, held.mission, standing, trouble)
        with self._lock:
            if self._held.get(held.mission) is held:
                del self._held[held.mission]

    def tick(self) -> None:
        """Be heard of, and hand on what was asked.

        Whoever was taken for dead loses all missions, and begins anew under another name.
        """
        if time.monotonic() - self._heard >= BEAT:
            sent = time.monotonic()  # it counts from before the store heard
            if not self.store.beat(self.worker):
                self.renew()
                return
            self._heard = sent
        self._hand_on()

    def _silence(self) -> Seconds:
        return time.monotonic() - self._heard

    def _hand_on(self) -> None:
        held = {each.mission: each for each in self.held}
        if held:
            for message in self.store.messages(self.worker):
                if message.mission in held:
                    held[message.mission].tell(message)

    def renew(self) -> None:
        """Let go of everything, and begin anew under another name."""
        with self._lock:
            for held in self._held.values():
                held.let_go()
            self._held.clear()
        self.end()
        self.worker = new_worker()
        self.begin()

    def _tick_on(self) -> None:
        while not self._ended.wait(TICK):
            with suppress(StoreError):  # it may come back in time
                self.tick()
