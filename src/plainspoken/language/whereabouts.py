"""Which symbols cannot hold at one instant, as far as their landmarks tell."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from plainspoken.automata.construction import Automaton
from plainspoken.language.own_name import SAYS_WHERE, beginning
from plainspoken.logic.formula import Formula
from plainspoken.world.landmark import Landmarks, LandmarkType
from plainspoken.world.symbol import SymbolId

Apart = tuple[frozenset[SymbolId], ...]
"""Sets of symbols of which no two hold at one instant."""


def places_of_robots(landmarks: Landmarks, among: Iterable[SymbolId]) -> Apart:
    """The places of each robot, of some symbols; no robot is at two of its places at once.

    Whose place an id tells of is the word behind the one that says so: "ada" behind "robot_at" in
    `robot_at_ada_archive`. Where not each of them has two places, no id says whose: `car_at_depot`.
    """
    shared = beginning(landmarks)
    where = next((shared[:n] for n in range(len(shared), 0, -1) if shared[n - 1] in SAYS_WHERE), ())
    named = Counter(
        symbol.split("_")[len(where)]
        for symbol, landmark in landmarks.items()
        if where and landmark.type is LandmarkType.LOCATION
    )
    tells = min(named.values(), default=0) > 1
    found: dict[str, set[SymbolId]] = {}
    for symbol in among if where else ():
        *begins, whose = [*symbol.split("_")[: len(where) + 1], ""][: len(where) + 1]
        known = symbol in landmarks and landmarks[symbol].type is not LandmarkType.ACTION
        own = tells and symbol == "_".join((*where, whose))
        if tuple(begins) == where and known and not own:
            found.setdefault(whose if tells else "", set()).add(symbol)
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
