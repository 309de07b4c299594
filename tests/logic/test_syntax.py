"""Formulas as text: precedence by a table, errors with their column, and the way back."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.strategies import formulas

from plainspoken.errors import FormulaSyntaxError
from plainspoken.logic.formula import (
    FALSE,
    TRUE,
    Always,
    And,
    Atom,
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
from plainspoken.logic.syntax import (
    DEEPEST,
    MOST_DOUBLINGS,
    OPERATORS,
    SPELLINGS,
    is_proposition,
    parse,
    unparse,
)
from plainspoken.logic.trace import holds

a, b, c, d = map(Atom, "abcd")

READ: dict[str, Formula] = {
    "a": a,
    "true": TRUE,
    "false": FALSE,
    "robot_at_rob_l0": Atom("robot_at_rob_l0"),
    "!a": Not(a),
    "X a": Next(a),
    "WX a": WeakNext(a),
    "F a": Eventually(a),
    "G a": Always(a),
    "a U b": Until(a, b),
    "a W b": WeakUntil(a, b),
    "a R b": Release(a, b),
    "a & b": And((a, b)),
    "a | b": Or((a, b)),
    "a -> b": Implies(a, b),
    "a <-> b": Iff(a, b),
    # one operator against its neighbours, from the tightest to the loosest
    "!a U b": Until(Not(a), b),
    "F a U G b": Until(Eventually(a), Always(b)),
    "a U b & c": And((Until(a, b), c)),
    "a & b U c": And((a, Until(b, c))),
    "a & b | c & d": Or((And((a, b)), And((c, d)))),
    "a | b & c": Or((a, And((b, c)))),
    "a | b -> c | d": Implies(Or((a, b)), Or((c, d))),
    "a -> b <-> c -> d": Iff(Implies(a, b), Implies(c, d)),
    # chains
    "a & b & c": And((a, b, c)),
    "a | b | c": Or((a, b, c)),
    "a -> b -> c": Implies(a, Implies(b, c)),
    "a <-> b <-> c": Iff(Iff(a, b), c),
    "a U b W c R d": Until(a, WeakUntil(b, Release(c, d))),
    # parentheses
    "(a)": a,
    "((a))": a,
    "(a & b) & c": And((And((a, b)), c)),
    "a & (b & c)": And((a, And((b, c)))),
    "(a -> b) -> c": Implies(Implies(a, b), c),
    "(a U b) U c": Until(Until(a, b), c),
    "!(a & b)": Not(And((a, b))),
    "F(a & X b)": Eventually(And((a, Next(b)))),
    # prefixes run together or apart
    "GF a": Always(Eventually(a)),
    "FG(a)": Eventually(Always(a)),
    "XX a": Next(Next(a)),
    "!!a": Not(Not(a)),
    "!GF!a": Not(Always(Eventually(Not(a)))),
    "X!a": Next(Not(a)),
    # white space
    "  a\t&\n b ": And((a, b)),
    "a&b|c": Or((And((a, b)), c)),
    # names that begin like operators, or differ in case
    "Go & Wet & X1 & true_north": And((Atom("Go"), Atom("Wet"), Atom("X1"), Atom("true_north"))),
    "f & g & x & u": And((Atom("f"), Atom("g"), Atom("x"), Atom("u"))),
    "_a1": Atom("_a1"),
}

BROKEN = {
    "": (0, "the formula is empty"),
    "   ": (0, "the formula is empty"),
    "a b": (2, "expected an operator or the end"),
    "a)": (1, "expected an operator or the end"),
    "(a": (2, "expected an operator or ')'"),
    "(a b)": (3, "expected an operator or ')'"),
    "()": (1, "expected a proposition, a prefix operator or '('"),
    "a &": (3, "expected a proposition, a prefix operator or '('"),
    "& a": (0, "expected a proposition, a prefix operator or '('"),
    "F": (1, "expected a proposition, a prefix operator or '('"),
    "a U": (3, "expected a proposition, a prefix operator or '('"),
    "U a": (0, "expected a proposition, a prefix operator or '('"),
    "F (at & & mug)": (8, "expected a proposition, a prefix operator or '('"),
    "a ! b": (2, "expected an operator or the end"),
    "at(kitchen)": (2, "expected an operator or the end"),
    "a @ b": (2, "'@' is no part of a formula"),
    "a - b": (2, "'-' is no part of a formula"),
    "1a": (0, "'1' is no part of a formula"),
    "é": (0, "'é' is no part of a formula"),
    "a & \n F": (7, "expected a proposition, a prefix operator or '('"),
}


@pytest.mark.parametrize("text", READ)
def test_each_operator_binds_as_the_grammar_says(text: str) -> None:
    assert parse(text) == READ[text]


@pytest.mark.parametrize("spelling", SPELLINGS)
def test_the_spellings_of_other_tools_are_read(spelling: str) -> None:
    ours = SPELLINGS[spelling]
    text = f"{spelling} a" if ours == "!" else f"a {spelling} b"
    assert parse(text) == parse(text.replace(spelling, ours))


def test_two_signs_that_begin_alike_are_told_apart() -> None:
    assert parse("a<->b=>c&&!d||a") == Iff(a, Implies(b, Or((And((c, Not(d))), a))))


@pytest.mark.parametrize("text", BROKEN)
def test_a_bad_formula_names_the_column_that_broke_it(text: str) -> None:
    column, expected = BROKEN[text]
    with pytest.raises(FormulaSyntaxError) as caught:
        parse(text)
    assert (caught.value.column, caught.value.expected) == (column, expected)
    assert OPERATORS in str(caught.value)


@given(formulas())
def test_a_formula_written_and_read_again_is_the_same(formula: Formula) -> None:
    assert parse(unparse(formula)) == formula


@pytest.mark.parametrize("text", READ)
def test_what_was_read_can_be_written_and_read_again(text: str) -> None:
    assert parse(unparse(READ[text])) == READ[text]


@pytest.mark.parametrize(
    ("formula", "text"),
    [
        (And((Until(a, b), c)), "a U b & c"),
        (Or((And((a, b)), c)), "a & b | c"),
        (And((Or((a, b)), c)), "(a | b) & c"),
        (Until(And((a, b)), c), "(a & b) U c"),
        (Until(a, Until(b, c)), "a U (b U c)"),
        (Implies(a, Implies(b, c)), "a -> (b -> c)"),
        (Implies(And((a, b)), c), "(a & b) -> c"),
        (Eventually(And((a, b))), "F(a & b)"),
        (Always(Eventually(a)), "G F a"),
        (Not(Not(a)), "!!a"),
        (WeakNext(Until(a, b)), "WX(a U b)"),
    ],
)
def test_a_formula_is_written_with_parentheses_where_a_reader_would_want_them(
    formula: Formula, text: str
) -> None:
    assert unparse(formula) == text


@pytest.mark.parametrize(
    ("name", "is_one"),
    [
        ("full_b", True),
        ("A", True),
        ("_", True),
        ("f", True),
        ("FA", True),
        ("truefalse", True),
        ("F", False),
        ("U", False),
        ("WX", False),
        ("GF", False),
        ("XXX", False),
        ("true", False),
        ("", False),
        ("1a", False),
        ("robot-at", False),
        ("a b", False),
        ("a\n", False),
        ("é", False),
    ],
)
def test_a_name_is_a_proposition_if_it_can_stand_alone_in_a_formula(
    name: str, *, is_one: bool
) -> None:
    try:
        stands_alone = parse(name) == Atom(name)
    except FormulaSyntaxError:
        stands_alone = False
    assert is_proposition(name) is stands_alone is is_one


@pytest.mark.parametrize(
    "left", ["(", "!", "F(", "a -> ", "a U ", "(a & ", "a U (b & ", "(a R ", "X(b | "]
)
def test_a_formula_as_deep_as_allowed_is_read_written_and_judged(left: str) -> None:
    operators = sum(map(left.count, "!FX>U&|R"))
    count = DEEPEST // max(operators, 1)
    formula = parse(left * count + "b" + ")" * (count * left.count("(")))
    assert parse(unparse(formula)) == formula
    assert isinstance(holds(formula, [frozenset("a")]), bool)
    assert isinstance(holds(negation_normal_form(formula), [frozenset("a")]), bool)


@pytest.mark.parametrize(
    "text",
    [
        "(" * 100_000,
        "!" * 100_000 + "a",
        "F(" * 400 + "a" + ")" * 400,
        "a -> " * 20_000 + "a",
        "a U " * 20_000 + "a",
        "a <-> " * 20_000 + "a",
        "(a & " * 5_000 + "a" + ")" * 5_000,
        "a <-> b -> c | d & e U (" * 5_000,
    ],
    ids=lambda text: text[:12],
)
def test_a_formula_that_is_too_deep_is_refused_and_not_a_crash(text: str) -> None:
    with pytest.raises(FormulaSyntaxError) as caught:
        parse(text)
    assert "nested deeper" in str(caught.value) or "inside each other" in str(caught.value)


@pytest.mark.parametrize("operator", [" <-> ", " W "])
def test_operators_that_double_the_normal_form_are_limited_inside_each_other_only(
    operator: str,
) -> None:
    parse(operator.join("a" * (MOST_DOUBLINGS + 1)))
    parse(" & ".join([f"(a{operator}b)"] * 100))
    with pytest.raises(FormulaSyntaxError, match="inside each other"):
        parse(operator.join("a" * (MOST_DOUBLINGS + 2)))


def test_a_wide_formula_is_no_deep_one() -> None:
    assert parse(" | ".join(["a & b"] * 5_000)) == Or((And((a, b)),) * 5_000)


@given(st.text(alphabet="ab()!&|-<>XWFGUR tr@\n", max_size=25))
def test_any_text_is_a_formula_or_a_syntax_error_with_a_column_inside_it(text: str) -> None:
    column = 0
    try:
        formula = parse(text)
    except FormulaSyntaxError as error:
        column = error.column
    else:
        assert parse(unparse(formula)) == formula
    assert 0 <= column <= len(text)
