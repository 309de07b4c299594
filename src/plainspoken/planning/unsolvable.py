"""Finds out why there is no policy, in terms of the parts of what was asked."""

from __future__ import annotations

from dataclasses import dataclass, field

from plainspoken.automata.construction import Automaton, automata_for
from plainspoken.logic.formula import Formula, conjuncts
from plainspoken.logic.pattern import Pattern
from plainspoken.logic.recognition import recognised
from plainspoken.planning.culprit import Culprits, contradict, culprits
from plainspoken.planning.glance import impossible_at_a_glance
from plainspoken.planning.goal import denoted, simplified
from plainspoken.planning.grounding import Grounding
from plainspoken.planning.luck import lucky_plan, lucky_way
from plainspoken.planning.product import Product, ProductState, product_of, read_negatively
from plainspoken.planning.reason import (
    Contradiction,
    NeverFalse,
    NeverTrue,
    NoGuarantee,
    OnlyByRetrying,
    Reason,
    ViolatedAtStart,
)
from plainspoken.planning.search import Found, NoPolicy, strong_cyclic_search
from plainspoken.planning.strong import strong_search
from plainspoken.planning.task import compiled
from plainspoken.planning.watch import Seconds, Watch
from plainspoken.planning.weak import Exhausted, WeakPlan

EXPLAINING: Seconds = 3.0
"""An explanation takes no longer than this, and no longer than the caller's time allows."""


def parts_of(goal: Formula) -> tuple[Formula, ...]:
    """What a goal asks for, a pattern of several conjuncts being one part."""
    asked = set(conjuncts(goal))
    found: list[Formula] = []
    for each in recognised(goal):
        if not isinstance(each, Pattern):
            found.append(each)
        elif asked.issuperset(conjuncts(each.executable)):
            found.append(each.executable)
        else:
            found.append(each.literal)
    return tuple(dict.fromkeys(found))


def is_plainly_impossible(product: Product) -> bool:
    """Whether there is no policy, as far as that shows without a search."""
    return impossible_at_a_glance(product)


@dataclass
class Inquiry:
    """Asks why a product has no policy, which has been proven.

    dead: states known to have no policy, where a search has met some
    """

    product: Product
    goal: Formula
    grounding: Grounding
    strong: bool
    timeout: Seconds | None
    dead: frozenset[ProductState] = frozenset()
    _verdicts: dict[tuple[int, ...], bool | None] = field(default_factory=dict)

    def reason(self) -> Reason:
        if self.product.is_rejected(self.product.initial):
            return self._at_the_start()
        self._begin()
        if self._contradict_in_logic(tuple(range(len(self._parts)))):
            named = culprits(len(self._parts), self._contradict_in_logic)
            return Contradiction(self._named(named), named.minimal)
        # Half of the time is for what is in the way, the rest for what luck could do.
        named = culprits(len(self._parts), self._impossible)
        found = self._named(named)
        if named.minimal and self._contradict_in_logic(named.parts):
            return Contradiction(found)
        if self.strong and self._is_cyclic():
            return OnlyByRetrying(found, named.minimal)
        return self._with_luck(named)

    def _begin(self) -> None:
        limit = EXPLAINING if self.timeout is None else min(EXPLAINING, self.timeout)
        self._watch = Watch(limit)
        self._half = Watch(limit / 2)
        self._parts = parts_of(self.goal)
        constants = self.product.task.constants
        self._logic = tuple(automata_for(part) for part in self._parts)
        self._automata = tuple(automata_for(simplified(part, constants)) for part in self._parts)
        negative = read_negatively([a for automata in self._automata for a in automata])
        task = self.product.task
        if any(
            task.world >> task.reads[name] & 1 and task.reads[name] not in task.complements
            for name in negative
        ):
            task = compiled(self.grounding, self.goal, negative)
        self._task = task

    def _named(self, found: Culprits) -> tuple[Formula, ...]:
        return tuple(self._parts[part] for part in found.parts)

    # -- at the start ---------------------------------------------------------------------

    def _at_the_start(self) -> Reason:
        """One part alone is violated by what is true in the initial state, or never changes."""
        for part in conjuncts(self.goal):
            if contradict(automata_for(part)):
                return Contradiction((part,))
        constants = self.product.task.constants
        for part in conjuncts(self.goal):
            alone = product_of(self.product.task.problem, part, self.grounding)
            if not alone.is_rejected(alone.initial):
                continue
            names = [name for name in alone.task.constants if name in constants]
            if names and contradict(alone.automata):
                false = [name for name in names if not constants[name]]
                problem = self.product.task.problem
                symbols = tuple(denoted(name, problem) for name in false or names)
                return NeverTrue(symbols, part) if false else NeverFalse(symbols, part)
            return ViolatedAtStart(part)
        return ViolatedAtStart(self.goal)

    # -- what is in the way ---------------------------------------------------------------

    def _together(
        self, parts: tuple[int, ...], of: tuple[tuple[Automaton, ...], ...]
    ) -> tuple[Automaton, ...]:
        return tuple(automaton for part in parts for automaton in of[part])

    def _contradict_in_logic(self, parts: tuple[int, ...]) -> bool | None:
        return contradict(self._together(parts, self._logic))

    def _product(self, parts: tuple[int, ...]) -> Product:
        return Product(self._task, self._together(parts, self._automata))

    def _impossible(self, parts: tuple[int, ...]) -> bool | None:
        """Whether some parts alone have no policy."""
        if parts not in self._verdicts:
            self._verdicts[parts] = self._judged(parts)
        return self._verdicts[parts]

    def _judged(self, parts: tuple[int, ...]) -> bool | None:
        left = self._half.left
        if left is not None and left <= 0:
            return None
        product = self._product(parts)
        if impossible_at_a_glance(product):
            return True
        watch = Watch(None if left is None else max(left / 3, 0.05))
        search = strong_search if self.strong else strong_cyclic_search
        found = search(product, watch)
        return isinstance(found, NoPolicy) if isinstance(found, (NoPolicy, Found)) else None

    # -- luck -----------------------------------------------------------------------------

    def _is_cyclic(self) -> bool:
        return not impossible_at_a_glance(self.product) and isinstance(
            strong_cyclic_search(self.product, self._watch), Found
        )

    def _with_luck(self, named: Culprits) -> Reason:
        found = self._named(named)
        whole = len(found) == len(self._parts)
        plan = lucky_plan(self.product, self._watch)
        if isinstance(plan, WeakPlan):
            way = lucky_way(self.product, plan, self.dead, self._watch)
            return NoGuarantee(found, named.minimal, whole, lucky=True, way=way)
        lucky: bool | None = None if plan is None else False
        if lucky is False and not whole:
            alone = lucky_plan(self._product(named.parts), self._watch)
            lucky = None if alone is None else isinstance(alone, WeakPlan)
        elif lucky is None and not whole:
            alone = lucky_plan(self._product(named.parts), self._watch)
            lucky = False if isinstance(alone, Exhausted) else None
        never = isinstance(plan, Exhausted)
        return NoGuarantee(found, named.minimal, whole, lucky=lucky, never=never)


def reason_why_not(
    product: Product,
    goal: Formula,
    grounding: Grounding,
    *,
    strong: bool,
    timeout: Seconds | None,
    dead: frozenset[ProductState] = frozenset(),
) -> Reason:
    """Why a goal that is proven to have no policy has none.

    timeout: what is left of the caller's time
    """
    return Inquiry(product, goal, grounding, strong, timeout, dead).reason()
