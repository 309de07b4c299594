"""Real ROS 2 servers in a process of their own, which may be stopped, killed and started again.

    python ros2_server.py FOLDER NAMESPACE

`drive` (test_msgs/action/Fibonacci) takes `order` steps of a twentieth of a second, tells the
sequence so far, refuses an order below 1 and aborts one above 1000. `look` (std_srvs/srv/Trigger)
says what it sees, in `message`; `grip` (std_srvs/srv/SetBool) refuses to open. The topic
`load` (test_msgs/msg/BasicTypes) tells a number.
What was begun and finished is in FOLDER/begun and FOLDER/done, one goal a line.
"""

from __future__ import annotations

import sys
import time
from contextlib import suppress
from pathlib import Path
from typing import Any

import rclpy
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from std_srvs.srv import SetBool, Trigger
from test_msgs.action import Fibonacci
from test_msgs.msg import BasicTypes

STEP = 0.05


class Servers:
    """All of them, on one node."""

    def __init__(self, node: Any, folder: Path) -> None:
        self._folder = folder
        group = ReentrantCallbackGroup()
        self.drive = ActionServer(
            node,
            Fibonacci,
            "drive",
            self._drive,
            goal_callback=self._wanted,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
            callback_group=group,
        )
        node.create_service(Trigger, "look", self._look, callback_group=group)
        node.create_service(SetBool, "grip", self._grip, callback_group=group)
        self._load = node.create_publisher(BasicTypes, "load", 10)
        node.create_timer(0.1, self._tell_load, callback_group=group)

    def _wanted(self, goal: Any) -> GoalResponse:
        return GoalResponse.ACCEPT if goal.order > 0 else GoalResponse.REJECT

    def _drive(self, handle: Any) -> Any:
        self._note("begun", bytes(handle.goal_id.uuid).hex())
        told = Fibonacci.Feedback()
        result = Fibonacci.Result()
        for number in range(handle.request.order):
            if handle.request.order > 1000:
                handle.abort()
                return result
            if handle.is_cancel_requested:
                handle.canceled()
                return result
            told.sequence.append(number)
            result.sequence.append(number)
            handle.publish_feedback(told)
            time.sleep(STEP)
        self._note("done", bytes(handle.goal_id.uuid).hex())
        handle.succeed()
        return result

    def _look(self, _: Any, response: Any) -> Any:
        file = self._folder / "grape"
        response.success, response.message = True, file.read_text() if file.exists() else "ripe"
        return response

    def _grip(self, request: Any, response: Any) -> Any:
        response.success = request.data
        response.message = "closed" if request.data else "the gripper is stuck"
        return response

    def _tell_load(self) -> None:
        self._load.publish(BasicTypes(float32_value=0.5))

    def _note(self, name: str, line: str) -> None:
        with (self._folder / name).open("a") as file:
            file.write(line + "\n")


def main() -> None:
    """Serve until killed."""
    folder, namespace = Path(sys.argv[1]), sys.argv[2]
    rclpy.init(args=[])
    node = rclpy.create_node("robot", namespace=namespace)
    Servers(node, folder)
    executor = MultiThreadedExecutor(4)
    executor.add_node(node)
    (folder / "ready").touch()
    with suppress(ExternalShutdownException):
        executor.spin()


if __name__ == "__main__":
    main()
