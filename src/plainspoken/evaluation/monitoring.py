"""The paper's experiment on monitoring: a question falls while a plan runs, and is scored.

source: section "Evaluating Process Monitoring" and "Process Monitoring" under "Experiments". A
determinised policy is carried out; after each action a question is asked with a probability that
grows until it is certain; the fluents of the answer are compared with those of the states. The
paper's metric compares one set of fluents with every state of the past or the future; the
time-indexed one compares at each instant what is claimed for that instant.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from random import Random
from typing import Any

from plainspoken.pipeline import Site
from plainspoken.planning.policy import Policy, PolicyNode
from plainspoken.questions.answer import answer_at
from plainspoken.questions.claim import Answer
from plainspoken.questions.fluents import Fluent, Time, fluents_in
from plainspoken.questions.length import Length
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.moment import Moment
from plainspoken.world.domain import GroundAtom, State
from plainspoken.world.event import (
    ActionFinished,
    ActionStarted,
    Entry,
    Event,
    Instant,
    MissionAccepted,
    PolicyChosen,
)
from plainspoken.world.landmark import landmarks_to_json

RUNS = 30
"""Experiments of a category, as in the paper."""


class Category(StrEnum):
    """The part of the plan's execution that a question is about."""

    PRESENT = "present"
    PAST = "past"
    FUTURE = "future"


# The paper has six forms for each category and prints one of them, the first here; five more are
# ours in its manner, and six are put as people put them.
QUESTIONS: Mapping[Category, tuple[str, ...]] = {
    Category.PRESENT: (
        "What are you doing now?",
        "What is your current activity?",
        "What are you doing at the moment?",
        "What is the current situation?",
        "What action are you performing right now?",
        "Can you describe what you are doing?",
        "What are you up to?",
        "What's going on?",
        "What's happening at the minute?",
        "Tell me what you're busy with.",
        "Which step are you on?",
        "How do things stand right now?",
    ),
    Category.PAST: (
        "What did you do so far?",
        "What have you done?",
        "Which actions have you carried out until now?",
        "What has happened so far?",
        "Can you tell me what you did?",
        "What did you do before now?",
        "Fill me in on what you did.",
        "Give me a quick summary of what you did.",
        "What have you been up to?",
        "What have you got done?",
        "Walk me through what has happened.",
        "What did I miss?",
    ),
    Category.FUTURE: (
        "What are you going to do next?",
        "What will you do from now on?",
        "What is your plan?",
        "Which actions are you going to carry out?",
        "What will you do until you finish?",
        "Can you tell me your next steps?",
        "What's next?",
        "What's still ahead of you?",
        "How will you go on?",
        "Talk me through the rest of your plan.",
        "What's on your list?",
        "And what comes now?",
    ),
}


@dataclass(frozen=True, slots=True)
class Situation:
    """One experiment before it is answered: a plan under way, and the question that fell.

    states: s0 ... sT of the plan, without what never changes
    at:     the instant t of the question
    """

    id: str
    domain: str
    category: Category
    full: bool
    question: str
    at: Instant
    states: tuple[State, ...]
    static: State
    entries: tuple[Entry, ...]

    @property
    def instants(self) -> range:
        """The instants that the category's equation sums over."""
        match self.category:
            case Category.PRESENT:
                return range(self.at, self.at + 1)
            case Category.PAST:
                return range(1, self.at + 1)
            case Category.FUTURE:
                return range(self.at, len(self.states))


Predicted = Mapping[Instant, frozenset[GroundAtom]]
"""The fluents that an answer gives for each instant."""


@dataclass(frozen=True, slots=True)
class Run:
    """One experiment: what was said, and which fluents that gives."""

    situation: Situation
    text: str
    predicted: Predicted
    seconds: float | None = None

    @property
    def said(self) -> frozenset[GroundAtom]:
        """All fluents of the answer, whatever instant they are said of: the paper's set."""
        return frozenset().union(*self.predicted.values())


# -- situations --------------------------------------------------------------------------------


