"""From a planning problem and a formula to a policy, or to how the search ended without one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from plainspoken.logic.formula import Formula
from plainspoken.logic.syntax import unparse
from plainspoken.planning.grounding import grounded
from plainspoken.planning.luck import lucky_plan
from plainspoken.planning.policy import Gap, Policy, PolicyKind, PolicyNode
from plainspoken.planning.product import ActionIndex, Product, ProductState, product_of
from plainspoken.planning.reason import Reason
from plainspoken.planning.search import Interrupted, NoPolicy, strong_cyclic_search
from plainspoken.planning.strong import strong_search
from plainspoken.planning.unsolvable import is_plainly_impossible, reason_why_not
from plainspoken.planning.watch import Progress, Seconds, TimeIsUp, Watch
from plainspoken.planning.weak import WeakPlan
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
    lucky: bool = False,
    timeout: Seconds | None = None,
    on_progress: Callable[[Progress], None] | None = None,
) -> Ending:
    """Find a policy whose every way to stop satisfies the formula.

    strong: reach the end within a bound whatever happens; else (strong-cyclic) whenever no
            outcome is avoided for ever
    lucky:  where there is no such policy, take a weak one, which has gaps: outcomes that it has
            no answer to
    raises UnknownSymbolError: when the formula names what the problem does not have
    """
    watch = Watch(timeout, on_progress)
    seconds: dict[str, Seconds] = {}

    def lap(stage: str) -> None:
        seconds[stage] = watch.seconds - sum(seconds.values())

    search = strong_search if strong else strong_cyclic_search
    try:
        grounding = grounded(problem, watch.check)
        watch.check()
        lap("ground")
        product = product_of(problem, goal, grounding, watch.check)
        lap("automaton")
    except TimeIsUp:
        return OutOfTime("automaton" if seconds else "ground", watch.progress(0, 0, 0))
    found = NoPolicy(frozenset()) if is_plainly_impossible(product) else search(product, watch)
    lap("search")
    if isinstance(found, Interrupted):
        return OutOfTime("search", watch.progress(found.closed, found.waiting, found.dead))
    if isinstance(found, NoPolicy):
        plan = lucky_plan(product, Watch(watch.left)) if lucky else None
        if isinstance(plan, WeakPlan):
            lap("luck")
            seconds["total"] = sum(seconds.values())
            return Solved(weak_policy_of(product, plan, unparse(goal), seconds))
        return Unsolvable(
            reason_why_not(
                product, goal, grounding, strong=strong, timeout=watch.left, dead=found.dead
            )
        )
    seconds["total"] = sum(seconds.values())
    kind: PolicyKind = "strong" if strong else "strong-cyclic"
    return Solved(policy_of(product, found.choice, kind, unparse(goal), seconds))


def weak_policy_of(
    product: Product, plan: WeakPlan, goal: str, seconds: dict[str, Seconds]
) -> Policy:
    """A weak plan as a policy; an outcome that leads back to the plan is no gap."""
    states = list(dict.fromkeys([*(state for state, _ in plan.path), plan.end]))
    numbers = {state: number for number, state in enumerate(states)}
    actions = {state: step.action for state, step in plan.path}
    nodes, gaps = [], []
    for state, number in numbers.items():
        world = product.task.state(state)
        if state == plan.end:
            nodes.append(PolicyNode(number, world, None))
            continue
        after = product.successors(state, actions[state])
        covered = tuple(numbers[each] for each in after if each in numbers)
        name = product.actions[actions[state]].name
        nodes.append(PolicyNode(number, world, name, covered))
        gaps += [Gap(number, product.task.state(each)) for each in after if each not in numbers]
    static = product.task.static
    return Policy("weak", goal, 0, static, tuple(nodes), seconds, tuple(gaps))


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
