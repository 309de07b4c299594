"""Carrying out a mission that has a place in the store, in this process, while somebody watches."""

from __future__ import annotations

import time
from collections.abc import Generator, Sequence

import click

from plainspoken.cli.record import written_too
from plainspoken.cli.simulated import robot_for
from plainspoken.knowledge.jsonl import JsonlWriter
from plainspoken.mission.mailbox import to_message
from plainspoken.mission.mission import Mission
from plainspoken.mission.observation import CancelAsked
from plainspoken.pipeline import Site, accepted_of, take_up
from plainspoken.work.shift import TICK, Held, Shift
from plainspoken.world.event import Entry


def going_on(
    shift: Shift,
    held: Held,
    site: Site,
    *,
    first: Sequence[Entry] = (),
    pace: float | None = None,
    file: JsonlWriter | None = None,
) -> Generator[Entry, None, Mission]:
    """Wait for the mission's turn, then go on with it; first: entries to show before.

    Ctrl-C while it waits cancels it.
    """
    yield from first
    try:
        _await_turn(shift, held)
    except KeyboardInterrupt:
        shift.store.post(held.mission, to_message(CancelAsked("keyboard")))
    shift.tick()
    entries = held.entries()
    with robot_for(site, accepted_of(entries).robot, entries, pace=pace) as (robot, patience):
        return (
            yield from take_up(
                site,
                entries,
                robot,
                written_too(held.record, file),
                by=held.worker,
                requests=held.requests,
                patience=patience,
            )
        )


def _await_turn(shift: Shift, held: Held) -> None:
    told: tuple[str, ...] = ()
    while ahead := shift.store.ahead_of(held.mission):
        if ahead != told:
            told = ahead
            click.echo(f"waiting for the robot; before it: {', '.join(ahead)}", err=True)
        time.sleep(TICK)
