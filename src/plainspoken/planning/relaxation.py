"""The delete relaxation of the product: how far a goal is if nothing is ever undone.

Facts are the bits of product states, one more for each choice in a test and for each automaton
that accepts, and one for the goal. Outcomes are operators of cost 1; transitions of automata and
the ways to meet a choice are operators of cost 0. The value of a state is the length of the
relaxed plan read off the h_add supporters (Hoffmann and Nebel, JAIR 2001; Keyder and Geffner,
ECAI 2008); a state whose relaxation does not reach the goal has no plan at all.
"""

from __future__ import annotations

from dataclasses import dataclass
from heapq import heappop, heappush

from plainspoken.planning.closure import Closure
from plainspoken.planning.product import ActionIndex, Product, ProductState
from plainspoken.planning.task import Bits, Choice, Requirement, Variant, ones

FactIndex = int
UNREACHED = 1 << 40
SATURATED = 1 << 20
"""h_add doubles along chains; a cost is never more than this, so that none is 'unreached'."""


@dataclass(frozen=True, slots=True)
class Step:
    """An outcome of an action: which variant of it, and which of that variant's outcomes."""

    action: ActionIndex
    variant: int
    outcome: int


@dataclass(frozen=True, slots=True)
class Estimate:
    """What the relaxation says of a state from which it reaches the goal.

    value:      the number of outcomes in the relaxed plan
    preferred:  the steps of it that can be taken now
    applicable: the actions whose tests hold now, with the variant
    plan:       the relaxed plan, nearest steps first
    """

    value: int
    preferred: tuple[Step, ...]
    applicable: tuple[tuple[ActionIndex, int], ...]
    plan: tuple[Step, ...]


