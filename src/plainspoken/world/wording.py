"""The names of a domain, split into the words that a person would say."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache

_RUN_TOGETHER = frozenset(
    ("at", "in", "on", "up", "down", "off", "out", "to", "from", "into", "onto", "inside", "under",
     "over", "near", "with", "by", "is", "has", "have", "can", "no", "not")
)  # fmt: skip
"""Short words that names carry without a mark between: `vehicleat`, `hasspare`, `pickup`."""
_PARTICLES = ("up", "down", "off", "out")
_SHORTEST = 3
"""Letters of a piece that is no short word; a dictionary holds too many odd ones of two."""


class Wording:
    """Splits names by their marks, and where words are run together by the words known.

    own: words of the domain itself, which count for more than a dictionary's
    """

    def __init__(self, names: Iterable[str]) -> None:
        self._own = frozenset(
            piece
            for name in names
            for piece in re.split(r"[-_\d]+", name)
            if len(piece) >= _SHORTEST
        )

    def spaced(self, name: str) -> str:
        """A name as words: `robot-at` is "robot at", `line3` is "line 3", `l3` stays."""
        marked = re.sub(r"[-_]+", " ", name).strip()
        marked = re.sub(r"\b([a-z]{3,})(\d+)\b", r"\1 \2", marked)
        return " ".join(part for piece in marked.split() for part in self._parted(piece))

    def verbal(self, name: str) -> str:
        """The same of an act, whose verb may carry its particle: `pickup` is "pick up"."""
        first, *rest = self.spaced(name).split() or [name]
        for particle in _PARTICLES:
            verb = first.removesuffix(particle)
            if verb != first and len(verb) >= _SHORTEST and is_word(verb):
                return " ".join([verb, particle, *rest])
        return " ".join([first, *rest])

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


@cache
def is_word(text: str) -> bool:
    """Whether the dictionary of English has it."""
    # Loaded at the first word: the dictionary takes a quarter of a second.
    import simplemma  # noqa: PLC0415

    return bool(simplemma.is_known(text, lang="en"))


def is_quality(text: str) -> bool:
    """Whether a word says how something is: those have a noun in "-ness"."""
    head = text[:-1] + "i" if text.endswith("y") else text
    return is_word(f"{head}ness")


def abbreviates(short: str, kind: str) -> bool:
    """Whether a name is short for a type: its first letters, or some of them in order."""
    short, kind = (text.replace("-", "").replace("_", "") for text in (short, kind))
    if not short or len(short) > len(kind) or short[0] != kind[0]:
        return False
    rest = iter(kind)
    return all(letter in rest for letter in short)


def doing(noun: str) -> str | None:
    """What one who is called after what they do is doing: a "lifter" is "lifting"."""
    if not noun.endswith(("er", "or")) or len(noun) < 5:
        return None
    head = noun[:-2]
    head = head[:-1] + "y" if head.endswith("i") else head
    gerund = f"{head}ing"
    return gerund if is_word(gerund) else None
