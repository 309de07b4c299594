"""Missions to ask about: three domains, their policies and logs, built from entries alone."""

import json
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

from plainspoken.logic.syntax import parse
from plainspoken.planning.policy import Policy, PolicyNode
from plainspoken.planning.solver import Solved, solve
from plainspoken.world.domain import Problem
from plainspoken.world.event import (
    ActionFinished,
    ActionStarted,
    Entry,
    Event,
    MissionAccepted,
    MissionEnded,
    PolicyChosen,
)
from plainspoken.world.pddl import parse_domain, parse_problem
from plainspoken.world.scene import successors

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
DOMAINS = Path(__file__).resolve().parent / "domains"

WAREHOUSE = """
(define (domain warehouse)
  (:requirements :strips :typing :negative-preconditions :non-deterministic)
  (:types robot place package - object)
  (:predicates (at ?r - robot ?p - place) (lies-in ?x - package ?p - place)
    (holding ?r - robot ?x - package) (hands-free ?r - robot) (scanned ?x - package)
    (damaged ?x - package) (intact ?x - package) (door-open) (next-to ?a ?b - place))
  (:action drive :parameters (?r - robot ?from ?to - place)
    :precondition (and (at ?r ?from) (next-to ?from ?to))
    :effect (and (not (at ?r ?from)) (at ?r ?to)))
  (:action scan :parameters (?r - robot ?x - package ?p - place)
    :precondition (and (at ?r ?p) (lies-in ?x ?p) (not (scanned ?x)))
    :effect (and (scanned ?x) (oneof (damaged ?x) (intact ?x))))
  (:action pick-up :parameters (?r - robot ?x - package ?p - place)
    :precondition (and (at ?r ?p) (lies-in ?x ?p) (hands-free ?r) (scanned ?x))
    :effect (and (holding ?r ?x) (not (hands-free ?r)) (not (lies-in ?x ?p))))
  (:action put-down :parameters (?r - robot ?x - package ?p - place)
    :precondition (and (at ?r ?p) (holding ?r ?x) (door-open))
    :effect (and (lies-in ?x ?p) (hands-free ?r) (not (holding ?r ?x))))
  (:action open-door :parameters (?r - robot)
    :precondition (not (door-open))
    :effect (oneof (door-open) (and))))
"""
WAREHOUSE_PROBLEM = """
(define (problem two-packages) (:domain warehouse)
  (:objects robo - robot dock shelf1 shelf2 - place p1 p2 - package)
  (:init (at robo dock) (hands-free robo) (lies-in p1 shelf1) (lies-in p2 shelf2)
    (next-to dock shelf1) (next-to shelf1 dock) (next-to shelf1 shelf2) (next-to shelf2 shelf1))
  (:goal (and (lies-in p1 dock) (lies-in p2 dock))))
"""
KITCHEN = """
(define (domain kitchen)
  (:requirements :strips :typing :negative-preconditions :non-deterministic)
  (:types dish cupboard - object plate mug - dish)
  (:predicates (dirty ?d - dish) (clean ?d - dish) (broken ?d - dish) (on-table ?d - dish)
    (in ?d - dish ?c - cupboard) (running ?d - dish) (water-hot))
  (:action heat-water :parameters () :precondition (not (water-hot)) :effect (water-hot))
  (:action wash :parameters (?d - dish)
    :precondition (and (dirty ?d) (on-table ?d) (water-hot))
    :effect (oneof (and (not (dirty ?d)) (clean ?d)) (and) (not (water-hot))))
  (:action put-away :parameters (?d - dish ?c - cupboard)
    :precondition (and (clean ?d) (on-table ?d))
    :effect (and (in ?d ?c) (not (on-table ?d)))))
"""
KITCHEN_PROBLEM = """
(define (problem breakfast) (:domain kitchen)
  (:objects plate1 plate2 - plate red-mug - mug top-cupboard - cupboard)
  (:init (dirty plate1) (dirty plate2) (dirty red-mug) (on-table plate1) (on-table plate2)
    (on-table red-mug))
  (:goal (and (in plate1 top-cupboard) (in red-mug top-cupboard))))
"""


@dataclass(frozen=True)
class Setting:
    """A domain with a problem, its landmarks and a request."""

    name: str
    domain: str
    problem: str
    goal: str
    landmarks: str = "{}"

    @property
    def parsed(self) -> Problem:
        return parse_problem(self.problem, parse_domain(self.domain, "domain"), "problem")


def _example(name: str, goal: str, folder: Path = EXAMPLES) -> Setting:
    domain, problem = (
        (folder / name / f"{each}.pddl").read_text() for each in ("domain", "problem")
    )
    landmarks = folder / name / "landmarks.json"
    return Setting(
        name, domain, problem, goal, landmarks.read_text() if landmarks.exists() else "{}"
    )


VINEYARD = _example("vineyard", "F cleared_l0 & F cleared_l1 & F cleared_l2 & F cleared_l3")
AVOIDING = _example("vineyard", "F cleared_l0 & F cleared_l1 & G !robot_at_rob_l3")
TWO_LINES = _example("vineyard", "F cleared_l0 & F cleared_l1")
SETTINGS = {
    "vineyard": VINEYARD,
    "avoiding": AVOIDING,
    "warehouse": Setting(
        "warehouse",
        WAREHOUSE,
        WAREHOUSE_PROBLEM,
        "F lies_in_p1_dock & F(lies_in_p2_dock & hands_free_robo)",
    ),
    "kitchen": Setting(
        "kitchen", KITCHEN, KITCHEN_PROBLEM, "F in_plate1_top_cupboard & F in_red_mug_top_cupboard"
    ),
}


