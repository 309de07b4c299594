"""What a mission is asked for, and what it has become: clauses over the trace so far.

A change of mind does not rewrite the past. Each clause holds, or not, of the trace from its own
instant on, with the state of that instant as its s0: so whether the mission did what was asked
stays defined by the recorded trace alone, however often the request changed.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from plainspoken.automata.verdict import Monitor, Part
from plainspoken.errors import PlainspokenError
from plainspoken.logic.formula import Formula, atoms
from plainspoken.logic.syntax import parse, unparse
from plainspoken.world.domain import GroundAction, Problem, State
from plainspoken.world.event import Instant, MissionAccepted
from plainspoken.world.symbol import Symbol, letter, resolve_all


@dataclass(frozen=True, slots=True)
class Clause:
    """A formula for the trace from an instant on; no action led to that instant."""

    goal: Formula
    since: Instant = 0


@dataclass(frozen=True, slots=True)
class Past:
    """The trace so far, sn first: a list that shares its tail with the one before.

    state: every true atom, static ones included; action: what led to it
    """

    state: State
    action: GroundAction | None
    before: Past | None = field(default=None, repr=False, compare=False)

    def moments(self) -> list[tuple[State, GroundAction | None]]:
        """From s0 on."""
        found = []
        each: Past | None = self
        while each is not None:
            found.append((each.state, each.action))
            each = each.before
        return found[::-1]


def acceptance(
    mission: str,
    problem: Problem,
    goal: Formula,
    *,
    domain_text: str,
    problem_text: str,
    sentence: str | None = None,
    english: str = "",
    landmarks: Mapping[str, Any] | None = None,
    robot: Mapping[str, Any] | None = None,
    unknown: State = frozenset(),
) -> MissionAccepted:
    """The first event of a mission: all that is needed to understand its log alone.

    domain_text, problem_text: the PDDL that `problem` was read from
    sentence, english: what the person said, and the goal said back
    landmarks: the landmarks document; robot: which robot, and how it is set
    unknown: atoms that nobody knows at s0, beside those that the problem names
    """
    unknown |= problem.unknown
    static = frozenset(
        atom
        for atom in problem.initial - unknown
        if atom.split()[0] not in problem.changing_predicates
    )
    return MissionAccepted(
        mission,
        sentence,
        unparse(goal),
        english,
        domain_text,
        problem_text,
        landmarks or {},
        tuple(sorted(static)),
        problem.initial - static,
        robot or {},
        tuple(sorted(unknown)),
    )


def clauses_to_json(clauses: Iterable[Clause]) -> tuple[Mapping[str, Any], ...]:
    """The field `clauses` of an event."""
    return tuple({"since": each.since, "goal": unparse(each.goal)} for each in clauses)


def clauses_from_json(documents: Sequence[Mapping[str, Any]], where: str) -> tuple[Clause, ...]:
    """Read the field `clauses` of an event.

    raises PlainspokenError: when it is none, or a formula of it cannot be read
    """
    try:
        return tuple(Clause(parse(each["goal"]), int(each["since"])) for each in documents)
    except (KeyError, TypeError, ValueError) as error:
        raise PlainspokenError("expected clauses, each with since and goal", where=where) from error


def symbols_of(clauses: Iterable[Clause], problem: Problem) -> tuple[Symbol, ...]:
    """The symbols that clauses speak of.

    raises UnknownSymbolError: when the problem has no such symbol
    """
    names = frozenset[str]().union(*(atoms(each.goal) for each in clauses))
    return resolve_all(names, problem)


def monitor_of(clauses: Iterable[Clause], symbols: tuple[Symbol, ...], past: Past) -> Monitor:
    """Clauses after the trace so far.

    raises PlainspokenError: when a clause begins at an instant that is yet to come
    """
    moments = past.moments()
    parts: list[Part] = []
    for each in clauses:
        if not 0 <= each.since < len(moments):
            raise PlainspokenError(f"a clause cannot begin at instant {each.since}, not yet come")
        (first, _), *rest = moments[each.since :]
        monitor = Monitor.of(each.goal).after(letter(symbols, first, action=None))
        parts += monitor.after_all(letter(symbols, *moment) for moment in rest).parts
    return Monitor(tuple(parts))
