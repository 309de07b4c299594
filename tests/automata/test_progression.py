"""Progression against the semantics; what one residual says of another."""

from collections.abc import Callable
from functools import reduce
from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.strategies import formulas, traces

from plainspoken.automata.progression import (
    NO_INSTANT_LEFT,
    SOME_INSTANT_LEFT,
    all_of,
    any_of,
    entails,
    progress,
    remaining,
    satisfied_at_end,
)
from plainspoken.logic.formula import (
    FALSE,
    TRUE,
    Always,
    And,
    Atom,
    Constant,
    Eventually,
    Formula,
    Iff,
    Implies,
    Next,
    Not,
    Or,
    Release,
    Until,
    WeakNext,
    WeakUntil,
    negation_normal_form,
)
from plainspoken.logic.syntax import parse
from plainspoken.logic.trace import Trace, holds

LETTERS = tuple(map(frozenset, ("", "a", "b", "ab")))
SHORT_TRACES: tuple[Trace, ...] = tuple(
    trace for length in range(1, 4) for trace in product(LETTERS, repeat=length)
)


def holds_on_nothing(residual: Formula) -> bool:
    """What a residual is worth over no instants at all, from the definitions alone.

    There is no instant to be true at, so what asks for one (a literal, `X`, `F`, `U`) is false,
    and what speaks of every one there is (`WX`, `G`, `R`) is true.
    """
    match residual:
        case Constant(value):
            return value
        case And(operands):
            return all(holds_on_nothing(f) for f in operands)
        case Or(operands):
            return any(holds_on_nothing(f) for f in operands)
        case WeakNext() | Always() | Release():
            return True
        case Atom() | Not() | Next() | Eventually() | Until():
            return False
        case Implies() | Iff() | WeakUntil():
            raise AssertionError("residuals are in negation normal form")


@given(formulas(), traces())
def test_progressing_to_the_end_agrees_with_the_semantics(formula: Formula, trace: Trace) -> None:
    assert satisfied_at_end(reduce(progress, trace, formula)) == holds(formula, trace)


@given(formulas(), traces(), traces())
def test_after_some_instants_a_residual_says_what_the_formula_says_of_the_rest(
    formula: Formula, seen: Trace, rest: Trace
) -> None:
    assert holds(reduce(progress, seen, formula), rest) == holds(formula, [*seen, *rest])


@pytest.mark.parametrize(
    ("formula", "letter", "left"),
    [
        ("a", "a", TRUE),
        ("a", "", FALSE),
        ("!a", "a", FALSE),
        ("a & b", "a", FALSE),
        ("a | b", "a", TRUE),
        ("F a", "a", TRUE),
        ("F a", "", parse("F a")),
        ("G a", "a", parse("G a")),
        ("G a", "", FALSE),
        ("a U b", "a", parse("a U b")),
        ("a U b", "b", TRUE),
        ("a U b", "", FALSE),
        ("a R b", "b", parse("a R b")),
        ("a R b", "ab", TRUE),
        ("a R b", "a", FALSE),
        ("X a", "a", And((parse("a"), SOME_INSTANT_LEFT))),
        ("WX a", "", Or((parse("a"), NO_INSTANT_LEFT))),
        ("G(a -> X b)", "", parse("G(!a | X b)")),
        ("G(a -> F b)", "a", parse("F b & G(!a | F b)")),
        ("true", "", TRUE),
    ],
)
def test_what_is_left_of_a_formula_after_an_instant(
    formula: str, letter: str, left: Formula
) -> None:
    assert progress(parse(formula), frozenset(letter)) == left


@pytest.mark.parametrize(
    ("residual", "expected"),
    [
        ("true", True),
        ("false", False),
        ("a", False),
        ("!a", False),
        ("X true", False),
        ("WX false", True),
        ("F a", False),
        ("G a", True),
        ("a U true", False),
        ("a R false", True),
        ("a W b", True),
        ("F a & G a", False),
        ("F a | G a", True),
        ("!F a", True),
        ("F true", False),
        ("G false", True),
    ],
)
def test_over_no_instants_what_asks_for_one_is_false_and_what_speaks_of_all_is_true(
    residual: str, *, expected: bool
) -> None:
    assert satisfied_at_end(parse(residual)) is expected


@pytest.mark.parametrize(
    ("joined", "operands", "expected"),
    [
        (all_of, "", TRUE),
        (all_of, "a a", Atom("a")),
        (all_of, "a true b a", And((Atom("a"), Atom("b")))),
        (all_of, "a false", FALSE),
        (any_of, "", FALSE),
        (any_of, "b b", Atom("b")),
        (any_of, "a false b a", Or((Atom("a"), Atom("b")))),
        (any_of, "a true", TRUE),
    ],
)
def test_residuals_are_joined_without_repetition_and_constants_are_worked_out(
    joined: Callable[..., Formula], operands: str, expected: Formula
) -> None:
    assert joined(*map(parse, operands.split())) == expected


