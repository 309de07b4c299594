"""Rules: an action for every state that has certain bits, read off a weak plan backwards.

Source: Muise, McIlraith and Beck, Improved non-deterministic planning by exploiting state
relevance, ICAPS 2012 (regression of weak plans), here over product states.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from plainspoken.planning.product import ActionIndex, Product, ProductState
from plainspoken.planning.relaxation import Step
from plainspoken.planning.task import Bits, Choice, Requirement, ones


@dataclass(frozen=True, slots=True)
class Rule:
    """In a state with all bits of the mask the action leads on; distance in steps to a goal."""

    distance: int
    mask: Bits
    action: ActionIndex


class Rules:
    """Rules, and the actions that they take, found by their rarest bits."""

    def __init__(self, product: Product) -> None:
        self._product = product
        self._by_bit: dict[int, list[Rule]] = {}
        self._always: list[Rule] = []
        self._best: dict[tuple[Bits, ActionIndex], int] = {}
        self._indexed: Bits = 0
        self._actions: set[ActionIndex] = set()
        self._actions_by_bit: dict[int, list[ActionIndex]] = {}
        self._action_bits: Bits = 0
        self._always_tried: list[ActionIndex] = []

    def __len__(self) -> int:
        return len(self._best)

    def add(self, rule: Rule) -> None:
        """Keep a rule, unless the same is known with no greater distance."""
        key = (rule.mask, rule.action)
        if self._best.get(key, rule.distance + 1) <= rule.distance:
            return
        self._best[key] = rule.distance
        if rule.action not in self._actions:
            self._actions.add(rule.action)
            self._index_action(rule.action)
        bits = ones(rule.mask)
        if bits:
            rarest = min(bits, key=lambda bit: (len(self._by_bit.get(bit, ())), bit))
            self._by_bit.setdefault(rarest, []).append(rule)
            self._indexed |= 1 << rarest
        else:
            self._always.append(rule)

    def _index_action(self, action: ActionIndex) -> None:
        for variant in self._product.actions[action].variants:
            bits = ones(variant.requirement.mask)
            if not bits:
                self._always_tried.append(action)
                continue
            rarest = min(bits, key=lambda bit: (len(self._actions_by_bit.get(bit, ())), bit))
            self._actions_by_bit.setdefault(rarest, []).append(action)
            self._action_bits |= 1 << rarest

    def actions(self, state: ProductState) -> Iterator[ActionIndex]:
        """Actions of rules, all that apply in a state among them."""
        yield from self._always_tried
        for bit in ones(state & self._action_bits):
            yield from self._actions_by_bit[bit]

    def matching(self, state: ProductState) -> list[Rule]:
        """The rules that match a state, those of the smallest distance first."""
        found = [rule for rule in self._candidates(state) if state & rule.mask == rule.mask]
        found.sort(key=lambda rule: (rule.distance, rule.mask, rule.action))
        return found

    def _candidates(self, state: ProductState) -> Iterator[Rule]:
        yield from self._always
        for bit in ones(state & self._indexed):
            yield from self._by_bit[bit]


def regressed(
    product: Product,
    mask: Bits,
    path: Sequence[tuple[ProductState, Step]],
    end: ProductState,
    distance: int,
) -> Iterable[Rule]:
    """The rules of a weak plan whose last state has the bits of the mask.

    path: the states and the steps taken in them
    distance: from the last state to a goal
    """
    after = end
    for state, step in reversed(path):
        mask = _before(product, mask, state, step, after)
        distance += 1
        yield Rule(distance, mask, step.action)
        after = state


def goal_bits(product: Product, state: ProductState) -> Bits:
    """The bits that make a state a goal."""
    return sum(state & accepting for accepting in product.accepting)


def _before(
    product: Product, mask: Bits, state: ProductState, step: Step, after: ProductState
) -> Bits:
    """What a state needs for the step to lead to the bits of the mask."""
    task = product.task
    action = product.actions[step.action]
    variant = action.variants[step.variant]
    outcome = variant.outcomes[step.outcome]
    memory = mask & ~task.world
    world = mask & task.world
    letter = after & task.world | action.symbols
    needed = 0
    for bit in ones(state & ~task.world):
        transition = product.taken(bit, letter)
        if memory >> transition.target & 1:
            needed |= 1 << bit
            world |= transition.positive & task.world
            for negative in ones(transition.negative):
                complement = task.complements.get(negative)
                if complement is not None:
                    world |= 1 << complement
    add = outcome.add
    for change in outcome.changes:
        if world & change.add & ~add and change.condition.holds(state):
            add |= change.add
            needed |= _witness(change.condition, state)
    return (world & ~add) | needed | _witness(variant.requirement, state)


def _witness(requirement: Requirement, state: ProductState) -> Bits:
    """Bits of the state that make the requirement hold, one way for each choice."""
    mask = requirement.mask
    for choice in requirement.choices:
        mask |= _chosen(choice, state)
    return mask


def _chosen(choice: Choice, state: ProductState) -> Bits:
    held = choice.mask & state
    if held:
        return held & -held
    way = next(way for way in choice.ways if way.holds(state))
    return _witness(way, state)
