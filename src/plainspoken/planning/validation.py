"""An independent validator: whether a policy does what was asked, step by step from the definition.

It shares the parser, `world.scene` (the plain meaning of PDDL) and `world.symbol` with the
planner's tests, and nothing with the planner: no task, no product, no automata.

What a policy has to be:

- its first node is the problem's initial state (`static` and `state` together);
- each action is applicable, and its successors are exactly the states it can lead to: every
  outcome covered, none invented, an outcome that changes nothing included. Each outcome state has
  one successor node: two nodes with one state under one edge would leave it open where to go on,
  since nothing that can be seen tells them apart;
- every reachable node can reach one where the policy stops; for a strong policy, none can be
  reached twice;
- the formula holds on every trace from the first node to one where it stops.

A weak policy may leave outcomes uncovered, as long as its gaps name each of them: it does what was
asked only where none of these happens.

Nodes that cannot be reached are not looked at, nor is the text in `policy.goal`: the formula that
counts is the one that is asked about.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, replace

from plainspoken.errors import PlainspokenError
from plainspoken.logic.formula import Formula, atoms
from plainspoken.logic.syntax import is_proposition, unparse
from plainspoken.planning.policy import NodeId, Policy, PolicyNode
from plainspoken.planning.valuation import Valuations
from plainspoken.world.domain import GroundAction, Problem, State
from plainspoken.world.scene import successors
from plainspoken.world.symbol import AtomSymbol, Symbol, SymbolId, letter, resolve

Letter = frozenset[SymbolId]
Visit = tuple[NodeId, Letter]
"""A node, and the letter there: its state and the action that led to it."""


@dataclass(frozen=True, slots=True)
class Valid:
    """The policy does what was asked; where `gaps` is not 0, only with luck."""

    nodes: int
    gaps: int = 0


@dataclass(frozen=True, slots=True)
class Invalid:
    """Why not, and at which node."""

    reason: str
    node: NodeId


def validate(problem: Problem, goal: Formula, policy: Policy) -> Valid | Invalid:
    """Whether the policy is one for the problem whose every way to stop satisfies the formula.

    raises UnknownSymbolError: when the formula names what the problem does not have
    """
    nodes = {node.id: node for node in policy.nodes}
    first = nodes.get(policy.initial)
    if first is None:
        return Invalid("the policy has no initial node", policy.initial)
    if len(nodes) != len(policy.nodes):
        return Invalid("two nodes have the same id", policy.initial)
    if first.state | policy.static != problem.initial:
        return Invalid(
            f"the first node is not the problem's initial state: "
            f"{_difference(problem.initial, first.state | policy.static)}",
            first.id,
        )
    policy, nodes = _with_what_changes(problem, policy, nodes)
    reachable = _reachable(nodes, nodes[first.id])
    if isinstance(reachable, Invalid):
        return reachable
    for node in reachable:
        wrong = _wrong_step(problem, policy, nodes, node)
        if wrong is not None:
            return wrong
    trapped = _trapped(reachable)
    if trapped is not None:
        return Invalid("from here the policy can never stop", trapped)
    if policy.kind == "strong":
        repeated = _on_a_cycle(reachable)
        if repeated is not None:
            return Invalid("a strong policy may not come back to a node, but here it can", repeated)
    violated = _violated(problem, goal, policy, nodes)
    return violated or Valid(len(reachable), _gaps(policy, reachable))


def _with_what_changes(
    problem: Problem, policy: Policy, nodes: dict[NodeId, PolicyNode]
) -> tuple[Policy, dict[NodeId, PolicyNode]]:
    """The same policy, its atoms static only where no action changes their predicate.

    A policy made elsewhere may call an atom static because nothing changes it on its way.
    """
    changing = problem.changing_predicates
    loose = frozenset(atom for atom in policy.static if atom.split()[0] in changing)
    if not loose:
        return policy, nodes
    nodes = {id: replace(node, state=node.state | loose) for id, node in nodes.items()}
    gaps = tuple(replace(gap, state=gap.state | loose) for gap in policy.gaps)
    return replace(
        policy, static=policy.static - loose, nodes=tuple(nodes.values()), gaps=gaps
    ), nodes


def _gaps(policy: Policy, reachable: list[PolicyNode]) -> int:
    """How many outcomes are not covered."""
    ids = {node.id for node in reachable}
    return len({(gap.node, gap.state) for gap in policy.gaps if gap.node in ids})


def _reachable(nodes: dict[NodeId, PolicyNode], first: PolicyNode) -> list[PolicyNode] | Invalid:
    order = [first]
    seen = {first.id}
    for node in order:
        for id in node.successors:
            if id not in nodes:
                return Invalid(f"it has the successor {id}, which is no node", node.id)
            if id not in seen:
                seen.add(id)
                order.append(nodes[id])
    return order


def _wrong_step(
    problem: Problem, policy: Policy, nodes: dict[NodeId, PolicyNode], node: PolicyNode
) -> Invalid | None:
    """What is wrong with the action of a node and its successors."""
    if node.action is None:
        return Invalid("the policy stops here, yet goes on", node.id) if node.successors else None
    try:
        wanted = set(successors(problem, node.state, node.action, policy.static))
    except PlainspokenError as error:
        return Invalid(error.what, node.id)
    given = [nodes[id].state for id in node.successors]
    for state, id in zip(given, node.successors, strict=True):
        if state not in wanted:
            return Invalid(f"{node.action!r} cannot lead to its successor {id}", node.id)
    missing = wanted.difference(given)
    if policy.kind == "weak":
        named = {gap.state for gap in policy.gaps if gap.node == node.id}
        if not named <= missing:
            return Invalid(f"a gap of {node.action!r} is no outcome, or has a successor", node.id)
        missing -= named
    if missing:
        changes = " or ".join(sorted(_difference(node.state, state) for state in missing))
        return Invalid(f"an outcome of {node.action!r} has no successor: {changes}", node.id)
    if len(set(given)) != len(given):
        return Invalid(f"two successors by {node.action!r} are the same state", node.id)
    return None


def _difference(before: State, after: State) -> str:
    changes = [*sorted(after - before), *(f"not {atom}" for atom in sorted(before - after))]
    shown = ", ".join(changes[:6]) + (", ..." if len(changes) > 6 else "")
    return shown or "nothing changes"


def _trapped(reachable: list[PolicyNode]) -> NodeId | None:
    """A node from which no way leads to one where the policy stops."""
    before: dict[NodeId, list[NodeId]] = {}
    for node in reachable:
        for id in node.successors:
            before.setdefault(id, []).append(node.id)
    todo = [node.id for node in reachable if node.action is None]
    stopping = set(todo)
    while todo:
        for id in before.get(todo.pop(), ()):
            if id not in stopping:
                stopping.add(id)
                todo.append(id)
    return next((node.id for node in reachable if node.id not in stopping), None)


def _on_a_cycle(reachable: list[PolicyNode]) -> NodeId | None:
    """A node that can be reached from itself, or one that only such nodes lead to."""
    arrows = {node.id: 0 for node in reachable}
    by_id = {node.id: node for node in reachable}
    for node in reachable:
        for id in node.successors:
            arrows[id] += 1
    todo = [id for id, count in arrows.items() if count == 0]
    while todo:
        for id in by_id[todo.pop()].successors:
            arrows[id] -= 1
            if arrows[id] == 0:
                todo.append(id)
    return next((id for id, count in arrows.items() if count), None)


def _violated(
    problem: Problem,
    goal: Formula,
    policy: Policy,
    nodes: dict[NodeId, PolicyNode],
) -> Invalid | None:
    """A node where the policy may stop though the trace so far violates the formula.

    Truth is decided from the end of a trace: so the valuations of the subformulas that are
    possible at a node are collected backwards, from those where it stops.
    """
    symbols = [_denoted(name, problem) for name in sorted(atoms(goal))]
    valuations = Valuations(goal)
    # What the goal reads of the static atoms; there may be thousands of others in each state.
    read = policy.static & {symbol.atom for symbol in symbols if isinstance(symbol, AtomSymbol)}

    def visit(id: NodeId, action: GroundAction | None) -> Visit:
        return id, letter(symbols, nodes[id].state | read, action)

    first = visit(policy.initial, None)
    before: dict[Visit, list[Visit]] = {}
    order = [first]
    seen = {first}
    # What is possible at a visit, and where each possibility comes from.
    possible: dict[Visit, dict[int, tuple[Visit, int] | None]] = {}
    changed: deque[tuple[Visit, int]] = deque()
    for here in order:
        node = nodes[here[0]]
        possible[here] = {}
        if node.action is None:
            value = valuations.kept(valuations.at_the_end(here[1]))
            possible[here][value] = None
            changed.append((here, value))
        for id in node.successors:
            there = visit(id, node.action)
            before.setdefault(there, []).append(here)
            if there not in seen:
                seen.add(there)
                order.append(there)
    while changed:
        there, value = changed.popleft()
        for here in before.get(there, ()):
            found = valuations.kept(valuations.before(here[1], value))
            if found not in possible[here]:
                possible[here][found] = (there, value)
                changed.append((here, found))
    if nodes[policy.initial].action is None:
        if valuations.holds(valuations.at_the_end(first[1])):
            return None
        return Invalid(f"it stops at once, and {unparse(goal)} does not hold", policy.initial)
    for id in nodes[policy.initial].successors:
        there = visit(id, nodes[policy.initial].action)
        for value in possible[there]:
            if not valuations.holds(valuations.before(first[1], value)):
                end = _origin(possible, there, value)
                return Invalid(f"it may stop here, and {unparse(goal)} does not hold then", end)
    return None


def _origin(
    possible: dict[Visit, dict[int, tuple[Visit, int] | None]], visit: Visit, value: int
) -> NodeId:
    """The node where a trace stops that gives rise to a valuation."""
    origin = possible[visit][value]
    while origin is not None:
        visit, value = origin
        origin = possible[visit][value]
    return visit[0]


def _denoted(name: SymbolId, problem: Problem) -> Symbol:
    """What an atom denotes; one that is no word of the grammar is a ground atom itself."""
    return resolve(name, problem) if is_proposition(name) else AtomSymbol(name, name)