class Relaxation:
    """The relaxed operators of a product, and estimates from them."""

    def __init__(self, product: Product) -> None:
        self._product = product
        self.width = self._facts = product.width
        # Automata too large to explore get bits as the search meets their states; the relaxation
        # knows none of them, and takes what they ask for as met.
        self._known = (1 << self.width) - 1
        self._conditions: list[list[FactIndex]] = []
        self._adds: list[tuple[tuple[FactIndex, int], ...]] = []
        self._costs: list[int] = []
        self._entries: list[tuple[ActionIndex, int] | None] = []
        self._operator_of: list[int] = []
        self._steps: list[Step | None] = []
        self._choices: dict[Choice, FactIndex] = {}
        self._variants: dict[tuple[ActionIndex, int], list[int]] = {}
        for index, action in enumerate(product.actions):
            for place, variant in enumerate(action.variants):
                self._add_variant(index, place, variant, action.symbols)
        self._add_automata()
        self._aim_fact = self._fact()
        self._aiming = self._operator([], 0, None)
        self._adds[self._aiming] = ((self._aim_fact, self._supporter(self._aiming, None)),)
        self._finish()

    # -- operators ------------------------------------------------------------------------

    def _fact(self) -> FactIndex:
        self._facts += 1
        return self._facts - 1

    def _supporter(self, operator: int, step: Step | None) -> int:
        self._operator_of.append(operator)
        self._steps.append(step)
        return len(self._steps) - 1

    def _operator(
        self, conditions: list[FactIndex], cost: int, entry: tuple[ActionIndex, int] | None
    ) -> int:
        self._conditions.append(conditions)
        self._adds.append(())
        self._costs.append(cost)
        self._entries.append(entry)
        return len(self._conditions) - 1

    def _axiom(self, conditions: list[FactIndex], add: FactIndex) -> None:
        operator = self._operator(conditions, 0, None)
        self._adds[operator] = ((add, self._supporter(operator, None)),)

    def _needs(self, requirement: Requirement) -> list[FactIndex]:
        return ones(requirement.mask) + [self._choice(each) for each in requirement.choices]

    def _choice(self, choice: Choice) -> FactIndex:
        fact = self._choices.get(choice)
        if fact is None:
            fact = self._choices[choice] = self._fact()
            for bit in ones(choice.mask):
                self._axiom([bit], fact)
            for way in choice.ways:
                self._axiom(self._needs(way), fact)
        return fact

    def _add_variant(
        self, action: ActionIndex, place: int, variant: Variant, symbols: Bits
    ) -> None:
        needs = self._needs(variant.requirement)
        operator = self._operator(needs, 1, (action, place))
        operators = self._variants[action, place] = [operator]
        known = variant.requirement.mask
        adds: list[tuple[FactIndex, int]] = []
        for number, outcome in enumerate(variant.outcomes):
            supporter = self._supporter(operator, Step(action, place, number))
            new = (outcome.add | symbols) & ~known
            known |= new
            adds += [(bit, supporter) for bit in ones(new)]
            for change in outcome.changes:
                more = self._operator(needs + self._needs(change.condition), 1, None)
                operators.append(more)
                supporter = self._supporter(more, Step(action, place, number))
                self._adds[more] = tuple((bit, supporter) for bit in ones(change.add))
        self._adds[operator] = tuple(adds)

    def _add_automata(self) -> None:
        product = self._product
        self.goal = self._fact()
        accepted: list[FactIndex] = []
        for index, explored in enumerate(product.explored):
            if not explored:
                continue
            fact = self._fact()
            accepted.append(fact)
            for bit in ones(product.accepting[index]):
                self._axiom([bit], fact)
        self._axiom(accepted, self.goal)
        complements = product.task.complements
        for bit in range(product.task.width, self.width):
            if not product.is_explored(bit) or product.rejecting >> bit & 1:
                continue
            for transition in product.transitions(bit):
                if transition.target == bit or product.rejecting >> transition.target & 1:
                    continue
                negative = [complements[i] for i in ones(transition.negative) if i in complements]
                self._axiom([bit, *ones(transition.positive), *negative], transition.target)

    def _finish(self) -> None:
        """Index the operators by their conditions."""
        self._waiting: list[list[int]] = [[] for _ in range(self._facts)]
        self._counts: list[int] = []
        self._free: list[int] = []
        for operator, conditions in enumerate(self._conditions):
            unique = list(dict.fromkeys(conditions))
            self._conditions[operator] = unique
            self._counts.append(len(unique))
            if not unique and operator != self._aiming:
                self._free.append(operator)
            for fact in unique:
                self._waiting[fact].append(operator)
        self._all_adds = self._adds
        self._keep_needed()

    def _keep_needed(self) -> None:
        """Leave out adds that nothing needs; they come back when something does."""
        self._all_adds += self._adds[len(self._all_adds) :]
        needed = self._needed = [bool(waiting) for waiting in self._waiting]
        needed[self.goal] = needed[self._aim_fact] = True
        self._adds = [tuple(a for a in adds if needed[a[0]]) for adds in self._all_adds]

    def require(self, action: ActionIndex, place: int, choice: Choice) -> None:
        """Add a choice to what a variant of an action asks for.

        An empty choice forbids it: it can never be met.
        """
        first_operator = len(self._conditions)
        fact = self._choice(choice)
        while len(self._waiting) < self._facts:
            self._waiting.append([])
        for operator in range(first_operator, len(self._conditions)):
            self._counts.append(len(self._conditions[operator]))
            for condition in self._conditions[operator]:
                self._waiting[condition].append(operator)
        for operator in self._variants[action, place]:
            if fact in self._conditions[operator]:
                continue
            self._conditions[operator].append(fact)
            self._counts[operator] += 1
            self._waiting[fact].append(operator)
            if operator in self._free:
                self._free.remove(operator)
        if any(not self._needed[bit] for bit in ones(choice.mask)):
            self._keep_needed()

    def clause(self, state: ProductState, order: list[int]) -> Bits:
        """Bits of which every state has one that the relaxation does not call dead.

        The relaxation calls the state dead. order: of the bits, those to do without first
        """
        closure = Closure(self._adds, self._waiting, self._counts)
        closure.refuse(self.goal)
        closure.admit(ones(state & self._known), self._free)
        found = 0
        for bit in order:
            if not closure.reaches(bit) and not closure.admit([bit]):
                closure.refuse(bit)
                found |= 1 << bit
        return found

    # -- estimates ------------------------------------------------------------------------

    def estimate(self, state: ProductState, target: Bits = 0) -> Estimate | None:
        """How far the goal is, or a state with the target's bits; None where it is not reached."""
        applicable: list[tuple[ActionIndex, int]] = []
        target &= self._known
        goal = self._aim(target) if target else self.goal
        costs, supporters = self._spread(state, applicable, goal)
        if target:
            self._forget(target)
        if costs[goal] == UNREACHED:
            return None
        operator_of, steps, conditions = self._operator_of, self._steps, self._conditions
        plan: dict[int, int] = {}
        preferred: list[int] = []
        todo = [goal]
        seen = {goal}
        while todo:
            fact = todo.pop()
            supporter = supporters[fact]
            if supporter < 0 or supporter in plan:
                continue
            needs = conditions[operator_of[supporter]]
            if steps[supporter] is not None:
                plan[supporter] = costs[fact]
                if not any(map(costs.__getitem__, needs)):
                    preferred.append(supporter)
            for fact in needs:
                if fact not in seen:
                    seen.add(fact)
                    todo.append(fact)
        preferred.sort()
        order = sorted(plan, key=lambda supporter: (plan[supporter], supporter))
        return Estimate(
            len(plan),
            tuple(s for i in preferred if (s := steps[i])),
            tuple(applicable),
            tuple(s for i in order if (s := steps[i])),
        )

    def _aim(self, target: Bits) -> FactIndex:
        """Make the target's bits the conditions of a goal of its own."""
        bits = ones(target)
        for bit in bits:
            self._waiting[bit].append(self._aiming)
        self._counts[self._aiming] = len(bits)
        self._conditions[self._aiming] = bits
        return self._aim_fact

    def _forget(self, target: Bits) -> None:
        for bit in ones(target):
            self._waiting[bit].pop()

    def _spread(
        self,
        state: ProductState,
        applicable: list[tuple[ActionIndex, int]],
        goal: FactIndex,
    ) -> tuple[list[int], list[int]]:
        """h_add costs and supporters of the facts, until the goal is reached."""
        adds, waiting = self._adds, self._waiting
        costs = [UNREACHED] * self._facts
        supporters = [-1] * self._facts
        counts = self._counts[:]
        sums = self._costs[:]
        entries = self._entries
        now = ones(state & self._known)
        for fact in now:
            costs[fact] = 0
        heap: list[int] = []
        shift = self._facts.bit_length()
        mask = (1 << shift) - 1
        fired = self._free[:]
        place = 0
        # Cost 0 first: what is true now, and what follows at once.
        while True:
            for operator in fired:
                total = sums[operator]
                entry = entries[operator]
                if entry is not None:
                    applicable.append(entry)
                for fact, supporter in adds[operator]:
                    if total < costs[fact]:
                        costs[fact] = total
                        supporters[fact] = supporter
                        if total:
                            heappush(heap, total << shift | fact)
                        else:
                            now.append(fact)
            if place == len(now):
                break
            fired = []
            for operator in waiting[now[place]]:
                counts[operator] -= 1
                if not counts[operator]:
                    fired.append(operator)
            place += 1
        while (heap and costs[goal] == UNREACHED) or (heap and heap[0] >> shift < costs[goal]):
            key = heappop(heap)
            cost, fact = key >> shift, key & mask
            if cost > costs[fact]:
                continue
            for operator in waiting[fact]:
                counts[operator] -= 1
                total = sums[operator] = sums[operator] + cost
                if not counts[operator]:
                    total = min(total, SATURATED)
                    for other, supporter in adds[operator]:
                        if total < costs[other]:
                            costs[other] = total
                            supporters[other] = supporter
                            heappush(heap, total << shift | other)
        return costs, supporters
