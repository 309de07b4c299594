"""Why there is no policy, as values with a sentence a person understands."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from plainspoken.automata.construction import Automaton, Guard, automata_for
from plainspoken.logic.formula import Formula, conjuncts
from plainspoken.logic.syntax import unparse
from plainspoken.planning.product import Product, ProductState, product_of
from plainspoken.planning.relaxation import Relaxation
from plainspoken.planning.search import NoPolicy, strong_cyclic_search
from plainspoken.planning.strong import strong_search
from plainspoken.planning.watch import Watch
from plainspoken.planning.weak import WeakPlan, WeakSearch
from plainspoken.world.domain import GroundAction, GroundAtom
from plainspoken.world.symbol import SymbolId

MOST_JOINT_STATES = 5_000
"""Beyond this many states a contradiction between conjuncts is not looked for."""


@dataclass(frozen=True, slots=True)
class Contradiction:
    """No trace at all satisfies these conjuncts together."""

    parts: tuple[Formula, ...]

    @property
    def sentence(self) -> str:
        if len(self.parts) == 1:
            return f"nothing that can happen satisfies {unparse(self.parts[0])}"
        shown = ", ".join(map(unparse, self.parts))
        return f"these contradict each other, whatever happens: {shown}"


@dataclass(frozen=True, slots=True)
class ViolatedAtStart:
    """The initial state alone violates a conjunct for good."""

    part: Formula

    @property
    def sentence(self) -> str:
        return f"it is too late for {unparse(self.part)}: the initial state violates it"


@dataclass(frozen=True, slots=True)
class NeverTrue:
    """The formula would need symbols to become true that never can."""

    symbols: tuple[SymbolId, ...]
    part: Formula

    @property
    def sentence(self) -> str:
        what = " and ".join(self.symbols)
        return f"{what} can never become true, and {unparse(self.part)} needs it"


@dataclass(frozen=True, slots=True)
class NeverFalse:
    """The formula would need symbols to become false that never can."""

    symbols: tuple[SymbolId, ...]
    part: Formula

    @property
    def sentence(self) -> str:
        what = " and ".join(self.symbols)
        return f"{what} can never become false, and {unparse(self.part)} needs it"


@dataclass(frozen=True, slots=True)
class PartImpossible:
    """One conjunct has no policy, even alone."""

    part: Formula

    @property
    def sentence(self) -> str:
        return f"{unparse(self.part)} cannot be guaranteed, even alone"


@dataclass(frozen=True, slots=True)
class NoGuarantee:
    """Every way can be broken by what happens.

    lucky:  the actions of a way that works with luck; None where not even luck helps
    action: one of them that may go wrong for good, and `change` what happens then
    """

    lucky: tuple[GroundAction, ...] | None
    action: GroundAction | None = None
    change: tuple[GroundAtom, ...] = ()

    @property
    def sentence(self) -> str:
        if self.lucky is None:
            return "no sequence of actions satisfies the formula, not even with luck"
        way = ", ".join(self.lucky[:6]) + (", ..." if len(self.lucky) > 6 else "")
        text = f"no way works whatever happens; with luck this one does: {way}"
        if self.action is None:
            return text
        outcome = ", ".join(self.change) or "nothing changes"
        return f"{text}; but {self.action} may go wrong for good ({outcome})"


Reason = Contradiction | ViolatedAtStart | NeverTrue | NeverFalse | PartImpossible | NoGuarantee


def early_reason(product: Product, goal: Formula) -> Reason | None:
    """A reason that needs no search: from the formula, the initial state, what never changes."""
    if not product.is_rejected(product.initial):
        return Contradiction(conjuncts(goal)) if _contradict(product.automata) else None
    for part in conjuncts(goal):
        if not _satisfiable(automata_for(part)):
            return Contradiction((part,))
    constants = product.task.constants
    for part in conjuncts(goal):
        alone = product_of(product.task.problem, part)
        if not alone.is_rejected(alone.initial):
            continue
        names = [name for name in alone.task.constants if name in constants]
        if names and not _satisfiable(alone.automata):
            false = tuple(name for name in names if not constants[name])
            if false:
                return NeverTrue(false, part)
            return NeverFalse(tuple(names), part)
        return ViolatedAtStart(part)
    return ViolatedAtStart(goal)


def late_reason(
    product: Product,
    goal: Formula,
    dead: frozenset[ProductState],
    *,
    strong: bool,
    watch: Watch,
) -> Reason:
    """A reason for what the search proved: a conjunct alone, or luck and what breaks it."""
    parts = conjuncts(goal)
    if len(parts) > 1:
        for part in parts:
            if watch.expired():
                break
            alone = product_of(product.task.problem, part)
            ending = strong_search(alone, watch) if strong else strong_cyclic_search(alone, watch)
            if isinstance(ending, NoPolicy):
                return PartImpossible(part)
    hopeless: set[ProductState] = set()
    search = WeakSearch(
        product,
        Relaxation(product),
        lambda state: product.is_rejected(state) or state in hopeless,
        hopeless.add,
        watch,
        careless=True,
    )
    found = search.plan(product.initial, lambda _: False)
    if not isinstance(found, WeakPlan):
        return NoGuarantee(None)
    lucky = tuple(product.actions[step.action].name for _, step in found.path)
    for state, step in found.path:
        for after in product.successors(state, step.action):
            if after in dead or product.is_rejected(after):
                change = _change(product, state, after)
                return NoGuarantee(lucky, product.actions[step.action].name, change)
    return NoGuarantee(lucky)


def _change(product: Product, before: ProductState, after: ProductState) -> tuple[str, ...]:
    old, new = product.task.state(before), product.task.state(after)
    return (*sorted(new - old), *(f"not {atom}" for atom in sorted(old - new)))


def _satisfiable(automata: Sequence[Automaton]) -> bool:
    return all(a.can_accept(a.initial) for a in automata) and not _contradict(automata)


def _contradict(automata: Sequence[Automaton]) -> bool:
    """Whether automata accept no trace together; False where that is not known."""
    if len(automata) < 2:
        return False
    start = tuple(a.initial for a in automata)
    seen = {start}
    todo = [start]
    while todo:
        targets = _joint(automata, todo.pop())
        if targets is None or len(seen) > MOST_JOINT_STATES:
            return False
        for after in targets:
            # Not only where it is new: a first letter may lead back to the start.
            if all(a.accepts(s) for a, s in zip(automata, after, strict=True)):
                return False
            if after not in seen:
                seen.add(after)
                todo.append(after)
    return True


def _joint(
    automata: Sequence[Automaton], states: tuple[int, ...]
) -> set[tuple[int, ...]] | None:
    """Where a letter can lead all automata at once; None where there are too many ways."""
    partial: dict[tuple[frozenset[str], frozenset[str], tuple[int, ...]], None]
    partial = {(frozenset(), frozenset(), ()): None}
    for automaton, state in zip(automata, states, strict=True):
        guards: list[Guard] = [g for g in automaton.guards(state) if automaton.can_accept(g.target)]
        partial = {
            (yes | g.positive, no | g.negative, (*after, g.target)): None
            for yes, no, after in partial
            for g in guards
            if not (yes & g.negative or no & g.positive)
        }
        if len(partial) > MOST_JOINT_STATES:
            return None
    return {after for _, _, after in partial}
