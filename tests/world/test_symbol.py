"""Ids and what they denote: every form, every spelling, and what cannot be told apart."""

import time
from collections.abc import Callable

import pytest

from plainspoken.errors import AmbiguousSymbolError, UnknownSymbolError
from plainspoken.world.domain import Problem
from plainspoken.world.symbol import (
    ActionSymbol,
    AtomSymbol,
    flat,
    letter,
    resolve,
    resolve_all,
)

ReadProblem = Callable[[str, str], Problem]


@pytest.mark.parametrize(
    ("id", "denoted"),
    [
        ("robot_at_rob_l0", "robot-at rob l0"),
        ("robot_at_sup_wh", "robot-at sup wh"),
        ("full_b", "full b"),
        ("in_hand_g0", "in-hand g0"),
        ("Robot_At_ROB_L0", "robot-at rob l0"),
    ],
)
def test_a_flattened_ground_atom_denotes_it(vineyard: Problem, id: str, denoted: str) -> None:
    assert resolve(id, vineyard) == AtomSymbol(id, denoted)


@pytest.mark.parametrize(
    ("id", "action", "arguments"),
    [
        ("move_executed", "move", ()),
        ("harvest_grape_executed", "harvest-grape", ()),
        ("HARVEST_grape_Executed", "harvest-grape", ()),
        ("rob_executes_move", "move", ("rob",)),
        ("sup_executes_call_support", "call-support", ("sup",)),
        ("move_rob_l0_l1_executed", "move", ("rob", "l0", "l1")),
        ("harvest_grape_rob_g0_l0_executed", "harvest-grape", ("rob", "g0", "l0")),
        ("harvest_grape_g0_executed", "harvest-grape", ("g0",)),
        ("move_l0_executed", "move", ("l0",)),
        ("move_rob_l1_executed", "move", ("rob", "l1")),
        ("empty_box_b_wh_executed", "empty-box", ("b", "wh")),
    ],
)
def test_an_action_symbol_denotes_the_instances_with_its_arguments(
    vineyard: Problem, id: str, action: str, arguments: tuple[str, ...]
) -> None:
    assert resolve(id, vineyard) == ActionSymbol(id, action, arguments)


@pytest.mark.parametrize(
    "id",
    [
        "",
        "robot_at",
        "robot_at_rob",
        "robot_at_rob_l9",
        "robot_at_l0_rob",
        "robot_at_rob_l0_l1",
        "_robot_at_rob_l0",
        "robot_at_rob_l0_",
        "robot_at__rob_l0",
        "full_b_",
        "move",
        "fly_executed",
        "move__executed",
        "move_g0_executed",
        "move_l0_rob_executed",
        "move_rob_l0_l1_l2_executed",
        "move_executed_executed",
        "g0_executes_move",
        "nobody_executes_move",
        "rob_executes_fly",
        "_executes_move",
        "_executed",
        "rob_executes_",
        "robot-at rob l0",
        "wh_ripe",
    ],
)
def test_an_id_of_nothing_in_the_problem_is_unknown(vineyard: Problem, id: str) -> None:
    with pytest.raises(UnknownSymbolError) as caught:
        resolve(id, vineyard)
    assert caught.value.symbol == id


@pytest.mark.parametrize(
    ("id", "suggested"),
    [
        ("robot_at_rob_l9", "robot_at_rob_l3"),
        ("harvest_executed", "harvest_grape_executed"),
        ("full_box", "full_b"),
        ("unripe_g9", "unripe_g3"),
    ],
)
def test_an_unknown_id_is_answered_with_one_that_is_known(
    vineyard: Problem, id: str, suggested: str
) -> None:
    with pytest.raises(UnknownSymbolError) as caught:
        resolve(id, vineyard)
    assert suggested in caught.value.nearest
    for near in caught.value.nearest:
        resolve(near, vineyard)


def test_symbols_are_resolved_in_sorted_order_whatever_the_order_of_a_set(
    vineyard: Problem,
) -> None:
    ids = {"ripe_g0", "full_b", "move_executed"}
    assert [s.id for s in resolve_all(ids, vineyard)] == ["full_b", "move_executed", "ripe_g0"]


@pytest.mark.parametrize(
    ("arguments", "action", "matches"),
    [
        ((), "move rob l0 l1", True),
        (("rob",), "move rob l0 l1", True),
        (("rob", "l1"), "move rob l0 l1", True),
        (("l0", "l1"), "move rob l0 l1", True),
        (("l1", "l0"), "move rob l0 l1", False),
        (("l0", "l0"), "move rob l0 l1", False),
        (("rob", "l0", "l1"), "move rob l0 l1", True),
        (("rob", "l0", "l1", "l1"), "move rob l0 l1", False),
        (("sup",), "move rob l0 l1", False),
        ((), "move-back rob", False),
        ((), "mov", False),
    ],
)
def test_an_action_symbol_matches_executions_with_its_arguments_in_order(
    arguments: tuple[str, ...], action: str, *, matches: bool
) -> None:
    assert ActionSymbol("x", "move", arguments).matches(action) is matches


