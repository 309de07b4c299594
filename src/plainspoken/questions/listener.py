"""What kind a question is of, by what has been learned from questions that people wrote.

A linear model over two things. Runs of up to four words, the words of the mission by the parts
they play (`spoken`), and what the grammar gives away: these tell constructions apart. And what
the encoder of `language.network` makes of the words: it knows words alike that no question held.
It goes wrong elsewhere than the rules do. `python -m training.questions` fits it.

Source: Joachims, Text Categorization with Support Vector Machines, 1998 (linear models over words);
Weinberger et al., Feature Hashing for Large Scale Multitask Learning, 2009 (the table).
"""

from __future__ import annotations

import zlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from importlib.resources import as_file, files
from itertools import combinations

import numpy as np
import numpy.typing as npt

from plainspoken.language.network import network
from plainspoken.questions.grammar import Shape
from plainspoken.questions.kind import Kind
from plainspoken.questions.spoken import Role, Spoken

Array = npt.NDArray[np.float32]

KINDS = tuple(Kind)
ROWS = 1 << 15
"""Of the table; two runs of words that share a row are taken for one."""
LONGEST_RUN = 4
_SUBJECTS = frozenset({"you", "i", "we", "it", "they", "robot", "everything", "that", "this", ""})
_PAUSES = frozenset(".,;:-–—")
_ENDS = frozenset("?!")
_BEGIN, _END = "^", "$"
_NOTHING = "."
"""What is heard where nothing is said."""
MOST_WORDS = 60
"""Of a text whose meaning is read: no question is longer."""


@dataclass(frozen=True)
class Listener:
    """Weights: a column for each kind.

    table:   a row for runs of words
    meaning: a row for each number of `meaning_of`
    """

    table: Array
    meaning: Array
    bias: Array

    def hear(self, said: Sequence[Spoken], shape: Shape) -> dict[Kind, float]:
        """How likely each kind is, by its own estimate."""
        scores = self.table[rows_of(said, shape)].sum(axis=0)
        scores = scores + meaning_of(said) @ self.meaning + self.bias
        chances = np.exp(scores - scores.max())
        return dict(zip(KINDS, map(float, chances / chances.sum()), strict=True))


@lru_cache(maxsize=4096)
def heard(said: tuple[Spoken, ...], shape: Shape) -> Mapping[Kind, float]:
    """What the listener that comes with the package makes of a text; one is often asked again."""
    return listener().hear(said, shape)


def meaning_of(said: Sequence[Spoken]) -> Array:
    """What the encoder makes of a text: the mean and the maximum of each layer's rows."""
    layers = network().states([each.word for each in said][:MOST_WORDS] or [_NOTHING])
    return np.concatenate(
        [part for rows in layers for part in (rows.mean(axis=0), rows.max(axis=0))]
    )


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
    plain = [each.word for each in words]
    for word, after in zip(plain, [*plain[1:], ""], strict=False):
        yield f"word {word}"
        yield f"word {word} {after}"
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
        return unpacked(stored)


def unpacked(stored: Mapping[str, npt.NDArray[np.generic]]) -> Listener:
    """Weights as they are stored: those of runs as 8-bit integers with a scale for each kind."""
    table = stored["table"].astype(np.float32) * stored["scale"].astype(np.float32)
    meaning, bias = (stored[each].astype(np.float32) for each in ("meaning", "bias"))
    return Listener(table, meaning, bias)
