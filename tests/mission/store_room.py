"""The store room of the examples, in which doors, rooms and a parcel are not known at first."""

from collections.abc import Callable, Sequence
from pathlib import Path

from plainspoken.logic.syntax import parse
from plainspoken.mission.mission import Mission
from plainspoken.mission.observation import Observation
from plainspoken.mission.run import Patience, Record, heeding
from plainspoken.mission.simulator import Simulator, Steering
from plainspoken.mission.veil import VeiledRobot, drawn
from plainspoken.pipeline import Request, Site, carry_out, find_policy, open_site
from plainspoken.planning.solver import Solved
from plainspoken.world.event import Entry, Event, Instant

FOLDER = Path(__file__).parents[2] / "examples" / "store-room"
SITE = open_site(FOLDER / "domain.pddl", FOLDER / "problem.pddl")
GOAL = parse("F in_parcel_ramp")


class Kept:
    """A log in memory."""

    def __init__(self) -> None:
        self.entries: list[Entry] = []

    def record(self, instant: Instant, events: Sequence[Event]) -> Sequence[Entry]:
        new = [
            Entry(
                len(self.entries) + i, f"2026-11-22T10:00:{len(self.entries) + i:02d}Z", instant, e
            )
            for i, e in enumerate(events)
        ]
        self.entries += new
        return new


def veiled(seed: int = 0, steering: Sequence[Steering] = ()) -> tuple[VeiledRobot, Simulator]:
    """A robot that does not see everything, and the world behind the veil."""
    world = Simulator(drawn(SITE.problem, seed, steering), seed=seed)
    return VeiledRobot(world, SITE.problem), world


def carried_out(
    robot: VeiledRobot,
    *,
    goal: str = "F in_parcel_ramp",
    requests: Callable[[], Observation | None] = lambda: None,
    site: Site = SITE,
) -> tuple[Mission, list[Entry]]:
    """Carry a mission out to where it rests."""
    ending = find_policy(site.problem, parse(goal))
    assert isinstance(ending, Solved)
    kept = Kept()
    record: Record = heeding(robot, kept.record)
    request = Request("m", parse(goal)).knowing(robot)
    run = carry_out(
        site, request, ending.policy, robot, record, requests=requests, patience=Patience()
    )
    while True:
        try:
            next(run)
        except StopIteration as end:
            return end.value, kept.entries