def determinised(policy: Policy, chance: Random) -> Policy:
    """The policy as a plan: at each node one of the possible outcomes, until it stops.

    Where an outcome leads back to where the plan has been, it would never end; then one is taken
    that lies nearer to a stop.
    """
    nearness = _distances(policy)
    path = [policy.node(policy.initial)]
    seen = {path[0].id}
    while path[-1].successors:
        node = path[-1]
        after = chance.choice(node.successors)
        if after in seen:
            after = min(node.successors, key=lambda id: (nearness[id], id))
        seen.add(after)
        path.append(policy.node(after))
    nodes = tuple(
        PolicyNode(number, node.state, node.action, (number + 1,) if node.action else ())
        for number, node in enumerate(path)
    )
    return Policy(policy.kind, policy.goal, 0, policy.static, nodes)


def _distances(policy: Policy) -> Mapping[int, int]:
    """How many actions each node is from a stop, with luck."""
    before: dict[int, list[int]] = {}
    for node, successor in policy.edges():
        before.setdefault(successor.id, []).append(node.id)
    layer = [node.id for node in policy.nodes if node.action is None]
    found = dict.fromkeys(layer, 0)
    while layer:
        layer = [id for after in layer for id in before.get(after, []) if id not in found]
        found.update({id: found[after] + 1 for id in layer for after in _after(policy, id, found)})
        layer = list(dict.fromkeys(layer))
    return found


def _after(policy: Policy, id: int, found: Mapping[int, int]) -> list[int]:
    known = [each for each in policy.node(id).successors if each in found]
    return [min(known, key=lambda each: found[each])]


def falls_at(last: Instant, chance: Random) -> Instant:
    """The instant at which the question falls: after action k of T with probability k / (T - 1)."""
    for instant in range(1, last):
        if chance.random() < instant / (last - 1):
            return instant
    return max(last - 1, 0)


def situations(
    domain: str, site: Site, policy: Policy, *, runs: int, seed: int
) -> Iterator[Situation]:
    """The experiments of a domain: so many for each category, answered briefly and in full."""
    static = frozenset(policy.static)
    for category in Category:
        for number in range(runs):
            chance = Random(f"{seed} {domain} {category} {number}")
            plan = determinised(policy, chance)
            at = falls_at(len(plan.nodes) - 1, chance)
            question = chance.choice(QUESTIONS[category])
            entries = tuple(_entries(site, plan, at))
            for full in (False, True):
                yield Situation(
                    f"{domain}-{category}-{number:02d}-{'full' if full else 'brief'}",
                    domain,
                    category,
                    full,
                    question,
                    at,
                    tuple(node.state - static for node in plan.nodes),
                    static,
                    entries,
                )


def _entries(site: Site, plan: Policy, at: Instant) -> Iterator[Entry]:
    """The log of a plan up to an instant, the action after it just begun."""
    documents = landmarks_to_json(site.landmarks)
    accepted = MissionAccepted(
        "m", None, plan.goal, "", site.domain_text, site.problem_text, documents,
        tuple(sorted(plan.static)), plan.nodes[0].state - plan.static, {},
    )  # fmt: skip
    events: list[tuple[Instant, Event]] = [(0, accepted), (0, PolicyChosen(plan.to_json()))]
    for node in plan.nodes[: at + 1]:
        action = node.action or ""
        events.append((node.id, ActionStarted(action, node.id, f"goal-{node.id}")))
        if node.id < at:
            after = plan.nodes[node.id + 1]
            done = ActionFinished(action, f"goal-{node.id}", after.state - plan.static, after.id)
            events.append((after.id, done))
    for step, (instant, event) in enumerate(events):
        yield Entry(step, "", instant, event)


# -- answers -----------------------------------------------------------------------------------

Tell = Callable[[Situation], str]
"""Whoever answers in words: a model, or the replies of a batch."""


def answered(situation: Situation, clock: Callable[[], float]) -> Run:
    """A run with our own answer and its claims."""
    moment = Moment(situation.entries)
    began = clock()
    length = Length.FULL if situation.full else Length.BRIEF
    found = answer_at(situation.question, moment, length=length)
    return Run(situation, found.text, _claimed(found, situation), clock() - began)


