"""A formula shown by example: the traces are what they are said to be, and near misses."""

import json

import pytest
from hypothesis import given, settings
from tests.language.domains import DOMAINS
from tests.strategies import formulas

from plainspoken.language.example import MOST, examples
from plainspoken.language.extraction import extract
from plainspoken.language.whereabouts import can_be_met, fits, places_of_robots
from plainspoken.logic.formula import Formula
from plainspoken.logic.syntax import parse
from plainspoken.logic.trace import holds
from plainspoken.world.landmark import Landmark, LandmarkType

HOSPITAL = DOMAINS["hospital"]
YARD = {
    each.id: each
    for each in (
        Landmark("robot_at_rob_shed", "the shed", LandmarkType.LOCATION),
        Landmark("robot_at_rob_well", "the well", LandmarkType.LOCATION),
        Landmark("robot_at_dog_shed", "the dog is in the shed", LandmarkType.CONDITION),
        Landmark("bark_executed", "to bark", LandmarkType.ACTION),
    )
}
LETTERS = {
    name: Landmark(name, f"{name} is so", LandmarkType.CONDITION) for name in ("a", "b", "c")
}


@settings(deadline=None)
@given(formula=formulas(most=6))
def test_the_definition_of_satisfaction_agrees_with_every_example(formula: Formula) -> None:
    found = examples(formula, LETTERS)
    assert len(found.accepted) <= MOST
    assert len(found.rejected) <= MOST
    assert all(holds(formula, each.trace) for each in found.accepted)
    assert not any(holds(formula, each.trace) for each in found.rejected)
    texts = [each.english for each in (*found.accepted, *found.rejected)]
    assert len(texts) == len(set(texts)), "what reads the same cannot be both"


@pytest.mark.parametrize(
    ("sentence", "shown"),
    [
        (
            "Visit ward 1, then ward 2.",
            (
                "For example: ward 1, then ward 2; or: ward 1, then elsewhere, then ward 2. "
                "Not: ward 2, then ward 1; or: ward 1."
            ),
        ),
        (
            "Visit ward 1 and ward 2.",
            "For example: ward 1, then ward 2; or: ward 2, then ward 1. Not: ward 1; or: ward 2.",
        ),
        (
            "When the battery is low, call a nurse immediately.",
            (
                "For example: the battery is low, then call a nurse; or: the battery is low, then "
                "call a nurse, then call a nurse. "
                "Not: the battery is low, then nothing, then call a nurse; or: the battery is low."
            ),
        ),
        (
            "Never enter ward 3.",
            "For example: elsewhere. Not: ward 3; or: ward 3, then elsewhere.",
        ),
    ],
)
def test_near_misses_show_where_the_line_runs(sentence: str, shown: str) -> None:
    formula = extract(sentence, HOSPITAL).formula
    assert formula is not None
    assert examples(formula, HOSPITAL.landmarks).english == shown


def test_a_robot_is_at_one_place_at_a_time() -> None:
    formula = parse("F robot_at_rob_shed & F robot_at_rob_well & F robot_at_dog_shed")
    apart = places_of_robots(YARD, YARD)
    assert apart == (frozenset(("robot_at_rob_shed", "robot_at_rob_well")),)
    found = examples(formula, YARD)
    assert found.accepted
    for each in (*found.accepted, *found.rejected):
        assert all(fits(letter, apart) for letter in each.trace)


def test_what_needs_two_places_at_once_has_no_example() -> None:
    formula = parse("F(robot_at_rob_shed & robot_at_rob_well)")
    assert not can_be_met(formula, places_of_robots(YARD, YARD))
    assert examples(formula, YARD).english == ""


def test_no_action_leads_to_the_first_instant() -> None:
    found = examples(parse("F bark_executed"), YARD)
    assert found.accepted
    assert all("bark_executed" not in each.trace[0] for each in found.accepted)


def test_a_formula_that_speaks_of_too_much_is_not_shown() -> None:
    names = [f"p{i}" for i in range(9)]
    assert examples(parse(" & ".join(f"F {name}" for name in names)), {}).accepted == ()


def test_examples_as_json_hold_the_trace_and_its_english() -> None:
    document = examples(parse("F robot_at_rob_shed"), YARD).to_json()
    assert json.loads(json.dumps(document))["accepted"][0] == {
        "english": "the shed",
        "trace": [["robot_at_rob_shed"]],
    }
