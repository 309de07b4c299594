"""`plainspoken report`: tell a mission what you did or saw."""

from __future__ import annotations

import json
import sys
from typing import Any

import click

from plainspoken.cli.asked import confirmed, mission_in, picked, put, refused, tell
from plainspoken.cli.exit import NO
from plainspoken.cli.robots import person
from plainspoken.cli.store import open_store, store_option
from plainspoken.language.extracted import Status
from plainspoken.mission.mission import mission_from
from plainspoken.pipeline import accepted_of
from plainspoken.questions.conversation import message_of
from plainspoken.questions.moment import lexicon_of
from plainspoken.questions.report import Report, settled_on, understood


@click.command()
@click.argument("text")
@click.option("--mission", metavar="ID", help="Which mission (default: the last that goes on).")
@store_option
@click.option("--by", metavar="NAME", help="Who reports (default: you).")
@click.option("--yes", is_flag=True, help="Take what is understood for right, and ask nothing.")
@click.option("--json", "as_json", is_flag=True, help="Print what was understood as JSON.")
def report(
    text: str,
    mission: str | None,
    store: str | None,
    by: str | None,
    *,
    yes: bool,
    as_json: bool,
) -> None:
    """Tell a mission what you did or saw: TEXT, in plain words.

    What is understood is said back, and recorded once you agree, with your name and the time. The
    mission acts on it, wherever it is carried out: it goes on where its policy knows the new
    state, and plans again where it does not. Exit status 3 where the text is no report, is not
    clear, or cannot be so.

    \b
    plainspoken report "I cleared line 2 myself"
    plainspoken report "the box is not full after all" --by Anna --yes
    plainspoken ask "How do you know that line 2 is cleared?"
    """
    with open_store(store) as kept:
        entries = mission_in(kept, mission)
        accepted, now = accepted_of(entries), mission_from(entries)
        lexicon = lexicon_of(accepted)
        found = understood(text, lexicon, now.world, accepted.unknown)
        document: dict[str, Any] = {"mission": now.id, "heard": False, **found.to_json()}
        if found.status is Status.CLARIFY and not as_json:
            answers = [choice.answer for choice in found.choices]
            number = picked(found.question or "", answers, yes=yes)
            if number is not None:
                found = settled_on(found, found.choices[number], lexicon)
        elif found.status is Status.OK and not as_json and not confirmed(_said(found), yes=yes):
            sys.exit(NO)
        if found.status is not Status.OK or (as_json and not yes):
            refused(document, found.reason, "nothing is recorded", as_json=as_json)
        name = by or person()
        reply = put(kept, now.id, message_of(found, name))
    if as_json:
        document |= {"heard": reply.heard, "by": name, "worker": reply.worker}
        click.echo(json.dumps(document, indent=2, ensure_ascii=False))
        sys.exit(0 if reply.heard else NO)
    tell(reply, f"noted: {found.english}")


def _said(found: Report) -> str:
    return f"I understand: {found.english}."
