"""Kill the worker of a mission, again and again, and see what became of the mission.

    python benchmarks/crash.py [--store sqlite|postgresql|both] [--missions 20] [--kills 3]

Each mission is of 40 actions, on a simulated robot whose world is kept in a file: it goes on while
nobody watches, and counts. Its worker is killed with SIGKILL: at a random moment, as soon as the
log says that an action was started, or as soon as the robot is done with one; then another worker
is started, and killed in its turn. In the end
- every mission is finished and satisfied, and the chain of its log is intact;
- the robot did exactly what the log tells, and heard no command twice;
- whatever a dead worker had printed, or a reader had seen in the log, is still there;
- and it is told how long it took from the start of a worker until it had the mission.
Then some workers are stopped (SIGSTOP), as a machine that swaps does it, and woken up once another
one has taken their mission over: they must not write or command anything.
Exit status 1 where any of that is not so.
"""

from __future__ import annotations

import argparse
import json
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from collections import Counter
from pathlib import Path
from random import Random

from fleet import Fleet, fleet, there_and_back
from processes import stop

ACTIONS = 40
ACTION_SECONDS = 0.02
RESUMED_WITHIN = 2.0
WAIT = 60.0
AIMS = ("at a random moment", "when the log says started", "when the robot is done")


class Life:
    """A worker from its start until it is killed, and what it printed."""

    def __init__(self, crew: Fleet, mission: str) -> None:
        self._crew, self._mission = crew, mission
        self._before = len(crew.store.links(mission))
        self.began = time.monotonic()
        self.process: subprocess.Popen[str] = crew.worker("--until-done")
        self.printed: list[str] = []
        self._reader = threading.Thread(target=self._read)
        self._reader.start()

    def _read(self) -> None:
        for line in self.process.stdout or ():
            if line.endswith("\n"):
                self.printed.append(line)

    def until_it_has_the_mission(self) -> float:
        """Seconds from the start until the log grows; killed later."""
        while len(self._crew.store.links(self._mission, self._before)) == 0:
            if self.process.poll() is not None or time.monotonic() - self.began > WAIT:
                break
            time.sleep(0.002)
        return time.monotonic() - self.began

    def is_over(self) -> bool:
        return self.process.poll() is not None

    def kill(self) -> None:
        self.process.kill()
        self.process.wait()
        self._reader.join()

    def ends(self) -> bool:
        try:
            return self.process.wait(timeout=WAIT) == 0
        except subprocess.TimeoutExpired:
            return False
        finally:
            self.kill()


def await_moment(crew: Fleet, mission: str, robot: str, life: Life, chance: Random) -> None:
    """Wait until it is time to kill."""
    aim = AIMS[chance.randrange(len(AIMS))]
    if aim == AIMS[0]:
        time.sleep(chance.uniform(0.0, 1.2))
        return
    seen = len(crew.store.links(mission))
    done = len(crew.deeds(mission, robot))
    skip = chance.randint(0, 10)
    while not life.is_over():
        if aim == AIMS[1]:
            new = crew.store.entries(mission, seen)
            if sum(entry.kind == "action_started" for entry in new) > skip:
                return
        elif sum(deed.status == "done" for deed in crew.deeds(mission, robot)) > done + skip:
            return
        time.sleep(0.001)


def where(crew: Fleet, mission: str, robot: str, killed: float) -> str:
    """What the kill came between; killed: when, by the system's clock."""
    last = crew.store.entries(mission)[-1]
    if last.kind != "action_started":
        return f"after {last.kind}"
    ends = {deed.goal_id: deed.ends for deed in crew.deeds(mission, robot)}
    end = ends.get(getattr(last.event, "goal_id", ""))
    if end is None:
        return "started, not sent"
    return "under way" if end > killed else "done, not recorded"


