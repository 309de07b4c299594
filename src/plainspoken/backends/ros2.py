"""Robots over ROS 2: actions with feedback and cancellation, services, and topics to look at.

    ros2: {namespace: /rob, silence: 5}
    services:
      drive: {via: ros2, action: navigate_to_pose, type: nav2_msgs/action/NavigateToPose}
      grip: {via: ros2, service: gripper, type: std_srvs/srv/SetBool, succeeds: {success: true}}
      battery: {via: ros2, topic: battery, type: sensor_msgs/msg/BatteryState}

The fields of a call are those of the goal or request, checked against the type before anything
moves. `/{h}/drive` as a name takes the field `h`, for a robot in a name space of its own.
"""

from __future__ import annotations

import threading
import time
from dataclasses import dataclass
from typing import Any

from plainspoken.backends.activities.adapter import COMMON, Around
from plainspoken.backends.activities.document import Section, Value
from plainspoken.backends.activities.journal import Journal
from plainspoken.backends.ros2_action import ActionService
from plainspoken.backends.ros2_client import NamedClients, Node
from plainspoken.backends.ros2_message import MessageError, fields_of, type_of
from plainspoken.mission.robot import Seconds, Unreachable
from plainspoken.mission.service import CallId, CallStatus, Done, Fields, Going, NotDone, Service

GET_IT = "pip install 'plainspoken[ros2]', or source a ROS 2 installation whose Python this is"
SILENCE: Seconds = 5.0
"""After how long without a sign of life a server counts as lost, where nobody says."""
DISCOVERY: Seconds = 3.0
"""How long a server may take to be discovered, where nobody says."""
TIMEOUT: Seconds = 30.0
"""How long a ROS service may take to answer, where nobody says."""


def open_adapter(settings: Section | None, around: Around) -> Ros2Adapter:
    """A node of our own, with what the file says under `ros2`.

    raises ImportError: when there is no ROS 2 for this Python
    """
    namespace, name, domain = "", "plainspoken", None
    silence, discovery = SILENCE, DISCOVERY
    if settings is not None:
        settings.only("namespace", "node", "domain", "silence", "discovery")
        namespace = settings.text("namespace") or ""
        name = settings.text("node") or name
        silence = settings.positive("silence", SILENCE)
        discovery = settings.positive("discovery", DISCOVERY)
        given = settings.get("domain")
        domain = None if given is None else int(given.number())
    try:
        import rclpy
    except ImportError as error:
        raise ImportError(f"{error}; {GET_IT}") from error
    context = rclpy.context.Context()
    signals = rclpy.signals.SignalHandlerOptions.NO  # Ctrl-C is ours: it pauses the mission
    rclpy.init(args=[], context=context, domain_id=domain, signal_handler_options=signals)
    node = rclpy.create_node(name, namespace=namespace, context=context)
    executor = rclpy.executors.SingleThreadedExecutor(context=context)
    executor.add_node(node)
    spinning = threading.Thread(target=executor.spin, name="ros2 robot", daemon=True)
    spinning.start()
    return Ros2Adapter(node, executor, context, spinning, silence, discovery, around.journal)


@dataclass
class Ros2Adapter:
    """Makes services that share a node, which a thread of its own spins."""

    node: Any
    executor: Any
    context: Any
    spinning: threading.Thread
    silence: Seconds
    discovery: Seconds
    journal: Journal

    def service(self, settings: Section) -> Service:
        kinds = [kind for kind in ("action", "service", "topic") if kind in settings]
        if len(kinds) != 1:
            raise settings.at.error("one of action, service and topic says what is called")
        kind = kinds[0]
        settings.only(*COMMON, kind, "type", *(("timeout",) if kind == "service" else ()))
        name = settings.entries[kind].text()
        type = _type(
            settings.need("type", f"the {kind}'s type, such as package/{_KIND[kind]}/Name"), kind
        )
        match kind:
            case "action":
                return ActionService(self, name, type, settings.text("reason"))
            case "service":
                return CallService(self, name, type, settings.positive("timeout", TIMEOUT))
            case _:
                return TopicService(self, name, type)

    def close(self) -> None:
        self.executor.shutdown(timeout_sec=2.0)
        self.spinning.join(timeout=2.0)
        self.node.destroy_node()
        self.context.try_shutdown()


_KIND = {"action": "action", "service": "srv", "topic": "msg"}


def _type(value: Value, kind: str) -> Any:
    try:
        return type_of(value.text(), _KIND[kind])
    except MessageError as error:
        raise value.error(error.what, error.hint) from error


class CallService(NamedClients):
    """A ROS service: one answer, which nobody can be asked for again."""

    def __init__(self, adapter: Node, name: str, type: Any, timeout: Seconds) -> None:
        self._type = type
        self._timeout = timeout
        self._calls: dict[CallId, tuple[Any, Seconds]] = {}
        super().__init__(adapter, name, type.Request)

    def begin(self, call: CallId, fields: Fields) -> None:
        if call in self.ended or call in self._calls:
            return
        begun = self.begun(call, fields)
        if begun is None:
            return
        client, message = begun
        self._calls[call] = client.call_async(message), time.monotonic() + self._timeout

    def status(self, call: CallId) -> CallStatus:
        if call not in self.ended and call in self._calls:
            future, until = self._calls[call]
            if future.done():
                self.ended[call] = Done(fields_of(future.result()))
            elif time.monotonic() > until:
                self.ended[call] = NotDone(
                    f"no answer from {self.name} in {self._timeout:g} s: "
                    "it is not known whether it was done"
                )
            else:
                return Going({}, heard=False)
        unknown = NotDone("it is not known whether it was done: nobody waited for the answer")
        return self.ended.get(call, unknown)

    def cancel(self, call: CallId) -> None:
        """A ROS service cannot be cancelled; its answer is waited for."""

    def made(self, name: str) -> Any:
        return self.adapter.node.create_client(self._type, name)

    def is_ready(self, client: Any) -> bool:
        return bool(client.service_is_ready())


class TopicService:
    """The last message of a topic, for what is to be seen; a call changes nothing."""

    def __init__(self, adapter: Node, name: str, type: Any) -> None:
        self._name = name
        self._last: Any = None
        self._subscription = adapter.node.create_subscription(type, name, self._hear, 10)

    def objection(self, fields: Fields) -> str | None:
        return "a topic is only looked at: it takes no fields" if fields else None

    def begin(self, call: CallId, fields: Fields) -> None: ...

    def status(self, call: CallId) -> CallStatus:
        return Going({}) if self._last is None else Done(fields_of(self._last))

    def cancel(self, call: CallId) -> None: ...

    def reach(self) -> None:
        if self._last is None:
            raise Unreachable(f"no message on {self._name} so far")

    def _hear(self, message: Any) -> None:
        self._last = message
