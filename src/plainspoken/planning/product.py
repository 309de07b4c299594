"""The product of a ground task and the automata of its goal, taken step by step.

A product state is an int: the bits of the task, and above them, one-hot, a bit for each state
of each automaton. Every action is one instant, so an action that changes nothing in the world
still moves the automata; and the product's first state has read the letter of s0.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from plainspoken.automata.construction import Automaton, automata_for
from plainspoken.logic.formula import Formula
from plainspoken.planning.goal import simplified
from plainspoken.planning.grounding import Grounding, grounded
from plainspoken.planning.task import (
    Bits,
    Outcome,
    Task,
    TaskAction,
    compiled,
    constants_of,
    ones,
)
from plainspoken.world.domain import Problem
from plainspoken.world.symbol import SymbolId

ProductState = int
ActionIndex = int

MOST_EXPLORED = 2_000
"""An automaton with more states than this is explored only along the search."""


@dataclass(frozen=True, slots=True)
class Transition:
    """From one automaton bit to another, under letters that have `positive`, not `negative`."""

    source: int
    positive: Bits
    negative: Bits
    target: int


class Product:
    """States, steps and endings of the search space.

    accepting: for each automaton, the bits of its accepting states
    explored:  for each automaton, whether all its states have bits already
    rejecting: the bits of automaton states from which nothing accepts
    """

    def __init__(self, task: Task, automata: Sequence[Automaton]) -> None:
        self.task = task
        self.automata = tuple(automata)
        self.actions: tuple[TaskAction, ...] = task.actions
        self.accepting: list[Bits] = [0] * len(self.automata)
        self.rejecting: Bits = 0
        self.width = task.width
        self._bits: dict[tuple[int, int], int] = {}
        self._owners: list[tuple[int, int]] = []
        self._transitions: dict[int, tuple[Transition, ...]] = {}
        self._letters = sum(1 << bit for bit in task.reads.values())
        self._key = self._letters | ~((1 << task.width) - 1)
        self._moves: dict[Bits, Bits] = {}
        self.explored = tuple(self._explore(i) for i in range(len(self.automata)))
        start = sum(1 << self._bit(i, a.initial) for i, a in enumerate(self.automata))
        self.initial: ProductState = task.initial | self._moved(
            (task.initial & self._letters) | start
        )

    # -- automata -------------------------------------------------------------------------

    def _bit(self, index: int, state: int) -> int:
        """The bit of an automaton's state, given out when it is met."""
        bit = self._bits.get((index, state))
        if bit is None:
            bit = self._bits[index, state] = self.width
            self._owners.append((index, state))
            self.width += 1
            automaton = self.automata[index]
            if automaton.accepts(state):
                self.accepting[index] |= 1 << bit
            if not automaton.can_accept(state):
                self.rejecting |= 1 << bit
        return bit

    def _explore(self, index: int) -> bool:
        automaton = self.automata[index]
        todo = [self._bit(index, automaton.initial)]
        seen = set(todo)
        while todo:
            if len(seen) > MOST_EXPLORED:
                return False
            for transition in self.transitions(todo.pop()):
                if transition.target not in seen:
                    seen.add(transition.target)
                    todo.append(transition.target)
        return True

    def is_explored(self, bit: int) -> bool:
        """Whether all states that can be reached from an automaton's state have bits already."""
        return self.explored[self._owners[bit - self.task.width][0]]

    def transitions(self, bit: int) -> tuple[Transition, ...]:
        """Where each letter leads from an automaton's state."""
        found = self._transitions.get(bit)
        if found is None:
            index, state = self._owners[bit - self.task.width]
            reads = self.task.reads
            found = self._transitions[bit] = tuple(
                Transition(
                    bit,
                    sum(1 << reads[name] for name in guard.positive),
                    sum(1 << reads[name] for name in guard.negative),
                    self._bit(index, guard.target),
                )
                for guard in self.automata[index].guards(state)
            )
        return found

    def taken(self, bit: int, letter: Bits) -> Transition:
        """The transition that a letter takes."""
        for transition in self.transitions(bit):
            if letter & transition.positive == transition.positive and not (
                letter & transition.negative
            ):
                return transition
        raise AssertionError("the guards of an automaton cover all letters")

    def _moved(self, key: Bits) -> Bits:
        """The automata's bits after a letter, both given in one int."""
        moved = self._moves.get(key)
        if moved is None:
            memory = key >> self.task.width << self.task.width
            moved = sum(1 << self.taken(bit, key).target for bit in ones(memory))
            self._moves[key] = moved
        return moved

    # -- steps ----------------------------------------------------------------------------

    def after(self, state: ProductState, outcome: Outcome, symbols: Bits) -> ProductState:
        """The state after an outcome of an action with these action symbols."""
        if outcome.changes:
            world = self.task.after(state, outcome)
        else:
            world = (state & ~outcome.delete) | outcome.add
        key = (world & self._key) | symbols
        moved = self._moves.get(key)
        if moved is None:
            moved = self._moved(key)
        return (world & self.task.world) | moved

    def applicable(self, state: ProductState, action: ActionIndex) -> bool:
        return any(v.requirement.holds(state) for v in self.actions[action].variants)

    def successors(self, state: ProductState, action: ActionIndex) -> tuple[ProductState, ...]:
        """The states that an action can lead to, each once; none where it is not applicable."""
        chosen = self.actions[action]
        found = [
            self.after(state, outcome, chosen.symbols)
            for variant in chosen.variants
            if variant.requirement.holds(state)
            for outcome in variant.outcomes
        ]
        return tuple(dict.fromkeys(found)) if len(found) > 1 else tuple(found)

    def is_goal(self, state: ProductState) -> bool:
        """Whether the formula is satisfied if the trace ends here."""
        return all(map(state.__and__, self.accepting))

    def is_rejected(self, state: ProductState) -> bool:
        """Whether the formula is violated, however the trace goes on."""
        return state & self.rejecting != 0


def product_of(
    problem: Problem,
    goal: Formula,
    grounding: Grounding | None = None,
    check: Callable[[], None] = lambda: None,
) -> Product:
    """Ground a problem and build its product with the automata of a formula.

    check: called again and again; what it raises ends the building
    raises UnknownSymbolError: when the formula names what the problem does not have
    """
    grounding = grounding or grounded(problem, check)
    automata = automata_for(simplified(goal, constants_of(grounding, goal)))
    task = compiled(grounding, goal, read_negatively(automata), check)
    return Product(task, automata)


def read_negatively(automata: Sequence[Automaton]) -> frozenset[SymbolId]:
    """The atoms that some guard between two states wants false."""
    names: set[SymbolId] = set()
    for automaton in automata:
        todo = [automaton.initial]
        seen = set(todo)
        while todo and len(seen) <= MOST_EXPLORED:
            state = todo.pop()
            for guard in automaton.guards(state):
                if guard.target != state and automaton.can_accept(guard.target):
                    names |= guard.negative
                if guard.target not in seen:
                    seen.add(guard.target)
                    todo.append(guard.target)
    return frozenset(names)
