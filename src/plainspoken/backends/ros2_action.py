"""ROS 2 actions: goals that another process finds again, and servers that may be dead.

A goal's id is made of the call's, and what became of it is what the server says when it is asked
for its result; a server that was restarted does not know it. The graph notices a killed server
only after the 20 s lease of its discovery, so a server that has a goal is asked, every other
second, about one that it cannot have: it is alive if it says so.
"""

from __future__ import annotations

import time
import uuid
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from plainspoken.backends.ros2_client import NamedClients, Node
from plainspoken.backends.ros2_message import fields_of
from plainspoken.mission.robot import Seconds, Unheard, Unreachable
from plainspoken.mission.service import CallId, CallStatus, Done, Fields, Going, NotDone
from plainspoken.mission.template import UnfilledError, filled

PULSE: Seconds = 2.0
"""How often a server that has a goal is asked whether it is alive, and about the goal."""
_GOALS = uuid.UUID("5c1b3f0e-6f53-5d0f-9f0e-0d5a1c6f7a11")
"""The name space of goal ids: the same call has the same id in every process."""
_SUCCEEDED, _CANCELED, _ABORTED = 4, 5, 6
"""Of action_msgs/msg/GoalStatus; a goal that is not known has 0."""


@dataclass
class _Goal:
    """One goal as this process knows it.

    accepted: the server's word on it, where this process sent it
    answers:  to our asking for its result, of the last times
    pulse:    what we asked for a sign of life
    """

    client: Any
    handle: Any
    accepted: Any = None
    answers: list[Any] = field(default_factory=list)
    asked_at: Seconds = 0.0
    cancelling: bool = False
    feedback: Mapping[str, Any] = field(default_factory=dict)
    begun_at: Seconds = field(default_factory=time.monotonic)
    alive_at: Seconds = field(default_factory=time.monotonic)
    pulse: Any = None
    pulse_at: Seconds = 0.0

    @property
    def is_answered(self) -> bool:
        """Whether the server has said yes or no to it."""
        return self.accepted is not None and bool(self.accepted.done())

    @property
    def is_accepted(self) -> bool:
        return self.is_answered and bool(self.accepted.result().accepted)


class ActionService(NamedClients):
    """A ROS action: goals with feedback that can be cancelled."""

    def __init__(self, adapter: Node, name: str, type: Any, reason: str | None) -> None:
        """Set a service up. reason: how to read, from an aborted result, why; a template."""
        self._type = type
        self._reason = reason
        self._goals: dict[CallId, _Goal] = {}
        super().__init__(adapter, name, type.Goal)

    def begin(self, call: CallId, fields: Fields) -> None:
        if call in self.ended or call in self._goals:
            return
        begun = self.begun(call, fields)
        if begun is None:
            return
        client, message = begun
        goal = self._goals[call] = _Goal(client, self._handle(client, call))
        goal.accepted = client.send_goal_async(message, _hears(goal), goal.handle.goal_id)

    def status(self, call: CallId) -> CallStatus:
        if call in self.ended:
            return self.ended[call]
        goal = self._goals.get(call) or self._found(call)
        if goal is None:
            return Unheard()
        status = self._answered(call, goal)
        if status is not None:
            return status
        self._check_alive(goal)
        return Going(goal.feedback, heard=goal.is_accepted or bool(goal.feedback))

    def cancel(self, call: CallId) -> None:
        goal = self._goals.get(call) or self._found(call)
        if goal is not None and call not in self.ended:
            self.needs(goal.client)
            goal.cancelling = True
            goal.handle.cancel_goal_async()

    def reach(self) -> None:
        """Wait, not for long, for a sign of life of every server that has a goal."""
        super().reach()
        for goal in self._goals.values():
            pulse = self._handle(goal.client, "pulse").get_result_async()
            until = time.monotonic() + min(1.0, self.adapter.silence)
            while not pulse.done():
                if time.monotonic() > until:
                    raise Unreachable(f"no sign of life from {self.name}")
                time.sleep(0.01)
            goal.alive_at = time.monotonic()

    def made(self, name: str) -> Any:
        from rclpy.action import ActionClient

        return ActionClient(self.adapter.node, self._type, name)

    def is_ready(self, client: Any) -> bool:
        return bool(client.server_is_ready())

    def _found(self, call: CallId) -> _Goal | None:
        """A goal that another process sent; None where there can be none."""
        client = self.again(call)
        if client is None:
            return None
        self.needs(client)
        goal = self._goals[call] = _Goal(client, self._handle(client, call))
        # There is no public way to hear of a goal that another process sent.
        client._feedback_callbacks[bytes(goal.handle.goal_id.uuid)] = _hears(goal)  # noqa: SLF001 - as said above
        return goal

    def _answered(self, call: CallId, goal: _Goal) -> CallStatus | None:
        """What the server says became of a goal; None while it says nothing.

        A refusal is believed once the server does not know the goal: it refuses what it has, too.
        """
        now = time.monotonic()
        if goal.accepted is not None and not goal.is_answered and now - goal.begun_at < PULSE:
            return None  # a question might overtake the goal that it is about
        # A server that came back has not heard what its forerunner was asked: ask again.
        if not goal.answers or now - goal.asked_at > PULSE:
            goal.answers = [*goal.answers[-1:], goal.handle.get_result_async()]
            goal.asked_at = now
            if goal.cancelling:
                goal.handle.cancel_goal_async()
        answer = next((each.result() for each in goal.answers if each.done()), None)
        if answer is None:
            return None
        result = fields_of(answer.result)
        if answer.status == _SUCCEEDED:
            return self._end(call, Done(result))
        if answer.status == _CANCELED:
            return self._end(call, NotDone("cancelled"))
        if answer.status == _ABORTED:
            return self._end(call, NotDone(self._why(result)))
        if goal.is_answered and not goal.is_accepted:
            return self._end(call, NotDone(f"rejected by {self.name}"))
        del self._goals[call]
        return Unheard()

    def _check_alive(self, goal: _Goal) -> None:
        """Ask for a sign of life, now and then.

        raises Unreachable: when there was none for too long
        """
        now, silence = time.monotonic(), self.adapter.silence
        if goal.pulse is not None and goal.pulse.done():
            goal.pulse, goal.alive_at = None, now
        if goal.pulse is None and now - goal.pulse_at > min(PULSE, silence / 2):
            goal.pulse = self._handle(goal.client, "pulse").get_result_async()
            goal.pulse_at = now
        if now - goal.alive_at > silence or not self.is_ready(goal.client):
            goal.pulse = None
            raise Unreachable(f"no sign of life from {self.name}")

    def _handle(self, client: Any, call: CallId) -> Any:
        """What rclpy gives for an accepted goal; made here, since another process may have it."""
        from rclpy.action.client import ClientGoalHandle
        from unique_identifier_msgs.msg import UUID

        id = UUID(uuid=list(uuid.uuid5(_GOALS, call).bytes))
        return ClientGoalHandle(client, id, self._type.Impl.SendGoalService.Response())

    def _why(self, result: Fields) -> str:
        try:
            return str(filled(self._reason, result)) if self._reason else f"aborted: {dict(result)}"
        except UnfilledError:
            return f"aborted: {dict(result)}"

    def _end(self, call: CallId, status: Done | NotDone) -> CallStatus:
        self.ended[call] = status
        self._goals.pop(call, None)
        return status


def _hears(goal: _Goal) -> Any:
    def heard(message: Any) -> None:
        goal.feedback = fields_of(message.feedback)
        goal.alive_at = time.monotonic()

    return heard
