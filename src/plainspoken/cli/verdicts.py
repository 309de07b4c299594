"""`plainspoken missions verdicts`: what was known of the request after each instant."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import click
from rich.console import Console
from rich.table import Table
from rich.text import Text

from plainspoken.cli.exit import NO
from plainspoken.cli.site import FILE
from plainspoken.cli.store import entries_of, store_option
from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.jsonl import read_jsonl
from plainspoken.mission.judgement import Judgement, first_breach, judgements


@click.command()
@click.argument("id", required=False)
@click.option("--log", type=FILE, metavar="FILE", help="A log that was written to a file.")
@store_option
@click.option("--json", "as_json", is_flag=True, help="Print JSON, one judgement a line.")
def verdicts(id: str | None, log: Path | None, store: str | None, *, as_json: bool) -> None:
    """Tell after each instant how the request of the mission ID stands, clause by clause.

    "satisfied" and "violated" are for good; what "holds so far" may be broken yet, what is "open"
    may be met yet. Exit status 3 where the request was broken; the entry that did it is named.
    """
    if log is not None and id is not None:
        raise PlainspokenError("give a mission's name or --log, not both")
    entries = read_jsonl(log).entries if log is not None else entries_of(id, store)
    found = list(judgements(entries))
    breach = first_breach(found)
    if as_json:
        for each in found:
            click.echo(json.dumps(_to_json(each), ensure_ascii=False))
    else:
        Console().print(_table(found))
        if breach is not None:
            click.echo(_said(breach))
    if breach is not None:
        sys.exit(NO)


def _to_json(judged: Judgement) -> dict[str, Any]:
    return {
        "instant": judged.instant,
        "step": judged.step,
        "verdict": str(judged.verdict),
        "clauses": {clause: str(verdict) for clause, verdict in judged.clauses},
        "action": judged.action,
        "reason": judged.reason,
    }


def _table(found: list[Judgement]) -> Table:
    """A row for each judgement; of the clauses those whose verdict is new."""
    table = Table("instant", "after", "the whole", "what is new of its clauses", box=None)
    known: dict[str, str] = {}
    for judged in found:
        now = {clause: str(verdict) for clause, verdict in judged.clauses}
        new = [f"{each}: {verdict}" for each, verdict in now.items() if known.get(each) != verdict]
        known = now
        style = "bold red" if judged.verdict == "violated" else ""
        cells = (str(judged.instant), judged.action or "", str(judged.verdict), "\n".join(new))
        table.add_row(*map(Text, cells), style=style)
    return table


def _said(breach: Judgement) -> str:
    by = f"by {breach.action}" if breach.action else "by no action"
    what = ", ".join(breach.broken) or breach.reason or "its clauses cannot all be met any more"
    return f"broken at instant {breach.instant}, {by} (step {breach.step}): {what}"
