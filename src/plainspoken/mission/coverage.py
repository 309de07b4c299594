"""Whether a policy can be followed from a node, given what the goal remembers by then.

A node of a policy stands for a state and a memory of the goal. After a surprise the state may be
one of the policy's and the memory another. Following on from there is sound if the goal's
monitor, carried along every edge, accepts wherever the policy stops, and if a stop stays within
reach; that is checked on the product of the policy and the monitor, without the planner.
"""

from __future__ import annotations

from collections.abc import Iterable

from plainspoken.automata.verdict import Monitor
from plainspoken.logic.trace import Letter
from plainspoken.planning.policy import NodeId, Policy, PolicyNode
from plainspoken.world.domain import State
from plainspoken.world.symbol import Symbol, letter

Memory = tuple[int, ...]
"""Where the automaton of each part of the goal is."""
_Pair = tuple[NodeId, Memory]


def sound_nodes(
    policy: Policy, world: State, monitor: Monitor, symbols: tuple[Symbol, ...]
) -> tuple[NodeId, ...]:
    """The nodes from which the policy can be followed now, in the order of the policy.

    world: every atom that is true now, static ones included
    """
    memory = tuple(part.state for part in monitor.parts)
    fitting = [node.id for node in policy.nodes if node.state | policy.static == world]
    product = _Product(policy, monitor, symbols)
    sound = product.sound((node, memory) for node in fitting)
    return tuple(node for node in fitting if (node, memory) in sound)


def all_sound(
    policy: Policy,
    starts: Iterable[tuple[NodeId, Memory]],
    monitor: Monitor,
    symbols: tuple[Symbol, ...],
) -> bool:
    """Whether the policy can be followed from each of these nodes, with that memory.

    monitor: for the automata alone
    """
    starts = tuple(starts)
    sound = _Product(policy, monitor, symbols).sound(starts)
    return all(start in sound for start in starts)


class _Product:
    """A policy and a monitor, walked together."""

    def __init__(self, policy: Policy, monitor: Monitor, symbols: tuple[Symbol, ...]) -> None:
        self._policy = policy
        self._automata = tuple(part.automaton for part in monitor.parts)
        self._symbols = symbols
        self._letters: dict[tuple[NodeId, str], Letter] = {}

    def sound(self, starts: Iterable[_Pair]) -> frozenset[_Pair]:
        """The pairs, reachable from the starts, from which following the policy is sound."""
        successors = self._reachable(starts)
        sound = {pair for pair in successors if not self._stops_in_vain(pair)}
        while True:
            safe = {pair for pair in sound if all(each in sound for each in successors[pair])}
            reaching = self._reaching_a_stop(safe, successors)
            if reaching == sound:
                return frozenset(sound)
            sound = reaching

    def _reachable(self, starts: Iterable[_Pair]) -> dict[_Pair, tuple[_Pair, ...]]:
        found: dict[_Pair, tuple[_Pair, ...]] = {}
        todo = list(starts)
        while todo:
            pair = todo.pop()
            if pair not in found:
                found[pair] = self._successors(pair)
                todo.extend(found[pair])
        return found

    def _successors(self, pair: _Pair) -> tuple[_Pair, ...]:
        node, memory = self._policy.node(pair[0]), pair[1]
        if node.action is None:
            return ()
        after = []
        for successor in map(self._policy.node, node.successors):
            seen = self._letter(successor, node.action)
            after.append(
                (
                    successor.id,
                    tuple(
                        automaton.step(state, seen)
                        for automaton, state in zip(self._automata, memory, strict=True)
                    ),
                )
            )
        return tuple(after)

    def _letter(self, node: PolicyNode, action: str) -> Letter:
        key = (node.id, action)
        if key not in self._letters:
            world = node.state | self._policy.static
            self._letters[key] = letter(self._symbols, world, action)
        return self._letters[key]

    def _stops_in_vain(self, pair: _Pair) -> bool:
        node, memory = pair
        if self._policy.node(node).action is not None:
            return not self._policy.node(node).successors
        return not all(
            automaton.accepts(state)
            for automaton, state in zip(self._automata, memory, strict=True)
        )

    def _reaching_a_stop(
        self, pairs: set[_Pair], successors: dict[_Pair, tuple[_Pair, ...]]
    ) -> set[_Pair]:
        predecessors: dict[_Pair, list[_Pair]] = {}
        for pair in pairs:
            for successor in successors[pair]:
                predecessors.setdefault(successor, []).append(pair)
        todo = [pair for pair in pairs if not successors[pair]]
        found = set(todo)
        while todo:
            for pair in predecessors.get(todo.pop(), ()):
                if pair not in found:
                    found.add(pair)
                    todo.append(pair)
        return found
