"""Truth of all subformulas of a formula at once, an instant at a time from the end of a trace.

As in `logic.trace`, the value of a formula at an instant depends on the letter there and on the
values at the next instant; here all values are the bits of one int.
"""
# ruff: noqa: ARG005 - rules of all operators are called alike, and most need only a part

from __future__ import annotations

from collections.abc import Callable
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
    children,
    subformulas,
)
from plainspoken.logic.trace import Letter

Valuation = int
"""Bit i is set where subformula i holds."""
Rule = Callable[[Letter, Valuation, Valuation, bool], bool]
"""The value of a subformula from the letter, the values found so far at this instant, those at the
next instant (none at the last one), and whether this is the last one."""


class Valuations:
    """Values of one formula's subformulas, parts before wholes, the formula itself last."""

    def __init__(self, formula: Formula) -> None:
        self._parts = tuple(dict.fromkeys(subformulas(formula)))
        places = {part: i for i, part in enumerate(self._parts)}
        self._operands = tuple(tuple(places[c] for c in children(p)) for p in self._parts)
        self._kept = 0
        for place, part in enumerate(self._parts):
            match part:
                case Next() | WeakNext():
                    self._kept |= 1 << self._operands[place][0]
                case Eventually() | Always() | Until() | WeakUntil() | Release():
                    self._kept |= 1 << place
                case _:
                    pass
        # Looked up once for each subformula, not at each instant: policies have many thousands.
        self._rules = [(1 << i, self._rule(part, i)) for i, part in enumerate(self._parts)]
        self._known: dict[tuple[Letter, Valuation | None], Valuation] = {}

    def at_the_end(self, letter: Letter) -> Valuation:
        """The values at the last instant."""
        return self._valuation(letter, None)

    def before(self, letter: Letter, after: Valuation) -> Valuation:
        """The values at an instant, from those at the next one (of which `kept` is enough)."""
        return self._valuation(letter, after)

    def kept(self, valuation: Valuation) -> Valuation:
        """The values that those at the instant before depend on."""
        return valuation & self._kept

    def holds(self, valuation: Valuation) -> bool:
        """Whether the formula itself holds."""
        return valuation >> (len(self._parts) - 1) & 1 == 1

    def _valuation(self, letter: Letter, after: Valuation | None) -> Valuation:
        key = (letter, after)
        known = self._known.get(key)
        if known is None:
            known = 0
            later, last = (0, True) if after is None else (after, False)
            for mask, rule in self._rules:
                if rule(letter, known, later, last):
                    known |= mask
            self._known[key] = known
        return known

    def _rule(self, part: Formula, place: int) -> Rule:
        """How the value of one subformula follows; each operand stands before it."""
        itself = 1 << place
        operands = self._operands[place]
        first = 1 << operands[0] if operands else 0
        second = 1 << operands[1] if len(operands) > 1 else 0
        every = sum({1 << operand for operand in operands})
        match part:
            case Constant(value):
                return lambda letter, now, after, last: value
            case Atom(name):
                return lambda letter, now, after, last: name in letter
            case Not():
                return lambda letter, now, after, last: not now & first
            case And():
                return lambda letter, now, after, last: now & every == every
            case Or():
                return lambda letter, now, after, last: now & every != 0
            case Implies():
                return lambda letter, now, after, last: not now & first or now & second != 0
            case Iff():
                return lambda letter, now, after, last: (not now & first) == (not now & second)
            case Next():
                return lambda letter, now, after, last: not last and after & first != 0
            case WeakNext():
                return lambda letter, now, after, last: last or after & first != 0
            case Eventually():
                return lambda letter, now, after, last: (now & first | after & itself) != 0
            case Always():
                return lambda letter, now, after, last: (
                    now & first != 0 and (last or after & itself != 0)
                )
            case Until():
                return lambda letter, now, after, last: (
                    now & second != 0 or (now & first != 0 and after & itself != 0)
                )
            case WeakUntil():
                return lambda letter, now, after, last: (
                    now & second != 0 or (now & first != 0 and (last or after & itself != 0))
                )
            case Release():
                return lambda letter, now, after, last: (
                    now & second != 0 and (now & first != 0 or last or after & itself != 0)
                )
            case _:
                assert_never(part)
