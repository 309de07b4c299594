"""What commands that ask something of a mission have in common: which one, and what came of it."""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping, Sequence
from typing import Any, NoReturn

import click

from plainspoken.cli.exit import NO
from plainspoken.cli.store import entries_in
from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.store import Store
from plainspoken.language.extracted import Status
from plainspoken.mission.mailbox import Asked
from plainspoken.mission.mission import mission_from
from plainspoken.pipeline import accepted_of
from plainspoken.work.asking import Reply, ask_of
from plainspoken.work.shift import robots_of
from plainspoken.world.event import Entry, MissionAccepted


def askable(entries: Sequence[Entry]) -> MissionAccepted:
    """How a mission began of which something can be asked.

    raises PlainspokenError: when it is over, or an action of another one
    """
    accepted = accepted_of(entries)
    if mission_from(entries).is_over:
        raise PlainspokenError(
            f"the mission {accepted.mission} is over", hint="`plainspoken ask` tells of it"
        )
    whole = accepted.robot.get("part_of")
    if whole is not None:
        raise PlainspokenError(
            f"the mission {accepted.mission} is an action of another one",
            hint=f"plainspoken missions {click.get_current_context().info_name} {whole}",
        )
    return accepted


def mission_in(kept: Store, mission: str | None) -> Sequence[Entry]:
    """The log of a mission that goes on: of the last one where none is named.

    raises PlainspokenError: when there is none
    """
    entries: Sequence[Entry]
    if mission is None:
        for id in reversed(kept.missions()):
            entries = kept.entries(id)
            if not (mission_from(entries).is_over or accepted_of(entries).robot.get("part_of")):
                return entries
        raise PlainspokenError(
            "no mission goes on",
            where=kept.database.place,
            hint="`plainspoken missions` lists those that are over",
        )
    entries = entries_in(kept, mission)
    askable(entries)
    return entries


def put(kept: Store, id: str, asked: Asked) -> Reply:
    """Ask something of a mission, whoever carries it out."""
    entries = entries_in(kept, id)
    return ask_of(kept, id, asked, robots_of(askable(entries)))


def tell(reply: Reply, done: str) -> None:
    """Say what became of a request; exit with 3 where nobody has heard it yet."""
    goal = reply.mission.in_flight
    if not reply.heard:
        click.echo(f"asked; {reply.worker or 'whoever takes it up'} has not answered yet", err=True)
        sys.exit(NO)
    text = done if goal is None else f"{done}; {goal.action} is under way"
    waits = not (reply.mission.is_over or reply.mission.is_at_rest)
    if waits and reply.worker is None and not reply.others:
        text += ", and nobody carries the mission out: start a worker with `plainspoken work`"
    click.echo(text)


def refused(
    document: Mapping[str, Any], reason: str | None, nothing: str, *, as_json: bool
) -> NoReturn:
    """Say why nothing is asked of a mission, and exit; JSON without --yes shows what would be.

    nothing: what does not happen
    """
    if as_json:
        click.echo(json.dumps(document, indent=2, ensure_ascii=False))
        sys.exit(0 if document["status"] == Status.OK else NO)
    if reason:
        click.echo(f"plainspoken: {reason}", err=True)
    click.echo(nothing, err=True)
    sys.exit(NO)


def confirmed(text: str, *, yes: bool) -> bool:
    """Say back what was understood, and hear whether it is right; yes: it is, nobody is asked.

    Where nobody is there to say so, it is not.
    """
    if yes:
        return True
    if not sys.stdin.isatty():
        click.echo(f"{text}\nplainspoken: nobody is there to confirm it; give --yes", err=True)
        return False
    return click.confirm(f"{text} Is that right?", default=None, err=True)


def picked(question: str, answers: Sequence[str], *, yes: bool) -> int | None:
    """Ask which of several is meant; None where nobody answers, or it is none of them."""
    click.echo(question, err=True)
    for number, answer in enumerate(answers, start=1):
        click.echo(f"  {number}. {answer}", err=True)
    if yes or not answers or not sys.stdin.isatty():
        return None
    number = click.prompt(
        "Which (0 for none)", type=click.IntRange(0, len(answers)), default=0, err=True
    )
    return number - 1 if number else None
