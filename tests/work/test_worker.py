"""Workers in one process, each on a thread; `test_crash` has them in processes that are killed."""

import threading
from collections.abc import Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from tests.work.workshop import (
    at_work,
    deeds,
    finished_goals,
    kinds,
    queue_up,
    robot_for,
    standing,
    until,
)

from plainspoken.cli.store import open_store
from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.log import OvertakenError
from plainspoken.knowledge.queue import Standing
from plainspoken.knowledge.store import Store
from plainspoken.mission.mailbox import to_message
from plainspoken.mission.mission import Status
from plainspoken.mission.observation import CancelAsked, PauseAsked, ResumeAsked, Told
from plainspoken.mission.robot import Robot, Seconds
from plainspoken.mission.run import Patience
from plainspoken.pipeline import Site
from plainspoken.work.asking import ask_of
from plainspoken.work.shift import Shift
from plainspoken.work.worker import Worker
from plainspoken.world.event import Entry, Paused, ReportReceived, TakenUp


def place_of(store: Store, mission: str) -> tuple[Standing, str | None, str | None]:
    place = store.place(mission)
    assert place is not None
    return place.standing, place.worker, place.trouble


def test_a_worker_carries_out_what_waits_and_then_is_done(store: Store, tmp_path: Path) -> None:
    for mission in ("m1", "m2", "m3"):
        queue_up(store, mission, tmp_path / mission)
    Worker(store, robot_for).run(until_done=True)
    for mission in ("m1", "m2", "m3"):
        assert standing(store, mission).status is Status.FINISHED
        assert store.verify(mission) is None
        done = [deed.goal_id for deed in deeds(tmp_path / mission, mission)]
        assert finished_goals(store, mission) == done == [f"{mission}/{n}" for n in range(1, 5)]
        assert place_of(store, mission) == (Standing.OVER, None, None)
    assert store.workers() == ()


def test_missions_of_one_robot_never_overlap_and_come_in_their_order(
    store: Store, tmp_path: Path
) -> None:
    missions = [f"m{number}" for number in range(4)]
    for mission in missions:
        queue_up(store, mission, tmp_path / "world", robot="rob", pace=0.002)
    with at_work(Worker(store, robot_for)), at_work(Worker(store, robot_for)):
        until(lambda: all(standing(store, mission).is_over for mission in missions))
    all_deeds = [deeds(tmp_path / "world", mission) for mission in missions]
    for earlier, later in pairwise(all_deeds):
        assert earlier[-1].ends <= later[0].begins


def test_a_mission_is_paused_resumed_and_cancelled_from_outside(
    store: Store, store_url: str, tmp_path: Path
) -> None:
    queue_up(store, "m", tmp_path / "world", pace=0.2)
    with at_work(Worker(store, robot_for)), open_store(store_url) as outside:
        until(lambda: "action_started" in kinds(store, "m"))
        reply = ask_of(outside, "m", PauseAsked("ada"), ())
        assert reply.heard
        until(lambda: place_of(store, "m")[0] is Standing.RESTING)
        paused = standing(store, "m")
        assert paused.is_at_rest
        assert paused.instant >= 1, "the action under way came to its end"
        assert paused.in_flight is None
        assert ask_of(outside, "m", ResumeAsked("ada"), ()).heard
        until(lambda: standing(store, "m").instant > paused.instant)
        assert ask_of(outside, "m", CancelAsked("ada"), ()).heard
        until(lambda: standing(store, "m").is_over)
    assert standing(store, "m").status is Status.CANCELLED
    assert store.verify("m") is None


def test_a_report_is_in_the_log_once_whoever_reads_it(store: Store, tmp_path: Path) -> None:
    queue_up(store, "m", tmp_path / "world", pace=0.02)
    told = Told("ada", "I emptied the box", deleted=frozenset({"full b"}))
    store.post("m", to_message(told))
    Worker(store, robot_for).run(until_done=True)
    reports = [e.event for e in store.entries("m") if isinstance(e.event, ReportReceived)]
    assert [report.text for report in reports] == ["I emptied the box"]
    assert store.unanswered("m") == ()


