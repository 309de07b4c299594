"""The parts of a request as a person gave them: each a pattern, however many conjuncts say it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from plainspoken.automata.verdict import Part, Verdict
from plainspoken.logic.formula import Formula, conjunction, conjuncts
from plainspoken.logic.pattern import Pattern
from plainspoken.logic.recognition import recognised

_WORST_FIRST = (Verdict.VIOLATED, Verdict.OPEN, Verdict.HOLDS_SO_FAR)


@dataclass(frozen=True, slots=True)
class Demand:
    """One part of the request.

    said:  the pattern, or the conjunct itself where it belongs to none
    parts: its conjuncts, each with what its automaton has seen
    """

    said: Pattern | Formula
    parts: tuple[Part, ...]

    @property
    def verdict(self) -> Verdict:
        """The verdict of the conjunction: the worst of its conjuncts."""
        found = {part.verdict for part in self.parts}
        return next((worst for worst in _WORST_FIRST if worst in found), Verdict.SATISFIED)


def demands_of(parts: Sequence[Part]) -> tuple[Demand, ...]:
    """Group the conjuncts of a request by the patterns that they make up."""
    left = {part.formula: part for part in parts}
    found: list[Demand] = []
    for said in recognised(conjunction(*left)):
        own: tuple[Formula, ...] = (said,)  # type: ignore[assignment]
        if isinstance(said, Pattern):
            own = tuple(dict.fromkeys(conjuncts(said.executable)))
            if not all(formula in left for formula in own):
                own = tuple(dict.fromkeys(conjuncts(said.literal)))
        if all(formula in left for formula in own):
            found.append(Demand(said, tuple(left.pop(formula) for formula in own)))
    found += [Demand(formula, (part,)) for formula, part in left.items()]
    return tuple(found)
