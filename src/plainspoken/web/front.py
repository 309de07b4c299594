"""All that is served, behind one gate: the page, logging in, and the interface for programs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from fastapi import FastAPI, Request
from starlette.routing import Mount
from starlette.types import ASGIApp

from plainspoken.web.access import Access, Caller
from plainspoken.web.address import Names
from plainspoken.web.api import Office, create_api
from plainspoken.web.api.application import PREFIX
from plainspoken.web.desk import Desk
from plainspoken.web.gate import CALLER, Gate, Limits
from plainspoken.web.hearing import Hearing
from plainspoken.web.login import login_routes
from plainspoken.web.rate import Rates


def behind_gate(
    page: FastAPI,
    desk: Desk,
    access: Access,
    names: Names,
    *,
    robot: Mapping[str, Any] | None = None,
    limits: Limits | None = None,
    hearing: Hearing | None = None,
) -> ASGIApp:
    """The page with everything beside it, as one application.

    page:    what is served wherever nothing else is
    robot:   carries out what programs start, for its log
    hearing: of what is said into a microphone
    """
    rates = Rates()
    beside = [
        Mount(PREFIX, create_api(Office(desk, robot=robot, rates=rates, hearing=hearing))),
        *login_routes(access, rates),
    ]
    page.router.routes[:0] = beside  # before the page, which answers to every path
    return Gate(page, access, names, limits=limits, rates=rates)


def caller_of(request: Request) -> Caller:
    """Who asks for a page: the gate has said so."""
    caller: Caller = request.scope[CALLER]
    return caller
