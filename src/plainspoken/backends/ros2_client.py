"""What ROS 2 actions and services have in common: clients by name, and servers to be found."""

from __future__ import annotations

import time
from typing import Any, Protocol

from plainspoken.backends.activities.journal import Journal
from plainspoken.backends.ros2_message import MessageError, message_of, objection
from plainspoken.mission.robot import Seconds, Unreachable
from plainspoken.mission.service import CallId, Done, Fields, NotDone
from plainspoken.mission.template import filled, paths_in

_NAME = "ros2 name"


class Node(Protocol):
    """The node that clients belong to, and what goes with it.

    silence:   after how long without a sign of life a server counts as lost
    discovery: how long a server may take to be discovered before it counts as not there
    """

    node: Any
    silence: Seconds
    discovery: Seconds
    journal: Journal


class NamedClients:
    """Clients of one kind, by the name that a call's fields make of a template."""

    def __init__(self, adapter: Node, name: str, message: Any) -> None:
        self.adapter, self.name, self.message = adapter, name, message
        self.clients: dict[str, Any] = {}
        self.ended: dict[CallId, Done | NotDone] = {}
        self.named = frozenset(paths_in(name))
        if not self.named:
            self.client(name)  # so that it is discovered before it is needed

    def objection(self, fields: Fields) -> str | None:
        missing = sorted(self.named - set(fields))
        if missing:
            return f"the name {self.name} needs the fields {', '.join(missing)}"
        return objection(self.message, self.sent(fields))

    def sent(self, fields: Fields) -> dict[str, Any]:
        """The fields that go into the message."""
        return {key: value for key, value in fields.items() if key not in self.named}

    def begun(self, call: CallId, fields: Fields) -> tuple[Any, Any] | None:
        """The client and the message for a call that begins now; another process will find it.

        None where the fields do not fit, with which the call has ended
        raises Unreachable: when there is no server
        """
        try:
            message = message_of(self.message, self.sent(fields))
        except MessageError as error:
            self.ended[call] = NotDone(error.what)
            return None
        name = str(filled(self.name, fields))
        if self.named:
            self.adapter.journal.note(call, _NAME, name)
        client = self.client(name)
        self.needs(client)
        return client, message

    def again(self, call: CallId) -> Any | None:
        """The client of a call that was begun; None where its name was never noted."""
        name = self.adapter.journal.get(call, _NAME) if self.named else self.name
        return None if name is None else self.client(name)

    def client(self, name: str) -> Any:
        if name not in self.clients:
            self.clients[name] = self.made(name)
        return self.clients[name]

    def made(self, name: str) -> Any:
        raise NotImplementedError

    def is_ready(self, client: Any) -> bool:
        raise NotImplementedError

    def reach(self) -> None:
        for client in self.clients.values():
            self.needs(client)

    def needs(self, client: Any) -> None:
        """Wait for a server to be discovered.

        raises Unreachable: when there is none
        """
        until = time.monotonic() + self.adapter.discovery
        while not self.is_ready(client):
            if time.monotonic() > until:
                raise Unreachable(f"no server for {self.name}")
            time.sleep(0.01)
