"""Strong-cyclic policies by brute force over every state and memory: slow, and plain to see.

Shares nothing with the solver, so that missions are tested without trusting it.
"""

from collections.abc import Callable

from plainspoken.automata.construction import automata_for
from plainspoken.logic.formula import Formula, atoms
from plainspoken.logic.syntax import unparse
from plainspoken.planning.policy import Policy, PolicyNode
from plainspoken.world.domain import GroundAction, Problem, State
from plainspoken.world.scene import applicable_actions, successors
from plainspoken.world.symbol import letter, resolve_all

Node = tuple[State, tuple[int, ...]]
Choices = dict[Node, dict[GroundAction, tuple[Node, ...]]]
Ways = dict[Node, tuple[GroundAction, tuple[Node, ...]] | None]


def solved(problem: Problem, state: State, goal: Formula) -> Policy | None:
    """A policy from a state, or None where there is none."""
    automata = automata_for(goal)
    symbols = resolve_all(atoms(goal), problem)

    def stepped(memory: tuple[int, ...], now: State, action: str | None) -> tuple[int, ...]:
        seen = letter(symbols, now, action)
        return tuple(a.step(m, seen) for a, m in zip(automata, memory, strict=True))

    def accepts(node: Node) -> bool:
        return all(a.accepts(m) for a, m in zip(automata, node[1], strict=True))

    start: Node = (state, stepped(tuple(a.initial for a in automata), state, None))
    choices: Choices = {}
    todo = [start]
    while todo:
        node = todo.pop()
        if node in choices:
            continue
        choices[node] = {}
        if not accepts(node):
            for action in applicable_actions(problem, node[0]):
                outcomes = successors(problem, node[0], action)
                choices[node][action] = tuple(
                    (outcome, stepped(node[1], outcome, action)) for outcome in outcomes
                )
                todo.extend(choices[node][action])
    return _policy(start, _ways(choices, accepts), unparse(goal), problem)


def _ways(choices: Choices, accepts: Callable[[Node], bool]) -> Ways:
    """For each node of the greatest strong-cyclic set, the action that comes nearest a stop."""
    safe = set(choices)
    while True:
        chosen: Ways = {node: None for node in safe if accepts(node)}
        grown = True
        while grown:
            layer: Ways = {}
            for node in safe - set(chosen):
                for action, outcomes in choices[node].items():
                    if safe.issuperset(outcomes) and any(o in chosen for o in outcomes):
                        layer[node] = (action, outcomes)
                        break
            chosen.update(layer)
            grown = bool(layer)
        if set(chosen) == safe:
            return chosen
        safe = set(chosen)


def _policy(start: Node, ways: Ways, goal: str, problem: Problem) -> Policy | None:
    if start not in ways:
        return None
    static = frozenset(
        atom for atom in problem.initial if atom.split()[0] not in problem.changing_predicates
    )
    numbers = {start: 0}
    nodes = []
    todo = [start]
    while todo:
        node = todo.pop(0)
        action, outcomes = ways[node] or (None, ())
        for outcome in outcomes:
            if outcome not in numbers:
                numbers[outcome] = len(numbers)
                todo.append(outcome)
        following = tuple(dict.fromkeys(numbers[outcome] for outcome in outcomes))
        nodes.append(PolicyNode(numbers[node], node[0] - static, action, following))
    return Policy("strong-cyclic", goal, 0, static, tuple(nodes))
