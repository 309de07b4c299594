"""Missions: what there is, how each stands, and starting one."""

from __future__ import annotations

from typing import Annotated, Any

from fastapi import APIRouter, HTTPException, Query, Response

from plainspoken.knowledge.queue import Place
from plainspoken.logic.english import say
from plainspoken.logic.formula import conjunction
from plainspoken.logic.syntax import unparse
from plainspoken.mission.mission import Mission as MissionState
from plainspoken.mission.mission import new_mission_id
from plainspoken.pipeline import Request
from plainspoken.questions.demand import demands_of
from plainspoken.questions.moment import lexicon_of
from plainspoken.web.api.calling import COMMAND, MissionName, TheCaller, TheOffice, TheOperator
from plainspoken.web.api.model import (
    Clause,
    Mission,
    Missions,
    MissionSummary,
    MissionWanted,
    Plan,
    UnderWay,
)
from plainspoken.web.standing import Standing
from plainspoken.work.shift import robots_of, utc_now
from plainspoken.world.event import PolicyChosen

router = APIRouter(tags=["missions"])
whole = APIRouter(tags=["missions"])
"""Comes after all routes whose paths go on behind the name: that of a mission inside an action has
slashes."""

MOST_LISTED = 50


@router.get("/missions")
def missions(
    office: TheOffice,
    _: TheCaller,
    most: Annotated[int, Query(ge=1, le=MOST_LISTED)] = 20,
    before: Annotated[str | None, Query(max_length=300)] = None,
) -> Missions:
    """The missions, newest first."""
    names = office.desk.missions()[::-1]
    if before is not None:
        if before not in names:
            raise HTTPException(404, f"no mission {before!r}")
        names = names[names.index(before) + 1 :]
    found = [MissionSummary(**_summary(office.standings.of(name))) for name in names[:most]]
    return Missions(missions=found, before=found[-1].mission if len(names) > most else None)


@router.post("/missions", status_code=201, dependencies=[COMMAND])
def start(
    wanted: MissionWanted, response: Response, office: TheOffice, caller: TheOperator
) -> Mission:
    """Have a plan carried out. `confirm` is the formula that was said back to you."""
    plan = office.plans.get(wanted.plan, caller)
    if plan is None:
        raise HTTPException(404, "no such plan of yours, or it is too old: plan again")
    if wanted.confirm != unparse(plan.goal):
        raise HTTPException(409, f"another formula was planned for: {unparse(plan.goal)}")
    if not office.plans.take(wanted.plan):
        raise HTTPException(409, "the plan is being carried out already")
    request = Request(new_mission_id(utc_now), plan.goal, plan.sentence, {**office.robot})
    mission = office.desk.start(plan.place, request, plan.policy)
    response.headers["Location"] = f"missions/{mission}"
    return _whole(office.standings.of(mission), office.desk.store.place(mission))


@router.get("/missions/{mission:path}/policy")
def policy(mission: MissionName, office: TheOffice, _: TheCaller) -> dict[str, Any]:
    """The policy that is followed, as `plainspoken plan --out` writes it."""
    chosen = [
        entry.event for entry in office.desk.log(mission) if isinstance(entry.event, PolicyChosen)
    ]
    if not chosen:
        raise HTTPException(404, f"the mission {mission} has no policy yet")
    return dict(chosen[-1].policy)


def _summary(standing: Standing) -> dict[str, Any]:
    mission, accepted = standing.mission, standing.accepted
    return {
        "mission": mission.id,
        "status": str(mission.status),
        "over": mission.is_over,
        "satisfied": mission.satisfied,
        "sentence": accepted.sentence,
        "english": accepted.english,
        "seen": standing.seen,
        "instant": mission.instant,
        "began": standing.began,
        "changed": standing.changed,
    }


def _whole(standing: Standing, place: Place | None) -> Mission:
    mission = standing.mission
    return Mission(
        **_summary(standing),
        formula=standing.accepted.goal,
        clauses=_clauses(standing),
        now=_under_way(standing),
        plan=_plan(mission),
        state=sorted(mission.state),
        robots=list(robots_of(standing.accepted)),
        worker=place.worker if place else None,
        trouble=place.trouble if place else None,
        paused_by=mission.paused_by,
        ended=mission.ended.reason if mission.ended else None,
    )


def _clauses(standing: Standing) -> list[Clause]:
    """Each part of the request as a person gave it."""
    found = []
    for demand in demands_of(standing.mission.monitor.parts):
        formula = conjunction(*(part.formula for part in demand.parts))
        english = say(formula, standing.site.landmarks)
        found.append(Clause(formula=unparse(formula), english=english, verdict=demand.verdict))
    return found


def _under_way(standing: Standing) -> UnderWay | None:
    goal, progress = standing.mission.in_flight, standing.progress
    if goal is None:
        return None
    return UnderWay(
        action=goal.action,
        words=lexicon_of(standing.accepted).deed(goal.action).doing,
        overdue=goal.overdue,
        progress=progress.progress if progress else None,
        doing=progress.doing if progress else None,
    )


def _plan(mission: MissionState) -> Plan | None:
    policy = mission.policy
    if policy is None or mission.is_over:
        return None
    node = None if mission.node is None else policy.by_id.get(mission.node)
    return Plan(
        kind=policy.kind,
        nodes=len(policy.nodes),
        node=mission.node,
        next_action=node.action if node else None,
    )


@whole.get("/missions/{mission:path}")
def mission(mission: MissionName, office: TheOffice, _: TheCaller) -> Mission:
    """How a mission stands: its status, the verdict of each part, what is done now, the plan."""
    return _whole(office.standings.of(mission), office.desk.store.place(mission))