Reader = Callable[[str, Lexicon], Sequence[Fluent]]
"""Whoever reads fluents in a text: the embedded reader, or a model."""


def read_back(
    situation: Situation, text: str, lexicon: Lexicon, reader: Reader = fluents_in
) -> Run:
    """A run with the fluents that a text states, by the extractor.

    What is said of a span without an instant counts wherever in the span it is so, or, where it
    never is, once: as a hallucination at the instant nearest to the question.
    """
    found: dict[Instant, set[GroundAtom]] = {}
    last = len(situation.states) - 1
    for fluent in reader(text, lexicon):
        if not fluent.holds:
            continue  # The metric knows only what is so.
        span = [i for i in fluent.instants(situation.at, last) if 0 <= i <= last]
        exact = fluent.offset is not None or fluent.time in (Time.NOW, Time.START, Time.END)
        so = [i for i in span if fluent.atom in situation.states[i] | situation.static]
        nearest = sorted(span, key=lambda i: abs(i - situation.at))[:1]
        for instant in span if exact else so or nearest:
            found.setdefault(instant, set()).add(fluent.atom)
    predicted = {i: frozenset(found[i]) for i in situation.instants if i in found}
    return Run(situation, text, predicted)


def _claimed(answer: Answer, situation: Situation) -> Predicted:
    instants = situation.instants
    found: dict[Instant, set[GroundAtom]] = {}
    for claim in answer.claims:
        for instant in range(max(claim.start, instants.start), min(claim.end + 1, instants.stop)):
            found.setdefault(instant, set()).add(claim.fluent)
    return {instant: frozenset(found[instant]) for instant in sorted(found)}


# -- scores ------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Score:
    """The paper's S and C of one run; None where an answer gives no fluents to be sound."""

    soundness: float | None
    completeness: float


def score(run: Run, *, timed: bool, static: bool) -> Score:
    """The score of a run.

    timed:  a fluent counts at the instants it is claimed for; else at every one, as in the paper
    static: whether what never changes counts among the fluents of a state
    """
    situation = run.situation
    ever = situation.static if static else frozenset()
    sound: list[float] = []
    complete: list[float] = []
    for instant in situation.instants:
        said = run.predicted.get(instant, frozenset()) if timed else run.said
        said = said if static else said - situation.static
        true = situation.states[instant] | ever
        if said:
            sound.append(len(said & true) / len(said))
        if true:
            complete.append(len(said & true) / len(true))
    mean = sum(complete) / len(complete) if complete else 0.0
    return Score(sum(sound) / len(sound) if sound else None, mean)


@dataclass(frozen=True, slots=True)
class Tally:
    """Fluents at one distance from now: correct, hallucinated and missing."""

    correct: int = 0
    hallucinated: int = 0
    missing: int = 0

    def __add__(self, other: Tally) -> Tally:
        return Tally(
            self.correct + other.correct,
            self.hallucinated + other.hallucinated,
            self.missing + other.missing,
        )


def by_distance(runs: Sequence[Run], *, timed: bool) -> Mapping[int, Tally]:
    """The paper's histogram: what is said of each distance from the question."""
    found: dict[int, Tally] = {}
    for run in runs:
        for instant in run.situation.instants:
            true = run.situation.states[instant]
            said = run.predicted.get(instant, frozenset()) if timed else run.said
            said -= run.situation.static
            tally = Tally(len(said & true), len(said - true), len(true - said))
            distance = abs(instant - run.situation.at)
            found[distance] = found.get(distance, Tally()) + tally
    return dict(sorted(found.items()))


def run_to_json(run: Run) -> dict[str, Any]:
    """A line of the file of runs: all that its scores need."""
    situation = run.situation
    return {
        "id": situation.id,
        "domain": situation.domain,
        "category": str(situation.category),
        "full": situation.full,
        "question": situation.question,
        "at": situation.at,
        "answer": run.text,
        "predicted": {str(i): sorted(said) for i, said in run.predicted.items()},
        "states": [sorted(state) for state in situation.states],
        "static": sorted(situation.static),
        "seconds": run.seconds,
    }