def test_a_letter_holds_the_atoms_of_the_state_and_the_action_that_led_to_it(
    vineyard: Problem,
) -> None:
    ids = ("robot_at_rob_l0", "Full_B", "move_executed", "rob_executes_move", "move_l3_executed")
    symbols = resolve_all(ids, vineyard)
    state = frozenset({"robot-at rob l0", "full b", "ripe g0"})
    assert letter(symbols, state, "move rob l1 l0") == {
        "robot_at_rob_l0",
        "Full_B",
        "move_executed",
        "rob_executes_move",
    }
    assert letter(symbols, state, "check-grape rob g0 l0") == {"robot_at_rob_l0", "Full_B"}


def test_at_the_first_instant_no_action_symbol_is_true(vineyard: Problem) -> None:
    symbols = resolve_all(["robot_at_rob_l0", "move_executed"], vineyard)
    assert letter(symbols, vineyard.initial, None) == {"robot_at_rob_l0"}


def test_an_id_is_flat() -> None:
    assert flat("robot-at rob line-1") == "robot_at_rob_line_1"


# What flattens to the same

DOMAIN = """(define (domain names)
  (:predicates (at ?x ?y) (at-a ?x) (on ?x) (go-executed) (done))
  (:action go :parameters (?x ?y) :effect (done))
  (:action go-a :parameters (?x) :effect (done))
)
"""


def named(problem_of: ReadProblem, *objects: str) -> Problem:
    return problem_of(
        DOMAIN, f"(define (problem p) (:domain names) (:objects {' '.join(objects)}) (:init))"
    )


def test_an_object_whose_name_begins_another_is_told_from_it(problem_of: ReadProblem) -> None:
    problem = named(problem_of, "a", "a_b", "a-b-c", "x")
    for atom in ("on a", "on a_b", "on a-b-c", "at x a", "at a_b x", "at a-b-c a_b", "at a_b a"):
        assert resolve(flat(atom), problem) == AtomSymbol(flat(atom), atom)
    assert resolve("go_x_a_b_executed", problem) == ActionSymbol(
        "go_x_a_b_executed", "go", ("x", "a_b")
    )
    assert resolve("a_b_executes_go", problem) == ActionSymbol("a_b_executes_go", "go", ("a_b",))


@pytest.mark.parametrize(
    ("objects", "id", "readings"),
    [
        (("b", "b_c", "c_d", "d"), "at_b_c_d", ("(at b c_d)", "(at b_c d)")),
        (("a", "b"), "at_a_b", ("(at a b)", "(at-a b)")),
        (("a-b", "a_b"), "on_a_b", ("(on a-b)", "(on a_b)")),
        (("b", "b_c", "c"), "go_b_c_executed", ("(go b c)", "(go b_c)")),
        (("a", "b"), "go_a_b_executed", ("(go a b)", "(go-a b)")),
        (("a-b", "a_b"), "a_b_executes_go", ("(go a-b)", "(go a_b)")),
    ],
)
def test_an_id_of_two_things_is_refused_and_both_are_named(
    problem_of: ReadProblem, objects: tuple[str, ...], id: str, readings: tuple[str, ...]
) -> None:
    problem = named(problem_of, *objects)
    with pytest.raises(AmbiguousSymbolError) as caught:
        resolve(id, problem)
    assert caught.value.readings == readings


def test_a_form_listed_earlier_goes_before_a_later_one(problem_of: ReadProblem) -> None:
    problem = named(problem_of, "a", "b")
    assert resolve("go_executed", problem) == AtomSymbol("go_executed", "go-executed")
    # `go` with a, or any `go-a`
    assert resolve("go_a_executed", problem) == ActionSymbol("go_a_executed", "go-a")


def test_arguments_that_can_stand_in_several_places_are_no_two_readings(
    problem_of: ReadProblem,
) -> None:
    problem = named(problem_of, "x", "y")
    assert resolve("go_x_executed", problem) == ActionSymbol("go_x_executed", "go", ("x",))
    assert resolve("go_x_x_executed", problem) == ActionSymbol("go_x_x_executed", "go", ("x", "x"))


def test_suggestions_for_a_large_problem_take_no_longer_than_a_second(
    problem_of: ReadProblem,
) -> None:
    problem = named(problem_of, *(f"object{i}" for i in range(400)))
    start = time.process_time()
    with pytest.raises(UnknownSymbolError):
        resolve("at_objekt1_objekt2", problem)
    assert time.process_time() - start < 1
