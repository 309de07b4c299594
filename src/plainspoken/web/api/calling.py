"""Who calls, and what they may do: parameters of the routes."""

from __future__ import annotations

from typing import Annotated

from fastapi import Depends, HTTPException, Path, Request

from plainspoken.web.access import Caller
from plainspoken.web.api.office import COMMANDING, THINKING, Office
from plainspoken.web.gate import CALLER
from plainspoken.web.hearing import RECORDINGS


def _office(request: Request) -> Office:
    office: Office = request.app.state.office
    return office


def _caller(request: Request) -> Caller:
    caller: Caller | None = request.scope.get(CALLER)
    if caller is None:  # there is a door beside the gate
        raise HTTPException(401, "nobody is let in without a token")
    return caller


TheOffice = Annotated[Office, Depends(_office)]
TheCaller = Annotated[Caller, Depends(_caller)]


def _operator(caller: TheCaller) -> Caller:
    if not caller.may_command:
        raise HTTPException(403, f"{caller.name} may look and ask, not command")
    return caller


TheOperator = Annotated[Caller, Depends(_operator)]


def _thinking(caller: TheCaller, office: TheOffice) -> None:
    office.rates.spend(THINKING, caller.name)


def _commanding(caller: TheOperator, office: TheOffice) -> None:
    office.rates.spend(COMMANDING, caller.name)


def _listening(caller: TheOperator, office: TheOffice) -> None:
    office.rates.spend(RECORDINGS, caller.name)


THOUGHTFUL = Depends(_thinking)
"""For routes that cost more than looking something up."""
COMMAND = Depends(_commanding)
LISTEN = Depends(_listening)
"""For recordings: they cost seconds."""

MissionName = Annotated[str, Path(min_length=1, max_length=300, description="As in the list.")]
