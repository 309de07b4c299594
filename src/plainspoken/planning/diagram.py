"""Policies as diagrams: DOT and Mermaid text.

A node says what the robot does there; an edge where the world has a choice says what tells that
outcome from the others.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from plainspoken.planning.policy import NodeId, Policy, PolicyNode
from plainspoken.world.domain import GroundAction, GroundAtom

Words = Callable[[str], str]
"""How to write a ground atom or a ground action."""

MOST_CHANGES = 4
"""An edge that would name more changes than this names the first ones and how many follow."""


@dataclass(frozen=True, slots=True)
class Edge:
    source: NodeId
    target: NodeId
    label: str


def dot(policy: Policy, *, action: Words = str, atom: Words = str) -> str:
    """The policy in the DOT language of Graphviz."""
    lines = [
        "digraph policy {",
        '  node [shape=box, style="rounded,filled", fillcolor="#eef4fb", fontname="Helvetica"];',
        '  edge [fontname="Helvetica", fontsize=10];',
        '  start [shape=circle, label="", width=0.15, fillcolor="#333333"];',
        f"  start -> n{policy.initial};",
    ]
    for node in policy.nodes:
        style = ', shape=doublecircle, fillcolor="#dff0d8"' if node.action is None else ""
        lines.append(f'  n{node.id} [label="{_escaped(_label(node, action))}"{style}];')
    lines += [
        f'  n{edge.source} -> n{edge.target} [label="{_escaped(edge.label)}"];'
        for edge in edges(policy, atom)
    ]
    return "\n".join([*lines, "}"]) + "\n"


def mermaid(policy: Policy, *, action: Words = str, atom: Words = str) -> str:
    """The policy as a Mermaid flowchart, which code hosts draw inside Markdown."""
    lines = ["flowchart TD", f"  start(( )) --> n{policy.initial}"]
    for node in policy.nodes:
        label = _label(node, action).replace('"', "'")
        lines.append(
            f'  n{node.id}((("{label}")))' if node.action is None else f'  n{node.id}("{label}")'
        )
    for edge in edges(policy, atom):
        label = edge.label.replace('"', "'")
        arrow = f'-- "{label}" -->' if label else "-->"
        lines.append(f"  n{edge.source} {arrow} n{edge.target}")
    return "\n".join(lines) + "\n"


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
