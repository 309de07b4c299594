"""Which words of a sentence are shown so that nobody reads over them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plainspoken.language.emphasis import Weight, emphases


def marked(text: str) -> list[tuple[str, Weight]]:
    return [(text[each.start : each.end], each.weight) for each in emphases(text)]


N, L, D = Weight.NEGATION, Weight.LIMIT, Weight.NUMBER


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Go to the dock.", []),
        ("Never enter line 3.", [("Never", N), ("3", D)]),
        ("Don't go until it's full", [("Don't", N), ("until", L)]),
        ("Don\u2019t, please", [("Don\u2019t", N)]),
        ("you cannot stop", [("cannot", N), ("stop", N)]),
        ("it must not be, and dont", [("not", N), ("dont", N)]),
        ("Visit row two twice", [("two", D), ("twice", D)]),
        ("line2 only", [("2", D), ("only", L)]),
        ("the second aisle, without the cart", [("second", D), ("without", N)]),
        ("A note for the notary", []),
        ("NEVER!", [("NEVER", N)]),
        ("", []),
    ],
)
def test_negations_limits_and_numbers_are_marked_as_whole_words(
    text: str, expected: list[tuple[str, Weight]]
) -> None:
    assert marked(text) == expected


@given(st.text(max_size=200))
def test_marks_lie_in_the_text_in_its_order_and_do_not_overlap(text: str) -> None:
    end = 0
    for each in emphases(text):
        assert end <= each.start < each.end <= len(text)
        end = each.end
