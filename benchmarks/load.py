"""Many missions on many robots over several workers: how fast, how soon a pause is heard.

    python benchmarks/load.py [--missions 200] [--robots 20] [--actions 6] [--seconds 0.3]

Missions of one robot wait for each other; each action takes so many real seconds on average.
1. PostgreSQL: three worker processes carry all missions out, and one of them is killed half-way.
   All have to be finished and intact (see crash.py), and no robot may have two at a time. Meanwhile
   missions are paused and resumed from outside: from the asking until it is in the log.
2. PostgreSQL, a third of the missions, by one to four workers: missions a second, with actions that
   take their time and with actions that take none.
3. SQLite: twenty missions by two workers.
Exit status 1 where a mission went wrong or pauses are not heard within a second (95th percentile).
"""

from __future__ import annotations

import argparse
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from collections import Counter
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from random import Random

from fleet import Fleet, fleet, there_and_back

from plainspoken.cli.store import open_store
from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.queue import Standing
from plainspoken.knowledge.store import Store
from plainspoken.mission.mailbox import to_message
from plainspoken.mission.observation import PauseAsked, ResumeAsked

HEARD_WITHIN = 1.0
DEADLINE = 600.0


@dataclass
class Pauses:
    """Missions paused and resumed from outside, one after the other, while workers are at it."""

    crew: Fleet
    seconds: list[float] = field(default_factory=list)
    _stop: threading.Event = field(default_factory=threading.Event)

    def run(self) -> None:
        chance = Random(1)
        with open_store(self.crew.url) as store:
            while not self._stop.wait(0.1):
                at_work = [
                    place.mission
                    for place in store.places()
                    if place.worker is not None and place.standing is Standing.GOING
                ]
                if not at_work:
                    continue
                mission = chance.choice(at_work)
                since = len(store.links(mission))
                try:
                    store.post(mission, to_message(PauseAsked("load")))
                    asked = time.monotonic()
                    while not (ended := paused_or_over(store, mission, since)):
                        time.sleep(0.005)
                    if ended == "paused":
                        self.seconds.append(time.monotonic() - asked)
                    store.post(mission, to_message(ResumeAsked("load")))
                except PlainspokenError:
                    continue  # it was over before it heard

    def stop(self) -> None:
        self._stop.set()


def paused_or_over(store: Store, mission: str, since: int) -> str | None:
    """Which of both is in the log since a step; None while it is neither."""
    if any(entry.kind == "paused" for entry in store.entries(mission, since)):
        return "paused"
    place = store.place(mission)
    return "over" if place is None or place.standing is Standing.OVER else None


def queue_up(crew: Fleet, missions: int, robots: int, goal: str, seconds: float) -> dict[str, str]:
    """Missions for robots in turn; gives whose each is."""
    whose = {f"m{number}": f"robot {number % robots}" for number in range(missions)}
    for mission, robot in whose.items():
        crew.queue_up(mission, robot, goal, action_seconds=seconds)
    return whose


def over(crew: Fleet) -> int:
    return sum(place.standing is Standing.OVER for place in crew.store.places())


def wait_until_over(crew: Fleet, missions: int) -> None:
    deadline = time.monotonic() + DEADLINE
    while over(crew) < missions:
        if time.monotonic() > deadline:
            sys.exit(f"only {over(crew)} of {missions} missions are over after {DEADLINE:.0f} s")
        time.sleep(0.05)


def end(workers: list[subprocess.Popen[str]]) -> None:
    for worker in workers:
        worker.terminate()
    for worker in workers:
        worker.wait()


def wrong(crew: Fleet, whose: dict[str, str]) -> Counter[str]:
    """What is wrong with missions that should be over."""
    found = Counter[str]()
    times: dict[str, list[tuple[float, float]]] = {}
    for mission, robot in whose.items():
        found.update(crew.faults(mission, robot))
        told = crew.deeds(mission, robot)
        if told:
            times.setdefault(robot, []).append((told[0].begins, told[-1].ends))
    for spans in times.values():
        found["a robot had two missions at a time"] += sum(
            later[0] < earlier[1] for earlier, later in pairwise(sorted(spans))
        )
    return +found


