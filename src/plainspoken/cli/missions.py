"""`plainspoken missions`: what is in a store, what is asked of a mission, its log and facts."""

from __future__ import annotations

import json
from collections.abc import Sequence
from contextlib import ExitStack
from datetime import datetime
from pathlib import Path
from typing import Any

import click
from rich.console import Console
from rich.table import Table

from plainspoken.cli.asked import askable, put, tell
from plainspoken.cli.exit import NO
from plainspoken.cli.foreground import ended, going_on, watched
from plainspoken.cli.record import fresh_file, utc_now
from plainspoken.cli.site import FILE
from plainspoken.cli.store import entries_in, open_store, store_option
from plainspoken.cli.verdicts import verdicts
from plainspoken.knowledge.facts import facts_after
from plainspoken.knowledge.jsonl import write_jsonl
from plainspoken.knowledge.queue import Place
from plainspoken.mission.mailbox import to_message
from plainspoken.mission.mission import mission_from
from plainspoken.mission.observation import CancelAsked, PauseAsked, ResumeAsked
from plainspoken.pipeline import accepted_of, site_of
from plainspoken.work.shift import Shift, robots_of
from plainspoken.world.event import Entry, RequestChanged

BY = "command line"

_json = click.option("--json", "as_json", is_flag=True, help="Print JSON.")


@click.group(invoke_without_command=True)
@store_option
@_json
@click.pass_context
def missions(context: click.Context, store: str | None, *, as_json: bool) -> None:
    """List the missions in a store; pause, resume, cancel or change one; write its log to a file.

    What is asked of a mission reaches it wherever it is carried out.
    """
    if context.invoked_subcommand is not None:
        return
    with open_store(store) as kept:
        places = {place.mission: place for place in kept.places()}
        found = [_summary(kept.entries(id), places.get(id)) for id in kept.missions()]
        title = kept.database.place
    if as_json:
        click.echo(json.dumps(found, indent=2, ensure_ascii=False))
    elif not found:
        click.echo("no missions yet; try: plainspoken run --say 'Clear line 2'")
    else:
        table = Table("mission", "status", "instants", "carried out by", "asked for", title=title)
        for one in found:
            by = one["worker"] or ("" if one["over"] else one["trouble"] or "nobody")
            if one["part_of"]:
                by = f"an action of {one['part_of']}"
            table.add_row(one["mission"], one["status"], str(one["instant"]), by, one["request"])
        Console().print(table)


def _summary(entries: Sequence[Entry], place: Place | None) -> dict[str, Any]:
    mission, accepted = mission_from(entries), accepted_of(entries)
    return {
        "mission": mission.id,
        "status": str(mission.status),
        "over": mission.is_over,
        "instant": mission.instant,
        "satisfied": mission.satisfied,
        "request": _request(entries),
        "robots": list(robots_of(accepted)),
        "part_of": accepted.robot.get("part_of"),
        "worker": place.worker if place else None,
        "trouble": place.trouble if place else None,
    }


def _request(entries: Sequence[Entry]) -> str:
    """What the mission is about by now, as it was said or, after a change of mind, said back."""
    for entry in reversed(entries):
        if isinstance(entry.event, RequestChanged) and entry.event.english:
            return entry.event.english
    accepted = accepted_of(entries)
    return accepted.sentence or accepted.goal


@missions.command()
@click.argument("id")
@store_option
@click.option("--json", "as_json", is_flag=True, help="Print the events, one JSON object a line.")
@click.option("--pace", type=click.FloatRange(min=0), metavar="X", help="As in run.")
@click.option("--detach", is_flag=True, help="Leave it to `plainspoken work`.")
def resume(id: str, store: str | None, pace: float | None, *, as_json: bool, detach: bool) -> None:
    """Go on with the mission ID, which was paused or killed.

    Here, where you see it, unless a worker carries it out.
    """
    with ExitStack() as stack:
        kept = stack.enter_context(open_store(store))
        entries = entries_in(kept, id)
        accepted = askable(entries)
        asked = ResumeAsked(BY)
        if kept.place(id) is None:
            kept.enlist(id, robots_of(accepted))
        if detach:
            tell(put(kept, id, asked), "resumed")
            return
        shift = stack.enter_context(Shift(kept))
        held = shift.take(id)
        if held is None:
            tell(put(kept, id, asked), "resumed")
            return
        kept.post(id, to_message(asked))
        site = site_of(accepted)
        events = going_on(shift, held, site, pace=pace)
        mission = watched(shift, held, events, site, as_json=as_json)
    ended(mission)


