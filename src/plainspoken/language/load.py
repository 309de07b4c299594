"""What an errand has come to, step by step: what is held, and at which stops what was done."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from plainspoken.language.handling import Handling, Manner, Thing
from plainspoken.language.step import Go, Handle, Lies, Place, Step
from plainspoken.world.symbol import SymbolId

Stops = tuple[tuple[SymbolId, ...], ...]
"""What is done at one stop after another; at each stop all of its symbols at once."""


def stops_of(steps: Sequence[Step], handling: Handling) -> Stops | None:
    """The stops that steps of going and handling make; None where they do not fit together."""
    load = _Load(handling, any(_lays(step) for step in steps))
    for number, step in enumerate(_placed(steps)):
        match step:
            case Go(place=place):
                load.go(place)
            case Handle(manner=Manner.LIFT):
                if not load.lift(step):
                    return None
            case Handle():
                if not load.lay(step, first=number == 0):
                    return None
            case _:
                return None
    return tuple(load.stops) or None


def _lays(step: Step) -> bool:
    return isinstance(step, Handle) and step.manner is not Manner.LIFT


def _placed(steps: Sequence[Step]) -> Sequence[Step]:
    """The steps, with where a thing was said to be as where it comes from."""
    lies = steps[0]
    if not isinstance(lies, Lies) or len(steps) < 2:
        return steps
    first = steps[1]
    if not isinstance(first, Handle) or first.manner is Manner.LAY or first.source is not None:
        return steps
    if first.things not in ((), (lies.thing,)):
        return steps
    return (replace(first, things=(lies.thing,), source=lies.place), *steps[2:])


@dataclass(slots=True)
class _Load:
    """What steps so far have come to.

    delivers: whether something gets somewhere in the end, and is not only picked up
    held:     things picked up and not yet put down
    waiting:  where it went, and has not yet done anything
    carried:  whether something has been put down
    """

    handling: Handling
    delivers: bool
    stops: list[tuple[SymbolId, ...]] = field(default_factory=list)
    held: list[Thing] = field(default_factory=list)
    waiting: Place | None = None
    here: Place | None = None
    carried: bool = False

    def go(self, place: Place | None) -> None:
        if self.waiting is not None:
            self.stops.append((self.waiting.symbol,))
        self.waiting = place

    def lift(self, step: Handle) -> bool:
        """Pick things up; returns whether that can be said in the domain."""
        if not step.things or (self.carried and not self.held):
            return False
        source = step.source or self.waiting
        self.waiting = None
        lifts = [self.handling.lifts(thing) for thing in step.things]
        if not (all(lifts) or self.delivers):
            return False
        picks = [symbol for symbol in lifts if symbol is not None]
        if self.delivers or len(picks) > 1:
            if source is not None and source != self.here:
                self.stops.append((source.symbol,))
            self.stops += [(symbol,) for symbol in picks]
        else:
            self.stops.append((*((source.symbol,) if source else ()), *picks))
        self.here = source
        self.held += step.things
        return True

    def lay(self, step: Handle, *, first: bool) -> bool:
        """Get things somewhere; returns whether that can be said in the domain."""
        if self.carried and not self.held and step.things:
            return False  # a further thing is an errand of its own
        goal = step.goal or self.waiting
        if not self.held and step.things and (step.manner is Manner.CARRY or goal is not None):
            if not self._fetch(step, goal):
                return False
        elif self.carried and not self.held:
            # "... and put it down there": it is down already.
            return goal is None or goal.symbol in self.stops[-1]
        elif not first and not self.held and self.waiting is None:
            return False
        self.waiting = None
        if self.held and step.things and set(step.things) != set(self.held):
            return False
        return self._put(step.things or tuple(self.held), goal)

    def _fetch(self, step: Handle, goal: Place | None) -> bool:
        lifts = [self.handling.lifts(thing) for thing in step.things]
        there = all(self._delivered(thing, goal) for thing in step.things)
        if not (all(lifts) or there):
            return False
        source = step.source or (self.waiting if step.goal is not None else None)
        if source is not None:
            self.stops.append((source.symbol,))
        if not there:
            self.stops += [(symbol,) for symbol in lifts if symbol is not None]
        return True

    def _put(self, things: Sequence[Thing], goal: Place | None) -> bool:
        ends: list[SymbolId] = []
        for thing in things or ((),):
            there = self._delivered(thing, goal)
            lays = self.handling.lays(thing)
            if there is not None:
                ends.append(there)
            elif lays is not None and (goal is None or goal.symbol):
                ends += [lays] if goal is None else [goal.symbol, lays]
            else:
                return False
        self.stops.append(tuple(dict.fromkeys(ends)))
        self.held, self.carried, self.here = [], True, goal
        return True

    def _delivered(self, thing: Thing, goal: Place | None) -> SymbolId | None:
        return self.handling.delivered.get((thing, goal.words)) if goal is not None else None
