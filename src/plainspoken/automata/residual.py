"""Residuals in a normal form, so that equal ones are one state of an automaton.

A residual is a set of clauses, each a set of obligations (temporal subformulas), read as "all
obligations of some clause". Formulas in negation normal form progress to monotone combinations
of obligations, whose least such set is unique; so there are finitely many. Obligations and
clauses that plainly follow from others are dropped (`progression.entails`).
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import reduce

from plainspoken.automata.progression import Entailments, all_of, any_of, entails
from plainspoken.logic.formula import And, Constant, Formula, Or

Clause = frozenset[int]
"""Obligations, by their number in the automaton that they belong to."""
Residual = frozenset[Clause]
"""Some clause has all its obligations met."""

LOST: Residual = frozenset()
"""No clause: false, whatever comes."""
DONE: Residual = frozenset({frozenset()})
"""A clause without obligations: true, whatever comes."""


class Residuals:
    """Residuals of one automaton in normal form, with its obligations numbered as they come."""

    def __init__(self) -> None:
        self._obligations: list[Formula] = []
        self._numbers: dict[Formula, int] = {}
        self._entailed: dict[tuple[int, int], bool] = {}
        self._known: Entailments = {}
        self._met: dict[tuple[Residual, Residual], Residual] = {}
        self._joined: dict[tuple[Residual, Residual], Residual] = {}

    def of(self, formula: Formula) -> Residual:
        """A formula about the instants left as clauses of obligations."""
        match formula:
            case Constant(value):
                return DONE if value else LOST
            case And(operands):
                return reduce(self.meet, map(self.of, operands))
            case Or(operands):
                return reduce(self.join, map(self.of, operands))
            case _:
                number = self._numbers.setdefault(formula, len(self._obligations))
                if number == len(self._obligations):
                    self._obligations.append(formula)
                return frozenset({frozenset({number})})

    def formula(self, residual: Residual) -> Formula:
        """The clauses as a formula again."""
        return any_of(
            *(
                all_of(*(self._obligations[number] for number in sorted(clause)))
                for clause in sorted(residual, key=sorted)
            )
        )

    def meet(self, left: Residual, right: Residual) -> Residual:
        """Both hold."""
        if left == DONE or right == LOST:
            return right
        if right == DONE or left == LOST:
            return left
        key = (left, right)
        if key not in self._met:
            self._met[key] = self._least(self._tight(a | b) for a in left for b in right)
        return self._met[key]

    def join(self, left: Residual, right: Residual) -> Residual:
        """One of them holds."""
        if left == LOST or right == DONE:
            return right
        if right == LOST or left == DONE:
            return left
        key = (left, right)
        if key not in self._joined:
            self._joined[key] = self._least(left | right)
        return self._joined[key]

    def _entails(self, stronger: int, weaker: int) -> bool:
        key = (stronger, weaker)
        if key not in self._entailed:
            self._entailed[key] = entails(
                self._obligations[stronger], self._obligations[weaker], self._known
            )
        return self._entailed[key]

    def _tight(self, clause: Clause) -> Clause:
        """Without the obligations that follow from others; of equals the first is kept."""
        kept: list[int] = []
        for obligation in sorted(clause):
            if not any(self._entails(other, obligation) for other in kept):
                kept = [other for other in kept if not self._entails(obligation, other)]
                kept.append(obligation)
        return frozenset(kept)

    def _least(self, clauses: Iterable[Clause]) -> Residual:
        """Without the clauses that entail others; of equals the first is kept."""
        kept: list[Clause] = []
        for clause in sorted(set(clauses), key=lambda c: (len(c), sorted(c))):
            if not any(self._clause_entails(clause, other) for other in kept):
                kept = [other for other in kept if not self._clause_entails(other, clause)]
                kept.append(clause)
        return frozenset(kept)

    def _clause_entails(self, stronger: Clause, weaker: Clause) -> bool:
        return all(any(self._entails(f, g) for f in stronger) for g in weaker)
