"""Why there is no policy, in a value and in a sentence."""

from __future__ import annotations

from pathlib import Path

import pytest

from plainspoken.logic.syntax import parse
from plainspoken.planning.solver import Solved, Unsolvable, solve
from plainspoken.planning.unsolvable import (
    Contradiction,
    NeverFalse,
    NeverTrue,
    NoGuarantee,
    PartImpossible,
    Reason,
    ViolatedAtStart,
)
from plainspoken.world.domain import Problem
from plainspoken.world.pddl import read_domain, read_problem

DOMAIN = """
(define (domain door)
  (:requirements :strips :non-deterministic)
  (:predicates (inside) (locked) (key) (broken) (tired) (open))
  (:action push :parameters () :precondition (and (not (broken)) (not (inside)))
    :effect (oneof (inside) (broken)))
  (:action rest :parameters () :precondition (tired) :effect (not (tired)))
  (:action shout :parameters () :precondition (and) :effect (and)))
"""
PROBLEM = "(define (problem p) (:domain door) (:init (locked) (tired)) (:goal (inside)))"


@pytest.fixture
def door(tmp_path: Path) -> Problem:
    (tmp_path / "domain.pddl").write_text(DOMAIN)
    (tmp_path / "problem.pddl").write_text(PROBLEM)
    return read_problem(tmp_path / "problem.pddl", read_domain(tmp_path / "domain.pddl"))


def reason(problem: Problem, text: str, *, strong: bool = False) -> Reason:
    ending = solve(problem, parse(text), strong=strong)
    assert isinstance(ending, Unsolvable)
    return ending.reason


@pytest.mark.parametrize("text", ["F(inside & !inside)", "F inside & G !inside"])
def test_a_formula_that_contradicts_itself_is_named(door: Problem, text: str) -> None:
    found = reason(door, text)
    assert isinstance(found, Contradiction)
    assert "inside" in found.sentence


def test_what_the_initial_state_violates_is_named(door: Problem) -> None:
    found = reason(door, "F inside & G !tired")
    assert found == ViolatedAtStart(parse("G !tired"))
    assert "initial state" in found.sentence


def test_an_atom_that_can_never_become_true_is_named(door: Problem) -> None:
    found = reason(door, "F !tired & F open")
    assert found == NeverTrue(("open",), parse("F open"))
    assert "open can never become true" in found.sentence


def test_an_atom_that_can_never_become_false_is_named(door: Problem) -> None:
    assert reason(door, "F !locked") == NeverFalse(("locked",), parse("F !locked"))


def test_a_conjunct_that_cannot_hold_alone_is_named(door: Problem) -> None:
    found = reason(door, "F !tired & F inside")
    assert found == PartImpossible(parse("F inside"))


def test_a_lucky_way_and_the_outcome_that_breaks_it_are_named(door: Problem) -> None:
    found = reason(door, "F inside")
    assert found == NoGuarantee(("push",), "push", ("broken",))
    assert "push may go wrong for good (broken)" in found.sentence


def test_no_way_even_with_luck_is_said(door: Problem) -> None:
    found = reason(door, "F(inside & F broken)")
    assert found == NoGuarantee(None)


def test_a_strong_policy_needs_a_bound(door: Problem) -> None:
    assert isinstance(reason(door, "F inside", strong=True), NoGuarantee)


def test_two_things_to_keep_away_from_are_no_contradiction(door: Problem) -> None:
    # Both automata are back at their start after the first instant.
    assert isinstance(solve(door, parse("G !broken & G !inside")), Solved)
