"""What a recogniser heard, and what becomes of it when it hears nothing, or does not end."""

import threading
from collections.abc import Sequence

import numpy as np
import pytest
from tests.language.harbour import HARBOUR
from tests.language.recordings import heard, tone

from plainspoken.language.emphasis import Weight
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.hint import MOST_HINTS, hints
from plainspoken.language.transcription import (
    HeardWord,
    Samples,
    SilentAudio,
    Transcript,
    TranscriptionTimeoutError,
    transcribed,
)
from plainspoken.world.landmark import Landmark, LandmarkType


def never(_: Samples, __: Sequence[str], /) -> Transcript:
    raise AssertionError("silence is not worth asking about")


def test_silence_is_not_handed_to_a_recogniser() -> None:
    for silent in (np.zeros(16_000, np.float32), np.zeros(0, np.float32)):
        with pytest.raises(SilentAudio):
            transcribed(silent, never)


@pytest.mark.parametrize("text", ["", "...", "— !"])
def test_a_recording_in_which_no_word_is_heard_is_silent(text: str) -> None:
    with pytest.raises(SilentAudio, match=r"1\.0 s"):
        transcribed(tone(440, 1), lambda *_: heard(text))


def test_a_recogniser_that_hangs_is_given_up_on() -> None:
    release = threading.Event()

    def hangs(_: Samples, __: Sequence[str], /) -> Transcript:
        release.wait()
        return heard("too late")

    try:
        with pytest.raises(TranscriptionTimeoutError):
            transcribed(tone(440, 1), hangs, patience=0.1)
    finally:
        release.set()


def test_the_error_of_a_recogniser_is_not_lost() -> None:
    def breaks(_: Samples, __: Sequence[str], /) -> Transcript:
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        transcribed(tone(440, 1), breaks)


def test_a_transcript_marks_what_weighs_and_what_was_unclear_where_it_stands() -> None:
    words = (
        HeardWord("Never", 0, 0.4, 0.3),
        HeardWord("enter", 0.4, 0.8, 0.9),
        HeardWord("lane", 0.8, 1.2, 0.4),
        HeardWord("3.", 1.2, 1.5, 0.99),
    )
    said = Transcript(words, 2.0)
    assert said.text == "Never enter lane 3."
    assert [(said.text[e.start : e.end], e.weight) for e in said.emphases] == [
        ("Never", Weight.NEGATION),
        ("Never", Weight.UNCLEAR),
        ("lane", Weight.UNCLEAR),
        ("3", Weight.NUMBER),
    ]
    assert said.to_json()["words"][0] == {
        "text": "Never",
        "start": 0,
        "end": 0.4,
        "confidence": 0.3,
    }


def test_hints_are_the_words_of_the_domain_and_no_general_ones() -> None:
    assert hints(HARBOUR) == ("quay", "dock", "tower", "tank", "full", "refuel")


def test_of_many_numbered_places_two_stand_for_all() -> None:
    named = (Landmark(f"at_{i}", f"site {i}", LandmarkType.LOCATION) for i in range(300))
    other = (Landmark(f"s_{w}", f"the {w} is open", LandmarkType.CONDITION) for w in WORDS)
    found = hints(Vocabulary.of({each.id: each for each in (*named, *other)}))
    assert found[:2] == ("site 0", "site 1")
    assert found[2] == "aaa"
    assert len(found) == MOST_HINTS


WORDS = [a + b + c for a in "abcdef" for b in "abcdef" for c in "abc"]
