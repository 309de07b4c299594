"""What the answerer knows at a step of the log: the trace so far, what is being done, the plan.

Built in one pass over the entries; what only some questions need is worked out when asked for.
"""

from __future__ import annotations

import json
from bisect import bisect_right
from collections.abc import Iterable, Mapping, Sequence
from datetime import UTC, datetime
from functools import cached_property, lru_cache
from typing import Any, NamedTuple

from plainspoken.automata.verdict import Part
from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.facts import Facts, Knowledge, facts_after
from plainspoken.mission.lookout import Lookout
from plainspoken.planning.policy import NodeId, Policy, PolicyNode, policy_from_json
from plainspoken.questions.demand import Demand, demands_of
from plainspoken.questions.identity import ById
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.monitoring import Clauses, Letters, letters_of
from plainspoken.world.domain import GroundAction, GroundAtom, Problem, State
from plainspoken.world.event import (
    ActionFailed,
    ActionFinished,
    ActionOverdue,
    ActionProgressed,
    ActionStarted,
    DeviationNoticed,
    Entry,
    Instant,
    MissionAccepted,
    MissionEnded,
    ObservationMade,
    Paused,
    PolicyChosen,
    ReportReceived,
    RequestChanged,
    Resumed,
    RobotFound,
    RobotLost,
    Stated,
    Step,
    VerdictReached,
)
from plainspoken.world.landmark import Landmarks, landmarks_from_json
from plainspoken.world.pddl import parse_domain, parse_problem
from plainspoken.world.sense import Senses

Run = tuple[Instant, Instant]
"""From and to, both included."""


class Happening(NamedTuple):
    """One action that was carried out.

    at: the instant that it led to; step: the entry that says so
    node: the policy node that chose it; policy: the step of the entry that holds the policy
    """

    action: GroundAction
    at: Instant
    step: Step
    node: NodeId | None
    policy: Step


class _Begun(NamedTuple):
    """An action under way, the entry that says so, and the one that holds the policy."""

    event: ActionStarted
    step: Step
    policy: Step


