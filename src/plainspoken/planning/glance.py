"""Impossible at a glance: proofs that there is no policy which need no search.

Two of them. The automata alone may have no trace that all accept from the first state on, once
letters with two facts that exclude each other are left out: `F G at_a & F G at_b`. And the delete
relaxation may not reach the goal once it is told what the automata forbid: with `G !at_a`, no
action that leads to `a`. On its own it does not see that, because there an automaton never leaves
a state.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from plainspoken.planning.culprit import contradict
from plainspoken.planning.mutex import exclusions
from plainspoken.planning.product import Product
from plainspoken.planning.relaxation import Relaxation
from plainspoken.planning.task import Bits, Choice, Outcome, Task, TaskAction, Variant, ones
from plainspoken.world.symbol import SymbolId

MOST_COMPARED = 300_000
"""Pairs of an action and a transition that rejects; beyond this, the relaxation is not told."""


def impossible_at_a_glance(product: Product, *, lucky: bool = False) -> bool:
    """Whether it is plain that there is no policy; False says nothing.

    lucky: that there is no way even if outcomes could be chosen
    """
    if product.is_rejected(product.initial):
        return True
    if product.is_goal(product.initial):
        return False
    return _no_word(product) or _out_of_reach(product, lucky=lucky)


def _no_word(product: Product) -> bool:
    """Whether the automata accept nothing together, from the initial state on."""
    if len(product.automata) < 2:
        return False
    task = product.task
    letter = frozenset(name for name, bit in task.reads.items() if task.initial >> bit & 1)
    start = tuple(a.step(a.initial, letter) for a in product.automata)
    return contradict(product.automata, start, excluded_by(task)) is True


def excluded_by(task: Task) -> dict[SymbolId, frozenset[SymbolId]]:
    """For each symbol of the goal, those that are never true when it is."""
    names = {bit: name for name, bit in task.reads.items() if bit < len(task.atoms)}
    predicates = [task.atoms[bit].split(" ", 1)[0] for bit in names]
    if len(set(predicates)) == len(predicates):
        return {}  # Only atoms of one predicate are known to exclude each other.
    found = exclusions(task)
    return {
        name: frozenset(names[other] for other in ones(found[bit]) if other in names)
        for bit, name in names.items()
    }


def _out_of_reach(product: Product, *, lucky: bool) -> bool:
    """Whether the relaxation does not reach the goal when told what the automata forbid."""
    rejecting = tuple(_rejecting(product))
    if not rejecting or len(rejecting) * len(product.actions) > MOST_COMPARED:
        return False
    actions = tuple(map(_split, product.actions)) if lucky else product.actions
    needs = dict.fromkeys(
        (number, place, mask)
        for number, action in enumerate(actions)
        for place, variant in enumerate(action.variants)
        for outcome in variant.outcomes
        for mask in _needed(product, action, variant, outcome, rejecting)
    )
    if not needs:
        return False
    if lucky:
        product = Product(replace(product.task, actions=actions), product.automata)
    relaxation = Relaxation(product)
    for number, place, mask in needs:
        relaxation.require(number, place, Choice(mask))
    return relaxation.estimate(product.initial) is None


def _split(action: TaskAction) -> TaskAction:
    """The action with a variant for each outcome, as if one could choose."""
    return replace(
        action,
        variants=tuple(
            Variant(variant.requirement, (outcome,))
            for variant in action.variants
            for outcome in variant.outcomes
        ),
    )


@dataclass(frozen=True, slots=True)
class Rejection:
    """A transition to where nothing accepts, in an automaton that is known as a whole.

    first: the automaton's bit in the initial state
    live:  all of its bits that can be reached and may still accept
    """

    first: int
    source: int
    positive: Bits
    negative: Bits
    live: Bits


def _rejecting(product: Product) -> Iterator[Rejection]:
    for first in ones(product.initial >> product.task.width << product.task.width):
        if not product.is_explored(first):
            continue
        live = 1 << first
        todo = [first]
        for bit in todo:
            for each in product.transitions(bit):
                target = 1 << each.target
                if not target & (live | product.rejecting):
                    live |= target
                    todo.append(each.target)
        for bit in todo:
            for each in product.transitions(bit):
                if product.rejecting >> each.target & 1:
                    yield Rejection(first, bit, each.positive, each.negative, live)


def _needed(
    product: Product,
    action: TaskAction,
    variant: Variant,
    outcome: Outcome,
    rejecting: tuple[Rejection, ...],
) -> tuple[Bits, ...]:
    """For an outcome not to be rejected, a state needs a bit of each of these masks."""
    task = product.task
    known = _known_after(task, action, variant, outcome)
    symbols = (1 << task.width) - 1 & ~task.world
    added, cleared = outcome.add, outcome.delete & ~outcome.add
    for change in outcome.changes:
        added |= change.add
    always: dict[int, Bits] = {}
    found: list[Bits] = []
    for each in rejecting:
        if each.positive & ~known or each.negative & (symbols & action.symbols | added):
            continue
        # It is rejected in this state, unless something that the guard wants false stays true.
        others = each.live & ~(1 << each.source)
        kept = each.negative & task.world & ~cleared
        for bit in ones(kept):
            complement = task.complements.get(bit)
            if complement is not None and variant.requirement.mask >> complement & 1:
                kept &= ~(1 << bit)
        if kept:
            found.append(others | kept)
        else:
            always[each.first] = always.get(each.first, each.live) & others
    return (*always.values(), *found)


def _known_after(task: Task, action: TaskAction, variant: Variant, outcome: Outcome) -> Bits:
    """Bits that are set after an outcome, whatever the state before."""
    atoms = (1 << len(task.atoms)) - 1
    perhaps_cleared = 0
    for change in outcome.changes:
        perhaps_cleared |= change.delete
    known = (variant.requirement.mask & ~outcome.delete | outcome.add) & ~perhaps_cleared
    return known & task.world | outcome.add & atoms | action.symbols
