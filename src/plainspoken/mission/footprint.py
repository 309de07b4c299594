"""What an action reads and may change, and who does it: whether two get in each other's way."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import assert_never

from plainspoken.world.domain import (
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
    GroundAction,
    GroundAtom,
    NotCondition,
    OneOf,
    Problem,
    State,
    Together,
    When,
    ground,
)
from plainspoken.world.role import Roles
from plainspoken.world.scene import instances

Binding = Mapping[str, str]


@dataclass(frozen=True, slots=True)
class Footprint:
    """All that an action has to do with, in whatever state, with whatever outcome.

    reads:  the atoms that its precondition, or a condition of an effect, looks at
    writes: those that it may add or delete
    robots: the objects among its arguments that move by actions of their own
    """

    reads: State
    writes: State
    robots: frozenset[str]

    def disturbs(self, other: Footprint) -> bool:
        """Whether one of two actions may notice that the other goes on."""
        return bool(
            self.writes & (other.reads | other.writes)
            or other.writes & self.reads
            or self.robots & other.robots
        )


class Footprints:
    """The footprints of one problem's actions."""

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        self._robots = frozenset(Roles(problem).agents)
        self._known: dict[GroundAction, Footprint] = {}

    def of(self, action: GroundAction) -> Footprint:
        if action not in self._known:
            reads: set[GroundAtom] = set()
            writes: set[GroundAtom] = set()
            for schema, binding in instances(self._problem, action):
                reads.update(_read(schema.precondition, self._problem, binding))
                for atom, written in _touched(schema.effect, self._problem, binding):
                    (writes if written else reads).add(atom)
            robots = self._robots.intersection(action.split()[1:])
            self._known[action] = Footprint(frozenset(reads), frozenset(writes), robots)
        return self._known[action]


class _Id:
    """A problem as a key: its own hash would walk through all of it."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem

    def __hash__(self) -> int:
        return id(self.problem)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Id) and self.problem is other.problem


def footprints_of(problem: Problem) -> Footprints:
    """The footprints of a problem; kept, as they are asked for at every action."""
    return _footprints(_Id(problem))


@lru_cache(maxsize=16)
def _footprints(key: _Id) -> Footprints:
    return Footprints(key.problem)


def _read(condition: Condition, problem: Problem, binding: Binding) -> Iterator[GroundAtom]:
    match condition:
        case AtomCondition():
            yield ground(condition, binding)
        case Equal():
            return
        case NotCondition(part):
            yield from _read(part, problem, binding)
        case AllOf(parts) | AnyOf(parts):
            for part in parts:
                yield from _read(part, problem, binding)
        case ForAll(parameters, part) | Exists(parameters, part):
            for more in problem.bindings(parameters):
                yield from _read(part, problem, {**binding, **more})
        case _:
            assert_never(condition)


def _touched(
    effect: Effect, problem: Problem, binding: Binding
) -> Iterator[tuple[GroundAtom, bool]]:
    """Atoms that an effect has to do with; True: it may change it, False: it looks at it."""
    match effect:
        case Add(atom) | Delete(atom):
            yield ground(atom, binding), True
        case Together(parts) | OneOf(parts):
            for part in parts:
                yield from _touched(part, problem, binding)
        case When(condition, part):
            for read in _read(condition, problem, binding):
                yield read, False
            yield from _touched(part, problem, binding)
        case ForEach(parameters, part):
            for more in problem.bindings(parameters):
                yield from _touched(part, problem, {**binding, **more})
        case _:
            assert_never(effect)
