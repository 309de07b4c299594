"""What is known: the fold of a log to facts, each with where it comes from, and to the trace.

    facts = facts_after(entries)
    known = facts.known("full b", now)      # at a time: facts go stale
    known.holds                             # True, False, or None where nobody knows
    known.fact.source, known.fact.by        # how it came to be known, and from whom
    known.step                              # the entry that says so

What nobody ever said is false, as in PDDL, unless the problem or the robots' file says that it is
unknown at first.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from datetime import datetime
from enum import StrEnum
from typing import Any

from plainspoken.errors import PlainspokenError
from plainspoken.logic.trace import Letter
from plainspoken.world.domain import GroundAction, GroundAtom, Problem, State
from plainspoken.world.event import (
    ActionFailed,
    ActionFinished,
    Entry,
    Instant,
    MissionAccepted,
    ObservationMade,
    ReportReceived,
    Stated,
    Step,
)
from plainspoken.world.pddl import parse_domain, parse_problem
from plainspoken.world.scene import settled_by
from plainspoken.world.sense import Senses, told_by
from plainspoken.world.symbol import Symbol, letter


class Source(StrEnum):
    """How it came to be known that an atom is true, or false."""

    INITIAL = "initial"
    """The problem says so, or says nothing of it."""
    ACTION = "action"
    OBSERVATION = "observation"
    REPORT = "report"


@dataclass(frozen=True, slots=True)
class Fact:
    """A ground atom that is true, false or not known (None), since when, and what says so.

    step, instant, time: of the entry since which it has been so without a break
    by: the action, the service or the person that it is known from, where one is named
    """

    atom: GroundAtom
    holds: bool | None
    source: Source
    step: Step
    instant: Instant
    time: str
    by: str | None = None


@dataclass(frozen=True, slots=True)
class Knowledge:
    """What can be said of an atom at a time.

    holds:  None where nobody knows, or it was seen too long ago: it has to be looked at first
    fact:   what was known last
    seen:   when that was last seen to be so, ISO 8601; step: the entry that says so
    vain:   the entry of a later look that could tell nothing, None where there is none
    """

    holds: bool | None
    fact: Fact
    seen: str
    step: Step = 0
    vain: Step | None = None

    @property
    def is_stale(self) -> bool:
        """Whether it was known once, and is not any more."""
        return self.holds is None and self.fact.holds is not None

    def to_json(self) -> dict[str, Any]:
        """An item of `missions facts --json`."""
        fact = self.fact
        return {
            "atom": fact.atom,
            "holds": self.holds,
            "last": fact.holds,
            "source": str(fact.source),
            "by": fact.by,
            "since": fact.time,
            "since_step": fact.step,
            "seen": self.seen or None,
            "seen_step": self.step,
            "looked_in_vain": self.vain,
        }


@dataclass(frozen=True, slots=True)
class Moment:
    """One instant of the trace.

    state:  without the static atoms (`Facts.static`)
    action: what led to it; None at s0, and where something changed with no action
    step:   the entry with which it began
    """

    instant: Instant
    state: State
    action: GroundAction | None
    step: Step
    time: str


@dataclass(frozen=True)
class Facts:
    """All that is known after some entries.

    changed: the facts about atoms that were ever true, or unknown, static ones included
    static:  the true atoms that no action changes
    trace:   instants s0 ... sn, sn the current one; their states have what is assumed of atoms
             that are not known
    seen:    when the world was looked at last: every event with a state is such a look;
             looked: its step
    senses:  how facts come to be known, and for how long
    single:  the last entries that told of facts that a look at the world in general does not show
    vain:    the last looks that could not tell
    """

    changed: Mapping[GroundAtom, Fact]
    static: State
    trace: tuple[Moment, ...]
    seen: str = ""
    looked: Step = 0
    senses: Senses = field(default_factory=Senses)
    single: Mapping[GroundAtom, tuple[Step, str]] = field(default_factory=dict)
    vain: Mapping[GroundAtom, Step] = field(default_factory=dict)

    @property
    def state(self) -> State:
        """What is true now, or assumed to be, static atoms included."""
        return self.trace[-1].state | self.static

    def fact(self, atom: GroundAtom) -> Fact:
        """What is known of an atom; one that was never true has been false since s0."""
        start = self.trace[0]
        return self.changed.get(
            atom, Fact(atom, False, Source.INITIAL, start.step, start.instant, start.time)
        )

    def known(self, atom: GroundAtom, at: datetime) -> Knowledge:
        """What can be said of an atom at a time: true, false, or not known (any more).

        at: with its time zone
        """
        fact = self.fact(atom)
        if atom in self.static:
            step, seen = fact.step, self.seen
        elif self.senses.is_needed_only(atom):
            step, seen = self.single.get(atom, (fact.step, fact.time))
        else:
            step, seen = max((self.looked, self.seen), self.single.get(atom, (0, "")))
        vain = self.vain.get(atom)
        vain = vain if vain is not None and vain > step else None
        if fact.holds is None:
            return Knowledge(None, fact, "", fact.step, vain)
        holds = fact.holds if atom in self.static or self._is_fresh(atom, seen, at) else None
        return Knowledge(holds, fact, seen, step, vain)

    def all_known(self, at: datetime) -> Iterator[Knowledge]:
        """What can be said of every atom that was ever true, unknown, or looked at, in order."""
        atoms = self.changed.keys() | self.single.keys() | self.vain.keys()
        return (self.known(atom, at) for atom in sorted(atoms))

    def stale(self, at: datetime) -> frozenset[GroundAtom]:
        """The atoms that were known once, and were seen too long ago."""
        if not self.senses:
            return frozenset()
        return frozenset(each.fact.atom for each in self.all_known(at) if each.is_stale)

    def _is_fresh(self, atom: GroundAtom, seen: str, at: datetime) -> bool:
        lasts = self.senses.lasts(atom)
        if lasts is None or not seen:
            return True
        return (at - datetime.fromisoformat(seen)).total_seconds() <= lasts

    def letters(self, symbols: Iterable[Symbol]) -> tuple[Letter, ...]:
        """The symbols true at each instant of the trace, for `logic.trace.holds`."""
        wanted = tuple(symbols)
        return tuple(
            letter(wanted, moment.state | self.static, moment.action) for moment in self.trace
        )


def facts_after(entries: Iterable[Entry]) -> Facts:
    """Fold entries, from the first one of a mission on, to what is known after them.

    raises PlainspokenError: when they are not the beginning of a log
    """
    folding = Folding()
    for entry in entries:
        folding.take(entry)
    return folding.facts()


class Folding:
    """What is known, entry by entry."""

    def __init__(self) -> None:
        self._changed: dict[GroundAtom, Fact] = {}
        self._static: State = frozenset()
        self._trace: list[Moment] = []
        self._seen, self._looked = "", 0
        self._senses = Senses()
        self._single: dict[GroundAtom, tuple[Step, str]] = {}
        self._vain: dict[GroundAtom, Step] = {}
        self._problem: Problem | None = None
        self._unknown: State = frozenset()

    def facts(self) -> Facts:
        """What is known so far.

        raises PlainspokenError: when nothing is
        """
        if not self._trace:
            raise PlainspokenError("an empty log: a log begins with mission_accepted")
        return Facts(
            self._changed,
            self._static,
            tuple(self._trace),
            self._seen,
            self._looked,
            self._senses,
            self._single,
            self._vain,
        )

    def take(self, entry: Entry) -> None:
        """Take in the next entry.

        raises PlainspokenError: when it is not the next one of a log
        """
        event = entry.event
        if not isinstance(event, Stated):
            if not self._trace:
                raise _misplaced(entry, "a log begins with mission_accepted")
            return
        if not self._trace and not isinstance(event, MissionAccepted):
            raise _misplaced(entry, "a log begins with mission_accepted")
        if isinstance(event, MissionAccepted):
            self._begin(entry, event)
        single = isinstance(event, ObservationMade) and event.sensed
        if not isinstance(event, ReportReceived) and not single:
            self._seen, self._looked = entry.time, entry.step
        self._single_facts(entry, event)
        if entry.instant != len(self._trace) - 1:
            self._next_instant(entry, event)
        elif event.state is not self._trace[-1].state:
            # What was not known did not change: the instant is as it is seen now.
            self._trace[-1] = replace(self._trace[-1], state=event.state)
        if isinstance(event, MissionAccepted):
            for atom in event.unknown:
                self._note(entry, atom, Source.INITIAL, holds=None)
            self._unknown = frozenset(event.unknown)

    def _begin(self, entry: Entry, event: MissionAccepted) -> None:
        self._senses = Senses.of(event)
        self._static = frozenset(event.static)
        for atom in sorted(self._static):
            self._note(entry, atom, Source.INITIAL, holds=True)
        # Only where something is hidden does it matter what an action settles unseen.
        if event.unknown or any(rule.needed for rule in self._senses.rules):
            where = f"mission {event.mission}"
            self._problem = parse_problem(
                event.problem, parse_domain(event.domain, f"{where}, domain"), f"{where}, problem"
            )

    def _next_instant(self, entry: Entry, event: Stated) -> None:
        trace = self._trace
        if entry.instant != len(trace) or bool(trace) == isinstance(event, MissionAccepted):
            raise _misplaced(entry, f"expected instant {len(trace)}, got {entry.instant}")
        before = trace[-1].state if trace else frozenset()
        action = event.action if isinstance(event, ActionFinished) else None
        trace.append(Moment(entry.instant, event.state, action, entry.step, entry.time))
        for atom in sorted(event.state ^ before):
            self._note(entry, atom, _source(event), holds=atom in event.state, by=_by(event))

    def _single_facts(self, entry: Entry, event: Stated) -> None:
        """What an event says of facts one by one, whether it changed what was believed or not."""
        if isinstance(event, ObservationMade) and event.sensed:
            for each in event.sensed:
                person = each.get("reporter")
                source = Source.OBSERVATION if person is None else Source.REPORT
                if each["holds"] is None:
                    self._vain[each["atom"]] = entry.step
                else:
                    by = str(person or each["by"])
                    self._note(entry, each["atom"], source, holds=each["holds"], by=by)
        elif isinstance(event, ReportReceived):
            for each in event.told:
                by = event.reporter
                self._note(entry, each["atom"], Source.REPORT, holds=each["holds"], by=by)
        elif self._problem is not None and self._trace:
            world = self._trace[-1].state | self._static
            said = told_by(event, world, self._unknown, self._senses, self._problem)
            if isinstance(event, ActionFinished):
                settled = settled_by(self._problem, world, event.action)
                said.update((atom, atom in event.state) for atom in settled)
            for atom, holds in sorted(said.items()):
                self._note(entry, atom, _source(event), holds=holds, by=_by(event))

    def _note(
        self,
        entry: Entry,
        atom: GroundAtom,
        source: Source,
        *,
        holds: bool | None,
        by: str | None = None,
    ) -> None:
        """An entry says of an atom that it is so; since when is older where it was so before."""
        if holds is not None:
            self._single[atom] = entry.step, entry.time
            self._unknown -= {atom}
        known = self._changed.get(atom)
        if (known.holds if known is not None else False) is not holds:
            self._changed[atom] = Fact(
                atom, holds, source, entry.step, entry.instant, entry.time, by
            )


def trace_of(entries: Iterable[Entry]) -> tuple[Moment, ...]:
    """The trace of a log: instants s0 ... sn with the actions that led to them."""
    return facts_after(entries).trace


def _source(event: Stated) -> Source:
    match event:
        case MissionAccepted():
            return Source.INITIAL
        case ActionFinished():
            return Source.ACTION
        # What a failed action left behind was seen, not meant.
        case ActionFailed() | ObservationMade():
            return Source.OBSERVATION
        case ReportReceived():
            return Source.REPORT


def _by(event: Stated) -> str | None:
    """What a fact is known from: an action, whoever saw it, or who said so."""
    match event:
        case MissionAccepted():
            return None
        case ActionFinished(action) | ActionFailed(action):
            return action
        case ObservationMade(source):
            return source
        case ReportReceived(reporter):
            return reporter


def _misplaced(entry: Entry, what: str) -> PlainspokenError:
    return PlainspokenError(what, where=f"step {entry.step}, {entry.kind}")