def test_what_was_asked_and_leads_to_nothing_is_done_with_when_the_mission_goes_on(
    store: Store, tmp_path: Path
) -> None:
    queue_up(store, "m", tmp_path / "world")
    with Shift(store) as shift:
        held = shift.take("m")
        assert held is not None
        number = store.post("m", to_message(PauseAsked("ada")))
        shift.tick()
        until(lambda: held.requests() == PauseAsked("ada"))
        assert not store.is_answered("m", number)
        assert held.requests() is None
        assert store.is_answered("m", number)


def test_what_is_asked_of_a_mission_that_nobody_carries_out_is_in_its_log_at_once(
    store: Store, tmp_path: Path
) -> None:
    queue_up(store, "m", tmp_path / "world")
    reply = ask_of(store, "m", PauseAsked("ada"), ())
    assert reply.heard
    assert reply.worker is None
    assert reply.mission.status is Status.PAUSED
    Worker(store, robot_for).run(until_done=True)
    assert standing(store, "m").status is Status.PAUSED, "a worker does not undo a pause"
    assert deeds(tmp_path / "world", "m") == ()
    ask_of(store, "m", ResumeAsked("ada"), ())
    Worker(store, robot_for).run(until_done=True)
    assert standing(store, "m").status is Status.FINISHED


def test_a_mission_at_rest_is_gone_on_with_when_a_message_comes(
    store: Store, tmp_path: Path
) -> None:
    queue_up(store, "m", tmp_path / "world")
    ask_of(store, "m", PauseAsked("ada"), ())
    with at_work(Worker(store, robot_for)):
        store.post("m", to_message(Told("ada", "nothing new")))
        until(lambda: kinds(store, "m")[-1] == "report_received")
        store.post("m", to_message(ResumeAsked("ada")))
        until(lambda: standing(store, "m").is_over)


def test_a_worker_that_stops_hands_a_mission_on_with_its_action_under_way(
    store: Store, tmp_path: Path
) -> None:
    queue_up(store, "m", tmp_path / "world", pace=0.05)
    with at_work(Worker(store, robot_for)):
        until(lambda: bool(deeds(tmp_path / "world", "m")))  # the robot has heard of it
    assert standing(store, "m").in_flight is not None
    assert place_of(store, "m") == (Standing.GOING, None, None)
    Worker(store, robot_for).run(until_done=True)
    assert standing(store, "m").status is Status.FINISHED
    assert all(deed.repeats == 0 for deed in deeds(tmp_path / "world", "m"))
    assert "action_resent" not in kinds(store, "m")


def test_a_paused_mission_stays_paused_when_it_is_taken_over_in_the_middle_of_an_action(
    store: Store, tmp_path: Path
) -> None:
    queue_up(store, "m", tmp_path / "world", pace=0.5)
    with at_work(Worker(store, robot_for)):
        until(lambda: "action_started" in kinds(store, "m"))
        ask_of(store, "m", PauseAsked("ada"), ())
    assert standing(store, "m").in_flight is not None
    Worker(store, robot_for).run(until_done=True)
    mission = standing(store, "m")
    assert (mission.status, mission.instant, mission.in_flight) == (Status.PAUSED, 1, None)


class Hanging:
    """A robot whose program hangs in the middle, as one that is swapped out does."""

    def __init__(self, robot: Robot, asleep: threading.Event, awake: threading.Event) -> None:
        self._robot, self._asleep, self._awake = robot, asleep, awake

    def __getattr__(self, name: str) -> Any:
        return getattr(self._robot, name)

    def wait(self, goal_id: str, timeout: Seconds) -> Any:
        self._asleep.set()
        assert self._awake.wait(20.0)
        return self._robot.wait(goal_id, timeout)


