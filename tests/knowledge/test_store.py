"""Who carries which mission out, and what is asked of it."""

import json
import sqlite3
import subprocess
import sys
import threading
import time
from contextlib import closing
from pathlib import Path

import pytest
from tests.mission.small_vineyard import accepted

from plainspoken.cli.store import open_store
from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.log import OvertakenError, SqliteLog
from plainspoken.knowledge.queue import LEASE, Standing
from plainspoken.knowledge.sqlite import m001_entries
from plainspoken.knowledge.store import Store
from plainspoken.logic.syntax import parse
from plainspoken.world.event import Paused, Resumed

GOAL = parse("F cleared_l0")


def begun(store: Store, mission: str, *robots: str, worker: str | None = None) -> None:
    store.begin(mission, "t", [accepted(GOAL, mission)], robots, worker)


def holder(store: Store, mission: str) -> str | None:
    place = store.place(mission)
    assert place is not None
    return place.worker


def silence(store: Store, worker: str, seconds: float) -> None:
    with store.database.writing() as session:
        session.change("UPDATE worker SET heard = heard - ? WHERE id = ?", (seconds, worker))


def test_of_two_who_write_the_same_step_the_second_is_refused(store: Store, store_url: str) -> None:
    begun(store, "m", "rob")
    with open_store(store_url) as other:
        other.append("m", "t", 0, [Paused("ada")], at=1)
        with pytest.raises(OvertakenError):
            store.append("m", "t", 0, [Resumed("bob"), Paused("bob")], at=1)
    assert [entry.kind for entry in store.entries("m")] == ["mission_accepted", "paused"]
    store.append("m", "t", 0, [Resumed("bob")], at=2)
    assert store.verify("m") is None


def test_of_many_who_race_for_each_step_exactly_one_writes_it(store: Store, store_url: str) -> None:
    begun(store, "m", "rob")
    won: list[int] = []

    def race(name: str) -> None:
        with open_store(store_url) as mine:
            for step in range(1, 30):
                try:
                    mine.append("m", "t", 0, [Paused(name)], at=step)
                except OvertakenError:
                    continue
                won.append(step)

    racers = [threading.Thread(target=race, args=(name,)) for name in "abc"]
    for racer in racers:
        racer.start()
    for racer in racers:
        racer.join()
    assert len(won) == len(set(won))
    assert [entry.step for entry in store.entries("m")] == [0, *sorted(won)]
    assert store.verify("m") is None


def test_a_mission_is_begun_with_its_place_or_not_at_all(store: Store) -> None:
    begun(store, "m", "rob")
    with pytest.raises(OvertakenError):
        begun(store, "m", "rob")
    assert len(store.places()) == len(store.entries("m")) == 1


def test_missions_of_one_robot_wait_for_each_other_and_those_of_another_do_not(
    store: Store,
) -> None:
    for mission, robot in [("m1", "rob"), ("m2", "rob"), ("m3", "sup")]:
        begun(store, mission, robot)
    store.enrol("w")
    assert store.claim("w", 5) == ("m1", "m3")
    assert store.claim("w", 5) == ()
    store.release("w", "m1", Standing.OVER)
    assert store.claim("w", 5) == ("m2",)


def test_a_mission_of_two_robots_waits_for_both_and_keeps_both(store: Store) -> None:
    for mission, robots in [("m1", "ab"), ("m2", "bc"), ("m3", "c"), ("m4", "d")]:
        begun(store, mission, *robots)
    store.enrol("w")
    assert store.claim("w", 5) == ("m1", "m4")
    store.release("w", "m1", Standing.OVER)
    assert store.claim("w", 5) == ("m2",)
    store.release("w", "m2", Standing.OVER)
    assert store.claim("w", 5) == ("m3",)


def test_two_workers_never_have_one_mission(store: Store) -> None:
    for number in range(4):
        begun(store, f"m{number}", f"rob{number}")
    store.enrol("v")
    store.enrol("w")
    assert store.claim("v", 3) == ("m0", "m1", "m2")
    assert store.claim("w", 3) == ("m3",)
    assert not store.claim_this("w", "m0")