def run(crew: Fleet, mission: str, kills: int, chance: Random, found: Counter[str]) -> list[float]:
    """One mission through all its lives; counts what went wrong, gives seconds to resume."""
    robot = f"robot of {mission}"
    crew.queue_up(mission, robot, there_and_back(ACTIONS), action_seconds=ACTION_SECONDS)
    resumed, printed, seen = [], [], []
    for number in range(kills):
        life = Life(crew, mission)
        if number:
            resumed.append(life.until_it_has_the_mission())
        await_moment(crew, mission, robot, life, chance)
        life.kill()
        killed = time.time()
        printed += life.printed
        seen = [link.text for link in crew.store.links(mission)]
        found[f"killed {where(crew, mission, robot, killed)}"] += 1
    life = Life(crew, mission)
    resumed.append(life.until_it_has_the_mission())
    if not life.ends():
        found["WRONG: the last worker did not come to an end"] += 1
    printed += life.printed
    texts = [link.text for link in crew.store.links(mission)]
    if texts[: len(seen)] != seen:
        found["WRONG: an event that was there is lost"] += 1
    kept = {json.loads(text)["step"]: json.loads(text) for text in texts}
    for line in printed:
        event = json.loads(line)
        event.pop("mission")
        if kept.get(event["step"]) != event:
            found["WRONG: an event that was printed is lost"] += 1
    for fault in crew.faults(mission, robot):
        found[f"WRONG: {fault}"] += 1
    if len(crew.deeds(mission, robot)) != ACTIONS:
        found["WRONG: not forty actions"] += 1
    return resumed


def hang(crew: Fleet, mission: str, found: Counter[str]) -> float:
    """A worker that is taken for dead, and wakes up; gives seconds until it was taken for dead."""
    robot = f"robot of {mission}"
    crew.queue_up(mission, robot, there_and_back(ACTIONS), action_seconds=ACTION_SECONDS)
    sleeper = Life(crew, mission)
    sleeper.until_it_has_the_mission()
    time.sleep(0.3)
    stop(sleeper.process, *crew.files(robot))
    stopped, other = time.monotonic(), Life(crew, mission)
    other.until_it_has_the_mission()
    taken_over = time.monotonic() - stopped
    sleeper.process.send_signal(signal.SIGCONT)
    for life in (other, sleeper):
        if not life.ends():
            found["WRONG: a worker did not come to an end"] += 1
    found["stopped and woken up"] += 1
    for fault in crew.faults(mission, robot):
        found[f"WRONG: {fault}"] += 1
    return taken_over


def measured(kind: str, options: argparse.Namespace) -> bool:
    chance, found = Random(f"{options.seed}:{kind}"), Counter[str]()
    seconds: list[float] = []
    with tempfile.TemporaryDirectory() as folder, fleet(kind, Path(folder) / "fleet") as crew:
        for number in range(options.missions):
            seconds += run(crew, f"m{number}", options.kills, chance, found)
            print(f"\r{kind}: {number + 1} of {options.missions} missions", end="", flush=True)
        silent = [hang(crew, f"s{number}", found) for number in range(options.hangs)]
    print()
    for what, count in sorted(found.items()):
        print(f"  {count:4d}  {what}")
    late = sum(each > RESUMED_WITHIN for each in seconds)
    if seconds:
        print(
            f"  resumed after {statistics.median(seconds):.2f} s (median), {max(seconds):.2f} s"
            f" (most); {late} later than {RESUMED_WITHIN:.0f} s"
        )
    if silent:
        print(f"  a worker that hangs was replaced after {max(silent):.1f} s at most")
    return late == 0 and not any(what.startswith("WRONG") for what in found)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--store", choices=("sqlite", "postgresql", "both"), default="both")
    parser.add_argument("--missions", type=int, default=20)
    parser.add_argument(
        "--kills", type=int, default=3, help="how often each one's worker is killed"
    )
    parser.add_argument("--hangs", type=int, default=6, help="workers that are stopped and woken")
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    kinds = ("sqlite", "postgresql") if options.store == "both" else (options.store,)
    good = [measured(kind, options) for kind in kinds]
    sys.exit(not all(good))


if __name__ == "__main__":
    main()
