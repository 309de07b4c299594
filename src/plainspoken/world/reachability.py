"""Which ground atoms may ever be true: reachability with deletes and denials left out.

Whatever some execution makes true is among them; not every one of them need be. Landmarks are
derived for these alone, and what can be left unsaid is read off them: where a thing is only ever
in one place, the place need not be named.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from plainspoken.world.domain import (
    Action,
    Add,
    AllOf,
    AtomCondition,
    Condition,
    Delete,
    Effect,
    ForEach,
    OneOf,
    Parameter,
    Problem,
    Together,
    When,
    changed_atoms,
)

MOST_STEPS = 100_000
"""Atoms tried, a third of a second; of a larger problem every atom of the right types is taken."""

Arguments = tuple[str, ...]
Facts = dict[str, dict[Arguments, None]]


@dataclass(frozen=True)
class _Rule:
    """What makes an atom true: the parameters, what is needed, and the atom."""

    parameters: tuple[Parameter, ...]
    needed: tuple[AtomCondition, ...]
    added: AtomCondition

    @cached_property
    def named(self) -> dict[str, Parameter]:
        return {each.name: each for each in self.parameters}


class _TooLarge(Exception):
    pass


@dataclass(slots=True)
class _Search:
    problem: Problem
    facts: Facts
    steps: int = 0
    fitting: dict[Parameter, frozenset[str]] = field(default_factory=dict)

    def fits(self, parameter: Parameter) -> frozenset[str]:
        if parameter not in self.fitting:
            self.fitting[parameter] = frozenset(self.problem.objects_for(parameter))
        return self.fitting[parameter]

    def _step(self) -> None:
        self.steps += 1
        if self.steps > MOST_STEPS:
            raise _TooLarge

    def bindings(self, rule: _Rule) -> Iterator[dict[str, str]]:
        """The ways to bind a rule's parameters so that all it needs is reached."""
        yield from self._joined(rule, rule.needed, {})

    def _joined(
        self, rule: _Rule, needed: Sequence[AtomCondition], bound: dict[str, str]
    ) -> Iterator[dict[str, str]]:
        if not needed:
            yield from self._free(rule, bound)
            return
        atom = min(needed, key=lambda each: sum(term not in bound for term in each.terms))
        rest = [each for each in needed if each is not atom]
        for arguments in tuple(self.facts.get(atom.predicate, ())):
            self._step()
            longer = self._unified(rule, atom, arguments, bound)
            if longer is not None:
                yield from self._joined(rule, rest, longer)

    def _unified(
        self, rule: _Rule, atom: AtomCondition, arguments: Arguments, bound: dict[str, str]
    ) -> dict[str, str] | None:
        longer = dict(bound)
        parameters = rule.named
        for term, argument in zip(atom.terms, arguments, strict=True):
            if term not in parameters:
                if term != argument:
                    return None
            elif (
                argument not in self.fits(parameters[term])
                or longer.setdefault(term, argument) != argument
            ):
                return None
        return longer

    def _free(self, rule: _Rule, bound: dict[str, str]) -> Iterator[dict[str, str]]:
        """Bind what is left of the atom that is added; the rest only has to exist."""
        free = [p for p in rule.parameters if p.name not in bound]
        if not all(self.fits(each) for each in free):
            return
        own = tuple(each for each in free if each.name in rule.added.terms)
        for more in self.problem.bindings(own):
            self._step()
            yield bound | more


def reachable(problem: Problem) -> dict[str, dict[Arguments, None]] | None:
    """The reachable atoms of each predicate, in a stable order; None where there are too many."""
    facts: Facts = {}
    for atom in sorted(problem.initial | problem.unknown):
        predicate, *arguments = atom.split()
        facts.setdefault(predicate, {})[tuple(arguments)] = None
    rules = [
        _Rule((*action.parameters, *more), (*required(action.precondition), *needed), added)
        for action in problem.domain.actions
        for more, needed, added in _additions(action.effect)
    ]
    search = _Search(problem, facts)
    fresh = set(facts)
    try:
        while fresh:
            before, fresh = fresh, set()
            for rule in rules:
                if rule.needed and before.isdisjoint(atom.predicate for atom in rule.needed):
                    continue
                made = facts.setdefault(rule.added.predicate, {})
                count = len(made)
                for bound in search.bindings(rule):
                    made[tuple(bound.get(term, term) for term in rule.added.terms)] = None
                if len(made) > count:
                    fresh.add(rule.added.predicate)
    except _TooLarge:
        return None
    return facts


