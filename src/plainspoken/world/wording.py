"""The names of a domain, split into the words that a person would say."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import cached_property

from plainspoken.world.inflection import is_word

_RUN_TOGETHER = frozenset(
    ("at", "in", "on", "up", "down", "off", "out", "to", "from", "into", "onto", "inside", "under",
     "over", "near", "with", "by", "is", "has", "have", "can", "no", "not",
     "of", "for")
)  # fmt: skip
"""Short words that names carry without a mark between: `vehicleat`, `hasspare`, `pickup`."""
_PARTICLES = ("up", "down", "off", "out")
_SHORT_FOR = {
    "loc": "location", "obj": "object", "pkg": "package", "pos": "position", "wp": "waypoint",
    "temp": "temperature", "veh": "vehicle", "num": "number", "msg": "message", "img": "image",
    "dest": "destination", "cmd": "command", "btn": "button", "pt": "point",
}  # fmt: skip
"""Abbreviations that programmers write and nobody says."""
_TITLES = frozenset(("mr", "mrs", "ms", "dr", "st"))
_SHORTEST = 3
"""Letters of a piece that is no short word; a dictionary holds too many odd ones of two."""


class Wording:
    """Splits names by their marks, and where words are run together by the words known.

    names:  those of the domain, whose words count for more than a dictionary's
    parted: names that were written with marks or capitals where one word ends, in lower case
    """

    def __init__(self, names: Iterable[str], parted: Mapping[str, str] | None = None) -> None:
        self._names = tuple(names)
        self._written = parted or {}
        self._own = frozenset(
            piece
            for name in self._names
            for piece in re.split(r"[-_\d]+", self._written.get(name, name))
            if len(piece) >= _SHORTEST
        )

    def spaced(self, name: str) -> str:
        """A name as words: `robot-at` is "robot at", `line3` is "line 3", `l3` stays."""
        pieces = self.marked(name).split()
        return " ".join(part for piece in pieces for part in self._parted(piece))

    def marked(self, name: str) -> str:
        """A name parted where it was written so, and nowhere else."""
        marked = re.sub(r"[-_]+", " ", self._written.get(name, name)).strip()
        marked = re.sub(r"\b([a-z]{3,})(\d+)", r"\1 \2", marked)
        return re.sub(r"(\d)([a-z]{3,})\b", r"\1 \2", marked)

    def verbal(self, name: str) -> str:
        """The same of an act, whose verb may carry its particle: `pickup` is "pick up"."""
        first, *rest = self.spaced(name).split() or [name]
        rest = [word for word in rest if not word.isdigit()]  # `fix-1` and `fix-2`
        for particle in _PARTICLES:
            verb = first.removesuffix(particle)
            if verb != first and len(verb) >= _SHORTEST and is_word(verb):
                return " ".join([verb, particle, *rest])
        if rest:
            # `putoutfire`: "outfire" is in the dictionary, but "fire" is what the domain speaks of
            for particle in _PARTICLES:
                if rest[0].removeprefix(particle) in self.spoken - {rest[0]}:
                    return " ".join([first, particle, rest[0].removeprefix(particle), *rest[1:]])
        return " ".join([first, *rest])

    @cached_property
    def spoken(self) -> frozenset[str]:
        """All words that the names of the domain are made of."""
        return frozenset(word for name in self._names for word in self.spaced(name).split())

    def noun(self, kind: str) -> str:
        """What things of a type are called, its usual abbreviations spelled out."""
        return " ".join(map(spelled_out, self.spaced(kind).split()))

    def _parted(self, piece: str) -> tuple[str, ...]:
        if len(piece) < 5 or not piece.isalpha() or is_word(piece):
            return (piece,)
        found = min(self._splits(piece, 3), key=self._cost, default=(piece,))
        return found if len(found) > 1 else (piece,)

    def _splits(self, piece: str, most: int) -> Iterable[tuple[str, ...]]:
        if self._cost((piece,)) < _UNKNOWN:
            yield (piece,)
        if most < 2:
            return
        for cut in range(2, len(piece) - 1):
            if self._cost((piece[:cut],)) < _UNKNOWN:
                for rest in self._splits(piece[cut:], most - 1):
                    yield (piece[:cut], *rest)

    def _cost(self, pieces: tuple[str, ...]) -> int:
        """Fewer pieces first, and among as many those that the domain itself uses."""
        total = 0
        for piece in pieces:
            if piece in self._own and (is_word(piece) or len(pieces) > 1):
                total += 10
            elif piece in _RUN_TOGETHER:
                total += 11
            elif len(piece) >= _SHORTEST and is_word(piece):
                total += 13
            else:
                total += _UNKNOWN
        return total


_UNKNOWN = 1000


def abbreviates(short: str, kind: str) -> bool:
    """Whether a name is short for a type: its first letters, or some of them in order."""
    short, kind = (text.replace("-", "").replace("_", "") for text in (short, kind))
    if not short or len(short) > len(kind) or short[0] != kind[0]:
        return False
    rest = iter(kind)
    return all(letter in rest for letter in short)


def spelled_out(word: str) -> str:
    """A word of a name as it is said: `loc` is "location", `agv` is "AGV"."""
    if word in _SHORT_FOR:
        return _SHORT_FOR[word]
    if len(word) > 3 or not word.isalpha() or len(word) < 2 or is_word(word):
        return word
    return word if word in _RUN_TOGETHER or word in _TITLES else word.upper()
