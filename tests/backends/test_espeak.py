"""The voice of espeak-ng: what it says can be listened to, and what is missing is named."""

import shutil
from pathlib import Path

import numpy as np
import pytest

from plainspoken.backends.espeak import PROGRAM, Espeak
from plainspoken.language.recording import read_wav
from plainspoken.language.speaking import MOST_CHARACTERS, SpeechError, sayable

with_a_voice = pytest.mark.skipif(
    shutil.which(PROGRAM) is None, reason=f"needs {PROGRAM}: install the package of that name"
)


@with_a_voice
def test_what_it_says_is_a_recording_that_we_read() -> None:
    short, long = (
        read_wav(Espeak().recorded(text)) for text in ("Stop.", "Go to line 2, then come back.")
    )
    assert 0.2 * 16_000 < len(short) < len(long) < 6 * 16_000
    assert np.abs(long).max() > 0.1


@with_a_voice
def test_a_text_is_said_and_never_taken_for_options_or_markup() -> None:
    assert (
        read_wav(Espeak().recorded("--version -f nothing <break time='60s'/>")).size < 20 * 16_000
    )


@with_a_voice
def test_a_voice_that_is_not_there_is_an_error() -> None:
    with pytest.raises(SpeechError, match="voice"):
        Espeak("nowhere").recorded("hello")


def test_without_the_program_the_error_tells_how_to_get_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(SpeechError, match="not installed") as missing:
        Espeak().say("hello")
    assert "apt install espeak-ng" in str(missing.value)


def test_a_voice_that_hangs_is_given_up_on(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    program = tmp_path / PROGRAM
    program.write_text("#!/bin/sh\nexec sleep 600\n")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    with pytest.raises(SpeechError, match="does not run"):
        Espeak(patience=0.2).say("hello")


def test_a_text_is_said_without_control_characters_and_not_without_end() -> None:
    assert sayable("line\x1b[31m 2\n\tnow\x00") == "line [31m 2 now"
    assert len(sayable("never " * 10_000)) <= MOST_CHARACTERS + 4
