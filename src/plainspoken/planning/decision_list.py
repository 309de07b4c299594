"""A policy as a short list of rules: the first one that matches a node says what to do there.

Read off the policy's graph alone: a rule asks for a few facts, true or false, and for a number
that the policy remembers where the state alone does not decide. The list speaks of the nodes of
the policy and of nothing else: in a state that the policy never meets it says nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

from plainspoken.planning.policy import NodeId, Policy, PolicyNode
from plainspoken.world.domain import GroundAction, GroundAtom, State

MOST_SEEDS = 24
"""Rules that are compared before one is chosen."""

Label = TypeVar("Label", bound=Hashable)
Test = tuple[GroundAtom, bool]
"""A fact, and whether it has to be true."""
_MEMORY = "memory "
_BEFORE = "before: "


@dataclass(frozen=True, slots=True)
class ListedRule:
    """What to do in a node that has these facts, and this memory unless it is None.

    action: None where the policy stops, satisfied
    """

    facts: tuple[Test, ...]
    memory: int | None
    action: GroundAction | None

    def matches(self, state: State, memory: int) -> bool:
        return self.memory in (None, memory) and _hold(self.facts, state)


@dataclass(frozen=True, slots=True)
class Remembering:
    """What is remembered after an action, by what was so before it and is so after it."""

    memory: int
    action: GroundAction
    before: tuple[Test, ...]
    after: tuple[Test, ...]
    becomes: int

    def matches(self, memory: int, before: State, action: GroundAction, after: State) -> bool:
        return (
            (self.memory, self.action) == (memory, action)
            and _hold(self.before, before)
            and _hold(self.after, after)
        )


def _hold(tests: Sequence[Test], state: State) -> bool:
    return all((atom in state) == true for atom, true in tests)


@dataclass(frozen=True)
class DecisionList:
    """Rules, the first that matches counts; and how the memory changes, else it stays.

    memory: what is remembered at each node; 0 everywhere if the state always decides
    """

    rules: tuple[ListedRule, ...]
    changes: tuple[Remembering, ...]
    memory: dict[NodeId, int]

    def rule_of(self, node: PolicyNode) -> int:
        """The first rule that matches a node, by its place in the list."""
        return self.chosen(node.state, self.memory[node.id])

    def chosen(self, state: State, memory: int) -> int:
        return next(i for i, rule in enumerate(self.rules) if rule.matches(state, memory))

    def remembered(self, memory: int, before: State, action: GroundAction, after: State) -> int:
        """The memory after an action has led from one state to another."""
        for change in self.changes:
            if change.matches(memory, before, action, after):
                return change.becomes
        return memory


def decision_list(policy: Policy) -> DecisionList:
    """The rules of a policy: each node that can be reached first matches one with its action."""
    nodes = list(_reachable(policy))
    memory = _memories(policy, nodes)
    several = len(set(memory.values())) > 1
    seen: dict[tuple[frozenset[str], int], PolicyNode] = {}
    for node in nodes:
        seen.setdefault((node.state, memory[node.id]), node)
    examples = [
        (state | {f"{_MEMORY}{number}"} if several else state, node.action)
        for (state, number), node in seen.items()
    ]
    rules = []
    for tests, action in _listed(examples, _explaining):
        facts, number = _split(tests)
        rules.append(ListedRule(facts, number, action))
    return DecisionList(tuple(rules), _changes(policy, nodes, memory), memory)


def _reachable(policy: Policy) -> Iterator[PolicyNode]:
    order = [policy.initial]
    seen = set(order)
    for id in order:
        node = policy.node(id)
        yield node
        for successor in node.successors:
            if successor not in seen:
                seen.add(successor)
                order.append(successor)


# -- memory ---------------------------------------------------------------------------------


def _memories(policy: Policy, nodes: Sequence[PolicyNode]) -> dict[NodeId, int]:
    """A number for each node, so that nodes of one state and number do the same for ever.

    Numbers are kept along the edges where they can be, so that they change rarely. Where the
    nodes of each state have one action, all numbers are 0.
    """
    actions: dict[State, set[GroundAction | None]] = {}
    for node in nodes:
        actions.setdefault(node.state, set()).add(node.action)
    if all(len(found) == 1 for found in actions.values()):
        return {node.id: 0 for node in nodes}
    taken: dict[tuple[State, int], NodeId] = {}
    memory: dict[NodeId, int] = {}

    def give(node: PolicyNode, wanted: int) -> None:
        number = wanted
        if (node.state, number) in taken:
            number = next(n for n in range(len(nodes)) if (node.state, n) not in taken)
        taken[node.state, number] = node.id
        memory[node.id] = number

    give(policy.node(policy.initial), 0)
    for node in nodes:
        for id in node.successors:
            if id not in memory:
                give(policy.node(id), memory[node.id])
    return memory


def _changes(
    policy: Policy, nodes: Sequence[PolicyNode], memory: dict[NodeId, int]
) -> tuple[Remembering, ...]:
    """How the memory changes, as a list of rules of its own; what stays comes last, unsaid."""
    if len(set(memory.values())) == 1:
        return ()
    cases: dict[tuple[int, GroundAction], dict[tuple[State, int], None]] = {}
    for node in nodes:
        for id in node.successors:
            if node.action is not None:
                now = _features(policy.node(id).state, node.state)
                cases.setdefault((memory[node.id], node.action), {})[now, memory[id]] = None
    found: list[Remembering] = []
    for (number, action), seen in cases.items():
        if any(becomes != number for _, becomes in seen):
            rows = [
                Remembering(number, action, *_halves(tests), becomes)
                for tests, becomes in _listed(tuple(seen), _latest)
            ]
            while rows[-1].becomes == number:  # It stays so without a word.
                rows.pop()
            found += rows
    return tuple(found)


def _features(after: State, before: State) -> frozenset[str]:
    return after | {f"{_BEFORE}{atom}" for atom in before}


def _halves(tests: Sequence[Test]) -> tuple[tuple[Test, ...], tuple[Test, ...]]:
    """What is asked of the state before an action, and of the one after it."""
    before = ((f.removeprefix(_BEFORE), true) for f, true in tests if f.startswith(_BEFORE))
    return tuple(before), tuple(test for test in tests if not test[0].startswith(_BEFORE))


def _latest(test: Test, label: object) -> int:
    """What is so after an action tells more than what was so before."""
    del label
    return (test[0].startswith(_BEFORE)) * 2 + (not test[1])


# -- lists ----------------------------------------------------------------------------------


def _split(tests: Sequence[Test]) -> tuple[tuple[Test, ...], int | None]:
    facts = tuple(test for test in tests if not test[0].startswith(_MEMORY))
    numbers = [int(fact.removeprefix(_MEMORY)) for fact, _ in tests if fact.startswith(_MEMORY)]
    return facts, numbers[0] if numbers else None


def _explaining(test: Test, action: GroundAction | None) -> int:
    """How well a fact explains an action: best one true of the action's own objects."""
    fact, true = test
    if fact.startswith(_MEMORY):
        return 3
    about = set(fact.split()[1:])
    own = set((action or "").split()[1:])
    return (0 if about and about <= own else 1) + (0 if true else 2)


