"""`plainspoken token`: who may come in where `serve` listens to more than this computer."""

from __future__ import annotations

from pathlib import Path

import click

from plainspoken.cli.site import FILE
from plainspoken.web.access import TOKENS_VARIABLE, Role, append_grant, new_grant


@click.command()
@click.argument("name")
@click.option(
    "--role",
    type=click.Choice([str(role) for role in Role]),
    default=str(Role.VIEWER),
    show_default=True,
    help="A viewer may look and ask, an operator may command.",
)
@click.option("--file", type=FILE, metavar="FILE", help="Add it to the file of serve --tokens.")
def token(name: str, role: str, file: Path | None) -> None:
    """Make a token for NAME, a person or a program, and print it: it is shown only now.

    Give it to them over a way that nobody else reads. The file holds no token, only what a token
    is recognised by; take a line out of it, and that token and its logins end at once.

    \b
    plainspoken token ada --role operator --file tokens.txt
    plainspoken serve --host 0.0.0.0 --tokens tokens.txt
    """
    drawn, grant = new_grant(Role(role), name)
    if file is not None:
        append_grant(file, grant)
        click.echo(f"plainspoken: {name} is {role} in {file}", err=True)
    else:
        click.echo(f"plainspoken: for {TOKENS_VARIABLE}, or a line of a file:\n{grant}", err=True)
    click.echo(drawn)