def test_a_worker_that_was_taken_for_dead_writes_nothing_and_sends_nothing_when_it_wakes(
    store: Store, store_url: str, tmp_path: Path
) -> None:
    asleep, awake = threading.Event(), threading.Event()

    @contextmanager
    def hanging(
        site: Site, set_up: Mapping[str, Any], entries: Sequence[Entry]
    ) -> Iterator[tuple[Robot, Patience]]:
        with robot_for(site, set_up, entries) as (robot, patience):
            yield Hanging(robot, asleep, awake), patience

    queue_up(store, "m", tmp_path / "world", pace=0.001)
    first = Worker(store, hanging, most=1)
    with at_work(first), open_store(store_url) as elsewhere:
        assert asleep.wait(10.0)
        with store.database.writing() as session:
            session.change("UPDATE place SET worker = NULL WHERE worker = ?", (first.shift.worker,))
        Worker(elsewhere, robot_for).run(until_done=True)
        written = store.entries("m")
        awake.set()
        until(lambda: not first._threads)
    assert standing(store, "m").status is Status.FINISHED
    assert store.entries("m") == written
    assert [deed.repeats for deed in deeds(tmp_path / "world", "m")] == [0, 0, 0, 0]


def test_of_two_who_hold_a_mission_the_slower_one_is_told(store: Store, tmp_path: Path) -> None:
    queue_up(store, "m", tmp_path / "world")
    one, two = Shift(store), Shift(store)
    one.begin()
    two.begin()
    held = one.take("m")
    assert held is not None
    held.entries()
    assert two.take("m") is None
    one.store.release(one.worker, "m", Standing.GOING)
    again = two.take("m")
    assert again is not None
    again.entries()
    again.record(0, [TakenUp("two")])
    with pytest.raises(OvertakenError):
        held.record(0, [Paused("one")])
    one.end()
    two.end()


def test_a_worker_whose_row_is_gone_begins_anew_and_goes_on(store: Store, tmp_path: Path) -> None:
    queue_up(store, "m", tmp_path / "world", pace=0.02)
    worker = Worker(store, robot_for)
    with at_work(worker):
        until(lambda: "action_started" in kinds(store, "m"))
        before = worker.shift.worker
        with store.database.writing() as session:
            session.change("DELETE FROM worker")
        until(lambda: worker.shift.worker != before)
        until(lambda: standing(store, "m").is_over)
    assert standing(store, "m").status is Status.FINISHED
    assert kinds(store, "m").count("taken_up") == 2
    assert all(deed.repeats == 0 for deed in deeds(tmp_path / "world", "m"))


def test_a_mission_that_breaks_off_rests_with_its_trouble_until_somebody_asks(
    store: Store, tmp_path: Path
) -> None:
    def broken(*_: object) -> AbstractContextManager[tuple[Robot, Patience]]:
        raise RuntimeError("no such gripper")

    queue_up(store, "m", tmp_path / "world")
    Worker(store, broken).run(until_done=True)
    assert place_of(store, "m") == (Standing.RESTING, None, "no such gripper")
    ask_of(store, "m", ResumeAsked("ada"), ())
    Worker(store, robot_for).run(until_done=True)
    assert standing(store, "m").status is Status.FINISHED


def test_what_no_version_of_ours_can_read_in_the_mailbox_is_passed_over(
    store: Store, tmp_path: Path
) -> None:
    queue_up(store, "m", tmp_path / "world")
    store.post("m", '{"ask": "dance"}')
    Worker(store, robot_for).run(until_done=True)
    assert standing(store, "m").status is Status.FINISHED


def test_a_mission_whose_goal_holds_already_is_over_before_a_worker_looks(
    store: Store, tmp_path: Path
) -> None:
    queue_up(store, "m", tmp_path / "world", goal="F robot_at_rob_wh", robot="rob")
    queue_up(store, "next", tmp_path / "world", robot="rob")
    place = store.place("m")
    assert place is not None
    assert place.standing is Standing.OVER
    assert standing(store, "m").status is Status.FINISHED
    assert store.ahead_of("next") == ()
    with pytest.raises(PlainspokenError, match="it is over"):
        store.post("m", "{}")
