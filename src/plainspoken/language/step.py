"""One step of an errand: go there, pick this up, carry it, put it down, take a record of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from plainspoken.language.handling import Manner, Thing
from plainspoken.world.symbol import SymbolId


@dataclass(frozen=True, slots=True)
class Place:
    """Where a place is named. first, last: its first word and the one after its last."""

    symbol: SymbolId
    first: int
    last: int
    words: Thing


Name = tuple[SymbolId, int, int]


@dataclass(frozen=True, slots=True)
class Step:
    """Words from first to last that tell one step.

    verb:  the word whose inflection is the step's
    kept:  words within that say what is so of the step: "must", "not"
    there: whether it says "there"
    link:  how the several things or places that it speaks of are joined
    """

    first: int
    last: int
    verb: int
    form: str
    names: tuple[Name, ...] = ()
    where: tuple[Place, ...] = ()
    kept: tuple[int, ...] = ()
    there: bool = False
    link: str = "and"


@dataclass(frozen=True, slots=True)
class Go(Step):
    """Going somewhere; without a place only "go and", "go to" before what is done."""

    place: Place | None = None


@dataclass(frozen=True, slots=True)
class Handle(Step):
    """Picking things up, carrying them, putting them down. things: () for whatever is held."""

    manner: Manner = Manner.LIFT
    things: tuple[Thing, ...] = ()
    source: Place | None = None
    goal: Place | None = None


@dataclass(frozen=True, slots=True)
class Deed(Step):
    """Taking a record, of places or wherever the robot is."""

    symbol: SymbolId = ""
    places: tuple[Place, ...] = ()


@dataclass(frozen=True, slots=True)
class Lies(Step):
    """Where a thing is, told before what is to be done with it."""

    thing: Thing = ()
    place: Place | None = None


def names_of(places: Sequence[Place]) -> tuple[Name, ...]:
    """The symbols of places with the words that they stand for."""
    return tuple((each.symbol, each.first, each.last) for each in places)
