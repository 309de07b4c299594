"""Strong policies: a goal within a bounded number of steps, whatever happens.

A strong policy is a strong-cyclic one without cycles; so that search goes first, and where it
fails, or finds no cycle, its answer stands. Otherwise states are expanded, its policy's first,
then best first, and a backward fixpoint over what has been expanded asks, each time it has
doubled, whether that is enough. When all is expanded, the answer is final.
"""

from __future__ import annotations

from collections import deque
from heapq import heappop, heappush

from plainspoken.planning.fixpoint import Space, strong_choice
from plainspoken.planning.product import ActionIndex, Product, ProductState
from plainspoken.planning.relaxation import Relaxation
from plainspoken.planning.search import Found, Interrupted, NoPolicy, strong_cyclic_search
from plainspoken.planning.watch import Watch

FIRST_BATCH = 64


def strong_search(product: Product, watch: Watch | None = None) -> Found | NoPolicy | Interrupted:
    """Find a strong policy, or prove that there is none."""
    watch = watch or Watch()
    cyclic = strong_cyclic_search(product, watch)
    if not isinstance(cyclic, Found) or _is_acyclic(product, cyclic.choice):
        return cyclic
    expansion = _Expansion(product, tuple(cyclic.choice))
    batch = max(FIRST_BATCH, 2 * len(cyclic.choice))
    while True:
        while expansion.oldest and len(expansion.expanded) < batch:
            if watch.expired():
                return Interrupted(*expansion.size)
            expansion.grow()
        watch.tell(*expansion.size)
        chosen = strong_choice(expansion.space())
        if product.initial in chosen:
            return Found(chosen)
        if not expansion.oldest:
            return NoPolicy(frozenset(expansion.choices) - chosen.keys() - expansion.goals)
        batch = 2 * len(expansion.expanded)


class _Expansion:
    """The part of the product that has been expanded, and the states that wait for it.

    first: states to expand before all others
    """

    def __init__(self, product: Product, first: tuple[ProductState, ...]) -> None:
        self._product = product
        self._relaxation = Relaxation(product)
        self._nearest: list[tuple[int, int, ProductState]] = []
        self.choices: dict[ProductState, dict[ActionIndex, tuple[ProductState, ...]]] = {}
        self.goals: set[ProductState] = set()
        self.oldest: deque[ProductState] = deque()
        self.expanded: set[ProductState] = set()
        self._dead = 0
        for state in (product.initial, *first):
            self._meet(state)

    @property
    def size(self) -> tuple[int, int, int]:
        """States expanded, states that wait for it, dead ends."""
        return len(self.expanded), len(self.oldest), self._dead

    def space(self) -> Space[ProductState, ActionIndex]:
        return Space(self._product.initial, self.choices, frozenset(self.goals))

    def grow(self) -> None:
        """Expand one more state."""
        # Every other state is the oldest: bad outcomes look far, and have to be closed too.
        if self._nearest and len(self.expanded) % 2:
            state = heappop(self._nearest)[2]
        else:
            state = self.oldest.popleft()
        if state in self.expanded:
            return
        self.expanded.add(state)
        for action in range(len(self._product.actions)):
            after = self._product.successors(state, action)
            if after:
                self.choices[state][action] = after
                for successor in after:
                    self._meet(successor)

    def _meet(self, state: ProductState) -> None:
        """Put a new state in both queues, unless it is an end."""
        if state in self.choices:
            return
        self.choices[state] = {}
        if self._product.is_goal(state):
            self.goals.add(state)
            return
        rejected = self._product.is_rejected(state)
        estimate = None if rejected else self._relaxation.estimate(state)
        if estimate is None:
            self._dead += 1
            return
        heappush(self._nearest, (estimate.value, len(self.choices), state))
        self.oldest.append(state)


def _is_acyclic(product: Product, choice: dict[ProductState, ActionIndex]) -> bool:
    """Whether no state that is reachable by the choice can be reached again."""
    arrows: dict[ProductState, int] = {product.initial: 0}
    order = [product.initial]
    for state in order:
        for after in product.successors(state, choice[state]) if state in choice else ():
            if after not in arrows:
                arrows[after] = 0
                order.append(after)
            arrows[after] += 1
    if arrows[product.initial]:
        return False
    free = [product.initial]
    for state in free:
        for after in product.successors(state, choice[state]) if state in choice else ():
            arrows[after] -= 1
            if arrows[after] == 0:
                free.append(after)
    return len(free) == len(order)
