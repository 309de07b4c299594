"""Formulas as values: building, taking apart, replacing, and the negation normal form."""

from itertools import product

import pytest
from hypothesis import given
from tests.strategies import formulas, traces

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
    atoms,
    children,
    conjunction,
    conjuncts,
    disjunction,
    negation_normal_form,
    rebuilt,
    subformulas,
    substituted,
)
from plainspoken.logic.trace import Trace, holds

a, b, c = Atom("a"), Atom("b"), Atom("c")

ONE_OF_EACH: tuple[Formula, ...] = (
    TRUE,
    a,
    Not(a),
    And((a, b)),
    Or((a, b)),
    Implies(a, b),
    Iff(a, b),
    Next(a),
    WeakNext(a),
    Eventually(a),
    Always(a),
    Until(a, b),
    WeakUntil(a, b),
    Release(a, b),
)


@pytest.mark.parametrize(
    ("operands", "expected"),
    [
        ((), TRUE),
        ((a,), a),
        ((a, b), And((a, b))),
        ((a, TRUE, b), And((a, b))),
        ((And((a, b)), c), And((a, b, c))),
        ((a, Or((b, c))), And((a, Or((b, c))))),
        ((FALSE, a), And((FALSE, a))),
    ],
)
def test_a_conjunction_is_flat_and_leaves_out_true(
    operands: tuple[Formula, ...], expected: Formula
) -> None:
    assert conjunction(*operands) == expected


@pytest.mark.parametrize(
    ("operands", "expected"),
    [
        ((), FALSE),
        ((a,), a),
        ((a, FALSE, b), Or((a, b))),
        ((a, Or((b, c))), Or((a, b, c))),
        ((TRUE, a), Or((TRUE, a))),
    ],
)
def test_a_disjunction_is_flat_and_leaves_out_false(
    operands: tuple[Formula, ...], expected: Formula
) -> None:
    assert disjunction(*operands) == expected


def test_the_conjuncts_are_those_at_the_top_only() -> None:
    assert conjuncts(And((a, Or((b, c)), Always(And((a, b)))))) == (
        a,
        Or((b, c)),
        Always(And((a, b))),
    )
    assert conjuncts(Or((a, b))) == (Or((a, b)),)


def test_subformulas_come_parts_before_wholes() -> None:
    formula = Until(Not(a), And((b, a)))
    assert list(subformulas(formula)) == [a, Not(a), b, a, And((b, a)), formula]


def test_the_atoms_of_a_formula_are_named_once_and_constants_are_none() -> None:
    assert atoms(Implies(Until(a, TRUE), Or((b, a)))) == {"a", "b"}


@pytest.mark.parametrize("formula", ONE_OF_EACH, ids=lambda f: type(f).__name__)
def test_every_operator_can_be_rebuilt_over_changed_operands(formula: Formula) -> None:
    changed = rebuilt(formula, Always)
    assert type(changed) is type(formula)
    assert children(changed) == tuple(map(Always, children(formula)))


@pytest.mark.parametrize("formula", ONE_OF_EACH, ids=lambda f: type(f).__name__)
def test_every_operator_is_a_value_that_can_be_compared_and_hashed(formula: Formula) -> None:
    again = rebuilt(formula, lambda part: part)
    assert again == formula
    assert hash(again) == hash(formula)
    assert len({*ONE_OF_EACH, again}) == len(ONE_OF_EACH)


def test_a_replaced_atom_is_replaced_everywhere_and_only_it() -> None:
    formula = Release(a, And((b, Next(a))))
    replaced = substituted(formula, lambda name: Eventually(c) if name == "a" else Atom(name))
    assert replaced == Release(Eventually(c), And((b, Next(Eventually(c)))))


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        (Not(TRUE), FALSE),
        (Not(Not(a)), a),
        (Not(And((a, b))), Or((Not(a), Not(b)))),
        (Not(Or((a, b))), And((Not(a), Not(b)))),
        (Implies(a, b), Or((Not(a), b))),
        (Not(Implies(a, b)), And((a, Not(b)))),
        (Iff(a, b), Or((And((a, b)), And((Not(a), Not(b)))))),
        (Not(Iff(a, b)), Or((And((a, Not(b))), And((Not(a), b))))),
        (Not(Next(a)), WeakNext(Not(a))),
        (Not(WeakNext(a)), Next(Not(a))),
        (Not(Eventually(a)), Always(Not(a))),
        (Not(Always(a)), Eventually(Not(a))),
        (Not(Until(a, b)), Release(Not(a), Not(b))),
        (Not(Release(a, b)), Until(Not(a), Not(b))),
        (WeakUntil(a, b), Release(b, Or((a, b)))),
        (Not(WeakUntil(a, b)), Until(Not(b), And((Not(a), Not(b))))),
    ],
)
def test_the_negation_normal_form_of_each_operator(formula: Formula, expected: Formula) -> None:
    assert negation_normal_form(formula) == expected


@given(formulas())
def test_in_negation_normal_form_only_atoms_are_negated(formula: Formula) -> None:
    for part in subformulas(negation_normal_form(formula)):
        assert not isinstance(part, (Implies, Iff, WeakUntil))
        assert not isinstance(part, Not) or isinstance(part.operand, Atom)


@given(formulas(), traces())
def test_the_negation_normal_form_means_the_same(formula: Formula, trace: Trace) -> None:
    assert holds(negation_normal_form(formula), trace) == holds(formula, trace)


@pytest.mark.parametrize("truth", [*product((True, False), repeat=2)])
def test_constants_take_part_like_any_formula(truth: tuple[bool, bool]) -> None:
    left, right = map(Constant, truth)
    trace = [frozenset[str]()]
    assert holds(And((left, right)), trace) == all(truth)
    assert holds(Or((left, right)), trace) == any(truth)
    assert holds(Implies(left, right), trace) == (truth[1] if truth[0] else True)
    assert holds(Iff(left, right), trace) == (truth[0] is truth[1])
