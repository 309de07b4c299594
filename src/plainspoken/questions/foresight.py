"""What the policy allows from now on: a tree of futures, with what is sure in it told apart.

Instants are those of the trace: a node that is `k` actions away is at instant `now + k`.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from plainspoken.planning.policy import NodeId, Policy, PolicyNode
from plainspoken.world.domain import GroundAction, GroundAtom, State
from plainspoken.world.event import Instant

MOST_LAYERS = 60
"""What is sure is worked out this many actions ahead."""
MOST_WIDTH = 3000
"""A layer with more nodes than this ends it too."""
MOST_WORK = 2_000_000
"""Nodes times actions: beyond this, which actions are unavoidable is not worked out."""


@dataclass(frozen=True, slots=True)
class Remaining:
    """How many actions are left.

    most: None where an outcome can send the robot round again without end
    """

    least: int
    most: int | None
    repeated: GroundAction | None


class Foresight:
    """The futures of a policy from one of its nodes."""

    def __init__(self, policy: Policy, node: PolicyNode, now: Instant) -> None:
        self.policy = policy
        self.node = node
        self.now = now

    @cached_property
    def reachable(self) -> dict[NodeId, int]:
        """The nodes that may be met, and in how many actions at the earliest."""
        found = {self.node.id: 0}
        todo = deque([self.node])
        while todo:
            node = todo.popleft()
            for id in node.successors:
                if id not in found:
                    found[id] = found[node.id] + 1
                    todo.append(self.policy.node(id))
        return found

    @cached_property
    def to_stop(self) -> dict[NodeId, int]:
        """How many actions a stop is away at the least, for each node that may be met."""
        before: dict[NodeId, list[NodeId]] = {}
        for id in self.reachable:
            for successor in self.policy.node(id).successors:
                before.setdefault(successor, []).append(id)
        found = {id: 0 for id in self.reachable if self.policy.node(id).action is None}
        todo = deque(found)
        while todo:
            id = todo.popleft()
            for earlier in before.get(id, ()):
                if earlier not in found:
                    found[earlier] = found[id] + 1
                    todo.append(earlier)
        return found

    # -- what is sure --------------------------------------------------------------------------

    @cached_property
    def layers(self) -> tuple[tuple[PolicyNode, ...], ...]:
        """The nodes that the policy can be at in 0, 1, 2 ... actions.

        It ends where some execution may have stopped: beyond, nothing is sure at an instant.
        """
        layers: list[tuple[PolicyNode, ...]] = [(self.node,)]
        while len(layers) <= MOST_LAYERS and all(node.action for node in layers[-1]):
            ids = dict.fromkeys(id for node in layers[-1] for id in node.successors)
            if len(ids) > MOST_WIDTH or not ids:
                break
            layers.append(tuple(map(self.policy.node, ids)))
        return tuple(layers)

    @cached_property
    def sure(self) -> tuple[State, ...]:
        """The atoms true in every execution in 0, 1, 2 ... actions."""
        return tuple(
            frozenset.intersection(*(node.state for node in layer)) for layer in self.layers
        )

    @cached_property
    def sure_actions(self) -> tuple[GroundAction, ...]:
        """The actions that come one after another whatever the outcomes, from the next one on."""
        found: list[GroundAction] = []
        for layer in self.layers:
            actions = {node.action for node in layer}
            if len(actions) != 1 or None in actions:
                break
            found.extend(action for action in actions if action)
        return tuple(found)

    def sure_run(self, atom: GroundAtom, start: int) -> tuple[Instant, Instant] | None:
        """The instants from `start` actions on at which an atom is sure, None if there are none."""
        if start >= len(self.sure) or atom not in self.sure[start]:
            return None
        end = start
        while end + 1 < len(self.sure) and atom in self.sure[end + 1]:
            end += 1
        return self.now + start, self.now + end

    @cached_property
    def unavoidable(self) -> tuple[GroundAction, ...]:
        """The actions that every execution does at least once, the earliest first."""
        first: dict[GroundAction, int] = {}
        users: dict[GroundAction, set[NodeId]] = {}
        for id, distance in self.reachable.items():
            action = self.policy.node(id).action
            if action is not None:
                first[action] = min(first.get(action, distance), distance)
                users.setdefault(action, set()).add(id)
        if len(first) * len(self.reachable) > MOST_WORK:
            return self.sure_actions
        found = [action for action, ids in users.items() if not self._stops_without(ids)]
        return tuple(sorted(found, key=lambda action: (first[action], action)))

    def _stops_without(self, forbidden: set[NodeId]) -> bool:
        """Whether a stop can be reached without acting in one of these nodes."""
        if self.node.id in forbidden:
            return False
        seen = {self.node.id}
        todo = [self.node]
        while todo:
            node = todo.pop()
            if node.action is None:
                return True
            for id in node.successors:
                if id not in seen and id not in forbidden:
                    seen.add(id)
                    todo.append(self.policy.node(id))
        return False

    @cached_property
    def finally_true(self) -> State:
        """The atoms true wherever the policy may stop."""
        stops = [
            self.policy.node(id).state
            for id in self.reachable
            if self.policy.node(id).action is None
        ]
        return frozenset.intersection(*stops) if stops else frozenset()

    @cached_property
    def kept(self) -> State:
        """The atoms that are true now and stay so in every execution."""
        return frozenset.intersection(*(self.policy.node(id).state for id in self.reachable))

    # -- what is possible ----------------------------------------------------------------------

    def path_to(self, wanted: Iterator[NodeId] | set[NodeId]) -> tuple[PolicyNode, ...] | None:
        """A shortest execution from now to one of some nodes, both ends included."""
        goals = set(wanted)
        came: dict[NodeId, NodeId] = {}
        todo = deque([self.node.id])
        seen = {self.node.id}
        while todo:
            id = todo.popleft()
            if id in goals:
                path = [id]
                while path[-1] in came:
                    path.append(came[path[-1]])
                return tuple(self.policy.node(each) for each in reversed(path))
            for successor in self.policy.node(id).successors:
                if successor not in seen:
                    seen.add(successor)
                    came[successor] = id
                    todo.append(successor)
        return None

    def shortest(self, node: PolicyNode) -> tuple[PolicyNode, ...]:
        """The shortest execution from a node to a stop, both ends included."""
        path = [node]
        while path[-1].successors:
            nearest = min(path[-1].successors, key=lambda id: self.to_stop.get(id, 1 << 30))
            if self.to_stop.get(nearest, 1 << 30) >= self.to_stop.get(path[-1].id, 1 << 30):
                break
            path.append(self.policy.node(nearest))
        return tuple(path)

    def repeats(self, node: PolicyNode) -> bool:
        """Whether the node's action may leave things as they are, to be tried again."""
        return node.id in node.successors or any(
            self.policy.node(id).state == node.state and self.policy.node(id).action == node.action
            for id in node.successors
        )

    @cached_property
    def remaining(self) -> Remaining:
        """How many actions are left, at the least and at the most."""
        least = self.to_stop.get(self.node.id, 0)
        order, looping = self._order()
        if looping is not None:
            return Remaining(least, None, looping)
        most: dict[NodeId, int] = {}
        for id in order:
            node = self.policy.node(id)
            most[id] = max((most[each] + 1 for each in node.successors), default=0)
        return Remaining(least, most[self.node.id], None)

    def _order(self) -> tuple[list[NodeId], GroundAction | None]:
        """The nodes, each after its successors; or an action that lies on a cycle."""
        done: list[NodeId] = []
        colour = {self.node.id: 1}
        stack = [(self.node, iter(self.node.successors))]
        while stack:
            node, rest = stack[-1]
            id = next(rest, None)
            if id is None:
                stack.pop()
                colour[node.id] = 2
                done.append(node.id)
            elif id not in colour:
                colour[id] = 1
                child = self.policy.node(id)
                stack.append((child, iter(child.successors)))
            elif colour[id] == 1:
                return done, node.action
        return done, None
