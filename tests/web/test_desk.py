import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import pytest
from tests.mission.small_vineyard import DOMAIN_TEXT, PROBLEM, PROBLEM_TEXT

from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.log import SqliteLog
from plainspoken.logic.syntax import parse
from plainspoken.mission.mission import Status
from plainspoken.mission.observation import ChangeAsked, Told
from plainspoken.mission.request import Clause
from plainspoken.mission.robot import Robot
from plainspoken.mission.simulator import Simulator
from plainspoken.pipeline import Request, Site
from plainspoken.planning.solver import Solved
from plainspoken.web.desk import Desk, PlanningStopped
from plainspoken.world.event import Entry

SITE = Site(PROBLEM, DOMAIN_TEXT, PROBLEM_TEXT)
GOAL = parse("F(cleared_l0 & F robot_at_rob_wh)")


def slow_robot(site: Site, set_up: Mapping[str, Any], entries: Sequence[Entry]) -> Robot:
    """Each action takes some hundredths of a second."""
    del set_up
    state = None
    for entry in entries:
        state = getattr(entry.event, "state", state)
    return Simulator(site.problem, state=state, pace=0.01)


@pytest.fixture
def desk() -> Iterator[Desk]:
    with SqliteLog(":memory:") as log:
        desk = Desk({"vineyard": SITE}, log, slow_robot)
        yield desk
        for mission in desk.missions():
            if desk.is_running(mission):
                desk.cancel(mission, "the test")
        until(lambda: not any(map(desk.is_running, desk.missions())))


def until(so: Callable[[], bool]) -> None:
    for _ in range(500):
        if so():
            return
        time.sleep(0.02)
    raise AssertionError("waited for too long")


def started(desk: Desk, mission: str = "m") -> str:
    ending = desk.plan("vineyard", GOAL)
    assert isinstance(ending, Solved)
    return desk.start("vineyard", Request(mission, GOAL), ending.policy)


def test_a_mission_goes_on_while_others_watch_and_ask(desk: Desk) -> None:
    mission = started(desk)
    seen = [entry for some in desk.follow(mission) for entry in some]
    assert seen == list(desk.entries(mission))
    assert seen[-1].kind == "mission_ended"
    assert desk.mission(mission).satisfied
    answer, _ = desk.ask(mission, "What did you do last?")
    assert "warehouse" in answer.text


def test_a_paused_mission_takes_reports_and_goes_on_when_told(desk: Desk) -> None:
    mission = started(desk)
    desk.pause(mission, "ada")
    until(lambda: desk.mission(mission).status is Status.PAUSED and not desk.is_running(mission))
    desk.report(mission, Told("ada", "the support robot is at line 0"))
    assert desk.mission(mission).status is Status.PAUSED
    desk.resume(mission, "ada")
    until(lambda: desk.mission(mission).is_over)
    assert desk.mission(mission).satisfied


def test_a_mission_can_be_cancelled_and_is_over_then(desk: Desk) -> None:
    mission = started(desk)
    desk.cancel(mission, "ada")
    until(lambda: desk.mission(mission).is_over)
    assert desk.mission(mission).status is Status.CANCELLED
    with pytest.raises(PlainspokenError, match="is over"):
        desk.resume(mission, "ada")


def test_a_changed_mission_is_planned_anew(desk: Desk) -> None:
    mission = started(desk)
    desk.change(
        mission, ChangeAsked("ada", "only check", (Clause(parse("F check_grape_executed")),))
    )
    until(lambda: desk.mission(mission).is_over)
    assert "request_changed" in {entry.kind for entry in desk.entries(mission)}


def test_one_mission_is_carried_out_by_one_thread(desk: Desk) -> None:
    started(desk)
    with pytest.raises(PlainspokenError, match="carried out already"):
        started(desk)


def test_two_missions_go_on_side_by_side(desk: Desk) -> None:
    missions = [started(desk, "one"), started(desk, "other")]
    until(lambda: all(desk.mission(each).is_over for each in missions))
    assert all(desk.mission(each).satisfied for each in missions)


def test_planning_stops_when_nobody_waits_for_it(desk: Desk) -> None:
    stopped = threading.Event()
    stopped.set()
    with pytest.raises(PlanningStopped):
        desk.plan("vineyard", GOAL, stopped=stopped)


def test_a_desk_that_was_killed_finds_its_missions_again() -> None:
    with SqliteLog(":memory:") as log:
        first = Desk({"vineyard": SITE}, log, slow_robot)
        mission = started(first)
        until(lambda: first.mission(mission).instant > 0)
        first.pause(mission, "the test")
        until(lambda: not first.is_running(mission))
        second = Desk({"vineyard": SITE}, log, slow_robot)
        second.resume(mission, "restart")
        until(lambda: second.mission(mission).is_over)
        assert second.mission(mission).satisfied


@pytest.mark.parametrize("name", ["", "m2"])
def test_what_is_not_there_is_an_error(desk: Desk, name: str) -> None:
    with pytest.raises(PlainspokenError, match="no mission"):
        desk.mission(name)
    with pytest.raises(PlainspokenError, match="no place"):
        desk.understand("orchard", "Clear line 0")
