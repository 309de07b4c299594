import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from itertools import count, pairwise
from pathlib import Path
from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.mission.small_vineyard import PROBLEM, accepted, policy_for, replanned

from plainspoken.knowledge.facts import facts_after
from plainspoken.knowledge.log import SqliteLog
from plainspoken.logic.formula import Formula, atoms
from plainspoken.logic.syntax import parse
from plainspoken.logic.trace import holds
from plainspoken.mission.executive import Advance, accept, advance
from plainspoken.mission.mission import Mission, Status, mission_from
from plainspoken.mission.observation import (
    CancelAsked,
    Observation,
    PauseAsked,
    ResumeAsked,
    Told,
)
from plainspoken.mission.robot import GoalStatus, Seconds, Succeeded, Unheard
from plainspoken.mission.run import Heed, Replanner, Requests, run_mission
from plainspoken.mission.simulator import Simulator
from plainspoken.planning.policy import Policy
from plainspoken.world.domain import GroundAction, State
from plainspoken.world.event import ActionFinished, Entry, Event, MissionAccepted, MissionEnded
from plainspoken.world.symbol import resolve_all

GOALS = [
    parse(text)
    for text in (
        "F cleared_l0",
        "F(cleared_l0 & F robot_at_rob_wh)",
        "F cleared_l0 & G(full_b -> F !full_b)",
        "F cleared_l0 & (!robot_at_sup_l0 W cleared_l0)",
        "F check_grape_executed & X X X true",
        "G(harvest_grape_executed -> X drop_grape_executed) & F cleared_l0",
        "(ripe_g0 | unripe_g0) R robot_at_sup_wh & F(cleared_l0 & X F robot_at_rob_wh)",
    )
]
POLICIES = [policy_for(goal) for goal in GOALS]
WHICH = st.integers(0, len(GOALS) - 1)


class Recorder:
    """Keeps entries as a store does, and hands them out again."""

    def __init__(self) -> None:
        self.entries: list[Entry] = []

    def __call__(self, instant: int, events: Sequence[Event]) -> list[Entry]:
        assert events
        new = [
            Entry(step, "t", instant, event)
            for step, event in enumerate(events, start=len(self.entries))
        ]
        self.entries += new
        return new

    @property
    def kinds(self) -> list[str]:
        return [entry.kind for entry in self.entries]


def finished(
    start: Advance,
    robot: Simulator,
    record: Recorder,
    plan: Replanner = replanned,
    requests: Requests = lambda: None,
) -> Mission:
    """Run to the end, and hand the mission back; what is given is what was stored."""
    run = run_mission(start, robot, record, plan, requests=requests)
    given_out = len(record.entries)
    while True:
        try:
            assert next(run) == record.entries[given_out]
        except StopIteration as stop:
            mission = stop.value
            assert isinstance(mission, Mission)
            return mission
        given_out += 1


def check_verdict(goal: Formula, entries: Sequence[Entry]) -> None:
    """What the log says of the goal is what the plain semantics says of its trace."""
    letters = facts_after(entries).letters(resolve_all(atoms(goal), PROBLEM))
    ended = entries[-1].event
    assert isinstance(ended, MissionEnded)
    assert ended.satisfied == holds(goal, letters)


@given(WHICH, st.integers())
def test_without_surprises_every_run_finishes_and_satisfies_its_goal(which: int, seed: int) -> None:
    record = Recorder()
    start = accept(accepted(GOALS[which]), POLICIES[which])
    mission = finished(start, Simulator(PROBLEM, seed=seed), record)
    assert mission.status is Status.FINISHED
    assert mission.satisfied
    assert "deviation_noticed" not in record.kinds
    check_verdict(GOALS[which], record.entries)


