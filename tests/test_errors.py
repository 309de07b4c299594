"""Errors say what, where and what next, keep their fields, and survive a process boundary."""

import pickle

import pytest

from plainspoken.errors import (
    AmbiguousSymbolError,
    FormulaSyntaxError,
    FormulaTooLargeError,
    InputFileError,
    PlainspokenError,
    UnknownSymbolError,
)

ERRORS = [
    PlainspokenError("no robot", where="dock 3", hint="plug it in"),
    FormulaSyntaxError("F (a & & b)", 7, "expected a proposition", "operators: !"),
    FormulaTooLargeError("G(a -> F b)"),
    InputFileError("not JSON", "landmarks.json", line=3, column=14, hint="see docs"),
    UnknownSymbolError("full_c", ["full_b", "ripe_g0"], where="sentence 2"),
    AmbiguousSymbolError("at_a_b_c", ["(at a b-c)", "(at a-b c)"]),
]


def test_an_error_reads_as_what_where_and_what_next() -> None:
    error = PlainspokenError("no robot", where="dock 3\ndock 4", hint="plug it in")
    assert str(error) == "no robot\n  dock 3\n  dock 4\nhint: plug it in"


def test_an_error_without_a_place_or_advice_is_one_line() -> None:
    assert str(PlainspokenError("no robot")) == "no robot"


def test_a_formula_error_puts_a_caret_under_the_column() -> None:
    error = FormulaSyntaxError("F (a & & b)", 7, "expected a proposition", "operators: !")
    assert str(error).splitlines() == [
        "not an LTLf formula",
        "  F (a & & b)",
        "         ^ expected a proposition",
        "hint: operators: !",
    ]


@pytest.mark.parametrize("column", [0, 5, 150, 295, 300])
def test_a_caret_in_a_long_formula_stays_under_its_character(column: int) -> None:
    text = "a & " * 75
    text = text[:column] + "%" + text[column + 1 :]
    _, shown, caret, _ = str(FormulaSyntaxError(text, column, "no", "hint")).splitlines()
    assert shown[caret.index("^")] == "%"
    assert len(shown) < 85


@pytest.mark.parametrize("space", ["\n", "\t", "\r\n", "\x0b", "\x1b", "\u2028"])
def test_a_formula_on_several_lines_is_shown_on_one(space: str) -> None:
    text = f"a &{space}& b"
    lines = str(FormulaSyntaxError(text, text.rindex("&"), "no", "hint")).splitlines()
    assert len(lines) == 4
    assert lines[1][lines[2].index("^")] == "&"


@pytest.mark.parametrize(
    ("fields", "place"),
    [
        ({}, "d.pddl"),
        ({"line": 3}, "d.pddl:3"),
        ({"line": 3, "column": 7}, "d.pddl:3:7"),
        ({"field": "full_b.type"}, "d.pddl, field full_b.type"),
    ],
)
def test_a_file_error_names_the_place_as_far_as_it_is_known(
    fields: dict[str, object], place: str
) -> None:
    assert InputFileError("broken", "d.pddl", **fields).where == place


def test_an_unknown_symbol_is_answered_with_the_nearest_known_ones() -> None:
    error = UnknownSymbolError("full_box", ["full_b", "ripe_g0", "full_bx"])
    assert error.nearest == ("full_bx", "full_b")
    assert error.hint == "did you mean full_bx or full_b?"


def test_an_unknown_symbol_like_no_other_is_answered_with_a_command_that_lists_them() -> None:
    error = UnknownSymbolError("zzz", ["full_b"])
    assert error.nearest == ()
    assert "plainspoken doctor" in str(error)


@pytest.mark.parametrize("error", ERRORS, ids=lambda error: type(error).__name__)
def test_an_error_comes_out_of_another_process_as_it_went_in(error: PlainspokenError) -> None:
    copy = pickle.loads(pickle.dumps(error))  # noqa: S301 - the bytes are our own
    assert type(copy) is type(error)
    assert str(copy) == str(error)
    assert vars(copy) == vars(error)
    assert copy.args == error.args
