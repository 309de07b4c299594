"""The instances of actions that can ever be executed, found by joins from the initial state.

Deletes, negations, disjunctions and the conditions of effects are ignored here, except where
static predicates decide them; so no instance that can be executed is left out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from operator import itemgetter

from plainspoken.planning.schema import (
    Every,
    Fact,
    Literal,
    Row,
    Same,
    Schema,
    Test,
    schemas,
)
from plainspoken.world.domain import Problem

ROWS_A_CHECK = 256
"""So many rows are filled between two looks at the clock."""


@dataclass(frozen=True, slots=True)
class Instance:
    """A schema and the row that fills it in."""

    schema: Schema
    row: Row

    @property
    def name(self) -> str:
        arguments = self.row[: len(self.schema.action.parameters)]
        return " ".join((self.schema.action.name, *arguments))


@dataclass(frozen=True)
class Grounding:
    """What can ever be executed, and what can ever be true.

    facts:    the atoms of changing predicates that are true in some state, perhaps, and may
              change; in the order they were found
    constant: the atoms of changing predicates that are true in every state
    static:   the true atoms of predicates that no action changes
    """

    problem: Problem
    instances: tuple[Instance, ...]
    facts: dict[Fact, int]
    constant: frozenset[Fact]
    static: frozenset[Fact]
    changing: frozenset[str]

    def fixed(self, fact: Fact) -> bool | None:
        """Whether the atom is true in every state or in none; None where it may change."""
        if fact in self.facts:
            return None
        return fact in self.constant or fact in self.static


def grounded(problem: Problem, check: Callable[[], None] = lambda: None) -> Grounding:
    """Find the instances and atoms that are reachable when nothing is ever deleted.

    check: called again and again; what it raises ends the grounding
    """
    changing = problem.changing_predicates
    initial = sorted(tuple(atom.split()) for atom in problem.initial)
    static = frozenset(fact for fact in initial if fact[0] not in changing)
    joins = _Joins(problem, static, changing, check)
    for fact in initial:
        if fact[0] not in changing:
            joins.store(fact)
    instances = list(joins.at_once())
    reached = dict.fromkeys(fact for fact in initial if fact[0] in changing)
    deleted: set[Fact] = set()
    queue = list(reached)
    done = 0

    def harvest(instance: Instance) -> None:
        row = instance.row
        for outcome in instance.schema.outcomes:
            for guarded in outcome:
                if guarded.test.parts and joins.refuted(guarded.test, row):
                    continue
                for literal in guarded.adds:
                    fact = literal.fact(row)
                    if fact not in reached:
                        reached[fact] = None
                        queue.append(fact)
                for literal in guarded.deletes:
                    deleted.add(literal.fact(row))

    for instance in instances:
        harvest(instance)
    while done < len(queue):
        fact = queue[done]
        done += 1
        joins.store(fact)
        for instance in joins.triggered(fact):
            instances.append(instance)
            harvest(instance)
    constant = frozenset(f for f in initial if f[0] in changing and f not in deleted)
    facts = {fact: i for i, fact in enumerate(f for f in reached if f not in constant)}
    order = {id(schema): i for i, schema in enumerate(joins.schemas)}
    instances.sort(key=lambda i: (order[id(i.schema)], i.row))
    return Grounding(problem, tuple(instances), facts, constant, static, changing)


@dataclass(frozen=True, slots=True)
class _Step:
    """One atom of a join: look up by the places already bound, then bind the others.

    new:   pairs of a position in the fact and the place in the row that it binds
    again: pairs of positions in the fact that must hold the same object
    """

    index: dict[Fact, list[Fact]]
    key: Callable[[Row], str | Fact] | None
    predicate: str
    new: tuple[tuple[int, int], ...]
    again: tuple[tuple[int, int], ...]


@dataclass(frozen=True, slots=True)
class _Plan:
    """How to find the instances of a schema: from a fact that matches `start`, if any."""

    schema: Schema
    start: _Step | None
    steps: tuple[_Step, ...]
    free: tuple[int, ...]
    unique: bool


class _Joins:
    """Join plans of all schemas over indexes of the facts seen so far."""

    def __init__(
        self,
        problem: Problem,
        static: frozenset[Fact],
        changing: frozenset[str],
        check: Callable[[], None],
    ) -> None:
        self._static = static
        self._changing = changing
        self._check = check
        self._rows = 0
        self._indexes: dict[str, dict[tuple[int, ...], dict[Fact, list[Fact]]]] = {}
        self._keys: dict[str, list[tuple[tuple[int, ...], dict[Fact, list[Fact]]]]] = {}
        self.schemas = schemas(problem, check)
        self._allowed = {
            id(schema): [problem.objects_for(p) for p in schema.action.parameters]
            for schema in self.schemas
        }
        self._allowed_sets = {
            key: [frozenset(objects) for objects in lists] for key, lists in self._allowed.items()
        }
        self._seen: dict[int, set[Row]] = {}
        self._lifted: dict[int, tuple[Literal, ...]] = {}
        self._missing: dict[int, set[Fact]] = {}
        self._watched: dict[Fact, list[Schema]] = {}
        self._start: list[Schema] = []
        self._scans: dict[int, list[_Plan]] = {}
        self._joined: dict[int, list[_Plan]] = {}
        self._triggers: dict[str, list[_Plan]] = {}
        for schema in self.schemas:
            self._plan(schema)

    # -- plans ----------------------------------------------------------------------------

    def _plan(self, schema: Schema) -> None:
        """Watch the atoms without variables; the others are for joins once all those hold."""
        first_constant = len(schema.action.parameters)
        row = ("",) * first_constant + schema.constants
        lifted: list[Literal] = []
        missing: set[Fact] = set()
        for atom in schema.joins:
            if any(place < first_constant for place in atom.places):
                lifted.append(atom)
            elif (fact := atom.fact(row)) not in self._static:
                missing.add(fact)
        self._lifted[id(schema)] = tuple(lifted)
        if missing:
            self._missing[id(schema)] = missing
            for fact in missing:
                self._watched.setdefault(fact, []).append(schema)
        else:
            self._start.append(schema)
        # The index has to be there before the facts come.
        for i, plan in self._plans(schema):
            (self._scans if i is None else self._joined).setdefault(id(schema), []).append(plan)

    def _plans(self, schema: Schema) -> Iterator[tuple[int | None, _Plan]]:
        yield None, self._ordered(schema, None)
        for i, atom in enumerate(self._lifted[id(schema)]):
            if atom.predicate in self._changing:
                yield i, self._ordered(schema, i)

    def _activate(self, schema: Schema) -> Iterator[Instance]:
        """The instances there are so far; from now on new facts trigger further ones."""
        for plan in self._joined.get(id(schema), ()):
            if plan.start is not None:
                self._triggers.setdefault(plan.start.predicate, []).append(plan)
        yield from self._instances(self._scans[id(schema)][0], None)

    def _ordered(self, schema: Schema, trigger: int | None) -> _Plan:
        """Put the atoms with most places bound first, static ones before others."""
        lifted = self._lifted[id(schema)]
        arity = len(schema.action.parameters)
        bound = set(range(arity, arity + len(schema.constants)))
        waiting = list(enumerate(lifted))
        start = None
        if trigger is not None:
            start = self._step(lifted[trigger], bound, indexed=False)
            waiting = [(i, atom) for i, atom in waiting if i != trigger]

        def rank(entry: tuple[int, Literal]) -> tuple[bool, bool, bool, int, int]:
            number, atom = entry
            known = sum(place in bound for place in atom.places)
            is_static = atom.predicate not in self._changing
            return known == len(atom.places), known > 0, is_static, known, -number

        steps = []
        while waiting:
            best = max(waiting, key=rank)
            waiting.remove(best)
            steps.append(self._step(best[1], bound, indexed=True))
        free = tuple(i for i in range(arity) if i not in bound)
        fluent = [a.predicate for a in lifted if a.predicate in self._changing]
        return _Plan(schema, start, tuple(steps), free, len(fluent) == len(set(fluent)))

    def _step(self, atom: Literal, bound: set[int], *, indexed: bool) -> _Step:
        known = [i for i, place in enumerate(atom.places) if place in bound]
        first: dict[int, int] = {}
        new, again = [], []
        for i, place in enumerate(atom.places):
            if place in bound:
                continue
            if place in first:
                again.append((first[place] + 1, i + 1))
            else:
                first[place] = i
                new.append((i + 1, place))
        bound.update(first)
        key = None
        index: dict[Fact, list[Fact]] = {}
        if indexed:
            positions = (0, *(i + 1 for i in known))
            index = self._index(atom.predicate, positions)
            # A key of one element is the bare predicate: the scan of all its facts.
            key = itemgetter(*(atom.places[i] for i in known)) if known else None
        else:
            again += [(-place - 1, i + 1) for i, place in enumerate(atom.places) if i in known]
        return _Step(index, key, atom.predicate, tuple(new), tuple(again))

    def _index(self, predicate: str, positions: tuple[int, ...]) -> dict[Fact, list[Fact]]:
        by_positions = self._indexes.setdefault(predicate, {})
        if positions not in by_positions:
            by_positions[positions] = {}
            self._keys.setdefault(predicate, []).append((positions[1:], by_positions[positions]))
        return by_positions[positions]

    # -- facts ----------------------------------------------------------------------------

    def store(self, fact: Fact) -> None:
        """Make a fact known to the joins."""
        for positions, index in self._keys.get(fact[0], ()):
            index.setdefault(tuple(fact[i] for i in positions), []).append(fact)

    def at_once(self) -> Iterator[Instance]:
        """The instances that need nothing but static atoms."""
        for schema in self._start:
            yield from self._activate(schema)

    def triggered(self, fact: Fact) -> Iterator[Instance]:
        """The instances that need a fact just stored, and only facts stored so far."""
        for plan in tuple(self._triggers.get(fact[0], ())):
            yield from self._instances(plan, fact)
        for schema in self._watched.get(fact, ()):
            missing = self._missing[id(schema)]
            missing.discard(fact)
            if not missing:
                yield from self._activate(schema)

    def _instances(self, plan: _Plan, fact: Fact | None) -> Iterator[Instance]:
        schema = plan.schema
        count = len(schema.action.parameters)
        row: list[str] = [""] * count + list(schema.constants)
        if (
            fact is not None
            and plan.start is not None
            and not self._bind(plan.start, fact, row, schema)
        ):
            return
        seen = None if plan.unique else self._seen.setdefault(id(schema), set())
        for _ in self._extended(plan, 0, row):
            found = tuple(row)
            self._rows += 1
            if self._rows % ROWS_A_CHECK == 0:
                self._check()
            if seen is not None:
                if found in seen:
                    continue
                seen.add(found)
            if not self.refuted(schema.test, found):
                yield Instance(schema, found)

    def _bind(self, step: _Step, fact: Fact, row: list[str], schema: Schema) -> bool:
        for left, right in step.again:
            if fact[right] != (fact[left] if left >= 0 else row[-left - 1]):
                return False
        allowed = self._allowed_sets[id(schema)]
        for position, place in step.new:
            if fact[position] not in allowed[place]:
                return False
            row[place] = fact[position]
        return True

    def _extended(self, plan: _Plan, depth: int, row: list[str]) -> Iterator[None]:
        """Fill the row in every way; it holds one way whenever this yields."""
        if depth == len(plan.steps):
            yield from self._freed(plan, 0, row)
            return
        step = plan.steps[depth]
        if step.key is None:
            key: Fact = ()
        else:
            picked = step.key(tuple(row))
            key = picked if isinstance(picked, tuple) else (picked,)
        for fact in tuple(step.index.get(key, ())):
            if self._bind(step, fact, row, plan.schema):
                yield from self._extended(plan, depth + 1, row)

    def _freed(self, plan: _Plan, depth: int, row: list[str]) -> Iterator[None]:
        if depth == len(plan.free):
            yield
            return
        place = plan.free[depth]
        for candidate in self._allowed[id(plan.schema)][place]:
            row[place] = candidate
            yield from self._freed(plan, depth + 1, row)

    # -- what static predicates decide ----------------------------------------------------

    def refuted(self, test: Test, row: Row) -> bool:
        """Whether static predicates and equalities make a test false."""
        if isinstance(test, Literal):
            if test.predicate in self._changing:
                return False
            return (test.fact(row) in self._static) != test.positive
        if isinstance(test, Same):
            return (row[test.left] == row[test.right]) != test.positive
        if isinstance(test, Every):
            return any(self.refuted(part, row) for part in test.parts)
        return all(self.refuted(part, row) for part in test.parts)
