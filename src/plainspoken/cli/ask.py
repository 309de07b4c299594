"""`plainspoken ask`: what the robot is doing, has done, will do, and why."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import click
from click.core import ParameterSource

from plainspoken.cli.batch import batch_options, run_batch
from plainspoken.cli.record import utc_now
from plainspoken.cli.robots import person
from plainspoken.cli.site import FILE
from plainspoken.cli.store import entries_in, entries_of, open_store, store_option
from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.jsonl import read_jsonl
from plainspoken.pipeline import accepted_of, bundled
from plainspoken.questions.answer import answer_at
from plainspoken.questions.claim import Answer
from plainspoken.questions.length import Length
from plainspoken.questions.moment import Moment
from plainspoken.questions.retelling import retold
from plainspoken.questions.translated import LANGUAGES, Words, read_words
from plainspoken.work.asking import look
from plainspoken.work.shift import robots_of
from plainspoken.world.document import read_text
from plainspoken.world.event import Entry
from plainspoken.world.sense import Senses


@click.command()
@click.argument("question", required=False)
@click.option("--log", type=FILE, metavar="RUN", help="The events that run --log wrote.")
@click.option("--mission", metavar="ID", help="A mission in the store (default: the last one).")
@store_option
@click.option("--at", type=click.IntRange(min=0), metavar="STEP", help="Answer as if asked then.")
@batch_options("question")
@click.option(
    "--length",
    type=click.Choice([each.value for each in Length]),
    default=Length.BRIEF.value,
    show_default=True,
    help="One or two sentences, a few, or every fact that matters.",
)
@click.option(
    "--language",
    type=click.Choice(["en", *LANGUAGES]),
    default="en",
    show_default=True,
    help="The language of the answer; the question is in English.",
)
@click.option(
    "--words", type=FILE, metavar="W", help="The words of the domain in it (vineyard: none needed)."
)
@click.option("--full", is_flag=True, help="The same as --length full.")
@click.option(
    "--talk", is_flag=True, help="Go on talking: ask, report, and change your mind, line by line."
)
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
    length: str,
    language: str,
    words: Path | None,
    full: bool,
    rephrase: str | None,
    explain: bool,
    talk: bool,
    speak: bool,
    as_json: bool,
) -> None:
    """Ask what the robot is doing, has done, will do, why, and how far it is.

    The answer is computed from the log and the policy in it; each claim carries the instants it
    is about and the entries it rests on. Without --log, the mission run last is asked; what is not
    known is looked at first, where somebody carries the mission out and a service can tell.

    \b
    plainspoken ask "What are you doing now?"
    plainspoken ask "Why?" --log run.jsonl --at 12 --json
    plainspoken ask --talk
    """
    if talk:
        if question or log is not None or batch is not None or at is not None:
            raise click.UsageError("--talk goes with --mission and --store alone")
        _talk(mission, store)
        return
    entries = _entries(log, mission, store)
    live = log is None and at is None
    if at is not None and at >= len(entries):
        raise PlainspokenError(
            f"there is no step {at} in this log", hint=f"its steps are 0 to {len(entries) - 1}"
        )
    moment = Moment(entries, at, utc_now() if live else None)
    wanted = Length.FULL if full else Length(length)
    spoken = None if language == "en" else _words(words, moment)

    def answered(text: str, id: object = None) -> tuple[Answer, dict[str, Any]]:
        started = time.perf_counter()
        found, then = answer_at(text, moment, length=wanted), moment
        if live and batch is None and found.wanted:
            found, then = _looked(found, text, moment, store, wanted)
        if spoken is not None:
            found = replace(found, text=retold(found, then, spoken))
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


def _words(path: Path | None, moment: Moment) -> Words:
    """The words of a language other than English; those of the bundled vineyard are at hand."""
    if path is None:
        path = bundled("vineyard") / "words.it.json"
        if read_text(path.with_name("domain.pddl")) != moment.mission.domain:
            raise PlainspokenError(
                "there are no words for this domain in that language",
                hint=f"give them with --words; {path} is an example",
            )
    return read_words(path, moment.problem)


def _talk(mission: str | None, store: str | None) -> None:
    """Answer line by line; tell the mission what was reported, or is to change, once agreed to."""
    from plainspoken.cli.asked import put
    from plainspoken.questions.conversation import Conversation, message_of

    conversation = Conversation()
    with open_store(store) as kept:
        id = accepted_of(entries_in(kept, mission)).mission
        for line in sys.stdin:
            if not line.strip():
                continue
            said = conversation.say(line.strip(), Moment(kept.entries(id), now=utc_now()))
            conversation = said.then
            if said.agreed is not None:
                put(kept, id, message_of(said.agreed, person()))
            click.echo(said.answer.text)


def _looked(
    found: Answer, question: str, moment: Moment, store: str | None, length: Length
) -> tuple[Answer, Moment]:
    """An answer after a look at what it needs, where somebody carries the mission out who can."""
    senses = Senses.of(moment.mission)
    atoms = frozenset(filter(senses.can_tell, found.wanted))
    if not atoms or moment.ended is not None:
        return found, moment
    mission = moment.mission.mission
    with open_store(store) as kept:
        if not look(kept, mission, atoms, person(), robots_of(moment.mission)):
            return found, moment
        then = Moment(kept.entries(mission), now=utc_now())
    seen = answer_at(question, then, length=length)
    return replace(seen, text=f"Let me look. {seen.text}"), then


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
    source = click.get_current_context().get_parameter_source("store")
    named = store is not None and source is not ParameterSource.ENVIRONMENT
    if log is not None and (mission is not None or named):
        raise click.UsageError("give --log, or --mission and --store")
    if log is not None:
        return read_jsonl(log).entries
    return entries_of(mission, store)
