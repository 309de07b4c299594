"""How often somebody may ask for something: buckets that fill again with time."""

from __future__ import annotations

import math
import threading
import time
from collections import OrderedDict
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

from plainspoken.errors import PlainspokenError

Seconds = float
Who = str

MOST_REMEMBERED = 4096
"""Who asked longest ago is forgotten: many made-up clients must not fill the memory."""


class TooManyError(PlainspokenError):
    """Somebody asks more often, or for more at once, than is served.

    after: seconds until it is worth trying again
    """

    def __init__(self, what: str, after: Seconds) -> None:
        self.after = max(1, math.ceil(after))
        unit = "second" if self.after == 1 else "seconds"
        super().__init__(what, hint=f"try again in {self.after} {unit}")


@dataclass(frozen=True, slots=True)
class Rate:
    """So many a second, and so many at once after a while of nothing."""

    what: str
    a_second: float
    at_once: float


class Rates:
    """What each of many may still ask for."""

    def __init__(self, now: Callable[[], Seconds] = time.monotonic) -> None:
        self._now = now
        self._lock = threading.Lock()
        self._buckets: OrderedDict[tuple[str, Who], tuple[float, Seconds]] = OrderedDict()

    def spend(self, rate: Rate, who: Who) -> None:
        """Take one of what is left.

        raises TooManyError: when nothing is left
        """
        key = (rate.what, who)
        with self._lock:
            now = self._now()
            left, since = self._buckets.pop(key, (rate.at_once, now))
            left = min(rate.at_once, left + (now - since) * rate.a_second)
            enough = left >= 1
            self._buckets[key] = (left - 1 if enough else left, now)
            if len(self._buckets) > MOST_REMEMBERED:
                self._buckets.popitem(last=False)
        if not enough:
            raise TooManyError(f"too many {rate.what}", (1 - left) / rate.a_second)


class Seats:
    """So many at the same time, and so many of one."""

    def __init__(self, what: str, total: int, each: int) -> None:
        self._what, self._total, self._each = what, total, each
        self._lock = threading.Lock()
        self._taken: dict[Who, int] = {}

    @contextmanager
    def seat(self, who: Who) -> Iterator[None]:
        """Take a seat, and leave it at the end.

        raises TooManyError: when there is none
        """
        self.take(who)
        try:
            yield
        finally:
            self.leave(who)

    def take(self, who: Who) -> None:
        """Take a seat that is given back with `leave`.

        raises TooManyError: when there is none
        """
        with self._lock:
            mine = self._taken.get(who, 0)
            if mine >= self._each or sum(self._taken.values()) >= self._total:
                raise TooManyError(f"too many {self._what} at the same time", 5)
            self._taken[who] = mine + 1

    def leave(self, who: Who) -> None:
        with self._lock:
            self._taken[who] -= 1
            if not self._taken[who]:
                del self._taken[who]