class Haunted(Simulator):
    """A world where things happen by themselves, now and then."""

    def __init__(self, seed: int) -> None:
        super().__init__(PROBLEM, seed=seed)
        self._ghost = Random(seed)

    def wait(self, goal_id: str, timeout: Seconds) -> GoalStatus:
        if self._ghost.random() < 0.3:
            atoms = ["full b", "ripe g0", "unchecked g0", "robot-at sup l0", "cleared l0"]
            atom = self._ghost.choice(atoms)
            if atom in self.state():
                self.disturb(deleted=[atom])
            else:
                self.disturb(added=[atom])
        return super().wait(goal_id, timeout)


@given(WHICH, st.integers())
def test_whatever_happens_the_verdict_in_the_log_is_what_the_trace_says(
    which: int, seed: int
) -> None:
    record = Recorder()
    start = accept(accepted(GOALS[which]), POLICIES[which])
    mission = finished(start, Haunted(seed), record)
    assert mission.is_over
    if mission.status is Status.FINISHED:
        assert mission.satisfied
    else:
        assert mission.ended is not None
        assert mission.ended.reason
    check_verdict(GOALS[which], record.entries)
    assert mission_from(record.entries) == mission


@given(WHICH, st.integers())
def test_the_same_seed_is_the_same_run(which: int, seed: int) -> None:
    runs = []
    for _ in range(2):
        record = Recorder()
        start = accept(accepted(GOALS[which]), POLICIES[which])
        finished(start, Haunted(seed), record)
        runs.append(record.entries)
    assert runs[0] == runs[1]


@given(WHICH, st.integers(), st.data())
def test_a_run_that_is_killed_after_any_entry_goes_on_as_it_would_have(
    which: int, seed: int, data: st.DataObject
) -> None:
    whole = Recorder()
    start = accept(accepted(GOALS[which]), POLICIES[which])
    finished(start, Simulator(PROBLEM, seed=seed), whole)
    kept = Recorder()
    # A store keeps whole decisions; a file that is torn may end within one.
    kept.entries = whole.entries[: data.draw(st.integers(2, len(whole.entries) - 1))]
    trace = facts_after(kept.entries).trace
    robot = Simulator(
        PROBLEM,
        seed=seed,
        state=trace[-1].state,
        history=[
            (before.state, moment.action)
            for before, moment in pairwise(trace)
            if moment.action is not None
        ],
    )
    mission = mission_from(kept.entries)
    mission = finished(advance(mission, ResumeAsked("restart")), robot, kept)
    assert mission.status is Status.FINISHED
    assert facts_after(kept.entries).letters(
        resolve_all(atoms(GOALS[which]), PROBLEM)
    ) == facts_after(whole.entries).letters(resolve_all(atoms(GOALS[which]), PROBLEM))
    assert [m.state for m in facts_after(kept.entries).trace] == [
        m.state for m in facts_after(whole.entries).trace
    ]


def no_plan(_state: State, _remaining: Formula, _heed: Heed) -> Policy | str:
    return "nobody plans here"


def asking(*requests: tuple[int, Observation]) -> Requests:
    """Ask for something each time the loop has looked so often."""
    looks = count(1)
    due = dict(requests)
    return lambda: due.get(next(looks))


def test_a_pause_that_is_asked_for_meanwhile_ends_the_run_until_it_is_resumed() -> None:
    record = Recorder()
    robot = Simulator(PROBLEM)
    start = accept(accepted(GOALS[1]), POLICIES[1])
    paused = finished(start, robot, record, requests=asking((2, PauseAsked("ada"))))
    assert paused.is_at_rest
    assert record.kinds[-2:] == ["paused", "action_finished"]
    again = finished(advance(paused, ResumeAsked("ada")), robot, record)
    assert again.status is Status.FINISHED
    check_verdict(GOALS[1], record.entries)


def test_a_cancel_stops_the_robot_in_the_middle_of_its_action() -> None:
    record = Recorder()
    robot = Simulator(PROBLEM, pace=1.0, sleep=lambda _: None)
    start = accept(accepted(GOALS[0]), POLICIES[0])
    mission = finished(start, robot, record, requests=asking((3, CancelAsked("ada"))))
    assert mission.status is Status.CANCELLED
    assert record.kinds[-3:] == ["cancelled", "action_failed", "mission_ended"]
    assert robot.state() == PROBLEM.initial


