"""Action schemas and conditions with their quantifiers expanded, ready to be filled in.

A *row* is the arguments of one instance followed by the constants of its schema; atoms hold
places in the row, so that filling one in is a single look-up.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from itertools import product
from operator import itemgetter
from typing import assert_never

from plainspoken.world.domain import (
    Action,
    Add,
    AllOf,
    AnyOf,
    AtomCondition,
    Condition,
    Delete,
    Effect,
    Equal,
    Exists,
    ForAll,
    ForEach,
    NotCondition,
    OneOf,
    Parameter,
    Problem,
    Together,
    When,
)

Fact = tuple[str, ...]
"""A predicate and its arguments."""
Row = tuple[str, ...]
Place = int
Binding = Mapping[str, str]
"""Quantified variables and the objects that stand for them."""


@dataclass(frozen=True, slots=True)
class Literal:
    """An atom or its negation; `fact` fills in the places of a row."""

    predicate: str
    places: tuple[Place, ...]
    positive: bool
    fact: Callable[[Row], Fact] = field(compare=False)


@dataclass(frozen=True, slots=True)
class Same:
    """Two places hold the same object, or, not positive, different ones."""

    left: Place
    right: Place
    positive: bool


@dataclass(frozen=True, slots=True)
class Every:
    parts: tuple[Test, ...] = ()


@dataclass(frozen=True, slots=True)
class Some:
    parts: tuple[Test, ...] = ()


Test = Literal | Same | Every | Some


@dataclass(frozen=True, slots=True)
class Guarded:
    """Adds and deletes that happen in one outcome, where the test holds in the state before."""

    test: Every
    adds: tuple[Literal, ...]
    deletes: tuple[Literal, ...]


@dataclass(frozen=True, slots=True)
class Schema:
    """An action schema: its tests and its outcomes, each some guarded changes together.

    joins: the positive atoms that every instance needs, to find the instances by
    """

    action: Action
    constants: tuple[str, ...]
    joins: tuple[Literal, ...]
    test: Every
    outcomes: tuple[tuple[Guarded, ...], ...]


def schemas(problem: Problem, check: Callable[[], None] = lambda: None) -> tuple[Schema, ...]:
    """The action schemas of a problem, expanded over its objects.

    check: called for every schema; what it raises ends the expansion
    """
    found = []
    for action in problem.domain.actions:
        check()
        found.append(_Expansion(problem, action.parameters).schema(action))
    return tuple(found)


def goal_test(condition: Condition, problem: Problem) -> tuple[Test, Row]:
    """A condition without free variables, and the row to fill it in with."""
    expansion = _Expansion(problem, ())
    test = expansion.test(condition, {})
    return test, expansion.row


class _Expansion:
    """Expands one schema; gives each constant that it meets a place after the parameters."""

    def __init__(self, problem: Problem, parameters: tuple[Parameter, ...]) -> None:
        self._problem = problem
        # Of two parameters of one name the last counts, as in a mapping.
        self._places = {parameter.name: i for i, parameter in enumerate(parameters)}
        self._first_constant = len(parameters)
        self._constants: dict[str, Place] = {}
        self._literals: dict[tuple[tuple[Place, ...], bool], Literal] = {}

    @property
    def row(self) -> Row:
        return tuple(self._constants)

    def schema(self, action: Action) -> Schema:
        test = self.test(action.precondition, {})
        every = test if isinstance(test, Every) else Every((test,))
        outcomes = tuple(map(_merged, self._outcomes(action.effect, {})))
        joins = tuple(part for part in every.parts if isinstance(part, Literal) and part.positive)
        return Schema(action, self.row, joins, every, tuple(dict.fromkeys(outcomes)))

    def _place(self, term: str, binding: Binding) -> Place:
        term = binding.get(term, term)
        if term in self._places:
            return self._places[term]
        return self._constants.setdefault(term, self._first_constant + len(self._constants))

    def _literal(self, atom: AtomCondition, binding: Binding, *, positive: bool) -> Literal:
        # The predicate is a constant of the row too; no object or variable can stand for it.
        head = self._constants.setdefault(
            f"{atom.predicate}", self._first_constant + len(self._constants)
        )
        places = (head, *(self._place(term, binding) for term in atom.terms))
        key = (places, positive)
        if key not in self._literals:
            fact = _filler(places, atom.predicate)
            self._literals[key] = Literal(atom.predicate, places[1:], positive, fact)
        return self._literals[key]

    def test(self, condition: Condition, binding: Binding, *, positive: bool = True) -> Test:
        """A condition, or its negation, in negation normal form."""
        match condition:
            case AtomCondition():
                return self._literal(condition, binding, positive=positive)
            case Equal(left, right):
                return Same(self._place(left, binding), self._place(right, binding), positive)
            case NotCondition(part):
                return self.test(part, binding, positive=not positive)
            case AllOf(parts):
                tests = [self.test(p, binding, positive=positive) for p in parts]
                return _joined(tests, every=positive)
            case AnyOf(parts):
                tests = [self.test(p, binding, positive=positive) for p in parts]
                return _joined(tests, every=not positive)
            case ForAll(parameters, part) | Exists(parameters, part):
                tests = [
                    self.test(part, {**binding, **more}, positive=positive)
                    for more in self._problem.bindings(parameters)
                ]
                return _joined(tests, every=positive == isinstance(condition, ForAll))
            case _:
                assert_never(condition)

    def _outcomes(self, effect: Effect, binding: Binding) -> list[tuple[Guarded, ...]]:
        match effect:
            case Add(atom):
                return [(Guarded(Every(), (self._literal(atom, binding, positive=True),), ()),)]
            case Delete(atom):
                return [(Guarded(Every(), (), (self._literal(atom, binding, positive=True),)),)]
            case Together(parts):
                return _choices([self._outcomes(part, binding) for part in parts])
            case OneOf(parts):
                return [found for part in parts for found in self._outcomes(part, binding)]
            case When(condition, part):
                test = self.test(condition, binding)
                return [
                    tuple(_under(test, guarded) for guarded in outcome)
                    for outcome in self._outcomes(part, binding)
                ]
            case ForEach(parameters, part):
                return _choices(
                    [
                        self._outcomes(part, {**binding, **more})
                        for more in self._problem.bindings(parameters)
                    ]
                )
            case _:
                assert_never(effect)


def _filler(places: tuple[Place, ...], predicate: str) -> Callable[[Row], Fact]:
    if len(places) == 1:
        return lambda _: (predicate,)
    return itemgetter(*places)


def _joined(tests: list[Test], *, every: bool) -> Test:
    kind: type[Every | Some] = Every if every else Some
    flat: list[Test] = []
    for test in tests:
        flat.extend(test.parts if isinstance(test, kind) else (test,))
    return flat[0] if len(flat) == 1 else kind(tuple(flat))


def _under(test: Test, guarded: Guarded) -> Guarded:
    joined = _joined([test, guarded.test], every=True)
    every = joined if isinstance(joined, Every) else Every((joined,))
    return Guarded(every, guarded.adds, guarded.deletes)


def _choices(parts: list[list[tuple[Guarded, ...]]]) -> list[tuple[Guarded, ...]]:
    """Every choice of one outcome from each part, taken together."""
    return [tuple(g for outcome in chosen for g in outcome) for chosen in product(*parts)]


def _merged(outcome: tuple[Guarded, ...]) -> tuple[Guarded, ...]:
    """One change for each test, the one without a test first."""
    by_test: dict[Every, tuple[dict[Literal, None], dict[Literal, None]]] = {Every(): ({}, {})}
    for guarded in outcome:
        adds, deletes = by_test.setdefault(guarded.test, ({}, {}))
        adds.update(dict.fromkeys(guarded.adds))
        deletes.update(dict.fromkeys(guarded.deletes))
    return tuple(Guarded(test, tuple(a), tuple(d)) for test, (a, d) in by_test.items())
