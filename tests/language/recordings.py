"""Sounds to listen to, and WAV files of them."""

import struct

import numpy as np

from plainspoken.language.transcription import HeardWord, Samples, Transcript


def tone(hertz: float, seconds: float, rate: int = 16_000) -> Samples:
    time = np.arange(round(seconds * rate)) / rate
    return (0.5 * np.sin(2 * np.pi * hertz * time)).astype(np.float32)


def wav(
    body: bytes,
    *,
    code: int = 1,
    channels: int = 1,
    rate: int = 16_000,
    bits: int = 16,
    size: int | None = None,
) -> bytes:
    """A WAV file; size: what it says of its samples, where that is not the truth."""
    frame = channels * bits // 8
    form = struct.pack(
        "<HHIIHH", code, channels, rate, rate * frame & 0xFFFFFFFF, frame & 0xFFFF, bits
    )
    told = len(body) if size is None else size
    return (
        b"RIFF" + struct.pack("<I", (36 + told) & 0xFFFFFFFF) + b"WAVE"
        + b"fmt " + struct.pack("<I", len(form)) + form
        + b"data" + struct.pack("<I", told) + body
    )  # fmt: skip


def pcm16(samples: Samples) -> bytes:
    return (np.asarray(samples) * 32767).astype("<i2").tobytes()


def heard(text: str, confidence: float = 0.9) -> Transcript:
    said = text.split()
    words = (HeardWord(each, i / 2, i / 2 + 0.4, confidence) for i, each in enumerate(said))
    return Transcript(tuple(words), len(said) / 2)
