"""What is said of every one of several, where each goes by several names."""

import pytest
from tests.language.domains import vocabulary

from plainspoken.automata.equivalence import equivalent
from plainspoken.language.extraction import Status, extract
from plainspoken.logic.syntax import parse, unparse

BATHS = vocabulary(
    """
    p1, l, pool 1, pool one, the first pool
    p2, l, pool 2, pool two, the second pool
    p3, l, pool 3, pool three, the third pool
    desk, l, the front desk, reception
    cold1, c, pool 1 is cold
    test, a, to test the water
    low, c, the battery is low
    """
)


@pytest.mark.parametrize(
    ("utterance", "formula"),
    [
        ("Visit every pool.", "F p1 & F p2 & F p3"),
        ("Go to each of the pools.", "F p1 & F p2 & F p3"),
        ("Never enter any of the pools.", "G !p1 & G !p2 & G !p3"),
        ("Keep going round all three pools, over and over.", "G F p1 & G F p2 & G F p3"),
        ("Visit one of the pools.", "F(p1 | p2 | p3)"),
        ("Visit every pool except pool 2.", "F p1 & F p3"),
        ("Test the water at pool 1 and pool 3.", "F(test & p1) & F(test & p3)"),
        ("Test the water at each of the pools.", "F(test & p1) & F(test & p2) & F(test & p3)"),
        ("Test the water at pool 1 or the front desk.", "F(test & p1) | F(test & desk)"),
        ("Never test the water at pool 1 or pool 2.", "G !(test & p1) & G !(test & p2)"),
        ("Test the water at pool 1 and go to the front desk.", "F(test & p1) & F desk"),
        (
            "If the battery is low, test the water at pool 1 and pool 2.",
            "G(low -> F(test & p1)) & G(low -> F(test & p2))",
        ),
        (
            "If the battery is low, go to pool 1 and the front desk.",
            "G(low -> F p1) & G(low -> F desk)",
        ),
    ],
)
def test_what_is_said_of_each_is_asked_of_each(utterance: str, formula: str) -> None:
    found = extract(utterance, BATHS, None)
    assert found.status is Status.OK, (found.question, found.reason)
    assert found.reading is not None
    assert equivalent(found.reading.literal, parse(formula)), unparse(found.reading.literal)
