"""Asking services about single facts, one way after the other, without waiting for any.

Each call has a name made of the look, the fact and the way: a process that takes over asks under
the same names, and so finds the question that a person was asked before. How long something may
take, and how often it is tried, counts anew.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from datetime import UTC, datetime

from plainspoken.mission.repertoire import Ask, Offer, Sensor
from plainspoken.mission.robot import Seconds, Unheard, Unreachable
from plainspoken.mission.sensing import LookId, Telling
from plainspoken.mission.service import CallId, CallStatus, Done, NotDone, Service
from plainspoken.mission.template import Table, UnfilledError, filled
from plainspoken.world.domain import GroundAtom

POLL: Seconds = 0.05
"""How often a question under way is asked about."""
PAUSE: Seconds = 1.0
"""From one try to the next."""


@dataclass
class _Question:
    """One fact that somebody is asked about. way, tried: which service, for the how-manieth time.

    until: when the try is over, None where it has not begun; after: when the next may begin
    """

    atom: GroundAtom
    sensor: Sensor
    values: Mapping[str, str]
    way: int = 0
    tried: int = 0
    until: Seconds | None = None
    after: Seconds = 0.0
    why: str = "nothing can be asked"
    told: Telling | None = None


class Looking:
    """Looks at facts through the services of a robots' file."""

    def __init__(
        self,
        sensors: Sequence[Sensor],
        services: Mapping[str, Service],
        offers: Mapping[str, Offer],
        objects: Table,
        *,
        clock: Callable[[], Seconds] = time.monotonic,
        sleep: Callable[[Seconds], None] = time.sleep,
    ) -> None:
        self._sensors = tuple(sensors)
        self._services, self._offers, self._objects = services, offers, objects
        self._clock, self._sleep = clock, sleep
        self._looks: dict[LookId, dict[GroundAtom, _Question]] = {}

    def sense(
        self, look: LookId, atoms: Sequence[GroundAtom], timeout: Seconds
    ) -> tuple[Telling, ...] | None:
        """What is told of each fact; None while something is still asked."""
        questions = self._looks.setdefault(look, {})
        for atom in questions.keys() - set(atoms):  # somebody has told of it in another way
            self._take_back(look, questions.pop(atom))
        for atom in atoms:
            if atom not in questions:
                questions[atom] = self._question(atom)
        wanted = [questions[atom] for atom in atoms]
        until = self._clock() + timeout
        while True:
            for question in wanted:
                if question.told is None:
                    self._go_on(look, question)
            told = tuple(each.told for each in wanted if each.told is not None)
            if len(told) == len(wanted):
                self._looks.pop(look, None)
                return told
            left = until - self._clock()
            if left <= 0:
                return None
            self._sleep(min(POLL, left))

    def dismiss(self, look: LookId) -> None:
        """Nobody waits for a look any longer: what is still asked is taken back.

        What was told stays told, with its time: the look may be asked for again.
        """
        questions = self._looks.get(look, {})
        for atom in [each.atom for each in questions.values() if each.told is None]:
            self._take_back(look, questions.pop(atom))

    def _question(self, atom: GroundAtom) -> _Question:
        for sensor in self._sensors:
            values = sensor.values(atom)
            if values is not None:
                return _Question(atom, sensor, values)
        return _Question(atom, Sensor(atom, (), ()), {})

    def _go_on(self, look: LookId, question: _Question) -> None:
        """Have one question go on as far as it can at this moment."""
        if question.way >= len(question.sensor.ways):
            by = question.sensor.ways[-1].service if question.sensor.ways else "nobody"
            question.told = Telling(question.atom, None, by, _now(), why=question.why)
            return
        if self._clock() < question.after:
            return
        ask = question.sensor.ways[question.way]
        try:
            status = self._status(look, question, ask)
        except Unreachable as error:
            self._try_again(question, error.what)
            return
        except UnfilledError as error:
            self._next_way(question, f"{ask.service} cannot be asked: {error.what}")
            return
        match status:
            case Done(result):
                offer = self._offers[ask.service]
                holds = ask.told(result, question.values, self._objects, offer)
                if holds is None:
                    self._next_way(question, f"{ask.service} gave {dict(result)}")
                    return
                reporter = result.get("reporter")
                question.told = Telling(
                    question.atom,
                    holds,
                    ask.service,
                    _now(),
                    None if reporter is None else str(reporter),
                )
            case NotDone(reason):
                self._next_way(question, f"{ask.service}: {reason}")
            case Unheard():
                self._try_again(question, f"{ask.service} has forgotten the question")
            case _ if question.until is not None and self._clock() >= question.until:
                limit = self._offers[ask.service].limit
                self._take_back(look, question)
                self._try_again(question, f"no answer from {ask.service} in {limit:g} s")

    def _status(self, look: LookId, question: _Question, ask: Ask) -> CallStatus:
        """What became of a try, which is begun where it was not."""
        service, call = self._services[ask.service], _call(look, question)
        if question.until is None:
            question.until = self._clock() + self._offers[ask.service].limit
            service.begin(call, filled(ask.fields, question.values, self._objects))
        return service.status(call)

    def _try_again(self, question: _Question, why: str) -> None:
        question.tried += 1
        question.until, question.why = None, why
        question.after = self._clock() + PAUSE
        if question.tried >= question.sensor.tries:
            self._next_way(question, why)

    def _next_way(self, question: _Question, why: str) -> None:
        question.way, question.tried = question.way + 1, 0
        question.until, question.after, question.why = None, 0.0, why

    def _take_back(self, look: LookId, question: _Question) -> None:
        """Give up a try, where one is under way."""
        if question.told is not None or question.until is None:
            return
        service = self._services[question.sensor.ways[question.way].service]
        with suppress(Unreachable):
            service.cancel(_call(look, question))


def _call(look: LookId, question: _Question) -> CallId:
    """`m/look-2:full_b#0.1`: the second look at a fact, the first way, the second time."""
    return f"{look}:{question.atom.replace(' ', '_')}#{question.way}.{question.tried}"


def _now() -> str:
    return datetime.now(UTC).isoformat(timespec="milliseconds")
