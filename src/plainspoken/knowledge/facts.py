"""What is known: the fold of a log to facts, each with where it comes from, and to the trace."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from datetime import datetime
from enum import StrEnum

from plainspoken.errors import PlainspokenError
from plainspoken.logic.trace import Letter
from plainspoken.world.domain import GroundAction, GroundAtom, State
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
from plainspoken.world.symbol import Symbol, letter


class Source(StrEnum):
    """How it came to be known that an atom is true, or false."""

    INITIAL = "initial"
    ACTION = "action"
    OBSERVATION = "observation"
    REPORT = "report"


@dataclass(frozen=True, slots=True)
class Fact:
    """A ground atom that is true or false, since when, and what says so.

    step, instant, time: of the entry since which it has been so without a break
    """

    atom: GroundAtom
    holds: bool
    source: Source
    step: Step
    instant: Instant
    time: str


@dataclass(frozen=True, slots=True)
class Knowledge:
    """What can be said of an atom at a time.

    holds: None where it was seen too long ago to say: then it has to be looked at first
    fact:  what was seen last; seen: when that was, ISO 8601
    """

    holds: bool | None
    fact: Fact
    seen: str


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

    changed: the facts about atoms that were ever true, static ones included
    static:  the true atoms that no action changes
    trace:   instants s0 ... sn, sn the current one
    seen:    when the world was looked at last: every event with a state is such a look
    stale:   after how many seconds a fact of a predicate is not known any more
    """

    changed: Mapping[GroundAtom, Fact]
    static: State
    trace: tuple[Moment, ...]
    seen: str = ""
    stale: Mapping[str, float] = field(default_factory=dict)

    @property
    def state(self) -> State:
        """What is true now, static atoms included."""
        return self.trace[-1].state | self.static

    def fact(self, atom: GroundAtom) -> Fact:
        """What is known of an atom; one that was never true has been false since s0."""
        start = self.trace[0]
        return self.changed.get(
            atom, Fact(atom, False, Source.INITIAL, start.step, start.instant, start.time)
        )

    def known(self, atom: GroundAtom, at: datetime) -> Knowledge:
        """What can be said of an atom at a time: true, false, or not known any more.

        at: with its time zone
        """
        fact = self.fact(atom)
        lasts = self.stale.get(atom.split(" ", 1)[0])
        fresh = lasts is None or atom in self.static or not self.seen or (
            (at - datetime.fromisoformat(self.seen)).total_seconds() <= lasts
        )  # fmt: skip
        return Knowledge(fact.holds if fresh else None, fact, self.seen)

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
    changed: dict[GroundAtom, Fact] = {}
    static: State = frozenset()
    trace: list[Moment] = []
    seen, stale = "", dict[str, float]()
    for entry in entries:
        event = entry.event
        if isinstance(event, Stated) and not isinstance(event, ReportReceived):
            seen = entry.time
        if isinstance(event, MissionAccepted):
            stale = dict(event.robot.get("stale", {}))
            static = frozenset(event.static)
            changed.update(
                (atom, Fact(atom, True, Source.INITIAL, entry.step, 0, entry.time))
                for atom in sorted(static)
            )
        if not isinstance(event, Stated) or entry.instant == len(trace) - 1:
            if not trace:
                raise _misplaced(entry, "a log begins with mission_accepted")
            continue
        if entry.instant != len(trace) or bool(trace) == isinstance(event, MissionAccepted):
            raise _misplaced(entry, f"expected instant {len(trace)}, got {entry.instant}")
        before = trace[-1].state if trace else frozenset()
        trace.append(_moment(entry, event))
        for atom in sorted(event.state ^ before):
            changed[atom] = Fact(
                atom, atom in event.state, _source(event), entry.step, entry.instant, entry.time
            )
    if not trace:
        raise PlainspokenError("an empty log: a log begins with mission_accepted")
    return Facts(changed, static, tuple(trace), seen, stale)


def trace_of(entries: Iterable[Entry]) -> tuple[Moment, ...]:
    """The trace of a log: instants s0 ... sn with the actions that led to them."""
    return facts_after(entries).trace


def _moment(entry: Entry, event: Stated) -> Moment:
    action = event.action if isinstance(event, ActionFinished) else None
    return Moment(entry.instant, event.state, action, entry.step, entry.time)


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


def _misplaced(entry: Entry, what: str) -> PlainspokenError:
    return PlainspokenError(what, where=f"step {entry.step}, {entry.kind}")
