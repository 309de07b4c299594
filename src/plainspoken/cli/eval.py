"""`plainspoken eval`: the experiments, on a corpus that comes along or on one's own."""

from __future__ import annotations

import json
import multiprocessing
import os
import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import BrokenExecutor, Executor, ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import contextmanager, nullcontext
from pathlib import Path

import click
from rich.console import Console
from rich.progress import track
from rich.text import Text

from plainspoken import __version__
from plainspoken.cli.exit import write_whole
from plainspoken.cli.monitoring import monitoring
from plainspoken.cli.shown import MOST_SHOWN, shown_table
from plainspoken.cli.site import FILE
from plainspoken.cli.translator import chosen_translator, translator_options
from plainspoken.errors import PlainspokenError
from plainspoken.evaluation.batch import FromReplies, read_replies, requests
from plainspoken.evaluation.corpus import Row, brings_landmarks, read_corpus
from plainspoken.evaluation.experiment import Result, Translate, run_experiment
from plainspoken.evaluation.figure import picture
from plainspoken.evaluation.journal import Journal
from plainspoken.evaluation.summary import Summary, summarised, summary_to_json
from plainspoken.evaluation.table import caption, confusion, failures, markdown, mistaken, tables
from plainspoken.evaluation.translation import WithModel, embedded
from plainspoken.language.recorded import RecordedModel
from plainspoken.language.second_opinion import SecondOpinion
from plainspoken.pipeline import bundled
from plainspoken.world.landmark import read_landmarks

WORTH_PROCESSES = 200
"""Sentences from which starting further processes pays."""


@click.group(name="eval")
def eval() -> None:  # noqa: A001 - the name of the command
    """Measure how well sentences are understood, and how true answers are."""


eval.add_command(monitoring)


@eval.command()
@click.option(
    "--corpus", "-c", type=FILE, metavar="C", help="JSON lines (default: the vineyard's sentences)."
)
@click.option(
    "--landmarks",
    "-l",
    type=FILE,
    metavar="L",
    help="Landmarks (default: landmarks.json beside the corpus, or each row's own symbols).",
)
@click.option("--out", type=FILE, metavar="DIR", help="Write results, tables and a picture.")
@click.option("--resume", is_flag=True, help="Go on with the results that DIR has.")
@click.option(
    "--workers",
    type=click.IntRange(min=1),
    metavar="N",
    help="Sentences side by side (default: for a large corpus, as many as processors).",
)
@translator_options
@click.option("--export-batch", type=FILE, metavar="FILE", help="Write OpenAI Batch requests.")
@click.option("--import-batch", type=FILE, metavar="FILE", help="Score the replies to them.")
@click.option(
    "--batch-model",
    default="gpt-4o",
    show_default=True,
    metavar="NAME",
    help="The model that --export-batch asks.",
)
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
def extraction(
    *,
    corpus: Path | None,
    landmarks: Path | None,
    out: Path | None,
    workers: int | None,
    export_batch: Path | None,
    import_batch: Path | None,
    batch_model: str,
    resume: bool,
    as_json: bool,
) -> None:
    """Translate a corpus, and compare every formula with the one it should be.

    Formulas are compared by equivalence over all non-empty finite traces, never as text. Every
    sentence ends in a named outcome: right, wrong formula, wrong grounding, asked, refused, or
    failed with a reason.

    \b
    plainspoken eval extraction --out results
    plainspoken eval extraction --corpus examples/kitchen/sentences.jsonl --json
    plainspoken eval extraction --mode llm --model ollama:qwen3 --out qwen3 --resume
    plainspoken eval extraction --export-batch requests.jsonl
    plainspoken eval extraction --import-batch replies.jsonl --out results-gpt
    """
    if export_batch is not None and import_batch is not None:
        raise click.UsageError("give --export-batch or --import-batch, not both")
    if resume and (out is None or import_batch is not None):
        raise click.UsageError("--resume goes on with the results in --out, for sentences we run")
    path = corpus or bundled("vineyard") / "sentences.jsonl"
    rows = _rows(path, landmarks)
    if export_batch is not None:
        lines = (json.dumps(each, ensure_ascii=False) for each in requests(rows, batch_model))
        write_whole(export_batch, "".join(f"{line}\n" for line in lines))
        click.echo(f"{len(rows)} requests written to {export_batch}", err=True)
        return
    with _measured(import_batch, rows) as (mode, translate):
        results = _results(rows, mode, translate, out, workers, resume=resume)
    corpus_name = f"{path.resolve().parent.name}/{path.name}"
    summary = summarised(rows, results, corpus=corpus_name, mode=mode, version=__version__)
    if out is not None:
        write_whole(out / "extraction.md", markdown(summary))
        write_whole(out / "extraction.svg", picture(summary))
    if as_json:
        click.echo(json.dumps(summary_to_json(summary), indent=2, ensure_ascii=False))
    else:
        _print(summary, Console(), out)


