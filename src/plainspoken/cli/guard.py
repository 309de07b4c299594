"""The options that say who may come in where `serve` listens, and by which names it is called."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from plainspoken.cli.site import FILE

if TYPE_CHECKING:
    from plainspoken.web.access import Access

F = TypeVar("F", bound=Callable[..., Any])


def guard_options(command: F) -> F:
    """Add --tokens, --name, --tls-cert and --tls-key to a command."""
    for option in (
        click.option("--tls-key", type=FILE, metavar="FILE", help="The certificate's key."),
        click.option(
            "--tls-cert", type=FILE, metavar="FILE", help="Serve https with this certificate."
        ),
        click.option(
            "--name",
            "names",
            multiple=True,
            metavar="HOST",
            help="A name that browsers call this server by, through a proxy say. May be repeated.",
        ),
        click.option(
            "--tokens",
            type=FILE,
            metavar="FILE",
            help="Who may come in, as `plainspoken token` writes it (or PLAINSPOKEN_TOKENS). "
            "Needed to be reached from other computers.",
        ),
    ):
        command = option(command)
    return command


def guarding(host: str, names: Iterable[str], tokens: Path | None) -> Access:
    """Who may come in.

    raises PlainspokenError: where strangers could, or the tokens cannot be used
    """
    from plainspoken.cli.robots import person
    from plainspoken.web.access import TOKENS_VARIABLE, Access, chosen_grants
    from plainspoken.web.address import refuse_exposure

    grants = chosen_grants(tokens, os.environ.get(TOKENS_VARIABLE))
    refuse_exposure(host, names, guarded=grants is not None)
    return Access(grants, everyone=person())
