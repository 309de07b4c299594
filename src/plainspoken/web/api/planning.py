"""Before a mission: places, what a sentence asks for, and whether it can be done."""

from __future__ import annotations

import asyncio
import threading
import time
from typing import Any

from fastapi import APIRouter, Request, Response

from plainspoken.errors import PlainspokenError
from plainspoken.logic.formula import Formula
from plainspoken.logic.syntax import parse, unparse
from plainspoken.pipeline import why_not
from plainspoken.planning.goal import denotations
from plainspoken.planning.solver import Ending, Solved, Unsolvable
from plainspoken.web.api.calling import COMMAND, THOUGHTFUL, TheCaller, TheOffice, TheOperator
from plainspoken.web.api.model import Place, Planned, PlanWanted, Saying, Understanding
from plainspoken.web.api.office import Office, WaitingPlan
from plainspoken.web.desk import PlaceName, PlanningStopped

router = APIRouter(tags=["before a mission"])

GONE = 499
"""What is written to the access log where whoever asked has gone, as other servers do."""


@router.get("/places")
def places(office: TheOffice, _: TheCaller) -> list[Place]:
    """The places that missions can be started at."""
    return [
        Place(place=name, landmarks=len(site.landmarks))
        for name, site in office.desk.places.items()
    ]


@router.post("/places/{place}/understandings", dependencies=[THOUGHTFUL])
def understand(place: str, saying: Saying, office: TheOffice, _: TheCaller) -> Understanding:
    """What a sentence asks for: a formula, a question back with alternatives, or why neither.

    Nothing is started by it.
    """
    extraction = office.desk.understand(place, saying.sentence)
    return Understanding.model_validate(extraction.to_json())


@router.post(
    "/places/{place}/plans",
    dependencies=[COMMAND],
    response_model=Planned,
)
async def plan(
    place: str, wanted: PlanWanted, request: Request, office: TheOffice, caller: TheOperator
) -> Any:
    """Find a policy for a formula, and have it validated.

    The plan is kept for a quarter of an hour; start it with `POST /missions`. Planning stops when
    you hang up.
    """
    goal = await asyncio.to_thread(_goal, office, place, wanted.formula)
    started = time.perf_counter()
    office.planners.take(caller.name)
    ending = await _ending(office, request, caller.name, (place, goal, wanted.timeout))
    if ending is None:
        return Response(status_code=GONE)
    seconds = time.perf_counter() - started
    site = office.desk.places[place]
    told = Planned(
        status="solved",
        formula=unparse(goal),
        english=site.in_words(goal),
        seconds=round(seconds, 3),
    )
    if not isinstance(ending, Solved):
        told.status = "unsolvable" if isinstance(ending, Unsolvable) else "out_of_time"
        told.reason = await asyncio.to_thread(why_not, ending, site)
        return told
    policy = ending.policy
    kept = WaitingPlan(caller.name, place, goal, wanted.sentence, policy)
    told.plan = office.plans.keep(kept)
    told.kind, told.nodes = policy.kind, len(policy.nodes)
    told.first_action = policy.by_id[policy.initial].action
    return told


def _goal(office: Office, place: PlaceName, text: str) -> Formula:
    """Read a formula over the symbols of a place.

    raises PlainspokenError: when it is none
    """
    problem = office.desk.place(place).problem
    try:
        goal = parse(text)
        denotations(goal, problem)
    except RecursionError as error:
        raise PlainspokenError(
            "the formula is nested too deeply", where="body.formula", hint="write it flatter"
        ) from error
    return goal


async def _ending(
    office: Office, request: Request, who: str, wanted: tuple[PlaceName, Formula, float]
) -> Ending | None:
    """How planning ends, off the event loop; None where nobody waits for it any more.

    The seat of a planner is left when its thread ends, not when somebody hangs up.
    """
    place, goal, seconds = wanted
    stopped = threading.Event()

    def planned() -> Ending | None:
        try:
            return office.desk.plan(place, goal, timeout=seconds, stopped=stopped)
        except PlanningStopped:
            return None
        finally:
            office.planners.leave(who)

    work = asyncio.ensure_future(asyncio.to_thread(planned))
    gone = asyncio.ensure_future(_hung_up(request))
    try:
        await asyncio.wait({work, gone}, return_when=asyncio.FIRST_COMPLETED)
        return work.result() if work.done() else None
    finally:
        stopped.set()
        gone.cancel()


async def _hung_up(request: Request) -> None:
    """Wait until whoever asked has gone."""
    while (await request.receive())["type"] != "http.disconnect":
        pass
