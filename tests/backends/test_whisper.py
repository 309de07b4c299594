"""Whisper itself, on sentences that espeak-ng says; and what is told where it is missing."""

import shutil
import threading
from contextlib import suppress
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest
from tests.language.harbour import HARBOUR

from plainspoken.backends import whisper
from plainspoken.backends.espeak import PROGRAM, Espeak
from plainspoken.backends.whisper import PARTS, Whisper, prompt, was_sayable, weights_in
from plainspoken.language.hint import hints
from plainspoken.language.recording import MOST_SECONDS, read_wav
from plainspoken.language.transcription import (
    Samples,
    SilentAudio,
    TranscriptionError,
    transcribed,
)

missing = [name for name in ("faster_whisper", *PARTS) if find_spec(name) is None]
with_whisper = pytest.mark.skipif(bool(missing), reason=f"needs {', '.join(missing)}: make speech")
with_a_voice = pytest.mark.skipif(
    shutil.which(PROGRAM) is None, reason=f"needs {PROGRAM}: install the package of that name"
)


@pytest.fixture(scope="module")
def model() -> Whisper:
    return Whisper()


def spoken(text: str) -> Samples:
    return read_wav(Espeak("en-us", 150).recorded(text))


@with_whisper
@with_a_voice
@pytest.mark.timeout(600)
def test_a_sentence_is_heard_the_same_each_time_with_times_and_confidence(model: Whisper) -> None:
    samples = spoken("Go to the dock, but never visit the tower.")
    found = transcribed(samples, model, hints(HARBOUR))
    said = found.text.lower()
    assert "dock" in said
    assert "never" in said
    assert "tower" in said
    assert found == transcribed(samples, model, hints(HARBOUR))
    ends = [word.end for word in found.words]
    assert ends == sorted(ends)
    assert ends[-1] <= found.seconds + 0.5
    assert all(0 <= word.confidence <= 1 for word in found.words)


@with_whisper
@pytest.mark.timeout(600)
@pytest.mark.parametrize("loudness", [0.003, 0.1, 1.0])
def test_nothing_is_made_up_where_nobody_speaks(model: Whisper, loudness: float) -> None:
    noise = np.random.default_rng(7).standard_normal(5 * 16_000) * loudness / 4
    with pytest.raises(SilentAudio):
        transcribed(np.clip(noise, -1, 1).astype(np.float32), model, hints(HARBOUR))


@with_whisper
@pytest.mark.timeout(900)
def test_the_longest_recording_of_a_stranger_ends(model: Whisper) -> None:
    wave = np.sign(np.sin(np.arange(MOST_SECONDS * 16_000) / 20)).astype(np.float32)
    with suppress(SilentAudio):
        transcribed(wave, model, ["\x00", "<|endoftext|>", "é" * 1_000] * 20, patience=600)


@with_whisper
@with_a_voice
@pytest.mark.timeout(600)
def test_two_who_speak_at_once_are_both_heard(model: Whisper) -> None:
    said = [spoken("Visit the dock."), spoken("Never visit the tower.")]
    found: dict[int, str] = {}

    def listen(number: int) -> None:
        found[number] = transcribed(said[number], model, hints(HARBOUR), patience=500).text.lower()

    threads = [threading.Thread(target=listen, args=(number,)) for number in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert "dock" in found[0]
    assert "tower" in found[1]


def test_without_the_program_or_the_weights_the_error_tells_how_to_get_them(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(whisper, "find_spec", lambda _: None)
    with pytest.raises(TranscriptionError, match="not installed") as without:
        Whisper()
    assert "plainspoken[speech]" in str(without.value)
    assert whisper.packaged_weights() == ()


def test_a_folder_must_hold_all_that_would_otherwise_be_downloaded(tmp_path: Path) -> None:
    for name in ("model.bin", "config.json", "vocabulary.txt"):
        (tmp_path / name).write_bytes(b"")
    with pytest.raises(TranscriptionError, match=r"tokenizer\.json missing"):
        weights_in(tmp_path)
    (tmp_path / "tokenizer.json").write_bytes(b"")
    assert weights_in(tmp_path) == tmp_path


@with_whisper
def test_weights_that_are_none_are_an_error_of_ours(tmp_path: Path) -> None:
    for name in ("model.bin", "config.json", "vocabulary.txt", "tokenizer.json"):
        (tmp_path / name).write_bytes(b"nonsense")
    with pytest.raises(TranscriptionError, match="do not load"):
        Whisper(tmp_path)


def test_the_prompt_is_a_sentence_with_the_words_of_the_domain() -> None:
    said = prompt(["quay", "dock"])
    assert said is not None
    assert said.endswith("quay, dock.")
    assert prompt([]) is None


def test_a_piece_that_nobody_can_have_said_so_fast_is_told_from_quick_speech() -> None:
    assert not was_sayable(57, 0.6), "I'm sorry, I'm sorry, I'm sorry, ..."
    assert was_sayable(17, 3.5)
    assert was_sayable(1, 0.0), "the times of one word are rough"
