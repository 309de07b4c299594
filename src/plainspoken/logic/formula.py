"""LTLf formulas as frozen values, to be matched and not visited.

Source: De Giacomo and Vardi, Linear Temporal Logic and Linear Dynamic Logic on Finite Traces,
IJCAI 2013, section 2. `Next` is strong (there is a next instant), `WeakNext` is weak.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import assert_never


@dataclass(frozen=True, slots=True)
class Constant:
    """`true` or `false`."""

    value: bool


@dataclass(frozen=True, slots=True)
class Atom:
    """A proposition: the id of a landmark, a ground atom or an action symbol."""

    name: str


@dataclass(frozen=True, slots=True)
class Not:
    operand: Formula


@dataclass(frozen=True, slots=True)
class And:
    """All operands hold. At least two operands; see `conjunction` for any number."""

    operands: tuple[Formula, ...]


@dataclass(frozen=True, slots=True)
class Or:
    """Some operand holds. At least two operands; see `disjunction` for any number."""

    operands: tuple[Formula, ...]


@dataclass(frozen=True, slots=True)
class Implies:
    left: Formula
    right: Formula


@dataclass(frozen=True, slots=True)
class Iff:
    left: Formula
    right: Formula


@dataclass(frozen=True, slots=True)
class Next:
    operand: Formula


@dataclass(frozen=True, slots=True)
class WeakNext:
    operand: Formula


@dataclass(frozen=True, slots=True)
class Eventually:
    operand: Formula


@dataclass(frozen=True, slots=True)
class Always:
    operand: Formula


@dataclass(frozen=True, slots=True)
class Until:
    """`left` holds until `right` does, and `right` does at some instant."""

    left: Formula
    right: Formula


@dataclass(frozen=True, slots=True)
class WeakUntil:
    """`left` holds until `right` does, or to the end."""

    left: Formula
    right: Formula


@dataclass(frozen=True, slots=True)
class Release:
    """`right` holds up to and including the instant where `left` does, or to the end."""

    left: Formula
    right: Formula


Unary = Not | Next | WeakNext | Eventually | Always
Binary = Implies | Iff | Until | WeakUntil | Release
Formula = Constant | Atom | And | Or | Unary | Binary

TRUE = Constant(True)
FALSE = Constant(False)


def conjunction(*operands: Formula) -> Formula:
    """`And` of any number of operands: `true` of none, the operand itself of one."""
    return _flattened(And, operands, neutral=TRUE)


def disjunction(*operands: Formula) -> Formula:
    """`Or` of any number of operands: `false` of none, the operand itself of one."""
    return _flattened(Or, operands, neutral=FALSE)


def _flattened(kind: type[And | Or], operands: tuple[Formula, ...], neutral: Constant) -> Formula:
    flat: list[Formula] = []
    for operand in operands:
        flat.extend(operand.operands if isinstance(operand, kind) else (operand,))
    kept = [operand for operand in flat if operand != neutral]
    if not kept:
        return neutral
    return kept[0] if len(kept) == 1 else kind(tuple(kept))


def conjuncts(formula: Formula) -> tuple[Formula, ...]:
    """The operands of a conjunction at the top, or the formula alone."""
    return formula.operands if isinstance(formula, And) else (formula,)


def children(formula: Formula) -> tuple[Formula, ...]:
    """The direct subformulas, left to right."""
    match formula:
        case Constant() | Atom():
            return ()
        case And(operands) | Or(operands):
            return operands
        case Not(f) | Next(f) | WeakNext(f) | Eventually(f) | Always(f):
            return (f,)
        case (
            Implies(left, right)
            | Iff(left, right)
            | Until(left, right)
            | WeakUntil(left, right)
            | Release(left, right)
        ):
            return (left, right)
        case _:
            assert_never(formula)


def subformulas(formula: Formula) -> Iterator[Formula]:
    """Every subformula, parts before wholes, the formula itself last."""
    for child in children(formula):
        yield from subformulas(child)
    yield formula


def atoms(formula: Formula) -> frozenset[str]:
    """The names of the propositions that occur."""
    return frozenset(part.name for part in subformulas(formula) if isinstance(part, Atom))


def rebuilt(formula: Formula, change: Callable[[Formula], Formula]) -> Formula:
    """The same operator over changed operands."""
    match formula:
        case Constant() | Atom():
            return formula
        case And(operands) | Or(operands):
            return type(formula)(tuple(map(change, operands)))
        case Not(f) | Next(f) | WeakNext(f) | Eventually(f) | Always(f):
            return type(formula)(change(f))
        case (
            Implies(left, right)
            | Iff(left, right)
            | Until(left, right)
            | WeakUntil(left, right)
            | Release(left, right)
        ):
            return type(formula)(change(left), change(right))
        case _:
            assert_never(formula)


def substituted(formula: Formula, replacement: Callable[[str], Formula]) -> Formula:
    """The formula with each atom replaced by what `replacement` says of its name."""
    if isinstance(formula, Atom):
        return replacement(formula.name)
    return rebuilt(formula, lambda part: substituted(part, replacement))


def negation_normal_form(formula: Formula) -> Formula:
    """An equivalent formula with `Not` on atoms only and without `Implies`, `Iff` or `WeakUntil`.

    On finite traces `!X f` is `WX !f`, and `a W b` is `b R (a | b)`.
    """
    return _positive(formula)


def _positive(formula: Formula) -> Formula:
    match formula:
        case Not(operand):
            return _negative(operand)
        case And(operands):
            return conjunction(*map(_positive, operands))
        case Or(operands):
            return disjunction(*map(_positive, operands))
        case Implies(left, right):
            return disjunction(_negative(left), _positive(right))
        case Iff(left, right):
            return disjunction(
                conjunction(_positive(left), _positive(right)),
                conjunction(_negative(left), _negative(right)),
            )
        case WeakUntil(left, right):
            hold, goal = _positive(left), _positive(right)
            return Release(goal, disjunction(hold, goal))
        case _:
            return rebuilt(formula, _positive)


def _negative(formula: Formula) -> Formula:
    match formula:
        case Constant(value):
            return Constant(not value)
        case Atom():
            return Not(formula)
        case Not(operand):
            return _positive(operand)
        case And(operands):
            return disjunction(*map(_negative, operands))
        case Or(operands):
            return conjunction(*map(_negative, operands))
        case Implies(left, right):
            return conjunction(_positive(left), _negative(right))
        case Iff(left, right):
            return disjunction(
                conjunction(_positive(left), _negative(right)),
                conjunction(_negative(left), _positive(right)),
            )
        case Next(operand):
            return WeakNext(_negative(operand))
        case WeakNext(operand):
            return Next(_negative(operand))
        case Eventually(operand):
            return Always(_negative(operand))
        case Always(operand):
            return Eventually(_negative(operand))
        case Until(left, right):
            return Release(_negative(left), _negative(right))
        case Release(left, right):
            return Until(_negative(left), _negative(right))
        case WeakUntil(left, right):
            # not (a W b) = !b U (!a & !b)
            return Until(_negative(right), conjunction(_negative(left), _negative(right)))
        case _:
            assert_never(formula)
