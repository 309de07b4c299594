"""A process that carries out the missions of a store, several at once, each on a thread."""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager
from datetime import datetime
from typing import Any

from plainspoken.knowledge.database import StoreError
from plainspoken.knowledge.log import OvertakenError
from plainspoken.knowledge.queue import Standing
from plainspoken.knowledge.store import Store
from plainspoken.mission.robot import Robot
from plainspoken.mission.run import Patience, heeding
from plainspoken.pipeline import Site, accepted_of, site_of, take_up
from plainspoken.work.fenced import FencedRobot
from plainspoken.work.shift import TICK, Held, LetGo, Shift, standing_of, utc_now
from plainspoken.world.event import Entry

RobotFor = Callable[
    [Site, Mapping[str, Any], Sequence[Entry]], AbstractContextManager[tuple[Robot, Patience]]
]
"""Reaches the robot that a mission is set for, with how long to wait for it; entries: the log."""
Heard = Callable[[str, Entry], None]
"""Told of each entry of each mission, once it is stored; by the thread that carries it out."""

PATIENCE = 5.0
"""Seconds to wait, when work is to end, for a mission that is being planned for, say."""

log = logging.getLogger(__name__)


class Worker:
    """Takes missions as their robots become free, and takes over from workers that are gone."""

    def __init__(
        self,
        store: Store,
        robot_for: RobotFor,
        *,
        most: int = 8,
        heard: Heard = lambda _mission, _entry: None,
        now: Callable[[], datetime] = utc_now,
    ) -> None:
        """Make a worker that carries out so many missions at once, at most."""
        self._store = store
        self._robot_for = robot_for
        self._most = most
        self._heard = heard
        self.shift = Shift(store, now=now)
        self._threads: dict[Held, threading.Thread] = {}
        self._endings: dict[Held, tuple[Standing, str | None]] = {}
        self._stopped = threading.Event()

    def stop(self) -> None:
        """Hand every mission back as it is; an action that is under way goes on meanwhile."""
        self._stopped.set()

    def run(self, *, until_done: bool = False) -> None:
        """Work until `stop`; until_done: or until no mission is left to carry out.

        raises StoreError: when the store cannot be used to begin with
        """
        self.shift.begin()
        away = False
        while not self._stopped.wait(TICK):
            try:
                if away:
                    self.shift.renew()
                    away = False
                self._round()
                if until_done and not self._threads and self._store.is_done():
                    break
            except StoreError as error:
                if not away:
                    log.warning("the store is away; trying again: %s", error.what)
                away = True
        self._leave()

    def _round(self) -> None:
        self.shift.tick()
        for held, thread in tuple(self._threads.items()):
            if not thread.is_alive():
                self._hand_back(held)
        room = self._most - len(self._threads)
        if room > 0:
            for held in self.shift.take_next(room):
                thread = threading.Thread(
                    target=self._carry, args=(held,), name=f"mission {held.mission}", daemon=True
                )
                self._threads[held] = thread
                thread.start()

    def _hand_back(self, held: Held) -> None:
        standing, trouble = self._endings.get(held, (Standing.GOING, None))
        self.shift.hand_back(held, standing, trouble)
        self._threads.pop(held)
        self._endings.pop(held, None)

    def _leave(self) -> None:
        for held in self._threads:
            held.let_go()
        patient_until = time.monotonic() + PATIENCE
        for held, thread in tuple(self._threads.items()):
            thread.join(max(0.0, patient_until - time.monotonic()))
            self._hand_back(held)
        self.shift.end()

    def _carry(self, held: Held) -> None:
        """Carry a mission out, as far as this process may."""
        trouble = None
        try:
            standing = self._carried(held)
        except (LetGo, OvertakenError, StoreError):
            standing = Standing.GOING  # whoever has it then looks at the log
        except Exception as error:
            log.exception("the mission %s broke off", held.mission)
            # It would break off again: somebody has to ask for it.
            standing, trouble = Standing.RESTING, str(error) or type(error).__name__
        self._endings[held] = standing, trouble

    def _carried(self, held: Held) -> Standing:
        entries = held.entries()
        accepted = accepted_of(entries)
        site = site_of(accepted)
        with self._robot_for(site, accepted.robot, entries) as (robot, patience):
            run = take_up(
                site,
                entries,
                FencedRobot(robot, held),
                heeding(robot, held.record),
                by=held.worker,
                requests=held.requests,
                patience=patience,
            )
            while True:
                try:
                    self._heard(held.mission, next(run))
                except StopIteration as end:
                    return standing_of(end.value)