def _rows(corpus: Path, landmarks: Path | None) -> tuple[Row, ...]:
    beside = corpus.parent / "landmarks.json"
    if landmarks is None and not brings_landmarks(corpus) and beside.is_file():
        landmarks = beside
    return read_corpus(corpus, None if landmarks is None else read_landmarks(landmarks))


@contextmanager
def _measured(batch: Path | None, rows: Sequence[Row]) -> Iterator[tuple[str, Translate]]:
    """Whom the options ask to translate, and what to call it."""
    if batch is not None:
        yield "batch", FromReplies(read_replies(batch, {row.id for row in rows}))
        return
    with chosen_translator() as translator:
        if not isinstance(translator, SecondOpinion):
            yield "embedded", embedded
            return
        # The name of the model belongs to the mode: another model's results are not its own.
        name = translator.model.name if isinstance(translator.model, RecordedModel) else "model"
        stages = ", in stages" if translator.staged else ""
        yield f"{translator.mode} ({name}{stages})", WithModel(translator)


def _results(
    rows: Sequence[Row],
    mode: str,
    translate: Translate,
    out: Path | None,
    workers: int | None,
    *,
    resume: bool,
) -> list[Result]:
    """Run what has not been run, writing each result down as it comes."""
    if workers is None:
        # What a batch replied is only looked up, and a model may serve one at a time.
        worth = translate is embedded and len(rows) >= WORTH_PROCESSES
        workers = (os.cpu_count() or 1) if worth else 1
    results = []
    journal = nullcontext() if out is None else Journal(out / "results.jsonl", resume=resume)
    with journal as kept, _side_by_side(min(workers, len(rows)), translate) as executor:
        running = run_experiment(
            rows,
            mode,
            translate,
            known={} if kept is None else kept.known,
            executor=executor,
            timed=not isinstance(translate, FromReplies),
        )
        for result, new in track(
            running,
            total=len(rows),
            description=f"{len(rows)} sentences",
            console=Console(stderr=True),
            disable=not sys.stderr.isatty(),
        ):
            if new and kept is not None:
                kept.append(result)
            results.append(result)
    return results


@contextmanager
def _side_by_side(count: int, translate: Translate) -> Iterator[Executor | None]:
    """Processes for the embedded translator, threads for those that wait; neither for one."""
    if count == 1:
        yield None
        return
    executor: Executor
    if translate is embedded:
        # Spawned, not forked: the progress bar is a thread.
        executor = ProcessPoolExecutor(count, mp_context=multiprocessing.get_context("spawn"))
    else:
        executor = ThreadPoolExecutor(count)
    try:
        yield executor
    except BrokenExecutor as error:
        raise PlainspokenError(
            "a process of the run was killed",
            hint="with --out, --resume goes on where it stopped; try fewer --workers",
        ) from error
    finally:
        executor.shutdown(cancel_futures=True)


def _print(summary: Summary, console: Console, out: Path | None) -> None:
    console.print(Text(caption(summary)), style="dim")
    wide = confusion(summary).title
    shown = [each for each in tables(summary) if each.title != wide]
    shown += [each for each in (mistaken(summary), failures(summary)) if each.rows]
    for values in shown:
        console.print(shown_table(values))
        if len(values.rows) > MOST_SHOWN:
            left = len(values.rows) - MOST_SHOWN
            console.print(f"  and {left} more rows: see --out or --json\n", style="dim")
    if out is not None:
        click.echo(f"written to {out}: results.jsonl, extraction.md, extraction.svg", err=True)
