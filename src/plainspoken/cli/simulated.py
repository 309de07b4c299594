"""The simulated robot of a mission, as `run` sets it and `missions resume` finds it in the log."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from plainspoken.errors import PlainspokenError
from plainspoken.mission.fault import FaultyRobot, fault_from
from plainspoken.mission.kept_simulator import KeptSimulator
from plainspoken.mission.mission import Mission, MissionId, mission_from
from plainspoken.mission.robot import Robot, Seconds
from plainspoken.mission.run import Patience
from plainspoken.mission.simulator import Simulator, Steering, steering_from
from plainspoken.mission.veil import VeiledRobot, drawn
from plainspoken.pipeline import Site, accepted_of
from plainspoken.world.domain import GroundAction, Problem, State
from plainspoken.world.event import ActionFinished, Entry

PATIENT_SECONDS = 60.0
"""What an action may take, in simulated time, where faults strike and nobody says."""


@dataclass(frozen=True, slots=True)
class Settings:
    """What a log keeps of the robot; texts as they are given on the command line.

    names: missions that have a robot's name in common wait for each other
    world: the file that keeps the robot's world, None where it ends with the process
    """

    seed: int = 0
    steering: Sequence[str] = ()
    faults: Sequence[str] = ()
    limit: Seconds | None = None
    pace: float = 0.0
    names: Sequence[str] = ()
    world: str | None = None

    def to_json(self) -> dict[str, Any]:
        """The field `robot` of an accepted mission."""
        document: dict[str, Any] = {
            "robot": "simulator",
            "seed": self.seed,
            "steering": list(self.steering),
        }
        if self.faults:
            document["faults"] = list(self.faults)
        if self.limit is not None:
            document["action_timeout"] = self.limit
        if self.pace:
            document["pace"] = self.pace
        if self.names:
            document["names"] = list(self.names)
        if self.world is not None:
            document["world"] = self.world
        return document

    @classmethod
    def of(cls, document: Mapping[str, Any]) -> Settings:
        """Read what `to_json` wrote."""
        return cls(
            document.get("seed", 0),
            document.get("steering", ()),
            document.get("faults", ()),
            document.get("action_timeout"),
            document.get("pace", 0.0),
            document.get("names", ()),
            document.get("world"),
        )


def simulated(
    site: Site,
    settings: Settings,
    *,
    mission: MissionId,
    pace: float | None = None,
    entries: Sequence[Entry] = (),
) -> tuple[Robot, Patience]:
    """The robot of a mission with such a log so far, and what the mission is timed by.

    pace: None for the one in the settings
    raises PlainspokenError: when a wish or a fault cannot be read, or faults are to strike a robot
        whose world is kept in a file
    """
    steering = [steering_from(text, site.problem) for text in settings.steering]
    robot, patience = _seeing_all(
        site, settings, steering, mission=mission, pace=pace, entries=entries
    )
    if not site.problem.unknown or (entries and "senses" not in accepted_of(entries).robot):
        return robot, patience
    now = mission_from(entries) if entries else None
    veiled = VeiledRobot(
        robot,
        site.problem,
        belief=None if now is None else now.world,
        under_way={goal.goal_id: goal.action for goal in now.under_way} if now else {},
    )
    return veiled, patience


def _seeing_all(
    site: Site,
    settings: Settings,
    steering: Sequence[Steering],
    *,
    mission: MissionId,
    pace: float | None,
    entries: Sequence[Entry],
) -> tuple[Robot, Patience]:
    """A robot from which nothing is hidden."""
    problem = drawn(site.problem, settings.seed, steering)
    faults = tuple(fault_from(text) for text in settings.faults)
    pace = settings.pace if pace is None else pace
    if settings.world is not None:
        if faults:
            raise PlainspokenError(
                "no fault strikes a robot whose world is kept in a file",
                hint="leave out --fault or --world",
            )
        kept = KeptSimulator(
            settings.world, mission, problem, seed=settings.seed, steering=steering, pace=pace
        )
        return kept, Patience(action=lambda _: settings.limit)
    simulator = Simulator(
        problem,
        seed=settings.seed,
        steering=steering,
        state=_real(mission_from(entries), problem) if entries else None,
        history=list(_history(entries)),
        pace=pace,
    )
    if not faults:
        return simulator, Patience(action=lambda _: settings.limit)
    robot = FaultyRobot(problem, simulator, faults, seed=settings.seed)
    limit = settings.limit or PATIENT_SECONDS
    return robot, Patience(action=lambda _: limit, clock=lambda: robot.elapsed, sleep=robot.sleep)


def _real(now: Mission, problem: Problem) -> State:
    """The world of a mission: what it does not know is as chance decided at first."""
    unknown = now.lookout.unknown
    return (now.world - unknown) | (problem.initial & unknown)


def _history(entries: Sequence[Entry]) -> Iterable[tuple[State, GroundAction]]:
    """The actions that were carried out, each with the state it was done in."""
    before: State = frozenset()
    for entry in entries:
        if isinstance(entry.event, ActionFinished):
            yield before, entry.event.action
        before = getattr(entry.event, "state", before)
