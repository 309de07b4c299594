"""Asking something of a mission, whichever process carries it out, or none."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from plainspoken.knowledge.chain import MissionId
from plainspoken.knowledge.database import WorkerId
from plainspoken.knowledge.queue import RobotName, Seconds
from plainspoken.knowledge.store import Store
from plainspoken.mission.executive import advance
from plainspoken.mission.mailbox import Asked, to_message
from plainspoken.mission.mission import Mission, mission_from
from plainspoken.mission.observation import LookAsked
from plainspoken.work.shift import TICK, Shift, standing_of
from plainspoken.world.domain import GroundAtom
from plainspoken.world.event import ObservationMade, ReportReceived


@dataclass(frozen=True)
class Reply:
    """What became of a request.

    heard:  whether it is in the log
    worker: who carries the mission out, None where nobody does
    others: whether there are workers who may take it up
    """

    mission: Mission
    heard: bool
    worker: WorkerId | None
    others: bool = False


def ask_of(
    store: Store,
    mission: MissionId,
    asked: Asked,
    robots: Iterable[RobotName],
    *,
    patience: Seconds = 2.0,
    sleep: Callable[[Seconds], None] = time.sleep,
) -> Reply:
    """Ask something of a mission, and wait a moment for it to be taken up.

    robots: for a mission of an older store, which has no place yet
    Where nobody carries the mission out, what it leads to is written to its log at once.
    raises PlainspokenError: when the mission is over
    """
    if store.place(mission) is None:
        store.enlist(mission, robots)
    number = store.post(mission, to_message(asked))
    with Shift(store) as shift:
        for _ in range(max(1, round(patience / TICK))):
            if all(message.number != number for message in store.unanswered(mission)):
                break
            if _settled(shift, mission):
                break
            sleep(TICK)
    place = store.place(mission)
    return Reply(
        mission_from(store.entries(mission)),
        all(message.number != number for message in store.unanswered(mission)),
        None if place is None else place.worker,
        bool(store.workers()),
    )


def look(
    store: Store,
    mission: MissionId,
    atoms: frozenset[GroundAtom],
    by: str,
    robots: Iterable[RobotName],
    *,
    patience: Seconds = 10.0,
    sleep: Callable[[Seconds], None] = time.sleep,
) -> bool:
    """Have a mission's robot look at facts; whether all of them were looked at in time.

    False as well where nobody carries missions out who could look. What was asked for stays
    asked for: whoever takes the mission up looks.
    """
    place = store.place(mission)
    if place is None or not (place.worker or store.workers()):
        return False
    before = len(store.entries(mission))
    ask_of(store, mission, LookAsked(by, atoms), robots, patience=min(patience, 2.0), sleep=sleep)
    until = time.monotonic() + patience
    while True:
        events = [entry.event for entry in store.entries(mission, before)]
        seen = {
            each["atom"]
            for event in events
            if isinstance(event, ObservationMade | ReportReceived)
            for each in (event.sensed if isinstance(event, ObservationMade) else event.told)
        }
        if atoms <= seen:
            return True
        if time.monotonic() >= until:
            return False
        sleep(TICK)


def _settled(shift: Shift, mission: MissionId) -> bool:
    """Answer what was asked of a mission that nobody carries out; False where somebody does."""
    held = shift.take(mission)
    if held is None:
        return False
    now = mission_from(held.entries())
    asked = held.requests()
    while asked is not None:
        decided = advance(now, asked)
        if decided.events:
            held.record(decided.mission.instant, decided.events)
        now = decided.mission
        asked = held.requests()
    held.dismiss()
    shift.hand_back(held, standing_of(now))
    return True