def test_a_worker_that_is_not_heard_of_loses_its_missions(store: Store) -> None:
    begun(store, "m", "rob")
    store.enrol("v")
    store.enrol("w")
    store.claim("v", 1)
    silence(store, "v", 2.0)
    assert store.claim("w", 1) == (), "it may be slow"
    silence(store, "v", 2.0)
    assert store.claim("w", 1) == ("m",)
    assert not store.beat("v"), "it is told that it came too late"
    store.release("v", "m", Standing.OVER)
    assert holder(store, "m") == "w", "what it lost it cannot hand back"


WORKER = """
import sys, time
from plainspoken.cli.store import open_store
store = open_store(sys.argv[1])
store.enrol("v")
print(store.claim("v", 1), flush=True)
time.sleep(60)
"""


def test_the_missions_of_a_killed_process_are_free_at_once(store: Store, store_url: str) -> None:
    begun(store, "m", "rob")
    command = [sys.executable, "-c", WORKER, store_url]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert "m" in process.stdout.readline()
        store.enrol("w")
        assert store.claim("w", 1) == ()
        process.kill()
    killed = time.monotonic()
    while store.claim("w", 1) != ("m",):  # a server has to notice that a connection is closed
        assert time.monotonic() - killed < LEASE / 2, "it had to be waited for until it was late"
    assert store.workers() == ("w",)


def test_a_worker_that_was_heard_in_time_keeps_its_missions(store: Store) -> None:
    begun(store, "m", "rob")
    store.enrol("v")
    store.enrol("w")
    store.claim("v", 1)
    silence(store, "v", 60.0)
    assert store.beat("v")
    assert store.claim("w", 1) == ()


def test_a_worker_that_retires_hands_its_missions_back(store: Store) -> None:
    begun(store, "m", "rob")
    store.enrol("v")
    store.claim("v", 1)
    store.retire("v")
    store.enrol("w")
    assert store.claim("w", 1) == ("m",)


def test_nobody_takes_a_mission_without_being_a_worker(store: Store) -> None:
    begun(store, "m", "rob")
    assert store.claim("nobody", 1) == ()


def test_a_mission_at_rest_waits_for_a_message_and_keeps_its_robot(store: Store) -> None:
    begun(store, "m1", "rob")
    begun(store, "m2", "rob")
    store.enrol("w")
    store.claim("w", 1)
    store.release("w", "m1", Standing.RESTING)
    assert store.claim("w", 5) == ()
    store.post("m1", json.dumps({"ask": "resume", "by": "ada"}))
    assert store.claim("w", 5) == ("m1",)


def test_a_message_is_done_with_exactly_when_the_log_holds_what_it_led_to(store: Store) -> None:
    begun(store, "m", "rob")
    store.enrol("w")
    store.claim("w", 1)
    first, second = store.post("m", "first"), store.post("m", "second")
    assert [one.number for one in store.messages("w")] == [first, second]
    with pytest.raises(OvertakenError):
        store.append("m", "t", 0, [Paused("ada")], at=0, answered=first)
    assert [one.document for one in store.unanswered("m")] == ["first", "second"]
    store.append("m", "t", 0, [Paused("ada")], at=1, answered=first)
    assert [one.document for one in store.messages("w")] == ["second"]
    store.dismiss("m", second, 1)
    assert store.messages("w") == ()


def test_a_mission_of_an_older_store_has_no_place_until_somebody_asks_for_it(
    tmp_path: Path,
) -> None:
    path = tmp_path / "old.sqlite"
    with closing(sqlite3.connect(path)) as old:
        m001_entries(old)
        old.execute("PRAGMA user_version = 1")
    with SqliteLog(path) as log:
        log.append("m", "t", 0, [accepted(GOAL)])
    with open_store(str(path)) as store:
        store.enrol("w")
        assert store.missions() == ("m",)
        assert store.place("m") is None
        assert store.claim("w", 1) == ()
        store.enlist("m", ["rob"])
        assert store.claim("w", 1) == (), "nobody asked for anything yet"
        store.post("m", "anything")
        assert store.claim("w", 1) == ("m",)


def test_nothing_is_asked_of_a_mission_that_is_over(store: Store) -> None:
    begun(store, "m", "rob")
    store.enrol("w")
    store.claim("w", 1)
    store.release("w", "m", Standing.OVER)
    for mission in ("m", "unknown"):
        with pytest.raises(PlainspokenError, match="over"):
            store.post(mission, "anything")
