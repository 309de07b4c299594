"""What is left of a mission's request, part by part, as patterns where it is of some."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from plainspoken.automata.verdict import Part, Verdict
from plainspoken.logic.formula import Formula, conjuncts
from plainspoken.logic.pattern import Pattern, Visit
from plainspoken.logic.recognition import recognised
from plainspoken.mission.mission import Mission
from plainspoken.mission.request import Clause

Patterns = tuple[Pattern, ...]


@dataclass(frozen=True, slots=True)
class Left:
    """A part of the request.

    clause:   it alone, with the instant that it counts from
    rest:     what its automaton still asks for
    patterns: the same as patterns; none where it is of none, or there is nothing left
    """

    clause: Clause
    verdict: Verdict
    rest: Formula
    patterns: Patterns


def single(patterns: Patterns) -> Patterns:
    """Patterns with each visit for itself."""
    return tuple(
        one
        for each in patterns
        for one in (
            (Visit((place,)) for place in each.places) if isinstance(each, Visit) else (each,)
        )
    )


def left_over(mission: Mission) -> Iterator[Left]:
    """The parts of a request with what is left of each."""
    parts = iter(mission.monitor.parts)
    for clause in mission.brief.clauses:
        for goal in conjuncts(clause.goal):
            part = next(parts)
            rest = part.automaton.residual(part.state)
            patterns = () if part.verdict is Verdict.SATISFIED else _as_patterns(part, rest)
            yield Left(Clause(goal, clause.since), part.verdict, rest, patterns)


def _as_patterns(part: Part, rest: Formula) -> Patterns:
    for formula in (rest, part.formula):
        found = recognised(formula)
        if all(isinstance(each, Pattern) for each in found):
            return single(tuple(each for each in found if isinstance(each, Pattern)))
    return ()


def done_already(mission: Mission) -> Patterns:
    """The parts of the request that are met for good."""
    found = [
        each
        for part in mission.monitor.parts
        if part.verdict is Verdict.SATISFIED
        for each in recognised(part.formula)
    ]
    return tuple(each for each in found if isinstance(each, Pattern))
