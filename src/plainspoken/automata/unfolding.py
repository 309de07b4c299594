"""One instant of a formula unfolded: for one letter, or for all letters at once as cubes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Generic, TypeVar

from plainspoken.automata.progression import NO_INSTANT_LEFT, SOME_INSTANT_LEFT
from plainspoken.automata.residual import DONE, LOST, Residual, Residuals
from plainspoken.logic.formula import (
    Always,
    And,
    Atom,
    Constant,
    Eventually,
    Formula,
    Next,
    Not,
    Or,
    Release,
    Until,
    WeakNext,
)

MOST_CUBES = 10_000
"""More cubes than this are given up (`TooManyCubes`)."""


class TooManyCubes(Exception):
    pass


V = TypeVar("V")


@dataclass(frozen=True, slots=True)
class Algebra(Generic[V]):
    """What the parts of an unfolded formula are worth: a residual, or one for each letter."""

    literal: Callable[[str, bool], V]
    residual: Callable[[Residual], V]
    meet: Callable[[V, V], V]
    join: Callable[[V, V], V]


def unfolded(
    formula: Formula,
    algebra: Algebra[V],
    residuals: Residuals,
    known: dict[Formula, V] | None = None,
) -> V:
    """One instant of progression: literals are about now, the rest is left for later.

    known: values of subformulas, where they can be kept from call to call
    """
    if known is None:
        known = {}
    if formula in known:
        return known[formula]
    meet, join = algebra.meet, algebra.join

    def now(part: Formula) -> V:
        return unfolded(part, algebra, residuals, known)

    def later(part: Formula) -> V:
        return algebra.residual(residuals.of(part))

    match formula:
        case Constant():
            value = later(formula)
        case Atom(name):
            value = algebra.literal(name, True)
        case Not(Atom(name)):
            value = algebra.literal(name, False)
        case And(operands):
            value = reduce(meet, map(now, operands))
        case Or(operands):
            value = reduce(join, map(now, operands))
        case Next(f):
            value = meet(later(f), later(SOME_INSTANT_LEFT))
        case WeakNext(f):
            value = join(later(f), later(NO_INSTANT_LEFT))
        case Eventually(f):
            value = join(now(f), later(formula))
        case Always(f):
            value = meet(now(f), later(formula))
        case Until(hold, goal):
            value = join(now(goal), meet(now(hold), later(formula)))
        case Release(release, hold):
            value = meet(now(hold), join(now(release), later(formula)))
        case _:
            raise AssertionError(f"not in negation normal form: {formula}")
    known[formula] = value
    return value


Cube = tuple[frozenset[str], frozenset[str], Residual]
Cubes = tuple[Cube, ...]
"""What is left after each letter: disjoint cubes that cover all letters."""


def cubes_of_literal(name: str, positive: bool) -> Cubes:  # noqa: FBT001 - an Algebra's literal is called by position
    """The two cubes of an atom or its negation."""
    one, none = frozenset({name}), frozenset[str]()
    return (
        (one, none, DONE if positive else LOST),
        (none, one, LOST if positive else DONE),
    )


def product_of_cubes(
    left: Cubes,
    right: Cubes,
    absorbing: Residual,
    combine: Callable[[Residual, Residual], Residual],
) -> Cubes:
    """The letters common to a cube of each side; none is split where one side decides alone."""
    found: list[Cube] = []
    for positive, negative, residual in left:
        if residual == absorbing:
            found.append((positive, negative, residual))
            continue
        for also_positive, also_negative, other in right:
            if not (positive & also_negative or negative & also_positive):
                joined = combine(residual, other)
                found.append((positive | also_positive, negative | also_negative, joined))
        if len(found) > MOST_CUBES:
            raise TooManyCubes
    return _merged(found)


def _merged(cubes: Sequence[Cube]) -> Cubes:
    """The same letters in fewer cubes: two that differ in one sign only become one."""
    often = Counter(residual for _, _, residual in cubes)
    found: dict[tuple[frozenset[str], frozenset[str]], Residual] = {}
    todo = [*reversed(cubes)]
    while todo:
        positive, negative, residual = todo.pop()
        for name in sorted(positive | negative) if often[residual] > 1 else ():
            other = (positive ^ {name}, negative ^ {name})
            if found.get(other) == residual:
                del found[other]
                todo.append((positive - {name}, negative - {name}, residual))
                break
        else:
            found[positive, negative] = residual
    return tuple((positive, negative, residual) for (positive, negative), residual in found.items())
