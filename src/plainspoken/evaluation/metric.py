"""What is counted: shares with their intervals, formulas judged, mentions matched, seconds."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import permutations
from typing import Protocol

from plainspoken.automata.equivalence import equivalent
from plainspoken.evaluation.corpus import Mention, symbols_of
from plainspoken.logic.formula import Atom, Formula, substituted
from plainspoken.world.symbol import SymbolId

Z95 = 1.959963984540054
"""The 97.5th percentile of the normal distribution: two-sided 95%."""
MOST_MISTAKEN = 4
"""Symbols that may be taken for others in one sentence: 4! ways to tell them apart."""


@dataclass(frozen=True, slots=True)
class Share:
    """So many of so many."""

    count: int
    total: int

    @classmethod
    def of(cls, flags: Iterable[bool]) -> Share:
        listed = list(flags)
        return cls(sum(listed), len(listed))

    @property
    def value(self) -> float | None:
        """Between 0 and 1; None of nothing."""
        return self.count / self.total if self.total else None

    @property
    def interval(self) -> tuple[float, float]:
        return wilson(self.count, self.total)


def wilson(count: int, total: int, z: float = Z95) -> tuple[float, float]:
    """The score interval for a proportion; 0 to 1 where nothing was counted.

    source: Wilson, "Probable inference, the law of succession, and statistical inference",
    JASA 22 (1927). The paper gives no intervals; with 10 sentences a pattern they matter.
    """
    if not 0 <= count <= total:
        raise ValueError(f"{count} of {total}")
    if total == 0:
        return 0.0, 1.0
    share = count / total
    middle = share + z * z / (2 * total)
    spread = z * math.sqrt(share * (1 - share) / total + z * z / (4 * total * total))
    scale = 1 + z * z / total
    # At the ends the interval is exact; floating point is not.
    low = 0.0 if count == 0 else max(0.0, (middle - spread) / scale)
    high = 1.0 if count == total else min(1.0, (middle + spread) / scale)
    return low, high


def percentile(values: Sequence[float], percent: float) -> float | None:
    """The smallest value that so many percent do not exceed (nearest rank)."""
    if not values:
        return None
    rank = max(1, math.ceil(percent / 100 * len(values)))
    return sorted(values)[rank - 1]


def differs_in_grounding(recognised: Formula, gold: Formula) -> bool:
    """Whether a wrong formula would be right with other symbols in the places of some of its own.

    Symbols that both have stay where they are: to swap those is a wrong order, not a wrong symbol.
    """
    own = sorted(symbols_of(recognised) - symbols_of(gold))
    due = sorted(symbols_of(gold) - symbols_of(recognised))
    if not own or len(own) != len(due) or len(own) > MOST_MISTAKEN:
        return False
    return any(
        equivalent(substituted(recognised, _renaming(dict(zip(own, order, strict=True)))), gold)
        for order in permutations(due)
    )


def _renaming(symbols: dict[SymbolId, SymbolId]) -> Callable[[str], Formula]:
    return lambda name: Atom(symbols.get(name, name))


class Span(Protocol):
    """A recognised referring expression, or a gold one."""

    @property
    def start(self) -> int: ...
    @property
    def end(self) -> int: ...
    @property
    def symbol(self) -> SymbolId: ...


@dataclass(frozen=True, slots=True)
class Mentions:
    """How the referring expressions of one sentence, or of many, were recognised.

    recall:    of the gold ones, those that a recognised one overlaps and grounds alike
    precision: of the recognised ones, those that a gold one overlaps and grounds alike
    grounding: of the gold ones that a recognised one overlaps, those that one grounds alike
    """

    recall: Share = Share(0, 0)
    precision: Share = Share(0, 0)
    grounding: Share = Share(0, 0)

    def __add__(self, other: Mentions) -> Mentions:
        return Mentions(
            _sum(self.recall, other.recall),
            _sum(self.precision, other.precision),
            _sum(self.grounding, other.grounding),
        )


def compared(recognised: Sequence[Span], gold: Sequence[Mention]) -> Mentions:
    """Match the referring expressions of one sentence, by place and by symbol."""
    found = [any(_same(mention, each) for each in recognised) for mention in gold]
    due = [any(_same(each, mention) for mention in gold) for each in recognised]
    touched = [any(_overlap(mention, each) for each in recognised) for mention in gold]
    return Mentions(Share.of(found), Share.of(due), Share(sum(found), sum(touched)))


def _sum(one: Share, other: Share) -> Share:
    return Share(one.count + other.count, one.total + other.total)


def _overlap(one: Span, other: Span) -> bool:
    return one.start < other.end and other.start < one.end


def _same(one: Span, other: Span) -> bool:
    return one.symbol == other.symbol and _overlap(one, other)
