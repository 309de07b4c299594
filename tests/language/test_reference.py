"""Where an utterance speaks of a symbol, and in which form."""

import pytest
from tests.language.domains import DOMAINS

from plainspoken.language.extraction import extract

BOTH_WAYS = (
    "You cannot call the support robot without visiting line 1 right before, and you cannot "
    "visit line 1 without calling the support robot right after that."
)


@pytest.mark.parametrize(
    ("sentence", "expected"),
    [
        ("Visit line two.", [("line two", "l2")]),
        ("Go to row 1.", [("row 1", "l1")]),
        ("Avoid harvesting a grape.", [("harvesting a grape", "harvest")]),
        ("Go to line 1 until the box gets full.", [("line 1", "l1"), ("box gets full", "full")]),
        ("If the bin is not full, ask a human.",
         [("bin is not full", "full"), ("ask a human", "ask")]),
        ("A grape must be harvested.", [("grape must be harvested", "harvest")]),
        ("Once line 2 has been cleared, go to the depot.",
         [("line 2 has been cleared", "cleared2"), ("depot", "wh")]),
        ("Visit lines 1 and 2.", [("lines 1", "l1"), ("2", "l2")]),
        ("Go to line2.", [("line2", "l2")]),
    ],
)  # fmt: skip
def test_expressions_carry_their_place(sentence: str, expected: list[tuple[str, str]]) -> None:
    found = extract(sentence, DOMAINS["vineyard"], None).referring_expressions
    assert [(each.text, each.symbol) for each in found] == expected
    for each in found:
        assert sentence[each.start : each.end] == each.text


@pytest.mark.parametrize(
    ("sentence", "formula"),
    [
        ("As soon as the box is full, call the support robot.",
         "(full -> X call) & G((!full & X full) -> X X call)"),
        ("As soon as you harvest a grape, drop a grape in the box.", "G(harvest -> X drop)"),
        ("Do not visit line 2 until line 1 is cleared.", "!l2 W cleared1"),
        ("After visiting line 2, never visit line 1.", "G(l2 -> WX G !l1)"),
        (BOTH_WAYS,
         "(l1 <-> X call) & G((!l1 & X l1) <-> X X call)"),
    ],
)  # fmt: skip
def test_the_executable_reading_follows_what_persists(sentence: str, formula: str) -> None:
    assert extract(sentence, DOMAINS["vineyard"], None).to_json()["formula"] == formula
