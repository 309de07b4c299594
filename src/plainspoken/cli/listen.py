"""`plainspoken listen`: a recording to text, shown and confirmed, and then what is made of it."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.console import Console
from rich.panel import Panel
from rich.text import Text

from plainspoken.cli.exit import NO
from plainspoken.cli.extract import answered, explained, vocabulary_of
from plainspoken.cli.site import FILE, site_options
from plainspoken.cli.translator import chosen_translator, translator_options
from plainspoken.errors import InputFileError, PlainspokenError
from plainspoken.language.dialogue import Dialogue
from plainspoken.language.emphasis import Emphasis, Weight, emphases
from plainspoken.language.extraction import Extraction, Status
from plainspoken.language.grounding import Vocabulary

if TYPE_CHECKING:
    from plainspoken.language.transcription import Transcript

STYLES = {
    Weight.NEGATION: "bold reverse red",
    Weight.LIMIT: "bold magenta",
    Weight.NUMBER: "bold cyan",
    Weight.UNCLEAR: "underline yellow",
}
SIGNS = {Weight.NEGATION: "!!", Weight.LIMIT: "**", Weight.NUMBER: "##", Weight.UNCLEAR: "??"}
"""Without colours, a word stands between these."""


@click.command()
@click.argument("recording", type=FILE)
@site_options
@translator_options
@click.option(
    "--whisper",
    type=FILE,
    metavar="FOLDER",
    envvar="PLAINSPOKEN_WHISPER",
    show_envvar=True,
    help="Weights of Whisper for CTranslate2 (default: those that a package holds).",
)
@click.option("--no-hints", is_flag=True, help="Do not tell the recogniser the domain's words.")
@click.option("--yes", is_flag=True, help="Take what was heard as it is, without asking.")
@click.option("--json", "as_json", is_flag=True, help="Print JSON; with --yes the formula, too.")
def listen(
    *,
    recording: Path,
    domain: Path | None,
    problem: Path | None,
    landmarks: Path | None,
    whisper: Path | None,
    no_hints: bool,
    yes: bool,
    as_json: bool,
) -> None:
    """Turn what is said in RECORDING (WAV) into text, and that into a formula.

    What was heard is shown first, with the words that turn its meaning marked: negations, limits
    ("until", "only") and numbers, and what was unclear. At a terminal it is confirmed, or
    corrected, before anything is made of it; elsewhere nothing is, unless --yes is given (exit
    status 3).

    \b
    plainspoken listen order.wav
    plainspoken listen order.wav --landmarks L.json --yes --json
    """
    vocabulary = vocabulary_of(domain, problem, landmarks)
    heard = _heard(recording, whisper, None if no_hints else vocabulary)
    asks = at_a_terminal() and not (yes or as_json)
    if not as_json:
        console = Console(stderr=True)
        console.print(Panel(shown(heard.text, heard.emphases, console), title="heard"))
    if not (yes or asks):
        if as_json:
            click.echo(json.dumps({"transcript": heard.to_json()}, indent=2, ensure_ascii=False))
            return
        click.echo("plainspoken: not confirmed, so nothing is made of it: give --yes", err=True)
        sys.exit(NO)
    sentence = confirmed(heard.text, heard.emphases) if asks else heard.text
    with chosen_translator() as translate:
        extraction = translate(sentence, vocabulary)
        if asks:
            extraction = answered(Dialogue(vocabulary, translate=translate), extraction)
    _print(heard, extraction, vocabulary, as_json=as_json)
    if extraction.status is Status.REJECT:
        sys.exit(NO)


def at_a_terminal() -> bool:
    """Whether there is somebody to confirm what was heard."""
    return sys.stdin.isatty()


def shown(text: str, marks: tuple[Emphasis, ...], console: Console) -> Text:
    """A text with its emphases in colours, or between signs where there are none."""
    if console.color_system is None:
        # From the end, so that places keep; of two marks at one place the weightier is outside.
        order = list(Weight)
        for each in sorted(marks, key=lambda mark: (-mark.start, -order.index(mark.weight))):
            sign, word = SIGNS[each.weight], text[each.start : each.end]
            text = f"{text[: each.start]}{sign}{word}{sign}{text[each.end :]}"
        return Text(text)
    coloured = Text(text)
    for each in marks:
        coloured.stylize(STYLES[each.weight], each.start, each.end)
    return coloured


def confirmed(text: str, marks: tuple[Emphasis, ...]) -> str:
    """The text as the person at the terminal says it should be, shown anew after each change.

    raises Abort: when they say no more
    """
    doubtful = [text[each.start : each.end] for each in marks if each.weight is Weight.UNCLEAR]
    if doubtful:
        asked = " ".join(f"“{word}”" for word in doubtful)
        click.echo(f"plainspoken: not sure of {asked}: is that what you said?", err=True)
    while True:
        said = click.prompt(
            "Enter to accept, or type what you said", default=text, show_default=False, err=True
        )
        sentence = " ".join(str(said).split())
        if not sentence or sentence == text:
            return text
        text = sentence
        console = Console(stderr=True)
        console.print(Panel(shown(text, emphases(text), console), title="you said"))


def _heard(recording: Path, whisper: Path | None, vocabulary: Vocabulary | None) -> Transcript:
    from plainspoken.backends.whisper import Whisper
    from plainspoken.language.hint import hints
    from plainspoken.language.recording import MOST_BYTES, UnreadableRecordingError, read_wav
    from plainspoken.language.transcription import transcribed

    try:
        # Not a byte more than it takes to see that it is too much: the file may be a device.
        with recording.open("rb") as file:
            samples = read_wav(file.read(MOST_BYTES + 1))
    except OSError as error:
        raise InputFileError(
            f"cannot read the file: {error.strerror}", recording, hint="check the path"
        ) from error
    except UnreadableRecordingError as error:
        error.where = str(recording)
        raise
    words = () if vocabulary is None else hints(vocabulary)
    try:
        return transcribed(samples, Whisper(whisper), words)
    except PlainspokenError as error:
        error.where = error.where or str(recording)
        raise


def _print(
    heard: Transcript, extraction: Extraction, vocabulary: Vocabulary, *, as_json: bool
) -> None:
    if as_json:
        document = {"transcript": heard.to_json(), "extraction": extraction.to_json()}
        click.echo(json.dumps(document, indent=2, ensure_ascii=False))
    else:
        explained(extraction, vocabulary, Console())