class Moment:
    """All that is known at one step of one log.

    states:  s0 ... sn; the last one is now
    actions: what led to each instant, None where nothing was done
    steps:   the entry that each instant was observed in
    started: the action in flight that was begun first, None when nothing is
    asked_at: the time by which facts are fresh or stale
    """

    def __init__(
        self, entries: Sequence[Entry], at: Step | None = None, now: datetime | None = None
    ) -> None:
        """Read a log up to and including a step.

        now: when it is asked, with a time zone; None for the time of that step
        raises PlainspokenError: when the log does not begin with an accepted mission
        """
        last = len(entries) if at is None else bisect_right(entries, at, key=_step)
        self.entries = entries[:last]
        if not self.entries or not isinstance(self.entries[0].event, MissionAccepted):
            raise PlainspokenError(
                "the log does not begin with an accepted mission",
                hint="give the whole log, from its first line",
            )
        self.mission: MissionAccepted = self.entries[0].event
        self.asked_at = now or _time_of(self.entries[-1])
        self.states: list[State] = [self.mission.state]
        self.actions: list[GroundAction | None] = [None]
        self.steps: list[Step] = [self.entries[0].step]
        self.happenings: list[Happening] = []
        self._going: dict[str, _Begun] = {}
        self.chosen: PolicyChosen | None = None
        self.chosen_step: Step = 0
        self.node_id: int | None = None
        self.ended: MissionEnded | None = None
        self.paused = False
        self.lost: RobotLost | None = None
        self.certain: tuple[Step, VerdictReached] | None = None
        self.doing: str | None = None
        self.overdue = False
        self._asked: list[tuple[Instant, Clauses]] = [(0, ((0, self.mission.goal),))]
        self._since: dict[GroundAtom, Instant] = {}
        self.failures: list[tuple[Step, ActionFailed]] = []
        self.reports: list[tuple[Step, ReportReceived]] = []
        self.deviations: list[tuple[Step, DeviationNoticed]] = []
        for entry in self.entries:
            # Nearly all entries are of these two kinds, and a log may have 100,000.
            event = entry.event
            if type(event) is ActionStarted:
                if not self._going:
                    self.node_id = event.node
                self._going[event.goal_id] = _Begun(event, entry.step, self.chosen_step)
                self.doing, self.overdue = None, False
            elif type(event) is ActionFinished:
                self._finish(entry, event)
            else:
                self._take(entry)

    def _finish(self, entry: Entry, event: ActionFinished) -> None:
        begun = self._going.pop(event.goal_id, None)
        if entry.instant >= len(self.states):
            chosen_by = begun.event.node if begun else None
            policy = begun.policy if begun else self.chosen_step
            self.happenings.append(
                Happening(event.action, entry.instant, entry.step, chosen_by, policy)
            )
        self._see(entry, event.state, event.action)
        self.node_id = event.node

    def _take(self, entry: Entry) -> None:
        event = entry.event
        match event:
            case ActionFailed():
                self._see(entry, event.state, None)
                self.failures.append((entry.step, event))
                self._going.pop(event.goal_id, None)
            case ObservationMade() | ReportReceived():
                self._see(entry, event.state, None)
                if isinstance(event, ReportReceived):
                    self.reports.append((entry.step, event))
            case PolicyChosen():
                self.chosen, self.chosen_step = event, entry.step
                initial = event.policy.get("initial")
                self.node_id = initial if isinstance(initial, int) else None
            case DeviationNoticed():
                self.deviations.append((entry.step, event))
                self.node_id = event.node if event.node is not None else self.node_id
            case ActionProgressed(doing=doing):
                self.doing = doing
            case ActionOverdue():
                self.overdue = True
            case RobotLost() | RobotFound():
                self.lost = event if isinstance(event, RobotLost) else None
            case RequestChanged(clauses=clauses):
                asked = tuple((int(each["since"]), str(each["goal"])) for each in clauses)
                self._asked.append((entry.instant, asked))
                self.certain = None
            case VerdictReached():
                self.certain = entry.step, event
            case Paused() | Resumed():
                self.paused = isinstance(event, Paused)
            case MissionEnded():
                self.ended = event
                self._going.clear()
            case _:
                pass

    def _see(self, entry: Entry, state: State, action: GroundAction | None) -> None:
        """Note a state: a new instant, or a truer picture of the one that is now."""
        if entry.instant >= len(self.states):
            self.states.append(state)
            self.actions.append(action)
            self.steps.append(entry.step)
            self.node_id = None  # Until an entry says which node of the policy this is.
        else:
            self.states[-1] = state

    # -- now -----------------------------------------------------------------------------------

    @property
    def started(self) -> ActionStarted | None:
        return next((each.event for each in self._going.values()), None)

    @property
    def started_step(self) -> Step:
        return next((each.step for each in self._going.values()), 0)

    @property
    def beside(self) -> tuple[tuple[Step, ActionStarted], ...]:
        """What goes on at the same time as `started`, each with the entry that says so."""
        return tuple((each.step, each.event) for each in self._going.values())[1:]

    @property
    def now(self) -> Instant:
        return len(self.states) - 1

    @property
    def believed(self) -> State:
        """The state that the mission goes by, with what is only assumed in it."""
        return self.states[-1]

    @cached_property
    def state(self) -> State:
        """What is known to be true now."""
        return self.states[-1] - self.unsure if self.unsure else self.states[-1]

    @cached_property
    def facts(self) -> Facts | None:
        """What is known, where anything may not be; None where every fact is known."""
        if not self.mission.unknown and not Senses.of(self.mission):
            return None
        return facts_after(self.entries)

    @cached_property
    def unsure(self) -> frozenset[GroundAtom]:
        """The atoms of which nobody knows now whether they are true."""
        if self.facts is None:
            return frozenset()
        known = self.facts.all_known(self.asked_at)
        return frozenset(each.fact.atom for each in known if each.holds is None)

    def is_unsure(self, atom: GroundAtom) -> bool:
        return self.facts is not None and self.known(atom).holds is None

    def known(self, atom: GroundAtom) -> Knowledge:
        """What can be said of an atom now, and where that comes from."""
        return (self.facts or self._all_facts).known(atom, self.asked_at)

    @cached_property
    def _all_facts(self) -> Facts:
        return facts_after(self.entries)

    @cached_property
    def _known_from(self) -> dict[GroundAtom, Instant]:
        """The instants from which what was unknown at first is known; the last but one is never."""
        if not self.mission.unknown:
            return {}
        found = dict.fromkeys(self.mission.unknown, self.now + 1)
        world, lookout = self.mission.state, Lookout.of(self.mission, self.problem)
        for entry in self.entries[1:]:
            after = lookout.after(entry.event, world, self.static, self.problem)
            for atom in lookout.unknown - after.unknown:
                found[atom] = entry.instant
            lookout = after
            if isinstance(entry.event, Stated):
                world = entry.event.state
        return found

    @cached_property
    def static(self) -> frozenset[GroundAtom]:
        return frozenset(self.mission.static)

    @cached_property
    def fluents(self) -> frozenset[GroundAtom]:
        """What is true now and could be otherwise."""
        return frozenset(filter(self.changes, self.state))

    def changes(self, atom: GroundAtom) -> bool:
        """Whether an atom could ever become true or false; the others go without saying."""
        predicate = atom.split(" ", 1)[0]
        changes = predicate in self.problem.changing_predicates or atom in self.mission.unknown
        return changes and atom not in self.static

    def whole(self, state: State) -> State:
        """A state of the log or of the policy with the atoms that never change."""
        return state | self.static

    @cached_property
    def problem(self) -> Problem:
        return self.lexicon.problem

    @cached_property
    def lexicon(self) -> Lexicon:
        return lexicon_of(self.mission)

    # -- the trace -----------------------------------------------------------------------------

    def since(self, atom: GroundAtom) -> Instant:
        """The first instant of the run of instants up to now at which an atom is as it is now."""
        if atom not in self._since:
            self.look_back([atom])
        return self._since[atom]

    def look_back(self, atoms: Iterable[GroundAtom]) -> None:
        """Find since when some atoms are as they are, in one walk back over the instants."""
        waiting = {atom for atom in atoms if atom not in self._since}
        states, index = self.states, self.now
        while index > 0 and waiting:
            later, earlier = states[index], states[index - 1]
            if later is not earlier:
                for atom in (later ^ earlier) & waiting:
                    self._since[atom] = index
                    waiting.discard(atom)
            index -= 1
        for atom in waiting:
            self._since[atom] = min(self._known_from.get(atom, 0), self.now)

    @cached_property
    def runs(self) -> dict[GroundAtom, list[Run]]:
        """The maximal runs of instants at which each atom is true."""
        found: dict[GroundAtom, list[Run]] = {}
        start = dict.fromkeys(self.states[0], 0)
        before = self.states[0]
        for instant, state in enumerate(self.states):
            if state is not before:
                for atom in before ^ state:
                    if atom in state:
                        start[atom] = instant
                    else:
                        found.setdefault(atom, []).append((start.pop(atom), instant - 1))
                before = state
        for atom, since in start.items():
            found.setdefault(atom, []).append((since, self.now))
        for atom, first in self._known_from.items():
            clipped = [(max(a, first), b) for a, b in found.pop(atom, ()) if b >= first]
            if clipped:
                found[atom] = clipped
        return found

    # -- the plan ------------------------------------------------------------------------------

    @cached_property
    def policy(self) -> Policy | None:
        """The policy that is followed, None before there is one or after the mission's end."""
        if self.chosen is None or self.ended is not None:
            return None
        return self.policy_at(self.chosen_step)

    def policy_at(self, step: Step) -> Policy | None:
        """The policy that an entry of the log holds."""
        index = bisect_right(self.entries, step, key=_step) - 1
        event = self.entries[index].event
        if not isinstance(event, PolicyChosen):
            return None
        # Questions come in numbers about one mission, and a policy may have thousands of nodes.
        return _policy(ById(event.policy))

    @cached_property
    def node(self) -> PolicyNode | None:
        """Where in the policy the mission is; while an action runs, the node that chose it.

        None where the state now is not the node's: a policy says nothing of other states.
        """
        if self.policy is None or self.node_id is None:
            return None
        node = self.policy.by_id.get(self.node_id)
        if node is None or node.state != self.believed - self.policy.static - self.static:
            return None
        return node

    # -- the request ---------------------------------------------------------------------------

    @cached_property
    def letters(self) -> Letters:
        return letters_of(self.problem, self._asked[-1][1])

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """The conjuncts of the request, each with what its automaton has seen so far."""
        return self.parts_at(self.now)

    @cached_property
    def demands(self) -> tuple[Demand, ...]:
        """The parts of the request as a person gave them, each with its verdict."""
        return demands_of(self.parts)

    def demand_of(self, part: Part) -> Demand:
        """The part of the request that a conjunct belongs to."""
        own = part.formula
        return next(d for d in self.demands if own in [each.formula for each in d.parts])

    def parts_at(self, instant: Instant) -> tuple[Part, ...]:
        """The conjuncts of the request as they were at an instant."""
        upto = instant + 1
        letters = self.letters if instant == self.now else self._letters_at(instant)
        return letters.parts_after(self.states[:upto], self.actions[:upto])

    def _letters_at(self, instant: Instant) -> Letters:
        """What was asked for at an instant: a request may change, and the past stays as it was."""
        clauses = next(each for since, each in reversed(self._asked) if since <= instant)
        return letters_of(self.problem, clauses)

    def after(
        self, parts: tuple[Part, ...], state: State, action: GroundAction
    ) -> tuple[Part, ...]:
        """The conjuncts after one more instant, imagined."""
        seen = self.letters.read(state, action)
        return tuple(
            Part(part.formula, part.automaton, part.automaton.step(part.state, seen))
            for part in parts
        )


