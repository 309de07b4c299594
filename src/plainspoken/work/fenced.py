"""A robot that hears nothing more from a process that may have lost its mission."""

from __future__ import annotations

import time
from collections.abc import Sequence

from plainspoken.mission.mission import GoalId
from plainspoken.mission.robot import GoalStatus, Robot, Seconds, UnderWay
from plainspoken.mission.sensing import LookId, Senser, Telling
from plainspoken.work.shift import TICK, Held
from plainspoken.world.domain import GroundAction, GroundAtom, State
from plainspoken.world.sense import Sense


class FencedRobot:
    """Asks before each command whether the mission is still in this process's hands.

    The log refuses what a process would write that was taken for dead. One that slept between its
    last entry and the command that the entry names has written already: it is stopped here.
    """

    def __init__(self, robot: Robot, held: Held) -> None:
        self._robot = robot
        self._held = held
        self._last: dict[GoalId, UnderWay] = {}

    def send(self, goal_id: GoalId, action: GroundAction) -> None:
        """Begin an action.

        raises LetGo: when this process was not heard of for as long as a lease lasts
        """
        self._held.check()
        self._robot.send(goal_id, action)

    def wait(self, goal_id: GoalId, timeout: Seconds) -> GoalStatus:
        """What became of a command; nothing new while it is in doubt whose the mission is.

        An activity of several calls begins the next one while it is waited for.
        """
        if self._held.is_in_doubt:
            time.sleep(min(timeout, TICK))
            return self._last.get(goal_id, UnderWay())
        status = self._robot.wait(goal_id, timeout)
        if isinstance(status, UnderWay):
            self._last[goal_id] = status
        return status

    def cancel(self, goal_id: GoalId) -> None:
        self._held.check()
        self._robot.cancel(goal_id)

    def state(self) -> State:
        return self._robot.state()

    @property
    def senses(self) -> Sequence[Sense]:
        return self._robot.senses if isinstance(self._robot, Senser) else ()

    def unknown_at_first(self) -> State:
        return self._robot.unknown_at_first() if isinstance(self._robot, Senser) else frozenset()

    def sense(
        self, look: LookId, atoms: Sequence[GroundAtom], timeout: Seconds
    ) -> tuple[Telling, ...] | None:
        """What is told of facts; nothing new while it is in doubt whose the mission is."""
        if self._held.is_in_doubt:
            time.sleep(min(timeout, TICK))
            return None
        if not isinstance(self._robot, Senser):
            return tuple(Telling(atom, None, "nobody") for atom in atoms)
        return self._robot.sense(look, atoms, timeout)

    def dismiss(self, look: LookId) -> None:
        if isinstance(self._robot, Senser):
            self._robot.dismiss(look)
