"""All missions of the store, the latest first."""

from __future__ import annotations

import asyncio

from plainspoken.web.page.frame import House, Text, Visitor, framed
from plainspoken.web.page.living import Living

AGAIN = 1.0
"""Seconds until the store is looked at again."""


class Overview:
    """The list of missions in one browser."""

    def __init__(self, house: House, visitor: Visitor) -> None:
        self.house, self.visitor = house, visitor

    async def build(self) -> None:
        """Lay the page out."""
        with framed(self.visitor, "say"):
            Text("h1", "Missions")
            self.list = Living(await asyncio.to_thread(self.house.cards.html))

    async def follow(self) -> None:
        """Show what comes."""
        while True:
            await asyncio.sleep(AGAIN)
            self.list.show(await asyncio.to_thread(self.house.cards.html))
