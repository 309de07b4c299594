"""Which parts of a goal are in each other's way: minimal sets, found by leaving parts out."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import comb

from plainspoken.automata.construction import Automaton, Guard, StateId
from plainspoken.world.symbol import SymbolId

MOST_TRIED = 40
"""Sets of one size are tried one by one where there are no more of them."""
MOST_JOINT = 20_000
"""The ways on from joint states that are looked at before a contradiction is given up on."""

Exclusions = Mapping[SymbolId, frozenset[SymbolId]]
Judge = Callable[[tuple[int, ...]], bool | None]
"""Whether parts are impossible together; None where that is not known."""


@dataclass(frozen=True, slots=True)
class Culprits:
    """Parts that are impossible together. minimal: proven to be possible without any of them."""

    parts: tuple[int, ...]
    minimal: bool


def culprits(count: int, judge: Judge) -> Culprits:
    """A set of parts, of so many, that are impossible together; all of them are known to be.

    Small sets go first: they are quicker to decide than large ones. Then parts are left out one
    by one. What is possible with more parts is possible with fewer, so nothing is tried twice.
    """
    unknown: set[int] = set()
    for size in (1, 2):
        if size >= count or comb(count, size) > MOST_TRIED:
            break
        for tried in combinations(range(count), size):
            verdict = judge(tried)
            if verdict:
                return Culprits(tried, not unknown.intersection(tried))
            if verdict is None and size == 1:
                unknown.update(tried)
    kept = tuple(range(count))
    minimal = True
    for part in range(count):
        rest = tuple(each for each in kept if each != part)
        if not rest:
            break
        verdict = judge(rest)
        if verdict:
            kept = rest
        elif verdict is None:
            minimal = False
    return Culprits(kept, minimal)


def contradict(
    automata: Sequence[Automaton],
    start: tuple[StateId, ...] | None = None,
    excluded: Exclusions | None = None,
    most: int = MOST_JOINT,
) -> bool | None:
    """Whether automata accept no trace together; None where that takes too long to know.

    start:    states that have read something already, and do not all accept
    excluded: for each symbol, those that are never true when it is
    """
    if start is None:
        if not all(automaton.can_accept(automaton.initial) for automaton in automata):
            return True
        start = tuple(a.initial for a in automata)
    seen = {start}
    todo = [start]
    while todo:
        targets, looked_at = _joint(automata, todo.pop(), most, excluded or {})
        if targets is None:
            return None
        most -= looked_at
        for after in targets:
            # Not only where it is new: a first letter may lead back to the start.
            if all(a.accepts(s) for a, s in zip(automata, after, strict=True)):
                return False
            if after not in seen:
                seen.add(after)
                todo.append(after)
    return True


def _joint(
    automata: Sequence[Automaton], states: tuple[StateId, ...], most: int, excluded: Exclusions
) -> tuple[set[tuple[StateId, ...]] | None, int]:
    """Where a letter can lead all automata at once, and how many ways were looked at for that.

    None where there are more ways than `most`.
    """
    looked_at = 0
    partial: dict[tuple[frozenset[SymbolId], frozenset[SymbolId], tuple[StateId, ...]], None]
    partial = {(frozenset(), frozenset(), ()): None}
    for automaton, state in zip(automata, states, strict=True):
        guards: list[Guard] = [g for g in automaton.guards(state) if automaton.can_accept(g.target)]
        looked_at += len(partial) * len(guards)
        if looked_at > most:
            return None, looked_at
        if excluded:
            guards = [each for guard in guards if (each := _closed(guard, excluded)) is not None]
        partial = {
            (yes | g.positive, no | g.negative, (*after, g.target)): None
            for yes, no, after in partial
            for g in guards
            if not (yes & g.negative or no & g.positive)
        }
    return {after for _, _, after in partial}, looked_at


def _closed(guard: Guard, excluded: Exclusions) -> Guard | None:
    """The guard with what its symbols exclude; None where no letter has all of them."""
    never = frozenset[SymbolId]().union(*(excluded.get(name, ()) for name in guard.positive))
    if never & guard.positive:
        return None
    return Guard(guard.positive, guard.negative | never, guard.target)
