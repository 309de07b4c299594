"""Puts the page, and whatever else is served beside it, together as one application."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import uvicorn
from fastapi import FastAPI, Request
from nicegui import ui
from starlette.types import ASGIApp

from plainspoken.web.desk import Desk
from plainspoken.web.page.pages import open_pages


@dataclass(frozen=True, slots=True)
class Visitor:
    """Who looks at the page, and whether they may do more than look and ask."""

    name: str
    may_command: bool = True


VisitorOf = Callable[[Request], Visitor]


@dataclass(frozen=True)
class Setting:
    """How the page is set.

    robot:    the robot of missions that are started here, for their log
    layouts:  by place, where things lie on its map, see docs/page.md
    """

    robot: Mapping[str, Any] = field(default_factory=dict)
    layouts: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)


def create_app(desk: Desk, visitor_of: VisitorOf, setting: Setting | None = None) -> FastAPI:
    """The application; one in a process, since NiceGUI has one page register."""
    app = FastAPI(title="plainspoken", docs_url=None, redoc_url=None)
    open_pages(desk, visitor_of, setting or Setting())
    ui.run_with(app, title="plainspoken", dark=None, tailwind=False, show_welcome_message=False)
    return app


def run(app: ASGIApp, *, host: str, port: int) -> None:
    """Serve until the process is told to stop."""
    uvicorn.run(app, host=host, port=port, log_level="warning", ws_max_size=1_000_000)
