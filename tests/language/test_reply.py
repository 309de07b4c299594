"""The checked parse of what a language model replies."""

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.language.harbour import DOCK, HARBOUR, QUAY, SAID, SEQUENCE, reply

from plainspoken.language.reply import LONGEST_REPLY, UnusableReplyError, reading_from
from plainspoken.logic.formula import atoms
from plainspoken.logic.syntax import parse, unparse

TANK, REFUEL = ("the tank is full", "full_tank"), ("refuel", "refuel_executed")
BOTH = "Once the tank is full, refuel right after."

PROMPTLY = "(full_tank -> X refuel_executed) & G((!full_tank & X full_tank) -> X X refuel_executed)"


def test_a_good_reply_becomes_both_readings() -> None:
    found = reading_from(reply(SEQUENCE), SAID, HARBOUR)
    (reading,) = found.readings
    assert reading.literal == reading.executable == parse(SEQUENCE)
    assert reading.pattern == "sequenced visit"
    assert [each.text for each in found.expressions] == ["the quay", "the dock"]
    assert all(SAID[each.start : each.end] == each.text for each in found.expressions)


@pytest.mark.parametrize(
    ("literal", "executable", "spoken"),
    [
        (
            "G(full_tank -> X refuel_executed)",
            PROMPTLY,
            (TANK, REFUEL),
        ),
        (
            "G(refuel_executed -> X full_tank)",
            "G(refuel_executed -> X full_tank)",
            (TANK, REFUEL),
        ),
        ("!refuel_executed U full_tank", "!refuel_executed W full_tank", (TANK, REFUEL)),
        (
            "G(full_tank -> X G !refuel_executed)",
            "G(full_tank -> WX G !refuel_executed)",
            (TANK, REFUEL),
        ),
    ],
)
def test_the_executable_reading_is_derived_from_the_pattern_whatever_the_model_says(
    literal: str, executable: str, spoken: tuple[tuple[str, str], ...]
) -> None:
    said = reply((literal, "F full_tank & F refuel_executed"), spoken=spoken)
    (reading,) = reading_from(said, BOTH, HARBOUR).readings
    assert unparse(reading.executable) == unparse(parse(executable))


def test_a_formula_of_no_pattern_keeps_the_executable_formula_of_the_model() -> None:
    literal, executable = "F(at_quay & X X at_dock)", "F(at_quay & WX X at_dock)"
    (reading,) = reading_from(reply((literal, executable)), SAID, HARBOUR).readings
    assert reading.pattern is None
    assert reading.executable == parse(executable)


def test_a_reply_in_a_code_fence_is_read() -> None:
    assert reading_from(f"```json\n{reply(SEQUENCE)}\n```", SAID, HARBOUR).readings


HOSTILE = {
    "nothing": "",
    "prose": "Sure! The formula is F at_quay.",
    "a prompt leak": "You translate what a person tells a robot into temporal logic over the",
    "a list": "[]",
    "a number": "17",
    "half": reply(SEQUENCE)[:-5],
    "deep": "[" * 40_000,
    "huge": reply(" & ".join(["F at_quay"] * 10_000)),
    "longer than anything": "x" * (LONGEST_REPLY + 1),
    "no fields": "{}",
    "fields of another kind": '{"expressions": "the quay", "readings": 3}',
    "entries of another kind": '{"expressions": [1], "readings": [null]}',
    "formulas of another kind": '{"expressions": [], "readings": [{"literal": 1}]}',
    "too many readings": reply(*[f"{'X ' * i}at_quay" for i in range(9)]),
    "not a formula": reply("F (at_quay & & at_dock)"),
    "a long formula": reply(" & ".join(["F at_quay"] * 600)),
    "a deep formula": reply("!" * 1000 + "at_quay"),
    "a proposition that is no landmark": reply("F at_moon"),
    "a landmark of another id": reply("F at_quay", spoken=[("the quay", "at_moon")]),
    "an expression that was not said": reply("F at_tower", spoken=[("the tower", "at_tower")]),
    "an empty expression": reply("F at_tower", spoken=[("", "at_tower")]),
    "a symbol that nothing names": reply("F at_quay & F at_tower"),
    "true": reply("F true"),
    "false": reply("F true & G false"),
    "true beside a landmark": reply("F(at_quay | true)"),
    "another thing in the executable formula": reply(("F at_quay", "F at_dock")),
}


@pytest.mark.parametrize("text", HOSTILE.values(), ids=HOSTILE.keys())
def test_a_reply_that_cannot_be_used_is_an_error_that_can_be_fed_back(text: str) -> None:
    with pytest.raises(UnusableReplyError) as caught:
        reading_from(text, SAID, HARBOUR)
    assert caught.value.what
    assert len(str(caught.value)) < 600


def test_an_unknown_symbol_is_answered_with_the_nearest() -> None:
    with pytest.raises(UnusableReplyError, match="at_quai") as caught:
        reading_from(reply("F at_quai"), SAID, HARBOUR)
    assert "at_quay" in (caught.value.hint or "")


_words = st.sampled_from(
    ["at_quay", "at_dock", "at_moon", "F", "G", "X", "U", "&", "(", ")", "true"]
)


@given(st.lists(_words, max_size=8).map(" ".join), st.text(max_size=20))
def test_whatever_is_accepted_speaks_of_landmarks_alone(formula: str, junk: str) -> None:
    for text in (reply(formula), junk, json.dumps({"expressions": [], "readings": [junk]})):
        try:
            found = reading_from(text, SAID, HARBOUR)
        except UnusableReplyError:
            continue
        for each in found.readings:
            assert atoms(each.literal) | atoms(each.executable) <= {QUAY[1], DOCK[1]}
