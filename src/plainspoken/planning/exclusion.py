"""Which facts can be so together, and of which groups exactly one is: what a report leaves unsaid.

Two literals exclude each other where no state that can be reached holds both, as far as is found
by looking at two at a time. Source: Bonet and Geffner, Planning as heuristic search, AIJ 2001,
section 5.2 (h^2), forwards and with negated atoms as atoms of their own.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property

from plainspoken.logic.formula import TRUE
from plainspoken.planning.task import (
    ALWAYS,
    Bits,
    Choice,
    Outcome,
    Requirement,
    Task,
    ground_task,
    ones,
)
from plainspoken.planning.watch import TimeIsUp, Watch
from plainspoken.world.domain import (
    Action,
    Add,
    AllOf,
    AtomCondition,
    Delete,
    GroundAtom,
    OneOf,
    Problem,
    State,
)

Literal = tuple[GroundAtom, bool]
"""An atom, and whether it is so."""

MOST_SECONDS = 10.0
"""After so long nothing is known to exclude anything: a report then says what it says."""


_DRAW = "(draw)"
"""The action that stands for what nobody knows; no file can have one of that name."""


def _mask(bits: Iterable[int]) -> Bits:
    return sum(1 << bit for bit in bits)


def _drawn(problem: Problem, unknown: State) -> Problem:
    """The problem with an action that makes unknown atoms so, and not so: none is left out then."""
    atoms = [
        AtomCondition(predicate, tuple(terms))
        for predicate, *terms in map(str.split, sorted(unknown))
        if predicate in problem.changing_predicates
    ]
    if not atoms:
        return problem
    draw = OneOf((*map(Add, atoms), *map(Delete, atoms)))
    actions = (*problem.domain.actions, Action(_DRAW, (), AllOf(), draw))
    return replace(problem, domain=replace(problem.domain, actions=actions))


@dataclass(frozen=True)
class _Rule:
    """What one part of an outcome may make so, all in bits of literals.

    needed:   alternatives, of each of which some set of literals holds before
    add:      what it makes so
    gone:     what is surely not so afterwards
    """

    needed: tuple[tuple[Bits, ...], ...]
    add: Bits
    gone: Bits


class Exclusions:
    """What excludes what in a problem; bit i is atom i, bit n + i that it is not so."""

    def __init__(self, problem: Problem, unknown: State = frozenset()) -> None:
        """Take what nobody knows at s0 for possible, and for possibly not so.

        unknown: further such atoms than the problem names
        """
        unknown |= problem.unknown
        self._task: Task = ground_task(_drawn(problem, unknown), TRUE)
        self._count = len(self._task.atoms)
        self._bits = {atom: bit for bit, atom in enumerate(self._task.atoms)}
        self._rules = tuple(self._all_rules())
        self._unknown = _mask(self._bits[atom] for atom in unknown if atom in self._bits)
        self._oneofs = tuple(
            _mask(self._bits[atom] for atom in group)
            for group in problem.oneofs
            if all(atom in self._bits for atom in group)
        )

    def is_possible(self, literal: Literal) -> bool:
        """Whether some state that can be reached may hold a literal."""
        atom, holds = literal
        bit = self._bit(literal)
        if bit is None:
            return (atom in self._task.always or atom in self._task.static) == holds
        return not self._together or self._together[bit] != 0

    def implied(self, literal: Literal) -> Iterator[Literal]:
        """The literals that hold wherever one does, itself left out."""
        bit = self._bit(literal)
        if bit is None or not self._together or not self._together[bit]:
            return
        for other in ones(~self._together[bit] & ((1 << 2 * self._count) - 1)):
            found = self._literal(self._opposite(other))
            if found != literal:
                yield found

    def exclude(self, one: Literal, other: Literal) -> bool:
        """Whether two literals are never so together."""
        first, second = self._bit(one), self._bit(other)
        if first is None or second is None or not self._together:
            return False
        return not self._together[first] >> second & 1

    @cached_property
    def _groups(self) -> dict[int, tuple[GroundAtom, ...]]:
        return {}

    def group(self, atom: GroundAtom) -> tuple[GroundAtom, ...]:
        """Atoms, this one among them, of which exactly one is so in every state; or none."""
        bit = self._bits.get(atom)
        if bit is None or not self._together:
            return ()
        if bit not in self._groups:
            members = self._grown([bit])
            found = tuple(self._task.atoms[each] for each in sorted(members or ()))
            for each in members or [bit]:
                self._groups.setdefault(each, found)
        return self._groups[bit]

    # -- literals ------------------------------------------------------------------------------

    def _bit(self, literal: Literal) -> int | None:
        atom, holds = literal
        bit = self._bits.get(atom)
        return bit if bit is None or holds else bit + self._count

    def _literal(self, bit: int) -> Literal:
        return self._task.atoms[bit % self._count], bit < self._count

    def _opposite(self, bit: int) -> int:
        return bit - self._count if bit >= self._count else bit + self._count

    def _converted(self, mask: Bits) -> Bits:
        """A mask of the task as one of literals; what is of neither kind is left out."""
        own = mask & ((1 << self._count) - 1)
        for bit, complement in self._task.complements.items():
            if mask >> complement & 1:
                own |= 1 << bit + self._count
        return own

    def _inverted(self, literals: Bits) -> Bits:
        low = literals & ((1 << self._count) - 1)
        return low << self._count | literals >> self._count

    # -- rules ---------------------------------------------------------------------------------

    def _all_rules(self) -> Iterator[_Rule]:
        for action in self._task.actions:
            if action.name == _DRAW:
                continue  # that is what s0 is, and nothing that happens
            for variant in action.variants:
                needed = self._needed(variant.requirement)
                for outcome in variant.outcomes:
                    yield from self._of(needed, outcome)

    def _needed(self, requirement: Requirement) -> tuple[tuple[Bits, ...], ...]:
        found: list[tuple[Bits, ...]] = [(self._converted(requirement.mask),)]
        found += [self._ways(choice) for choice in requirement.choices]
        return tuple(found)

    def _ways(self, choice: Choice) -> tuple[Bits, ...]:
        # A way with choices of its own is taken for less than it asks: that only excludes less.
        return (
            *(1 << bit for bit in ones(self._converted(choice.mask))),
            *(self._converted(way.mask) for way in choice.ways),
        )

    def _of(self, needed: tuple[tuple[Bits, ...], ...], outcome: Outcome) -> Iterator[_Rule]:
        add, gone = self._effect(outcome.add, outcome.delete)
        (sure,) = needed[0]
        always = [add]
        for change in outcome.changes:
            more, less = self._effect(change.add, change.delete)
            if change.condition == ALWAYS:
                always.append(more)
                gone |= less
            left = self._converted(change.condition.mask) & ~sure
            if not change.condition.choices and left and left & (left - 1) == 0:
                gone |= left & less  # what is there meets the condition, and so goes
        base = 0
        for each in always:
            base |= each
        yield _Rule(needed, base, gone & ~base)
        for change in outcome.changes:
            more, less = self._effect(change.add, change.delete)
            condition = self._needed(change.condition)
            yield _Rule((*needed, *condition), base | more, (gone | less) & ~(base | more))

    def _effect(self, add: Bits, delete: Bits) -> tuple[Bits, Bits]:
        """What becomes so, and what stops being so, by masks of the task."""
        low = (1 << self._count) - 1
        add, delete = add & low, delete & low & ~add
        made = add | delete << self._count
        return made, self._inverted(made)

    # -- what can be together ------------------------------------------------------------------

    @cached_property
    def _together(self) -> list[Bits]:
        """For each literal those that some reachable state may hold with it; empty: not known."""
        found = self._at_first()
        watch = Watch(MOST_SECONDS)
        try:
            news = True
            while news:
                news = False
                for rule in self._rules:
                    news |= self._fired(rule, found, watch)
        except TimeIsUp:
            return []
        return found

    def _at_first(self) -> list[Bits]:
        """What can be together at s0."""
        low = (1 << self._count) - 1
        true = self._task.initial & low & ~self._unknown
        start = true | self._unknown | (low & ~true) << self._count
        found = [start if start >> bit & 1 else 0 for bit in range(2 * self._count)]
        for bit in ones(self._unknown):
            found[bit] &= ~(1 << bit + self._count)
            found[bit + self._count] &= ~(1 << bit)
        for group in self._oneofs:
            for bit in ones(group):
                others = group & ~(1 << bit)
                found[bit] &= ~others
                if others & (others - 1) == 0:  # of two, one is so
                    found[bit + self._count] &= ~(others << self._count)
        return found

    def _fired(self, rule: _Rule, found: list[Bits], watch: Watch) -> bool:
        """Note what a rule brings together; whether that is new."""
        watch.check()
        before = self._before(rule, found)
        if before == 0 and self._count:
            return False
        after = (before & ~rule.gone & ~self._inverted(rule.add)) | rule.add
        new = False
        for bit in ones(rule.add):
            if after & ~found[bit]:
                new = True
                for other in ones(after & ~found[bit]):
                    found[other] |= 1 << bit
                found[bit] |= after
        return new

    def _before(self, rule: _Rule, found: list[Bits]) -> Bits:
        """The literals that may hold where a rule applies; none where it never does."""
        possible = sum(1 << bit for bit in range(2 * self._count) if found[bit])
        for ways in rule.needed:
            joined = 0
            for way in ways:
                both = possible
                for bit in ones(way):
                    both &= found[bit]
                if both & way == way:
                    joined |= both
            possible &= joined
        return possible

    # -- groups --------------------------------------------------------------------------------

    def _grown(self, members: list[int]) -> list[int] | None:
        """A group with these members; None where there is none."""
        missing = self._lacking(members)
        if missing is None:
            return members
        for bit in missing:
            if all(not self._together[bit] >> each & 1 for each in members):
                return self._grown([*members, bit])
        return None

    def _lacking(self, members: Collection[int]) -> list[int] | None:
        """What could make up for a way to have none of some atoms; None where there is no way."""
        mask = sum(1 << each for each in members)
        low = (1 << self._count) - 1
        true = self._task.initial & low & ~self._unknown
        if not true & mask and not any(group & mask == group for group in self._oneofs):
            return ones(true | self._unknown)
        for rule in self._rules:
            gone, add = rule.gone & low, rule.add & low
            if gone & mask and not add & mask and self._before(rule, self._together):
                return ones(add)
        return None
