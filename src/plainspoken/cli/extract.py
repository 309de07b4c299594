"""`plainspoken extract`: a sentence to a formula, stage by stage."""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path

import click
from rich.console import Console
from rich.panel import Panel
from rich.table import Table
from rich.text import Text

from plainspoken.cli.batch import batch_options, run_batch
from plainspoken.cli.exit import NO
from plainspoken.cli.goal import no_formula
from plainspoken.cli.site import chosen_site, site_options
from plainspoken.cli.translator import chosen_translator, translator_options
from plainspoken.language.dialogue import Dialogue
from plainspoken.language.example import Examples, examples
from plainspoken.language.extraction import Extraction, Status
from plainspoken.language.grounding import Vocabulary
from plainspoken.logic.syntax import unparse
from plainspoken.world.landmark import read_landmarks


@click.command()
@click.argument("sentence", required=False)
@site_options
@batch_options("utterance")
@translator_options
@click.option("--explain", is_flag=True, help="Show every stage.")
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
@click.option("--no-input", is_flag=True, help="Print a question, and do not wait for the answer.")
def extract(
    *,
    sentence: str | None,
    domain: Path | None,
    problem: Path | None,
    landmarks: Path | None,
    batch: Path | None,
    out: Path | None,
    explain: bool,
    as_json: bool,
    no_input: bool,
) -> None:
    """Turn SENTENCE into an LTLf formula over the landmarks.

    A sentence that cannot be grounded is refused with the words that were not understood
    (exit status 3); an ambiguous one is asked back: at a terminal, type the letter or the words of
    an answer, or nothing to leave it open. Short examples of what the formula accepts and what it
    does not go with it. A landmarks file alone is enough.

    \b
    plainspoken extract "Never enter line 3 while the box is full" --explain
    plainspoken extract --landmarks L.json --batch sentences.jsonl --out formulas.jsonl
    plainspoken extract "Line 2, then line 1" --mode both --model ollama:qwen3
    """
    vocabulary = vocabulary_of(domain, problem, landmarks)
    if batch is not None:
        with chosen_translator() as translate:
            run_batch(
                batch, out, "utterance", lambda text, _: translate(text, vocabulary).to_json()
            )
        return
    if sentence is None:
        if sys.stdin.isatty():
            raise click.UsageError("say a SENTENCE, in quotes, or give --batch")
        sentence = sys.stdin.read().strip()
    with chosen_translator() as translate:
        extraction = translate(sentence, vocabulary)
        if sys.stdin.isatty() and not (as_json or no_input):
            extraction = answered(Dialogue(vocabulary, translate=translate), extraction)
    if as_json:
        document = extraction.to_json() | {"examples": shown(extraction, vocabulary).to_json()}
        click.echo(json.dumps(document, indent=2, ensure_ascii=False))
    elif explain:
        explained(extraction, vocabulary, Console())
    elif extraction.reading is not None and extraction.status is Status.OK:
        click.echo(unparse(extraction.reading.formula))
        click.echo(extraction.reading.english, err=True)
        by_example = shown(extraction, vocabulary).english
        if by_example:
            click.echo(by_example, err=True)
        if extraction.note:
            click.echo(f"note: {extraction.note}", err=True)
    else:
        click.echo(f"plainspoken: {no_formula(extraction)}", err=True)
    if extraction.status is Status.REJECT:
        sys.exit(NO)


def answered(dialogue: Dialogue, extraction: Extraction) -> Extraction:
    """Ask the person at the terminal until no question is open, or they leave it open."""
    dialogue = replace(dialogue, asked=extraction)
    while extraction.status is Status.CLARIFY:
        click.echo(f"plainspoken: {extraction.question}", err=True)
        # Letters: what there is to choose from may itself be called by a number.
        for letter, each in zip("abcdef", extraction.alternatives, strict=False):
            said = f"{each.answer}: {each.english}" if each.answer else each.english
            click.echo(f"  {letter}  {said}", err=True)
        try:
            answer = click.prompt("", prompt_suffix="> ", default="", show_default=False, err=True)
        except click.Abort:
            answer = ""
        if not answer.strip():
            break
        turn = dialogue.say(answer)
        if turn.extraction.status is Status.REJECT:
            if turn.dialogue.asked is None:
                return turn.extraction
            click.echo(f"plainspoken: {turn.said}", err=True)
            continue
        dialogue, extraction = turn.dialogue, turn.extraction
    return extraction


def shown(extraction: Extraction, vocabulary: Vocabulary) -> Examples:
    """The examples of an accepted formula; none of what is still a question."""
    if extraction.formula is None:
        return Examples()
    return examples(extraction.formula, vocabulary.landmarks)


def vocabulary_of(domain: Path | None, problem: Path | None, landmarks: Path | None) -> Vocabulary:
    """The words for what the options name; a landmarks file alone is enough."""
    if landmarks is not None and domain is None and problem is None:
        return Vocabulary.of(read_landmarks(landmarks))
    found: Vocabulary = chosen_site(domain, problem, landmarks).vocabulary
    return found


def explained(extraction: Extraction, vocabulary: Vocabulary, console: Console) -> None:
    """Print every stage: the sentence marked, symbols, lifted and grounded formula, English."""
    console.print(Panel(marked(extraction), title="1  referring expressions", title_align="left"))
    if extraction.referring_expressions:
        table = Table("words", "symbol", "type", "score", box=None, padding=(0, 2))
        for each in extraction.referring_expressions:
            kind = vocabulary.landmarks[each.symbol].type
            table.add_row(f"“{each.text}”", each.symbol, kind, f"{each.score:.2f}")
        console.print(Panel(table, title="2  grounding", title_align="left"))
    if extraction.reading is None or extraction.status is not Status.OK:
        style = "yellow" if extraction.status is Status.CLARIFY else "red"
        title = "a question" if extraction.status is Status.CLARIFY else "refused"
        console.print(
            Panel(Text(no_formula(extraction)), title=title, title_align="left", style=style)
        )
        return
    formulas = Table.grid(padding=(0, 2))
    formulas.add_row("pattern", Text(extraction.pattern or ""))
    formulas.add_row("lifted", Text(extraction.lifted or ""))
    formulas.add_row("literal", Text(unparse(extraction.reading.literal)))
    formulas.add_row("executable", Text(unparse(extraction.reading.formula), style="bold"))
    console.print(Panel(formulas, title="3  formula", title_align="left"))
    said = Text(extraction.reading.english)
    by_example = shown(extraction, vocabulary).english
    if by_example:
        said.append(f"\n{by_example}", style="dim")
    if extraction.note:
        said.append(f"\n{extraction.note}", style="yellow")
    console.print(Panel(said, title="4  said back", title_align="left"))


def marked(extraction: Extraction) -> Text:
    """The utterance with its referring expressions underlined."""
    text = Text(extraction.utterance)
    for each in extraction.referring_expressions:
        text.stylize("bold underline", each.start, each.end)
    return text
