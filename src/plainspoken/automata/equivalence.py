"""Whether two formulas say the same of every finite trace, by walking their automata together."""

from __future__ import annotations

from collections.abc import Iterator

from plainspoken.automata.construction import Automaton, Guard, StateId
from plainspoken.logic.formula import Formula, Not, conjunction


def equivalent(first: Formula, second: Formula) -> bool:
    """Whether the same non-empty finite traces satisfy both formulas."""
    one, other = Automaton(first), Automaton(second)
    pairs = ((a, b) for a, b, read in _pairs(one, other) if read)
    return all(one.accepts(a) == other.accepts(b) for a, b in pairs)


def satisfiable(formula: Formula) -> bool:
    """Whether some non-empty finite trace satisfies the formula."""
    automaton = Automaton(formula)
    seen = {automaton.initial}
    todo = [automaton.initial]
    while todo:
        for guard in automaton.guards(todo.pop()):
            if automaton.accepts(guard.target):
                return True
            if guard.target not in seen:
                seen.add(guard.target)
                todo.append(guard.target)
    return False


def implies(first: Formula, second: Formula) -> bool:
    """Whether every non-empty finite trace of the first satisfies the second."""
    return not satisfiable(conjunction(first, Not(second)))


def _pairs(one: Automaton, other: Automaton) -> Iterator[tuple[StateId, StateId, bool]]:
    """The reachable pairs of states, and whether an instant has been read by then."""
    start = (one.initial, other.initial)
    yield (*start, False)
    reached: set[tuple[StateId, StateId]] = set()
    todo = [start]
    while todo:
        a, b = todo.pop()
        for first in one.guards(a):
            for second in other.guards(b):
                pair = (first.target, second.target)
                if pair not in reached and _meet(first, second):
                    reached.add(pair)
                    yield (*pair, True)
                    todo.append(pair)


def _meet(first: Guard, second: Guard) -> bool:
    """Whether some letter passes both guards."""
    return not (first.positive & second.negative or first.negative & second.positive)
