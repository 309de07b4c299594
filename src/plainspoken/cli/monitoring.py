"""`plainspoken eval monitoring`: the paper's experiment on answers, on three sites."""

from __future__ import annotations

import json
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import click
from rich.console import Console

from plainspoken import __version__
from plainspoken.cli.exit import write_whole
from plainspoken.cli.shown import shown_table
from plainspoken.cli.site import FILE
from plainspoken.errors import PlainspokenError
from plainspoken.evaluation.batch import URL, NoReply, Replies, read_replies
from plainspoken.evaluation.monitoring import (
    RUNS,
    Reader,
    Run,
    Situation,
    answered,
    read_back,
    run_to_json,
    situations,
)
from plainspoken.evaluation.monitoring_report import markdown, picture, tables
from plainspoken.logic.syntax import parse
from plainspoken.pipeline import bundled, find_policy, open_site
from plainspoken.planning.solver import Solved
from plainspoken.questions.fluents import fluents_in
from plainspoken.questions.moment import Moment

GOALS = {
    "vineyard": "F cleared_l0 & F cleared_l2 & G(full_b -> F !full_b)",
    "warehouse": "F delivered_crate & F delivered_drum",
    "kitchen": "F served_soup & F !open_fridge",
}
"""What the robots of the experiment were asked for."""
PROMPT = (
    "You are the robot that carries out the policy below in the planning problem below. Answer the "
    "question of the person beside you in plain English, in one short paragraph, from the policy "
    "and the problem alone."
)


@click.command()
@click.option("--runs", type=click.IntRange(min=1), default=RUNS, show_default=True, metavar="N")
@click.option("--seed", type=int, default=0, show_default=True, metavar="S")
@click.option("--out", type=FILE, metavar="DIR", help="Write runs, tables and pictures.")
@click.option("--export-batch", type=FILE, metavar="FILE", help="Write OpenAI Batch requests.")
@click.option("--import-batch", type=FILE, metavar="FILE", help="Score the replies to them.")
@click.option("--batch-model", default="gpt-4o", show_default=True, metavar="NAME")
@click.option(
    "--reader", metavar="PROVIDER:NAME", help="Have a language model read the fluents in a text."
)
def monitoring(
    *,
    runs: int,
    seed: int,
    out: Path | None,
    export_batch: Path | None,
    import_batch: Path | None,
    batch_model: str,
    reader: str | None,
) -> None:
    """Ask while plans are carried out, and score the fluents of the answers.

    The paper's experiment: a question falls after some action, with a probability that grows; the
    fluents of its answer are compared with those of the states. Ours are scored by the claims
    that come with an answer, and by what is read back from its words; a model's by its words.

    \b
    plainspoken eval monitoring --out results
    plainspoken eval monitoring --export-batch requests.jsonl
    plainspoken eval monitoring --import-batch replies.jsonl --out results-gpt
    """
    if export_batch is not None and import_batch is not None:
        raise click.UsageError("give --export-batch or --import-batch, not both")
    falls = tuple(_situations(runs, seed))
    if export_batch is not None:
        briefly = [each for each in falls if not each.full]
        documents = (json.dumps(_request(each, batch_model)) for each in briefly)
        write_whole(export_batch, "".join(f"{line}\n" for line in documents))
        click.echo(f"{len(briefly)} requests written to {export_batch}", err=True)
        return
    with _reader(reader) as read:
        results = _results(falls, import_batch, read)
    _write(results, out, f"{runs} runs a category and domain, seed {seed}, version {__version__}.")


@contextmanager
def _reader(model: str | None) -> Iterator[Reader]:
    """Whoever reads fluents in the texts."""
    if model is None:
        yield fluents_in
        return
    from plainspoken.cli.translator import language_model
    from plainspoken.language.completion import PATIENCE
    from plainspoken.questions.model_reading import fluents_by_model

    with language_model(model, PATIENCE) as connected:
        yield partial(fluents_by_model, model=connected)


def _results(
    falls: Sequence[Situation], import_batch: Path | None, reader: Reader
) -> dict[str, tuple[Run, ...]]:
    if import_batch is not None:
        replies = read_replies(import_batch, {each.id for each in falls})
        return {"words of the batch": tuple(_replied(falls, replies, reader))}
    ours = tuple(answered(each, time.perf_counter) for each in falls)
    lexica = {run.situation.domain: Moment(run.situation.entries).lexicon for run in ours}
    back = (read_back(r.situation, r.text, lexica[r.situation.domain], reader) for r in ours)
    return {"claims": ours, "words": tuple(back)}


def _situations(runs: int, seed: int) -> Iterator[Situation]:
    for name, goal in GOALS.items():
        folder = bundled(name)
        site = open_site(folder / "domain.pddl", folder / "problem.pddl", folder / "landmarks.json")
        ending = find_policy(site.problem, parse(goal))
        if not isinstance(ending, Solved):
            raise PlainspokenError(f"no policy was found for the example {name}")
        yield from situations(name, site, ending.policy, runs=runs, seed=seed)


def _replied(falls: Sequence[Situation], replies: Replies, reader: Reader) -> Iterator[Run]:
    """The runs that a batch replied to.

    raises PlainspokenError: when it has no reply to one, or none that can be scored
    """
    for each in falls:
        if each.full:
            continue  # A model is asked once; only our answers know a brief and a full register.
        reply = replies.get(each.id, NoReply("the batch has no reply to it"))
        if isinstance(reply, NoReply):
            raise PlainspokenError(f"{each.id}: {reply.reason}")
        yield read_back(each, reply, Moment(each.entries).lexicon, reader)


def _request(situation: Situation, model: str) -> dict[str, Any]:
    """What the paper hands to its model: the question, the policy, the PDDL; and where it is."""
    accepted, chosen = (entry.event for entry in situation.entries[:2])
    told = {
        "domain": getattr(accepted, "domain", ""),
        "problem": getattr(accepted, "problem", ""),
        "policy": getattr(chosen, "policy", {}),
        "actions done so far": situation.at,
    }
    return {
        "custom_id": situation.id,
        "method": "POST",
        "url": URL,
        "body": {
            "model": model,
            "temperature": 1e-7,  # As in the paper.
            "messages": [
                {"role": "system", "content": f"{PROMPT}\n\n{json.dumps(told)}"},
                {"role": "user", "content": situation.question},
            ],
        },
    }


def _write(results: dict[str, tuple[Run, ...]], out: Path | None, caption: str) -> None:
    console = Console()
    for table in tables(results):
        console.print(shown_table(table))
    if out is None:
        return
    out.mkdir(parents=True, exist_ok=True)
    kept = [
        json.dumps({"fluents": source, **run_to_json(run)}, ensure_ascii=False)
        for source, runs in results.items()
        for run in runs
    ]
    write_whole(out / "runs.jsonl", "".join(f"{line}\n" for line in kept))
    write_whole(out / "monitoring.md", markdown(results, caption))
    first = next(iter(results.values()))
    for full in (False, True):
        chosen = [run for run in first if run.situation.full is full]
        if chosen:
            name = "full" if full else "brief"
            write_whole(out / f"monitoring-{name}.svg", picture(chosen, timed=True))
    click.echo(f"written to {out}: runs.jsonl, monitoring.md, monitoring-*.svg", err=True)
