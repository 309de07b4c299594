"""`plainspoken export`: policies and automata for other tools."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import click

from plainspoken.automata.construction import automata_for
from plainspoken.automata.hoa import hoa as automaton_text
from plainspoken.cli.exit import write_whole
from plainspoken.cli.goal import chosen_goal, goal_options
from plainspoken.cli.site import FILE, chosen_site, site_options
from plainspoken.logic.syntax import parse
from plainspoken.pipeline import Site
from plainspoken.planning import diagram
from plainspoken.planning.policy import read_policy
from plainspoken.questions.lexicon import Lexicon


@click.group()
def export() -> None:
    """Write a policy, an automaton or a compiled problem for other tools.

    \b
    plainspoken plan --say "Clear line 2" --out policy.json
    plainspoken export dot policy.json | dot -Tsvg > policy.svg
    plainspoken export rules policy.json --words
    plainspoken export hoa "G(full_b -> F call_support_executed)"
    plainspoken export pddl --say "Clear line 2" --out-domain d.pddl --out-problem p.pddl
    """


def _written(text: str, out: Path | None) -> None:
    if out is None:
        click.echo(text, nl=False)
    else:
        write_whole(out, text)


_out = click.option("--out", type=FILE, metavar="FILE", help="Where to (default: the terminal).")


_words = click.option(
    "--words", is_flag=True, help="In words; for another site than the vineyard give -d and -p."
)

_compact = click.option(
    "--compact", is_flag=True, help="One box for all nodes with one rule; see export rules."
)


@export.command()
@click.argument("policy", type=FILE)
@_words
@_compact
@site_options
@_out
def dot(policy: Path, *, words: bool, compact: bool, out: Path | None, **site: Path | None) -> None:
    """POLICY, which plan --out wrote, as a graph in DOT (Graphviz)."""
    _written(diagram.dot(_drawn(policy, site, words=words, compact=compact)), out)


@export.command()
@click.argument("policy", type=FILE)
@_words
@_compact
@site_options
@_out
def mermaid(
    policy: Path, *, words: bool, compact: bool, out: Path | None, **site: Path | None
) -> None:
    """POLICY, which plan --out wrote, as a Mermaid flowchart for Markdown pages."""
    _written(diagram.mermaid(_drawn(policy, site, words=words, compact=compact)), out)


@export.command()
@click.argument("policy", type=FILE)
@_words
@site_options
@_out
def rules(policy: Path, *, words: bool, out: Path | None, **site: Path | None) -> None:
    """POLICY, which plan --out wrote, as a short list: if these facts hold, then this action."""
    action, atom = _labels(site, words=words)
    _written(diagram.rules(read_policy(policy), action=action, atom=atom), out)


def _drawn(
    policy: Path, site: Mapping[str, Path | None], *, words: bool, compact: bool
) -> diagram.Drawing:
    action, atom = _labels(site, words=words)
    draw = diagram.compact if compact else diagram.whole
    return draw(read_policy(policy), action=action, atom=atom)


def _labels(site: Mapping[str, Path | None], *, words: bool) -> tuple[diagram.Words, diagram.Words]:
    """How to write actions and atoms: as in PDDL, or in the words of the site that is named."""
    if not words:
        return str, str
    chosen: Site = chosen_site(site["domain"], site["problem"], site["landmarks"])
    lexicon = Lexicon(chosen.problem, chosen.landmarks)
    return lambda action: lexicon.deed(action).bare, lambda atom: lexicon.clause(atom).said()


@export.command()
@click.argument("formula")
@_out
def hoa(formula: str, out: Path | None) -> None:
    """The automata of FORMULA, one for each conjunct, in the Hanoi format."""
    _written("".join(map(automaton_text, automata_for(parse(formula)))), out)


@export.command()
@site_options
@goal_options
@click.option("--out-domain", type=FILE, metavar="FILE", help="Where to write the domain.")
@click.option("--out-problem", type=FILE, metavar="FILE", help="Where to write the problem.")
def pddl(
    *,
    domain: Path | None,
    problem: Path | None,
    landmarks: Path | None,
    goal: str | None,
    say: str | None,
    out_domain: Path | None,
    out_problem: Path | None,
) -> None:
    """A ground domain and problem whose plain :goal means the formula, for any FOND planner.

    Without --out-domain and --out-problem both are printed; with one of them, the other is
    written beside it as domain-compiled.pddl or problem-compiled.pddl.
    """
    from plainspoken.planning.compilation import compiled

    site = chosen_site(domain, problem, landmarks)
    formula, _ = chosen_goal(goal, say, site)
    made = compiled(site.problem, formula)
    given = out_domain or out_problem
    if given is None:
        click.echo(made.domain + made.problem, nl=False)
        return
    write_whole(out_domain or given.with_name("domain-compiled.pddl"), made.domain)
    write_whole(out_problem or given.with_name("problem-compiled.pddl"), made.problem)