def test_nobody_who_plans_is_asked_without_need() -> None:
    record = Recorder()
    mission = finished(
        accept(accepted(GOALS[0]), POLICIES[0]), Simulator(PROBLEM), record, plan=no_plan
    )
    assert mission.status is Status.FINISHED


def test_without_a_plan_for_a_surprise_it_stops_with_the_planners_reason() -> None:
    record = Recorder()
    robot = Simulator(PROBLEM)
    robot.disturb(added=["full b"])
    mission = finished(accept(accepted(GOALS[0]), POLICIES[0]), robot, record, plan=no_plan)
    assert mission.ended == MissionEnded("stopped", False, "nobody plans here")


class Interrupted(Simulator):
    """Ctrl-C comes while the robot is at its actions, at these looks."""

    def __init__(self, *looks: int) -> None:
        super().__init__(PROBLEM)
        self._looks = count(1)
        self._interrupts = looks

    def wait(self, goal_id: str, timeout: Seconds) -> GoalStatus:
        if next(self._looks) in self._interrupts:
            raise KeyboardInterrupt
        return super().wait(goal_id, timeout)


def test_an_interrupt_lets_the_action_end_and_leaves_the_mission_paused() -> None:
    record = Recorder()
    mission = finished(accept(accepted(GOALS[0]), POLICIES[0]), Interrupted(2), record)
    assert mission.is_at_rest
    assert mission.paused_by == "keyboard"
    assert record.kinds[-2:] == ["paused", "action_finished"]


def test_a_second_interrupt_leaves_at_once_with_the_pause_in_the_log() -> None:
    record = Recorder()
    with pytest.raises(KeyboardInterrupt):
        finished(accept(accepted(GOALS[0]), POLICIES[0]), Interrupted(2, 3), record)
    assert record.kinds[-1] == "paused"
    assert mission_from(record.entries).in_flight is not None


def test_who_stops_listening_pauses_the_mission() -> None:
    record = Recorder()
    run = run_mission(
        accept(accepted(GOALS[0]), POLICIES[0]), Simulator(PROBLEM), record, replanned
    )
    assert [next(run).kind for _ in range(4)][-1] == "action_finished"
    run.close()
    assert record.kinds[-1] == "paused"
    mission = mission_from(record.entries)
    again = finished(
        advance(mission, ResumeAsked("ada")),
        Simulator(PROBLEM, state=mission.world),
        record,
    )
    assert again.status is Status.FINISHED


class RobotOnDisk(Simulator):
    """A robot that goes on while the process that drives it dies: what it did is in a file."""

    def __init__(self, file: Path) -> None:
        self._file = file
        self._done: dict[str, State] = {}
        for line in file.read_text().splitlines() if file.exists() else ():
            goal_id, state = json.loads(line)
            self._done[goal_id] = frozenset(state)
        states = [PROBLEM.initial, *self._done.values()]
        super().__init__(PROBLEM, state=states[-1], seed=len(states))

    def send(self, goal_id: str, action: GroundAction) -> None:
        assert goal_id not in self._done, "an action was sent again"
        super().send(goal_id, action)
        time.sleep(0.003)
        super().wait(goal_id, 0.0)
        with self._file.open("a") as file:
            file.write(json.dumps([goal_id, sorted(self.state())]) + "\n")
        self._done[goal_id] = self.state()
        time.sleep(0.003)

    def wait(self, goal_id: str, timeout: Seconds) -> GoalStatus:
        return Succeeded(self._done[goal_id]) if goal_id in self._done else Unheard()


