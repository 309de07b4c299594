"""A recording as samples: WAV files, of whatever rate and width, within limits.

WAV alone, since what else browsers record (Opus in WebM or MP4) needs a decoder of tens of
megabytes that would be fed by strangers; a page can hand over plain samples as easily.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from math import gcd

import numpy as np
import numpy.typing as npt

from plainspoken.errors import PlainspokenError
from plainspoken.language.transcription import SAMPLE_RATE, Samples

MOST_SECONDS = 60
MOST_BYTES = 12_000_000
"""A minute at 48 kHz in two channels of 16 bits, with something to spare."""
CONTENT_TYPES = frozenset(("audio/wav", "audio/x-wav", "audio/wave", "audio/vnd.wave"))
_RATES = range(8_000, 96_001)
_CHANNELS = range(1, 9)
_PCM, _FLOAT, _EXTENSIBLE = 1, 3, 0xFFFE
GET_WAV = "record or convert it as 16-bit mono WAV: ffmpeg -i IN -ac 1 -ar 16000 OUT.wav"
_OTHERS = {
    b"\x1aE\xdf\xa3": "WebM", b"OggS": "Ogg", b"ID3": "MP3", b"\xff\xfb": "MP3", b"fLaC": "FLAC",
    b"FORM": "AIFF", b"RF64": "RF64", b"caff": "CAF",
}  # fmt: skip


class UnreadableRecordingError(PlainspokenError):
    """What should be a recording is not one that we read."""

    def __init__(self, what: str, *, hint: str = GET_WAV) -> None:
        super().__init__(what, hint=hint)


class TooLongError(UnreadableRecordingError):
    """A recording is longer, or a file larger, than one sentence can be."""

    def __init__(self, what: str) -> None:
        super().__init__(what, hint=f"say one request at a time, in less than {MOST_SECONDS} s")


@dataclass(frozen=True, slots=True)
class _Format:
    code: int
    channels: int
    rate: int
    bits: int


def read_upload(content: bytes, content_type: str) -> Samples:
    """The samples of what a page or a program sent; its word for what it is has to be right, too.

    raises UnreadableRecordingError: as `read_wav`, and when it is called something else
    """
    called = content_type.partition(";")[0].strip().lower()
    if called not in CONTENT_TYPES:
        raise UnreadableRecordingError(
            f"a recording of type {called[:60]!r} is not read", hint=f"send audio/wav: {GET_WAV}"
        )
    return read_wav(content)


def read_wav(content: bytes) -> Samples:
    """The samples of a WAV file: mixed to one channel, at SAMPLE_RATE.

    A length that is wrong, as programs leave it that write to a pipe, is passed over.
    raises UnreadableRecordingError: when it is no WAV file that we read
    raises TooLongError: past MOST_BYTES or MOST_SECONDS
    """
    if len(content) > MOST_BYTES:
        raise TooLongError(
            f"the recording has {len(content):,} bytes, and {MOST_BYTES:,} are the most"
        )
    if content[:4] != b"RIFF" or content[8:12] != b"WAVE":
        kind = next((name for head, name in _OTHERS.items() if content.startswith(head)), None)
        said = f"this is {kind}, not WAV" if kind else "this is not a WAV file"
        raise UnreadableRecordingError(said if content else "the recording is empty")
    form, body = _chunks(content)
    frame = form.channels * (form.bits // 8)
    body = body[: len(body) - len(body) % frame]
    frames = len(body) // frame
    if not frames:
        raise UnreadableRecordingError("the WAV file has no samples")
    if frames > MOST_SECONDS * form.rate:
        raise TooLongError(
            f"the recording takes {frames / form.rate:.0f} s, and {MOST_SECONDS} are the most"
        )
    values = _values(body, form)
    if not np.isfinite(values).all():
        raise UnreadableRecordingError("the WAV file has samples that are not numbers")
    mixed = np.clip(values, -1, 1).reshape(frames, form.channels).mean(axis=1)
    heard = resampled(mixed, form.rate)
    return np.clip(heard, -1, 1).astype(np.float32)


def resampled(values: npt.NDArray[np.float64], rate: int) -> npt.NDArray[np.float64]:
    """The same sound at SAMPLE_RATE; what is too high for that rate is left out."""
    if rate == SAMPLE_RATE or not len(values):
        return values
    # Cut off in the spectrum: exact for whatever two rates, and a minute takes well under a second.
    step = rate // gcd(rate, SAMPLE_RATE)
    length = -(-len(values) // step) * step
    wanted = length * SAMPLE_RATE // rate
    spectrum = np.fft.rfft(values, length)[: wanted // 2 + 1]
    sound = np.fft.irfft(spectrum, wanted) * (wanted / length)
    return sound[: max(1, round(len(values) * SAMPLE_RATE / rate))]


def _chunks(content: bytes) -> tuple[_Format, bytes]:
    """The format and the samples of a WAV file, whatever else stands in it."""
    place, form = 12, None
    while place + 8 <= len(content):
        name = content[place : place + 4]
        size = int.from_bytes(content[place + 4 : place + 8], "little")
        place += 8
        if name == b"data":
            if form is None:
                raise UnreadableRecordingError("the WAV file has samples before their format")
            return form, content[place : place + size] if size else content[place:]
        if name == b"fmt ":
            form = _format(content[place : place + size])
        place += size + size % 2
    raise UnreadableRecordingError("the WAV file is cut off before its samples")


def _format(chunk: bytes) -> _Format:
    if len(chunk) < 16:
        raise UnreadableRecordingError("the WAV file does not tell its format")
    code, channels, rate, _, _, bits = struct.unpack("<HHIIHH", chunk[:16])
    if code == _EXTENSIBLE and len(chunk) >= 26:
        code = int.from_bytes(chunk[24:26], "little")
    if (code, bits) not in ((_PCM, 8), (_PCM, 16), (_PCM, 24), (_PCM, 32), (_FLOAT, 32)):
        raise UnreadableRecordingError(f"WAV of format {code} with {bits} bits is not read")
    if channels not in _CHANNELS or rate not in _RATES:
        raise UnreadableRecordingError(f"WAV with {channels} channels at {rate} Hz is not read")
    return _Format(code, channels, rate, bits)


def _values(body: bytes, form: _Format) -> npt.NDArray[np.float64]:
    """Samples as numbers in [-1, 1], channel beside channel."""
    if form.code == _FLOAT:
        return np.frombuffer(body, "<f4").astype(np.float64)
    if form.bits == 8:
        return (np.frombuffer(body, "u1").astype(np.float64) - 128) / 128
    if form.bits == 24:
        three = np.frombuffer(body, "u1").reshape(-1, 3).astype(np.int32)
        whole = (three[:, 0] << 8 | three[:, 1] << 16 | three[:, 2] << 24) >> 8
        return whole / float(1 << 23)
    return np.frombuffer(body, f"<i{form.bits // 8}") / float(1 << (form.bits - 1))
