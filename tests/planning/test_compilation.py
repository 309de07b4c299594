"""The compiled problem: plain PDDL that has a policy exactly where the formula does."""

from __future__ import annotations

from pathlib import Path
from unittest.mock import patch

import pddl
import pytest
from hypothesis import HealthCheck, given, settings
from tests.strategies import problem_with_goal, problems_with_goals

from plainspoken.errors import FormulaTooLargeError
from plainspoken.logic.formula import Formula, conjunction
from plainspoken.logic.syntax import parse
from plainspoken.planning import compilation
from plainspoken.planning.compilation import compiled
from plainspoken.planning.cube import Cube, all_of, any_of, literal, negated
from plainspoken.planning.goal import problem_goal
from plainspoken.planning.ground_pddl import distinct_names
from plainspoken.planning.solver import Solved, solve
from plainspoken.planning.validation import Valid, validate
from plainspoken.world.domain import AllOf, AtomCondition, NotCondition, Problem
from plainspoken.world.pddl import parse_domain, parse_problem, read_domain, read_problem

VINEYARD = Path(__file__).resolve().parents[2] / "examples" / "vineyard"
relaxed = settings(max_examples=250, suppress_health_check=[HealthCheck.too_slow])


@pytest.fixture(scope="module")
def vineyard() -> Problem:
    return read_problem(VINEYARD / "problem.pddl", read_domain(VINEYARD / "domain.pddl"))


def agrees(problem: Problem, goal: Formula) -> bool:
    """Whether both have a policy or none, and that of the compiled problem is one for both."""
    direct = solve(problem, goal)
    made = compiled(problem, goal)
    read = made.read()
    ending = solve(read, problem_goal(read))
    if isinstance(ending, Solved):
        assert isinstance(validate(problem, goal, made.original(ending.policy)), Valid)
    return isinstance(direct, Solved) == isinstance(ending, Solved)


@relaxed
@given(problems_with_goals())
def test_the_compiled_problem_has_a_policy_where_the_formula_has_one(
    drawn: tuple[Problem, Formula],
) -> None:
    assert agrees(*drawn)


@settings(max_examples=100, suppress_health_check=[HealthCheck.too_slow])
@given(problems_with_goals())
def test_so_it_has_where_disjunctions_are_kept_up_and_the_problems_own_goal_is_wanted_too(
    drawn: tuple[Problem, Formula],
) -> None:
    problem, goal = drawn
    with patch.object(compilation, "MOST_WAYS", 1):
        assert agrees(problem, conjunction(goal, problem_goal(problem)))


@pytest.mark.parametrize("seed", range(25))
def test_preconditions_are_conjunctions_of_literals_and_the_pddl_package_reads_the_text(
    seed: int, tmp_path: Path
) -> None:
    made = compiled(*problem_with_goal(seed))
    for action in made.read().domain.actions:
        assert isinstance(action.precondition, AllOf)
        for part in action.precondition.conditions:
            inner = part.condition if isinstance(part, NotCondition) else part
            assert isinstance(inner, AtomCondition)
    (tmp_path / "domain.pddl").write_text(made.domain)
    (tmp_path / "problem.pddl").write_text(made.problem)
    if made.actions:
        theirs = pddl.parse_domain(tmp_path / "domain.pddl")
        assert {action.name for action in theirs.actions} == set(made.actions)
        assert len(pddl.parse_problem(tmp_path / "problem.pddl").init) == len(made.read().initial)


MISSIONS = {
    "a goal about the first instant": "robot_at_rob_l0 & F cleared_l1",
    "a reaction by an action": "F cleared_l2 & G(full_b -> !robot_at_rob_l3)"
    " & (full_b -> X call_support_executed)"
    " & G((!full_b & X full_b) -> X X call_support_executed)",
    "steps counted": "X X X X robot_at_rob_l3 & F G robot_at_rob_l3",
}


@pytest.mark.parametrize("text", MISSIONS.values(), ids=MISSIONS)
def test_missions_in_the_vineyard_are_compiled(vineyard: Problem, text: str) -> None:
    assert agrees(vineyard, parse(text))


def test_what_the_first_instant_violates_has_no_policy(vineyard: Problem) -> None:
    read = compiled(vineyard, parse("robot_at_rob_l1 & F cleared_l1")).read()
    assert not isinstance(solve(read, problem_goal(read)), Solved)


def test_every_conjunct_keeps_an_automaton_of_its_own(vineyard: Problem) -> None:
    made = compiled(vineyard, parse(" & ".join(f"F cleared_l{i}" for i in range(4))))
    assert made.domain.count("(at-") < made.domain.count("\n")
    assert {f"at-{i}-0" for i in range(1, 5)} <= set(made.read().domain.predicates)
    assert "at-5-0" not in made.domain


def test_a_wide_disjunction_is_kept_up_and_not_split() -> None:
    holes = range(12)
    domain = parse_domain(
        "(define (domain d) (:predicates (done) "
        + " ".join(f"(a{i}) (b{i})" for i in holes)
        + ")"
        + " ".join(
            f"(:action {name}{i} :parameters () :precondition (and) :effect ({name}{i}))"
            for i in holes
            for name in "ab"
        )
        + "(:action end :parameters () :effect (done) :precondition (and "
        + " ".join(f"(or (a{i}) (b{i}))" for i in holes)
        + ")))",
        "wide",
    )
    problem = parse_problem(
        "(define (problem p) (:domain d) (:init (a3)) (:goal (done)))", domain, "p"
    )
    made = compiled(problem, problem_goal(problem))
    assert len(made.actions) < 50
    assert "(or-8)" in made.domain
    assert agrees(problem, problem_goal(problem))


def test_names_are_words_that_no_two_atoms_share() -> None:
    names = distinct_names("is", ["on a-b", "on_a-b", "on a--b", "on é", "and"])
    assert names == ["is-on_a-b", "is-on_a-b-_2", "is-on_a-_b", "is-on__", "is-and"]


def test_a_problem_that_would_be_too_large_is_refused(vineyard: Problem) -> None:
    with patch.object(compilation, "MOST_EFFECTS", 10), pytest.raises(FormulaTooLargeError):
        compiled(vineyard, parse("F cleared_l0"))


def test_cubes_join_meet_and_are_negated() -> None:
    a, b, c = (literal(bit, positive=True) for bit in range(3))
    assert any_of(a, all_of(a, b)) == a
    assert all_of(a, negated(a)) == ()
    assert negated(all_of(a, b)) == any_of(negated(a), negated(b))
    assert all_of(any_of(a, b), c) == any_of(all_of(a, c), all_of(b, c))
    assert negated(()) == (Cube(),)
