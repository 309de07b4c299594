"""Missions in a world that does not keep to its model, and what the log says of them in the end.

    python benchmarks/adversary.py [--runs 300] [--seed 0] [--markdown]

Each run draws a domain, a request, and an adversary: a mixture of robots that fail, hang, lie and
are lost, of actions that turn out as no outcome of the domain has it, of facts that change by
themselves, of people who act, report (truly or not), pause and resume, and of chance that is
unfair: of several outcomes the one that leads nowhere, for ever or so many times. Checked of every
run:
- it ends, in simulated time and within a minute of real time, in a named outcome: finished, or
  stopped with a reason; one whose luck is bad says so after so many tries;
- the final verdict in the log is what the plain semantics says of the recorded trace;
- so is what was known after each instant, and nothing that was said to be certain came otherwise;
- folded anew from its log, the mission is what it was.
Exit status 1 where any of that is not so.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from random import Random

from plainspoken.automata.verdict import Verdict
from plainspoken.knowledge.facts import facts_after
from plainspoken.logic.formula import Formula, atoms
from plainspoken.logic.syntax import parse
from plainspoken.logic.trace import holds
from plainspoken.mission.executive import accept, advance
from plainspoken.mission.fault import Fault, FaultKind, FaultyRobot, fluents_of
from plainspoken.mission.judgement import judgements
from plainspoken.mission.mission import Limits, Mission, mission_from
from plainspoken.mission.observation import Observation, PauseAsked, ResumeAsked, Told
from plainspoken.mission.request import acceptance
from plainspoken.mission.run import Patience, run_mission
from plainspoken.mission.simulator import Simulator
from plainspoken.pipeline import Site, bundled, find_policy, open_site, replanner
from plainspoken.planning.policy import Policy
from plainspoken.planning.solver import Solved
from plainspoken.world.event import Entry, Event, MissionEnded
from plainspoken.world.symbol import resolve_all

GOALS = {
    "vineyard": (
        "F cleared_l2 & F cleared_l0 & G(full_b -> F !full_b)",
        "F cleared_l1 & (!robot_at_rob_l3 W cleared_l1)",
        "F(cleared_l1 & F robot_at_rob_wh) & G !robot_at_rob_l2",
        "F cleared_l3 & G(harvest_grape_executed -> X drop_grape_executed)",
    ),
    "warehouse": (
        "F delivered_crate & G(battery_low_cart -> F !battery_low_cart)",
        "F delivered_crate & F delivered_drum & (!delivered_drum U delivered_crate)",
        "F delivered_carton & G !robot_at_cart_plug",
        "F(robot_at_cart_desk & X F robot_at_cart_bay) & F delivered_drum",
    ),
    "kitchen": (
        "F(served_soup & !stove_on) & (!served_soup U seasoned_soup)",
        "F served_soup & G(open_fridge -> F !open_fridge)",
        "F served_soup & F !open_fridge & (!stove_on W robot_at_rob_stove)",
    ),
}
TRIES = 25
"""After how many tries at one spot of a policy a mission of these gives up."""
STUCK_SECONDS = 60.0
PATIENCE = Patience(action=lambda _: 60.0, lost=100.0)


@cache
def site(name: str) -> Site:
    folder = bundled(name)
    return open_site(folder / "domain.pddl", folder / "problem.pddl", folder / "landmarks.json")


@cache
def policy_for(name: str, text: str) -> Policy:
    ending = find_policy(site(name).problem, parse(text))
    if not isinstance(ending, Solved):
        raise SystemExit(f"{name}: no policy for {text}")
    return ending.policy


@dataclass
class Drawn:
    """One run: what is asked for, and what goes wrong.

    faults:   how likely each is at each action; unlucky: how often chance is unfair, in all
    meddling: how likely a person does or says something between two looks
    """

    domain: str
    goal: str
    faults: tuple[Fault, ...]
    meddling: float
    chance: Random = field(repr=False)

    @classmethod
    def of(cls, seed: int) -> Drawn:
        chance = Random(f"adversary {seed}")
        domain = list(GOALS)[seed % len(GOALS)]
        goal = chance.choice(GOALS[domain])
        if chance.random() < 0.15:
            # Chance is unfair for ever: nothing but giving up helps.
            return cls(domain, goal, (Fault(FaultKind.UNLUCKY, 1.0),), 0.0, chance)
        kinds = chance.sample(list(FaultKind), chance.randint(1, 4))
        faults = tuple(Fault(kind, chance.choice((0.05, 0.15, 0.4))) for kind in kinds)
        return cls(domain, goal, faults, chance.choice((0.0, 0.0, 0.05, 0.2)), chance)


class People:
    """Who asks for things meanwhile: they report what is so or is not, pause, and resume."""

    def __init__(self, drawn: Drawn, robot: FaultyRobot) -> None:
        self._drawn, self._robot = drawn, robot
        self._fluents = fluents_of(site(drawn.domain).problem)

    def __call__(self) -> Observation | None:
        chance = self._drawn.chance
        if chance.random() >= self._drawn.meddling:
            return None
        if chance.random() < 0.3:
            return PauseAsked("ada")
        told = frozenset(chance.sample(self._fluents, 1))
        true = chance.random() < 0.5
        added, deleted = (told, frozenset[str]()) if true else (frozenset[str](), told)
        return Told("ada", "something that may be so", added, deleted)


@dataclass(frozen=True, slots=True)
class Ran:
    """How a run ended, and everything that was not as it has to be."""

    ending: str
    defects: tuple[str, ...]
    instants: int


def run(seed: int) -> Ran:
    """One mission against one adversary."""
    drawn = Drawn.of(seed)
    here = site(drawn.domain)
    goal = parse(drawn.goal)
    entries: list[Entry] = []

    def record(instant: int, events: Sequence[Event]) -> list[Entry]:
        new = [Entry(len(entries) + n, "", instant, event) for n, event in enumerate(events)]
        entries.extend(new)
        return new

    robot = FaultyRobot(here.problem, Simulator(here.problem, seed=seed), drawn.faults, seed=seed)
    accepted = acceptance(
        "m", here.problem, goal, domain_text=here.domain_text, problem_text=here.problem_text
    )
    limits = Limits(revisits=TRIES)
    start = accept(accepted, policy_for(drawn.domain, drawn.goal), limits)
    patience = replace(PATIENCE, clock=lambda: robot.elapsed, sleep=robot.sleep)
    began = time.monotonic()
    mission: Mission | None = None
    while mission is None or not mission.is_over:
        going = run_mission(
            start, robot, record, replanner(here), requests=People(drawn, robot), patience=patience
        )
        while True:
            try:
                next(going)
            except StopIteration as end:
                mission = end.value
                break
            if time.monotonic() - began > STUCK_SECONDS:
                return Ran("STUCK", ("it did not end",), facts_after(entries).trace[-1].instant)
        if mission is not None and not mission.is_over:  # paused: somebody goes on with it
            start = advance(mission_from(entries, limits), ResumeAsked("ada"))
    return judged(goal, entries, mission, limits, here)


def judged(
    goal: Formula, entries: Sequence[Entry], mission: Mission, limits: Limits, here: Site
) -> Ran:
    """What the plain semantics says of a run, beside what the log does."""
    ended = entries[-1].event
    defects: list[str] = []

    def check(what: str, *, so: bool) -> None:
        if not so:
            defects.append(what)

    if not isinstance(ended, MissionEnded):
        return Ran("STUCK", ("the log does not end with mission_ended",), 0)
    trace = facts_after(entries).letters(resolve_all(atoms(goal), here.problem))
    true = holds(goal, trace)
    check("the final verdict is not that of the semantics", so=ended.satisfied == true)
    check("finished, and not satisfied", so=ended.outcome != "finished" or ended.satisfied)
    check("stopped without a reason", so=ended.outcome == "finished" or bool(ended.reason))
    check("the fold of the log is another mission", so=mission_from(entries, limits) == mission)
    met = (Verdict.SATISFIED, Verdict.HOLDS_SO_FAR)
    for each in judgements(entries):
        now = holds(goal, trace[: each.instant + 1])
        check(f"instant {each.instant}: {each.verdict}", so=(each.verdict in met) == now)
        if each.verdict in (Verdict.SATISFIED, Verdict.VIOLATED):
            check(f"certain at {each.instant}, and not so", so=(each.verdict in met) == true)
        for clause, verdict in each.clauses:
            so = holds(parse(clause), trace[: each.instant + 1])
            check(f"instant {each.instant}, {clause}: {verdict}", so=(verdict in met) == so)
    return Ran(_named(ended, entries), tuple(defects), len(trace) - 1)


REASONS: tuple[tuple[str, str], ...] = (
    ("no luck with", "no luck"),
    ("the request can no longer be met", "broken"),
    ("the robot failed", "robot failed"),
    ("did not come to an end", "action never ended"),
    ("the robot cannot be reached", "robot lost"),
    ("planned anew", "went astray too often"),
    ("the robot forgot", "robot forgot"),
)


def _named(ended: MissionEnded, entries: Sequence[Entry]) -> str:
    if ended.outcome == "finished":
        replans = sum(entry.kind == "policy_chosen" for entry in entries) - 1
        return "finished, planned again" if replans else "finished"
    for text, name in REASONS:
        if text in (ended.reason or ""):
            return f"stopped: {name}"
    return "stopped: no plan is left"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--runs", type=int, default=300)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--markdown", action="store_true", help="print a table for docs/results.md")
    options = parser.parse_args()
    found: Counter[tuple[str, str]] = Counter()
    instants, bad = 0, 0
    for seed in range(options.seed, options.seed + options.runs):
        ran = run(seed)
        instants += ran.instants
        found[Drawn.of(seed).domain, ran.ending] += 1
        if ran.defects:
            bad += 1
            drawn = Drawn.of(seed)
            print(f"seed {seed}: {drawn}: {ran.ending}", *ran.defects[:5], sep="\n  ", flush=True)
    _print_table(found, markdown=options.markdown)
    print(f"{options.runs} runs, {instants} instants; {bad} where the log and the semantics differ")
    sys.exit(bad > 0)


def _print_table(found: Counter[tuple[str, str]], *, markdown: bool) -> None:
    domains = list(GOALS)
    if markdown:
        print(f"| ending | {' | '.join(domains)} | all |\n| --- |{' ---: |' * (len(domains) + 1)}")
    for ending in sorted({ending for _, ending in found}):
        counts = [found[domain, ending] for domain in domains]
        cells = [str(count) for count in (*counts, sum(counts))]
        if markdown:
            print(f"| {ending} | {' | '.join(cells)} |")
        else:
            print(f"{ending:32} {' '.join(f'{cell:>10}' for cell in cells)}")


if __name__ == "__main__":
    main()
