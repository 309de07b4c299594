"""From a planning problem and a formula to a policy, or to how the search ended without one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from plainspoken.logic.formula import Formula
from plainspoken.logic.syntax import unparse
from plainspoken.planning.grounding import grounded
from plainspoken.planning.policy import Policy, PolicyKind, PolicyNode
from plainspoken.planning.product import ActionIndex, Product, ProductState, product_of
from plainspoken.planning.search import Interrupted, NoPolicy, strong_cyclic_search
from plainspoken.planning.strong import strong_search
from plainspoken.planning.unsolvable import Reason, early_reason, late_reason
from plainspoken.planning.watch import Progress, Seconds, Watch
from plainspoken.world.domain import Problem


@dataclass(frozen=True, slots=True)
class Solved:
    """A policy was found; `policy.seconds` says what each stage took."""

    policy: Policy


@dataclass(frozen=True, slots=True)
class Unsolvable:
    """It is proven that there is no policy."""

    reason: Reason


@dataclass(frozen=True, slots=True)
class OutOfTime:
    """The time was spent before there was an answer.

    stage: what was under way: ground, automaton or search
    """

    stage: str
    progress: Progress

    @property
    def sentence(self) -> str:
        at = self.progress
        return (
            f"no answer after {at.seconds:.1f} s, in the stage {self.stage!r}: {at.closed} states "
            f"have an action, {at.waiting} wait for one, {at.dead} are dead ends"
        )


Ending = Solved | Unsolvable | OutOfTime


def solve(
    problem: Problem,
    goal: Formula,
    *,
    strong: bool = False,
    timeout: Seconds | None = None,
    on_progress: Callable[[Progress], None] | None = None,
) -> Ending:
    """Find a policy whose every way to stop satisfies the formula.

    strong: reach the end within a bound whatever happens; else (strong-cyclic) whenever no
            outcome is avoided for ever
    raises UnknownSymbolError: when the formula names what the problem does not have
    """
    watch = Watch(timeout, on_progress)
    seconds: dict[str, Seconds] = {}

    def lap(stage: str) -> None:
        seconds[stage] = watch.seconds - sum(seconds.values())

    grounding = grounded(problem)
    lap("ground")
    if watch.expired():
        return OutOfTime("ground", watch.progress(0, 0, 0))
    product = product_of(problem, goal, grounding)
    lap("automaton")
    reason = early_reason(product, goal)
    if reason is not None:
        return Unsolvable(reason)
    search = strong_search if strong else strong_cyclic_search
    found = search(product, watch)
    lap("search")
    if isinstance(found, Interrupted):
        return OutOfTime("search", watch.progress(found.closed, found.waiting, found.dead))
    if isinstance(found, NoPolicy):
        return Unsolvable(late_reason(product, goal, found.dead, strong=strong, watch=watch))
    seconds["total"] = sum(seconds.values())
    kind: PolicyKind = "strong" if strong else "strong-cyclic"
    return Solved(policy_of(product, found.choice, kind, unparse(goal), seconds))


def policy_of(
    product: Product,
    choice: dict[ProductState, ActionIndex],
    kind: PolicyKind,
    goal: str,
    seconds: dict[str, Seconds],
) -> Policy:
    """The part of a choice of actions that is reachable, as a policy."""
    numbers = {product.initial: 0}
    order = [product.initial]
    nodes = []
    for state in order:
        world = product.task.state(state)
        if product.is_goal(state):
            nodes.append(PolicyNode(numbers[state], world, None))
            continue
        action = choice[state]
        after = product.successors(state, action)
        for successor in after:
            if successor not in numbers:
                numbers[successor] = len(numbers)
                order.append(successor)
        successors = tuple(numbers[successor] for successor in after)
        name = product.actions[action].name
        nodes.append(PolicyNode(numbers[state], world, name, successors))
    return Policy(kind, goal, 0, product.task.static, tuple(nodes), seconds)
