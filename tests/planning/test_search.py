"""What the search believes on the way, against fixpoints over all reachable product states."""

from __future__ import annotations

from collections.abc import Iterator
from unittest.mock import patch

from hypothesis import HealthCheck, given, settings
from tests.strategies import problems_with_goals

from plainspoken.logic.formula import Formula
from plainspoken.planning import product as product_module
from plainspoken.planning.deadends import DeadEnds
from plainspoken.planning.fixpoint import Space, reachable_space, strong_cyclic_choice
from plainspoken.planning.mutex import mutex_groups
from plainspoken.planning.product import Product, ProductState, product_of
from plainspoken.planning.relaxation import Relaxation
from plainspoken.planning.search import Found, StrongCyclicSearch
from plainspoken.world.domain import Problem

relaxed = settings(max_examples=300, suppress_health_check=[HealthCheck.too_slow])


def all_choices(product: Product, state: ProductState) -> dict[int, tuple[ProductState, ...]]:
    found = {a: product.successors(state, a) for a in range(len(product.actions))}
    return {action: after for action, after in found.items() if after}


def space_of(product: Product) -> Space[ProductState, int]:
    def choices(state: ProductState) -> Iterator[tuple[int, tuple[ProductState, ...]]]:
        yield from all_choices(product, state).items()

    found = reachable_space(product.initial, product.is_goal, choices)
    assert found is not None
    return found


def with_luck(space: Space[ProductState, int]) -> set[ProductState]:
    """The states from which a goal is reached if outcomes could be chosen."""
    found = set(space.goals)
    while True:
        more = {
            state
            for state, actions in space.choices.items()
            if state not in found and any(found & set(after) for after in actions.values())
        }
        if not more:
            return found
        found |= more


@relaxed
@given(problems_with_goals())
def test_no_state_called_dead_has_a_policy(drawn: tuple[Problem, Formula]) -> None:
    product = product_of(*drawn)
    space = space_of(product)
    live = set(strong_cyclic_choice(space)) | space.goals
    search = StrongCyclicSearch(product)
    ending = search.run()
    assert not live & search.dead
    assert isinstance(ending, Found) == (product.initial in live)


@relaxed
@given(problems_with_goals())
def test_no_condition_learned_forbids_an_action_that_is_safe(
    drawn: tuple[Problem, Formula],
) -> None:
    product = product_of(*drawn)
    space = space_of(product)
    live = set(strong_cyclic_choice(space)) | space.goals
    relaxation = Relaxation(product)
    dead_ends = DeadEnds(product, relaxation)
    # Learn from every state that is dead by the relaxation, so that much is learned.
    for state in space.choices:
        if not product.is_rejected(state) and relaxation.estimate(state) is None:
            dead_ends.learn(state)
    for state, actions in space.choices.items():
        if state in live:
            assert product.is_goal(state) or relaxation.estimate(state) is not None
            for action, after in actions.items():
                assert dead_ends.permits(state, action) or not set(after) <= live


@relaxed
@given(problems_with_goals())
def test_a_state_that_the_relaxation_calls_dead_has_no_plan_even_with_luck(
    drawn: tuple[Problem, Formula],
) -> None:
    product = product_of(*drawn)
    space = space_of(product)
    lucky = with_luck(space)
    relaxation = Relaxation(product)
    for state in space.choices:
        if not product.is_goal(state) and relaxation.estimate(state) is None:
            assert state not in lucky


@relaxed
@given(problems_with_goals())
def test_the_actions_that_an_estimate_finds_applicable_are_those(
    drawn: tuple[Problem, Formula],
) -> None:
    product = product_of(*drawn)
    relaxation = Relaxation(product)
    for state in space_of(product).choices:
        estimate = relaxation.estimate(state)
        if estimate is not None:
            assert {a for a, _ in estimate.applicable} == set(all_choices(product, state))


@relaxed
@given(problems_with_goals())
def test_of_a_mutex_group_no_two_bits_are_ever_set(drawn: tuple[Problem, Formula]) -> None:
    product = product_of(*drawn)
    groups = mutex_groups(product.task)
    for state in space_of(product).choices:
        for group in groups:
            assert (state & group).bit_count() <= 1


@relaxed
@given(problems_with_goals())
def test_automata_too_large_to_explore_change_no_verdict(drawn: tuple[Problem, Formula]) -> None:
    whole = StrongCyclicSearch(product_of(*drawn)).run()
    with patch.object(product_module, "MOST_EXPLORED", 1):
        partly = StrongCyclicSearch(product_of(*drawn)).run()
    assert type(whole) is type(partly)
