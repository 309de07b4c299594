"""The validator, judged by enumerating traces and by breaking policies on purpose."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from tests.planning.brute import is_acyclic, some_trace_violates
from tests.strategies import formulas, problem_with_goal, traces

from plainspoken.logic.formula import Formula
from plainspoken.logic.trace import Trace, holds
from plainspoken.planning.policy import Policy, PolicyNode
from plainspoken.planning.solver import Solved, solve
from plainspoken.planning.validation import Invalid, Valid, validate
from plainspoken.planning.valuation import Valuations
from plainspoken.world.domain import Problem
from plainspoken.world.scene import applicable_actions, successors

relaxed = settings(
    max_examples=200, suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much]
)


Task = tuple[Problem, Formula, Policy]


SOLVED_TASKS = 300


@cache
def task(number: int) -> Task:
    """One of many solved tasks with a policy that acts; solved once, and by all tests shared."""
    seed = number * 100
    while True:
        drawn = problem_with_goal(seed)
        ending = solve(*drawn)
        if isinstance(ending, Solved) and len(ending.policy.nodes) > 1:
            return *drawn, ending.policy
        seed += 1


tasks = st.integers(0, SOLVED_TASKS - 1).map(task)


def changed(policy: Policy, node: PolicyNode) -> Policy:
    return replace(
        policy, nodes=tuple(node if each.id == node.id else each for each in policy.nodes)
    )


@given(formulas(), traces())
def test_valuations_from_the_end_agree_with_the_semantics(formula: Formula, trace: Trace) -> None:
    valuations = Valuations(formula)
    value = valuations.at_the_end(trace[-1])
    for letter in reversed(trace[:-1]):
        value = valuations.before(letter, valuations.kept(value))
    assert valuations.holds(value) == holds(formula, trace)


@relaxed
@given(tasks, formulas(("in_r1", "done", "a_executed"), 4))
def test_a_policy_for_one_formula_is_valid_for_another_iff_every_trace_satisfies_it(
    drawn: Task, other: Formula
) -> None:
    problem, _, policy = drawn
    verdict = validate(problem, other, policy)
    if isinstance(verdict, Valid):
        assert not some_trace_violates(problem, other, policy, longest=7)
    elif is_acyclic(policy):
        assert some_trace_violates(problem, other, policy, longest=len(policy.nodes) + 1)


@relaxed
@given(tasks, st.data())
def test_a_policy_that_leaves_an_outcome_out_is_rejected(drawn: Task, data: st.DataObject) -> None:
    problem, goal, policy = drawn
    acting = [node for node in policy.nodes if node.action]
    node = data.draw(st.sampled_from(acting))
    left_out = data.draw(st.sampled_from(node.successors))
    broken = replace(node, successors=tuple(s for s in node.successors if s != left_out))
    assert isinstance(validate(problem, goal, changed(policy, broken)), Invalid)


@relaxed
@given(tasks, st.data())
def test_a_policy_with_another_action_that_does_something_else_is_rejected(
    drawn: Task, data: st.DataObject
) -> None:
    problem, goal, policy = drawn
    acting = [node for node in policy.nodes if node.action]
    node = data.draw(st.sampled_from(acting))
    state = node.state | policy.static
    others = {
        action
        for schema in problem.domain.actions
        for binding in problem.bindings(schema.parameters)
        if (action := " ".join([schema.name, *binding.values()]))
    }
    applicable = set(applicable_actions(problem, state))
    after = {policy.node(s).state | policy.static for s in node.successors}
    wrong = sorted(
        a for a in others if a not in applicable or set(successors(problem, state, a)) != after
    )
    assume(wrong)
    broken = replace(node, action=data.draw(st.sampled_from(wrong)))
    assert isinstance(validate(problem, goal, changed(policy, broken)), Invalid)


@relaxed
@given(tasks, st.data())
def test_a_policy_with_a_state_edited_is_rejected(drawn: Task, data: st.DataObject) -> None:
    problem, goal, policy = drawn
    node = data.draw(st.sampled_from(policy.nodes))
    broken = replace(node, state=node.state ^ {data.draw(st.sampled_from(("done", "in r1")))})
    # A static atom stays true whether the node lists it or not.
    assume(broken.state | policy.static != node.state | policy.static)
    assert isinstance(validate(problem, goal, changed(policy, broken)), Invalid)


@relaxed
@given(tasks)
def test_a_policy_that_stops_before_the_formula_holds_is_rejected(
    drawn: Task,
) -> None:
    problem, goal, policy = drawn
    acting = [node for node in policy.nodes if node.action]
    # The solver stops as soon as it may, so no node that acts could stop on every way there.
    for node in acting:
        broken = changed(policy, replace(node, action=None, successors=()))
        assert isinstance(validate(problem, goal, broken), Invalid)


@relaxed
@given(tasks)
def test_a_policy_that_goes_round_for_ever_is_rejected(drawn: Task) -> None:
    problem, goal, policy = drawn
    for node in policy.nodes:
        state = node.state | policy.static
        for action in dict.fromkeys(applicable_actions(problem, state)):
            if successors(problem, state, action) == (state,):
                broken = replace(node, action=action, successors=(node.id,))
                assert isinstance(validate(problem, goal, changed(policy, broken)), Invalid)


@relaxed
@given(tasks)
def test_a_strong_policy_has_no_cycles_and_a_strong_cyclic_one_may(
    drawn: Task,
) -> None:
    problem, goal, policy = drawn
    policy = replace(policy, kind="strong")
    assert isinstance(validate(problem, goal, policy), Valid) == is_acyclic(policy)


@relaxed
@given(tasks)
def test_two_successors_with_one_state_are_rejected(drawn: Task) -> None:
    problem, goal, policy = drawn
    acting = [node for node in policy.nodes if node.action]
    copy = replace(policy.node(acting[0].successors[0]), id=len(policy.nodes))
    broken = replace(acting[0], successors=(*acting[0].successors, copy.id))
    policy = changed(policy, broken)
    policy = replace(policy, nodes=(*policy.nodes, copy))
    assert isinstance(validate(problem, goal, policy), Invalid)
