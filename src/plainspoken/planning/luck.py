"""Plans that work with luck: found without care for what else may happen, and where they break."""

from __future__ import annotations

from copy import copy

from plainspoken.planning.glance import impossible_at_a_glance
from plainspoken.planning.product import Product, ProductState
from plainspoken.planning.reason import Breach, LuckyWay
from plainspoken.planning.relaxation import Relaxation
from plainspoken.planning.search import NoPolicy, strong_cyclic_search
from plainspoken.planning.watch import Watch
from plainspoken.planning.weak import Exhausted, WeakPlan, WeakSearch


def lucky_plan(product: Product, watch: Watch) -> WeakPlan | Exhausted | None:
    """A way to a goal if every outcome could be chosen, the proof that there is none, or neither.

    The initial state is no goal.
    """
    if impossible_at_a_glance(product, lucky=True):
        return Exhausted(frozenset((product.initial,)))
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
    return found if isinstance(found, (WeakPlan, Exhausted)) else None


def lucky_way(
    product: Product, plan: WeakPlan, dead: frozenset[ProductState], watch: Watch
) -> LuckyWay:
    """The actions of a lucky plan, and the outcome that breaks it.

    dead: states that are known to have no policy
    """
    actions = tuple(product.actions[step.action].name for _, step in plan.path)
    hoped = (*(state for state, _ in plan.path[1:]), plan.end)
    forks = [
        (state, step.action, aim, after)
        for (state, step), aim in zip(plan.path, hoped, strict=True)
        for after in product.successors(state, step.action)
        if after != aim
    ]
    for state, action, aim, after in forks:
        if after in dead or product.is_rejected(after):
            return LuckyWay(actions, _breach(product, state, action, aim, after))
    # The last state of the plan that has no policy has an outcome without one: look from there.
    for state, action, aim, after in reversed(forks):
        if watch.expired():
            break
        from_there = copy(product)
        from_there.initial = after
        if not product.is_goal(after) and isinstance(
            strong_cyclic_search(from_there, watch), NoPolicy
        ):
            return LuckyWay(actions, _breach(product, state, action, aim, after))
    return LuckyWay(actions, None)


def _breach(
    product: Product, state: ProductState, action: int, aim: ProductState, after: ProductState
) -> Breach:
    before, hoped, found = map(product.task.state, (state, aim, after))
    added, deleted = found - before, before - found
    return Breach(
        product.actions[action].name,
        tuple(sorted(added - hoped)),
        tuple(sorted(atom for atom in deleted if atom in hoped)),
    )
