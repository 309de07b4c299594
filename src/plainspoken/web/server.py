"""Puts the page, and whatever else is served beside it, together as one application."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import uvicorn
from fastapi import FastAPI
from nicegui import app as nicegui
from nicegui import ui
from starlette.types import ASGIApp

from plainspoken.web.desk import Desk
from plainspoken.web.page.cards import Cards
from plainspoken.web.page.frame import House
from plainspoken.web.page.layout import Layout
from plainspoken.web.page.live import Feeds
from plainspoken.web.page.pages import VisitorOf, open_pages


@dataclass(frozen=True, slots=True)
class Anybody:
    """Whoever sits at this machine."""

    name: str = "operator"
    may_command: bool = True


def create_app(
    desk: Desk,
    *,
    robot: Mapping[str, Any] | None = None,
    layouts: Mapping[str, Layout] | None = None,
    visitor_of: VisitorOf | None = None,
    missing: str | None = None,
) -> FastAPI:
    """The application; one in a process, since NiceGUI has one register of pages.

    robot:      the robot of missions that are started here, for their log
    layouts:    the maps, by the name of the planning problem
    visitor_of: who sends a request, None where everybody may do everything
    missing:    what there is to do before anybody can speak here, None where they can
    """
    app = FastAPI(title="plainspoken", docs_url=None, redoc_url=None)
    house = House(desk, Feeds(desk, layouts or {}), Cards(desk), dict(robot or {}), missing)
    open_pages(house, visitor_of or (lambda _: Anybody()))
    # Quasar's bar for requests has no name that a screen reader could say, and nothing to tell.
    nicegui.config.quasar_config["loadingBar"] = {"skipHijack": True}
    ui.run_with(
        app,
        title="plainspoken",
        dark=None,  # as the system has it
        language="en-US",
        tailwind=False,
        show_welcome_message=False,
        reconnect_timeout=10.0,  # a phone between two vines; what it missed is sent again
    )
    return app


def run(
    app: ASGIApp,
    *,
    host: str,
    port: int,
    tls: tuple[Path | None, Path | None] = (None, None),
) -> None:
    """Serve until the process is told to stop.

    tls: certificate and key
    """
    certificate, key = tls
    uvicorn.run(
        app,
        host=host,
        port=port,
        log_level="warning",
        access_log=False,  # addresses may hold what somebody asked
        server_header=False,
        ws_max_size=1_000_000,
        timeout_graceful_shutdown=2,  # whoever watches would otherwise keep it from ending
        ssl_certfile=certificate,
        ssl_keyfile=key,
    )
