"""The running verdict: four values, the way to close what is open, and the semantics at the end."""

import pytest
from hypothesis import given
from tests.strategies import formulas, traces

from plainspoken.automata.verdict import Monitor, Verdict
from plainspoken.logic.formula import Formula
from plainspoken.logic.syntax import parse
from plainspoken.logic.trace import Letter, Trace, holds

SATISFIED, SO_FAR, OPEN, VIOLATED = (
    Verdict.SATISFIED,
    Verdict.HOLDS_SO_FAR,
    Verdict.OPEN,
    Verdict.VIOLATED,
)


def read(trace: str) -> list[Letter]:
    return [frozenset(instant) for instant in trace.split("|")]


@pytest.mark.parametrize(
    ("formula", "trace", "verdicts"),
    [
        ("F a", "|b|a|", [OPEN, OPEN, SATISFIED, SATISFIED]),
        ("G a", "a|a||a", [SO_FAR, SO_FAR, VIOLATED, VIOLATED]),
        ("a U b", "a|a|b|", [OPEN, OPEN, SATISFIED, SATISFIED]),
        ("a U b", "a||b", [OPEN, VIOLATED, VIOLATED]),
        ("a W b", "a|b|", [SO_FAR, SATISFIED, SATISFIED]),
        ("G(a -> F b)", "|a||b|a", [SO_FAR, OPEN, OPEN, SO_FAR, OPEN]),
        ("X a", "|a", [OPEN, SATISFIED]),
        ("WX a", "|", [SO_FAR, VIOLATED]),
        ("true", "|", [SATISFIED, SATISFIED]),
        ("false", "|", [VIOLATED, VIOLATED]),
        ("F a & G b", "b|ab|", [OPEN, SO_FAR, VIOLATED]),
    ],
)
def test_the_verdict_after_each_instant(formula: str, trace: str, verdicts: list[Verdict]) -> None:
    monitor = Monitor.of(parse(formula))
    found = []
    for letter in read(trace):
        monitor = monitor.after(letter)
        found.append(monitor.verdict)
    assert found == verdicts


@given(formulas(), traces())
def test_a_trace_that_ends_now_satisfies_the_formula_just_if_the_verdict_says_so(
    formula: Formula, trace: Trace
) -> None:
    verdict = Monitor.of(formula).after_all(trace).verdict
    assert (verdict in (SATISFIED, SO_FAR)) == holds(formula, trace)


@given(formulas(), traces(longest=4), traces(longest=4))
def test_a_verdict_for_good_is_never_taken_back(formula: Formula, seen: Trace, rest: Trace) -> None:
    before = Monitor.of(formula).after_all(seen)
    if before.verdict in (SATISFIED, VIOLATED):
        assert before.after_all(rest).verdict is before.verdict


@given(formulas(), traces(longest=4))
def test_what_closes_a_part_makes_it_hold_and_nothing_shorter_does(
    formula: Formula, seen: Trace
) -> None:
    for part in Monitor.of(formula).after_all(seen).parts:
        way = part.closing()
        if way is None:
            assert part.verdict is VIOLATED
            continue
        trace = [*seen, *(guard.positive for guard in way)]
        assert holds(part.formula, trace)
        for length in range(len(way)):
            assert not holds(part.formula, trace[: len(seen) + length])


@pytest.mark.parametrize(
    ("formula", "trace", "demands"),
    [
        ("F a", "", ["a"]),
        ("F a", "a", []),
        ("F(a & X F b)", "", ["a", "b"]),
        ("F(a & b)", "", ["ab"]),
        ("a U (b & X c)", "a", ["b", "c"]),
        ("(F(a & b & c)) | F d", "", ["d"]),
    ],
)
def test_the_way_to_close_a_part_asks_for_as_little_as_can_be(
    formula: str, trace: str, demands: list[str]
) -> None:
    (part,) = Monitor.of(parse(formula)).after_all(read(trace)).parts
    way = part.closing()
    assert way is not None
    assert [guard.positive for guard in way] == [frozenset(letters) for letters in demands]


def test_a_part_that_is_lost_has_no_way_to_close() -> None:
    (part,) = Monitor.of(parse("G a")).after_all(read("")).parts
    assert part.closing() is None


def test_the_parts_are_the_conjuncts_as_they_are_written() -> None:
    formula = parse("!F a & (b -> c)")
    assert [part.formula for part in Monitor.of(formula).parts] == [parse("!F a"), parse("b -> c")]


def test_a_monitor_is_a_value_and_an_instant_makes_a_new_one() -> None:
    before = Monitor.of(parse("F a"))
    after = before.after(frozenset("a"))
    assert before.verdict is OPEN
    assert after.verdict is SATISFIED
    assert before.after(frozenset("a")) == after


def test_two_parts_that_cannot_both_be_met_stay_open_until_one_is_lost() -> None:
    monitor = Monitor.of(parse("F a & G !a"))
    assert [part.verdict for part in monitor.parts] == [OPEN, SO_FAR]
    assert monitor.verdict is OPEN
    assert monitor.after(frozenset("a")).verdict is VIOLATED
