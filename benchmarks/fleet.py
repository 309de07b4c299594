"""What crash.py and load.py share: missions, workers, and robots whose worlds are in files."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from postgres_server import new_database, server, why_not

from plainspoken.cli.store import open_store
from plainspoken.knowledge.store import Store
from plainspoken.logic.formula import Formula
from plainspoken.logic.syntax import parse
from plainspoken.mission.executive import queued
from plainspoken.mission.kept_simulator import Deed, KeptSimulator
from plainspoken.pipeline import Request, Site, accepted_as, bundled, find_policy, open_site
from plainspoken.planning.policy import Policy
from plainspoken.planning.solver import Solved
from plainspoken.world.event import ActionFinished, Entry, MissionEnded

USUAL_ACTION = 8.0
"""Simulated seconds that an action takes on average: `plainspoken.mission.simulator`."""


@dataclass(frozen=True)
class Fleet:
    """Missions in one store, and the folder of their robots' worlds."""

    url: str
    worlds: Path
    store: Store

    def queue_up(self, mission: str, robot: str, goal: str, *, action_seconds: float) -> None:
        """Leave a mission to the workers."""
        set_up = {
            "robot": "simulator",
            "names": [robot],
            "world": str(self.worlds / robot),
            "pace": action_seconds / USUAL_ACTION,
        }
        accepted = accepted_as(vineyard(), Request(mission, parse(goal), robot=set_up))
        self.store.begin(mission, "", queued(accepted, policy_for(parse(goal))), [robot])

    def worker(self, *options: str) -> subprocess.Popen[str]:
        """A worker in a process of its own, which prints every event."""
        command = [sys.executable, "-m", "plainspoken", "work", "--store", self.url, "--json"]
        return subprocess.Popen(
            [*command, *options], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )

    def deeds(self, mission: str, robot: str) -> tuple[Deed, ...]:
        """What the robot was told for a mission."""
        return KeptSimulator(self.worlds / robot, mission, vineyard().problem).deeds()

    def files(self, robot: str) -> list[Path]:
        """The SQLite files that a worker of a robot's mission writes to."""
        return [self.worlds / robot, *([] if "://" in self.url else [Path(self.url)])]

    def faults(self, mission: str, robot: str) -> list[str]:
        """What is wrong with a mission that should be over; nothing, one hopes."""
        entries = self.store.entries(mission)
        found = []
        ended = entries[-1].event
        if not isinstance(ended, MissionEnded) or not ended.satisfied:
            found.append(f"it ended with {entries[-1].kind}")
        broken = self.store.verify(mission)
        if broken is not None:
            found.append(f"its chain is broken at step {broken.step}")
        told = self.deeds(mission, robot)
        if any(deed.repeats for deed in told):
            found.append("a command was sent again, though the robot had heard it")
        if [deed.goal_id for deed in told] != finished(entries):
            found.append("the robot did other things than the log tells")
        return found


def finished(entries: tuple[Entry, ...]) -> list[str]:
    """The goal ids of the actions that a log says were done, in order."""
    return [e.event.goal_id for e in entries if isinstance(e.event, ActionFinished)]


@cache
def vineyard() -> Site:
    folder = bundled("vineyard")
    return open_site(folder / "domain.pddl", folder / "problem.pddl", folder / "landmarks.json")


@cache
def policy_for(goal: Formula) -> Policy:
    ending = find_policy(vineyard().problem, goal)
    if not isinstance(ending, Solved):
        sys.exit("there is no policy for the mission of this benchmark")
    return ending.policy


def there_and_back(actions: int) -> str:
    """A goal that takes so many actions, none of which can turn out otherwise."""
    stops = [f"robot_at_rob_l{1 - number % 2}" for number in range(actions)]
    return "".join(f"F({stop} & " for stop in stops) + "true" + ")" * actions


@contextmanager
def fleet(kind: str, folder: Path) -> Iterator[Fleet]:
    """An empty store, `sqlite` or `postgresql`, and no robots yet."""
    folder.mkdir(parents=True)
    if kind == "sqlite":
        url = str(folder / "store.sqlite")
        with open_store(url) as store:
            yield Fleet(url, folder / "worlds", store)
        return
    reason = why_not()
    if reason is not None:
        sys.exit(reason)
    with server() as running:
        url = new_database(running)
        with open_store(url) as store:
            yield Fleet(url, folder / "worlds", store)
