"""Batches: a JSON object a line in, one a line out, in the same order."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, TypeVar

import click
from rich.console import Console
from rich.progress import track

from plainspoken.cli.exit import write_whole
from plainspoken.cli.site import FILE
from plainspoken.errors import InputFileError
from plainspoken.world.document import read_text

F = TypeVar("F", bound=Callable[..., Any])


def batch_options(field: str) -> Callable[[F], F]:
    """Add --batch and --out to a command."""

    def add(command: F) -> F:
        command = click.option(
            "--out", type=FILE, metavar="OUT", help="Where to write them (default: the terminal)."
        )(command)
        return click.option(
            "--batch",
            type=FILE,
            metavar="IN",
            help=f'A file of {{"id", "{field}"}}, one JSON object a line.',
        )(command)

    return add


def run_batch(
    source: Path, out: Path | None, field: str, answer: Callable[[str, Any], dict[str, Any]]
) -> None:
    """Answer every row, given its text and id; the answers are written when all are there.

    raises InputFileError: naming the line of a row that cannot be used
    """
    rows = list(_rows(source, field))
    answers = [
        json.dumps({"id": row["id"], **answer(row[field], row["id"])}, ensure_ascii=False)
        for row in track(
            rows,
            description=f"{len(rows)} rows",
            console=Console(stderr=True),
            disable=not sys.stderr.isatty(),
        )
    ]
    text = "".join(f"{line}\n" for line in answers)
    if out is None:
        click.echo(text, nl=False)
    else:
        write_whole(out, text)


def _rows(source: Path, field: str) -> Iterator[dict[str, Any]]:
    for number, line in enumerate(read_text(source).split("\n"), start=1):
        if not line.strip():
            continue
        try:
            row = json.loads(line)
        except (json.JSONDecodeError, RecursionError) as error:
            raise InputFileError("the line is not JSON", source, line=number) from error
        if not isinstance(row, dict) or "id" not in row or not isinstance(row.get(field), str):
            raise InputFileError(
                f'expected an object with "id" and a text "{field}"', source, line=number
            )
        yield row
