"""`plainspoken plan`: a domain and a goal to a policy."""

from __future__ import annotations

import json
import shutil
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click

from plainspoken.cli.exit import NO, write_whole
from plainspoken.cli.goal import chosen_goal, goal_options
from plainspoken.cli.site import FILE, chosen_site, site_options
from plainspoken.logic.formula import Formula
from plainspoken.logic.syntax import unparse
from plainspoken.pipeline import Site, find_policy, why_not
from plainspoken.planning.policy import Policy
from plainspoken.planning.solver import Ending, OutOfTime, Solved, Unsolvable
from plainspoken.planning.watch import Progress

PATIENCE = 0.5
"""Seconds of search before progress is shown."""
MOST_SHOWN = 40
"""Nodes of a policy that are printed; more are counted."""


@click.command()
@site_options
@goal_options
@click.option("--strong", is_flag=True, help="Only a policy without loops will do.")
@click.option("--lucky", is_flag=True, help="Where there is none, take one that needs luck.")
@click.option("--timeout", type=click.FloatRange(min=0), metavar="S", help="Seconds, at most.")
@click.option("--engine", type=click.Choice(["own", "prp"]), default="own", help="Who searches.")
@click.option("--prp", type=FILE, metavar="PATH", help="The program prp, for --engine prp.")
@click.option("--out", type=FILE, metavar="FILE", help="Write the policy, or the no, as JSON.")
@click.option("--json", "as_json", is_flag=True, help="Print that JSON.")
def plan(
    *,
    domain: Path | None,
    problem: Path | None,
    landmarks: Path | None,
    goal: str | None,
    say: str | None,
    timeout: float | None,
    engine: str,
    prp: Path | None,
    out: Path | None,
    strong: bool,
    lucky: bool,
    as_json: bool,
) -> None:
    """Find a policy that reaches a goal whatever the actions turn out to do.

    The policy is strong-cyclic: it comes to the end if no outcome is avoided for ever. With
    --strong it has no loops at all. It is validated before it is handed out. Exit status 3
    where there is none, with the reason; with --lucky, a way that works if all turns out well.

    \b
    plainspoken plan --say "Clear line 2, but stay out of line 3"
    plainspoken plan -d domain.pddl -p problem.pddl --goal "F at_home & G !wet" --out policy.json
    """
    started = time.perf_counter()
    site: Site = chosen_site(domain, problem, landmarks)
    parsed = time.perf_counter() - started
    formula, extraction = chosen_goal(goal, say, site)
    if extraction is not None and not as_json:
        click.echo(f"goal: {unparse(formula)}", err=True)
    if engine == "prp":
        ending = _found_by_prp(prp, site, formula, strong=strong, timeout=timeout)
    else:
        with progress_shown() as on_progress:
            ending = find_policy(
                site.problem,
                formula,
                strong=strong,
                lucky=lucky,
                timeout=timeout,
                on_progress=on_progress,
            )
    document = {**document_of(ending, site), "goal": unparse(formula)}
    seconds = document["seconds"]
    document["seconds"] = {"parse": parsed, **seconds, "total": time.perf_counter() - started}
    text = json.dumps(document, ensure_ascii=False)
    if out is not None:
        write_whole(out, text + "\n")
    if as_json:
        click.echo(text)
    else:
        _print(ending, document, out)
    if isinstance(ending, Solved) and ending.policy.kind == "weak":
        count = len(ending.policy.gaps)
        click.echo(
            f"warning: this works only with luck: {count} outcomes have no answer (see gaps)",
            err=True,
        )
    if not isinstance(ending, Solved):
        sys.exit(NO)


def document_of(ending: Ending, site: Site) -> dict[str, Any]:
    """What `plan --out` writes, whatever the ending."""
    if isinstance(ending, Solved):
        return ending.policy.to_json()
    return {
        "status": "unsolvable" if isinstance(ending, Unsolvable) else "out_of_time",
        "kind": None,
        "initial": None,
        "static": [],
        "nodes": [],
        "seconds": {},
        "reason": why_not(ending, site),
        "reason_detail": ending.reason.detail() if isinstance(ending, Unsolvable) else None,
    }


def _found_by_prp(
    prp: Path | None, site: Site, formula: Formula, *, strong: bool, timeout: float | None
) -> Ending:
    """What an external PRP finds for the compiled problem, validated as our own policies are."""
    from plainspoken.backends.prp import solve_with_prp

    if strong:
        raise click.UsageError("PRP finds strong-cyclic policies only: leave out --strong")
    path = prp or shutil.which("prp")
    if path is None:
        raise click.UsageError("--engine prp needs --prp PATH: there is no prp on the PATH")
    return solve_with_prp(site.problem, formula, Path(path), timeout=timeout)


@contextmanager
def progress_shown() -> Iterator[Callable[[Progress], None] | None]:
    """A line on the terminal that says how far a long search is."""
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console

    console = Console(stderr=True)
    with console.status("planning ...") as status:

        def show(at: Progress) -> None:
            if at.seconds > PATIENCE:
                status.update(
                    f"planning, {at.seconds:.0f} s: {at.closed} states have an action, "
                    f"{at.waiting} wait for one, {at.dead} are dead ends"
                )

        yield show


def _print(ending: Ending, document: dict[str, Any], out: Path | None) -> None:
    total = document["seconds"]["total"]
    if isinstance(ending, Solved):
        policy = ending.policy
        click.echo(f"solved: a {policy.kind} policy of {len(policy.nodes)} nodes, {total:.2f} s")
        click.echo(listing(policy) if out is None else f"written to {out}")
    elif isinstance(ending, OutOfTime):
        click.echo(f"out of time: {document['reason']}")
        click.echo("hint: give a longer --timeout, or a smaller goal", err=True)
    else:
        click.echo(f"unsolvable: {document['reason']}")
        if "way" in document["reason_detail"]:
            click.echo("hint: --lucky takes the way that needs luck", err=True)


def listing(policy: Policy) -> str:
    """The policy as lines of text: each node, its action, and where the outcomes lead."""
    lines = []
    for node in policy.nodes[:MOST_SHOWN]:
        if node.action is None:
            lines.append(f"{node.id:>5}  done")
        else:
            targets = " or ".join(map(str, node.successors))
            lines.append(f"{node.id:>5}  {node.action}  -> {targets}")
    if len(policy.nodes) > MOST_SHOWN:
        lines.append(f"       and {len(policy.nodes) - MOST_SHOWN} more nodes; see --out")
    return "\n".join(lines)
