"""`plainspoken work`: a worker, which carries out the missions of a store."""

from __future__ import annotations

import json
import logging
import signal
from functools import partial

import click

from plainspoken.cli.robots import robot_for
from plainspoken.cli.store import open_store, store_option
from plainspoken.work.worker import Worker
from plainspoken.world.event import ActionStarted, Entry, MissionEnded, TakenUp


@click.command()
@store_option
@click.option(
    "--missions",
    "most",
    type=click.IntRange(min=1),
    default=8,
    show_default=True,
    metavar="N",
    help="How many missions at once, at most.",
)
@click.option(
    "--until-done", is_flag=True, help="Return when no mission is left to carry out, or waiting."
)
@click.option("--json", "as_json", is_flag=True, help="Print every event, one JSON object a line.")
def work(store: str | None, most: int, *, until_done: bool, as_json: bool) -> None:
    """Carry out the missions that wait in a store, and those that a killed process left behind.

    Start as many workers as you like, on as many machines as reach the store (with PostgreSQL; a
    SQLite file serves one machine). Missions of one robot wait for each other. A worker that is
    killed, hangs, or is cut off is replaced by another within seconds; an action that was under
    way is asked about, not repeated. Ctrl-C hands everything back as it is.

    \b
    plainspoken run --say "Clear line 2" --robot-name rob --detach
    plainspoken work --until-done
    plainspoken work --store postgresql://farm@db.example/missions
    """
    logging.basicConfig(format="plainspoken: %(message)s", level=logging.WARNING)
    with open_store(store) as kept:
        heard = _as_json if as_json else _in_short
        worker = Worker(kept, partial(robot_for, kept), most=most, heard=heard)
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, lambda *_: worker.stop())
        click.echo(f"worker {worker.shift.worker} at {kept.database.place}", err=True)
        worker.run(until_done=until_done)


def _as_json(mission: str, entry: Entry) -> None:
    click.echo(json.dumps({"mission": mission, **entry.to_json()}, ensure_ascii=False))


def _in_short(mission: str, entry: Entry) -> None:
    match entry.event:
        case TakenUp():
            click.echo(f"{mission}  taken up")
        case ActionStarted(action):
            click.echo(f"{mission}  {action}")
        case MissionEnded(outcome, _, reason):
            click.echo(f"{mission}  {outcome}" + (f": {reason}" if reason else ""))
        case _:
            pass
