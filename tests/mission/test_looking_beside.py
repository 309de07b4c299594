"""Robots at work at once, in a world of which not all is known."""

from itertools import pairwise

from hypothesis import given, settings
from hypothesis import strategies as st
from tests.mission.harbour import GOAL, SITE
from tests.mission.store_room import Kept

from plainspoken.knowledge.facts import facts_after
from plainspoken.logic.trace import holds
from plainspoken.mission.executive import accept
from plainspoken.mission.mission import Limits, Mission, after, begun
from plainspoken.mission.request import symbols_of
from plainspoken.mission.run import heeding, run_mission
from plainspoken.mission.simulator import Simulator
from plainspoken.mission.veil import VeiledRobot, drawn
from plainspoken.pipeline import Request, accepted_as, find_policy, replanner
from plainspoken.planning.solver import Solved
from plainspoken.world.event import ActionStarted, Entry, MissionAccepted, MissionEnded
from plainspoken.world.scene import relevant_to


def carried_out(seed: int) -> tuple[Mission, list[Entry]]:
    """A mission of both robots at once, to its end."""
    world = Simulator(drawn(SITE.problem, seed), seed=seed)
    robot = VeiledRobot(world, SITE.problem)
    ending = find_policy(SITE.problem, GOAL)
    assert isinstance(ending, Solved)
    kept = Kept()
    request = Request("m", GOAL, robot={"side_by_side": True}).knowing(robot)
    start = accept(accepted_as(SITE, request), ending.policy)
    run = run_mission(start, robot, heeding(robot, kept.record), replanner(SITE))
    while True:
        try:
            next(run)
        except StopIteration as end:
            return end.value, kept.entries


@settings(deadline=None, max_examples=30)
@given(st.integers(0, 10_000))
def test_no_robot_begins_what_rests_on_a_fact_that_nobody_knows(seed: int) -> None:
    mission, entries = carried_out(seed)
    assert mission.ended == MissionEnded("finished", satisfied=True)
    first = entries[0].event
    assert isinstance(first, MissionAccepted)
    now = begun(first, Limits())
    for entry in entries[1:]:
        if isinstance(entry.event, ActionStarted):
            rests_on = relevant_to(SITE.problem, entry.event.action)
            assert not rests_on & now.lookout.unknown, entry.event.action
        now = after(now, entry.event)
    assert holds(
        GOAL, facts_after(entries).letters(symbols_of(mission.brief.clauses, SITE.problem))
    )


def test_robots_are_at_work_at_once_where_enough_is_known() -> None:
    _, entries = carried_out(0)
    kinds = [entry.kind for entry in entries]
    assert ("action_started", "action_started") in pairwise(kinds)
