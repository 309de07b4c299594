"""The solver against the validator and against exhaustive fixpoints."""

from __future__ import annotations

import time
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from tests.planning.brute import is_solvable
from tests.strategies import problems_with_goals

from plainspoken.logic.formula import Formula, conjunction
from plainspoken.logic.syntax import parse
from plainspoken.planning.goal import problem_goal
from plainspoken.planning.solver import OutOfTime, Solved, Unsolvable, solve
from plainspoken.planning.validation import Valid, validate
from plainspoken.world.domain import Problem
from plainspoken.world.pddl import parse_domain, parse_problem, read_domain, read_problem

VINEYARD = Path(__file__).resolve().parents[2] / "examples" / "vineyard"
relaxed = settings(max_examples=300, suppress_health_check=[HealthCheck.too_slow])


@pytest.fixture(scope="module")
def vineyard() -> Problem:
    return read_problem(VINEYARD / "problem.pddl", read_domain(VINEYARD / "domain.pddl"))


@relaxed
@given(drawn=problems_with_goals())
@pytest.mark.parametrize("strong", [False, True])
def test_the_solver_says_what_the_fixpoint_says_and_its_policies_are_valid(
    drawn: tuple[Problem, Formula],
    strong: bool,  # noqa: FBT001 - pytest names it
) -> None:
    problem, goal = drawn
    ending = solve(problem, goal, strong=strong)
    assert isinstance(ending, Solved) == is_solvable(problem, goal, strong=strong)
    if isinstance(ending, Solved):
        assert isinstance(validate(problem, goal, ending.policy), Valid)
    else:
        assert isinstance(ending, Unsolvable)
        assert ending.reason.said()


@settings(max_examples=100)
@given(problems_with_goals())
def test_the_problems_own_goal_is_decided_too(drawn: tuple[Problem, Formula]) -> None:
    problem, goal = drawn
    both = conjunction(problem_goal(problem), goal)
    ending = solve(problem, both)
    assert isinstance(ending, Solved) == is_solvable(problem, both, strong=False)
    if isinstance(ending, Solved):
        assert isinstance(validate(problem, both, ending.policy), Valid)


@settings(max_examples=50)
@given(problems_with_goals())
def test_the_same_question_gets_the_same_policy(drawn: tuple[Problem, Formula]) -> None:
    problem, goal = drawn
    assert solve(problem, goal) == solve(problem, goal)


MISSIONS = {
    "one line": "F cleared_l2",
    "all lines": "F cleared_l0 & F cleared_l1 & F cleared_l2 & F cleared_l3"
    " & G(full_b -> !robot_at_rob_l3)",
    "a reaction": "F cleared_l2 & G(full_b -> !robot_at_rob_l3)"
    " & (full_b -> X call_support_executed)"
    " & G((!full_b & X full_b) -> X X call_support_executed)",
}


@pytest.mark.parametrize("text", MISSIONS.values(), ids=MISSIONS)
def test_missions_in_the_vineyard_get_valid_policies(vineyard: Problem, text: str) -> None:
    ending = solve(vineyard, parse(text))
    assert isinstance(ending, Solved)
    assert isinstance(validate(vineyard, parse(text), ending.policy), Valid)


def test_the_vineyards_own_goal_gets_a_valid_policy(vineyard: Problem) -> None:
    goal = problem_goal(vineyard)
    ending = solve(vineyard, goal)
    assert isinstance(ending, Solved)
    assert isinstance(validate(vineyard, goal, ending.policy), Valid)


def test_a_solver_without_time_says_how_far_it_got(vineyard: Problem) -> None:
    ending = solve(vineyard, parse("F cleared_l2"), timeout=0)
    assert isinstance(ending, OutOfTime)
    assert ending.stage in ending.sentence


def test_the_time_bounds_grounding_too() -> None:
    names = " ".join(f"o{i}" for i in range(400))
    domain = parse_domain(
        "(define (domain d) (:predicates (p ?x) (q ?x ?y ?z)) (:action a :parameters (?x ?y ?z)"
        " :precondition (and (p ?x) (p ?y) (p ?z)) :effect (q ?x ?y ?z)))",
        "d",
    )
    true = " ".join(f"(p o{i})" for i in range(400))
    problem = parse_problem(
        f"(define (problem p) (:domain d) (:objects {names}) (:init {true}) (:goal (q o1 o2 o3)))",
        domain,
        "p",
    )
    started = time.monotonic()
    ending = solve(problem, problem_goal(problem), timeout=0.3)
    assert isinstance(ending, OutOfTime)
    assert ending.stage == "ground"
    assert time.monotonic() - started < 5
