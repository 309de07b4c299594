"""`plainspoken check`: an independent validator of policies."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import click

from plainspoken.cli.exit import NO
from plainspoken.cli.goal import chosen_goal
from plainspoken.cli.site import FILE
from plainspoken.pipeline import open_site
from plainspoken.planning.policy import check_belongs, read_policy
from plainspoken.planning.validation import Invalid, validate


@click.command()
@click.option("--domain", "-d", type=FILE, required=True, metavar="D", help="PDDL domain.")
@click.option("--problem", "-p", type=FILE, required=True, metavar="P", help="PDDL problem.")
@click.option("--goal", "-g", metavar="LTLF", help="The goal (default: the problem's own :goal).")
@click.option("--policy", type=FILE, required=True, metavar="FILE", help="What plan --out wrote.")
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
def check(domain: Path, problem: Path, goal: str | None, policy: Path, *, as_json: bool) -> None:
    """Validate a policy from the PDDL and the formula alone.

    Shares no code with the solver but the parser. A policy is valid when every action is
    applicable, every outcome is covered and none is invented, the end can be reached from
    everywhere, and the goal is true on every way to stop. Exit status 3 where it is not. A weak
    policy (plan --lucky) need not cover the outcomes that it names as its gaps.

    \b
    plainspoken plan  -d domain.pddl -p problem.pddl -g "F done" --out policy.json
    plainspoken check -d domain.pddl -p problem.pddl -g "F done" --policy policy.json
    """
    site = open_site(domain, problem)
    formula, _ = chosen_goal(goal, None, site)
    checked = read_policy(policy)
    check_belongs(checked, site.problem, policy)
    verdict = validate(site.problem, formula, checked)
    reason = verdict.reason if isinstance(verdict, Invalid) else None
    node = verdict.node if isinstance(verdict, Invalid) else None
    if as_json:
        document = {"valid": reason is None, "reason": reason, "node": node}
        document.update(kind=checked.kind, gaps=len(checked.gaps))
        click.echo(json.dumps({**document, "nodes": len(checked.nodes)}, indent=2))
    elif reason is None:
        click.echo(f"valid: {len(checked.nodes)} nodes, {checked.kind}")
        if checked.kind == "weak":
            click.echo(
                f"  it reaches the goal if none of {len(checked.gaps)} outcomes happens that it "
                f"has no answer to; it is no guarantee"
            )
    else:
        click.echo(f"not valid: {reason}" + ("" if node is None else f" (node {node})"))
    if reason is not None:
        sys.exit(NO)
