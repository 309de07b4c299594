"""`plainspoken missions`: what is in a store, going on with it, and its log."""

from __future__ import annotations

import json
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import click
from rich.console import Console
from rich.table import Table

from plainspoken.cli.exit import NO
from plainspoken.cli.record import entries_of, fresh_file, recorder, utc_now
from plainspoken.cli.robots import asking_here, heeding, opened, robot_in
from plainspoken.cli.run import ended, shown
from plainspoken.cli.site import FILE
from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.jsonl import write_jsonl
from plainspoken.knowledge.log import SqliteLog, store_path
from plainspoken.mission.mission import mission_from
from plainspoken.pipeline import accepted_of, go_on, site_of
from plainspoken.world.event import Entry

_store = click.option(
    "--store", metavar="URL", help="Where missions are kept: sqlite:///PATH or PATH."
)


@click.group(invoke_without_command=True)
@_store
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
@click.pass_context
def missions(context: click.Context, store: str | None, *, as_json: bool) -> None:
    """List the missions in a store, go on with one, or write its log to a file."""
    if context.invoked_subcommand is not None:
        return
    with SqliteLog(store_path(store)) as kept:
        found = [_summary(kept.entries(id)) for id in kept.missions()]
    if as_json:
        click.echo(json.dumps(found, indent=2, ensure_ascii=False))
    elif not found:
        click.echo("no missions yet; try: plainspoken run --say 'Clear line 2'")
    else:
        table = Table("mission", "status", "instants", "asked for", title=str(store_path(store)))
        for one in found:
            table.add_row(one["mission"], one["status"], str(one["instant"]), one["request"])
        Console().print(table)


def _summary(entries: Sequence[Entry]) -> dict[str, Any]:
    mission, accepted = mission_from(entries), accepted_of(entries)
    return {
        "mission": mission.id,
        "status": str(mission.status),
        "instant": mission.instant,
        "satisfied": mission.satisfied,
        "request": accepted.sentence or accepted.goal,
    }


@missions.command()
@click.argument("id")
@_store
@click.option("--json", "as_json", is_flag=True, help="Print the events, one JSON object a line.")
@click.option("--pace", type=click.FloatRange(min=0), default=0.0, metavar="X", help="As in run.")
def resume(id: str, store: str | None, pace: float, *, as_json: bool) -> None:
    """Go on with the mission ID, which was paused or killed."""
    entries = entries_of(id, store)
    accepted = accepted_of(entries)
    if mission_from(entries).is_over:
        raise PlainspokenError(f"the mission {id} is over", hint="`plainspoken ask` tells of it")
    if "part_of" in accepted.robot:
        raise PlainspokenError(
            f"the mission {id} is an action of another one",
            hint=f"plainspoken missions resume {accepted.robot['part_of']}",
        )
    site = site_of(accepted)
    path, chosen = store_path(store), robot_in(accepted.robot)
    with ExitStack() as stack:
        robot, patience = stack.enter_context(
            opened(site, chosen, store=path, pace=pace, entries=entries)
        )
        kept = stack.enter_context(SqliteLog(path))
        record = heeding(robot, recorder(kept, id, None, utc_now))
        events = go_on(site, entries, robot, record, by="command line", patience=patience)
        with asking_here(path, id):
            mission = shown(events, site, as_json=as_json)
    ended(mission)


@missions.command()
@click.argument("id")
@_store
@click.option("--out", type=FILE, required=True, metavar="FILE", help="Where to.")
@click.option("--overwrite", is_flag=True, help="Replace the file.")
def log(id: str, store: str | None, out: Path, *, overwrite: bool) -> None:
    """Write the log of the mission ID as JSON lines, after checking that nobody changed it."""
    entries_of(id, store)
    fresh_file(out, overwrite=overwrite)
    with ExitStack() as stack:
        kept = stack.enter_context(SqliteLog(store_path(store)))
        broken = kept.verify(id)
        if broken is not None:
            click.echo(f"plainspoken: step {broken.step}: {broken.what}", err=True)
            raise SystemExit(NO)
        write_jsonl(kept.links(id), out)
