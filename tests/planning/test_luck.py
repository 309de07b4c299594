"""Weak policies: what they cover, what they do not, and that they say so."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from hypothesis import HealthCheck, given, settings
from tests.planning.brute import space
from tests.planning.explained import with_luck
from tests.strategies import problems_with_goals

from plainspoken.logic.formula import Formula
from plainspoken.logic.syntax import parse
from plainspoken.planning.policy import Policy, policy_from_json
from plainspoken.planning.solver import Solved, Unsolvable, solve
from plainspoken.planning.validation import Invalid, Valid, validate
from plainspoken.world.domain import Problem
from plainspoken.world.pddl import read_domain, read_problem

VINEYARD = Path(__file__).resolve().parents[2] / "examples" / "vineyard"
GOAL = parse("F stored_g2")


def vineyard() -> Problem:
    return read_problem(VINEYARD / "problem.pddl", read_domain(VINEYARD / "domain.pddl"))


def weak_policy() -> Policy:
    ending = solve(vineyard(), GOAL, lucky=True)
    assert isinstance(ending, Solved)
    return ending.policy


def test_a_goal_without_a_policy_gets_a_weak_one_only_when_asked_for() -> None:
    assert isinstance(solve(vineyard(), GOAL), Unsolvable)
    policy = weak_policy()
    assert policy.kind == "weak"
    assert validate(vineyard(), GOAL, policy) == Valid(len(policy.nodes), len(policy.gaps))
    assert any("unripe g2" in gap.state for gap in policy.gaps)


def test_an_outcome_that_only_means_to_try_again_is_no_gap() -> None:
    policy = weak_policy()
    call = next(n for n in policy.nodes if n.action and n.action.startswith("call-support"))
    assert call.id in call.successors
    assert not any(gap.node == call.id for gap in policy.gaps)


def test_a_weak_policy_is_read_back_as_it_was_written() -> None:
    policy = weak_policy()
    assert policy_from_json(policy.to_json(), "policy") == policy


def test_a_gap_that_is_not_named_is_found() -> None:
    policy = weak_policy()
    verdict = validate(vineyard(), GOAL, replace(policy, gaps=policy.gaps[1:]))
    assert isinstance(verdict, Invalid)
    assert "no successor" in verdict.reason


def test_a_gap_that_is_no_outcome_is_found() -> None:
    policy = weak_policy()
    wrong = replace(policy.gaps[0], node=0)
    assert isinstance(validate(vineyard(), GOAL, replace(policy, gaps=(wrong,))), Invalid)


def test_gaps_are_for_weak_policies_only() -> None:
    claimed = replace(weak_policy(), kind="strong-cyclic")
    assert isinstance(validate(vineyard(), GOAL, claimed), Invalid)


def test_where_there_is_a_policy_luck_is_not_needed() -> None:
    goal = parse("F cleared_l2")
    assert solve(vineyard(), goal, lucky=True) == solve(vineyard(), goal)


@settings(max_examples=300, suppress_health_check=[HealthCheck.too_slow])
@given(problems_with_goals())
def test_a_weak_policy_is_found_where_luck_can_help_and_is_valid(
    drawn: tuple[Problem, Formula],
) -> None:
    problem, goal = drawn
    if isinstance(solve(problem, goal), Solved):
        return
    ending = solve(problem, goal, lucky=True)
    found = space(problem, goal)
    assert isinstance(ending, Solved) == (found.initial in with_luck(found))
    if isinstance(ending, Solved):
        assert isinstance(validate(problem, goal, ending.policy), Valid)
