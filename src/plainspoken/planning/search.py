"""Strong-cyclic policies from weak plans.

Weak plans are found from one open state after the other, turned into rules that cover other
states too, and closed under all outcomes. States without a weak plan are dead, and so is every
action that may lead to one; if the first state turns out dead, there is no policy. What the rules
say is checked at the end by a fixpoint: states that cannot reach a goal get plans of their own.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from plainspoken.planning.deadends import DeadEnds
from plainspoken.planning.product import ActionIndex, Product, ProductState
from plainspoken.planning.relaxation import Relaxation
from plainspoken.planning.rules import Rule, Rules, goal_bits, regressed
from plainspoken.planning.watch import Watch
from plainspoken.planning.weak import Exhausted, WeakPlan, WeakSearch

MANY_CLOSED = 10_000
"""Past so many states with an action, policies are made smaller as they are made."""
LOCAL_BUDGET = 100
"""Expansions to come back to the way that was planned, before a new plan is made."""
FAR = 1 << 30


@dataclass(frozen=True)
class Found:
    """An action for each reachable state that is not a goal."""

    choice: dict[ProductState, ActionIndex]


@dataclass(frozen=True)
class NoPolicy:
    """Every state that the search met and proved dead."""

    dead: frozenset[ProductState]


@dataclass(frozen=True)
class Interrupted:
    """Time ran out."""

    closed: int
    waiting: int
    dead: int


@dataclass
class StrongCyclicSearch:
    """The search over one product. `run` it once."""

    product: Product
    watch: Watch = field(default_factory=Watch)
    dead: set[ProductState] = field(default_factory=set)

    def __post_init__(self) -> None:
        self._rules = Rules(self.product)
        relaxation = Relaxation(self.product)
        self._weak = WeakSearch(
            self.product,
            relaxation,
            self._is_dead,
            self.dead.add,
            self.watch,
            dead_ends=DeadEnds(self.product, relaxation),
        )
        self._choice: dict[ProductState, ActionIndex] = {}
        self._parents: dict[ProductState, set[ProductState]] = {}
        # Chosen for one state by a plan that avoids what the rules say.
        self._overrides: dict[ProductState, ActionIndex] = {}
        self._open: list[ProductState] = []
        self._hoped: dict[ProductState, Rule] = {}
        self._merging = False

    def run(self) -> Found | NoPolicy | Interrupted:
        """Search until the first state has a policy, or is dead, or time is up."""
        start = self.product.initial
        while True:
            self._open = [start]
            self._choice = {}
            self._parents = {}
            while self._open:
                if self.watch.expired():
                    return self._interrupted()
                self.watch.tell(len(self._choice), len(self._open), len(self.dead))
                self._close(self._open.pop())
                if self._is_dead(start):
                    return NoPolicy(frozenset(self.dead))
                many = max(MANY_CLOSED, 4 * len(self._rules))
                if not self._merging and len(self._choice) > many:
                    # Start again, with the rules kept, and join paths wherever an action can.
                    self._merging = True
                    self._open = [start]
                    self._choice = {}
                    self._parents = {}
            stuck = self._stuck(start)
            if not stuck:
                return Found(self._choice)
            if not self._repair(stuck):
                if self.watch.expired():
                    return self._interrupted()
                if self._is_dead(start):
                    return NoPolicy(frozenset(self.dead))

    def _interrupted(self) -> Interrupted:
        return Interrupted(len(self._choice), len(self._open), len(self.dead))

    def _is_dead(self, state: ProductState) -> bool:
        return state & self.product.rejecting != 0 or state in self.dead

    # -- closing states -------------------------------------------------------------------

    def _close(self, state: ProductState) -> None:
        """Decide on an action for an open state, or that there is none."""
        if self.product.is_goal(state):
            return
        if self._is_dead(state):
            self._reopen_parents(state)
            return
        chosen = self._choice.get(state)
        if chosen is not None and self._adopt(state, chosen):
            return
        self._choice.pop(state, None)
        override = self._overrides.get(state)
        if override is not None and self._adopt(state, override):
            return
        if self._merging and self._merge(state):
            return
        if self._by_rule(state):
            return
        if self._locally(state):
            return
        found = self._weak.plan(state, self._is_covered)
        if isinstance(found, WeakPlan):
            self._learn(found)
            if not self._by_rule(state):
                action = found.path[0][1].action
                self._overrides[state] = action
                if not self._adopt(state, action):
                    self._open.append(state)
        elif isinstance(found, Exhausted):
            self.dead.update(found.states)
            self._reopen_parents(state)
            for each in found.states:
                if each in self._choice:
                    self._reopen_parents(each)
        else:
            self._open.append(state)

    def _locally(self, state: ProductState) -> bool:
        """Come back to where the outcome that was hoped for would have led."""
        hoped = self._hoped.pop(state, None)
        if hoped is None or state & hoped.mask == hoped.mask:
            return False
        mask = hoped.mask
        onward, back = self._weak.estimate(state), self._weak.estimate(state, mask)
        if onward is None or back is None or onward.value <= back.value:
            return False
        found = self._weak.plan(
            state,
            lambda each: each & mask == mask or self._is_covered(each),
            target=mask,
            budget=LOCAL_BUDGET,
        )
        if not isinstance(found, WeakPlan):
            return False
        if self.product.is_goal(found.end) or found.end & mask != mask:
            self._learn(found)
        else:
            for rule in regressed(self.product, mask, found.path, found.end, hoped.distance):
                self._rules.add(rule)
        return self._by_rule(state)

    def _is_covered(self, state: ProductState) -> bool:
        return any(self._weak.allowed(state, r.action) for r in self._rules.matching(state))

    def _by_rule(self, state: ProductState) -> bool:
        return any(self._adopt(state, rule.action) for rule in self._rules.matching(state))

    def _merge(self, state: ProductState) -> bool:
        """Choose an action all of whose outcomes have been decided on, if there is one."""
        product, choice = self.product, self._choice
        for action in self._rules.actions(state):
            after = product.successors(state, action)
            if after and all(s in choice or product.is_goal(s) for s in after):
                return self._adopt(state, action)
        return False

    def _adopt(self, state: ProductState, action: ActionIndex) -> bool:
        """Choose an action, unless one of its outcomes is dead; open the new outcomes."""
        after = self._weak.allowed(state, action)
        if not after:
            return False
        self._choice[state] = action
        if len(after) > 1:
            after = self._ordered(after)
        for successor in after:
            self._parents.setdefault(successor, set()).add(state)
            if successor not in self._choice and not self.product.is_goal(successor):
                self._open.append(successor)
        return True

    def _ordered(self, after: tuple[ProductState, ...]) -> tuple[ProductState, ...]:
        """The outcomes, the one to decide on first last; also notes what was hoped for.

        The nearest to a goal comes first, so that plans for what goes wrong late serve what goes
        wrong early. Where paths are joined it is the farthest: what is nearer may join its path.
        """
        first = {s: rules[0] if (rules := self._rules.matching(s)) else None for s in after}
        nearest = min(
            (rule for rule in first.values() if rule), key=lambda r: r.distance, default=None
        )
        if nearest is not None:
            for state, rule in first.items():
                if rule is None and not self.product.is_goal(state):
                    self._hoped.setdefault(state, nearest)
        distances = {s: rule.distance if rule else FAR for s, rule in first.items()}
        return tuple(sorted(after, key=distances.__getitem__, reverse=not self._merging))

    def _reopen_parents(self, state: ProductState) -> None:
        self._choice.pop(state, None)
        for parent in sorted(self._parents.pop(state, ())):
            if self._choice.pop(parent, None) is not None:
                self._open.append(parent)

    def _learn(self, plan: WeakPlan) -> None:
        """Turn a weak plan into rules."""
        if self.product.is_goal(plan.end):
            mask, distance = goal_bits(self.product, plan.end), 0
        else:
            rule = next(
                rule
                for rule in self._rules.matching(plan.end)
                if self._weak.allowed(plan.end, rule.action)
            )
            mask, distance = rule.mask, rule.distance
        for rule in regressed(self.product, mask, plan.path, plan.end, distance):
            self._rules.add(rule)

    # -- the check at the end -------------------------------------------------------------

    def _stuck(self, start: ProductState) -> list[ProductState]:
        """The states reachable by what was chosen that cannot reach a goal so."""
        before: dict[ProductState, list[ProductState]] = {}
        goals: list[ProductState] = []
        order = [start]
        seen = {start}
        for state in order:
            if self.product.is_goal(state):
                goals.append(state)
            if self.product.is_goal(state) or self._is_dead(state) or state not in self._choice:
                continue
            for successor in self.product.successors(state, self._choice[state]):
                before.setdefault(successor, []).append(state)
                if successor not in seen:
                    seen.add(successor)
                    order.append(successor)
        live = set(goals)
        todo = goals
        while todo:
            for state in before.get(todo.pop(), ()):
                if state not in live:
                    live.add(state)
                    todo.append(state)
        self._choice = {state: self._choice[state] for state in order if state in self._choice}
        # What reaches a goal is left as it is from now on; so each round adds to it.
        self._overrides.update((s, self._choice[s]) for s in live if s in self._choice)
        self._live = live
        return [state for state in order if state not in live]

    def _repair(self, stuck: list[ProductState]) -> bool:
        """Give a stuck state a plan to one that reaches a goal; mark it dead if it has none."""
        live = self._live
        for state in stuck:
            if state in live or self._is_dead(state):
                continue
            found = self._weak.plan(state, live.__contains__)
            if isinstance(found, WeakPlan):
                for passed, step in found.path:
                    self._overrides[passed] = step.action
                    live.add(passed)
            elif isinstance(found, Exhausted):
                self.dead.update(found.states)
                return False
            else:
                return False
        return True


def strong_cyclic_search(
    product: Product, watch: Watch | None = None
) -> Found | NoPolicy | Interrupted:
    """Find a strong-cyclic policy, or prove that there is none."""
    return StrongCyclicSearch(product, watch or Watch()).run()
