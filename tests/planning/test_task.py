"""The compiled task means what the plain reading of PDDL says."""

from __future__ import annotations

from hypothesis import given, settings
from tests.strategies import problems, problems_with_goals

from plainspoken.logic.formula import TRUE, Formula
from plainspoken.planning.product import product_of
from plainspoken.planning.task import ground_task
from plainspoken.world.domain import Problem, State
from plainspoken.world.scene import applicable_actions, successors


def changing_part(problem: Problem, state: State) -> State:
    return frozenset(a for a in state if a.split()[0] in problem.changing_predicates)


def states_of(problem: Problem) -> list[State]:
    """Every reachable state, by the plain meaning."""
    order = [problem.initial]
    seen = set(order)
    for state in order:
        for action in applicable_actions(problem, state):
            for after in successors(problem, state, action):
                if after not in seen:
                    seen.add(after)
                    order.append(after)
    return order


@settings(max_examples=150)
@given(problems())
def test_every_reachable_state_has_the_same_actions_and_successors_as_in_the_scene(
    problem: Problem,
) -> None:
    product = product_of(problem, TRUE)
    task = product.task
    names = {action.name: i for i, action in enumerate(task.actions)}
    order = [(problem.initial, product.initial)]
    seen = {problem.initial}
    for state, bits in order:
        assert task.state(bits) | task.static == state
        wanted = set(applicable_actions(problem, state))
        given = {task.actions[i].name for i in names.values() if product.applicable(bits, i)}
        assert given == wanted
        for action in sorted(wanted):
            after = product.successors(bits, names[action])
            by_state = {task.state(b) | task.static: b for b in after}
            assert set(by_state) == set(successors(problem, state, action))
            assert len(by_state) == len(after)
            for following, following_bits in by_state.items():
                if following not in seen:
                    seen.add(following)
                    order.append((following, following_bits))


@settings(max_examples=100)
@given(problems_with_goals())
def test_complements_are_kept_up(drawn: tuple[Problem, Formula]) -> None:
    problem, goal = drawn
    task = ground_task(problem, goal)
    todo = [task.initial]
    seen = set(todo)
    while todo:
        state = todo.pop()
        for bit, complement in task.complements.items():
            assert (state >> bit & 1) != (state >> complement & 1)
        for action in task.actions:
            for variant in action.variants:
                if variant.requirement.holds(state):
                    for outcome in variant.outcomes:
                        after = task.after(state, outcome)
                        if after not in seen:
                            seen.add(after)
                            todo.append(after)


@settings(max_examples=50)
@given(problems())
def test_the_order_of_sets_does_not_matter(problem: Problem) -> None:
    again = Problem(
        problem.name,
        problem.domain,
        problem.objects,
        frozenset(sorted(problem.initial, reverse=True)),
        problem.goal,
    )
    assert ground_task(problem, TRUE) == ground_task(again, TRUE)
