"""Truth of all subformulas of a formula at once, an instant at a time from the end of a trace.

As in `logic.trace`, the value of a formula at an instant depends on the letter there and on the
values at the next instant; here all values are the bits of one int.
"""

from __future__ import annotations

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
            for place, part in enumerate(self._parts):
                if self._value(part, place, letter, known, after):
                    known |= 1 << place
            self._known[key] = known
        return known

    def _value(
        self, part: Formula, place: int, letter: Letter, now: Valuation, after: Valuation | None
    ) -> bool:
        def holds(operand: int) -> bool:
            return now >> self._operands[place][operand] & 1 == 1

        last = after is None
        # Itself, and its operand, at the next instant.
        itself = after is not None and after >> place & 1 == 1
        match part:
            case Constant(value):
                return value
            case Atom(name):
                return name in letter
            case Not():
                return not holds(0)
            case And():
                return all(now >> operand & 1 for operand in self._operands[place])
            case Or():
                return any(now >> operand & 1 for operand in self._operands[place])
            case Implies():
                return not holds(0) or holds(1)
            case Iff():
                return holds(0) == holds(1)
            case Next():
                return after is not None and after >> self._operands[place][0] & 1 == 1
            case WeakNext():
                return after is None or after >> self._operands[place][0] & 1 == 1
            case Eventually():
                return holds(0) or itself
            case Always():
                return holds(0) and (last or itself)
            case Until():
                return holds(1) or (holds(0) and itself)
            case WeakUntil():
                return holds(1) or (holds(0) and (last or itself))
            case Release():
                return holds(1) and (holds(0) or last or itself)
            case _:
                assert_never(part)
