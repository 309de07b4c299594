"""What is learned from a dead end: conditions without which an action leads to one.

Let R be all facts that the relaxation reaches from a dead state; it does not hold the goal. A
state within R is dead too, so every live state has one of the facts N outside R. N is made small
by letting R grow as long as it does not hold the goal. An outcome that takes facts of N away and
gives none then needs one of the facts M of N that it does not take, in the state before; the
relaxation is told, and so it sees further dead ends, from which more is learned.

The idea is that of traps and of state constraints in FOND planners (Lipovetzky, Muise and
Geffner, Traps, invariants, and dead-ends, ICAPS 2016), read off the delete relaxation.
"""

from __future__ import annotations

from plainspoken.planning.mutex import exclusions
from plainspoken.planning.product import ActionIndex, Product, ProductState
from plainspoken.planning.relaxation import Relaxation
from plainspoken.planning.task import Bits, Choice, Outcome, ones


class DeadEnds:
    """The conditions learned so far, for the search and, through it, for the relaxation."""

    def __init__(self, product: Product, relaxation: Relaxation) -> None:
        self._product = product
        self._relaxation = relaxation
        self._conditions: dict[ActionIndex, list[tuple[int, Bits]]] = {}
        self._exclusions: list[Bits] | None = None
        self._seen: set[Bits] = set()
        self._deleters: dict[int, list[tuple[ActionIndex, int, int]]] = {}
        self._indexed = False
        self.learned = 0

    def permits(self, state: ProductState, action: ActionIndex) -> bool:
        """Whether no condition learned for the action fails; then nothing is known against it."""
        conditions = self._conditions.get(action)
        if conditions is None:
            return True
        variants = self._product.actions[action].variants
        return all(
            state & mask or not variants[place].requirement.holds(state)
            for place, mask in conditions
        )

    def learn(self, state: ProductState) -> bool:
        """Learn from a state that is dead by the relaxation; whether there was anything new."""
        self._index()
        needed = self._relaxation.clause(state, self._order)
        if needed in self._seen:
            return False
        self._seen.add(needed)
        before = self.learned
        world = self._product.task.world
        candidates: dict[tuple[ActionIndex, int, int], None] = {}
        if needed & ~world & ~self._permanent(needed):
            candidates = dict.fromkeys(
                (action, place, number)
                for action, found in enumerate(self._product.actions)
                for place, variant in enumerate(found.variants)
                for number in range(len(variant.outcomes))
            )
        else:
            for bit in ones(needed & world):
                candidates.update(dict.fromkeys(self._deleters.get(bit, ())))
        for action, place, number in candidates:
            self._condition(action, place, number, needed)
        return self.learned > before

    def _index(self) -> None:
        """The mutex groups, and the outcomes that clear each bit; made when first needed."""
        if self._indexed:
            return
        self._indexed = True
        self._exclusions = exclusions(self._product.task)
        for action, found in enumerate(self._product.actions):
            for place, variant in enumerate(found.variants):
                for number, outcome in enumerate(variant.outcomes):
                    for bit in ones(outcome.delete & ~outcome.add):
                        self._deleters.setdefault(bit, []).append((action, place, number))
        task = self._product.task
        grouped = [bit for bit, mask in enumerate(self._exclusions) if mask]
        alone = [bit for bit, mask in enumerate(self._exclusions) if not mask]
        memory = list(range(task.width, self._relaxation.width))
        others = list(range(len(task.atoms), task.width))
        # What is tried last is likeliest to stay in the clause. Facts of mutex groups are best
        # there: an action that asks for one of a group excludes the others from its condition.
        self._order = [*alone, *others, *memory, *grouped]

    def _permanent(self, needed: Bits) -> Bits:
        """The automata's bits in a clause that are never left for one outside it."""
        product = self._product
        bits = ones(needed & ~product.task.world & ~((1 << product.task.width) - 1))
        stay = 0
        for bit in bits:
            if all(needed >> t.target & 1 for t in product.transitions(bit)):
                stay |= 1 << bit
        return stay | (needed & ((1 << product.task.width) - 1) & ~product.task.world)

    def _condition(self, action: ActionIndex, place: int, number: int, needed: Bits) -> None:
        """Learn what the outcome needs before it so that the clause holds after it."""
        product = self._product
        found = product.actions[action]
        variant = found.variants[place]
        outcome = variant.outcomes[number]
        adds = outcome.add | found.symbols
        for change in outcome.changes:
            adds |= change.add
        if adds & needed:
            return
        required = variant.requirement.mask
        world = needed & product.task.world & ~outcome.delete
        if required & world:
            return
        for bit in ones(required):
            if self._exclusions and bit < len(self._exclusions):
                world &= ~self._exclusions[bit]
        mask = world | self._memories(outcome, found.symbols, needed)
        known = self._conditions.setdefault(action, [])
        if any(at == place and other & mask == other for at, other in known):
            return
        known[:] = [(at, other) for at, other in known if at != place or other & mask != mask]
        known.append((place, mask))
        self.learned += 1
        self._relaxation.require(action, place, Choice(mask))

    def _memories(self, outcome: Outcome, symbols: Bits, needed: Bits) -> Bits:
        """The automata's states in the clause that can step into it as the outcome happens."""
        product = self._product
        task = product.task
        every_symbol = ~task.world & ((1 << task.width) - 1)
        found = 0
        for bit in ones(needed >> task.width << task.width):
            for transition in product.transitions(bit):
                positive, negative = transition.positive, transition.negative
                if (
                    needed >> transition.target & 1
                    and not positive & (outcome.delete & ~outcome.add)
                    and not negative & outcome.add
                    and not positive & every_symbol & ~symbols
                    and not negative & symbols
                ):
                    found |= 1 << bit
                    break
        return found
