"""A vineyard of one line and one grape, small enough to plan for by brute force."""

from pathlib import Path

from tests.mission.brute_force import solved

from plainspoken.logic.formula import Formula
from plainspoken.mission.request import acceptance
from plainspoken.mission.run import Heed
from plainspoken.planning.policy import Policy
from plainspoken.world.domain import State
from plainspoken.world.event import MissionAccepted
from plainspoken.world.pddl import parse_domain, parse_problem

DOMAIN_TEXT = (Path(__file__).parents[2] / "examples" / "vineyard" / "domain.pddl").read_text()
PROBLEM_TEXT = """
(define (problem one-line) (:domain vineyard)
  (:objects rob - harvester sup - support l0 - line wh - warehouse g0 - grape b - box)
  (:init (robot-at rob wh) (robot-at sup wh) (carries rob b) (hand-empty rob)
         (adjacent wh l0) (adjacent l0 wh) (grape-at g0 l0) (unchecked g0))
  (:goal (cleared l0)))
"""
DOMAIN = parse_domain(DOMAIN_TEXT, "vineyard")
PROBLEM = parse_problem(PROBLEM_TEXT, DOMAIN, "one line")


def accepted(goal: Formula, mission: str = "m") -> MissionAccepted:
    return acceptance(mission, PROBLEM, goal, domain_text=DOMAIN_TEXT, problem_text=PROBLEM_TEXT)


def policy_for(goal: Formula) -> Policy:
    policy = solved(PROBLEM, PROBLEM.initial, goal)
    assert policy is not None
    return policy


def replanned(state: State, remaining: Formula, heed: Heed = lambda: None) -> Policy | str:
    heed()
    return solved(PROBLEM, state, remaining) or "there is no policy"
