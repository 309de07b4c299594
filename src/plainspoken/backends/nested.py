"""A mission inside an action: a goal of its own, in a domain of its own, for a robot of its own.

    services:
      clear:
        via: mission
        domain: line.pddl             # paths are taken from where the robots' file lies
        problem: one-line.pddl
        goal: F cleared_{l}           # a template over the fields of a call
        start: ["robot-at rob {l}"]   # what is true there at first, beside the problem's init
        robots: line.yaml             # its own robots' file, or `simulator`

Its log is in the same store, under the id of the call, so that `missions` and `ask` know it too;
a program that takes over goes on with it from there.
"""

from __future__ import annotations

import threading
from collections.abc import Generator, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from pathlib import Path

from plainspoken.backends.activities.adapter import COMMON, Around
from plainspoken.backends.activities.document import Section, Value
from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.log import EventLog
from plainspoken.logic.syntax import parse
from plainspoken.mission.activity import Literal
from plainspoken.mission.mission import Mission, mission_from
from plainspoken.mission.observation import CancelAsked, Observation
from plainspoken.mission.repertoire import amended
from plainspoken.mission.robot import Robot, Unheard
from plainspoken.mission.run import Record
from plainspoken.mission.service import CallId, CallStatus, Done, Fields, Going, NotDone
from plainspoken.mission.simulator import Simulator
from plainspoken.mission.template import filled, paths_in
from plainspoken.pipeline import (
    Request,
    Site,
    carry_out,
    find_policy,
    go_on,
    open_site,
    why_not,
)
from plainspoken.planning.solver import Solved
from plainspoken.questions.lexicon import Lexicon
from plainspoken.world.domain import State
from plainspoken.world.event import (
    ActionProgressed,
    ActionStarted,
    Entry,
    Event,
    Instant,
    Step,
)

SIMULATOR = "simulator"
_FIELDS = "nested mission"
"""Under which a journal keeps the fields of a call, for whoever takes over."""


def open_adapter(settings: Section | None, around: Around) -> MissionAdapter:
    """The adapter; there is nothing to set."""
    if settings is not None:
        settings.only()
    return MissionAdapter(around)


@dataclass
class MissionAdapter:
    """Makes services that are missions."""

    around: Around
    services: list[MissionService] = field(default_factory=list)

    def service(self, settings: Section) -> MissionService:
        settings.only(*COMMON, "domain", "problem", "landmarks", "goal", "start", "robots")
        landmarks = settings.get("landmarks")
        site = open_site(
            _beside(settings.need("domain", "the PDDL domain of the mission")),
            _beside(settings.need("problem", "the PDDL problem of the mission")),
            None if landmarks is None else _beside(landmarks),
        )
        start = settings.get("start")
        robots = settings.need("robots", f"its own robots' file, or {SIMULATOR}")
        service = MissionService(
            self.around,
            site,
            settings.need("goal", "the formula that is to hold").text(),
            () if start is None else tuple(Literal.of(item.text()) for item in start.items()),
            None if robots.text() == SIMULATOR else _beside(robots),
        )
        service.check(robots)
        self.services.append(service)
        return service

    def close(self) -> None:
        for service in self.services:
            service.close()


class _ClosedError(Exception):
    """The program ends; the mission is gone on with by the next one."""


@dataclass
class _Run:
    """A nested mission while it goes on, as its thread and others see it."""

    doing: str = "planning"
    ended: Done | NotDone | None = None
    cancelling: bool = False
    thread: threading.Thread | None = None