@given(formulas(), traces(longest=4), traces(longest=4))
def test_what_remains_is_about_a_trace_that_begins_at_the_current_instant(
    formula: Formula, seen: Trace, later: Trace
) -> None:
    left = remaining(formula, seen)
    assert holds(left, [seen[-1], *later]) == holds(formula, [*seen, *later])
    assert holds(left, [seen[-1]]) == holds(formula, seen)


@given(formulas(), traces(longest=4), traces(longest=4))
def test_what_remains_does_not_read_the_current_instant_again(
    formula: Formula, seen: Trace, later: Trace
) -> None:
    left = remaining(formula, seen)
    assert holds(left, [frozenset(), *later]) == holds(left, [frozenset("abc"), *later])


@pytest.mark.parametrize(
    ("formula", "seen", "left"),
    [
        ("F a", ["a"], "true"),
        ("G a", [""], "false"),
        ("F a", ["b"], "X F a"),
        ("G a", ["a"], "WX G a"),
        ("F(a & X F b)", ["a", ""], "X(F b | F(a & X F b))"),
    ],
)
def test_what_remains_of_a_formula(formula: str, seen: list[str], left: str) -> None:
    found = remaining(parse(formula), map(frozenset, seen))
    for trace in SHORT_TRACES:
        assert holds(found, trace) == holds(parse(left), trace)


@st.composite
def _entailing_pairs(draw: st.DrawFn) -> tuple[Formula, Formula]:
    """Two residuals, often built of the same parts so that one may entail the other."""
    parts = st.sampled_from(
        [*draw(st.lists(formulas(("a", "b"), 3), min_size=2, max_size=3)), Atom("a"), TRUE]
    )
    wrapped = st.one_of(
        parts,
        st.builds(lambda kind, f: kind(f), st.sampled_from((Eventually, Always, Next)), parts),
        st.builds(
            lambda kind, f, g: kind(f, g),
            st.sampled_from((Until, Release, WeakUntil)),
            parts,
            parts,
        ),
        st.builds(lambda kind, f, g: kind((f, g)), st.sampled_from((And, Or)), parts, parts),
    )
    return negation_normal_form(draw(wrapped)), negation_normal_form(draw(wrapped))


@given(_entailing_pairs())
def test_one_residual_entails_another_only_if_it_does_on_every_trace_and_on_none(
    pair: tuple[Formula, Formula],
) -> None:
    stronger, weaker = pair
    if entails(stronger, weaker):
        assert holds_on_nothing(weaker) or not holds_on_nothing(stronger)
        for trace in SHORT_TRACES:
            assert holds(weaker, trace) or not holds(stronger, trace)


@pytest.mark.parametrize(
    ("stronger", "weaker", "expected"),
    [
        ("false", "a", True),
        ("a", "true", True),
        ("F a", "F a", True),
        ("F a & G b", "F a", True),
        ("F a", "F a | G b", True),
        ("F(a & b)", "F a", True),
        ("F(a & F b)", "F b", True),
        ("a U b", "F b", True),
        ("G a", "G(a | b)", True),
        ("G a", "false R a", True),
        ("(a & b) U a", "b U a", True),
        ("a", "F a", True),
        ("b U c", "a U (b U c)", True),
        ("G(a & b)", "G G a", True),
        ("F F a", "F a", True),
        ("a", "F true", True),
        # not on no instants, where G is true and F is false
        ("G a", "F a", False),
        ("G a", "a", False),
        ("G a", "a U a", False),
        ("WX a", "F true", False),
        ("F a", "G a", False),
        ("F a", "F b", False),
        ("F a", "a", False),
        ("a U b", "a", False),
        ("a R b", "b", False),
        ("a R b", "a R c", False),
        ("a R c", "b R c", False),
        ("a U b", "a U c", False),
        ("a U c", "b U c", False),
        ("G a", "G b", False),
        ("G a", "b R c", False),
        ("(a & b) R (b & c)", "a R c", True),
    ],
)
def test_a_few_plain_entailments_are_seen(stronger: str, weaker: str, *, expected: bool) -> None:
    pair = (negation_normal_form(parse(stronger)), negation_normal_form(parse(weaker)))
    assert entails(*pair) is expected


def test_entailment_between_deep_formulas_is_quick() -> None:
    formula: Formula = Atom("a")
    for index in range(40):
        formula = Eventually(And((formula, Atom(f"b{index}"))))
    assert entails(formula, Eventually(Atom("b3")))
    assert not entails(formula, Eventually(Atom("c")))
