"""A robot that hears nothing more from a process that may have lost its mission."""

from __future__ import annotations

from plainspoken.mission.mission import GoalId
from plainspoken.mission.robot import GoalStatus, Robot, Seconds
from plainspoken.work.shift import Held
from plainspoken.world.domain import GroundAction, State


class FencedRobot:
    """Asks before each command whether the mission is still in this process's hands.

    The log refuses what a process would write that was taken for dead. One that slept between its
    last entry and the command that the entry names has written already: it is stopped here.
    """

    def __init__(self, robot: Robot, held: Held) -> None:
        self._robot = robot
        self._held = held

    def send(self, goal_id: GoalId, action: GroundAction) -> None:
        """Begin an action.

        raises LetGo: when this process was not heard of for as long as a lease lasts
        """
        self._held.check()
        self._robot.send(goal_id, action)

    def wait(self, goal_id: GoalId, timeout: Seconds) -> GoalStatus:
        return self._robot.wait(goal_id, timeout)

    def cancel(self, goal_id: GoalId) -> None:
        self._held.check()
        self._robot.cancel(goal_id)

    def state(self) -> State:
        return self._robot.state()
