"""Missions on simulated robots whose worlds are kept in files, and workers for them."""

import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

from tests.mission.small_vineyard import DOMAIN_TEXT, PROBLEM, PROBLEM_TEXT, policy_for

from plainspoken.knowledge.store import Store
from plainspoken.logic.syntax import parse
from plainspoken.mission.executive import queued
from plainspoken.mission.kept_simulator import Deed, KeptSimulator
from plainspoken.mission.mission import Mission, mission_from
from plainspoken.mission.robot import Robot
from plainspoken.mission.run import Patience
from plainspoken.pipeline import Request, Site, accepted_as, accepted_of
from plainspoken.planning.policy import Policy
from plainspoken.work.shift import robots_of
from plainspoken.work.worker import Worker
from plainspoken.world.event import ActionFinished, Entry

SITE = Site(PROBLEM, DOMAIN_TEXT, PROBLEM_TEXT)
THERE_AND_BACK = "F(robot_at_rob_l0 & F(robot_at_rob_wh & F(robot_at_rob_l0 & F robot_at_rob_wh)))"
"""Four actions, none of which can turn out otherwise."""


@cache
def policy(goal: str) -> Policy:
    return policy_for(parse(goal))


def queue_up(
    store: Store,
    mission: str,
    world: Path,
    *,
    robot: str | None = None,
    goal: str = THERE_AND_BACK,
    pace: float = 0.0,
) -> None:
    """Leave a mission to whichever worker comes."""
    set_up = {"world": str(world), "pace": pace, "names": [robot or mission]}
    accepted = accepted_as(SITE, Request(mission, parse(goal), robot=set_up))
    store.begin(mission, "t", queued(accepted, policy(goal)), robots_of(accepted))


@contextmanager
def robot_for(
    site: Site, set_up: Mapping[str, Any], entries: Sequence[Entry]
) -> Iterator[tuple[Robot, Patience]]:
    mission = accepted_of(entries).mission
    robot = KeptSimulator(set_up["world"], mission, site.problem, pace=set_up["pace"])
    yield robot, Patience(news=0.05)


def deeds(world: Path, mission: str) -> tuple[Deed, ...]:
    return KeptSimulator(world, mission, PROBLEM).deeds()


def finished_goals(store: Store, mission: str) -> list[str]:
    return [
        entry.event.goal_id
        for entry in store.entries(mission)
        if isinstance(entry.event, ActionFinished)
    ]


def kinds(store: Store, mission: str) -> list[str]:
    return [entry.kind for entry in store.entries(mission)]


def standing(store: Store, mission: str) -> Mission:
    return mission_from(store.entries(mission))


@contextmanager
def at_work(worker: Worker) -> Iterator[Worker]:
    """A worker on a thread of its own, which is stopped in the end."""
    thread = threading.Thread(target=worker.run, daemon=True)
    thread.start()
    try:
        yield worker
    finally:
        worker.stop()
        thread.join()


def until(so: Callable[[], bool], seconds: float = 60.0) -> None:
    deadline = time.monotonic() + seconds
    while not so():
        assert time.monotonic() < deadline, "waited for too long"
        time.sleep(0.02)
