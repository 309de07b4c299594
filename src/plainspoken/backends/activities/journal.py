"""What a robot was told and what became of it, on disk before it is done.

One JSON object a line, each on the disk before the call that it is about is made. A process that
takes over reads it, walks the activity again, and finds each call where the dead one left it: so
no call is made twice because nobody remembers it.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path
from threading import Lock
from typing import Any

from plainspoken.errors import InputFileError

_BEGINS = b'{"subject": '


class Journal:
    """Notes by subject and key; the last one counts. Kept in memory where no path is given.

    Several programs may share the file: each sees what the others have noted.
    """

    def __init__(self, path: Path | None = None) -> None:
        self._path = path
        self._notes: dict[tuple[str, str], Any] = {}
        self._lock = Lock()
        self._read = 0  # bytes of the file that were taken in, and the lines in them
        self._lines = 0
        self._file = None
        if path is not None:
            path.parent.mkdir(parents=True, exist_ok=True)
            self._file = path.open("ab", buffering=0)
            try:
                self._catch_up()
            except InputFileError:
                self.close()
                raise

    def get(self, subject: str, key: str) -> Any:
        """The last note; None where there is none."""
        self._catch_up()
        return self._notes.get((subject, key))

    def note(self, subject: str, key: str, value: Any) -> None:
        """Write a note down; it is on the disk when this returns."""
        with self._lock:
            if self._file is not None:
                row = {"subject": subject, "key": key, "value": value}
                # One write, begun on a line of its own: a crash may have torn the one before.
                self._file.write(b"\n" + json.dumps(row, ensure_ascii=False).encode() + b"\n")
                os.fsync(self._file.fileno())
            self._notes[subject, key] = value

    def close(self) -> None:
        if self._file is not None:
            self._file.close()

    def _catch_up(self) -> None:
        """Take in the whole lines that were written since the last time."""
        with self._lock:
            if self._path is None or self._file is None or self._file.closed:
                return
            if os.fstat(self._file.fileno()).st_size == self._read:
                return
            with self._path.open("rb") as file:
                file.seek(self._read)
                content = file.read()
            whole, _, _ = content.rpartition(b"\n")
            lines = whole.split(b"\n") if whole else []
            for number, line in enumerate(lines, start=self._lines + 1):
                self._take_in(line, number)
            self._read += len(whole) + bool(lines)
            self._lines += len(lines)

    def _take_in(self, line: bytes, number: int) -> None:
        """Read one line, unless it is one of ours that a crash has torn."""
        if not line:
            return
        try:
            row: Mapping[str, Any] = json.loads(line)
            self._notes[row["subject"], row["key"]] = row["value"]
        except (ValueError, KeyError, TypeError) as error:
            if not (line.startswith(_BEGINS) or _BEGINS.startswith(line)):
                raise InputFileError(
                    "not a journal of robots", str(self._path), line=number
                ) from error
