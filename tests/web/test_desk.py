import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

import pytest
from tests.mission.small_vineyard import DOMAIN_TEXT, PROBLEM, PROBLEM_TEXT

from plainspoken.cli.store import open_store
from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.log import OvertakenError
from plainspoken.knowledge.store import Store
from plainspoken.logic.syntax import parse
from plainspoken.mission.mission import Status
from plainspoken.mission.observation import ChangeAsked, Told
from plainspoken.mission.request import Clause
from plainspoken.mission.robot import Robot
from plainspoken.mission.run import Patience
from plainspoken.mission.simulator import Simulator
from plainspoken.pipeline import Request, Site
from plainspoken.planning.solver import Solved
from plainspoken.web.desk import Desk, PlanningStopped
from plainspoken.world.event import Entry

SITE = Site(PROBLEM, DOMAIN_TEXT, PROBLEM_TEXT)
GOAL = parse("F(cleared_l0 & F robot_at_rob_wh)")


@contextmanager
def slow_robot(
    site: Site, set_up: Mapping[str, Any], entries: Sequence[Entry]
) -> Iterator[tuple[Robot, Patience]]:
    """Each action takes some hundredths of a second."""
    del set_up
    state = None
    for entry in entries:
        state = getattr(entry.event, "state", state)
    yield Simulator(site.problem, state=state, pace=0.01), Patience(news=0.02)


@pytest.fixture
def desk(store: Store) -> Iterator[Desk]:
    desk = Desk({"vineyard": SITE}, store, slow_robot)
    yield desk
    desk.close()


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
    until(lambda: desk.entries(mission)[-1].kind == "report_received")
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


def test_there_is_one_mission_of_a_name(desk: Desk) -> None:
    started(desk)
    with pytest.raises(OvertakenError):
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


def test_what_a_desk_leaves_another_one_goes_on_with(store: Store) -> None:
    first = Desk({"vineyard": SITE}, store, slow_robot)
    mission = started(first)
    until(lambda: first.mission(mission).instant > 0)
    first.close()
    assert not first.mission(mission).is_over
    second = Desk({"vineyard": SITE}, store, slow_robot)
    until(lambda: second.mission(mission).is_over)
    second.close()
    assert second.mission(mission).satisfied


def test_whoever_watches_sees_what_another_process_carries_out(
    store: Store, store_url: str
) -> None:
    with open_store(store_url) as elsewhere:
        other = Desk({"vineyard": SITE}, elsewhere, slow_robot)
        mission = started(other)
        until(lambda: other.is_running(mission))
        here = Desk({}, store, slow_robot, most=0)
        here.pause(mission, "ada")
        until(lambda: here.mission(mission).status is Status.PAUSED)
        here.resume(mission, "ada")
        seen = [entry for some in here.follow(mission) for entry in some]
        here.close()
        other.close()
    assert seen[-1].kind == "mission_ended"
    assert {"paused", "resumed"} <= {entry.kind for entry in seen}


@pytest.mark.parametrize("name", ["", "m2"])
def test_what_is_not_there_is_an_error(desk: Desk, name: str) -> None:
    with pytest.raises(PlainspokenError, match="no mission"):
        desk.mission(name)
    with pytest.raises(PlainspokenError, match="no place"):
        desk.understand("orchard", "Clear line 0")
