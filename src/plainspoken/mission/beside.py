"""Actions of different robots side by side: which one may begin before its turn, and what then.

A policy is a sequence: one action, then the next. While a robot is at the policy's action, another
one may begin what the policy has for it later, if that makes no difference but to the time:
- along every branch from here, the first action of the other robot is this one, and the policy
  does not stop before it;
- neither it nor any action before it reads or changes what the other may change, or needs the
  other's robot (`footprint`);
- wherever it may come to its end on the way, and however it and the others turn out, the policy
  with this action taken out of its place leads to what is asked for. That is checked as any policy
  is, with what the request remembers by then (`coverage`): so its verdict is the same in either
  order.

The trace stays a sequence with one action an instant, in the order in which the actions are seen to
end. Where the later one ends first, the policy is rearranged: its nodes up to there are repeated,
with what has been done already in their states. What an action under way may be changing is
believed to be as it was until it ends.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

from plainspoken.mission.coverage import Memory, all_sound
from plainspoken.mission.footprint import footprints_of
from plainspoken.mission.judgement import broken
from plainspoken.mission.mission import Mission
from plainspoken.planning.policy import NodeId, Policy, PolicyNode
from plainspoken.world.domain import GroundAction, State
from plainspoken.world.event import ActionStarted
from plainspoken.world.scene import relevant_to, successors
from plainspoken.world.symbol import letter

MOST_BEFORE = 64
"""How many nodes of a policy may come before an action that begins early."""
MOST_NODES = 5000
"""Policies with more nodes are followed one action at a time: each early start checks them."""


@dataclass(frozen=True, slots=True)
class Early:
    """An action that may begin before its turn.

    node:   one where the policy has it
    before: the nodes from which the policy leads to it, with nothing of its robot on the way
    """

    action: GroundAction
    node: NodeId
    before: frozenset[NodeId]


def goes_on(mission: Mission) -> bool:
    """Whether the policy's next action may begin while one that began early is under way."""
    if (
        mission.policy is None
        or mission.node is None
        or mission.cancelled_by is not None
        or mission.lost is not None
        or mission.change is not None
        or broken(mission)
    ):
        return False
    action = mission.policy.node(mission.node).action
    if action is None:
        return False
    footprints = footprints_of(mission.brief.problem)
    return mission.beside is None or not footprints.of(action).disturbs(
        footprints.of(mission.beside.action)
    )


def begun_beside(mission: Mission, stale: State = frozenset()) -> ActionStarted | None:
    """What another robot begins beside the policy's action, where nothing speaks against it."""
    if not mission.brief.side_by_side or mission.paused_by is not None or not goes_on(mission):
        return None
    early = early_action(mission, stale)
    if early is None:
        return None
    return ActionStarted(early.action, early.node, f"{mission.id}/{mission.sent + 1}")


def early_action(mission: Mission, stale: State = frozenset()) -> Early | None:
    """What another robot may begin while the policy's action is under way; None for nothing.

    stale: atoms that were seen too long ago to rest a decision on
    """
    goal, policy = mission.in_flight, mission.policy
    if (
        goal is None
        or policy is None
        or mission.beside is not None
        or mission.node != goal.node
        or len(policy.nodes) > MOST_NODES
    ):
        return None
    footprints = footprints_of(mission.brief.problem)
    unsure = mission.lookout.unsure(stale)
    for robot in sorted(_others(mission, goal.action)):
        early = _first_of(robot, policy, goal.node, mission)
        if early is None or not footprints.of(early.action).robots:
            continue
        if unsure and unsure & relevant_to(mission.brief.problem, early.action):
            continue
        own = footprints.of(early.action)
        on_the_way = {policy.node(id).action or "" for id in early.before}
        if any(own.disturbs(footprints.of(action)) for action in on_the_way):
            continue
        if _leads_there(mission, policy, early):
            return early
    return None


@dataclass(frozen=True, slots=True)
class Rearranged:
    """A policy with an action taken out of its place. repeats: which node each new one repeats."""

    policy: Policy
    repeats: Mapping[NodeId, NodeId]


def ended_early(mission: Mission, action: GroundAction, state: State) -> Rearranged | NodeId | None:
    """How to go on where an action that began early has ended, in such a state.

    mission: before that
    gives the node that the mission stays at where the action has changed nothing; None where the
    policy does not foresee what it has
    """
    policy, node = mission.policy, mission.node
    if policy is None or node is None:
        return None
    brief, world = mission.brief, state | mission.brief.static
    (robot, *_) = sorted(footprints_of(brief.problem).of(action).robots)
    early = _first_of(robot, policy, node, mission)
    if early is None or early.action != action:
        return None
    if world not in successors(brief.problem, mission.world, action):
        return None
    after = mission.monitor.after(letter(brief.symbols, world, action))
    memory = tuple(part.state for part in after.parts)
    if state == mission.state and all_sound(policy, [(node, memory)], after, brief.symbols):
        return node
    numbers = _fresh(mission, policy, early)
    changed = _rearranged(policy, early, numbers, state ^ mission.state, numbers[node])
    if changed is None or not all_sound(changed, [(changed.initial, memory)], after, brief.symbols):
        return None
    kept = changed.by_id
    return Rearranged(changed, {new: old for old, new in numbers.items() if new in kept})


