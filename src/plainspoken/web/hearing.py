"""Turning what somebody says on the page into text, for all who speak here: one set of weights."""

from __future__ import annotations

import threading
from collections.abc import Callable
from pathlib import Path

from plainspoken.backends import whisper
from plainspoken.language.transcription import Transcriber, Transcript, TranscriptionError
from plainspoken.pipeline import Site, transcribe_upload
from plainspoken.web.rate import Rate, Seats

RECORDINGS = Rate("recordings", 0.2, 6)
PATIENCE = 60.0
"""Seconds that whoever has spoken waits for the text."""
MOST_BYTES = 2 * 1024 * 1024
"""A minute at 16 kHz in one channel of 16 bits, as the page records it, with something to spare."""


class Hearing:
    """A recogniser that is loaded when somebody first speaks, and kept.

    missing: what there is to do before anybody can be heard; None where all is there
    """

    def __init__(self, load: Callable[[], Transcriber], missing: str | None = None) -> None:
        self.missing = missing
        self._load = load
        self._lock = threading.Lock()
        self._recogniser: Transcriber | None = None
        self._seats = Seats("recordings", total=4, each=1)

    def hear(self, content: bytes, content_type: str, site: Site, who: str) -> Transcript:
        """What somebody says in a recording; takes seconds.

        raises TranscriptionError: when nobody can be heard here, or not in time
        raises UnreadableRecordingError: when it is no recording that we read
        raises SilentAudio: when nobody speaks in it
        raises TooManyError: when they, or too many others, are being heard already
        """
        if self.missing is not None:
            raise TranscriptionError("speech is not understood on this server", hint=self.missing)
        with self._seats.seat(who):
            recogniser = self._loaded()
            return transcribe_upload(content, content_type, site, recogniser, patience=PATIENCE)

    def _loaded(self) -> Transcriber:
        with self._lock:
            if self._recogniser is None:
                self._recogniser = self._load()
            return self._recogniser


def whisper_hearing(folder: Path | None = None) -> Hearing:
    """Hearing by Whisper, with the weights of a folder, or those of its packages."""
    missing = None
    if not whisper.is_installed():
        missing = f"to speak to it: {whisper.GET_IT}, and {whisper.GET_WEIGHTS}"
    elif folder is None and not whisper.packaged_weights():
        missing = f"to speak to it: {whisper.GET_WEIGHTS}"
    return Hearing(lambda: whisper.Whisper(folder), missing)
