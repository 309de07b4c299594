"""The options that say what: a formula, a sentence, or neither for the problem's own goal."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

import click

from plainspoken.cli.exit import NO
from plainspoken.cli.translator import chosen_translator, translator_options
from plainspoken.logic.formula import Formula
from plainspoken.logic.syntax import parse
from plainspoken.planning.goal import denotations, problem_goal

if TYPE_CHECKING:
    from plainspoken.language.extraction import Extraction
    from plainspoken.pipeline import Site

F = TypeVar("F", bound=Callable[..., Any])


def goal_options(command: F) -> F:
    """Add --goal and --say, and who translates what is said, to a command."""
    command = translator_options(command)
    command = click.option("--say", "-s", metavar="SENTENCE", help="The goal in plain words.")(
        command
    )
    return click.option(
        "--goal",
        "-g",
        metavar="LTLF",
        help="The goal as an LTLf formula. With neither: the problem's own :goal.",
    )(command)


def chosen_goal(goal: str | None, say: str | None, site: Site) -> tuple[Formula, Extraction | None]:
    """The goal that the options name; exits with 3 where the sentence gives none.

    raises FormulaSyntaxError, UnknownSymbolError: for a formula that cannot be used
    """
    if goal is not None and say is not None:
        raise click.UsageError("give --goal or --say, not both")
    if say is None:
        formula = problem_goal(site.problem) if goal is None else parse(goal)
        denotations(formula, site.problem)
        return formula, None
    with chosen_translator() as translate:
        extraction = translate(say, site.vocabulary)
    if extraction.formula is None:
        click.echo(f"plainspoken: {no_formula(extraction)}", err=True)
        sys.exit(NO)
    return extraction.formula, extraction


def no_formula(extraction: Extraction) -> str:
    """Why a sentence gave no formula: the reason, or the question with its choices."""
    from plainspoken.language.extraction import Status

    if extraction.status is Status.REJECT:
        return extraction.reason or "the sentence is not a mission"
    choices = [f"  - {reading.english}" for reading in extraction.alternatives]
    return "\n".join([extraction.question or "which of these?", *choices])
