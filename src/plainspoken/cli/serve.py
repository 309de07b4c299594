"""`plainspoken serve`: the page, for people."""

from __future__ import annotations

from pathlib import Path

import click

from plainspoken.cli.site import chosen_site, site_options
from plainspoken.cli.store import open_store, store_option
from plainspoken.errors import PlainspokenError

GET_IT = "pip install 'plainspoken[web]'"


@click.command()
@site_options
@store_option
@click.option("--host", default="127.0.0.1", show_default=True, help="The address to listen on.")
@click.option("--port", default=8765, show_default=True, type=click.IntRange(0, 65535))
def serve(
    domain: Path | None,
    problem: Path | None,
    landmarks: Path | None,
    store: str | None,
    host: str,
    port: int,
) -> None:
    """Open the page: say what should be done, watch it, ask about it."""
    from functools import partial

    from plainspoken.cli.robots import person, robot_for
    from plainspoken.web.desk import Desk

    try:
        from plainspoken.web.server import Visitor, create_app, run
    except ImportError as error:
        raise PlainspokenError(f"the page cannot be opened: {error}", hint=GET_IT) from error
    site = chosen_site(domain, problem, landmarks)
    with open_store(store) as kept:
        desk = Desk({site.problem.name: site}, kept, partial(robot_for, kept.database.place))
        try:
            app = create_app(desk, lambda _: Visitor(person()))
            click.echo(f"plainspoken: http://{host}:{port}", err=True)
            run(app, host=host, port=port)
        finally:
            desk.close()
