"""A policy as a graph to look at: what was, what is, what may come, and what can come no more.

Of a large policy only the neighbourhood of the present is drawn; what lies beyond is folded into
boxes that say how many situations they hold, and open when they are asked to.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from typing import Any, Literal

from plainspoken.planning.diagram import edges
from plainspoken.planning.policy import NodeId, Policy
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.moment import Moment

Kind = Literal["past", "present", "future", "missed"]
Shown = str
"""The id of something drawn: `12` for a node, `fold 12` for a box whose first node is 12."""

PLENTY = 40
"""Nodes that are drawn without folding."""
AHEAD, BEHIND = 4, 8
"""Steps before and after the present that are drawn of a larger policy."""
ACROSS, DOWN = 235.0, 96.0


@dataclass(frozen=True, slots=True)
class Vertex:
    """Something drawn. holds: nodes folded into it, 1 for a node itself."""

    id: Shown
    kind: Kind
    label: str
    x: float
    y: float
    stop: bool = False
    holds: int = 1


@dataclass(frozen=True, slots=True)
class Arrow:
    """What leads from one to the other. label: what tells this outcome, where there are others."""

    source: Shown
    target: Shown
    kind: Kind
    label: str = ""


@dataclass(frozen=True)
class Graph:
    """A policy as it is drawn."""

    vertices: tuple[Vertex, ...]
    arrows: tuple[Arrow, ...]
    folds: Mapping[Shown, frozenset[NodeId]]

    def to_json(self) -> dict[str, Any]:
        return {
            "nodes": [
                {"id": v.id, "kind": v.kind, "label": v.label, "x": v.x, "y": v.y,
                 "stop": v.stop, "holds": v.holds}
                for v in self.vertices
            ],
            "edges": [
                {"source": a.source, "target": a.target, "kind": a.kind, "label": a.label}
                for a in self.arrows
            ],
        }  # fmt: skip


def graph_of(
    policy: Policy,
    past: Sequence[NodeId],
    present: NodeId | None,
    lexicon: Lexicon,
    *,
    opened: AbstractSet[NodeId] = frozenset(),
    whole: bool = False,
) -> Graph:
    """Draw a policy.

    past:    the nodes that were gone through, the earliest first
    present: where the mission is, None where the policy does not say
    opened:  folded nodes that are to be seen, with those around them
    whole:   fold nothing
    """
    kinds = kinds_of(policy, past, present)
    seen = set(kinds) if whole or len(kinds) <= PLENTY else _seen(policy, past, present, opened)
    folds = _folds(policy, kinds, seen)
    drawn = {id: str(id) for id in seen} | {id: f for f, ids in folds.items() for id in ids}
    went = set(zip(past, (*past[1:], present), strict=True)) if past else set()
    arrows = _arrows(policy, drawn, went, _ahead(policy, present), lexicon)
    spots = _layered(list(dict.fromkeys(drawn[n.id] for n in policy.nodes)), arrows)
    vertices = [
        Vertex(
            str(n.id), kinds[n.id], _label(n.action, lexicon), *spots[str(n.id)], n.action is None
        )
        for n in policy.nodes
        if n.id in seen
    ]
    for fold, ids in folds.items():
        kind = kinds[min(ids)]
        when = {"past": "earlier", "missed": "missed"}.get(kind, "more")
        label = f"{len(ids)} {when} situation{'' if len(ids) == 1 else 's'}"
        vertices.append(Vertex(fold, kind, label, *spots[fold], holds=len(ids)))
    return Graph(tuple(vertices), arrows, folds)


def kinds_of(
    policy: Policy, past: Collection[NodeId], present: NodeId | None
) -> dict[NodeId, Kind]:
    """What each node is, seen from the present.

    A node that was gone through and can be come to again is past; the mission may end anywhere.
    """
    ahead, went = _ahead(policy, present), set(past)
    found: dict[NodeId, Kind] = {}
    for node in policy.nodes:
        found[node.id] = (
            "present" if node.id == present
            else "past" if node.id in went
            else "future" if node.id in ahead
            else "missed"
        )  # fmt: skip
    return found


def _ahead(policy: Policy, present: NodeId | None) -> set[NodeId]:
    """The nodes that may be come to from the present, itself included."""
    return _within(policy, () if present is None else (present,), None, _successors(policy))


def _successors(policy: Policy) -> Callable[[NodeId], Iterable[NodeId]]:
    return lambda id: policy.node(id).successors


def _within(
    policy: Policy,
    start: Iterable[NodeId],
    most: int | None,
    following: Callable[[NodeId], Iterable[NodeId]],
) -> set[NodeId]:
    """The nodes at most so many steps from some."""
    found = {id for id in start if id in policy.by_id}
    level = sorted(found)
    while level and (most is None or most > 0):
        most = None if most is None else most - 1
        level = [id for id in dict.fromkeys(n for e in level for n in following(e))
                 if id not in found]  # fmt: skip
        found.update(level)
    return found


def _seen(
    policy: Policy, past: Sequence[NodeId], present: NodeId | None, opened: AbstractSet[NodeId]
) -> set[NodeId]:
    here = present if present is not None else past[-1] if past else policy.initial
    near = _within(policy, (here,), AHEAD, _successors(policy))
    asked = _within(policy, opened, AHEAD - 1, _successors(policy))
    return near | asked | set(past[-BEHIND:]) | {policy.initial}


def _folds(
    policy: Policy, kinds: Mapping[NodeId, Kind], seen: AbstractSet[NodeId]
) -> dict[Shown, frozenset[NodeId]]:
    """The nodes that are not seen, those together that are joined and of one kind."""
    root = {id: id for id in kinds if id not in seen}

    def find(id: NodeId) -> NodeId:
        while root[id] != id:
            root[id] = root[root[id]]
            id = root[id]
        return id

    for node, successor in policy.edges():
        if node.id in root and successor.id in root and kinds[node.id] == kinds[successor.id]:
            one, other = sorted((find(node.id), find(successor.id)))
            root[other] = one
    found: dict[NodeId, set[NodeId]] = {}
    for id in root:
        found.setdefault(find(id), set()).add(id)
    return {f"fold {first}": frozenset(ids) for first, ids in found.items()}


def _arrows(
    policy: Policy,
    drawn: Mapping[NodeId, Shown],
    went: AbstractSet[tuple[NodeId, NodeId | None]],
    ahead: AbstractSet[NodeId],
    lexicon: Lexicon,
) -> tuple[Arrow, ...]:
    found: dict[tuple[Shown, Shown], Arrow] = {}
    for edge in edges(policy, lambda atom: lexicon.clause(atom).said()):
        source, target = drawn[edge.source], drawn[edge.target]
        folded = source.startswith("fold") or target.startswith("fold")
        if source == target and folded:
            continue
        kind: Kind = "future" if edge.source in ahead else "missed"
        if (edge.source, edge.target) in went:
            kind = "past"
        known = found.get((source, target))
        if known is None or (known.kind != "past" and kind == "past"):
            found[source, target] = Arrow(source, target, kind, "" if folded else edge.label)
    return tuple(found.values())


def _label(action: str | None, lexicon: Lexicon) -> str:
    return "done" if action is None else lexicon.deed(action).bare


def naming(policy: Policy, words: str, lexicon: Lexicon) -> list[NodeId]:
    """The nodes whose label has some words."""
    asked = words.strip().lower()
    return [node.id for node in policy.nodes if asked in _label(node.action, lexicon).lower()]


def _layered(names: Sequence[Shown], arrows: Iterable[Arrow]) -> dict[Shown, tuple[float, float]]:
    """A spot for each: across by how many steps it is from the first, down by its neighbours."""
    after: dict[Shown, list[Shown]] = {name: [] for name in names}
    before: dict[Shown, list[Shown]] = {name: [] for name in names}
    for arrow in arrows:
        after[arrow.source].append(arrow.target)
        before[arrow.target].append(arrow.source)
    depth: dict[Shown, int] = {}
    for start in names:
        if start in depth:
            continue
        depth[start] = min((depth[b] + 1 for b in before[start] if b in depth), default=0)
        level = [start]
        while level:
            following = []
            for name in level:
                for other in after[name]:
                    if other not in depth:
                        depth[other] = depth[name] + 1
                        following.append(other)
            level = following
    layers: dict[int, list[Shown]] = {}
    for name in sorted(names, key=depth.__getitem__):
        layers.setdefault(depth[name], []).append(name)
    row = {name: float(i) for layer in layers.values() for i, name in enumerate(layer)}
    for _ in range(4):
        for layer in layers.values():
            wish = {
                name: sum(row[n] for n in near) / len(near)
                if (near := [*before[name], *after[name]])
                else row[name]
                for name in layer
            }
            layer.sort(key=lambda name: (wish[name], names.index(name) if len(names) < 200 else 0))
            for i, name in enumerate(layer):
                row[name] = i - (len(layer) - 1) / 2
    return {name: (depth[name] * ACROSS, row[name] * DOWN) for name in names}


def walked(moment: Moment) -> tuple[Policy | None, tuple[NodeId, ...], NodeId | None]:
    """The policy that was chosen last, the nodes of it gone through, and the one that is now."""
    if moment.chosen is None:
        return None, (), None
    policy = moment.policy_at(moment.chosen_step)
    past = [
        each.node for each in moment.happenings
        if each.policy == moment.chosen_step and each.node is not None
    ]  # fmt: skip
    present = moment.node_id
    return policy, tuple(past), present


def situation(policy: Policy, node: NodeId, moment: Moment) -> str:
    """What a node is about: how it differs from now, and what I do there."""
    lexicon, found = moment.lexicon, policy.node(node)
    changes = found.state ^ (moment.state - policy.static - moment.static)
    facts = [
        lexicon.clause(atom).said(negative=atom not in found.state)
        for atom in sorted(changes, key=lambda atom: (atom not in found.state, atom))
    ]
    told = [fact for fact in facts if fact][:6]
    where = f"When {', '.join(told)}" if told else "As things are now"
    deed = "the mission is done" if found.action is None else f"I {lexicon.deed(found.action).bare}"
    return f"{where}: {deed}."
