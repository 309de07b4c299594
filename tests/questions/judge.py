"""An outside judge of answers: reads the JSON of an answer, the log and the policy, nothing else.

It shares no code with `plainspoken.questions`: states are read off the entries, futures are sets
of policy nodes, one set for each number of actions from now.
"""

from collections.abc import Sequence
from typing import Any

from plainspoken.world.event import (
    ActionFailed,
    ActionFinished,
    ActionStarted,
    Entry,
    MissionAccepted,
    ObservationMade,
    PolicyChosen,
    ReportReceived,
)

Failure = str


class Judge:
    """The truth at one step of a log."""

    def __init__(self, entries: Sequence[Entry], at: int) -> None:
        self.states: dict[int, frozenset[str]] = {}
        self.done: dict[int, str] = {}
        self.policy: dict[int, Any] = {}
        self.node: int | None = None
        self.static: frozenset[str] = frozenset()
        for entry in entries:
            if entry.step <= at:
                self._read(entry)
        self.now = max(self.states)

    def _read(self, entry: Entry) -> None:
        event = entry.event
        if isinstance(event, MissionAccepted):
            self.static = frozenset(event.static)
        if isinstance(
            event,
            MissionAccepted | ActionFinished | ActionFailed | ObservationMade | ReportReceived,
        ):
            self.states[entry.instant] = event.state | self.static
        if isinstance(event, ActionFinished):
            self.done[entry.instant] = event.action
            self.node = event.node
        if isinstance(event, ActionStarted):
            self.node = event.node
        if isinstance(event, PolicyChosen):
            self.policy = {node["id"]: node for node in event.policy["nodes"]}
            self.node = event.policy["initial"]

    def layers(self, most: int) -> list[set[int]]:
        """The policy nodes that executions still under way can be at in 0, 1 ... actions."""
        assert self.node is not None
        found = [{self.node}]
        while len(found) <= most:
            found.append({s for id in found[-1] for s in self.policy[id]["successors"]})
        return found

    def _true(self, id: int, atom: str) -> bool:
        return atom in self.policy[id]["state"] or atom in self.static

    def failures(self, answer: dict[str, Any]) -> list[Failure]:
        """The claims of an answer that are not so."""
        found = [f"{c}" for c in answer["claims"] if not self._claim_holds(c)]
        for denied in answer["denied"]:
            span = range(denied["from"], denied["to"] + 1)
            if any(denied["fluent"] in self.states[i] for i in span) or not span:
                found.append(f"denied {denied}")
        found += [f"{c}" for c in answer["actions"] if not self._action_holds(c)]
        return found

    def _claim_holds(self, claim: dict[str, Any]) -> bool:
        atom, start, end = claim["fluent"], claim["from"], claim["to"]
        if start > end:
            return False
        if claim["certainty"] in ("is", "was"):
            if end > self.now or (claim["certainty"] == "is") != (end == self.now):
                return False
            return all(atom in self.states[i] for i in range(start, end + 1))
        if start <= self.now:
            return False
        layers = self.layers(end - self.now)
        if claim["certainty"] == "will":
            spans = range(start - self.now, end - self.now + 1)
            stopped = any(
                not self.policy[id]["successors"]
                for layer in layers[: end - self.now]
                for id in layer
            )
            return not stopped and all(self._true(id, atom) for k in spans for id in layers[k])
        alive = {id for id in layers[start - self.now] if self._true(id, atom)}
        for _ in range(start, end):
            alive = {
                s for id in alive for s in self.policy[id]["successors"] if self._true(s, atom)
            }
        return bool(alive)

    def _action_holds(self, claim: dict[str, Any]) -> bool:
        action, at = claim["action"], claim["at"]
        if claim["certainty"] == "was":
            return self.done.get(at) == action
        if at <= self.now:
            return False
        layers = self.layers(at - self.now - 1)
        actions = {self.policy[id]["action"] for id in layers[-1]}
        if claim["certainty"] == "will":
            stopped = any(not self.policy[id]["successors"] for layer in layers for id in layer)
            return not stopped and actions == {action}
        return action in actions
