"""The options that say where: domain, problem and landmarks, the bundled vineyard by default."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import click

F = TypeVar("F", bound=Callable[..., Any])

FILE = click.Path(path_type=Path)


def site_options(command: F) -> F:
    """Add --domain, --problem and --landmarks to a command."""
    for option in reversed(
        [
            click.option(
                "--domain",
                "-d",
                type=FILE,
                metavar="D",
                help="PDDL domain (default: the vineyard).",
            ),
            click.option("--problem", "-p", type=FILE, metavar="P", help="PDDL problem of it."),
            click.option(
                "--landmarks",
                "-l",
                type=FILE,
                metavar="L",
                help="Landmarks, the words for its symbols (default: derived from the PDDL names).",
            ),
        ]
    ):
        command = option(command)
    return command


def chosen_site(domain: Path | None, problem: Path | None, landmarks: Path | None) -> Any:
    """The site that the options name.

    raises UsageError: when only one of domain and problem is given
    """
    from plainspoken.pipeline import bundled, open_site

    if domain is None and problem is None:
        folder = bundled("vineyard")
        return open_site(
            folder / "domain.pddl",
            folder / "problem.pddl",
            landmarks or folder / "landmarks.json",
        )
    if domain is None or problem is None:
        missing = "--domain" if domain is None else "--problem"
        raise click.UsageError(f"a planning problem is two files: {missing} is missing")
    return open_site(domain, problem, landmarks)
