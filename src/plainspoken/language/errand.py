"""Errands: things picked up, carried and put down, and acts done at a place.

An errand is one act with several stops: carrying a thing from a to b is to be at a, then to pick
the thing up, then to put it down at b. It is told as one, so it is one operand of a clause.
"""

from __future__ import annotations

from dataclasses import dataclass

from plainspoken.world.symbol import SymbolId


@dataclass(frozen=True, slots=True)
class Named:
    """A symbol that words of an utterance stand for. start, end: characters."""

    symbol: SymbolId
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Errand:
    """What is done at one stop after another; at each stop all of its symbols at once.

    named: the words of each symbol
    form:  "base", "gerund" or "finite", as its verb is inflected
    carries: whether a thing is picked up, carried or put down, and not only recorded
    lays:    whether a thing gets somewhere, and is not only picked up
    things:  the words of the things that are handled
    """

    stops: tuple[tuple[SymbolId, ...], ...]
    named: tuple[Named, ...] = ()
    form: str = "base"
    carries: bool = True
    lays: bool = False
    things: tuple[tuple[str, ...], ...] = ()

    @property
    def travels(self) -> bool:
        """Whether it leads from stop to stop, or something somewhere, and so takes its time."""
        return len(self.stops) > 1 or (self.lays and bool(self.things))
