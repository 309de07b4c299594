"""The bundled warehouse: a cart and a forklift, with missions that both take part in."""

from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

from plainspoken.logic.syntax import parse
from plainspoken.mission.request import acceptance
from plainspoken.pipeline import bundled, find_policy, open_site
from plainspoken.planning.policy import Policy
from plainspoken.planning.solver import Solved
from plainspoken.world.event import Entry, Event, MissionAccepted

FOLDER = bundled("warehouse")
SITE = open_site(FOLDER / "domain.pddl", FOLDER / "problem.pddl", FOLDER / "landmarks.json")
PROBLEM = SITE.problem
APART = "F robot_at_cart_desk & F robot_at_fork_plug"
"""Two ways that have nothing to do with each other."""
GOALS = (
    APART,
    "F delivered_crate & F delivered_drum",
    "F(robot_at_cart_desk & F robot_at_cart_bay) & F(robot_at_fork_desk & F robot_at_fork_aisle_1)",
    "F robot_at_cart_plug & (!robot_at_cart_plug U robot_at_fork_aisle_3)",
    "F(robot_at_cart_desk & robot_at_fork_desk)",
    "F robot_at_fork_plug & G(robot_at_fork_aisle_3 -> X robot_at_cart_desk)",
    "F delivered_crate & G !(robot_at_cart_aisle_1 & robot_at_fork_aisle_1)",
    "F on_cart_crate & F on_floor_drum_aisle_2 & G(battery_low_cart -> F !battery_low_cart)",
    "F(drive_executed & X(drive_executed & X F robot_at_fork_aisle_3)) & F on_cart_crate",
)


@cache
def policy_for(goal: str) -> Policy:
    ending = find_policy(PROBLEM, parse(goal))
    assert isinstance(ending, Solved)
    return ending.policy


def accepted(goal: str, robot: Mapping[str, Any] | None = None) -> MissionAccepted:
    return acceptance(
        "m",
        PROBLEM,
        parse(goal),
        domain_text=SITE.domain_text,
        problem_text=SITE.problem_text,
        robot={"side_by_side": True} if robot is None else robot,
    )


class Recorder:
    """Keeps entries as a store does, and hands them out again."""

    def __init__(self) -> None:
        self.entries: list[Entry] = []

    def __call__(self, instant: int, events: Sequence[Event]) -> list[Entry]:
        new = [Entry(len(self.entries) + n, "t", instant, event) for n, event in enumerate(events)]
        self.entries += new
        return new