def drive(store: str, robot_file: str) -> None:
    """One process of the crash test: begin or take up the mission, and run it to its end."""
    goal = parse("F(robot_at_rob_l0 & F(robot_at_rob_wh & F(robot_at_rob_l0 & F cleared_l0)))")
    with SqliteLog(store) as log:

        def record(instant: int, events: Sequence[Event]) -> Sequence[Entry]:
            return log.append("m", "t", instant, events)

        entries = log.entries("m")
        if entries:
            mission = mission_from(entries)
            start = advance(mission, ResumeAsked("restart"))
        else:
            start = accept(accepted(goal), policy_for(goal))
        robot = RobotOnDisk(Path(robot_file))
        for _ in run_mission(start, robot, record, replanned):
            pass


def test_a_mission_that_is_killed_again_and_again_finishes_with_its_log_whole(
    tmp_path: Path,
) -> None:
    store, done = str(tmp_path / "log.sqlite"), tmp_path / "done"
    chance = Random(3)
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    code = "import sys; from tests.mission.test_run import drive; drive(*sys.argv[1:])"

    def one_life() -> "subprocess.Popen[bytes]":
        return subprocess.Popen([sys.executable, "-c", code, store, done], env=environment)

    def is_over() -> bool:
        with SqliteLog(store) as log:
            entries = log.entries("m")
        return bool(entries) and isinstance(entries[-1].event, MissionEnded)

    for _ in range(6):
        before = _steps(store)
        life = one_life()
        deadline = time.monotonic() + 30
        wanted = before + chance.randint(1, 6)
        while _steps(store) < wanted and life.poll() is None and time.monotonic() < deadline:
            time.sleep(0.002)
        life.send_signal(signal.SIGKILL)
        life.wait()
        if is_over():
            break
    if not is_over():
        assert one_life().wait(timeout=60) == 0
    with SqliteLog(store) as log:
        entries = log.entries("m")
        assert log.verify("m") is None
    accepted_event = entries[0].event
    assert isinstance(accepted_event, MissionAccepted)
    check_verdict(parse(accepted_event.goal), entries)
    assert mission_from(entries).status is Status.FINISHED
    in_the_log = [e.event.goal_id for e in entries if isinstance(e.event, ActionFinished)]
    by_the_robot = [json.loads(line)[0] for line in done.read_text().splitlines()]
    assert in_the_log == by_the_robot
    assert len(set(by_the_robot)) == len(by_the_robot)


def _steps(store: str) -> int:
    with SqliteLog(store) as log:
        return len(log.links("m"))


class Endless:
    """A planner that comes to no end the first time, unless it is interrupted."""

    def __init__(self) -> None:
        self.states: list[State] = []

    def __call__(self, state: State, remaining: Formula, heed: Heed) -> Policy | str:
        self.states.append(state)
        while len(self.states) == 1:
            heed()
        return replanned(state, remaining)


def asked_while_planning(request: Observation) -> tuple[Mission, Recorder, Endless]:
    """A run that goes astray at once, and is asked for something while it looks for a policy."""
    plan, record = Endless(), Recorder()
    robot = Simulator(PROBLEM)
    robot.disturb(added=["full b"])
    asked = [request]

    def requests() -> Observation | None:
        return asked.pop() if plan.states and asked else None

    start = accept(accepted(GOALS[0]), POLICIES[0])
    return finished(start, robot, record, plan, requests), record, plan


def test_a_pause_is_heard_while_a_policy_is_looked_for() -> None:
    mission, record, plan = asked_while_planning(PauseAsked("ada"))
    assert mission.status is Status.PAUSED
    assert record.kinds[-1] == "paused"
    assert len(plan.states) == 1


def test_a_cancellation_is_heard_while_a_policy_is_looked_for() -> None:
    mission, _, plan = asked_while_planning(CancelAsked("ada"))
    assert mission.status is Status.CANCELLED
    assert len(plan.states) == 1


def test_a_report_while_a_policy_is_looked_for_has_it_looked_for_from_there() -> None:
    told = Told("ada", "grape 0 is ripe", frozenset({"ripe g0"}), frozenset({"unchecked g0"}))
    mission, record, plan = asked_while_planning(told)
    assert mission.is_over
    assert "ripe g0" not in plan.states[0]
    assert "ripe g0" in plan.states[1]
    assert record.kinds.count("report_received") == 1
