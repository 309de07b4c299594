"""Missions in worlds that do not keep to their model; `benchmarks/adversary.py` does more."""

from collections import Counter
from collections.abc import Sequence

import pytest
from benchmarks.adversary import GOALS, Drawn, policy_for, run, site

from plainspoken.logic.syntax import parse
from plainspoken.mission.executive import accept
from plainspoken.mission.fault import Fault, FaultKind, FaultyRobot
from plainspoken.mission.mission import Limits
from plainspoken.mission.request import acceptance
from plainspoken.mission.run import run_mission
from plainspoken.mission.simulator import Simulator
from plainspoken.pipeline import replanner
from plainspoken.world.event import ActionStarted, Entry, Event, MissionEnded

RUNS = 30


@pytest.mark.parametrize("seed", range(RUNS))
def test_whatever_the_world_does_the_log_says_what_the_semantics_says_of_its_trace(
    seed: int,
) -> None:
    ran = run(seed)
    assert ran.defects == (), Drawn.of(seed)
    assert ran.ending.startswith(("finished", "stopped: "))


def test_the_runs_are_on_every_domain_and_meet_every_kind_of_trouble() -> None:
    drawn = [Drawn.of(seed) for seed in range(RUNS)]
    assert {each.domain for each in drawn} == set(GOALS)
    assert {fault.kind for each in drawn for fault in each.faults} == set(FaultKind)


def test_where_chance_is_unfair_for_ever_the_mission_says_so_after_so_many_tries() -> None:
    here = site("kitchen")
    text = GOALS["kitchen"][0]
    entries: list[Entry] = []

    def record(instant: int, events: Sequence[Event]) -> list[Entry]:
        new = [Entry(len(entries) + n, "", instant, event) for n, event in enumerate(events)]
        entries.extend(new)
        return new

    robot = FaultyRobot(here.problem, Simulator(here.problem), (Fault(FaultKind.UNLUCKY, 1.0),))
    accepted = acceptance(
        "m", here.problem, parse(text), domain_text=here.domain_text, problem_text=here.problem_text
    )
    start = accept(accepted, policy_for("kitchen", text))
    for _ in run_mission(start, robot, record, replanner(here)):
        pass
    ended = entries[-1].event
    assert isinstance(ended, MissionEnded)
    assert ended.reason is not None
    assert ended.reason.startswith("no luck with ")
    tries = Counter(each.event.node for each in entries if isinstance(each.event, ActionStarted))
    assert max(tries.values()) == Limits().revisits + 1
