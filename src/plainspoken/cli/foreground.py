"""Carrying out a mission that has a place in the store, in this process, while somebody watches."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Generator, Sequence
from contextlib import ExitStack

import click
from rich.console import Console

from plainspoken.cli.exit import NO
from plainspoken.cli.record import written_too
from plainspoken.cli.robots import asking_here, robot_for
from plainspoken.cli.watch import Scoreboard, watch
from plainspoken.knowledge.jsonl import JsonlWriter
from plainspoken.mission.mailbox import to_message
from plainspoken.mission.mission import Mission, Status, mission_from
from plainspoken.mission.observation import CancelAsked
from plainspoken.mission.run import heeding
from plainspoken.pipeline import Site, accepted_of, take_up
from plainspoken.questions.lexicon import Lexicon
from plainspoken.work.fenced import FencedRobot
from plainspoken.work.shift import TICK, Held, Shift, standing_of
from plainspoken.world.event import Entry, MissionEnded

Run = Generator[Entry, None, Mission]


def going_on(
    shift: Shift,
    held: Held,
    site: Site,
    *,
    first: Sequence[Entry] = (),
    pace: float | None = None,
    file: JsonlWriter | None = None,
) -> Run:
    """Wait for the mission's turn, then go on with it; first: entries to show before.

    Ctrl-C while it waits cancels it.
    """
    yield from first
    over = bool(first) and isinstance(first[-1].event, MissionEnded)
    try:
        if not over:
            _await_turn(shift, held)
    except KeyboardInterrupt:
        shift.store.post(held.mission, to_message(CancelAsked("keyboard")))
    shift.tick()
    entries = held.entries()
    set_up, store = accepted_of(entries).robot, shift.store
    with ExitStack() as stack:
        robot, patience = stack.enter_context(robot_for(store, site, set_up, entries, pace=pace))
        if "robots" in set_up:
            stack.enter_context(asking_here(store, held.mission))
        return (
            yield from take_up(
                site,
                entries,
                FencedRobot(robot, held),
                written_too(heeding(robot, held.record), file),
                by=held.worker,
                requests=held.requests,
                patience=patience,
            )
        )


def watched(shift: Shift, held: Held, events: Run, site: Site, *, as_json: bool) -> Mission:
    """Show a run to its end, and hand the mission back as it stands then.

    Ctrl-C where the mission itself does not hear it pauses it, too, and so does a closed pipe.
    """
    try:
        mission = _shown(events, site, as_json=as_json)
    except KeyboardInterrupt:
        events.close()
        mission = mission_from(held.entries())
    except (OSError, SystemExit):  # nobody reads what is printed any more: it is paused
        events.close()
        shift.hand_back(held, standing_of(mission_from(held.entries())))
        raise
    shift.hand_back(held, standing_of(mission))
    return mission


def _shown(events: Run, site: Site, *, as_json: bool) -> Mission:
    """Show a run while it goes on: its events as JSON, or what the robot does in words."""
    if as_json:
        while True:
            try:
                click.echo(json.dumps(next(events).to_json(), ensure_ascii=False))
            except StopIteration as end:
                mission: Mission = end.value
                return mission
    watched = watch(events, Scoreboard(Lexicon(site.problem, site.landmarks)), Console())
    assert watched is not None  # noqa: S101 - it was watched to the end
    return watched


def ended(mission: Mission) -> None:
    """Say what comes next, and exit with 3 where the mission did not do what was asked."""
    if mission.status is Status.PAUSED:
        click.echo(f"paused; go on with: plainspoken missions resume {mission.id}", err=True)
    elif mission.ended is not None and mission.ended.reason:
        click.echo(mission.ended.reason, err=True)
    if mission.is_over and not (mission.ended and mission.ended.satisfied):
        sys.exit(NO)


def _await_turn(shift: Shift, held: Held) -> None:
    told: tuple[str, ...] = ()
    while ahead := shift.store.ahead_of(held.mission):
        if ahead != told:
            told = ahead
            click.echo(f"waiting for the robot; before it: {', '.join(ahead)}", err=True)
        time.sleep(TICK)
