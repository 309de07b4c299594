"""The addresses of the page."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine
from typing import Any

from fastapi import Request
from nicegui import Client, ui

from plainspoken.errors import PlainspokenError
from plainspoken.web.page.frame import House, Text, Visitor, framed, share_assets
from plainspoken.web.page.home import Say
from plainspoken.web.page.overview import Overview
from plainspoken.web.page.watch import Watch

VisitorOf = Callable[[Request], Visitor]


def open_pages(house: House, visitor_of: VisitorOf) -> None:
    """Register every page."""
    share_assets()

    @ui.page("/", title="New mission - plainspoken")
    def home(request: Request) -> None:
        Say(house, visitor_of(request)).build()

    @ui.page("/missions", title="Missions - plainspoken")
    async def missions(request: Request, client: Client) -> None:
        overview = Overview(house, visitor_of(request))
        await overview.build()
        _kept_up(client, overview.follow)

    @ui.page("/missions/{mission}", title="Mission - plainspoken")
    async def mission(request: Request, client: Client, mission: str) -> None:
        visitor = visitor_of(request)
        try:
            feed = await asyncio.to_thread(house.feeds.of, mission)
        except PlainspokenError as error:
            client.status_code = 404
            with framed(visitor, "say"):
                Text("h1", error.what)
                Text("a", "All missions").props('href="/missions"')
            return
        watch = Watch(house, visitor, feed)
        watch.build(await asyncio.to_thread(feed.view))
        client.on_delete(feed.watch(watch.news.set))
        _kept_up(client, watch.follow)


def _kept_up(client: Client, follow: Callable[[], Coroutine[Any, Any, None]]) -> None:
    """Run something for as long as a browser has the page open."""
    task = asyncio.create_task(follow())
    client.on_delete(task.cancel)
