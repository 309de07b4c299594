"""Policies as diagrams: DOT and Mermaid text.

A node says what the robot does there; an edge where the world has a choice says what that
outcome made true, and false where it made nothing true.
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
        '  rankdir=TB; node [shape=box, style="rounded,filled", fillcolor="#eef4fb",'
        ' fontname="Helvetica"]; edge [fontname="Helvetica", fontsize=10];',
        '  start [shape=circle, label="", width=0.15, fillcolor="#333333"];',
        f"  start -> n{policy.initial};",
    ]
    for node in policy.nodes:
        style = ', shape=doublecircle, fillcolor="#dff0d8"' if node.action is None else ""
        lines.append(f'  n{node.id} [label="{_escaped(_label(node, action))}"{style}];')
    for edge in edges(policy, atom):
        lines.append(f'  n{edge.source} -> n{edge.target} [label="{_escaped(edge.label)}"];')
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
        for id in node.successors:
            label = "" if len(node.successors) == 1 else _change(node, policy.node(id), atom)
            yield Edge(node.id, id, label)


def _label(node: PolicyNode, words: Callable[[GroundAction], str]) -> str:
    return "done" if node.action is None else words(node.action)


def _change(before: PolicyNode, after: PolicyNode, words: Callable[[GroundAtom], str]) -> str:
    """What is true after and was not before; failing that, what is not true any more."""
    added = sorted(after.state - before.state)
    deleted = sorted(before.state - after.state)
    changes = [words(atom) for atom in added] or [f"not {words(atom)}" for atom in deleted]
    if len(changes) > MOST_CHANGES:
        changes = [*changes[:MOST_CHANGES], f"and {len(changes) - MOST_CHANGES} more"]
    return ", ".join(changes) or "nothing changes"


def _escaped(text: str) -> str:
    return text.replace("\\", "\\\\").replace('"', '\\"')
