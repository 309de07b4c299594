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
from plainspoken.world.document import read_text


class Journal:
    """Notes by subject and key; the last one counts. Kept in memory where no path is given."""

    def __init__(self, path: Path | None = None) -> None:
        self._path = path
        self._notes: dict[tuple[str, str], Any] = {}
        self._lock = Lock()
        self._file = None
        if path is not None:
            whole = self._read(path)
            path.parent.mkdir(parents=True, exist_ok=True)
            self._file = path.open("a", encoding="utf-8")
            if not whole:
                # An empty line marks the one before as torn; what follows stands on its own.
                self._file.write("\n\n")

    def get(self, subject: str, key: str) -> Any:
        """The last note; None where there is none."""
        return self._notes.get((subject, key))

    def note(self, subject: str, key: str, value: Any) -> None:
        """Write a note down; it is on the disk when this returns."""
        with self._lock:
            if self._file is not None:
                row = {"subject": subject, "key": key, "value": value}
                self._file.write(json.dumps(row, ensure_ascii=False) + "\n")
                self._file.flush()
                os.fsync(self._file.fileno())
            self._notes[subject, key] = value

    def close(self) -> None:
        if self._file is not None:
            self._file.close()

    def _read(self, path: Path) -> bool:
        """Take in what is there; false where the last line was torn by a crash."""
        text = read_text(path) if path.exists() else ""
        lines = text.splitlines()
        for number, line in enumerate(lines, start=1):
            try:
                row: Mapping[str, Any] = json.loads(line or "{}")
                if row:
                    self._notes[row["subject"], row["key"]] = row["value"]
            except (ValueError, KeyError, TypeError) as error:
                if number < len(lines) and lines[number]:
                    raise InputFileError("not a journal of robots", path, line=number) from error
        return not text or text.endswith("\n")
