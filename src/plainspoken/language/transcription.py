"""What a speech recogniser is to us: samples and words of the domain in, words with times out.

A recogniser is anything that can be called so; a fake is a function. What it heard is shown to the
person before it is acted on: see `emphasis`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from plainspoken.errors import PlainspokenError
from plainspoken.language.emphasis import Emphasis, Weight, emphases
from plainspoken.language.patience import Seconds, waited_for

Samples = npt.NDArray[np.float32]
"""Shape (n,), in [-1, 1], mono, at SAMPLE_RATE."""
SAMPLE_RATE = 16_000
PATIENCE: Seconds = 120.0
"""How long a recogniser may take over one recording, unless told otherwise."""
UNCLEAR = 0.5
"""A word with less confidence than this is marked."""
QUIET = 1e-3
"""The loudest sample of a recording in which nothing was said: -60 dB."""


@dataclass(frozen=True, slots=True)
class HeardWord:
    """One word as it was heard. start and end: seconds; confidence: 0 to 1."""

    text: str
    start: Seconds
    end: Seconds
    confidence: float


@dataclass(frozen=True, slots=True)
class Transcript:
    """What was heard in a recording.

    words:   with their punctuation
    seconds: of the recording
    """

    words: tuple[HeardWord, ...]
    seconds: Seconds

    @property
    def text(self) -> str:
        return " ".join(word.text for word in self.words)

    @property
    def emphases(self) -> tuple[Emphasis, ...]:
        """What deserves a second look before the text is acted on, in its order.

        A word that is both weighty and unclear is there twice, with the same place.
        """
        found = list(emphases(self.text))
        start = 0
        for word in self.words:
            end = start + len(word.text)
            if word.confidence < UNCLEAR:
                found.append(Emphasis(start, end, Weight.UNCLEAR))
            start = end + 1
        return tuple(sorted(found, key=lambda each: (each.start, each.end)))

    def to_json(self) -> dict[str, Any]:
        """For programs: the text, each word, and the places to look at again."""
        return {
            "text": self.text,
            "seconds": round(self.seconds, 3),
            "words": [
                {
                    "text": word.text,
                    "start": round(word.start, 3),
                    "end": round(word.end, 3),
                    "confidence": round(word.confidence, 3),
                }
                for word in self.words
            ],
            "emphases": [each.to_json() for each in self.emphases],
        }


class Transcriber(Protocol):
    """Hears what is said in a recording, the same each time.

    samples: see Samples
    hints:   words of the domain, most telling first; they may be heard where nothing else fits
    returns  no words where nobody speaks
    raises TranscriptionError: when it breaks down
    """

    def __call__(self, samples: Samples, hints: Sequence[str], /) -> Transcript: ...


class TranscriptionError(PlainspokenError):
    """A recording was not turned into text: the recogniser is missing, or broke down."""


class TranscriptionTimeoutError(TranscriptionError):
    """A recogniser did not finish in time."""

    def __init__(self, seconds: Seconds) -> None:
        self.seconds = seconds
        super().__init__(
            f"the recording was not understood within {seconds:g} s",
            hint="say it in fewer words, or type it",
        )


class SilentAudio(PlainspokenError):
    """There is no speech in a recording."""

    def __init__(self, seconds: Seconds) -> None:
        self.seconds = seconds
        super().__init__(
            f"no speech was heard in {seconds:.1f} s of recording",
            hint="check that the right microphone is chosen and not muted, and speak up",
        )


def transcribed(
    samples: Samples, model: Transcriber, hints: Sequence[str] = (), patience: Seconds = PATIENCE
) -> Transcript:
    """What is said in a recording.

    raises SilentAudio: when nothing is
    raises TranscriptionError: when the recogniser breaks down or takes too long
    """
    seconds = len(samples) / SAMPLE_RATE
    if not len(samples) or float(np.abs(samples).max()) < QUIET:
        raise SilentAudio(seconds)
    late = TranscriptionTimeoutError(patience)
    heard = waited_for(lambda: model(samples, hints), patience, late)
    if not any(character.isalnum() for character in heard.text):
        raise SilentAudio(seconds)
    return heard
