"""All missions of the store, the latest first."""

from __future__ import annotations

import asyncio

from plainspoken.web.desk import Desk
from plainspoken.web.page import panels
from plainspoken.web.page.frame import House, Text, Visitor, framed
from plainspoken.web.page.living import Living
from plainspoken.web.page.markup import Html, tag
from plainspoken.web.page.view import age
from plainspoken.work.shift import utc_now

AGAIN = 1.0
"""Seconds until the store is looked at again."""
MOST = 100


class Overview:
    """The list of missions in one browser."""

    def __init__(self, house: House, visitor: Visitor) -> None:
        self.house, self.visitor = house, visitor

    async def build(self) -> None:
        """Lay the page out."""
        with framed(self.visitor, "say"):
            Text("h1", "Missions")
            self.list = Living(await asyncio.to_thread(listed, self.house.desk))

    async def follow(self) -> None:
        """Show what comes."""
        while True:
            await asyncio.sleep(AGAIN)
            self.list.show(await asyncio.to_thread(listed, self.house.desk))


def listed(desk: Desk) -> Html:
    """A card for each mission."""
    found = desk.missions()
    cards = [_card(desk, mission) for mission in reversed(found[-MOST:])]
    if not cards:
        return tag(
            "p", "There are no missions yet. ", tag("a", "Say what should be done", href="/")
        )
    return tag("ul", *cards, class_="missions")


def _card(desk: Desk, id: str) -> Html:
    entries = desk.entries(id)
    mission = desk.mission(id)
    first = entries[0].event
    title = getattr(first, "sentence", None) or getattr(first, "english", "") or id
    trouble = desk.trouble(id)
    return tag(
        "li",
        tag("a", title, href=f"/missions/{id}"),
        tag("span", panels.status(mission.status),
            f" {age(entries[-1].time, utc_now())} ago" if mission.is_over else None),
        tag("p", trouble, class_="refusal") if trouble else None,
        class_="card",
        data_key=id,
    )  # fmt: skip
