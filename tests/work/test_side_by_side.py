"""Two robots at work at once, and the worker that commands them killed in the middle of it."""

import subprocess
import sys
from pathlib import Path

from tests.mission.two_robots import APART, PROBLEM, SITE, policy_for
from tests.work.workshop import finished_goals, kinds, standing, until

from plainspoken.knowledge.facts import facts_after
from plainspoken.knowledge.store import Store
from plainspoken.logic.formula import atoms
from plainspoken.logic.syntax import parse
from plainspoken.logic.trace import holds
from plainspoken.mission.executive import queued
from plainspoken.mission.kept_simulator import Deed, KeptSimulator
from plainspoken.mission.mission import Status
from plainspoken.pipeline import Request, accepted_as
from plainspoken.work.shift import robots_of
from plainspoken.world.symbol import resolve_all

WAIT = 90.0
PACE = 0.25
"""An action takes one to three seconds: long enough to be killed in the middle of two."""


def left(store: Store, world: Path) -> None:
    """Leave a mission of two robots to whichever worker comes."""
    names = ["cart", "fork"]
    robot = {"world": str(world), "pace": PACE, "names": names, "side_by_side": True}
    accepted = accepted_as(SITE, Request("m", parse(APART), robot=robot))
    store.begin("m", "t", queued(accepted, policy_for(APART)), robots_of(accepted))


def worker(url: str) -> "subprocess.Popen[bytes]":
    command = [sys.executable, "-m", "plainspoken", "work", "--store", url, "--until-done"]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def deeds(world: Path) -> tuple[Deed, ...]:
    return KeptSimulator(world, "m", PROBLEM).deeds()


def at_once(one: Deed, other: Deed) -> bool:
    return one.begins < other.ends and other.begins < one.ends


def test_killed_with_both_robots_at_work_both_are_found_again_and_neither_is_told_twice(
    store: Store, store_url: str, tmp_path: Path
) -> None:
    world = tmp_path / "world"
    left(store, world)
    first = worker(store_url)
    until(lambda: len(deeds(world)) == 2, WAIT)
    first.kill()
    first.wait()
    under_way = {goal.goal_id for goal in standing(store, "m").under_way}
    assert under_way == {"m/1", "m/2"}
    assert worker(store_url).wait(timeout=WAIT) == 0
    assert standing(store, "m").status is Status.FINISHED
    assert store.verify("m") is None
    told = deeds(world)
    assert at_once(told[0], told[1])
    assert {deed.goal_id for deed in told} == set(finished_goals(store, "m"))
    assert [deed.repeats for deed in told] == [0] * len(told)
    assert len(told) == 3
    assert "action_resent" not in kinds(store, "m")
    trace = facts_after(store.entries("m")).letters(resolve_all(atoms(parse(APART)), PROBLEM))
    assert holds(parse(APART), trace)
