"""A mission made a little different: patterns in, patterns out.

Nothing here reads words: what a person said further has been understood already.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from plainspoken.language.counting import Count
from plainspoken.language.itinerary import count_pattern
from plainspoken.logic.formula import And, Atom, Formula, atoms, conjunction
from plainspoken.logic.pattern import (
    AtLeast,
    Choice,
    DelayedReaction,
    Exactly,
    FairVisit,
    GuardedVisit,
    OrderedVisit,
    PastAvoidance,
    Patrolling,
    Pattern,
    PromptReaction,
    SequencedVisit,
    StrictOrderedVisit,
    Visit,
    Wait,
)
from plainspoken.logic.substitution import renamed
from plainspoken.world.symbol import SymbolId

Patterns = tuple[Pattern, ...]
Order = SequencedVisit | OrderedVisit | StrictOrderedVisit


def added(mission: Sequence[Pattern], more: Sequence[Pattern]) -> Patterns:
    """The mission, and more."""
    return _tidy((*mission, *more))


def replaced(mission: Sequence[Pattern], old: SymbolId, new: SymbolId) -> Patterns:
    """The mission with one symbol in place of another."""
    return _tidy(
        [renamed(each, lambda name: Atom(new if name == old else name)) for each in mission]
    )


def _tidy(patterns: Sequence[Pattern]) -> Patterns:
    """Each pattern once, and no visit of what is on the way of an order."""
    on_the_way = {place for each in patterns if isinstance(each, Order) for place in each.places}
    kept: dict[Pattern, None] = {}
    for each in patterns:
        if isinstance(each, Visit):
            places = tuple(place for place in each.places if place not in on_the_way)
            kept.update({Visit(places): None} if places else {})
        else:
            kept[each] = None
    return tuple(kept)


def without(mission: Sequence[Pattern], symbol: SymbolId) -> Patterns:
    """The mission with nothing that asks for a symbol; what forbids it stays."""
    return tuple(left for each in mission for left in _without(each, symbol))


def _without(pattern: Pattern, symbol: SymbolId) -> Iterator[Pattern]:
    match pattern:
        case Visit(places) | Patrolling(places):
            kept = _kept(places, symbol)
            if kept:
                yield type(pattern)(kept)
        case (
            SequencedVisit(places)
            | OrderedVisit(places)
            | StrictOrderedVisit(places)
            | FairVisit(places)
        ):
            kept = _kept(places, symbol)
            if kept:
                yield type(pattern)(kept) if len(kept) > 1 else Visit(kept)
        case GuardedVisit(place, guard):
            if symbol in atoms(guard):
                pattern = Visit((place,))
            if symbol not in atoms(place):
                yield pattern
        case AtLeast(place) | Exactly(place):
            if symbol not in atoms(place):
                yield pattern
        case PastAvoidance(first, second) | Wait(first, second):
            if symbol not in atoms(first) | atoms(second):
                yield pattern
        case DelayedReaction(_, response) | PromptReaction(_, response):
            if symbol not in atoms(response):
                yield pattern
        case Choice(options):
            left = tuple(without(option, symbol) for option in options)
            if all(left):
                yield Choice(left)
        case _:
            yield pattern


def _kept(places: Sequence[Formula], symbol: SymbolId) -> tuple[Formula, ...]:
    found = []
    for place in places:
        if symbol not in atoms(place):
            found.append(place)
        elif isinstance(place, And):
            rest = tuple(each for each in place.operands if symbol not in atoms(each))
            if rest:
                found.append(conjunction(*rest))
    return tuple(found)


def put_first(mission: Sequence[Pattern], place: Atom) -> Patterns:
    """The mission with one thing to be done before the first that it asks for."""
    return _ordered(mission, place, first=True)


def put_last(mission: Sequence[Pattern], place: Atom) -> Patterns:
    """The mission with one thing to be done after the last that it asks for."""
    return _ordered(mission, place, first=False)


def _ordered(mission: Sequence[Pattern], place: Atom, *, first: bool) -> Patterns:
    rest = without(mission, place.name)
    routes = [i for i, each in enumerate(rest) if isinstance(each, (Visit, Order))]
    if not routes:
        new = Visit((place,))
        return (new, *rest) if first else (*rest, new)
    made: list[Pattern] = list(rest)
    at = routes[0] if first else routes[-1]
    match made[at]:
        case Visit(places):
            made[at : at + 1] = [
                SequencedVisit((place, each) if first else (each, place)) for each in places
            ]
        case SequencedVisit(places) | OrderedVisit(places) | StrictOrderedVisit(places) as route:
            made[at] = type(route)((place, *places) if first else (*places, place))
        case _:
            raise AssertionError(made[at])
    return tuple(made)


def repeated(mission: Sequence[Pattern], symbol: SymbolId, count: Count) -> Patterns:
    """The mission with something to be done so many times."""
    place = Atom(symbol)
    counted = count_pattern(place, count, forbidden=False)
    made: list[Pattern] = []
    for each in mission:
        match each:
            case AtLeast(of) | Exactly(of) if of == place:
                continue
            case Visit(places) if place in places:
                kept = tuple(other for other in places if other != place)
                made += [Visit(kept)] if kept else []
            case _:
                made.append(each)
    return (*made, counted)


def demanded(mission: Sequence[Pattern]) -> tuple[SymbolId, ...]:
    """The symbols that a mission asks for, in the order in which it does."""
    found: dict[SymbolId, None] = {}
    for each in mission:
        for formula in _goals(each):
            found.update(dict.fromkeys(sorted(atoms(formula))))
    return tuple(found)


def _goals(pattern: Pattern) -> tuple[Formula, ...]:
    match pattern:
        case (
            Visit(places)
            | Patrolling(places)
            | FairVisit(places)
            | SequencedVisit(places)
            | OrderedVisit(places)
            | StrictOrderedVisit(places)
        ):
            return places
        case AtLeast(place) | Exactly(place) | GuardedVisit(place):
            return (place,)
        case DelayedReaction(_, response) | PromptReaction(_, response):
            return (response,)
        case PastAvoidance(_, until, True) | Wait(_, until):
            return (until,)
        case Choice(options):
            return tuple(goal for option in options for each in option for goal in _goals(each))
        case _:
            return ()
