"""The routes put together; every refusal says what is wrong, where, and what to do next."""

from __future__ import annotations

import logging
import secrets
from typing import Any

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from starlette.exceptions import HTTPException
from starlette.responses import Response

from plainspoken import __version__
from plainspoken.errors import PlainspokenError
from plainspoken.web.api import (
    commands,
    events,
    missions,
    planning,
    questions,
    transcripts,
    words,
)
from plainspoken.web.api.office import Office
from plainspoken.web.problem import Problem, refusal, response_of

PREFIX = "/api/v1"

log = logging.getLogger(__name__)

_ABOUT = """\
What the page can do, for programs: say what should get done, confirm it, watch it, interrupt it,
and ask about it. A refusal says what is wrong, where, and what to do next.

Where the server asks for tokens, send `Authorization: Bearer TOKEN`. A viewer may look and ask, an
operator may command. Starting a mission takes a plan and the formula that was said back; other
commands carry `seen`, the last step of the log that you know of, and are refused with 409 where
somebody else has commanded the mission after it.
"""
_REFUSALS: dict[int | str, dict[str, Any]] = {
    400: {"description": "Not a request that can be read."},
    401: {"description": "No token, or a wrong one."},
    403: {"description": "Not allowed."},
    404: {"description": "There is no such thing."},
    405: {"description": "That cannot be done with it."},
    409: {"description": "Not as things stand; somebody else may have commanded meanwhile."},
    413: {"description": "Too large."},
    422: {"description": "A field cannot be used."},
    429: {"description": "Too often, or too much at once; Retry-After says when."},
    503: {"description": "The store is away (Retry-After says until when), or speech is."},
}


def create_api(office: Office) -> FastAPI:
    """The application; it stands behind a gate, at `PREFIX`."""
    api = FastAPI(
        title="plainspoken",
        version=__version__,
        description=_ABOUT,
        docs_url=None,  # its page loads scripts from elsewhere
        redoc_url=None,
        root_path_in_servers=True,
        responses={status: {**each, "model": Problem} for status, each in _REFUSALS.items()},
    )
    api.state.office = office
    for routes in (planning, missions, words, commands, events, questions, transcripts):
        api.include_router(routes.router)
    api.include_router(missions.whole)
    api.add_exception_handler(PlainspokenError, _ours)
    api.add_exception_handler(RequestValidationError, _invalid)
    api.add_exception_handler(HTTPException, _refused)
    api.add_exception_handler(Exception, _unexpected)
    return api


def _ours(_: Request, error: Exception) -> Response:
    assert isinstance(error, PlainspokenError)  # noqa: S101 - as it is registered above
    return response_of(error)


def _invalid(_: Request, error: Exception) -> Response:
    """Say which field is wrong, without saying back what stood in it."""
    assert isinstance(error, RequestValidationError)  # noqa: S101 - as it is registered above
    first = error.errors()[0]
    place = ".".join(str(each) for each in first["loc"])
    if first["type"] == "json_invalid":
        return refusal(400, Problem(what="the body is not JSON", where=place, hint=None))
    what = str(first["msg"])
    return refusal(422, Problem(what=what, where=place, hint="openapi.json has the fields"))


def _refused(_: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)  # noqa: S101 - as it is registered above
    hints = {
        401: "Authorization: Bearer TOKEN",
        403: "ask whoever started the server for the token of an operator",
        404: "openapi.json has the paths",
        405: "openapi.json has the methods",
    }
    problem = Problem(what=str(error.detail), hint=hints.get(error.status_code))
    return refusal(error.status_code, problem, dict(error.headers or {}))


def _unexpected(request: Request, error: Exception) -> Response:
    """What should never happen; it is found again in the log by its number."""
    number = secrets.token_hex(4)
    log.error("%s %s failed (%s)", request.method, request.url.path, number, exc_info=error)
    return refusal(
        500,
        Problem(
            what=f"something went wrong here; it is in the server's log under {number}",
            hint="this is a bug of plainspoken: please report it",
        ),
    )
