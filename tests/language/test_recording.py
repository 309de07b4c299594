"""Recordings: what is read, what is refused, and that nothing a stranger sends does harm."""

import struct
import wave
from io import BytesIO

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.language.recordings import pcm16, tone, wav

from plainspoken.language.recording import (
    MOST_BYTES,
    MOST_SECONDS,
    TooLongError,
    UnreadableRecordingError,
    read_upload,
    read_wav,
    resampled,
)


def test_what_the_standard_library_writes_is_read_as_it_is() -> None:
    samples = tone(440, 0.5)
    file = BytesIO()
    with wave.open(file, "wb") as written:
        written.setnchannels(1)
        written.setsampwidth(2)
        written.setframerate(16_000)
        written.writeframes(pcm16(samples))
    found = read_wav(file.getvalue())
    assert found.dtype == np.float32
    assert np.abs(found - samples).max() < 1e-4


@pytest.mark.parametrize(
    ("bits", "code", "encode"),
    [
        (8, 1, lambda x: (x * 127 + 128).astype("u1").tobytes()),
        (16, 1, pcm16),
        (
            24,
            1,
            lambda x: b"".join(struct.pack("<i", int(v * (2**23 - 1)))[:3] for v in x),
        ),
        (32, 1, lambda x: (x.astype(float) * (2**31 - 1)).astype("<i4").tobytes()),
        (32, 3, lambda x: x.astype("<f4").tobytes()),
    ],
)
def test_every_width_says_the_same(bits: int, code: int, encode: object) -> None:
    assert callable(encode)
    samples = tone(440, 0.1)
    found = read_wav(wav(encode(samples), bits=bits, code=code))
    assert np.abs(found - samples).max() < 0.02


def test_two_channels_are_mixed_to_one() -> None:
    left = tone(440, 0.1)
    both = np.stack([left, -left], axis=1)
    assert np.abs(read_wav(wav(pcm16(both), channels=2))).max() < 1e-3


@pytest.mark.parametrize("rate", [8_000, 11_025, 22_050, 44_100, 48_000, 96_000])
def test_a_tone_keeps_its_pitch_its_loudness_and_its_length_at_every_rate(rate: int) -> None:
    found = read_wav(wav(pcm16(tone(1_000, 1, rate)), rate=rate))
    assert abs(len(found) - 16_000) <= 1
    inside = slice(1_000, 15_000)  # a tone that begins at once has edges
    assert np.abs(found - tone(1_000, 1)[: len(found)])[inside].max() < 0.02


def test_what_is_too_high_for_speech_is_left_out_and_not_folded_down() -> None:
    found = resampled(tone(15_000, 1, 48_000).astype(float), 48_000)
    assert np.abs(found[1_000:-1_000]).max() < 0.01


@pytest.mark.parametrize("size", [0, 0xFFFFFFFF, 0x7FFFF000])
def test_a_length_that_a_program_wrote_to_a_pipe_is_passed_over(size: int) -> None:
    samples = tone(440, 0.1)
    assert len(read_wav(wav(pcm16(samples), size=size))) == len(samples)


@pytest.mark.parametrize(
    ("content", "what"),
    [
        (b"", "empty"),
        (b"hello", "not a WAV"),
        (b"\x1aE\xdf\xa3" + bytes(40), "this is WebM"),
        (b"OggS" + bytes(40), "this is Ogg"),
        (b"RIFF\0\0\0\0WAVE", "cut off"),
        (b"RIFF\0\0\0\0WAVEdata\0\0\0\0", "before their format"),
        (b"RIFF\0\0\0\0WAVEfmt \2\0\0\0\1\0", "format"),
        (wav(b""), "no samples"),
        (wav(b"\0\0", channels=0), "0 channels"),
        (wav(b"\0" * 40, channels=9), "9 channels"),
        (wav(b"\0\0", rate=0), "0 Hz"),
        (wav(b"\0\0", rate=4_000_000_000), "Hz is not read"),
        (wav(b"\0\0", bits=0), "0 bits"),
        (wav(b"\0\0", code=85), "format 85"),
        (wav(struct.pack("<f", float("nan")), code=3, bits=32), "not numbers"),
        (wav(struct.pack("<f", float("inf")), code=3, bits=32), "not numbers"),
    ],
)
def test_what_is_no_recording_is_refused_with_the_reason_and_a_way_out(
    content: bytes, what: str
) -> None:
    with pytest.raises(UnreadableRecordingError, match=what) as refused:
        read_wav(content)
    assert refused.value.hint


def test_what_is_longer_than_a_sentence_is_refused_by_bytes_and_by_seconds() -> None:
    with pytest.raises(TooLongError, match="bytes"):
        read_wav(bytes(MOST_BYTES + 1))
    with pytest.raises(TooLongError, match="61 s"):
        read_wav(wav(bytes((MOST_SECONDS + 1) * 8_000), bits=8, rate=8_000))
    assert len(read_wav(wav(bytes(MOST_SECONDS * 8_000), bits=8, rate=8_000)))


@pytest.mark.parametrize("called", ["audio/webm;codecs=opus", "text/html", "", "x" * 10_000])
def test_an_upload_of_another_type_is_refused_whatever_it_holds(called: str) -> None:
    with pytest.raises(UnreadableRecordingError, match="is not read") as refused:
        read_upload(wav(pcm16(tone(440, 0.1))), called)
    assert len(str(refused.value)) < 400


def test_an_upload_may_have_parameters_and_capitals_in_its_type() -> None:
    assert len(read_upload(wav(pcm16(tone(440, 0.1))), "Audio/WAV; rate=16000")) == 1_600


HEADERS = st.builds(
    wav,
    st.binary(max_size=400),
    code=st.integers(0, 0xFFFF) | st.sampled_from([1, 3, 0xFFFE]),
    channels=st.integers(0, 0xFFFF) | st.integers(0, 9),
    rate=st.integers(0, 60_000) | st.sampled_from([8_000, 16_000, 44_100]),
    bits=st.sampled_from([0, 1, 8, 16, 24, 32, 64]),
    size=st.integers(0, 0xFFFFFFFF) | st.none(),
)


@st.composite
def spoilt(draw: st.DrawFn) -> bytes:
    """A WAV file of which some bytes are others, or its end is missing."""
    content = bytearray(draw(HEADERS))
    for place in draw(st.lists(st.integers(0, len(content) - 1), max_size=8)):
        content[place] = draw(st.integers(0, 255))
    return bytes(content[: draw(st.integers(0, len(content)))])


@settings(max_examples=400, deadline=None)
@given(st.binary(max_size=400) | HEADERS | spoilt())
def test_whatever_is_sent_becomes_samples_or_a_refusal(content: bytes) -> None:
    try:
        found = read_wav(content)
    except UnreadableRecordingError:
        return
    assert len(found)
    assert np.isfinite(found).all()
    assert np.abs(found).max() <= 1