@dataclass
class MissionService:
    """Runs a mission for each call, each in a thread of its own."""

    around: Around
    site: Site
    goal: str
    start: tuple[Literal, ...]
    robots: Path | None
    runs: dict[CallId, _Run] = field(default_factory=dict)
    closing: threading.Event = field(default_factory=threading.Event)

    def check(self, robots: Value) -> None:
        """See that the nested robots' file is sound before anything moves."""
        if self.robots is not None:
            if self.robots.resolve() == robots.path.resolve():
                raise robots.error("a mission inside itself would never end")
            with self._robot(self.site.problem.initial):
                pass

    def objection(self, fields: Fields) -> str | None:
        named = {*paths_in(self.goal), *(path for one in self.start for path in paths_in(one.atom))}
        missing = sorted(name for name in named if name.partition(".")[0] not in fields)
        return f"the mission's goal needs the fields {', '.join(missing)}" if missing else None

    def begin(self, call: CallId, fields: Fields) -> None:
        if call not in self.runs:
            self.around.journal.note(call, _FIELDS, dict(fields))
            self._started(call, fields)

    def status(self, call: CallId) -> CallStatus:
        run = self.runs.get(call)
        if run is None:
            fields = self.around.journal.get(call, _FIELDS)
            if fields is None:
                return Unheard()
            run = self._started(call, fields)
        return run.ended or Going({"doing": run.doing})

    def cancel(self, call: CallId) -> None:
        run = self.runs.get(call)
        if run is not None:
            run.cancelling = True

    def reach(self) -> None: ...

    def close(self) -> None:
        """Leave the missions where they are; their logs say where that is."""
        self.closing.set()
        for run in self.runs.values():
            if run.thread is not None:
                run.thread.join(timeout=5)

    def _started(self, call: CallId, fields: Fields) -> _Run:
        run = self.runs[call] = _Run()
        run.thread = threading.Thread(
            target=self._lived, args=(call, fields, run), name=f"mission {call}", daemon=True
        )
        run.thread.start()
        return run

    def _lived(self, call: CallId, fields: Fields, run: _Run) -> None:
        try:
            run.ended = self._carried_out(call, fields, run)
        except _ClosedError:
            pass
        except PlainspokenError as error:
            run.ended = NotDone(error.what)

    def _carried_out(self, call: CallId, fields: Fields, run: _Run) -> Done | NotDone:
        with ExitStack() as stack:
            kept = self.around.store
            entries = kept.entries(call)
            robot = stack.enter_context(self._robot(self._first(fields, entries)))
            events = self._events(call, fields, robot, kept, run)
            if isinstance(events, NotDone):
                return events
            lexicon = Lexicon(self.site.problem, self.site.landmarks)
            while True:
                try:
                    event = next(events).event
                except StopIteration as end:
                    return _came_to(end.value)
                if isinstance(event, ActionStarted):
                    run.doing = lexicon.deed(event.action).doing
                elif isinstance(event, ActionProgressed) and event.doing:
                    run.doing = event.doing

    def _first(self, fields: Fields, entries: Sequence[Entry]) -> State:
        """What is believed at first: what the log says, where there is one."""
        if entries:
            return mission_from(entries).world
        return amended(self.site.problem.initial, (one.bound(fields) for one in self.start))

    def _events(
        self, call: CallId, fields: Fields, robot: Robot, kept: EventLog, run: _Run
    ) -> Generator[Entry, None, Mission] | NotDone:
        """The mission's run: from its log where it has one, or else from a policy."""
        entries = kept.entries(call)
        record = _recorder(kept, call, len(entries))

        def requests() -> Observation | None:
            if self.closing.is_set():
                raise _ClosedError
            if run.cancelling:
                run.cancelling = False  # asked for once: a request that comes again is all it hears
                return CancelAsked("the mission it is part of")
            return None

        if entries:
            return go_on(self.site, entries, robot, record, by="restart", requests=requests)
        site = replace(self.site, problem=replace(self.site.problem, initial=robot.state()))
        formula = parse(str(filled(self.goal, fields)))
        ending = find_policy(site.problem, formula)
        if not isinstance(ending, Solved):
            return NotDone(why_not(ending, site))
        robots = SIMULATOR if self.robots is None else str(self.robots.absolute())
        part_of = call.partition("/")[0]
        request = Request(call, formula, robot={"robot": robots, "part_of": part_of})
        request = request.knowing(robot)
        return carry_out(site, request, ending.policy, robot, record, requests=requests)

    @contextmanager
    def _robot(self, state: State) -> Iterator[Robot]:
        if self.robots is None:
            yield Simulator(self.site.problem, state=state)
            return
        # A robots' file may hold missions, whose robots are again such a file.
        from plainspoken.backends.activities.configuration import robot_from

        store = self.around.store
        with robot_from(self.robots, self.site.problem, store, state=state) as robot:
            yield robot


def _came_to(mission: Mission) -> Done | NotDone:
    """What the end of a nested mission is to the action that it is."""
    ended = mission.ended
    if ended is None:
        return NotDone(f"paused by {mission.paused_by}")
    if not ended.satisfied or ended.outcome != "finished":
        return NotDone(ended.reason or f"{ended.outcome}, and its goal is not met")
    return Done({"outcome": ended.outcome, "facts": dict.fromkeys(sorted(mission.world), True)})


def _recorder(kept: EventLog, call: CallId, step: Step) -> Record:
    """Stores events from a step on, for as long as no other process goes on with the mission."""

    def record(instant: Instant, events: Sequence[Event]) -> Sequence[Entry]:
        nonlocal step
        time = datetime.now(UTC).isoformat(timespec="milliseconds")
        entries = kept.append(call, time, instant, events, at=step)
        step += len(entries)
        return entries

    return record


def _beside(value: Value) -> Path:
    """A path in a robots' file, taken from where the file lies."""
    return value.path.parent / value.text()
