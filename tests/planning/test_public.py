"""What the room offers to others by its own name."""

from pathlib import Path

import pytest

import plainspoken.planning
from plainspoken.planning import Solved, Valid, problem_goal, solve, validate
from plainspoken.world.pddl import read_domain, read_problem


def test_everything_it_offers_is_there() -> None:
    for name in plainspoken.planning.__all__:
        assert getattr(plainspoken.planning, name).__name__ == name


def test_what_it_does_not_have_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="nothing_such"):
        _ = plainspoken.planning.nothing_such  # type: ignore[attr-defined]


def test_a_solved_problem_is_valid_by_the_public_names_alone() -> None:
    folder = Path(__file__).resolve().parents[2] / "examples" / "warehouse"
    problem = read_problem(folder / "problem.pddl", read_domain(folder / "domain.pddl"))
    goal = problem_goal(problem)
    ending = solve(problem, goal)
    assert isinstance(ending, Solved)
    assert isinstance(validate(problem, goal, ending.policy), Valid)
