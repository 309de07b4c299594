"""What the request reads of each instant: automata for its conjuncts, run over the trace.

A request that was changed consists of clauses, each for the trace from an instant on; to a clause
the state of that instant is s0, to which no action led.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import islice

from plainspoken.automata.construction import Automaton
from plainspoken.automata.verdict import Part
from plainspoken.logic.formula import atoms, conjuncts
from plainspoken.logic.syntax import parse
from plainspoken.questions.identity import ById
from plainspoken.world.domain import GroundAction, Problem, State
from plainspoken.world.event import Instant
from plainspoken.world.symbol import AtomSymbol, SymbolId, letter, resolve_all

Clauses = tuple[tuple[Instant, str], ...]
"""Formulas as text, each with the instant from which on it is to hold."""
_States = tuple[int, ...]


class Letters:
    """What the request reads of an instant, and the automata that read it."""

    def __init__(self, problem: Problem, clauses: Clauses) -> None:
        self._static = frozenset(
            atom
            for atom in problem.initial
            if atom.split(" ", 1)[0] not in problem.changing_predicates
        )
        found = [(since, parse(goal)) for since, goal in clauses]
        begins = dict.fromkeys((part, since) for since, f in found for part in conjuncts(f))
        self.automata = tuple(Automaton(part) for part, _ in begins)
        self._since = tuple(since for _, since in begins)
        names = frozenset[SymbolId]().union(*(atoms(formula) for _, formula in found))
        self.symbols = resolve_all(names, problem)
        self._atoms = frozenset(s.atom for s in self.symbols if isinstance(s, AtomSymbol))
        self._known: dict[tuple[State, GroundAction | None], frozenset[SymbolId]] = {}

    def read(self, state: State, action: GroundAction | None) -> frozenset[SymbolId]:
        """The propositions of the request that are true at an instant."""
        key = (self._atoms & state, action)
        found = self._known.get(key)
        if found is None:
            found = self._known[key] = letter(self.symbols, key[0] | self._static, action)
        return found

    def parts_after(
        self, states: Sequence[State], actions: Sequence[GroundAction | None]
    ) -> tuple[Part, ...]:
        """The conjuncts after instants s0 ... sn, each with the action that led to it."""
        at: _States = tuple(automaton.initial for automaton in self.automata)
        begun = max(self._since, default=0) + 1
        moments = zip(states, actions, strict=True)
        for instant, (state, action) in enumerate(islice(moments, begun)):
            at = self._early(at, instant, state, action)
        # From here on a step depends on nothing but where the automata are and what they read.
        known: dict[tuple[_States, frozenset[SymbolId]], _States] = {}
        for state, action in moments:
            key = (at, self.read(state, action))
            after = known.get(key)
            if after is None:
                after = tuple(a.step(s, key[1]) for a, s in zip(self.automata, at, strict=True))
                known[key] = after
            at = after
        return tuple(Part(a.formula, a, s) for a, s in zip(self.automata, at, strict=True))

    def _early(
        self, at: _States, instant: Instant, state: State, action: GroundAction | None
    ) -> _States:
        """One step while some clause has not begun, or begins."""
        return tuple(
            automaton.step(here, self.read(state, action if since < instant else None))
            if since <= instant
            else here
            for automaton, here, since in zip(self.automata, at, self._since, strict=True)
        )


def letters_of(problem: Problem, clauses: Clauses) -> Letters:
    """The automata of a request; kept, as they grow with what they have read."""
    return _letters(ById(problem), clauses)


@lru_cache(maxsize=8)
def _letters(problem: ById[Problem], clauses: Clauses) -> Letters:
    return Letters(problem.value, clauses)
