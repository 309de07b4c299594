"""Conditions on a state as cubes joined by "or", and what they ask of the state before an outcome.

A cube is a set of bits that are set and a set of bits that are not; no complements stand in it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import reduce

from plainspoken.planning.task import Bits, Choice, Outcome, Requirement, Task, ones

MOST_CUBES = 4_096
"""A condition that needs more cubes than this is refused."""


class TooManyCubes(Exception):  # caught where the goal is known
    """A condition has more than `MOST_CUBES` cubes."""


@dataclass(frozen=True, slots=True)
class Cube:
    """All bits of `positive` are set, and none of `negative`."""

    positive: Bits = 0
    negative: Bits = 0

    def meet(self, other: Cube) -> Cube | None:
        """Both; None where they contradict each other."""
        positive, negative = self.positive | other.positive, self.negative | other.negative
        return None if positive & negative else Cube(positive, negative)

    def implies(self, other: Cube) -> bool:
        return not (other.positive & ~self.positive or other.negative & ~self.negative)

    def without(self, other: Cube) -> Cube:
        """What is left to ask where the other is known to hold."""
        return Cube(self.positive & ~other.positive, self.negative & ~other.negative)

    def literals(self) -> list[tuple[int, bool]]:
        """Its bits, lowest first, with the value that it asks for."""
        found = [(bit, True) for bit in ones(self.positive)]
        return sorted(found + [(bit, False) for bit in ones(self.negative)])


Cubes = tuple[Cube, ...]
"""Some cube of these holds: none for never, an empty cube for always."""
ALWAYS: Cubes = (Cube(),)
NEVER: Cubes = ()


def literal(bit: int, *, positive: bool) -> Cubes:
    """Where a bit is set, or, not positive, where it is not."""
    return (Cube(1 << bit, 0) if positive else Cube(0, 1 << bit),)


def any_of(*parts: Cubes) -> Cubes:
    """The cubes of all parts, without those that imply another."""
    return _least([cube for part in parts for cube in part])


def all_of(*parts: Cubes) -> Cubes:
    """The cubes that hold where one of each part does.

    raises TooManyCubes: when there are too many
    """
    return reduce(_both, parts, ALWAYS)


def negated(cubes: Cubes) -> Cubes:
    """Where none of the cubes holds.

    raises TooManyCubes: when that takes too many
    """
    return all_of(
        *(
            tuple(literal(bit, positive=not value)[0] for bit, value in cube.literals())
            for cube in cubes
        )
    )


def _both(left: Cubes, right: Cubes) -> Cubes:
    if ALWAYS in (left, right):
        return right if left == ALWAYS else left
    if len(left) * len(right) > MOST_CUBES:
        raise TooManyCubes
    return _least([met for a in left for b in right if (met := a.meet(b)) is not None])


def _least(cubes: list[Cube]) -> Cubes:
    if len(cubes) < 2:
        return tuple(cubes)
    kept: list[Cube] = []
    # Shorter cubes first: only they can be implied.
    for cube in sorted(
        dict.fromkeys(cubes), key=lambda c: c.positive.bit_count() + c.negative.bit_count()
    ):
        if not any(cube.implies(other) for other in kept):
            kept.append(cube)
    return tuple(kept)


class Reader:
    """Reads requirements of a task as cubes."""

    def __init__(self, task: Task) -> None:
        self._complemented = {complement: bit for bit, complement in task.complements.items()}
        self.atoms: Bits = (1 << len(task.atoms)) - 1

    def requirement(self, requirement: Requirement) -> Cubes:
        return all_of((self.mask(requirement.mask),), *map(self.choice, requirement.choices))

    def mask(self, mask: Bits) -> Cube:
        negative = sum(1 << self._complemented[bit] for bit in ones(mask & ~self.atoms))
        return Cube(mask & self.atoms, negative)

    def choice(self, choice: Choice) -> Cubes:
        bits = tuple(self.mask(1 << bit) for bit in ones(choice.mask))
        return any_of(bits, *map(self.requirement, choice.ways))


class Regression:
    """What a condition on the state after one outcome asks of the state before it.

    symbols: the action symbols that are true after it; bits from `first_symbol` are symbols
    """

    def __init__(self, outcome: Outcome, reader: Reader, symbols: Bits, first_symbol: int) -> None:
        self._outcome = outcome
        self._reader = reader
        self._symbols = symbols
        self._not_atoms = ~((1 << first_symbol) - 1)
        self._changes = [
            (reader.requirement(change.condition), change) for change in outcome.changes
        ]
        self.touched: Bits = outcome.add | outcome.delete
        for change in outcome.changes:
            self.touched |= change.add | change.delete
        self._known: dict[tuple[int, bool], Cubes] = {}

    def cube(self, cube: Cube) -> Cubes:
        """Where the cube holds afterwards."""
        symbols_wanted = cube.positive & self._not_atoms
        if symbols_wanted & ~self._symbols or cube.negative & self._symbols:
            return NEVER
        cube = Cube(cube.positive & ~self._not_atoms, cube.negative & ~self._not_atoms)
        untouched = Cube(cube.positive & ~self.touched, cube.negative & ~self.touched)
        rest = cube.without(untouched)
        return all_of((untouched,), *(self._literal(*each) for each in rest.literals()))

    def effects(self) -> Iterator[tuple[Cubes, Bits, Bits]]:
        """What the outcome does to the atoms: the condition, what it sets, what it clears."""
        atoms = self._reader.atoms
        yield ALWAYS, self._outcome.add & atoms, self._outcome.delete & atoms
        for when, change in self._changes:
            yield when, change.add & atoms, change.delete & atoms

    def _literal(self, bit: int, positive: bool) -> Cubes:  # noqa: FBT001 - a literal's sign
        found = self._known.get((bit, positive))
        if found is None:
            found = self._known[bit, positive] = self._asked(1 << bit, bit, positive=positive)
        return found

    def _asked(self, mask: Bits, bit: int, *, positive: bool) -> Cubes:
        if self._outcome.add & mask:
            return ALWAYS if positive else NEVER
        adds = any_of(*(when for when, change in self._changes if change.add & mask))
        deletes = any_of(*(when for when, change in self._changes if change.delete & mask))
        if self._outcome.delete & mask:
            deletes = ALWAYS
        if positive:
            return any_of(adds, all_of(literal(bit, positive=True), negated(deletes)))
        stays = any_of(literal(bit, positive=False), deletes)
        return all_of(negated(adds), stays)
