"""Why there is no policy, in a value and in a sentence."""

from __future__ import annotations

import time
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from tests.planning.explained import fault
from tests.strategies import problems_with_goals

from plainspoken.logic.formula import Formula, conjunction
from plainspoken.logic.syntax import parse, unparse
from plainspoken.planning.goal import problem_goal
from plainspoken.planning.reason import (
    Breach,
    Contradiction,
    LuckyWay,
    NeverFalse,
    NeverTrue,
    NoGuarantee,
    OnlyByRetrying,
    Reason,
    ViolatedAtStart,
    Words,
)
from plainspoken.planning.solver import OutOfTime, Solved, Unsolvable, solve
from plainspoken.world.domain import Problem
from plainspoken.world.pddl import read_domain, read_problem
from plainspoken.world.symbol import ActionSymbol, AtomSymbol

VINEYARD = Path(__file__).resolve().parents[2] / "examples" / "vineyard"
DOMAIN = """
(define (domain door)
  (:requirements :strips :non-deterministic)
  (:predicates (inside) (locked) (key) (broken) (tired) (open))
  (:action push :parameters () :precondition (and (not (broken)) (not (inside)))
    :effect (oneof (inside) (broken)))
  (:action try :parameters () :precondition (and) :effect (oneof (key) (and)))
  (:action unlock :parameters () :precondition (open) :effect (not (locked)))
  (:action rest :parameters () :precondition (tired) :effect (not (tired)))
  (:action shout :parameters () :precondition (and) :effect (and)))
"""
PROBLEM = "(define (problem p) (:domain door) (:init (locked) (tired)) (:goal (inside)))"


@pytest.fixture
def door(tmp_path: Path) -> Problem:
    (tmp_path / "domain.pddl").write_text(DOMAIN)
    (tmp_path / "problem.pddl").write_text(PROBLEM)
    return read_problem(tmp_path / "problem.pddl", read_domain(tmp_path / "domain.pddl"))


@pytest.fixture(scope="module")
def vineyard() -> Problem:
    return read_problem(VINEYARD / "problem.pddl", read_domain(VINEYARD / "domain.pddl"))


def reason(problem: Problem, text: str, *, strong: bool = False) -> Reason:
    ending = solve(problem, parse(text), strong=strong)
    assert isinstance(ending, Unsolvable)
    return ending.reason


def parts(*texts: str) -> tuple[Formula, ...]:
    return tuple(map(parse, texts))


@pytest.mark.parametrize("text", ["F(inside & !inside)", "F inside & F key & G !inside"])
def test_of_a_formula_that_contradicts_itself_the_parts_are_named(door: Problem, text: str) -> None:
    found = reason(door, text)
    assert isinstance(found, Contradiction)
    assert "inside" in found.said()
    assert "key" not in found.said()


def test_what_the_initial_state_violates_is_named(door: Problem) -> None:
    found = reason(door, "F inside & G !tired")
    assert found == ViolatedAtStart(parse("G !tired"))
    assert "at the start: satisfy G !tired" in found.said()


def test_an_atom_that_can_never_become_true_is_named(door: Problem) -> None:
    found = reason(door, "F !tired & F open")
    assert found == NeverTrue((AtomSymbol("open", "open"),), parse("F open"))
    assert found.said() == "I can't satisfy F open, for it can never be that open is true."


def test_an_action_that_can_never_be_taken_is_named(door: Problem) -> None:
    found = reason(door, "F unlock_executed")
    unlock = ActionSymbol("unlock_executed", "unlock")
    assert found == NeverTrue((unlock,), parse("F unlock_executed"))
    assert "I can never unlock" in found.said()


def test_an_atom_that_can_never_become_false_is_named(door: Problem) -> None:
    locked = AtomSymbol("locked", "locked")
    assert reason(door, "F !locked") == NeverFalse((locked,), parse("F !locked"))


def test_of_several_parts_the_one_that_is_in_the_way_is_named(door: Problem) -> None:
    found = reason(door, "F !tired & F inside")
    assert isinstance(found, NoGuarantee)
    assert (found.parts, found.minimal, found.whole) == (parts("F inside"), True, False)


def test_a_lucky_way_and_the_outcome_that_breaks_it_are_named(door: Problem) -> None:
    way = LuckyWay(("push",), Breach("push", ("broken",), ()))
    found = reason(door, "F inside")
    assert found == NoGuarantee(parts("F inside"), whole=True, lucky=True, way=way)
    assert found.said() == (
        "I can't promise to satisfy F inside. With luck: push. "
        "But when I push, it may be that broken is true, and then nothing helps."
    )


