"""What is known of the request after each instant, and what broke it.

A request is broken for good, and that is said in the log at once, where
- a clause of it is: whatever follows, the semantics says that it does not hold;
- its clauses can be met one by one, but no trace meets them together;
- the domain lets nothing follow that meets what is left, not even with luck. That is asked where
  the policy gives no answer, since planning again tells it in passing; a policy that is being
  followed proves by itself that the request can be met.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache

from plainspoken.automata.construction import Automaton, StateId
from plainspoken.automata.verdict import Monitor, Verdict
from plainspoken.logic.syntax import unparse
from plainspoken.mission.mission import Limits, Mission, after, begun
from plainspoken.planning.culprit import contradict, culprits
from plainspoken.world.domain import GroundAction
from plainspoken.world.event import (
    Entry,
    Instant,
    MissionAccepted,
    RequestChanged,
    Stated,
    Step,
    VerdictReached,
)

Clause = str
"""A conjunct of the request, as a formula."""


@dataclass(frozen=True, slots=True)
class Judgement:
    """What is known of the request at an instant.

    step:    the entry since which it is known
    verdict: of the whole
    clauses: each conjunct with its own
    action:  what led to the instant, None where nothing did
    reason:  why the domain lets nothing follow that meets the request, where that is why
    """

    instant: Instant
    step: Step
    verdict: Verdict
    clauses: tuple[tuple[Clause, Verdict], ...]
    action: GroundAction | None = None
    reason: str | None = None

    @property
    def broken(self) -> tuple[Clause, ...]:
        """The clauses that are violated, each by itself."""
        return tuple(clause for clause, verdict in self.clauses if verdict is Verdict.VIOLATED)


def judgements(entries: Iterable[Entry]) -> Iterator[Judgement]:
    """What was known of the request after each instant, and wherever it was changed.

    An instant has several where something that was only assumed turned out to be otherwise.

    raises PlainspokenError: when the entries are no log of a mission
    """
    mission: Mission | None = None
    for entry in entries:
        event = entry.event
        if mission is None:
            if not isinstance(event, MissionAccepted):
                continue
            mission = begun(event, Limits())
            yield _judged(mission, entry.step)
            continue
        before = mission.instant, mission.state
        mission = after(mission, event)
        if isinstance(event, VerdictReached) and event.reason is not None:
            judged = _judged(mission, entry.step)
            yield replace(judged, verdict=Verdict(event.verdict), reason=event.reason)
        elif isinstance(event, RequestChanged) or (
            isinstance(event, Stated) and (mission.instant, mission.state) != before
        ):
            yield _judged(mission, entry.step)


def first_breach(found: Iterable[Judgement]) -> Judgement | None:
    """The judgement with which a request was lost: its instant, and the entry that did it."""
    return next((each for each in found if each.verdict is Verdict.VIOLATED), None)


def broken_parts(monitor: Monitor) -> tuple[Clause, ...]:
    """The clauses of which no trace can meet all any more: one, or several together; else none."""
    for part in monitor.parts:
        if part.verdict is Verdict.VIOLATED:
            return (unparse(part.formula),)
    if monitor.verdict is not Verdict.OPEN:
        return ()
    return _in_conflict(tuple((part.automaton, part.state) for part in monitor.parts))


@lru_cache(maxsize=256)
def _in_conflict(parts: tuple[tuple[Automaton, StateId], ...]) -> tuple[Clause, ...]:
    """A smallest set of clauses that no way to go on meets together.

    None as well where that takes too long to find out: the planner finds out in its own way.
    """

    def clash(chosen: tuple[int, ...]) -> bool | None:
        states = tuple(parts[index][1] for index in chosen)
        automata = tuple(parts[index][0] for index in chosen)
        if all(a.accepts(s) for a, s in zip(automata, states, strict=True)):
            return False
        return contradict(automata, states)

    if not clash(tuple(range(len(parts)))):
        return ()
    return tuple(unparse(parts[index][0].formula) for index in culprits(len(parts), clash).parts)


def reached(mission: Mission) -> VerdictReached | None:
    """What the log is to say of the request now that has become certain, and is not said yet."""
    if mission.settled:
        return None
    if mission.monitor.verdict is Verdict.SATISFIED:
        return VerdictReached(Verdict.SATISFIED)
    match broken(mission):
        case ():
            return None
        case (clause,):
            return VerdictReached(Verdict.VIOLATED, clause)
        case together:
            return VerdictReached(Verdict.VIOLATED, together=together)


def broken(mission: Mission) -> tuple[Clause, ...]:
    """The clauses that cannot all be met any more.

    Where a policy is being followed, it shows that they can be met together.
    """
    if mission.node is not None and mission.monitor.verdict is not Verdict.VIOLATED:
        return ()
    return broken_parts(mission.monitor)


def _judged(mission: Mission, step: Step) -> Judgement:
    monitor = mission.monitor
    verdict = Verdict.VIOLATED if broken_parts(monitor) else monitor.verdict
    clauses = tuple((unparse(part.formula), part.verdict) for part in monitor.parts)
    return Judgement(mission.instant, step, verdict, clauses, mission.led_by)
