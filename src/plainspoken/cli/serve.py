"""`plainspoken serve`: the page, for people."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

from plainspoken.cli.guard import guard_options, guarding
from plainspoken.cli.site import FILE, chosen_site, site_options
from plainspoken.cli.store import open_store, store_option
from plainspoken.errors import PlainspokenError

if TYPE_CHECKING:
    from plainspoken.pipeline import Site
    from plainspoken.web.desk import Desk

GET_IT = "pip install 'plainspoken[web]'"
EXAMPLES = ("vineyard", "kitchen", "warehouse")
PACE = 0.6
"""Real seconds for each second of a simulated robot: an action takes about two, to be watched."""


@click.command()
@site_options
@store_option
@click.option("--host", default="127.0.0.1", show_default=True, help="The address to listen on.")
@click.option("--port", default=8765, show_default=True, type=click.IntRange(0, 65535))
@guard_options
@click.option("--layout", type=FILE, metavar="FILE", help="Where places lie on the map (JSON).")
@click.option("--robots", type=FILE, metavar="FILE", help="Robots that are not simulated (YAML).")
@click.option(
    "--whisper",
    type=FILE,
    metavar="FOLDER",
    envvar="PLAINSPOKEN_WHISPER",
    show_envvar=True,
    help="Weights of Whisper for CTranslate2 (default: those that a package holds).",
)
@click.option("--seed", default=0, show_default=True, help="Chances of the simulated robot.")
@click.option("--steer", multiple=True, metavar="FACT", help="What its chances should bring about.")
@click.option(
    "--pace",
    type=click.FloatRange(min=0),
    default=PACE,
    show_default=True,
    help="Real seconds for each simulated one.",
)
@click.option(
    "--side-by-side",
    is_flag=True,
    help="Let different robots be at work at once, where that makes no difference but to the time.",
)
@click.option("--demo", is_flag=True, help="Have a mission under way in the vineyard.")
def serve(
    *,
    domain: Path | None,
    problem: Path | None,
    landmarks: Path | None,
    store: str | None,
    host: str,
    port: int,
    tokens: Path | None,
    names: tuple[str, ...],
    tls_cert: Path | None,
    tls_key: Path | None,
    layout: Path | None,
    robots: Path | None,
    whisper: Path | None,
    seed: int,
    steer: tuple[str, ...],
    pace: float,
    side_by_side: bool,
    demo: bool,
) -> None:
    """Open the page: say what should be done, confirm it, watch it, ask about it.

    Without --domain and --problem, it knows the bundled vineyard, kitchen and warehouse. Programs
    find the same at /api/v1, described by /api/v1/openapi.json.

    \b
    plainspoken serve --demo
    plainspoken serve -d domain.pddl -p problem.pddl -l landmarks.json --robots robots.yaml
    plainspoken serve --host 0.0.0.0 --tokens tokens.txt
    """
    try:
        from plainspoken.web.front import behind_gate, caller_of
        from plainspoken.web.server import create_app, run
    except ImportError as error:
        raise PlainspokenError(f"the page cannot be opened: {error}", hint=GET_IT) from error
    from plainspoken.cli.robots import chosen_robot, robot_for
    from plainspoken.cli.simulated import Settings
    from plainspoken.pipeline import bundled
    from plainspoken.web.address import Names, at
    from plainspoken.web.desk import Desk
    from plainspoken.web.hearing import whisper_hearing
    from plainspoken.web.page.layout import read_layout

    access = guarding(host, names, tokens)
    if (tls_cert is None) != (tls_key is None):
        raise click.UsageError("https needs both --tls-cert and --tls-key")
    examples = EXAMPLES if domain is None and problem is None and landmarks is None else ()
    sites = {name: _bundled(name) for name in examples} or {
        each.problem.name: each for each in [chosen_site(domain, problem, landmarks)]
    }
    first = next(iter(sites.values()))
    layouts = {sites[n].problem.name: read_layout(f) for n in examples
               if (f := bundled(n) / "layout.json").exists()}  # fmt: skip
    if layout is not None:
        layouts[first.problem.name] = read_layout(layout)
    chosen = chosen_robot(None, robots, Settings(seed, steer, pace=0.0 if robots else pace))
    hearing = whisper_hearing(whisper)
    with open_store(store) as kept:
        desk = Desk(sites, kept, partial(robot_for, kept))
        try:
            robot = chosen.to_json() | ({"side_by_side": True} if side_by_side else {})
            page = create_app(
                desk, robot=robot, layouts=layouts, visitor_of=caller_of, missing=hearing.missing
            )
            app = behind_gate(
                page, desk, access, Names.of(host, names), robot=robot, hearing=hearing
            )
            if demo:
                start_demo(desk, pace)
            address = f"{'http' if tls_cert is None else 'https'}://{at(host)}:{port}"
            click.echo(f"plainspoken: open {address} in a browser", err=True)
            run(app, host=host, port=port, tls=(tls_cert, tls_key))
        finally:
            desk.close()


def _bundled(name: str) -> Site:
    from plainspoken.pipeline import bundled, open_site

    folder = bundled(name)
    return open_site(folder / "domain.pddl", folder / "problem.pddl", folder / "landmarks.json")


def start_demo(desk: Desk, pace: float) -> None:
    """Have the demo's mission begin, paused, so that whoever opens the page sees all of it."""
    from plainspoken.cli.demo import SENTENCE, STEERING
    from plainspoken.cli.record import utc_now
    from plainspoken.cli.simulated import Settings
    from plainspoken.mission.mission import new_mission_id
    from plainspoken.pipeline import Request
    from plainspoken.planning.solver import Solved

    extraction = desk.understand("vineyard", SENTENCE)
    if extraction.formula is None:
        raise PlainspokenError("the demo's own sentence was not understood")
    ending = desk.plan("vineyard", extraction.formula)
    if not isinstance(ending, Solved):
        raise PlainspokenError("the demo's own mission has no policy")
    robot = Settings(steering=STEERING, pace=pace).to_json()
    request = Request(new_mission_id(utc_now), extraction.formula, SENTENCE, robot)
    desk.start("vineyard", request, ending.policy)
    desk.pause(request.mission, "the demo")
