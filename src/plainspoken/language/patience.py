"""Waiting for what may take too long, and giving up on it."""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable
from typing import TypeVar

from plainspoken.errors import PlainspokenError

Seconds = float
T = TypeVar("T")


def waited_for(work: Callable[[], T], seconds: Seconds, late: PlainspokenError) -> T:
    """What the work returns or raises; after so many seconds `late`, whatever it is waiting for."""
    ended: queue.SimpleQueue[tuple[T, None] | tuple[None, BaseException]] = queue.SimpleQueue()

    def attempt() -> None:
        try:
            ended.put((work(), None))
        except BaseException as error:  # noqa: BLE001 - handed to the thread that waits
            ended.put((None, error))

    # A daemon: work that hangs must not keep the program from ending.
    threading.Thread(target=attempt, name="waited for", daemon=True).start()
    try:
        result, error = ended.get(timeout=seconds)
    except queue.Empty:
        raise late from None
    if error is not None:
        raise error
    return result  # type: ignore[return-value] # there is no error, so this is what it returned
