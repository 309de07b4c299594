"""Weak plans: a way to a goal if every outcome were the robot's to choose.

Lazy greedy best-first search with preferred operators (Richter and Helmert, ICAPS 2009) over
single outcomes. Steps of which another outcome is known to be dead are never taken, so a search
that is exhausted proves all that it closed dead.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from heapq import heappop, heappush

from plainspoken.planning.deadends import DeadEnds
from plainspoken.planning.product import Product, ProductState
from plainspoken.planning.relaxation import UNREACHED, Estimate, Relaxation, Step
from plainspoken.planning.task import Bits
from plainspoken.planning.watch import Watch

BOOST = 1000
LONGEST_SHORTENED = 200
"""Plans with more steps are taken as they are: shortening takes quadratic time."""


@dataclass(frozen=True, slots=True)
class WeakPlan:
    """The states passed and the steps taken in them, and the state that it leads to."""

    path: tuple[tuple[ProductState, Step], ...]
    end: ProductState


@dataclass(frozen=True, slots=True)
class Exhausted:
    """There is no weak plan: none of these states has one."""

    states: frozenset[ProductState]


@dataclass(frozen=True, slots=True)
class Spent:
    """The budget ran out; this says nothing."""


class WeakSearch:
    """Searches for weak plans, keeping the estimates of all states met."""

    def __init__(
        self,
        product: Product,
        relaxation: Relaxation,
        is_dead: Callable[[ProductState], bool],
        mark_dead: Callable[[ProductState], None],
        watch: Watch,
        *,
        dead_ends: DeadEnds | None = None,
        careless: bool = False,
    ) -> None:
        """A careless search takes steps of which another outcome is dead."""
        self.product = product
        self._relaxation = relaxation
        self.is_dead = is_dead
        self._mark_dead = mark_dead
        self.watch = watch
        self.careless = careless
        self._dead_ends = dead_ends
        self._estimates: dict[ProductState, Estimate] = {}
        self.expanded = 0

    def estimate(self, state: ProductState, target: Bits = 0) -> Estimate | None:
        """The relaxation's word on a state; a state without one is marked dead.

        With a target in place of the goal, nothing is marked and nothing kept.
        """
        if target:
            return self._relaxation.estimate(state, target)
        found = self._estimates.get(state)
        if found is None:
            found = self._relaxation.estimate(state)
            self.expanded += 1
            if found is None:
                self._mark_dead(state)
                if self._dead_ends is not None and self._dead_ends.learn(state):
                    self._estimates.clear()
            else:
                self._estimates[state] = found
        return found

    def allowed(self, state: ProductState, action: int) -> tuple[ProductState, ...]:
        """The successors by an action; none where it does not apply or one of them is dead."""
        if self._dead_ends is not None and not self._dead_ends.permits(state, action):
            return ()
        after = self.product.successors(state, action)
        return () if any(map(self.is_dead, after)) else after

    def plan(
        self,
        start: ProductState,
        arrived: Callable[[ProductState], bool],
        *,
        target: Bits = 0,
        budget: int | None = None,
    ) -> WeakPlan | Exhausted | Spent:
        """Search from a state for a goal, or one where `arrived` holds; the start is neither.

        target: bits to make for in place of the goal; nothing is proven then
        budget: expansions without progress
        """
        return _Run(self, start, arrived, target, budget).result()


class _Run:
    """One search, from one state."""

    def __init__(
        self,
        search: WeakSearch,
        start: ProductState,
        arrived: Callable[[ProductState], bool],
        target: Bits,
        budget: int | None,
    ) -> None:
        self._search = search
        self._product = search.product
        self._arrived = arrived
        self._target = target
        self._budget = budget
        self._left = budget
        self._start = start
        self._parents: dict[ProductState, tuple[ProductState, Step] | None] = {start: None}
        self._expanded: set[ProductState] = set()
        self._allowed: dict[tuple[ProductState, int], bool] = {}
        # Entries without a step are states that wait to be expanded themselves.
        self._all: list[tuple[int, int, ProductState, Step | None]] = []
        self._preferred: list[tuple[int, int, ProductState, Step | None]] = []
        self._priorities = [0, 0]
        self._serial = 0
        self._best = UNREACHED

    def result(self) -> WeakPlan | Exhausted | Spent:
        if (found := self._expand(self._start)) is not None:
            return found
        while self._all or self._preferred:
            if self._search.watch.expired() or (self._left is not None and self._left <= 0):
                return Spent()
            state, step = self._next()
            if step is not None:
                following = self._follow(state, step)
                if following is None:
                    continue
                if self._ends(following):
                    return self._shortened(following)
                state = following
            elif state in self._expanded:
                continue
            if (found := self._expand(state)) is not None:
                return found
        return Spent() if self._target else Exhausted(frozenset(self._parents))

    def _next(self) -> tuple[ProductState, Step | None]:
        priorities = self._priorities
        first = not self._all or (self._preferred and priorities[1] <= priorities[0])
        priorities[bool(first)] += 1
        _, _, state, step = heappop(self._preferred if first else self._all)
        return state, step

    def _ends(self, state: ProductState) -> bool:
        return self._product.is_goal(state) or self._arrived(state)

    def _follow(self, state: ProductState, step: Step) -> ProductState | None:
        """The state that a step leads to, if it is new and the step may be taken."""
        action = self._product.actions[step.action]
        variant = action.variants[step.variant]
        if not variant.requirement.holds(state):
            return None
        after = self._product.after(state, variant.outcomes[step.outcome], action.symbols)
        if after in self._parents or self._search.is_dead(after):
            return None
        key = (state, step.action)
        allowed = self._allowed.get(key)
        if allowed is None:
            allowed = self._allowed[key] = self._search.careless or bool(
                self._search.allowed(state, step.action)
            )
        if not allowed:
            return None
        self._parents[after] = (state, step)
        return after

    def _expand(self, state: ProductState) -> WeakPlan | None:
        """Queue the steps from a state, and run ahead along its relaxed plan."""
        estimate = self._search.estimate(state, self._target)
        self._expanded.add(state)
        if self._left is not None:
            self._left -= 1
        if estimate is None:
            return None
        value = estimate.value
        if value < self._best:
            if self._best < UNREACHED:
                self._priorities[1] -= BOOST
                self._left = self._budget
            self._best = value
        for step in estimate.preferred:
            self._push(self._preferred, value, state, step)
        actions = self._product.actions
        for action, variant in estimate.applicable:
            for outcome in range(len(actions[action].variants[variant].outcomes)):
                self._push(self._all, value, state, Step(action, variant, outcome))
        return self._run_ahead(state, estimate)

    def _push(
        self,
        queue: list[tuple[int, int, ProductState, Step | None]],
        value: int,
        state: ProductState,
        step: Step | None,
    ) -> None:
        self._serial += 1
        heappush(queue, (value, self._serial, state, step))

    def _run_ahead(self, state: ProductState, estimate: Estimate) -> WeakPlan | None:
        """Take the steps of the relaxed plan that can be taken one after the other.

        Source: Vidal, A lookahead strategy for heuristic search planning, ICAPS 2004.
        """
        waiting = list(estimate.plan)
        value = estimate.value
        moved = True
        while moved and waiting:
            moved = False
            for step in tuple(waiting):
                after = self._follow(state, step)
                if after is None:
                    continue
                if self._ends(after):
                    return self._shortened(after)
                waiting.remove(step)
                value -= 1
                moved = True
                state = after
                self._push(self._all, value, state, None)
        if state != self._start:
            self._push(self._preferred, value - 1, state, None)
        return None

    # -- the plan -------------------------------------------------------------------------

    def _shortened(self, end: ProductState) -> WeakPlan:
        """The way to a state, without steps that it does as well without.

        Source: Nakhost and Müller, Action elimination and plan neighborhood graph search,
        ICAPS 2010.
        """
        plan = self._traced(end)
        if len(plan.path) > LONGEST_SHORTENED:
            return plan
        place = 0
        while place < len(plan.path):
            shorter = self._replayed(plan, place)
            if shorter is None:
                place += 1
            else:
                plan = shorter
        return plan

    def _replayed(self, plan: WeakPlan, without: int) -> WeakPlan | None:
        """The plan without a step, and without those that need it; None where it then fails."""
        state = plan.path[without][0]
        path = list(plan.path[:without])
        for _, step in plan.path[without + 1 :]:
            action = self._product.actions[step.action]
            variant = action.variants[step.variant]
            if not variant.requirement.holds(state):
                continue
            if not (self._search.careless or self._search.allowed(state, step.action)):
                continue
            after = self._product.after(state, variant.outcomes[step.outcome], action.symbols)
            if after == state:
                continue
            path.append((state, step))
            state = after
            if self._ends(state):
                return WeakPlan(tuple(path), state)
        return None

    def _traced(self, end: ProductState) -> WeakPlan:
        path = []
        entry = self._parents[end]
        while entry is not None:
            path.append(entry)
            entry = self._parents[entry[0]]
        return WeakPlan(tuple(reversed(path)), end)
