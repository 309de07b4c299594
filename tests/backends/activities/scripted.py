"""An adapter for tests, by its dotted name in `via`: services do what a script says.

    services:
      arm: {via: tests.backends.activities.scripted, script: arm}

`SCRIPTS["arm"] = [Done({}), NotDone("jammed")]` is what its first and second call come to; a
number before an end is how often the call is still going when it is asked about.
"""

from __future__ import annotations

from collections.abc import Iterator

from plainspoken.backends.activities.adapter import COMMON, Around
from plainspoken.backends.activities.document import Section
from plainspoken.mission.robot import Unheard, Unreachable
from plainspoken.mission.service import CallId, CallStatus, Done, Fields, Going, NotDone

Script = list[Done | NotDone | int]
SCRIPTS: dict[str, Script] = {}
CALLED: list[tuple[str, Fields]] = []
"""Every call that was begun, by its script, in order."""
CANCELLED: list[str] = []
AWAY: set[str] = set()
"""Scripts whose services cannot be reached."""
SERVICES: dict[str, Scripted] = {}


class Scripted:
    """The far end of a service; it outlives the robots that use it."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.calls: dict[CallId, Iterator[CallStatus]] = {}
        self.ended: dict[CallId, CallStatus] = {}

    def objection(self, fields: Fields) -> str | None:
        return "there is no field 'colour'" if "colour" in fields else None

    def begin(self, call: CallId, fields: Fields) -> None:
        self.reach()
        if call not in self.calls:
            CALLED.append((self.name, fields))
            self.calls[call] = self._run()

    def status(self, call: CallId) -> CallStatus:
        self.reach()
        if call not in self.calls:
            return Unheard()
        if call not in self.ended:
            status = next(self.calls[call])
            if isinstance(status, Going):
                return status
            self.ended[call] = status
        return self.ended[call]

    def cancel(self, call: CallId) -> None:
        CANCELLED.append(self.name)
        self.ended.setdefault(call, NotDone("stopped half-way"))

    def reach(self) -> None:
        if self.name in AWAY:
            raise Unreachable(f"no answer from {self.name}")

    def _run(self) -> Iterator[CallStatus]:
        script = SCRIPTS.setdefault(self.name, [])
        while True:
            step = script.pop(0) if script else Done({})
            if not isinstance(step, int):
                yield step
                return
            for number in range(step):
                yield Going({"progress": number / step, "doing": f"{self.name} {number}"})


class Adapter:
    def service(self, settings: Section) -> Scripted:
        settings.only(*COMMON, "script")
        name = settings.need("script", "which script it follows").text()
        return SERVICES.setdefault(name, Scripted(name))

    def close(self) -> None: ...


def open_adapter(settings: Section | None, around: Around) -> Adapter:
    del settings, around  # a script needs nothing else
    return Adapter()


def named() -> list[str]:
    """The scripts of the calls that were begun."""
    return [name for name, _ in CALLED]
