"""What `plainspoken missions change` does."""

from __future__ import annotations

import json
import sys
import time
from typing import Any

import click

from plainspoken.cli.asked import askable, confirmed, picked, put, refused
from plainspoken.cli.exit import NO
from plainspoken.cli.robots import person
from plainspoken.cli.store import entries_in
from plainspoken.knowledge.store import Store
from plainspoken.language.extracted import Status
from plainspoken.mission.mission import MissionId, mission_from
from plainspoken.mission.observation import CancelAsked, PauseAsked
from plainspoken.questions.change import wanted
from plainspoken.questions.conversation import message_of
from plainspoken.questions.moment import lexicon_of
from plainspoken.work.shift import TICK
from plainspoken.world.event import ChangeRefused, MissionEnded, RequestChanged, Step

PATIENCE = 60.0
"""Seconds that a plan is waited for; it is made, and gone over to, also after that."""


def changed(
    kept: Store,
    id: MissionId,
    text: str,
    by: str | None,
    *,
    yes: bool,
    instead: bool | None,
    otherwise: str,
    as_json: bool,
) -> None:
    """Understand a change of mind, have it confirmed, ask for it, and say what comes of it."""
    entries = entries_in(kept, id)
    accepted = askable(entries)
    found = wanted(text, mission_from(entries), lexicon_of(accepted), instead=instead)
    if found.status is Status.CLARIFY and not as_json:
        answers = [f"{each.answer}: {each.english}" for each in found.choices]
        number = picked(found.question or "", answers, yes=yes)
        if number is not None:
            found = found.settled_on(found.choices[number])
    elif (
        found.meant is not None
        and not as_json
        and not confirmed(f"From now on: {found.meant.english}", yes=yes)
    ):
        sys.exit(NO)
    document: dict[str, Any] = {"mission": id, "outcome": None, **found.to_json()}
    meant = found.meant
    if meant is None or (as_json and not yes):
        refused(document, found.reason, "nothing is changed", as_json=as_json)
    name = by or person()
    reply = put(kept, id, message_of(found, name))
    outcome, reason = "asked", None
    if reply.heard and reply.worker is not None:
        outcome, reason = _outcome(kept, id, text, len(entries))
        if outcome == "refused" and otherwise != "go-on":
            put(kept, id, PauseAsked(name) if otherwise == "pause" else CancelAsked(name))
    if as_json:
        document |= {"outcome": outcome, "reason": reason}
        click.echo(json.dumps(document, indent=2, ensure_ascii=False))
    elif outcome == "changed":
        click.echo(f"from now on: {meant.english}")
    elif outcome == "refused":
        then = {"go-on": "it goes on as before", "pause": "it is paused", "cancel": "cancelled"}
        click.echo(f"plainspoken: {reason}\nnothing is changed; {then[otherwise]}", err=True)
    else:
        who = reply.worker or "whoever takes the mission up"
        click.echo(f"asked; {who} plans it before the next action")
    if outcome == "refused":
        sys.exit(NO)


def _outcome(kept: Store, id: MissionId, text: str, since: Step) -> tuple[str, str | None]:
    """What came of a change that was heard: changed, refused and why, or still asked for."""
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline:
        for entry in kept.entries(id, since):
            match entry.event:
                case RequestChanged(text=of) if of == text:
                    return "changed", None
                case ChangeRefused(text=of, reason=reason) if of == text:
                    return "refused", reason
                case MissionEnded():
                    return "refused", "the mission was over before that"
                case _:
                    pass
        time.sleep(TICK)
    return "asked", None
