"""The ground task: a problem compiled to bits.

A state is an int. Bits, from the lowest: one for each atom that may change; complements, for
atoms that some test wants false; action symbols of the formula, which are set only while one
step is taken (`planning.product`). The meaning is that of `world.scene`, against which it is
tested: all tests read the state before, and where one outcome adds and deletes an atom, it is
true afterwards.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from plainspoken.logic.formula import Formula
from plainspoken.planning.goal import denotations, simplified
from plainspoken.planning.grounding import Grounding, Instance, grounded
from plainspoken.planning.schema import Every, Guarded, Literal, Row, Same, Some, Test
from plainspoken.world.domain import GroundAction, Problem, State
from plainspoken.world.symbol import ActionSymbol, AtomSymbol, SymbolId

Bits = int


@dataclass(frozen=True, slots=True)
class Requirement:
    """All bits of the mask are set, and every choice is met."""

    mask: Bits = 0
    choices: tuple[Choice, ...] = ()

    def holds(self, state: Bits) -> bool:
        return state & self.mask == self.mask and all(c.holds(state) for c in self.choices)


@dataclass(frozen=True, slots=True)
class Choice:
    """Some bit of the mask is set, or some of the ways is met."""

    mask: Bits
    ways: tuple[Requirement, ...] = ()

    def holds(self, state: Bits) -> bool:
        return state & self.mask != 0 or any(way.holds(state) for way in self.ways)


ALWAYS = Requirement()


@dataclass(frozen=True, slots=True)
class Change:
    """What happens in an outcome where the condition held before."""

    condition: Requirement
    add: Bits
    delete: Bits


@dataclass(frozen=True, slots=True)
class Outcome:
    """What happens in any case, and what happens under conditions."""

    add: Bits
    delete: Bits
    changes: tuple[Change, ...] = ()


@dataclass(frozen=True, slots=True)
class Variant:
    """One instance of a schema."""

    requirement: Requirement
    outcomes: tuple[Outcome, ...]


@dataclass(frozen=True, slots=True)
class TaskAction:
    """A ground action; several variants where two schemas have one name.

    symbols: the action symbols of the formula that its execution makes true
    """

    name: GroundAction
    variants: tuple[Variant, ...]
    symbols: Bits


@dataclass(frozen=True)
class Task:
    """A problem and a formula over it, in bits.

    goal:      the formula, with atoms that never change replaced by their value
    reads:     the bit of each atom that is left in the goal
    atoms:     the ground atom of each bit from 0
    always:    atoms of changing predicates that are true in every state
    static:    true atoms of predicates that no action changes
    complements: the bit that is set where bit i is not
    world:     all bits but those of action symbols
    width:     the number of bits
    """

    problem: Problem
    goal: Formula
    reads: dict[SymbolId, int]
    atoms: tuple[str, ...]
    always: State
    static: State
    complements: dict[int, int]
    world: Bits
    width: int
    initial: Bits
    actions: tuple[TaskAction, ...]
    constants: dict[SymbolId, bool] = field(default_factory=dict)

    def state(self, bits: Bits) -> State:
        """The true atoms of changing predicates."""
        return self.always.union(self.atoms[i] for i in ones(bits & ((1 << len(self.atoms)) - 1)))

    def after(self, state: Bits, outcome: Outcome) -> Bits:
        """The world after an outcome; the requirement of its variant holds in the state."""
        if not outcome.changes:
            return (state & ~outcome.delete) | outcome.add
        add, delete = outcome.add, outcome.delete
        for change in outcome.changes:
            if change.condition.holds(state):
                add |= change.add
                delete |= change.delete
        both = add & delete & ((1 << len(self.atoms)) - 1)
        for bit in ones(both):
            if bit in self.complements:
                add &= ~(1 << self.complements[bit])
        return (state & ~delete) | add


def ones(bits: Bits) -> list[int]:
    """The places of the bits that are set, lowest first."""
    found = []
    while bits:
        low = bits & -bits
        found.append(low.bit_length() - 1)
        bits ^= low
    return found


def ground_task(
    problem: Problem, goal: Formula, negative: Iterable[SymbolId] | None = None
) -> Task:
    """Ground and compile a problem with a formula over it.

    negative: the atoms of the formula for which a complement is wanted; None for all
    raises UnknownSymbolError: when the formula names what the problem does not have
    """
    return compiled(grounded(problem), goal, negative)


def constants_of(grounding: Grounding, goal: Formula) -> dict[SymbolId, bool]:
    """The atoms of a formula that have one value in all states, and that value."""
    found: dict[SymbolId, bool] = {}
    schemas = {instance.schema.action.name for instance in grounding.instances}
    for name, symbol in denotations(goal, grounding.problem).items():
        if isinstance(symbol, AtomSymbol):
            value = grounding.fixed(tuple(symbol.atom.split()))
            if value is not None:
                found[name] = value
        elif symbol.action not in schemas or not any(
            symbol.matches(instance.name)
            for instance in grounding.instances
            if instance.schema.action.name == symbol.action
        ):
            found[name] = False
    return found


def compiled(
    grounding: Grounding,
    goal: Formula,
    negative: Iterable[SymbolId] | None = None,
    check: Callable[[], None] = lambda: None,
) -> Task:
    """Compile what was grounded; see `ground_task`.

    check: called for every instance; what it raises ends the compilation
    """
    constants = constants_of(grounding, goal)
    symbols = {
        name: symbol
        for name, symbol in denotations(goal, grounding.problem).items()
        if name not in constants
    }
    compiler = _Compiler(grounding)
    reads: dict[SymbolId, int] = {}
    for name, symbol in symbols.items():
        if isinstance(symbol, AtomSymbol):
            bit = reads[name] = grounding.facts[tuple(symbol.atom.split())]
            if negative is None or name in negative:
                compiler.complement(bit)
    variants = [
        (instance, requirement, compiler.tests(instance))
        for instance in grounding.instances
        if (requirement := compiler.requirement(instance.schema.test, instance.row)) is not None
    ]
    # Only now are all complements known, which outcomes have to keep up.
    first_symbol = len(grounding.facts) + len(compiler.complements)
    actions_read = [s for s in symbols.values() if isinstance(s, ActionSymbol)]
    for offset, symbol in enumerate(actions_read):
        reads[symbol.id] = first_symbol + offset
    by_name: dict[GroundAction, list[Variant]] = {}
    for instance, requirement, tests in variants:
        check()
        variant = Variant(requirement, compiler.outcomes(instance, tests))
        by_name.setdefault(instance.name, []).append(variant)
    return Task(
        grounding.problem,
        simplified(goal, constants),
        reads,
        tuple(" ".join(fact) for fact in grounding.facts),
        frozenset(" ".join(fact) for fact in grounding.constant),
        frozenset(" ".join(fact) for fact in grounding.static),
        compiler.complements,
        (1 << first_symbol) - 1,
        first_symbol + len(actions_read),
        _initial(grounding, compiler.complements),
        _actions(by_name, actions_read, reads),
        constants,
    )


def _actions(
    by_name: dict[GroundAction, list[Variant]],
    symbols: list[ActionSymbol],
    reads: dict[SymbolId, int],
) -> tuple[TaskAction, ...]:
    readers: dict[str, list[ActionSymbol]] = {}
    for symbol in symbols:
        readers.setdefault(symbol.action, []).append(symbol)
    return tuple(
        TaskAction(
            name,
            tuple(dict.fromkeys(found)) if len(found) > 1 else tuple(found),
            sum(
                1 << reads[symbol.id]
                for symbol in readers.get(name.partition(" ")[0], ())
                if symbol.matches(name)
            ),
        )
        for name, found in by_name.items()
    )


def _initial(grounding: Grounding, complements: dict[int, int]) -> Bits:
    initial = sum(
        1 << grounding.facts[fact]
        for fact in (tuple(atom.split()) for atom in grounding.problem.initial)
        if fact in grounding.facts
    )
    for bit, complement in complements.items():
        if not initial >> bit & 1:
            initial |= 1 << complement
    return initial


class _Compiler:
    """Turns tests and outcomes of instances into masks; gives out complements on demand."""

    def __init__(self, grounding: Grounding) -> None:
        self._grounding = grounding
        self._facts = grounding.facts
        self.complements: dict[int, int] = {}

    def complement(self, bit: int) -> int:
        return self.complements.setdefault(bit, len(self._facts) + len(self.complements))

    # -- tests ----------------------------------------------------------------------------

    def requirement(self, test: Every, row: Row) -> Requirement | None:
        """What a test asks of the state; None where it can never hold."""
        mask = 0
        choices: list[Choice] = []
        for part in test.parts:
            found = self._part(part, row)
            if found is None:
                return None
            if isinstance(found, Choice):
                choices.append(found)
            else:
                mask |= found.mask
                choices.extend(found.choices)
        if not choices:
            return Requirement(mask) if mask else ALWAYS
        return Requirement(mask, tuple(choices))

    def _part(self, test: Test, row: Row) -> Requirement | Choice | None:
        match test:
            case Literal():
                fact = test.fact(row)
                bit = self._facts.get(fact)
                if bit is None:
                    return ALWAYS if self._grounding.fixed(fact) == test.positive else None
                return Requirement(1 << (bit if test.positive else self.complement(bit)))
            case Same(left, right, positive):
                return ALWAYS if (row[left] == row[right]) == positive else None
            case Every():
                return self.requirement(test, row)
            case Some(parts):
                return self._choice(parts, row)

    def _choice(self, parts: tuple[Test, ...], row: Row) -> Requirement | Choice | None:
        mask = 0
        ways: list[Requirement] = []
        for part in parts:
            found = self._part(part, row)
            if found is None:
                continue
            if isinstance(found, Choice):
                mask |= found.mask
                ways.extend(found.ways)
            elif found == ALWAYS:
                return ALWAYS
            elif not found.choices and found.mask & (found.mask - 1) == 0:
                mask |= found.mask
            else:
                ways.append(found)
        if not mask and not ways:
            return None
        if not mask and len(ways) == 1:
            return ways[0]
        return Choice(mask, tuple(dict.fromkeys(ways)))

    # -- outcomes -------------------------------------------------------------------------

    def tests(self, instance: Instance) -> tuple[tuple[Requirement | None, ...], ...]:
        """The conditions of the changes of each outcome; None where one never holds."""
        return tuple(
            tuple(
                self.requirement(guarded.test, instance.row) if guarded.test.parts else ALWAYS
                for guarded in outcome
            )
            for outcome in instance.schema.outcomes
        )

    def outcomes(
        self, instance: Instance, tests: tuple[tuple[Requirement | None, ...], ...]
    ) -> tuple[Outcome, ...]:
        found = []
        for outcome, conditions in zip(instance.schema.outcomes, tests, strict=True):
            add = delete = 0
            changes: list[Change] = []
            for guarded, condition in zip(outcome, conditions, strict=True):
                if condition is None:
                    continue
                adds, deletes = self._masks(guarded, instance.row)
                if condition == ALWAYS:
                    add |= adds
                    delete |= deletes
                elif adds or deletes:
                    changes.append(Change(condition, adds, deletes))
            found.append(self._outcome(add, delete, changes))
        return tuple(dict.fromkeys(found)) if len(found) > 1 else tuple(found)

    def _masks(self, guarded: Guarded, row: Row) -> tuple[Bits, Bits]:
        facts = self._facts
        add = delete = 0
        for literal in guarded.adds:
            bit = facts.get(literal.fact(row))
            if bit is not None:
                add |= 1 << bit
        for literal in guarded.deletes:
            bit = facts.get(literal.fact(row))
            if bit is not None:
                delete |= 1 << bit
        return add, delete

    def _outcome(self, add: Bits, delete: Bits, changes: list[Change]) -> Outcome:
        if changes:
            return Outcome(
                *self._complemented(add, delete & ~add),
                tuple(
                    Change(each.condition, *self._complemented(each.add, each.delete & ~each.add))
                    for each in changes
                ),
            )
        return Outcome(*self._complemented(add, delete & ~add))

    def _complemented(self, add: Bits, delete: Bits) -> tuple[Bits, Bits]:
        """The masks with the complements of what they set and clear."""
        set_too = clear_too = 0
        if self.complements:
            for bit in ones(add):
                if bit in self.complements:
                    clear_too |= 1 << self.complements[bit]
            for bit in ones(delete):
                if bit in self.complements:
                    set_too |= 1 << self.complements[bit]
        return add | set_too, delete | clear_too
