"""`plainspoken run`: carry a mission out, and record it."""

from __future__ import annotations

import sys
from contextlib import ExitStack
from pathlib import Path

import click

from plainspoken.cli.exit import NO
from plainspoken.cli.foreground import ended, going_on, watched
from plainspoken.cli.goal import chosen_goal, goal_options
from plainspoken.cli.plan import progress_shown
from plainspoken.cli.record import fresh_file, utc_now, written_too
from plainspoken.cli.robots import KINDS, chosen_robot, opened, robot_in
from plainspoken.cli.simulated import Settings
from plainspoken.cli.site import FILE, chosen_site, site_options
from plainspoken.cli.store import open_store, store_option
from plainspoken.knowledge.jsonl import JsonlWriter
from plainspoken.knowledge.queue import Standing
from plainspoken.knowledge.store import Store
from plainspoken.mission.executive import queued
from plainspoken.mission.mission import Mission, new_mission_id
from plainspoken.mission.run import heeding
from plainspoken.pipeline import Request, Site, accepted_as, carry_out, find_policy, why_not
from plainspoken.planning.policy import Policy
from plainspoken.planning.solver import Solved
from plainspoken.work.fenced import FencedRobot
from plainspoken.work.shift import Shift, robots_of


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
    help="What goes wrong with the simulated robot: failing, hanging, lying, lost, person, "
    "drift, strange, unlucky. May be repeated.",
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
@click.option(
    "--robot-name",
    "names",
    multiple=True,
    metavar="NAME",
    help="Missions of one robot wait for each other. May be repeated, for a mission of several. "
    "Robots of a file have its name where they have no other.",
)
@click.option(
    "--world",
    type=FILE,
    metavar="FILE",
    help="Keep the simulated world there: like a real robot's, it goes on when this is killed.",
)
@click.option(
    "--side-by-side",
    is_flag=True,
    help="Let different robots be at work at once, where that makes no difference but to the time.",
)
@click.option(
    "--detach",
    is_flag=True,
    help="Leave the mission to `plainspoken work`: print its name, and return.",
)
@store_option
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
    names: tuple[str, ...],
    world: Path | None,
    side_by_side: bool,
    detach: bool,
    store: str | None,
    log: Path | None,
    timeout: float | None,
    overwrite: bool,
    as_json: bool,
) -> None:
    """Plan, validate, and carry a mission out, recording every event.

    Ctrl-C pauses before the next action, and `missions resume ID` goes on. With --detach a worker
    carries the mission out (`plainspoken work`), and goes on with it even after `kill -9`. Exit
    status 3 where there is no policy, or where the mission did not end satisfied.

    \b
    plainspoken run --say "Clear line 2" --steer "unripe g2" --log run.jsonl
    plainspoken run --say "Clear line 2" --fault hanging:0.2 --fault person:0.1
    plainspoken run --say "Clear line 2" --robot-name rob --detach && plainspoken work
    plainspoken run --say "Clear line 2" --robots examples/robots/http.yaml
    plainspoken ask "What did you do so far?" --log run.jsonl
    """
    site: Site = chosen_site(domain, problem, landmarks)
    formula, _ = chosen_goal(goal, say, site)
    kept_in = None if world is None else str(world.resolve())
    settings = Settings(seed, steer, faults, action_timeout, pace, names, kept_in)
    chosen = chosen_robot(robot, robots, settings)
    id = new_mission_id(utc_now)
    if detach and (log is not None or as_json):
        raise click.UsageError("with --detach nothing is watched: leave out --log and --json")
    if log is not None:
        fresh_file(log, overwrite=overwrite)
    robot_set = chosen.to_json() | ({"side_by_side": True} if side_by_side else {})
    with open_store(store) as kept, opened(site, chosen, mission=id, store=kept) as (found, _):
        # Before it is planned: what is wrong with a robots' file is known at once.
        request = Request(id, formula, say, robot_set).knowing(found)
    with progress_shown() as on_progress:
        ending = find_policy(site.problem, formula, timeout=timeout, on_progress=on_progress)
    if not isinstance(ending, Solved):
        click.echo(f"plainspoken: {why_not(ending, site)}", err=True)
        sys.exit(NO)
    with open_store(store) as kept:
        if detach:
            _left_to_workers(kept, site, request, ending.policy)
            return
        mission = _carried_out(kept, site, request, ending.policy, log=log, as_json=as_json)
    ended(mission)


def _left_to_workers(kept: Store, site: Site, request: Request, policy: Policy) -> None:
    accepted = accepted_as(site, request)
    time = utc_now().isoformat(timespec="milliseconds")
    kept.begin(request.mission, time, queued(accepted, policy), robots_of(accepted))
    click.echo(request.mission)
    place = kept.place(request.mission)
    if place is not None and place.standing is Standing.OVER:
        click.echo("nothing is to be done: what is asked for holds already", err=True)
    elif not kept.workers():
        click.echo("it waits for a worker; start one with: plainspoken work", err=True)


def _carried_out(
    kept: Store,
    site: Site,
    request: Request,
    policy: Policy,
    *,
    log: Path | None,
    as_json: bool,
) -> Mission:
    """Carry a mission out here; one whose robot has a name waits until it is its turn."""
    accepted = accepted_as(site, request)
    with ExitStack() as stack:
        file = stack.enter_context(JsonlWriter(log)) if log is not None else None
        shift = stack.enter_context(Shift(kept))
        held = shift.found(request.mission, robots_of(accepted))
        record = written_too(held.record, file)
        if accepted.robot.get("names"):
            begun = record(0, queued(accepted, policy))
            events = going_on(shift, held, site, first=begun, file=file)
        else:
            # Only a simulated robot has no name, and its mission waits for nobody.
            robot, patience = stack.enter_context(
                opened(site, robot_in(request.robot), mission=held.mission, store=None)
            )
            events = carry_out(
                site,
                request,
                policy,
                FencedRobot(robot, held),
                heeding(robot, record),
                requests=held.requests,
                patience=patience,
            )
        return watched(shift, held, events, site, as_json=as_json)