@lru_cache(maxsize=16)
def _policy(key: ById[Mapping[str, Any]]) -> Policy:
    return policy_from_json(key.value, "policy of the log")


def _step(entry: Entry) -> Step:
    return entry.step


def _time_of(entry: Entry) -> datetime:
    """When an entry was written; a log that no clock dates is of the beginning of time."""
    try:
        time = datetime.fromisoformat(entry.time)
    except ValueError:
        return datetime.min.replace(tzinfo=UTC)
    return time if time.tzinfo is not None else time.replace(tzinfo=UTC)


def lexicon_of(mission: MissionAccepted) -> Lexicon:
    """The words of a mission; kept, as many questions are asked about one."""
    document = json.dumps(mission.landmarks, sort_keys=True) if mission.landmarks else ""
    return _lexicon(mission.domain, mission.problem, document)


@lru_cache(maxsize=8)
def _problem(domain: str, problem: str) -> Problem:
    known = parse_domain(domain, "domain of the log")
    return parse_problem(problem, known, "problem of the log")


@lru_cache(maxsize=8)
def _lexicon(domain: str, problem: str, landmarks: str) -> Lexicon:
    known: Landmarks = {}
    if landmarks:
        known = landmarks_from_json(json.loads(landmarks), "landmarks of the log")
    return Lexicon(_problem(domain, problem), known)
