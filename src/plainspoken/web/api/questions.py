"""Asking a mission what it does, has done, will do, and why."""

from __future__ import annotations

import time

from fastapi import APIRouter, HTTPException

from plainspoken.web.api.calling import THOUGHTFUL, MissionName, TheCaller, TheOffice
from plainspoken.web.api.model import Answer, Asking

router = APIRouter(tags=["questions"], dependencies=[THOUGHTFUL])


@router.post("/missions/{mission:path}/questions")
def ask(mission: MissionName, asking: Asking, office: TheOffice, caller: TheCaller) -> Answer:
    """Answer a question from the log and the policy alone; every claim has its evidence."""
    seen = office.standings.of(mission).seen
    if asking.at is not None and asking.at > seen:
        raise HTTPException(422, f"there is no step {asking.at}: the last one is {seen}")
    started = time.perf_counter()
    with office.askers.seat(caller.name):
        found, _ = office.desk.ask(mission, asking.question, at=asking.at, full=asking.full)
    seconds = time.perf_counter() - started
    document = found.to_json(None, asking.question, round(seconds, 4))
    return Answer.model_validate(document)
