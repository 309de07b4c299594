"""A robot that hears nothing more from a process that may have lost its mission."""

from __future__ import annotations

import time

from plainspoken.mission.mission import GoalId
from plainspoken.mission.robot import GoalStatus, Robot, Seconds, UnderWay
from plainspoken.work.shift import TICK, Held
from plainspoken.world.domain import GroundAction, State


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
