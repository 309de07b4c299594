"""Formulas said back: short, the same every time, and telling different formulas apart."""

from dataclasses import dataclass

import pytest

from plainspoken.logic.english import say
from plainspoken.logic.syntax import parse


@dataclass(frozen=True)
class Words:
    description: str
    type: str


WORDS = {
    "l1": Words("line 1", "location"),
    "l2": Words("line 2", "location"),
    "wh": Words("the warehouse", "location"),
    "full": Words("the box is full", "condition"),
    "holds": Words("the robot holds a cup", "condition"),
    "call": Words("to call the support robot", "action"),
    "pick": Words("to harvest a grape", "action"),
}


@pytest.mark.parametrize(
    ("formula", "english"),
    [
        ("F l1", "Visit line 1."),
        ("F l1 & F wh", "Visit line 1 and the warehouse, in any order."),
        ("F pick", "Harvest a grape at some point."),
        ("F full", "Make sure that the box is full at some point."),
        ("F(l1 & F l2)", "Visit line 1, then visit line 2."),
        ("G !l1", "Never visit line 1."),
        ("G !full", "At every moment, make sure that the box is not full."),
        ("G(full -> !l2)", "Never visit line 2 while the box is full."),
        ("G(full -> F call)", "Whenever the box is full, eventually call the support robot."),
        ("G(pick -> full)", "Harvest a grape only if the box is full."),
        ("G(pick -> X call)",
         "As soon as you harvest a grape, call the support robot in the next step."),
        ("(full -> X call) & G((!full & X full) -> X X call)",
         "As soon as the box is full, call the support robot in the next step."),
        ("G(full -> X call)",
         "At every step at which the box is full, call the support robot in the next step."),
        ("F l1 | F l2", "Visit line 1 or visit line 2."),
        ("F !holds", "At some point make sure that it is not so that the robot holds a cup."),
        ("F(l1 & (l1 U (!l1 & (!l1 U F l1))))", "Visit line 1 at least twice."),
    ],
)  # fmt: skip
def test_a_formula_is_said_in_words(formula: str, english: str) -> None:
    assert say(parse(formula), WORDS) == english


def test_what_no_pattern_says_is_said_operator_by_operator() -> None:
    assert say(parse("X(F l1 -> X full)"), WORDS) == (
        "There is a next step, and in it (if (at some point you are at line 1), then (there is a"
        " next step, and in it the box is full))."
    )


def test_an_unknown_proposition_is_said_as_it_is_spelled() -> None:
    assert say(parse("F door_open"), {}) == "Make sure that door_open is true at some point."