REACTING = _example(
    "vineyard",
    "F cleared_l2 & G(full_b -> !robot_at_rob_l3) & (full_b -> X call_support_executed)"
    " & G(!full_b & X full_b -> X X call_support_executed)",
)
FURTHER = {
    "reacting": REACTING,
    "depot": _example(
        "warehouse",
        "F delivered_crate & F delivered_drum & G(battery_low_cart -> F !battery_low_cart)"
        " & (!robot_at_cart_plug W delivered_crate)",
    ),
    "soup": _example("kitchen", "F served_soup & F !open_fridge"),
    "hospital": _example(
        "hospital",
        "F charted_adams & F charted_brown & F nurse_informed"
        " & (!robot_at_medi_room_2 U given_aspirin_adams)",
        DOMAINS,
    ),
    "reading_room": _example(
        "reading_room",
        "F shelved_atlas & F shelved_sonnets & G(torn_diary -> F mended_diary)",
        DOMAINS,
    ),
}
"""Settings that only some tests ask about."""


@cache
def policy_of(name: str) -> Policy:
    return _solved({**SETTINGS, **FURTHER}[name])


@cache
def _solved(setting: Setting) -> Policy:
    ending = solve(setting.parsed, parse(setting.goal))
    assert isinstance(ending, Solved)
    return ending.policy


def _by_rule(state: frozenset[str]) -> str | None:
    """What a plain worker would do in the vineyard: line 0, then line 1, then stop."""
    for number in (0, 1):
        line, grape = f"l{number}", f"g{number}"
        if f"cleared {line}" in state:
            continue
        if f"robot-at rob {line}" not in state:
            return f"move rob l{number - 1} {line}"
        if f"unchecked {grape}" in state:
            return f"check-grape rob {grape} {line}"
        if f"unknown {grape}" in state:
            return f"ask-human rob {grape} {line}"
        if f"in-hand {grape}" in state and "full b" not in state:
            return f"drop-grape rob {grape} b"
        if f"in-hand {grape}" in state and f"robot-at sup {line}" in state:
            return f"empty-box rob sup b {line} wh"
        if f"in-hand {grape}" in state:
            return f"call-support rob sup wh {line}"
        if f"ripe {grape}" in state and f"picked {grape}" not in state:
            return f"harvest-grape rob {grape} {line}"
        return f"sign-off rob {line}"
    return None


@cache
def written_policy() -> Policy:
    """A policy that no change of the solver changes, for answers that are compared word by word."""
    problem = TWO_LINES.parsed
    static = frozenset(accepted(TWO_LINES).static)
    ids = {problem.initial: 0}
    nodes = []
    for state in (todo := [problem.initial]):
        action = _by_rule(state)
        after = successors(problem, state, action) if action else ()
        for each in after:
            if each not in ids:
                ids[each] = len(ids)
                todo.append(each)
        there = tuple(ids[each] for each in after)
        nodes.append(PolicyNode(ids[state], state - static, action, there))
    return Policy("strong-cyclic", TWO_LINES.goal, 0, static, tuple(nodes))


def written_run(*wanted: str) -> tuple[Entry, ...]:
    """The log of the written policy where the wanted facts come about, else the first outcome.

    It ends with the action after the last wanted fact started.
    """
    policy, waiting = written_policy(), list(wanted)
    log = Log()
    log.add(accepted(TWO_LINES))
    log.add(PolicyChosen(policy.to_json()))
    node = policy.node(0)
    while node.action is not None:
        log.add(ActionStarted(node.action, node.id, f"goal-{log.instant}"))
        if not waiting:
            break
        outcomes = [policy.node(id) for id in node.successors]
        fitting = [each for each in outcomes if waiting[0] in each.state - node.state]
        after = (fitting or outcomes)[0]
        if fitting:
            waiting.pop(0)
        log.instant += 1
        log.add(ActionFinished(node.action, f"goal-{log.instant - 1}", after.state, after.id))
        node = after
    return tuple(log.entries)


def accepted(setting: Setting) -> MissionAccepted:
    problem = setting.parsed
    static = frozenset(
        atom for atom in problem.initial if atom.split()[0] not in problem.changing_predicates
    )
    more: dict[str, Any] = {"robot": {}}
    return MissionAccepted(
        mission="m",
        sentence=None,
        goal=setting.goal,
        english="",
        domain=setting.domain,
        problem=setting.problem,
        landmarks=json.loads(setting.landmarks),
        static=tuple(sorted(static)),
        state=problem.initial - static,
        **more,
    )


class Log:
    """Entries in the making, one a second."""

    def __init__(self) -> None:
        self.entries: list[Entry] = []
        self.instant = 0

    def add(self, event: Event) -> None:
        step = len(self.entries)
        time = f"2026-05-04T10:{step // 60 % 60:02d}:{step % 60:02d}Z"
        self.entries.append(Entry(step, time, self.instant, event))


def run(name: str, seed: int, most: int = 400) -> tuple[Entry, ...]:
    """The log of one execution of a setting's policy, outcomes drawn by the seed."""
    return run_of({**SETTINGS, **FURTHER}[name], seed, most)


def run_of(setting: Setting, seed: int, most: int = 400) -> tuple[Entry, ...]:
    """The same of a setting that has no place here."""
    policy = _solved(setting)
    chance = Random(seed)
    log = Log()
    log.add(accepted(setting))
    log.add(PolicyChosen(policy.to_json()))
    node = policy.node(policy.initial)
    while node.action is not None and log.instant < most:
        goal_id = f"goal-{log.instant}"
        log.add(ActionStarted(node.action, node.id, goal_id))
        after = policy.node(chance.choice(node.successors))
        log.instant += 1
        log.add(ActionFinished(node.action, goal_id, after.state, after.id))
        node = after
    if node.action is None:
        log.add(MissionEnded("finished", satisfied=True))
    return tuple(log.entries)
