"""What satisfaction on a finite trace means: the slow, plain reading of the definition.

Everything else that speaks of truth over time (automata, policies, answers) is tested against
`holds`. Source: De Giacomo and Vardi, IJCAI 2013, section 2; `W`, `R` and `WX` by their usual
duals.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import assert_never

from plainspoken.logic.formula import (
    Always,
    And,
    Atom,
    Constant,
    Eventually,
    Formula,
    Iff,
    Implies,
    Next,
    Not,
    Or,
    Release,
    Until,
    WeakNext,
    WeakUntil,
)

Instant = int
Letter = frozenset[str]
"""The names of the propositions that are true at one instant."""
Trace = Sequence[Letter]
"""Instants s0 ... sn; never empty."""


def holds(formula: Formula, trace: Trace, at: Instant = 0) -> bool:
    """Whether the trace satisfies the formula at an instant.

    raises ValueError: on an empty trace or an instant outside it
    """
    if not 0 <= at < len(trace):
        raise ValueError(f"instant {at} is outside a trace of {len(trace)} instants")
    last = len(trace) - 1
    rest = range(at, len(trace))
    match formula:
        case Constant(value):
            return value
        case Atom(name):
            return name in trace[at]
        case Not(f):
            return not holds(f, trace, at)
        case And(operands):
            return all(holds(f, trace, at) for f in operands)
        case Or(operands):
            return any(holds(f, trace, at) for f in operands)
        case Implies(left, right):
            return not holds(left, trace, at) or holds(right, trace, at)
        case Iff(left, right):
            return holds(left, trace, at) == holds(right, trace, at)
        case Next(f):
            return at < last and holds(f, trace, at + 1)
        case WeakNext(f):
            return at == last or holds(f, trace, at + 1)
        case Eventually(f):
            return any(holds(f, trace, i) for i in rest)
        case Always(f):
            return all(holds(f, trace, i) for i in rest)
        case Until(left, right):
            return any(
                holds(right, trace, i) and all(holds(left, trace, j) for j in range(at, i))
                for i in rest
            )
        case WeakUntil(left, right):
            return all(
                holds(left, trace, i) or any(holds(right, trace, j) for j in range(at, i + 1))
                for i in rest
            )
        case Release(left, right):
            return all(
                holds(right, trace, i) or any(holds(left, trace, j) for j in range(at, i))
                for i in rest
            )
        case _:
            assert_never(formula)
