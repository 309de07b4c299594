"""An activity as a behaviour tree of `py_trees`: ticked, it makes the calls and watches them.

Every node has a name of its own within the goal and a count of how often it was begun: `0.1#2` is
the second part of the first part, the second time. The journal keeps what became of each, so that
a tree that is built anew after a crash comes to where the old one was.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, assert_never

from py_trees import composites, decorators
from py_trees.behaviour import Behaviour
from py_trees.common import ParallelPolicy, Status

from plainspoken.backends.activities.journal import Journal
from plainspoken.mission.activity import (
    Activity,
    Call,
    Condition,
    Parallel,
    Retry,
    Selection,
    Sequence,
    Within,
)
from plainspoken.mission.mission import GoalId
from plainspoken.mission.repertoire import Offer
from plainspoken.mission.robot import Seconds, Unheard, Unreachable
from plainspoken.mission.service import CallId, Done, Going, NotDone, Service
from plainspoken.mission.template import Table, UnfilledError, filled, meets
from plainspoken.world.domain import State

CANCELLED = "cancelled"
TOLD_EVERY: Seconds = 1.0
"""How often what a service says of itself is told anew: each time is an event in the log."""


@dataclass
class Stage:
    """What the nodes of one goal's tree share.

    arguments: those of the action, by name, and `action` and `goal`
    results:   of the calls that are done, by service; last: of the one done last
    reason:    of the failure that was the last one
    lost:      why something could not be reached in this tick; missing: the services that were not
    ending:    calls that were told to be given up, until they are
    stopping:  the whole goal is to be given up: nothing more is begun
    """

    goal: GoalId
    arguments: Mapping[str, str]
    services: Mapping[str, Service]
    offers: Mapping[str, Offer]
    objects: Table
    journal: Journal
    clock: Callable[[], Seconds]
    scene: Callable[[], State]
    results: dict[str, Any] = field(default_factory=dict)
    last: Mapping[str, Any] = field(default_factory=dict)
    reason: str = "its activity failed"
    lost: Unreachable | None = None
    missing: list[Service] = field(default_factory=list)
    stopping: bool = False
    ending: dict[CallId, Service] = field(default_factory=dict)
    counts: dict[str, int] = field(default_factory=dict)

    def begun(self, node: str) -> str:
        """The name of a node for this time."""
        self.counts[node] = self.counts.get(node, 0) + 1
        return f"{self.goal}:{node}#{self.counts[node]}"

    def loses(self, service: Service, error: Unreachable) -> None:
        self.lost = error
        self.missing.append(service)

    def fails(self, reason: str) -> Status:
        self.reason = reason
        return Status.FAILURE


def planted(activity: Activity, stage: Stage, node: str = "0") -> Behaviour:
    """The tree of an activity."""

    def parts(activities: tuple[Activity, ...]) -> list[Behaviour]:
        return [planted(part, stage, f"{node}.{i}") for i, part in enumerate(activities)]

    match activity:
        case Call():
            return CallNode(activity, stage, node)
        case Condition():
            return ConditionNode(activity, stage, node)
        case Sequence(of):
            return composites.Sequence(node, memory=True, children=parts(of))
        case Selection(of):
            return composites.Selector(node, memory=True, children=parts(of))
        case Parallel(of, one):
            policy = ParallelPolicy.SuccessOnOne() if one else ParallelPolicy.SuccessOnAll()
            return composites.Parallel(node, policy, parts(of))
        case Retry(part):
            return RetryNode(activity, planted(part, stage, f"{node}.0"), stage, node)
        case Within(part):
            return WithinNode(activity, planted(part, stage, f"{node}.0"), stage, node)
        case _:
            assert_never(activity)


class CallNode(Behaviour):
    """Makes a call once, and succeeds or fails as it does."""

    def __init__(self, call: Call, stage: Stage, node: str) -> None:
        super().__init__(node)
        self._call, self._stage, self._node = call, stage, node
        self._service = stage.services[call.service]
        self._offer = stage.offers[call.service]
        self._id: CallId = ""
        self._begun = self._told_to_stop = False
        self._told: Any = None
        self._told_at: Seconds = 0.0
        self.feedback: Mapping[str, Any] = {}

    def initialise(self) -> None:
        self._id = self._stage.begun(self._node)
        self._begun = self._note("called") is not None
        self._told_to_stop = False
        self._told = None
        self.feedback = {}

    def update(self) -> Status:
        ended = self._note("ended")
        if ended is not None:
            # A call that was given up in an earlier life is given up again, by the same node.
            return Status.RUNNING if ended == "given up" else self._settled(ended)
        if self._stage.stopping and self._note("called") is None:
            return self._stage.fails(CANCELLED)
        try:
            if self._stage.stopping and not self._told_to_stop:
                self._service.cancel(self._id)
                self._told_to_stop = True
            elif not self._begun:
                fields = self._filled(self._call.fields)
                self._journal("called", value=True)
                self._service.begin(self._id, fields)
                self._begun = True
            status = self._service.status(self._id)
        except Unreachable as error:
            self._stage.loses(self._service, error)
            return Status.RUNNING
        except UnfilledError as error:
            return self._stage.fails(f"{self._call.service} cannot be called: {error.what}")
        match status:
            case Going(feedback, heard):
                self.feedback = feedback
                if heard and self._note("heard") is None:
                    self._journal("heard", value=True)
                return Status.RUNNING
            case Done(result):
                return self._end(self._judged(result))
            case NotDone(reason):
                return self._end({"failed": CANCELLED if self._told_to_stop else reason})
            case Unheard():
                if self._note("heard") is not None:
                    return self._end({"failed": f"{self._call.service} has forgotten the call"})
                self._begun = False
                return self._stage.fails(CANCELLED) if self._told_to_stop else Status.RUNNING
            case _:
                assert_never(status)

    def terminate(self, new_status: Status) -> None:
        """Have a call given up that others make needless, or that takes too long."""
        if new_status is not Status.INVALID or self.status is not Status.RUNNING:
            return
        if self._note("ended") is not None or self._note("called") is None:
            return
        self._stage.ending[self._id] = self._service
        try:
            self._service.cancel(self._id)
        except Unreachable as error:
            self._stage.loses(self._service, error)

    @property
    def words(self) -> str | None:
        """What the call is, in words; None where nobody gave any."""
        try:
            words = self._filled(self._call.words)
        except UnfilledError:
            words = None  # it speaks of a result that an earlier call did not give
        now = self._stage.clock()
        if self._told is None or now - self._told_at >= TOLD_EVERY:
            self._told, self._told_at = self._read(self._offer.doing), now
        told = self._told
        return ": ".join(str(each) for each in (words, told) if each) or None

    @property
    def progress(self) -> float | None:
        """How far the call is, where its feedback says so."""
        found = self._read(self._offer.progress)
        try:
            return None if found is None else min(max(float(found), 0.0), 1.0)
        except (TypeError, ValueError):
            return None

    def _filled(self, template: Any) -> Any:
        """A template over the arguments and, by service, the results of calls before this one."""
        values = {**self._stage.results, **self._stage.arguments}
        return filled(template, values, self._stage.objects)

    def _read(self, template: str) -> Any:
        try:
            return filled(template, self.feedback)
        except UnfilledError:
            return None  # nothing was told yet

    def _judged(self, result: Mapping[str, Any]) -> dict[str, Any]:
        """What a call that came to its end comes to: a result may say that nothing was done."""
        if meets(result, self._offer.succeeds) and meets(result, self._call.expected):
            return {"done": dict(result)}
        try:
            reason = filled(self._offer.reason, result)
        except UnfilledError:
            reason = None
        return {"failed": str(reason or f"{self._call.service} gave {dict(result)}")}

    def _end(self, ended: Mapping[str, Any]) -> Status:
        self._journal("ended", ended)
        return self._settled(ended)

    def _settled(self, ended: Mapping[str, Any]) -> Status:
        if "failed" in ended:
            return self._stage.fails(ended["failed"])
        self._stage.last = ended["done"]
        self._stage.results[self._call.service] = ended["done"]
        return Status.SUCCESS

    def _note(self, key: str) -> Any:
        return self._stage.journal.get(self._id, key)

    def _journal(self, key: str, value: Any) -> None:
        self._stage.journal.note(self._id, key, value)


class ConditionNode(Behaviour):
    """Looks once whether facts hold, and keeps to what it saw."""

    def __init__(self, condition: Condition, stage: Stage, node: str) -> None:
        super().__init__(node)
        self._facts = [fact.bound(stage.arguments) for fact in condition.facts]
        self._stage, self._node = stage, node
        self._id = ""

    def initialise(self) -> None:
        self._id = self._stage.begun(self._node)

    def update(self) -> Status:
        if self._stage.stopping:
            return self._stage.fails(CANCELLED)
        broken = self._stage.journal.get(self._id, "broken")
        if broken is None:
            try:
                state = self._stage.scene()
            except Unreachable as error:
                self._stage.lost = error
                return Status.RUNNING
            broken = [str(fact) for fact in self._facts if not fact.holds_in(state)]
            self._stage.journal.note(self._id, "broken", broken)
        return self._stage.fails(f"not so: {', '.join(broken)}") if broken else Status.SUCCESS


class RetryNode(decorators.Decorator):
    """Begins its part anew after a failure, until it was begun often enough."""

    def __init__(self, retry: Retry, child: Behaviour, stage: Stage, node: str) -> None:
        super().__init__(node, child)
        self.retry, self._stage = retry, stage
        self.failures = 0
        self._again_at: Seconds = 0.0

    def initialise(self) -> None:
        self.failures, self._again_at = 0, 0.0

    def tick(self) -> Any:
        """Tick the part, unless it has a pause."""
        if self.status is Status.RUNNING and self._stage.clock() < self._again_at:
            if self._stage.stopping:
                self.stop(self._stage.fails(CANCELLED))
            yield self
            return
        yield from super().tick()

    def update(self) -> Status:
        if self.decorated.status is not Status.FAILURE:
            return Status(self.decorated.status)
        self.failures += 1
        if self.failures >= self.retry.times or self._stage.stopping:
            return Status.FAILURE
        self._again_at = self._stage.clock() + self.retry.pause_after(self.failures)
        return Status.RUNNING


class WithinNode(decorators.Decorator):
    """Gives its part up when it takes too long; counts anew after a restart of the program."""

    def __init__(self, within: Within, child: Behaviour, stage: Stage, node: str) -> None:
        super().__init__(node, child)
        self._within, self._stage, self._node = within, stage, node
        self._id = ""
        self._until: Seconds = 0.0

    def initialise(self) -> None:
        self._id = self._stage.begun(self._node)
        self._until = self._stage.clock() + self._within.seconds

    def update(self) -> Status:
        if self.decorated.status is not Status.RUNNING:
            return Status(self.decorated.status)
        late = self._stage.journal.get(self._id, "late") is not None
        if not late and self._stage.clock() < self._until:
            return Status.RUNNING
        if not late:
            self._stage.journal.note(self._id, "late", value=True)
        # `Decorator.stop` stops the part that is still running.
        return self._stage.fails(f"took longer than {self._within.seconds:g} s")


def doing(tree: Behaviour) -> str | None:
    """What goes on in a tree, in words: `step 2 of 3: driving to l1`; None where there are none."""
    if tree.status is not Status.RUNNING:
        return None
    match tree:
        case CallNode():
            return tree.words
        case composites.Parallel():
            return " and ".join(filter(None, map(doing, tree.children))) or None
        case composites.Composite():
            current = tree.current_child
            inner = None if current is None else doing(current)
            if current is None or len(tree.children) == 1:
                return inner
            kind = "way" if isinstance(tree, composites.Selector) else "step"
            place = f"{kind} {tree.children.index(current) + 1} of {len(tree.children)}"
            return place if inner is None else f"{place}: {inner}"
        case RetryNode(failures=failures) if failures:
            inner = doing(tree.decorated)
            attempt = f"try {failures + 1} of {tree.retry.times}"
            return attempt if inner is None else f"{attempt}: {inner}"
        case decorators.Decorator():
            return doing(tree.decorated)
        case _:
            return None


def progress(tree: Behaviour) -> float | None:
    """How far a tree is, from 0 to 1; None where nothing in it says so."""
    if tree.status is Status.SUCCESS:
        return 1.0
    match tree:
        case CallNode():
            return tree.progress
        case composites.Selector():
            return None if tree.current_child is None else progress(tree.current_child)
        case composites.Composite():
            shares = [progress(child) for child in tree.children]
            if len(shares) == 1:
                return shares[0]
            return sum(share or 0.0 for share in shares) / len(shares)
        case decorators.Decorator():
            return progress(tree.decorated)
        case _:
            return None
