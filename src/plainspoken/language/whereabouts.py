"""Which symbols cannot hold at one instant, as far as their landmarks tell."""

from __future__ import annotations

import re
from collections.abc import Iterable

from plainspoken.automata.construction import Automaton
from plainspoken.logic.formula import Formula
from plainspoken.world.landmark import Landmarks, LandmarkType
from plainspoken.world.symbol import SymbolId

Apart = tuple[frozenset[SymbolId], ...]
"""Sets of symbols of which no two hold at one instant."""

_WHERE = re.compile(r"(robot_at_[^_]+)_.")
"""A robot is at one place at a time: ids that differ in the place exclude each other."""


def places_of_robots(landmarks: Landmarks, among: Iterable[SymbolId]) -> Apart:
    """The places of each robot, of some symbols; no robot is at two of its places at once."""
    found: dict[str, set[SymbolId]] = {}
    for symbol in among:
        match = _WHERE.match(symbol)
        if match and symbol in landmarks and landmarks[symbol].type is not LandmarkType.ACTION:
            found.setdefault(match[1], set()).add(symbol)
    return tuple(frozenset(each) for each in found.values() if len(each) > 1)


def customary(landmarks: Landmarks, among: Iterable[SymbolId]) -> Apart:
    """What seldom holds at once: two places, two actions."""
    known = [symbol for symbol in among if symbol in landmarks]
    kinds = (LandmarkType.LOCATION, LandmarkType.ACTION)
    return tuple(
        frozenset(symbol for symbol in known if landmarks[symbol].type is kind) for kind in kinds
    )


def fits(letter: frozenset[SymbolId], apart: Apart) -> bool:
    """Whether no two symbols of a letter exclude each other."""
    return all(len(letter & each) < 2 for each in apart)


def can_be_met(formula: Formula, apart: Apart) -> bool:
    """Whether some trace satisfies a formula and keeps apart what excludes each other.

    raises FormulaTooLargeError: as its automaton does
    """
    automaton = Automaton(formula)
    seen, todo = {automaton.initial}, [automaton.initial]
    while todo:
        for guard in automaton.guards(todo.pop()):
            # The guard's smallest letter: where that does not fit, none of it does.
            if not fits(guard.positive, apart):
                continue
            if automaton.accepts(guard.target):
                return True
            if guard.target not in seen:
                seen.add(guard.target)
                todo.append(guard.target)
    return False
