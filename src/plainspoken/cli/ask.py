"""`plainspoken ask`: what the robot is doing, has done, will do, and why."""

from __future__ import annotations

import json
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from plainspoken.cli.batch import batch_options, run_batch
from plainspoken.cli.site import FILE
from plainspoken.cli.store import entries_of, store_option
from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.jsonl import read_jsonl
from plainspoken.questions.answer import answer_at
from plainspoken.questions.claim import Answer
from plainspoken.questions.moment import Moment
from plainspoken.world.event import Entry


@click.command()
@click.argument("question", required=False)
@click.option("--log", type=FILE, metavar="RUN", help="The events that run --log wrote.")
@click.option("--mission", metavar="ID", help="A mission in the store (default: the last one).")
@store_option
@click.option("--at", type=click.IntRange(min=0), metavar="STEP", help="Answer as if asked then.")
@batch_options("question")
@click.option("--full", is_flag=True, help="Tell every fact that matters, not the main ones.")
@click.option(
    "--rephrase",
    metavar="PROVIDER:NAME",
    help="Have a language model say it, checked, in its words.",
)
@click.option("--explain", is_flag=True, help="Show what a model said, and what was wrong with it.")
@click.option("--speak", is_flag=True, help="Say the answer aloud, too, by espeak-ng.")
@click.option("--json", "as_json", is_flag=True, help="Print claims and evidence, too.")
def ask(
    *,
    question: str | None,
    log: Path | None,
    mission: str | None,
    store: str | None,
    at: int | None,
    batch: Path | None,
    out: Path | None,
    full: bool,
    rephrase: str | None,
    explain: bool,
    speak: bool,
    as_json: bool,
) -> None:
    """Ask what the robot is doing, has done, will do, why, and how far it is.

    The answer is computed from the log and the policy in it; each claim carries the instants it
    is about and the entries it rests on. Without --log, the mission run last is asked.

    \b
    plainspoken ask "What are you doing now?"
    plainspoken ask "Why?" --log run.jsonl --at 12 --json
    """
    entries = _entries(log, mission, store)
    if at is not None and at >= len(entries):
        raise PlainspokenError(
            f"there is no step {at} in this log", hint=f"its steps are 0 to {len(entries) - 1}"
        )
    moment = Moment(entries, at)

    def answered(text: str, id: object = None) -> tuple[Answer, dict[str, Any]]:
        started = time.perf_counter()
        found = answer_at(text, moment, full=full)
        return found, found.to_json(id, text, time.perf_counter() - started)

    if batch is not None:
        if speak:
            raise click.UsageError("--speak goes with one QUESTION, not with --batch")
        run_batch(batch, out, "question", lambda text, id: answered(text, id)[1])
    elif not question or not question.strip():
        raise click.UsageError("ask a QUESTION, in quotes, or give --batch")
    elif as_json:
        found, document = answered(question)
        click.echo(json.dumps(document, indent=2, ensure_ascii=False))
        _spoken(found.text, speak=speak)
    elif rephrase is not None:
        said = _say_rephrased(answered(question)[0], moment, rephrase, explain=explain)
        _spoken(said, speak=speak)
    else:
        text = answered(question)[0].text
        click.echo(text)
        _spoken(text, speak=speak)


def _spoken(text: str, *, speak: bool) -> None:
    """Say an answer that was printed."""
    if speak:
        from plainspoken.backends.espeak import Espeak

        Espeak().say(text)


def _say_rephrased(found: Answer, moment: Moment, model: str, *, explain: bool) -> str:
    """Print an answer in a model's words where they pass, else as it was computed."""
    from plainspoken.cli.translator import language_model
    from plainspoken.language.completion import PATIENCE
    from plainspoken.questions.rephrasing import rephrased

    with language_model(model, PATIENCE) as connected:
        said = rephrased(found, moment, connected)
    click.echo(said.text)
    if not explain:
        return said.text
    for attempt in said.attempts:
        verdict = "; ".join(attempt.faults) or "states what was computed, and nothing else"
        click.echo(f"  {attempt.text or '(no text)'}\n    {verdict}", err=True)
    if said.fell_back:
        click.echo("  so the computed words are said", err=True)
    return said.text


def _entries(log: Path | None, mission: str | None, store: str | None) -> Sequence[Entry]:
    if log is not None and (mission is not None or store is not None):
        raise click.UsageError("give --log, or --mission and --store")
    if log is not None:
        return read_jsonl(log).entries
    return entries_of(mission, store)