def masked(mission: Mission, seen: State, ended: GroundAction) -> State:
    """What is believed when an action ends: what others may be changing stays as it was."""
    hidden: State = frozenset()
    for goal in mission.under_way:
        if goal.action != ended:
            hidden |= footprints_of(mission.brief.problem).of(goal.action).writes
    return (seen - hidden) | (mission.state & hidden)


def _others(mission: Mission, action: GroundAction) -> frozenset[str]:
    """The robots that the policy commands, without those of an action."""
    footprints = footprints_of(mission.brief.problem)
    policy = mission.policy
    if policy is None:
        return frozenset()
    actions = {node.action for node in policy.nodes if node.action is not None}
    robots = frozenset[str]().union(*(footprints.of(each).robots for each in actions))
    return robots - footprints.of(action).robots


def _first_of(robot: str, policy: Policy, start: NodeId, mission: Mission) -> Early | None:
    """The first action of a robot from a node on, if it is the same along every branch."""
    footprints = footprints_of(mission.brief.problem)
    before: set[NodeId] = set()
    found: dict[GroundAction, NodeId] = {}
    todo = [start]
    while todo:
        id = todo.pop()
        if id in before:
            continue
        action = policy.node(id).action
        if action is None or len(before) >= MOST_BEFORE:
            return None
        if robot in footprints.of(action).robots:
            found.setdefault(action, id)
            if len(found) > 1:
                return None
            continue
        before.add(id)
        todo += policy.node(id).successors
    if not found or start not in before:
        return None
    ((action, node),) = found.items()
    return Early(action, node, frozenset(before))


def _leads_there(mission: Mission, policy: Policy, early: Early) -> bool:
    """Whether the request is met wherever on the way the action ends, and however."""
    numbers = _fresh(mission, policy, early)
    ends = _ends(mission, policy, early)
    if ends is None:
        return False
    for change, reached in ends.items():
        changed = _rearranged(policy, early, numbers, change, None)
        if changed is None:
            return False
        starts = [(numbers[node], memory) for node, memory in reached]
        if not all_sound(changed, starts, mission.monitor, mission.brief.symbols):
            return False
    return True


def _ends(
    mission: Mission, policy: Policy, early: Early
) -> Mapping[State, list[tuple[NodeId, Memory]]] | None:
    """For each change that the action may bring about, where it may, and what is remembered then.

    A change is the atoms that become other than they were. None where it depends on the place.
    """
    brief = mission.brief
    automata = tuple(part.automaton for part in mission.monitor.parts)

    def stepped(memory: Memory, state: State, action: GroundAction) -> Memory:
        seen = letter(brief.symbols, state | brief.static, action)
        return tuple(a.step(s, seen) for a, s in zip(automata, memory, strict=True))

    assert mission.in_flight is not None  # noqa: S101 - there is something beside which it begins
    first = (mission.in_flight.node, tuple(part.state for part in mission.monitor.parts))
    known = {first}
    todo = [first]
    ends: dict[State, list[tuple[NodeId, Memory]]] = {}
    changes: frozenset[State] | None = None
    while todo:
        id, memory = todo.pop()
        node = policy.node(id)
        world = node.state | policy.static | brief.static
        outcomes = successors(brief.problem, world, early.action)
        here = frozenset(world ^ outcome for outcome in outcomes)
        if changes is not None and here != changes:
            return None
        changes = here
        for outcome in outcomes:
            after = stepped(memory, outcome, early.action)
            ends.setdefault(world ^ outcome, []).append((id, after))
        for successor in node.successors:
            if successor in early.before and node.action is not None:
                state = policy.node(successor).state | policy.static
                pair = (successor, stepped(memory, state, node.action))
                if pair not in known:
                    known.add(pair)
                    todo.append(pair)
    return ends


def _fresh(mission: Mission, policy: Policy, early: Early) -> dict[NodeId, NodeId]:
    """Numbers for the nodes that are repeated, which no node had that was ever come to."""
    free = max([*policy.by_id, *mission.visits]) + 1
    return {id: free + index for index, id in enumerate(sorted(early.before))}


def _rearranged(
    policy: Policy,
    early: Early,
    numbers: Mapping[NodeId, NodeId],
    change: State,
    initial: NodeId | None,
) -> Policy | None:
    """The policy with an action taken out of its place, as it has been done already.

    change:  the atoms that it made other than they were
    initial: the node to begin at; None leaves the policy as long as it was
    None where the policy has no node for the state after it.
    """
    repeated = []
    for id in sorted(early.before):
        node = policy.node(id)
        then: list[NodeId] = []
        for successor in node.successors:
            if successor in numbers:
                then.append(numbers[successor])
                continue
            wanted = policy.node(successor).state ^ change
            found = [
                each
                for each in policy.node(successor).successors
                if policy.node(each).state == wanted
            ]
            if not found:
                return None
            then.append(found[0])
        repeated.append(PolicyNode(numbers[id], node.state ^ change, node.action, tuple(then)))
    nodes = (*policy.nodes, *repeated)
    if initial is None:
        return replace(policy, nodes=nodes)
    return replace(policy, initial=initial, nodes=_reachable(nodes, initial))


def _reachable(nodes: Iterable[PolicyNode], initial: NodeId) -> tuple[PolicyNode, ...]:
    by_id = {node.id: node for node in nodes}
    found: dict[NodeId, PolicyNode] = {}
    todo = [initial]
    while todo:
        id = todo.pop()
        if id not in found:
            found[id] = by_id[id]
            todo += by_id[id].successors
    return tuple(node for id, node in by_id.items() if id in found)
