"""Policies as values, and the JSON that `plan --out` writes and `check --policy` reads."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, Literal

from plainspoken.errors import InputFileError
from plainspoken.world.document import read_json
from plainspoken.world.domain import GroundAction, GroundAtom, Problem, State

NodeId = int
PolicyKind = Literal["strong", "strong-cyclic", "weak"]
"""A weak policy reaches its end with luck: it says nothing for some outcomes, its gaps."""


@dataclass(frozen=True, slots=True)
class PolicyNode:
    """A state, with a memory of the formula, and what to do there.

    state:      the true ground atoms that some action changes (static ones: `Policy.static`)
    action:     None where the policy stops, satisfied
    successors: the nodes that the action's outcomes lead to, each once; empty where it stops
    """

    id: NodeId
    state: State
    action: GroundAction | None
    successors: tuple[NodeId, ...] = ()


@dataclass(frozen=True, slots=True)
class Gap:
    """An outcome that a weak policy has no answer to: the state that it leads to."""

    node: NodeId
    state: State


@dataclass(frozen=True)
class Policy:
    """A policy as a graph over nodes that are reachable from `initial`.

    gaps:    the outcomes that a weak policy does not cover; other policies have none
    seconds: what planning took, by stage (parse, ground, automaton, search, total)
    """

    kind: PolicyKind
    goal: str
    initial: NodeId
    static: frozenset[GroundAtom]
    nodes: tuple[PolicyNode, ...]
    seconds: Mapping[str, float] = field(default_factory=dict, compare=False)
    gaps: tuple[Gap, ...] = ()

    @cached_property
    def by_id(self) -> dict[NodeId, PolicyNode]:
        return {node.id: node for node in self.nodes}

    def node(self, id: NodeId) -> PolicyNode:
        return self.by_id[id]

    def edges(self) -> Iterator[tuple[PolicyNode, PolicyNode]]:
        """Every node with each of its successors."""
        for node in self.nodes:
            for successor in node.successors:
                yield node, self.by_id[successor]

    def to_json(self) -> dict[str, Any]:
        gaps = [{"node": gap.node, "state": sorted(gap.state)} for gap in self.gaps]
        return {
            "status": "solved",
            "kind": self.kind,
            "goal": self.goal,
            "initial": self.initial,
            "static": sorted(self.static),
            "nodes": [
                {
                    "id": node.id,
                    "state": sorted(node.state),
                    "action": node.action,
                    "successors": list(node.successors),
                }
                for node in self.nodes
            ],
            **({"gaps": gaps} if self.kind == "weak" else {}),
            "seconds": dict(self.seconds),
            "reason": None,
        }


def policy_from_json(document: object, path: str | Path) -> Policy:
    """Read a policy from a parsed JSON document; path is for the errors.

    raises InputFileError: with the field that is missing or of another type
    """
    reader = _Fields(path)
    top = reader.mapping(document, "")
    if top.get("status") != "solved":
        raise InputFileError(
            f"no policy in this file: its status is {top.get('status')!r}",
            path,
            field="status",
            hint="give the file that `plainspoken plan --out` wrote for a solved problem",
        )
    nodes = []
    for index, entry in enumerate(reader.sequence(top, "nodes")):
        place = f"nodes[{index}]"
        node = reader.mapping(entry, place)
        action = node.get("action")
        if action is not None and not isinstance(action, str):
            raise reader.wrong(f"{place}.action", "a text or null", action)
        nodes.append(
            PolicyNode(
                reader.number(node, "id", place),
                frozenset(reader.texts(node, "state", place)),
                " ".join(action.lower().split()) if action else None,
                tuple(reader.numbers(node, "successors", place)),
            )
        )
    kind = top.get("kind")
    if kind not in ("strong", "strong-cyclic", "weak"):
        raise reader.wrong("kind", "'strong', 'strong-cyclic' or 'weak'", kind)
    ids = [node.id for node in nodes]
    if len(set(ids)) != len(ids):
        raise InputFileError("two nodes have the same id", path, field="nodes")
    initial = reader.number(top, "initial", "")
    for id in {initial, *(each for node in nodes for each in node.successors)} - set(ids):
        raise InputFileError(f"there is no node {id}", path, field="nodes")
    static = frozenset(reader.texts(top, "static", "")) if "static" in top else frozenset()
    goal = top.get("goal")
    gaps = []
    for index, entry in enumerate(reader.sequence(top, "gaps") if kind == "weak" else ()):
        place = f"gaps[{index}]"
        gap = reader.mapping(entry, place)
        state = frozenset(reader.texts(gap, "state", place))
        gaps.append(Gap(reader.number(gap, "node", place), state))
    return Policy(
        kind,
        goal if isinstance(goal, str) else "",
        initial,
        static,
        tuple(nodes),
        gaps=tuple(gaps),
    )


def read_policy(path: str | Path) -> Policy:
    """Read the policy file that `plan --out` wrote.

    raises InputFileError: with the line or field
    """
    return policy_from_json(read_json(path), path)


@dataclass(frozen=True, slots=True)
class _Fields:
    """Takes fields of a JSON document, with an error that names the place."""

    path: str | Path

    def wrong(self, place: str, expected: str, got: object) -> InputFileError:
        return InputFileError(
            f"expected {expected}, got {type(got).__name__}", self.path, field=place
        )

    def mapping(self, value: object, place: str) -> dict[str, Any]:
        if not isinstance(value, dict):
            raise self.wrong(place or "(top)", "an object", value)
        return value

    def _take(self, mapping: dict[str, Any], name: str, place: str) -> tuple[Any, str]:
        full = f"{place}.{name}" if place else name
        if name not in mapping:
            raise InputFileError("a field is missing", self.path, field=full)
        return mapping[name], full

    def number(self, mapping: dict[str, Any], name: str, place: str) -> int:
        value, full = self._take(mapping, name, place)
        if not isinstance(value, int) or isinstance(value, bool):
            raise self.wrong(full, "a whole number", value)
        return value

    def sequence(self, mapping: dict[str, Any], name: str, place: str = "") -> list[Any]:
        value, full = self._take(mapping, name, place)
        if not isinstance(value, list):
            raise self.wrong(full, "a list", value)
        return value

    def texts(self, mapping: dict[str, Any], name: str, place: str) -> list[str]:
        values = self.sequence(mapping, name, place)
        for value in values:
            if not isinstance(value, str):
                raise self.wrong(f"{place}.{name}".lstrip("."), "a list of texts", value)
        return [" ".join(value.lower().split()) for value in values]

    def numbers(self, mapping: dict[str, Any], name: str, place: str) -> list[int]:
        values = self.sequence(mapping, name, place)
        for value in values:
            if not isinstance(value, int) or isinstance(value, bool):
                raise self.wrong(f"{place}.{name}".lstrip("."), "a list of whole numbers", value)
        return values


def check_belongs(policy: Policy, problem: Problem, path: str | Path) -> None:
    """Make sure that a policy speaks of this problem; whether it is valid is another question.

    raises InputFileError: with the field that names what the problem does not have
    """
    names = {schema.name: len(schema.parameters) for schema in problem.domain.actions}
    predicates = {name: len(places) for name, places in problem.domain.predicates.items()}
    hint = "is it a policy for another problem?"

    def known(text: str, arities: Mapping[str, int]) -> bool:
        head, *arguments = text.split() or [""]
        return arities.get(head) == len(arguments) and all(a in problem.objects for a in arguments)

    foreign = sorted(atom for atom in policy.static if not known(atom, predicates))
    if foreign:
        raise InputFileError(
            f"the problem has no atom {foreign[0]!r}", path, field="static", hint=hint
        )
    atoms = {atom for node in policy.nodes for atom in node.state}
    foreign = sorted(atom for atom in atoms if not known(atom, predicates))
    for node in policy.nodes:
        place = f"the node {node.id}"
        if node.action is not None and not known(node.action, names):
            raise InputFileError(
                f"the problem has no action {node.action!r}", path, field=place, hint=hint
            )
        for atom in foreign:
            if atom in node.state:
                raise InputFileError(
                    f"the problem has no atom {atom!r}", path, field=place, hint=hint
                )
