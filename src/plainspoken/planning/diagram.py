"""Policies as diagrams, DOT and Mermaid, and as lists of rules.

A node says what the robot does there; an edge where the world has a choice says what tells that
outcome from the others.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

from plainspoken.planning.decision_list import decision_list
from plainspoken.planning.policy import NodeId, Policy, PolicyNode
from plainspoken.world.domain import GroundAction, GroundAtom

Words = Callable[[str], str]
"""How to write a ground atom or a ground action."""

MOST_LABELS = 2
"""Edges between two boxes that differ in more labels than this are drawn as one without any."""
MOST_CHANGES = 4
"""An edge that would name more changes than this names the first ones and how many follow."""


@dataclass(frozen=True, slots=True)
class Edge:
    source: NodeId
    target: NodeId
    label: str


@dataclass(frozen=True, slots=True)
class Box:
    """Where something is done. stop: where the policy stops, satisfied."""

    id: NodeId
    label: str
    stop: bool


@dataclass(frozen=True)
class Drawing:
    """What a diagram shows of a policy."""

    first: NodeId
    boxes: tuple[Box, ...]
    edges: tuple[Edge, ...]


def whole(policy: Policy, *, action: Words = str, atom: Words = str) -> Drawing:
    """A box for each node."""
    boxes = (Box(node.id, _label(node, action), node.action is None) for node in policy.nodes)
    return Drawing(policy.initial, tuple(boxes), tuple(edges(policy, atom)))


def compact(policy: Policy, *, action: Words = str, atom: Words = str) -> Drawing:
    """A box for each rule of the policy's decision list, for all the nodes that it decides."""
    listed = decision_list(policy)
    places = {id: listed.rule_of(policy.node(id)) for id in listed.memory}
    boxes = []
    for place in sorted(set(places.values())):
        rule = listed.rules[place]
        deed = "done" if rule.action is None else action(rule.action)
        facts = _conditions(rule.facts, atom)
        boxes.append(Box(place, deed + (f" ({facts})" if facts else ""), rule.action is None))
    labels: dict[tuple[NodeId, NodeId], dict[str, None]] = {}
    for edge in edges(policy, atom):
        if edge.source in places:
            between = places[edge.source], places[edge.target]
            labels.setdefault(between, {})[edge.label] = None
    merged = (
        Edge(*between, " / ".join(found) if len(found) <= MOST_LABELS else "")
        for between, found in labels.items()
    )
    return Drawing(places[policy.initial], tuple(boxes), tuple(merged))


def dot(drawing: Drawing) -> str:
    """The policy in the DOT language of Graphviz."""
    lines = [
        "digraph policy {",
        '  node [shape=box, style="rounded,filled", fillcolor="#eef4fb", fontname="Helvetica"];',
        '  edge [fontname="Helvetica", fontsize=10];',
        '  start [shape=circle, label="", width=0.15, fillcolor="#333333"];',
        f"  start -> n{drawing.first};",
    ]
    for box in drawing.boxes:
        style = ', shape=doublecircle, fillcolor="#dff0d8"' if box.stop else ""
        lines.append(f'  n{box.id} [label="{_escaped(box.label)}"{style}];')
    lines += [
        f'  n{edge.source} -> n{edge.target} [label="{_escaped(edge.label)}"];'
        for edge in drawing.edges
    ]
    return "\n".join([*lines, "}"]) + "\n"


def mermaid(drawing: Drawing) -> str:
    """The policy as a Mermaid flowchart, which code hosts draw inside Markdown."""
    lines = ["flowchart TD", f"  start(( )) --> n{drawing.first}"]
    for box in drawing.boxes:
        label = box.label.replace('"', "'")
        lines.append(f'  n{box.id}((("{label}")))' if box.stop else f'  n{box.id}("{label}")')
    for edge in drawing.edges:
        label = edge.label.replace('"', "'")
        arrow = f'-- "{label}" -->' if label else "-->"
        lines.append(f"  n{edge.source} {arrow} n{edge.target}")
    return "\n".join(lines) + "\n"


def rules(policy: Policy, *, action: Words = str, atom: Words = str) -> str:
    """The policy's decision list as text, a rule a line; the first that fits counts."""
    listed = decision_list(policy)
    lines = []
    for number, rule in enumerate(listed.rules, 1):
        facts = [_conditions(rule.facts, atom)] if rule.facts else []
        facts += [] if rule.memory is None else [f"the memory is {rule.memory}"]
        condition = f"if {' and '.join(facts)}" if facts else "otherwise"
        deed = "stop" if rule.action is None else action(rule.action)
        lines.append(f"{number:>3}. {condition}: {deed}")
    if listed.changes:
        lines.append("The memory is 0 at the start, and changes so (the first that fits counts):")
    for change in listed.changes:
        before = _conditions(change.before, atom)
        after = _conditions(change.after, atom)
        lines.append(
            f"  {change.memory} to {change.becomes}, by: {action(change.action)}"
            + (f", if before it {before}" if before else "")
            + (f", if after it {after}" if after else "")
        )
    return "\n".join(lines) + "\n"


def _conditions(facts: Iterable[tuple[GroundAtom, bool]], atom: Words) -> str:
    return " and ".join(atom(fact) if true else f"not {atom(fact)}" for fact, true in facts)


def edges(policy: Policy, atom: Words = str) -> Iterator[Edge]:
    """The policy's edges; labelled where an action has several outcomes."""
    for node in policy.nodes:
        for outcome in outcomes(policy, node):
            label = "" if len(node.successors) == 1 else _said(outcome, atom)
            yield Edge(node.id, outcome.node.id, label)


@dataclass(frozen=True, slots=True)
class PolicyOutcome:
    """One way a node's action may turn out: the ground atoms that tell it from the others.

    added:   true after it, and not both before and after every other outcome
    deleted: false after it, in the same sense
    """

    node: PolicyNode
    added: tuple[GroundAtom, ...]
    deleted: tuple[GroundAtom, ...]


def outcomes(policy: Policy, node: PolicyNode) -> tuple[PolicyOutcome, ...]:
    """The ways a node's action may turn out, in the order of its successors."""
    after = [policy.node(id) for id in node.successors]
    added = [successor.state - node.state for successor in after]
    deleted = [node.state - successor.state for successor in after]
    # What every outcome does says nothing about which of them it was.
    always_added = frozenset.intersection(*added) if len(after) > 1 else frozenset()
    always_deleted = frozenset.intersection(*deleted) if len(after) > 1 else frozenset()
    return tuple(
        PolicyOutcome(
            successor, tuple(sorted(new - always_added)), tuple(sorted(gone - always_deleted))
        )
        for successor, new, gone in zip(after, added, deleted, strict=True)
    )


def _label(node: PolicyNode, words: Callable[[GroundAction], str]) -> str:
    return "done" if node.action is None else words(node.action)


def _said(outcome: PolicyOutcome, words: Callable[[GroundAtom], str]) -> str:
    changes = [words(atom) for atom in outcome.added]
    changes = changes or [f"not {words(atom)}" for atom in outcome.deleted]
    if len(changes) > MOST_CHANGES:
        changes = [*changes[:MOST_CHANGES], f"and {len(changes) - MOST_CHANGES} more"]
    return ", ".join(changes) or "otherwise"


def _escaped(text: str) -> str:
    return text.replace("\\", "\\\\").replace('"', '\\"')
