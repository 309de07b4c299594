"""What a robot offers, as the task manager's activities use it: calls that begin, go on and end.

A robot that is reached over some vendor's connection is a handful of services; an adapter in
`backends` makes one out of what a configuration says. An activity of one call or many makes a
robot's action out of them (`mission.activity`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Protocol

from plainspoken.mission.robot import Unheard

CallId = str
"""Names one call: the goal id, and which part of its activity for the how-manieth time."""
Fields = Mapping[str, Any]
"""What JSON or a message holds: texts, numbers, lists and mappings of them."""


@dataclass(frozen=True, slots=True)
class Going:
    """The call is under way; feedback is the last that was told of it.

    heard: whether the far end has said that it has the call; where it has not, and then says that
           it knows of none, the call may be made again
    """

    feedback: Fields
    heard: bool = True


@dataclass(frozen=True, slots=True)
class Done:
    """The call came to its end, and this is what it gave."""

    result: Fields


@dataclass(frozen=True, slots=True)
class NotDone:
    """The call was rejected, given up or cancelled, or what became of it cannot be known."""

    reason: str


CallStatus = Going | Done | NotDone | Unheard


class Service(Protocol):
    """One thing that can be asked of a robot, of a program or of a person.

    Each method but `objection` may raise Unreachable, and none waits for long.
    """

    def objection(self, fields: Fields) -> str | None:
        """What is wrong with the fields of a call, before any is made; None where nothing is.

        Templates stand in for values that are not known yet.
        """

    def begin(self, call: CallId, fields: Fields) -> None:
        """Begin a call, and return at once. An id heard before is ignored."""

    def status(self, call: CallId) -> CallStatus:
        """What became of a call, also of one that an earlier process began.

        `Unheard` only where it is certain that it was never begun, or forgotten without a trace:
        the caller knows which, if it was ever told that the call was under way.
        """

    def cancel(self, call: CallId) -> None:
        """Have a call given up, if possible; `status` says what became of it."""

    def reach(self) -> None:
        """Raise Unreachable where no call could be made now."""