@dataclass(frozen=True)
class _Table(Generic[Label]):
    """Examples in columns: for each fact, and each label, a mask of the examples that have it."""

    facts: dict[str, int]
    labels: dict[Label, int]
    every: int

    def mask(self, test: Test) -> int:
        fact, true = test
        return self.facts[fact] if true else self.every & ~self.facts[fact]


def _listed(
    examples: Sequence[tuple[frozenset[str], Label]], rank: Callable[[Test, Label], int]
) -> Iterator[tuple[tuple[Test, ...], Label]]:
    """Rules such that the first that matches an example has its label."""
    facts: dict[str, int] = {}
    labels: dict[Label, int] = {}
    for place, (features, label) in enumerate(examples):
        for fact in features:
            facts[fact] = facts.get(fact, 0) | 1 << place
        labels[label] = labels.get(label, 0) | 1 << place
    every = (1 << len(examples)) - 1
    varying = {fact: facts[fact] for fact in sorted(facts) if facts[fact] != every}
    table = _Table(varying, labels, every)
    left = every
    while left:
        best: tuple[tuple[int, int, int], tuple[Test, ...], Label, int] | None = None
        tried = 0
        for number, (label, mask) in enumerate(labels.items()):
            if not left & mask:
                continue
            tried += 1
            if tried > MOST_SEEDS:
                break
            tests, covered = _grown(table, left, label, rank)
            # Many examples for few facts.
            key = (len(tests) * 2 - covered.bit_count(), len(tests), number)
            if best is None or key < best[0]:
                best = key, tests, label, covered
        assert best is not None  # noqa: S101 - something is left, and it has a label
        yield best[1], best[2]
        left &= ~best[3]


def _grown(
    table: _Table[Label], left: int, label: Label, rank: Callable[[Test, Label], int]
) -> tuple[tuple[Test, ...], int]:
    """Tests that single out examples of a label among those left; the mask of these."""
    own = left & table.labels[label]
    seed = own & -own
    covered = left
    tests: list[Test] = []
    possible: list[Test] = [
        (fact, bool(mask & seed))
        for fact, mask in table.facts.items()
        if mask & seed or not fact.startswith(_MEMORY)  # a rule asks for a memory, not for others
    ]
    ranks = {test: rank(test, label) for test in possible}
    while covered & ~own:
        best: tuple[float, int, Test] | None = None
        for test in possible:
            kept = covered & table.mask(test)
            wrong = (kept & ~own).bit_count()
            if wrong < (covered & ~own).bit_count():
                cost = wrong / (kept & own).bit_count(), ranks[test], test
                best = cost if best is None else min(best, cost)
        assert best is not None  # noqa: S101 - examples with the same facts have one label
        tests.append(best[2])
        covered &= table.mask(best[2])
    for test in tuple(tests):
        fewer = [each for each in tests if each != test]
        kept = left
        for each in fewer:
            kept &= table.mask(each)
        if not kept & ~own:
            tests, covered = fewer, kept
    return tuple(sorted(tests, key=lambda test: (ranks[test], test))), covered
