"""What an adapter is: one file in `backends` that makes services out of settings.

`via: http` in a robots' file is the module `plainspoken.backends.http`; a name with dots is any
module that can be imported, so that an adapter may live elsewhere. The module has one function,
`open_adapter(settings, around)`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import Protocol, cast

from plainspoken.backends.activities.document import Section, Value, did_you_mean
from plainspoken.backends.activities.journal import Journal
from plainspoken.knowledge.store import Store
from plainspoken.mission.service import Service

COMMON = ("via", "succeeds", "reason", "progress", "doing", "limit")
"""Keys that every service may have, whatever the adapter; see `mission.repertoire.Offer`."""
BUNDLED = {
    "http": "plainspoken.backends.http",
    "ros2": "plainspoken.backends.ros2",
    "human": "plainspoken.backends.human",
    "mission": "plainspoken.backends.nested",
}


@dataclass(frozen=True)
class Around:
    """What an adapter finds around it.

    journal: keeps notes over the end of the process, for calls that are to be found again
    store:   where missions are, for services that have missions of their own
    via:     the adapter of services that do not name one
    """

    journal: Journal
    store: Store
    via: str | None = None


class Adapter(Protocol):
    """Makes services, and lets go of what it holds in the end."""

    def service(self, settings: Section) -> Service:
        """The service that the file describes.

        raises InputFileError: at the line that is wrong; keys in COMMON are none of its business
        """

    def close(self) -> None: ...


def opened(name: str, at: Value, settings: Section | None, around: Around) -> Adapter:
    """The adapter of a name, which stands or would stand in this place of the file.

    raises InputFileError: when there is none, or what it needs is not installed
    """
    if name not in BUNDLED and "." not in name:
        raise at.error(f"{name!r} is not known here", did_you_mean(name, BUNDLED))
    try:
        module = import_module(BUNDLED.get(name, name))
        open_adapter = cast("Callable[[Section | None, Around], Adapter]", module.open_adapter)
        return open_adapter(settings, around)
    except (ImportError, AttributeError) as error:
        raise at.error(f"no adapter {name!r}: {error}") from error
