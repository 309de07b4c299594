"""What an operator says to a mission in words: reports, and changes of mind; each is said back."""

from __future__ import annotations

from fastapi import APIRouter, HTTPException

from plainspoken.mission.observation import ChangeAsked
from plainspoken.questions.change import ChangeOfMind, wanted
from plainspoken.questions.moment import lexicon_of
from plainspoken.questions.report import understood
from plainspoken.web.api.calling import (
    COMMAND,
    THOUGHTFUL,
    MissionName,
    TheCaller,
    TheOffice,
    TheOperator,
)
from plainspoken.web.api.commands import heard, known
from plainspoken.web.api.model import ChangeRead, Changing, Heard, ReportRead, Words
from plainspoken.web.api.office import Office

router = APIRouter(tags=["commands"])


@router.post("/missions/{mission:path}/reports/understandings", dependencies=[THOUGHTFUL])
def read_report(mission: MissionName, words: Words, office: TheOffice, _: TheCaller) -> ReportRead:
    """What a report in words comes to. To record it, send `added` and `deleted` to `reports`."""
    standing = office.standings.of(mission)
    accepted = standing.accepted
    world = standing.mission.world
    report = understood(words.text, lexicon_of(accepted), world, accepted.unknown)
    facts = {"added": sorted(report.added), "deleted": sorted(report.deleted)}
    return ReportRead.model_validate(report.to_json() | facts)


@router.post("/missions/{mission:path}/changes/understandings", dependencies=[THOUGHTFUL])
def read_change(mission: MissionName, words: Words, office: TheOffice, _: TheCaller) -> ChangeRead:
    """What a change of mind comes to. To make it, send its English to `changes`."""
    return ChangeRead.model_validate(_meant(office, mission, words.text).to_json())


@router.post("/missions/{mission:path}/changes", dependencies=[COMMAND])
def change(mission: MissionName, asked: Changing, office: TheOffice, caller: TheOperator) -> Heard:
    """Have the mission be about something else, once it is planned; the log says what came of it.

    409 where the words mean something else by now, or others asked something after `seen`.
    """
    seen = known(office, mission, asked.seen)
    found = _meant(office, mission, asked.text)
    meant = found.meant or next((c for c in found.choices if c.answer == asked.answer), None)
    if meant is None:
        raise HTTPException(422, found.reason or found.question or "that is no change")
    if meant.english != asked.confirm:
        raise HTTPException(409, f"it was not confirmed; it would be: {meant.english}")
    change = ChangeAsked(caller.name, asked.text, meant.clauses, meant.english)
    return heard(office, mission, office.desk.change(mission, change, seen=seen))


def _meant(office: Office, mission: str, text: str) -> ChangeOfMind:
    standing = office.standings.of(mission)
    return wanted(text, standing.mission, lexicon_of(standing.accepted))