def _additions(
    effect: Effect,
) -> Iterator[tuple[tuple[Parameter, ...], tuple[AtomCondition, ...], AtomCondition]]:
    match effect:
        case Add(atom):
            yield (), (), atom
        case Together(effects) | OneOf(effects):
            for part in effects:
                yield from _additions(part)
        case When(condition, part):
            for parameters, needed, atom in _additions(part):
                yield parameters, (*required(condition), *needed), atom
        case ForEach(parameters, part):
            for more, needed, atom in _additions(part):
                yield (*parameters, *more), needed, atom
        case Delete():
            return


def required(condition: Condition) -> Iterator[AtomCondition]:
    """The atoms that a condition plainly needs."""
    match condition:
        case AtomCondition():
            yield condition
        case AllOf(conditions):
            for part in conditions:
                yield from required(part)
        case _:
            return


class PossibleAtoms:
    """The atoms that can be true at all, as far as is seen without planning."""

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        self._grounded: dict[str, tuple[tuple[str, ...], ...]] = {}

    def of(self, predicate: str) -> tuple[tuple[str, ...], ...]:
        """The arguments of those of a predicate."""
        if predicate not in self._grounded:
            self._grounded[predicate] = tuple(self._found(predicate))
        return self._grounded[predicate]

    def _found(self, predicate: str) -> Iterator[tuple[str, ...]]:
        """The ground atoms of a predicate that some execution may make true, as far as is seen."""
        if self._reached is not None:
            found = self._reached.get(predicate, {})
            order = {name: place for place, name in enumerate(self._problem.objects)}
            yield from sorted(found, key=lambda each: [order[name] for name in each])
            return
        parameters = self._problem.domain.predicates[predicate]
        for binding in self._problem.bindings(parameters):
            arguments = tuple(binding.values())
            atom = " ".join([predicate, *arguments])
            if atom in self._problem.initial or any(
                all(
                    f"{kind} {name}" in self._problem.initial
                    for name, kinds in zip(arguments, way, strict=True)
                    for kind in kinds
                )
                for way in self._ways.get(predicate, ())
            ):
                yield arguments

    @cached_property
    def _reached(self) -> dict[str, dict[tuple[str, ...], None]] | None:
        return reachable(self._problem)

    @cached_property
    def _ways(self) -> dict[str, set[tuple[frozenset[str], ...]]]:
        """For each predicate that is added: the static predicates each argument must satisfy."""
        found: dict[str, set[tuple[frozenset[str], ...]]] = {}
        for action in self._problem.domain.actions:
            needed = self._needed(action)
            for atom, added in changed_atoms(action.effect):
                if added:
                    way = tuple(needed.get(term, frozenset()) for term in atom.terms)
                    found.setdefault(atom.predicate, set()).add(way)
        return found

    def _needed(self, action: Action) -> dict[str, frozenset[str]]:
        found: dict[str, frozenset[str]] = {}
        for atom in required(action.precondition):
            if len(atom.terms) == 1 and atom.predicate not in self._problem.changing_predicates:
                term = atom.terms[0]
                found[term] = found.get(term, frozenset()) | {atom.predicate}
        return found

    def fitting(self, schema: Action, parameter: Parameter) -> Iterator[str]:
        """The objects that a parameter may stand for, by what never changes."""
        kinds = self._needed(schema).get(parameter.name, frozenset())
        for name in self._problem.objects_for(parameter):
            if all(f"{kind} {name}" in self._problem.initial for kind in kinds):
                yield name