def test_no_way_even_with_luck_is_said(door: Problem) -> None:
    found = reason(door, "F(inside & F broken)")
    assert found == NoGuarantee(parts("F(inside & F broken)"), whole=True, lucky=False, never=True)
    assert found.said() == "I can't satisfy F(inside & F broken)."


def test_what_only_trying_again_and_again_does_is_said(door: Problem) -> None:
    found = reason(door, "F key & F !tired", strong=True)
    assert found == OnlyByRetrying(parts("F key"))
    assert "trying again and again would do it" in found.said()


def test_two_things_to_keep_away_from_are_no_contradiction(door: Problem) -> None:
    # Both automata are back at their start after the first instant.
    assert isinstance(solve(door, parse("G !broken & G !inside")), Solved)


def test_the_words_are_the_callers(door: Problem) -> None:
    texts = {"F key": "Get the key.", "G !try_executed": "Never try.", "G !key": "Do not find it."}
    words = Words(lambda f: texts[unparse(f)], lambda _: "it's mine", lambda _: "poke")
    found = reason(door, "F key & G !try_executed")
    assert found.said(words) == "I can't both get the key and never try."
    three = NoGuarantee(parts(*texts), lucky=False)
    assert three.said(words) == (
        "I can't do all of these together: get the key; never try; not find it."
    )


def test_that_nothing_happens_at_all_satisfies_nothing(door: Problem) -> None:
    # Both automata accept before they have read anything; a trace has its first instant.
    found = reason(door, "G(WX tired <-> !tired) & G tired")
    assert found == Contradiction(parts("G(WX tired <-> !tired)", "G tired"))


IMPOSSIBLE = {
    "F cleared_l2 & G !robot_at_rob_l2": ("F cleared_l2", "G !robot_at_rob_l2"),
    "F cleared_l0 & F cleared_l2 & G !check_grape_executed & G !robot_at_rob_l2": (
        ("F cleared_l0", "G !check_grape_executed")
    ),
    "F G robot_at_rob_l1 & F cleared_l3 & F G robot_at_rob_l2": (
        ("F G robot_at_rob_l1", "F G robot_at_rob_l2")
    ),
    "G(robot_at_rob_l0 -> F robot_at_rob_l1) & G(robot_at_rob_l1 -> F robot_at_rob_l0)": (
        "G(robot_at_rob_l0 -> F robot_at_rob_l1)",
        "G(robot_at_rob_l1 -> F robot_at_rob_l0)",
    ),
    "F cleared_l3 & (!robot_at_rob_l2 U cleared_l2)": ("!robot_at_rob_l2 U cleared_l2",),
}


@pytest.mark.parametrize(("text", "named"), IMPOSSIBLE.items())
def test_what_shows_without_a_search_is_told_at_once(
    vineyard: Problem, text: str, named: tuple[str, ...]
) -> None:
    started = time.perf_counter()
    found = reason(vineyard, text)
    assert time.perf_counter() - started < 1
    assert isinstance(found, NoGuarantee)
    assert (found.parts, found.minimal, found.lucky) == (parts(*named), True, False)


def test_an_explanation_keeps_to_the_callers_time(vineyard: Problem) -> None:
    goal = parse("F ripe_g2 & F unripe_g2 & F cleared_l0")
    started = time.perf_counter()
    ending = solve(vineyard, goal, timeout=0.3)
    assert time.perf_counter() - started < 1.5
    assert isinstance(ending, (Unsolvable, OutOfTime))


relaxed = settings(max_examples=250, suppress_health_check=[HealthCheck.too_slow])


@relaxed
@given(drawn=problems_with_goals())
@pytest.mark.parametrize("strong", [False, True])
def test_the_parts_named_are_impossible_and_possible_without_any_of_them(
    drawn: tuple[Problem, Formula],
    strong: bool,  # noqa: FBT001 - pytest names it
) -> None:
    problem, goal = drawn
    for asked in (goal, conjunction(problem_goal(problem), goal)):
        ending = solve(problem, asked, strong=strong)
        if isinstance(ending, Unsolvable):
            assert fault(problem, asked, ending.reason, strong=strong) is None
            assert ending.reason.said().endswith(".")
