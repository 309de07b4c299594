"""What kind a question is of, by what has been learned from questions that people wrote.

A linear model over runs of words: each run of up to four words adds to the score of each kind,
with the words of the mission by the parts they play (`spoken`). It knows no grammar, and so it
goes wrong elsewhere than the rules do. `python -m training.questions` fits it.

Source: Joachims, Text Categorization with Support Vector Machines, 1998 (linear models over words);
Weinberger et al., Feature Hashing for Large Scale Multitask Learning, 2009 (the table).
"""

from __future__ import annotations

import zlib
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from importlib.resources import as_file, files
from itertools import combinations

import numpy as np
import numpy.typing as npt

from plainspoken.questions.grammar import Shape
from plainspoken.questions.kind import Kind
from plainspoken.questions.spoken import Role, Spoken

KINDS = tuple(Kind)
ROWS = 1 << 15
"""Of the table; two runs of words that share a row are taken for one."""
LONGEST_RUN = 4
_SUBJECTS = frozenset({"you", "i", "we", "it", "they", "robot", "everything", "that", "this", ""})
_PAUSES = frozenset(".,;:-–—")
_ENDS = frozenset("?!")
_BEGIN, _END = "^", "$"


class Listener:
    """The table of weights: a row for runs of words, a column for each kind."""

    def __init__(self, weights: npt.NDArray[np.float32]) -> None:
        self._weights = weights

    def hear(self, said: Sequence[Spoken], shape: Shape) -> dict[Kind, float]:
        """How likely each kind is, by its own estimate."""
        scores = self._weights[rows_of(said, shape)].sum(axis=0)
        chances = np.exp(scores - scores.max())
        return dict(zip(KINDS, map(float, chances / chances.sum()), strict=True))


def rows_of(said: Sequence[Spoken], shape: Shape) -> list[int]:
    """The rows of the table that a text adds up, in no order."""
    found = {*_runs(said), *_facets(said, shape)}
    return sorted({zlib.crc32(each.encode()) % ROWS for each in found})


def _facets(said: Sequence[Spoken], shape: Shape) -> Iterator[str]:
    """What the grammar gives away: each trait by itself, and pairs that go together."""
    traits = {
        "wh": shape.wh,
        "tense": shape.tense,
        "mood": shape.mood,
        "subject": _part(Spoken(shape.subject)) if shape.subject in _SUBJECTS else "other",
        "auxiliary": shape.auxiliary,
        "condition": shape.condition,
        "negated": shape.negated,
        "roles": sorted({role for each in said for role in each.roles}),
    }
    for name, value in traits.items():
        yield f"{name}={value}"
    for one, other in combinations(sorted(traits), 2):
        yield f"{one}={traits[one]} {other}={traits[other]}"


def _runs(said: Sequence[Spoken]) -> Iterator[str]:
    words = [each for each in said if each.word not in _PAUSES | _ENDS]
    parts = [_BEGIN, *map(_part, words), _END]
    for length in range(1, LONGEST_RUN + 1):
        for start in range(len(parts) - length + 1):
            yield "part " + " ".join(parts[start : start + length])
    for gap in range(2, LONGEST_RUN + 1):
        for one, other in zip(parts, parts[gap:], strict=False):
            yield f"gap {one} {other}"
    for one, other in zip(words, [*words[1:], Spoken("")], strict=False):
        yield f"word {one.word}"
        yield f"word {one.word} {other.word}"
    for length in range(1, LONGEST_RUN):
        yield "first " + " ".join(parts[1 : 1 + length])
    for part in {each for each in parts if each.startswith("<")}:
        yield f"any {part}"
    yield f"length {min(4, len(words) // 3)}"
    if any(each.word == "?" for each in said):
        yield "?"


def _part(spoken: Spoken) -> str:
    """A word by the part it plays, and its form where that tells when."""
    word = spoken.word
    ends = ("ing", "ed", "en", "s")
    form = next((end for end in ends if word.endswith(end)), "")
    for role in (Role.NAMED, Role.ME, Role.DEED, Role.KIND, Role.FACT):
        if role in spoken.roles:
            return f"<{role}{form if role in (Role.DEED, Role.FACT) else ''}>"
    return word


@cache
def listener() -> Listener:
    """The listener that comes with the package."""
    with (
        as_file(files("plainspoken.questions").joinpath("listener.npz")) as path,
        np.load(path) as stored,
    ):
        return Listener(unpacked(stored))


def unpacked(stored: Mapping[str, npt.NDArray[np.generic]]) -> npt.NDArray[np.float32]:
    """Weights as they are stored: 8-bit integers with a scale for each kind."""
    found: npt.NDArray[np.float32] = stored["weights"].astype(np.float32) * stored["scale"]
    return found
