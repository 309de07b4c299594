"""What is wrong, where, and what to do next, as JSON: the one form of every refusal."""

from __future__ import annotations

from collections.abc import Iterable

from pydantic import BaseModel, Field
from starlette.responses import JSONResponse

from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.database import StoreError
from plainspoken.knowledge.log import OvertakenError
from plainspoken.language.transcription import TranscriptionError
from plainspoken.web.desk import (
    Command,
    MissionOverError,
    UnknownMissionError,
    UnknownPlaceError,
    UnseenError,
)
from plainspoken.web.rate import TooManyError


class Unseen(BaseModel):
    """What somebody asked of a mission; step: where its log says so, if it does yet."""

    by: str
    asked: str = Field(examples=["paused"])
    step: int | None


class Problem(BaseModel):
    """Why a request was refused."""

    what: str = Field(description="What is wrong, in a sentence.")
    where: str | None = Field(default=None, description="The field, line or place.")
    hint: str | None = Field(default=None, description="What to do next.")
    unseen: list[Unseen] = Field(
        default=[],
        description="What others asked of the mission, which this request does not know of.",
    )


_STATUS: tuple[tuple[type[PlainspokenError], int], ...] = (
    (UnknownMissionError, 404),
    (UnknownPlaceError, 404),
    (UnseenError, 409),
    (MissionOverError, 409),
    (OvertakenError, 409),
    (TooManyError, 429),
    (StoreError, 503),
    (TranscriptionError, 503),
)


def status_of(error: PlainspokenError) -> int:
    """The HTTP status of an error; 422 for all that is about what was given to us."""
    return next((status for kind, status in _STATUS if isinstance(error, kind)), 422)


def problem_of(error: PlainspokenError) -> Problem:
    """An error as it is told."""
    return Problem(
        what=error.what,
        where=error.where,
        hint=error.hint,
        unseen=told(error.commands) if isinstance(error, UnseenError) else [],
    )


def told(commands: Iterable[Command]) -> list[Unseen]:
    """Commands as they are told."""
    return [Unseen(by=each.by, asked=each.asked, step=each.step) for each in commands]


def response_of(error: PlainspokenError) -> JSONResponse:
    """The response to a request that led to an error."""
    headers = {"Retry-After": str(error.after)} if isinstance(error, TooManyError) else {}
    if isinstance(error, StoreError):
        headers["Retry-After"] = "5"
    return refusal(status_of(error), problem_of(error), headers)


def refusal(status: int, problem: Problem, headers: dict[str, str] | None = None) -> JSONResponse:
    """A response that says what is wrong."""
    return JSONResponse(problem.model_dump(), status, headers)
