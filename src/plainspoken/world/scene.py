"""What is now, and what an action can make of it: the slow, plain meaning of PDDL.

The planner has its own, compiled form of this (`planning.task`) and is tested against it; the
validator, the simulator and the explanations use this one.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping
from dataclasses import dataclass
from itertools import product
from typing import assert_never

from plainspoken.errors import PlainspokenError
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

Binding = Mapping[str, str]
Change = tuple[frozenset[GroundAtom], frozenset[GroundAtom]]
"""What one outcome adds and deletes."""


@dataclass(frozen=True, slots=True)
class _Either:
    """The atoms of two states, without making a third: the static ones may be thousands."""

    changing: State
    static: State

    def __contains__(self, atom: object) -> bool:
        return atom in self.changing or atom in self.static


def satisfies(
    state: Container[GroundAtom],
    condition: Condition,
    problem: Problem,
    binding: Binding | None = None,
) -> bool:
    """Whether a condition holds in a state, its variables bound."""
    bound = binding or {}
    match condition:
        case AtomCondition():
            return ground(condition, bound) in state
        case Equal(left, right):
            return bound.get(left, left) == bound.get(right, right)
        case NotCondition(part):
            return not satisfies(state, part, problem, bound)
        case AllOf(parts):
            return all(satisfies(state, part, problem, bound) for part in parts)
        case AnyOf(parts):
            return any(satisfies(state, part, problem, bound) for part in parts)
        case ForAll(parameters, part):
            return all(
                satisfies(state, part, problem, {**bound, **more})
                for more in problem.bindings(parameters)
            )
        case Exists(parameters, part):
            return any(
                satisfies(state, part, problem, {**bound, **more})
                for more in problem.bindings(parameters)
            )
        case _:
            assert_never(condition)


def instances(problem: Problem, action: GroundAction) -> Iterator[tuple[Action, Binding]]:
    """The schemas and bindings that a ground action names; none if it names nothing."""
    name, *arguments = action.split() or [""]
    for schema in problem.action(name):
        if len(schema.parameters) == len(arguments) and all(
            argument in problem.objects_for(parameter)
            for parameter, argument in zip(schema.parameters, arguments, strict=True)
        ):
            names = (parameter.name for parameter in schema.parameters)
            yield schema, dict(zip(names, arguments, strict=True))


def is_applicable(problem: Problem, state: State, action: GroundAction) -> bool:
    """Whether the action exists in the problem and its precondition holds in the state."""
    return any(
        satisfies(state, schema.precondition, problem, binding)
        for schema, binding in instances(problem, action)
    )


def successors(
    problem: Problem, state: State, action: GroundAction, static: State = frozenset()
) -> tuple[State, ...]:
    """Every state that the action can lead to, each once, in the order of the outcomes.

    An outcome that changes nothing is among them.
    static: further true atoms, of predicates that no action changes; left out of the result
    raises PlainspokenError: when the action is not applicable
    """
    world = _Either(state, static)
    found: dict[State, None] = {}
    for schema, binding in instances(problem, action):
        if satisfies(world, schema.precondition, problem, binding):
            for added, deleted in _changes(schema.effect, world, problem, binding):
                found.setdefault((state - deleted) | added)
    if not found:
        raise PlainspokenError(f"the action {action!r} is not applicable in this state")
    return tuple(found)


def outcomes(problem: Problem, state: State, action: GroundAction) -> tuple[Change, ...]:
    """What each outcome of an action adds and deletes, whether or not it can be done now."""
    return tuple(
        change
        for schema, binding in instances(problem, action)
        for change in _changes(schema.effect, state, problem, binding)
    )


def applicable_actions(problem: Problem, state: State) -> Iterator[GroundAction]:
    """Every ground action whose precondition holds, in the order of the domain file.

    Tries every binding: meant for small problems, for tests and for explanations.
    """
    for schema in problem.domain.actions:
        for binding in problem.bindings(schema.parameters):
            if satisfies(state, schema.precondition, problem, binding):
                yield " ".join([schema.name, *binding.values()])


def _changes(
    effect: Effect, state: Container[GroundAtom], problem: Problem, binding: Binding
) -> list[Change]:
    """What each outcome of an effect adds and deletes in a state."""
    nothing: Change = (frozenset(), frozenset())
    match effect:
        case Add(atom):
            return [(frozenset({ground(atom, binding)}), frozenset())]
        case Delete(atom):
            return [(frozenset(), frozenset({ground(atom, binding)}))]
        case Together(parts):
            return _joined([_changes(part, state, problem, binding) for part in parts])
        case When(condition, part):
            if satisfies(state, condition, problem, binding):
                return _changes(part, state, problem, binding)
            return [nothing]
        case ForEach(parameters, part):
            return _joined(
                [
                    _changes(part, state, problem, {**binding, **more})
                    for more in problem.bindings(parameters)
                ]
            )
        case OneOf(parts):
            return [change for part in parts for change in _changes(part, state, problem, binding)]
        case _:
            assert_never(effect)


def _joined(parts: list[list[Change]]) -> list[Change]:
    """Every choice of one outcome from each part, taken together."""
    return [
        (
            frozenset().union(*(added for added, _ in chosen)),
            frozenset().union(*(deleted for _, deleted in chosen)),
        )
        for chosen in product(*parts)
    ]
