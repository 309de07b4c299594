"""What a voice is to us: a text in, and it is said, or there is a recording of it."""

from __future__ import annotations

from typing import Protocol

from plainspoken.errors import PlainspokenError

MOST_CHARACTERS = 2_000
"""Of one text: some two minutes of speech."""


class Speaker(Protocol):
    """Says texts.

    raises SpeechError: when it cannot
    """

    def say(self, text: str, /) -> None:
        """Say it aloud, and return when that is done."""
        ...

    def recorded(self, text: str, /) -> bytes:
        """The same as a WAV file."""
        ...


class SpeechError(PlainspokenError):
    """A text was not said: there is no voice, or it broke down."""


def sayable(text: str) -> str:
    """A text as a voice can say it: no control characters, not without end."""
    plain = " ".join("".join(c if c.isprintable() else " " for c in text).split())
    return plain if len(plain) <= MOST_CHARACTERS else plain[:MOST_CHARACTERS] + " ..."
