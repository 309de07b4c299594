"""What becomes of missions when something goes wrong: every fault, many seeds, three domains.

    python benchmarks/faults.py [--seeds N] [--markdown]

A mission runs on a simulated robot that one kind of fault strikes, at three actions in ten, or
that all kinds strike. Time is simulated: an action may take 60 s, a robot is waited for 100 s. A
run ends finished (the request is met), stopped (with a reason), or, which would be a defect,
wrong: the verdict in the log is not what the plain semantics says of the recorded trace. A run
that does not end within a minute of real time counts as stuck.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

from plainspoken.knowledge.facts import facts_after
from plainspoken.logic.formula import Formula, atoms
from plainspoken.logic.syntax import parse
from plainspoken.logic.trace import holds
from plainspoken.mission.executive import accept
from plainspoken.mission.fault import STRIKES, Fault, FaultKind, FaultyRobot
from plainspoken.mission.mission import Limits
from plainspoken.mission.request import acceptance
from plainspoken.mission.run import Patience, run_mission
from plainspoken.mission.simulator import Simulator
from plainspoken.pipeline import Site, bundled, find_policy, open_site, replanner
from plainspoken.planning.policy import Policy
from plainspoken.planning.solver import Solved
from plainspoken.world.event import Entry, Event, MissionEnded
from plainspoken.world.symbol import resolve_all

GOALS = {
    "vineyard": "F cleared_l2 & F cleared_l0 & G(full_b -> F !full_b)",
    "warehouse": "F delivered_crate & G(battery_low_cart -> F !battery_low_cart)",
    "kitchen": "F(served_soup & !stove_on) & (!served_soup U seasoned_soup)",
}
STUCK_SECONDS = 60.0
PATIENCE = Patience(action=lambda _: 60.0, lost=100.0)

Mix = tuple[str, tuple[Fault, ...]]
MIXES: list[Mix] = [
    ("none", ()),
    *((str(kind), (Fault(kind, STRIKES),)) for kind in FaultKind),
    ("all of them", tuple(Fault(kind, 0.1) for kind in FaultKind)),
]


def run(site: Site, goal: Formula, policy: Policy, faults: tuple[Fault, ...], seed: int) -> str:
    """One mission: how it ended, in a word or two."""
    entries: list[Entry] = []

    def record(instant: int, events: Sequence[Event]) -> list[Entry]:
        new = [Entry(len(entries) + n, "", instant, event) for n, event in enumerate(events)]
        entries.extend(new)
        return new

    robot = FaultyRobot(site.problem, Simulator(site.problem, seed=seed), faults, seed=seed)
    accepted = acceptance(
        "m", site.problem, goal, domain_text=site.domain_text, problem_text=site.problem_text
    )
    start = accept(accepted, policy, Limits(revisits=100))
    going = run_mission(
        start,
        robot,
        record,
        replanner(site),
        patience=replace(PATIENCE, clock=lambda: robot.elapsed, sleep=robot.sleep),
    )
    began = time.monotonic()
    for _ in going:
        if time.monotonic() - began > STUCK_SECONDS:
            return "STUCK"
    ended = entries[-1].event
    if not isinstance(ended, MissionEnded):
        return "STUCK"
    trace = facts_after(entries).letters(resolve_all(atoms(goal), site.problem))
    if ended.satisfied != holds(goal, trace):
        return "WRONG"
    replans = sum(entry.kind == "policy_chosen" for entry in entries) - 1
    if ended.outcome == "finished":
        return "finished, planned again" if replans else "finished"
    return "stopped with a reason" if ended.reason else "WRONG"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--markdown", action="store_true", help="print a table for docs/results.md")
    options = parser.parse_args()
    columns = ("finished", "finished, planned again", "stopped with a reason", "WRONG", "STUCK")
    lines = [f"| domain | fault | {' | '.join(columns)} |", f"| --- | --- |{' ---: |' * 5}"]
    bad = 0
    for name, text in GOALS.items():
        folder = bundled(name)
        site = open_site(folder / "domain.pddl", folder / "problem.pddl", folder / "landmarks.json")
        goal = parse(text)
        ending = find_policy(site.problem, goal)
        if not isinstance(ending, Solved):
            sys.exit(f"{name}: no policy for {text}")
        for mix, faults in MIXES:
            found = Counter(
                run(site, goal, ending.policy, faults, seed) for seed in range(options.seeds)
            )
            bad += found["WRONG"] + found["STUCK"]
            lines.append(f"| {name} | {mix} | {' | '.join(str(found[c]) for c in columns)} |")
            if not options.markdown:
                print(f"{name:10} {mix:10} {dict(found)}", flush=True)
    if options.markdown:
        print("\n".join(lines))
    sys.exit(bad > 0)


if __name__ == "__main__":
    main()
