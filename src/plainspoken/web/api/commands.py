"""What an operator may ask of a mission; it reaches whichever process carries the mission out."""

from __future__ import annotations

from fastapi import APIRouter, HTTPException

from plainspoken.errors import PlainspokenError
from plainspoken.mission.observation import Told
from plainspoken.web.api.calling import COMMAND, MissionName, TheOffice, TheOperator
from plainspoken.web.api.model import (
    Cancelling,
    Heard,
    Pausing,
    Reporting,
    Resuming,
)
from plainspoken.web.api.office import Office
from plainspoken.web.desk import Reply
from plainspoken.web.problem import told
from plainspoken.world.domain import GroundAtom, Problem
from plainspoken.world.event import Step

router = APIRouter(tags=["commands"], dependencies=[COMMAND])


@router.post("/missions/{mission:path}/pause")
def pause(mission: MissionName, asked: Pausing, office: TheOffice, caller: TheOperator) -> Heard:
    """Have no further action started; one that is under way comes to its end.

    It is never refused for what others asked: that is told in `meanwhile`.
    """
    seen = known(office, mission, asked.seen)
    return heard(office, mission, office.desk.pause(mission, caller.name, seen=seen))


@router.post("/missions/{mission:path}/resume")
def resume(mission: MissionName, asked: Resuming, office: TheOffice, caller: TheOperator) -> Heard:
    """Go on with a mission that was paused; 409 where others asked something after `seen`."""
    seen = known(office, mission, asked.seen)
    return heard(office, mission, office.desk.resume(mission, caller.name, seen=seen))


@router.post("/missions/{mission:path}/cancel")
def cancel(
    mission: MissionName, asked: Cancelling, office: TheOffice, caller: TheOperator
) -> Heard:
    """Give a mission up; 409 where others asked something after `seen`."""
    seen = known(office, mission, asked.seen)
    return heard(office, mission, office.desk.cancel(mission, caller.name, seen=seen))


@router.post("/missions/{mission:path}/reports")
def report(mission: MissionName, asked: Reporting, office: TheOffice, caller: TheOperator) -> Heard:
    """Tell what you did or saw; the mission goes by it from there on."""
    problem = office.standings.of(mission).site.problem
    added = frozenset(_fact(atom, problem, "body.added") for atom in asked.added)
    deleted = frozenset(_fact(atom, problem, "body.deleted") for atom in asked.deleted)
    reply = office.desk.report(mission, Told(caller.name, asked.text, added, deleted))
    return heard(office, mission, reply)


def known(office: Office, mission: str, seen: Step | None) -> Step | None:
    """A step that whoever commands can have seen.

    raises HTTPException: when the log does not go so far
    """
    last = office.standings.of(mission).seen
    if seen is not None and seen > last:
        raise HTTPException(422, f"nobody has seen step {seen}: the last one is {last}")
    return seen


def _fact(text: str, problem: Problem, where: str) -> GroundAtom:
    """A fact of the problem that may change.

    raises PlainspokenError: when the text is none
    """
    predicate, *arguments = text.lower().split() or [""]
    parameters = problem.domain.predicates.get(predicate)
    if parameters is None:
        raise PlainspokenError(
            f"the domain has no predicate {predicate!r}",
            where=where,
            hint=f"it has {', '.join(problem.domain.predicates)}",
        )
    if predicate not in problem.changing_predicates:
        raise PlainspokenError(f"{predicate} never changes, so it cannot be told", where=where)
    fits = len(parameters) == len(arguments) and all(
        argument in problem.objects_for(parameter)
        for parameter, argument in zip(parameters, arguments, strict=True)
    )
    if not fits:
        wanted = " ".join(" or ".join(each.types) for each in parameters)
        raise PlainspokenError(
            f"not a fact: {text!r}", where=where, hint=f"expected {predicate} {wanted}".strip()
        )
    return " ".join([predicate, *arguments])


def heard(office: Office, mission: str, reply: Reply) -> Heard:
    """What became of a command, once its mission had a moment to hear it."""
    is_heard = office.desk.is_heard(mission, reply, patience=office.patience)
    standing = office.standings.of(mission)
    return Heard(
        heard=is_heard,
        seen=standing.seen,
        status=standing.mission.status,
        meanwhile=told(reply.meanwhile),
    )
