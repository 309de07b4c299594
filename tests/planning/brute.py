"""A second way to decide small problems: the plain scene, progression, and fixpoints."""

from __future__ import annotations

from collections.abc import Iterator

from plainspoken.automata.construction import automata_for
from plainspoken.logic.formula import Formula, atoms
from plainspoken.logic.trace import holds
from plainspoken.planning.fixpoint import (
    Space,
    reachable_space,
    strong_choice,
    strong_cyclic_choice,
)
from plainspoken.planning.policy import Policy
from plainspoken.world.domain import GroundAction, Problem, State
from plainspoken.world.scene import applicable_actions, successors
from plainspoken.world.symbol import letter, resolve_all

Memory = tuple[int, ...]
Node = tuple[State, Memory]


def space(problem: Problem, goal: Formula) -> Space[Node, GroundAction]:
    """All reachable states with the automata's states, from the plain meaning of PDDL."""
    automata = automata_for(goal)
    symbols = resolve_all(atoms(goal), problem)

    def read(memory: Memory, state: State, action: GroundAction | None) -> Node:
        seen = letter(symbols, state, action)
        return state, tuple(a.step(s, seen) for a, s in zip(automata, memory, strict=True))

    def is_goal(node: Node) -> bool:
        return all(a.accepts(s) for a, s in zip(automata, node[1], strict=True))

    def choices(node: Node) -> Iterator[tuple[GroundAction, tuple[Node, ...]]]:
        for action in dict.fromkeys(applicable_actions(problem, node[0])):
            after = successors(problem, node[0], action)
            yield action, tuple(read(node[1], state, action) for state in after)

    start = read(tuple(a.initial for a in automata), problem.initial, None)
    found = reachable_space(start, is_goal, choices)
    assert found is not None
    return found


def is_solvable(problem: Problem, goal: Formula, *, strong: bool) -> bool:
    found = space(problem, goal)
    choice = strong_choice(found) if strong else strong_cyclic_choice(found)
    return found.initial in choice or found.initial in found.goals


def some_trace_violates(problem: Problem, goal: Formula, policy: Policy, longest: int) -> bool:
    """Whether some way to stop, of so many instants at most, violates the formula."""
    symbols = resolve_all(atoms(goal), problem)
    first = policy.node(policy.initial)
    paths: list[tuple[tuple[int, GroundAction | None], ...]] = [((first.id, None),)]
    while paths:
        path = paths.pop()
        node = policy.node(path[-1][0])
        if node.action is None:
            trace = [
                letter(symbols, policy.node(id).state | policy.static, action)
                for id, action in path
            ]
            if not holds(goal, trace):
                return True
        elif len(path) < longest:
            paths += [(*path, (id, node.action)) for id in node.successors]
    return False


def is_acyclic(policy: Policy) -> bool:
    layer = [policy.initial]
    for _ in range(len(policy.nodes) + 1):
        layer = [id for node in layer for id in policy.node(node).successors]
        if not layer:
            return True
        layer = list(dict.fromkeys(layer))
    return False
