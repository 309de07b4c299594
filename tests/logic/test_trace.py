"""What satisfaction means, each operator against a table made by hand."""

from itertools import product

import pytest

from plainspoken.logic.formula import Always, Atom, Eventually
from plainspoken.logic.syntax import parse
from plainspoken.logic.trace import Trace, holds

Verdicts = dict[str, bool]

# A trace is written as its instants with the propositions true at each: "a|ab|" has three
# instants, the last with none. Every line was worked out on paper from the definition.
TABLE: dict[str, Verdicts] = {
    "a": {"a": True, "": False, "a|": True, "|a": False},
    "true": {"": True, "|": True},
    "false": {"": False, "a|b": False},
    "!a": {"a": False, "": True, "|a": True},
    "a & b": {"ab": True, "a": False, "b": False, "": False},
    "a | b": {"ab": True, "a": True, "b": True, "": False},
    "a -> b": {"ab": True, "a": False, "b": True, "": True},
    "a <-> b": {"ab": True, "a": False, "b": False, "": True},
    # strong next: false where there is no next instant, whatever it asks for
    "X a": {"a": False, "|a": True, "a|": False, "||a": False},
    "X true": {"": False, "|": True},
    "X false": {"": False, "|": False},
    "!X a": {"a": True, "|a": False, "a|": True},
    # weak next: true where there is no next instant
    "WX a": {"": True, "|a": True, "a|": False},
    "WX false": {"": True, "|": False},
    "X X a": {"a|a": False, "||a": True, "|a|": False},
    "WX WX a": {"a": True, "|": True, "||a": True, "||": False},
    "X WX a": {"": False, "|": True, "||a": True, "||": False},
    "F a": {"a": True, "": False, "|a": True, "||a": True, "a||": True, "||": False},
    "G a": {"a": True, "": False, "a|a": True, "a|": False, "|a": False, "a|a|a": True},
    "G X true": {"": False, "|": False, "||": False},
    "F WX false": {"": True, "|": True, "||": True},
    "G F a": {"a": True, "a|": False, "|a": True, "a||a": True},
    "F G a": {"a": True, "a|": False, "|a": True, "|a|a": True},
    # the left of an until need not hold where the right does
    "a U b": {
        "b": True,
        "a": False,
        "": False,
        "a|b": True,
        "|b": False,
        "a|a": False,
        "a|a|b": True,
        "a||b": False,
        "b||": True,
    },
    "a W b": {
        "b": True,
        "a": True,
        "": False,
        "a|b": True,
        "a|a": True,
        "a|": False,
        "a|a|": False,
    },
    # the right of a release has to hold where the left does as well
    "a R b": {
        "b": True,
        "a": False,
        "ab": True,
        "": False,
        "b|b": True,
        "b|": False,
        "ab|": True,
        "b|ab|": True,
        "b|a": False,
        "b|b|b": True,
    },
    "true U a": {"|a": True, "||": False},
    "false R a": {"a|a": True, "a|": False},
    "a U (b U c)": {"c": True, "b|c": True, "a|b|c": True, "b|a|c": False, "a|c": True},
    "(a U b) U c": {"c": True, "ab|c": True, "b|c": True, "a|c": False, "a|b|c": True},
    "G(a -> F b)": {"a": False, "": True, "a|b": True, "a|b|a": False, "ab": True, "a|a|b": True},
    "G(a -> X b)": {"a": False, "a|b": True, "a|b|a": False, "": True, "a|ab|b": True},
    "G(a -> WX b)": {"a": True, "a|b": True, "a|b|a": True, "a|": False},
    "F(a & X F b)": {"ab": False, "a|b": True, "b|a": False, "a||b": True, "|ab|b": True},
    "!b U a": {"": False, "a": True, "b": False, "|a": True, "b|a": False, "|b|a": False},
}


def read(trace: str) -> Trace:
    return [frozenset(instant) for instant in trace.split("|")]


@pytest.mark.parametrize(
    ("formula", "trace", "expected"),
    [(f, t, expected) for f, verdicts in TABLE.items() for t, expected in verdicts.items()],
)
def test_an_operator_on_a_trace_gives_what_the_table_says(
    formula: str, trace: str, *, expected: bool
) -> None:
    assert holds(parse(formula), read(trace)) is expected


def every_trace(propositions: str, longest: int) -> list[Trace]:
    letters = [
        frozenset(p for p, chosen in zip(propositions, bits, strict=True) if chosen)
        for bits in product((False, True), repeat=len(propositions))
    ]
    return [t for length in range(1, longest + 1) for t in product(letters, repeat=length)]


def first(trace: Trace, name: str) -> int:
    """The first instant where a proposition is true, the trace's length if there is none."""
    return next((i for i, letter in enumerate(trace) if name in letter), len(trace))


@pytest.mark.parametrize("trace", every_trace("ab", 3))
def test_the_temporal_operators_are_about_first_instants(trace: Trace) -> None:
    """The same operators, said another way: by the first instant where a is false, b is true."""
    last = len(trace) - 1
    a_stops = next((i for i, letter in enumerate(trace) if "a" not in letter), len(trace))
    b_stops = next((i for i, letter in enumerate(trace) if "b" not in letter), len(trace))
    assert holds(parse("F b"), trace) == (first(trace, "b") <= last)
    assert holds(parse("G a"), trace) == (a_stops > last)
    assert holds(parse("a U b"), trace) == (first(trace, "b") <= min(last, a_stops))
    assert holds(parse("a W b"), trace) == (first(trace, "b") <= a_stops)
    assert holds(parse("a R b"), trace) == (b_stops > last or first(trace, "a") < b_stops)


def test_a_formula_is_judged_from_the_instant_asked_about() -> None:
    trace = read("a||a")
    assert [holds(Atom("a"), trace, at) for at in range(3)] == [True, False, True]
    assert [holds(Always(Atom("a")), trace, at) for at in range(3)] == [False, False, True]
    assert [holds(parse("X a"), trace, at) for at in range(3)] == [False, True, False]


@pytest.mark.parametrize(("trace", "at"), [("a|", 2), ("a", -1), ("a|a", 7)])
def test_an_instant_outside_the_trace_is_an_error_of_the_caller(trace: str, at: int) -> None:
    with pytest.raises(ValueError, match="outside a trace"):
        holds(Eventually(Atom("a")), read(trace), at)


def test_an_empty_trace_is_an_error_of_the_caller() -> None:
    with pytest.raises(ValueError, match="0 instants"):
        holds(parse("true"), [])