@missions.command()
@click.argument("id")
@store_option
def pause(id: str, store: str | None) -> None:
    """Have the mission ID start no further action; one under way comes to its end."""
    with open_store(store) as kept:
        tell(put(kept, id, PauseAsked(BY)), "paused")


@missions.command()
@click.argument("id")
@store_option
def cancel(id: str, store: str | None) -> None:
    """Give the mission ID up; an action under way is cancelled if the robot can."""
    with open_store(store) as kept:
        tell(put(kept, id, CancelAsked(BY)), "cancelled")


@missions.command()
@click.argument("id")
@click.argument("text")
@store_option
@click.option("--by", metavar="NAME", help="Who wants it (default: you).")
@click.option("--yes", is_flag=True, help="Take what is understood for right, and ask nothing.")
@click.option(
    "--instead/--besides",
    default=None,
    help="Whether a whole new request takes the place of the old one, or comes beside it.",
)
@click.option(
    "--otherwise",
    type=click.Choice(("go-on", "pause", "cancel")),
    default="go-on",
    show_default=True,
    help="What to do where there is no plan for it.",
)
@click.option("--json", "as_json", is_flag=True, help="Print what was understood as JSON.")
def change(
    id: str,
    text: str,
    store: str | None,
    by: str | None,
    *,
    yes: bool,
    instead: bool | None,
    otherwise: str,
    as_json: bool,
) -> None:
    """Change your mind about the mission ID: TEXT, in plain words.

    What it comes to, with what is left of the mission, is said back, and planned once you agree.
    The mission goes over to it where nothing is under way. Where there is no plan for it, it goes
    on as before, unless --otherwise says something else. Exit status 3 where nothing is changed.

    \b
    plainspoken missions change ID "skip line 3"
    plainspoken missions change ID "first go to the warehouse"
    plainspoken missions change ID "stop after this grape" --yes
    plainspoken missions change ID "Call the support robot" --besides
    """
    from plainspoken.cli.change import changed

    with open_store(store) as kept:
        changed(
            kept,
            id,
            text,
            by,
            yes=yes,
            instead=instead,
            otherwise=otherwise,
            as_json=as_json,
        )


@missions.command()
@click.argument("id")
@store_option
@click.option("--at", type=click.IntRange(min=0), metavar="STEP", help="What was known then.")
@_json
def facts(id: str, store: str | None, at: int | None, *, as_json: bool) -> None:
    """List what is known in the mission ID: true, false or unknown, since when, and from whom."""
    with open_store(store) as kept:
        entries = [entry for entry in entries_in(kept, id) if at is None or entry.step <= at]
    now = utc_now() if at is None else datetime.fromisoformat(entries[-1].time)
    found = [each.to_json() for each in facts_after(entries).all_known(now)]
    if as_json:
        click.echo(json.dumps(found, indent=2, ensure_ascii=False))
        return
    said = {True: "true", False: "false", None: "unknown"}
    table = Table("fact", "is", "source", "by", "since", "last seen", "step")
    for one in found:
        stale = f" (was {said[one['last']]})" if one["holds"] is not one["last"] else ""
        table.add_row(
            one["atom"],
            said[one["holds"]] + stale,
            one["source"],
            one["by"] or "",
            one["since"],
            one["seen"] or "never",
            str(one["seen_step"]),
        )
    Console().print(table)


@missions.command()
@click.argument("id")
@store_option
@click.option("--out", type=FILE, required=True, metavar="FILE", help="Where to.")
@click.option("--overwrite", is_flag=True, help="Replace the file.")
def log(id: str, store: str | None, out: Path, *, overwrite: bool) -> None:
    """Write the log of the mission ID as JSON lines, after checking that nobody changed it."""
    with open_store(store) as kept:
        entries_in(kept, id)
        fresh_file(out, overwrite=overwrite)
        broken = kept.verify(id)
        if broken is not None:
            click.echo(f"plainspoken: step {broken.step}: {broken.what}", err=True)
            raise SystemExit(NO)
        write_jsonl(kept.links(id), out)


missions.add_command(verdicts)
