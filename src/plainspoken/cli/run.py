"""`plainspoken run`: carry a mission out, and record it."""

from __future__ import annotations

import json
import sys
from collections.abc import Generator
from contextlib import ExitStack
from pathlib import Path

import click
from rich.console import Console

from plainspoken.cli.exit import NO
from plainspoken.cli.goal import chosen_goal, goal_options
from plainspoken.cli.plan import progress_shown
from plainspoken.cli.record import fresh_file, new_mission_id, recorder, utc_now
from plainspoken.cli.robots import KINDS, asking_here, chosen_robot, heeding, opened
from plainspoken.cli.simulated import Settings
from plainspoken.cli.site import FILE, chosen_site, site_options
from plainspoken.cli.watch import Scoreboard, watch
from plainspoken.knowledge.jsonl import JsonlWriter
from plainspoken.knowledge.log import SqliteLog, store_path
from plainspoken.mission.mission import Mission, Status
from plainspoken.pipeline import Request, Site, carry_out, find_policy, why_not
from plainspoken.planning.solver import Solved
from plainspoken.questions.lexicon import Lexicon
from plainspoken.world.event import Entry

Run = Generator[Entry, None, Mission]


@click.command()
@site_options
@goal_options
@click.option(
    "--robot",
    type=click.Choice(KINDS),
    help="Who carries it out: the simulator, or how the services of --robots are reached where "
    "the file does not say.",
)
@click.option(
    "--robots",
    type=FILE,
    metavar="FILE",
    help="Robots that a YAML file describes: services, and each action as an activity of them.",
)
@click.option("--seed", default=0, help="What chance draws in the simulator.", show_default=True)
@click.option(
    "--steer",
    multiple=True,
    metavar="FACT",
    help="How chance should fall: 'unripe g1', 'not full b'. May be repeated.",
)
@click.option(
    "--fault",
    "faults",
    multiple=True,
    metavar="KIND[:CHANCE]",
    help="What goes wrong with the simulated robot: failing, hanging, lying, lost, person. "
    "May be repeated.",
)
@click.option(
    "--action-timeout",
    type=click.FloatRange(min=0, min_open=True),
    metavar="S",
    help="Seconds that an action may take before it is given up (with --fault, simulated ones, "
    "and 60 where nobody says).",
)
@click.option(
    "--pace",
    type=click.FloatRange(min=0),
    default=0.0,
    metavar="X",
    help="Real seconds for each simulated second.",
    show_default=True,
)
@click.option("--store", metavar="URL", help="Where missions are kept: sqlite:///PATH or PATH.")
@click.option("--log", type=FILE, metavar="FILE", help="Write the events as JSON lines, too.")
@click.option("--overwrite", is_flag=True, help="Replace the file that --log names.")
@click.option("--timeout", type=click.FloatRange(min=0), metavar="S", help="Seconds to plan in.")
@click.option("--json", "as_json", is_flag=True, help="Print the events, one JSON object a line.")
def run(
    *,
    domain: Path | None,
    problem: Path | None,
    landmarks: Path | None,
    goal: str | None,
    say: str | None,
    robot: str | None,
    robots: Path | None,
    seed: int,
    steer: tuple[str, ...],
    faults: tuple[str, ...],
    action_timeout: float | None,
    pace: float,
    store: str | None,
    log: Path | None,
    timeout: float | None,
    overwrite: bool,
    as_json: bool,
) -> None:
    """Plan, validate, and carry a mission out, recording every event.

    Ctrl-C pauses before the next action, and `missions resume ID` goes on. Exit status 3 where
    there is no policy, or where the mission did not end satisfied.

    \b
    plainspoken run --say "Clear line 2" --steer "unripe g2" --log run.jsonl
    plainspoken run --say "Clear line 2" --fault hanging:0.2 --fault person:0.1
    plainspoken run --say "Clear line 2" --robots examples/robots/http.yaml
    plainspoken ask "What did you do so far?" --log run.jsonl
    """
    site: Site = chosen_site(domain, problem, landmarks)
    formula, _ = chosen_goal(goal, say, site)
    settings = Settings(seed, steer, faults, action_timeout)
    chosen = chosen_robot(robot, robots, settings, pace)
    if log is not None:
        fresh_file(log, overwrite=overwrite)
    path = store_path(store)
    with ExitStack() as stack:
        # Before it is planned: what is wrong with a robots' file is known at once.
        device, patience = stack.enter_context(opened(site, chosen, store=path, pace=pace))
        with progress_shown() as on_progress:
            ending = find_policy(site.problem, formula, timeout=timeout, on_progress=on_progress)
        if not isinstance(ending, Solved):
            click.echo(f"plainspoken: {why_not(ending, site)}", err=True)
            sys.exit(NO)
        request = Request(new_mission_id(utc_now), formula, say, chosen.to_json())
        kept = stack.enter_context(SqliteLog(path))
        file = stack.enter_context(JsonlWriter(log)) if log is not None else None
        record = heeding(device, recorder(kept, request.mission, file, utc_now))
        events = carry_out(site, request, ending.policy, device, record, patience=patience)
        with asking_here(path, request.mission):
            mission = shown(events, site, as_json=as_json)
    ended(mission)


def shown(events: Run, site: Site, *, as_json: bool) -> Mission:
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
