"""The time a search may take, and whom to tell how far it is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from time import monotonic

Seconds = float


@dataclass(frozen=True, slots=True)
class Progress:
    """How far a search is: states with an action, states that wait for one, dead ends."""

    closed: int
    waiting: int
    dead: int
    seconds: Seconds


class TimeIsUp(Exception):  # the solver makes an ending of it
    """Raised by `Watch.check` where a stage has no ending of its own."""


@dataclass(slots=True)
class Watch:
    """Started when it is made.

    timeout: None for as long as it takes
    size:    what was told last, told again where only the time is looked at
    """

    timeout: Seconds | None = None
    on_progress: Callable[[Progress], None] | None = None
    started: Seconds = field(default_factory=monotonic)
    told: Seconds = 0.0
    size: tuple[int, int, int] = (0, 0, 0)

    @property
    def seconds(self) -> Seconds:
        """Since it was started."""
        return monotonic() - self.started

    def expired(self) -> bool:
        """Whether time is up; whoever listens is told, and may end the search by raising."""
        self.tell(*self.size)
        return self.timeout is not None and monotonic() - self.started > self.timeout

    def check(self) -> None:
        """Go on, or raise TimeIsUp."""
        if self.expired():
            raise TimeIsUp

    @property
    def left(self) -> Seconds | None:
        """Until time is up; None where it never is."""
        return None if self.timeout is None else max(self.timeout - self.seconds, 0.0)

    def progress(self, closed: int, waiting: int, dead: int) -> Progress:
        return Progress(closed, waiting, dead, self.seconds)

    def tell(self, closed: int, waiting: int, dead: int) -> None:
        """Report progress, ten times a second at most."""
        self.size = closed, waiting, dead
        if self.on_progress is not None and self.seconds - self.told >= 0.1:
            self.told = self.seconds
            self.on_progress(self.progress(closed, waiting, dead))
