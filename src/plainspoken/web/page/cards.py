"""A card for each mission of the store, as HTML."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime

from plainspoken.mission.mission import MissionId, Status, mission_from
from plainspoken.pipeline import accepted_of
from plainspoken.web.desk import Desk
from plainspoken.web.page import panels
from plainspoken.web.page.markup import Html, joined, tag
from plainspoken.world.event import Entry

MOST = 100
"""Missions that are listed."""


class Cards:
    """A card for each mission, made anew only where its log has grown."""

    def __init__(self, desk: Desk) -> None:
        self._desk = desk
        self._known: dict[MissionId, tuple[int, bool, Html]] = {}

    def html(self) -> Html:
        """The latest missions, the last one first."""
        cards = [self._card(mission) for mission in reversed(self._desk.missions()[-MOST:])]
        if not cards:
            begin = tag("a", "Say what should be done", href="/")
            return tag("p", "There are no missions yet. ", begin)
        return tag("ul", *cards, class_="missions")

    def _card(self, id: MissionId) -> Html:
        length, is_over, card = self._known.get(id, (0, False, Html()))
        if not is_over and self._desk.entries(id, length, 1):
            entries = self._desk.log(id)
            mission = mission_from(entries)
            card = _card(id, entries, mission.status)
            self._known[id] = (len(entries), mission.is_over, card)
        trouble = None if is_over else self._desk.trouble(id)
        told = tag("p", trouble, class_="refusal") if trouble else None
        return tag("li", card, told, class_="card", data_key=id)


def _card(id: MissionId, entries: Sequence[Entry], status: Status) -> Html:
    accepted = accepted_of(entries)
    title = accepted.sentence or accepted.english or accepted.goal
    begun = tag("span", f"begun {moment_of(entries[0].time)}", class_="when")
    return joined(
        [tag("a", title, href=f"/missions/{id}"), tag("span", panels.status(status), " ", begun)]
    )


def moment_of(time: str) -> str:
    """When something was, on this machine's clock."""
    return datetime.fromisoformat(time).astimezone().strftime("%d %b, %H:%M")
