"""Where missions stand, folded from their logs and kept up to date by what is new in them."""

from __future__ import annotations

import threading
from collections import OrderedDict
from dataclasses import dataclass, replace
from functools import reduce

from plainspoken.mission.mission import Mission, MissionId, after, mission_from
from plainspoken.pipeline import Site, accepted_of, site_of
from plainspoken.web.desk import Desk
from plainspoken.world.event import ActionProgressed, ActionStarted, Entry, MissionAccepted, Step

MOST_KEPT = 64
"""Missions whose standing is kept; that of another one is folded again from its whole log."""


@dataclass(frozen=True)
class Standing:
    """A mission at the end of its log.

    seen:     the last step
    began, changed: the times of the first and the last entry
    progress: what the robot said last of the action under way
    """

    mission: Mission
    accepted: MissionAccepted
    site: Site
    seen: Step
    began: str
    changed: str
    progress: ActionProgressed | None = None


class Standings:
    """Where missions stand; asked by any thread, of many missions, many times."""

    def __init__(self, desk: Desk) -> None:
        self._desk = desk
        self._lock = threading.Lock()
        self._kept: OrderedDict[MissionId, Standing] = OrderedDict()

    def of(self, mission: MissionId) -> Standing:
        """Where a mission stands now.

        raises UnknownMissionError: when there is no such mission
        """
        with self._lock:
            known = self._kept.get(mission)
        if known is None:
            standing = _begun(self._desk.log(mission))
        else:
            standing = reduce(_then, self._desk.entries(mission, known.seen + 1), known)
        with self._lock:
            self._kept[mission] = standing
            self._kept.move_to_end(mission)
            if len(self._kept) > MOST_KEPT:
                self._kept.popitem(last=False)
        return standing


def _begun(entries: tuple[Entry, ...]) -> Standing:
    accepted = accepted_of(entries)
    first, last = entries[0], entries[-1]
    progress = None
    for entry in entries:
        progress = _progress(progress, entry)
    return Standing(
        mission_from(entries),
        accepted,
        site_of(accepted),
        last.step,
        first.time,
        last.time,
        progress,
    )


def _then(standing: Standing, entry: Entry) -> Standing:
    return replace(
        standing,
        mission=after(standing.mission, entry.event),
        seen=entry.step,
        changed=entry.time,
        progress=_progress(standing.progress, entry),
    )


def _progress(known: ActionProgressed | None, entry: Entry) -> ActionProgressed | None:
    match entry.event:
        case ActionProgressed():
            return entry.event
        case ActionStarted():
            return None
        case _:
            return known