def started(crew: Fleet, count: int) -> list[subprocess.Popen[str]]:
    """Workers, once they all wait for missions."""
    before = len(crew.store.workers())
    workers = [quiet(crew) for _ in range(count)]
    while len(crew.store.workers()) < before + count:
        time.sleep(0.02)
    return workers


def quiet(crew: Fleet) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "plainspoken", "work", "--store", crew.url]
    return subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, text=True
    )


def held_by(crew: Fleet, process: int | None) -> set[str]:
    """The missions that a process carries out; None: those that nobody does."""
    return {
        place.mission
        for place in crew.store.places()
        if (place.worker is None if process is None else f"-{process}-" in (place.worker or ""))
        and place.standing is not Standing.OVER
    }


def with_one_killed(options: argparse.Namespace, folder: Path) -> bool:
    goal = there_and_back(options.actions)
    with fleet("postgresql", folder) as crew:
        workers = started(crew, 3)
        began = time.monotonic()
        whose = queue_up(crew, options.missions, options.robots, goal, options.seconds)
        pauses = Pauses(crew)
        asking = threading.Thread(target=pauses.run)
        asking.start()
        while over(crew) < options.missions // 2:
            time.sleep(0.05)
        workers[0].kill()
        killed, orphans = time.monotonic(), held_by(crew, workers[0].pid)
        while orphans & (held_by(crew, workers[0].pid) | held_by(crew, None)):
            time.sleep(0.01)
        taken_over = time.monotonic() - killed
        wait_until_over(crew, options.missions)
        took = time.monotonic() - began
        pauses.stop()
        asking.join()
        end(workers)
        found = wrong(crew, whose)
    p95 = statistics.quantiles(pauses.seconds, n=20)[-1]
    print(
        f"PostgreSQL, 3 workers, one killed half-way: {options.missions} missions on"
        f" {options.robots} robots in {took:.1f} s, {options.missions / took:.1f} a second;"
        f" its {len(orphans)} missions were taken over within {taken_over:.2f} s"
    )
    print(
        f"  {len(pauses.seconds)} pauses, heard after {statistics.median(pauses.seconds):.2f} s"
        f" (median), {p95:.2f} s (95th percentile), {max(pauses.seconds):.2f} s (most)"
    )
    print(f"  wrong: {dict(found) or 'nothing'}", flush=True)
    return not found and p95 < HEARD_WITHIN


def rate(kind: str, workers: int, missions: int, options: argparse.Namespace) -> bool:
    """Missions a second by so many workers, from their start."""
    goal, seconds = there_and_back(options.actions), options.seconds
    with tempfile.TemporaryDirectory() as folder, fleet(kind, Path(folder) / "fleet") as crew:
        whose = queue_up(crew, missions, options.robots, goal, seconds)
        began = time.monotonic()
        processes = started(crew, workers)
        wait_until_over(crew, missions)
        took = time.monotonic() - began
        end(processes)
        found = wrong(crew, whose)
    print(
        f"{kind}, {workers} workers, actions of {seconds:g} s: {missions} missions in {took:.1f} s,"
        f" {missions / took:.1f} a second; wrong: {dict(found) or 'nothing'}",
        flush=True,
    )
    return not found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--missions", type=int, default=200)
    parser.add_argument("--robots", type=int, default=20)
    parser.add_argument("--actions", type=int, default=6)
    parser.add_argument("--seconds", type=float, default=0.3, help="an action, on average")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        good = [with_one_killed(options, Path(folder) / "fleet")]
    some = max(options.robots, options.missions // 3)
    good += [rate("postgresql", count, some, options) for count in (1, 2, 3, 4)]
    good.append(rate("sqlite", 2, 20, options))
    options.seconds = 0.0
    good += [rate("postgresql", count, some, options) for count in (1, 2, 3, 4)]
    sys.exit(not all(good))


if __name__ == "__main__":
    main()
