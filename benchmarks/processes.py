"""Stopping a process, as a machine does that swaps, or one that is suspended."""

from __future__ import annotations

import signal
import sqlite3
import subprocess
import time
from contextlib import closing
from pathlib import Path
from typing import Any


def stop(process: subprocess.Popen[Any], *files: Path) -> None:
    """Stop a process, though not in the middle of writing to one of its SQLite files.

    It would keep every other process from them: SQLite has no way around that.
    """
    while True:
        process.send_signal(signal.SIGSTOP)
        if all(is_free(file) for file in files):
            return
        process.send_signal(signal.SIGCONT)
        time.sleep(0.003)


def is_free(file: Path) -> bool:
    """Whether nobody is writing to a SQLite file."""
    with closing(sqlite3.connect(file, timeout=0.05, isolation_level=None)) as connection:
        try:
            connection.execute("BEGIN IMMEDIATE")
        except sqlite3.OperationalError:
            return False
        return True
