"""When a mission is done with a thing: "stop after this mug"."""

from __future__ import annotations

from plainspoken.logic.formula import Atom, Eventually, Formula, Not, conjunction, disjunction
from plainspoken.mission.mission import Mission
from plainspoken.planning.policy import NodeId, Policy
from plainspoken.world.domain import GroundAtom, State
from plainspoken.world.symbol import flat

MOST_ENDINGS = 12
"""Ways for a thing to be left; a policy with more is too rich to be told in a formula."""


def done_with(mission: Mission, thing: str) -> Formula | None:
    """That a thing is as the policy leaves it, whichever way it turns out.

    None where the policy has no more to do with it, or leaves it in too many ways.
    """
    policy, node = mission.policy, mission.node
    if node is None and mission.in_flight is not None:
        node = mission.in_flight.node
    if policy is None or node is None:
        return None
    busy = _still_to_touch(policy, node, thing)
    if node not in busy:
        return None
    endings = {
        _about(policy.node(after).state, thing): None
        for each in busy
        for after in policy.node(each).successors
        if after not in busy
    }
    known = sorted({atom for ending in endings for atom in ending})
    if not 0 < len(endings) <= MOST_ENDINGS or not known:
        return None
    # What all endings share with what is so now tells none of them from now.
    now = _about(mission.state, thing)
    telling = [atom for atom in known if not all(atom in each for each in [*endings, now])]
    gone = [atom for atom in sorted(now) if not any(atom in ending for ending in endings)]
    ways = []
    for ending in endings:
        so: list[Formula] = [Atom(flat(atom)) for atom in telling if atom in ending]
        ways.append(conjunction(*(so or [Not(Atom(flat(atom))) for atom in gone])))
    return Eventually(disjunction(*ways))


def _about(state: State, thing: str) -> frozenset[GroundAtom]:
    return frozenset(atom for atom in state if thing in atom.split()[1:])


def _still_to_touch(policy: Policy, start: NodeId, thing: str) -> set[NodeId]:
    """The nodes from which some action on the thing is still ahead."""
    reachable: dict[NodeId, tuple[NodeId, ...]] = {}
    todo = [start]
    while todo:
        id = todo.pop()
        if id not in reachable:
            reachable[id] = policy.node(id).successors
            todo += reachable[id]
    busy = {id for id in reachable if thing in (policy.node(id).action or "").split()[1:]}
    while True:
        before = {id for id, after in reachable.items() if id not in busy and busy & set(after)}
        if not before:
            return busy
        busy |= before
