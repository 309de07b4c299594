"""Deterministic automata of LTLf formulas, built by progression and only where they are asked.

A state is a residual in the normal form of `residual.py`; a step unfolds it (`unfolding.py`).
Conjuncts are kept apart as automata of their own (`automata_for`): their product is explored
only where a planner goes.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

from plainspoken.automata.progression import satisfied_at_end
from plainspoken.automata.residual import DONE, LOST, Residual, Residuals
from plainspoken.automata.unfolding import (
    Algebra,
    Cubes,
    TooManyCubes,
    cubes_of_literal,
    product_of_cubes,
    unfolded,
)
from plainspoken.errors import FormulaTooLargeError
from plainspoken.logic.formula import Formula, atoms, conjuncts, negation_normal_form
from plainspoken.logic.syntax import unparse
from plainspoken.logic.trace import Letter

StateId = int

MOST_GUARDS = 100_000
"""An automaton with more guards is not explored to the end (see `can_accept`)."""


@dataclass(frozen=True, slots=True)
class Guard:
    """The letters with all of `positive` and none of `negative` lead to `target`."""

    positive: frozenset[str]
    negative: frozenset[str]
    target: StateId

    def admits(self, letter: Letter) -> bool:
        return self.positive <= letter and not (self.negative & letter)


class Automaton:
    """The automaton of one formula. `initial` has read nothing, not even s0.

    atoms: the propositions it reads, sorted
    """

    initial: StateId = 0

    def __init__(self, formula: Formula) -> None:
        self.formula = formula
        normal = negation_normal_form(formula)
        self.atoms: tuple[str, ...] = tuple(sorted(atoms(normal)))
        self._reads = frozenset(self.atoms)
        self._residuals = Residuals()
        self._states: list[Residual] = []
        self._numbers: dict[Residual, StateId] = {}
        self._steps: dict[tuple[StateId, Letter], StateId] = {}
        self._guards: dict[StateId, tuple[Guard, ...]] = {}
        self._cubes: dict[Formula, Cubes] = {}
        self._number(self._residuals.of(normal))

    def __len__(self) -> int:
        """How many states have been met so far."""
        return len(self._states)

    def _number(self, residual: Residual) -> StateId:
        number = self._numbers.setdefault(residual, len(self._states))
        if number == len(self._states):
            self._states.append(residual)
        return number

    def step(self, state: StateId, letter: Letter) -> StateId:
        """The state after one more instant; propositions it does not read are ignored."""
        seen = letter & self._reads
        key = (state, seen)
        target = self._steps.get(key)
        if target is None:
            algebra = Algebra(
                literal=lambda name, positive: DONE if (name in seen) == positive else LOST,
                residual=lambda residual: residual,
                meet=self._residuals.meet,
                join=self._residuals.join,
            )
            after = unfolded(self.residual(state), algebra, self._residuals)
            target = self._steps[key] = self._number(after)
        return target

    def accepts(self, state: StateId) -> bool:
        """Whether the trace may end here."""
        return satisfied_at_end(self.residual(state))

    def residual(self, state: StateId) -> Formula:
        """What the state still asks of the instants that are left."""
        return self._residuals.formula(self._states[state])

    def guards(self, state: StateId) -> tuple[Guard, ...]:
        """Where each letter leads, as cubes that are disjoint and cover all letters.

        raises FormulaTooLargeError: when there are more than `unfolding.MOST_CUBES` of them
        """
        if state not in self._guards:
            algebra = Algebra(
                literal=cubes_of_literal,
                residual=lambda residual: ((frozenset(), frozenset(), residual),),
                meet=lambda a, b: product_of_cubes(a, b, LOST, self._residuals.meet),
                join=lambda a, b: product_of_cubes(a, b, DONE, self._residuals.join),
            )
            try:
                cubes = unfolded(self.residual(state), algebra, self._residuals, self._cubes)
            except TooManyCubes:
                raise FormulaTooLargeError(unparse(self.formula)) from None
            self._guards[state] = tuple(
                Guard(positive, negative, self._number(residual))
                for positive, negative, residual in cubes
            )
        return self._guards[state]

    def can_accept(self, state: StateId) -> bool:
        """Whether some way to go on (stopping here is one) satisfies the formula.

        True as well where the automaton is too large to know: a planner may then search in
        vain, but loses nothing.
        """
        accepting = self._fates[0]
        return accepting is None or state in accepting

    def must_accept(self, state: StateId) -> bool:
        """Whether every way to go on satisfies the formula. False where that is not known."""
        rejecting = self._fates[1]
        return rejecting is not None and state not in rejecting

    @cached_property
    def _fates(self) -> tuple[frozenset[StateId] | None, frozenset[StateId] | None]:
        """The states from which an accepting, and from which a rejecting state is reachable."""
        predecessors: dict[StateId, set[StateId]] = {}
        state = met = 0
        # Guards number new states as they meet them; the loop ends when there are none.
        while state < len(self._states):
            try:
                guards = self.guards(state)
            except FormulaTooLargeError:
                return None, None
            met += len(guards)
            if met > MOST_GUARDS:
                return None, None
            for guard in guards:
                predecessors.setdefault(guard.target, set()).add(state)
            state += 1
        accepting = {s for s in range(len(self)) if self.accepts(s)}
        rejecting = set(range(len(self))) - accepting
        return _reaching(accepting, predecessors), _reaching(rejecting, predecessors)


def automata_for(formula: Formula) -> tuple[Automaton, ...]:
    """One automaton for each conjunct; a trace satisfies the formula iff all of them accept."""
    return tuple(map(Automaton, dict.fromkeys(conjuncts(negation_normal_form(formula)))))


def _reaching(
    targets: Iterable[StateId], predecessors: dict[StateId, set[StateId]]
) -> frozenset[StateId]:
    found = set(targets)
    todo = list(found)
    while todo:
        for state in predecessors.get(todo.pop(), ()):
            if state not in found:
                found.add(state)
                todo.append(state)
    return frozenset(found)
