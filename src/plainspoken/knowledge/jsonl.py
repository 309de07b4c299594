"""Logs as files: one JSON event a line, as `run --log` writes and `ask --log` reads.

Each line ends in `"hash"`, the chain up to there; files without hashes are read too. A process
that is killed loses at most the line it was writing: such a torn last line is not an entry.
"""

from __future__ import annotations

import json
import logging
import os
import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import BinaryIO, Self

from plainspoken.errors import InputFileError
from plainspoken.knowledge.chain import (
    Hash,
    Link,
    MissionId,
    canonical,
    chained,
    first_break,
    genesis,
)
from plainspoken.world.event import Entry, MissionAccepted, entry_from_json

log = logging.getLogger(__name__)

_SEAL = re.compile(rb',"hash":"([0-9a-f]{64})"\}$')


@dataclass(frozen=True, slots=True)
class LogFile:
    """What a log file holds.

    links:     the lines as they were hashed; empty where the file has no hashes
    torn_line: the number of the last line where it was never finished, from 1
    end:       how many bytes of the file are whole lines
    """

    mission: MissionId
    entries: tuple[Entry, ...]
    links: tuple[Link, ...] = ()
    torn_line: int | None = None
    end: int = 0


def read_jsonl(path: str | Path) -> LogFile:
    """Read a log file; a torn last line is left out, with a warning.

    raises InputFileError: with the line that is no entry, or not the one that was written
    """
    try:
        raw = Path(path).read_bytes()
    except OSError as error:
        raise InputFileError(
            f"cannot read the file: {error.strerror}", path, hint="check the path"
        ) from error
    lines = raw.split(b"\n")
    torn_line = None
    if lines[-1] and not _is_whole(lines[-1]):
        torn_line = len(lines)
        log.warning("%s:%d: the last line was never finished; left out", path, torn_line)
        lines.pop()
    found = [
        (number, line, _entry(line, path, number))
        for number, line in enumerate(lines, start=1)
        if line.strip()
    ]
    for index, (number, _, entry) in enumerate(found):
        if entry.step != index:
            raise InputFileError(
                f"expected step {index}, got step {entry.step}",
                path,
                line=number,
                hint="a line is missing, or two runs were written to one file",
            )
    if not found or not isinstance(found[0][2].event, MissionAccepted):
        raise InputFileError(
            "a log begins with an entry of kind mission_accepted",
            path,
            line=1,
            hint="give the file that `plainspoken run --log` wrote",
        )
    mission = found[0][2].event.mission
    end = sum(len(line) + 1 for line in lines) if torn_line else len(raw)
    links = _links(mission, [(number, line) for number, line, _ in found], path)
    return LogFile(mission, tuple(entry for _, _, entry in found), links, torn_line, end)


class JsonlWriter:
    """Appends entries to a log file, each one out of this process before `write` returns."""

    def __init__(self, path: str | Path) -> None:
        """Open a file, made where there is none; one that holds entries is continued.

        A torn last line is cut off: it never was an entry.
        raises InputFileError: when the file holds something else
        """
        self._path = path
        self._next = 0
        self._previous: Hash | None = None
        try:
            Path(path).parent.mkdir(parents=True, exist_ok=True)
            self._file: BinaryIO = Path(path).open("ab")  # noqa: SIM115 - closed by close()
        except OSError as error:
            raise InputFileError(f"cannot write the file: {error.strerror}", path) from error
        if self._file.tell():
            try:
                self._continue(read_jsonl(path))
            except InputFileError:
                self._file.close()
                raise

    def _continue(self, written: LogFile) -> None:
        if not written.links:
            raise InputFileError("its lines have no hashes to go on from", self._path)
        if written.torn_line:
            self._file.truncate(written.end)
        elif not Path(self._path).read_bytes().endswith(b"\n"):
            self._file.write(b"\n")
        self._next = len(written.entries)
        self._previous = written.links[-1].hash

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        self._file.close()

    def write(self, entry: Entry) -> None:
        """Append one entry.

        raises InputFileError: when it is not the next one of the run in this file
        """
        if entry.step != self._next:
            raise InputFileError(
                f"the file goes on with step {self._next}, not step {entry.step}",
                self._path,
                hint="it holds another run: give another file",
            )
        if self._previous is None:
            accepted = entry.event
            if not isinstance(accepted, MissionAccepted):
                raise InputFileError("a log begins with mission_accepted", self._path)
            self._previous = genesis(accepted.mission)
        text = canonical(entry)
        self._previous = chained(self._previous, text)
        try:
            self._file.write(sealed(text, self._previous))
            self._file.flush()
        except OSError as error:
            raise InputFileError(f"cannot write the file: {error.strerror}", self._path) from error
        self._next += 1


def write_jsonl(links: Iterable[Link], path: str | Path) -> None:
    """Export a mission's log, byte for byte as it is stored; an old file is replaced.

    The file is there whole or not at all.
    """
    target = Path(path)
    partial = target.with_name(target.name + ".partial")
    try:
        with partial.open("wb") as file:
            file.writelines(sealed(link.text, link.hash) for link in links)
            file.flush()
            os.fsync(file.fileno())
        partial.replace(target)
    except OSError as error:
        raise InputFileError(f"cannot write the file: {error.strerror}", path) from error


def sealed(text: str, seal: Hash) -> bytes:
    """The line of an entry in a file."""
    return f'{text[:-1]},"hash":"{seal}"}}\n'.encode()


def _is_whole(line: bytes) -> bool:
    """Whether a last line without its line feed is an entry all the same."""
    try:
        entry_from_json(json.loads(line))
    except (ValueError, KeyError, TypeError, RecursionError):
        return False
    return True


def _entry(line: bytes, path: str | Path, number: int) -> Entry:
    try:
        document = json.loads(line)
    except (ValueError, RecursionError) as error:
        column = getattr(error, "colno", None)
        raise InputFileError("not a JSON text", path, line=number, column=column) from error
    if not isinstance(document, dict):
        raise InputFileError("expected a JSON object", path, line=number)
    try:
        return entry_from_json(document)
    except KeyError as error:
        missing = str(error.args[0])
        what = (
            f"unknown kind of event {missing!r}"
            if missing == document.get("kind")
            else f"the field {missing!r} is missing"
        )
        raise InputFileError(what, path, line=number) from error
    except TypeError as error:
        raise InputFileError("a field has the wrong type", path, line=number) from error


def _links(
    mission: MissionId, lines: list[tuple[int, bytes]], path: str | Path
) -> tuple[Link, ...]:
    """The lines without their hashes, checked; none where no line has one."""
    links: list[Link] = []
    for step, (number, line) in enumerate(lines):
        seal = _SEAL.search(line)
        if seal is None:
            if links or b'"hash"' in line:
                raise InputFileError("the line has lost its hash", path, line=number)
            continue
        if step != len(links):
            raise InputFileError("the line before has lost its hash", path, line=number)
        text = line[: seal.start()].decode("utf-8", "replace") + "}"
        links.append(Link(step, text, seal[1].decode()))
    broken = first_break(mission, links)
    if broken is not None:
        raise InputFileError(
            broken.what,
            path,
            line=lines[broken.step][0],
            hint="the file was changed after it was written",
        )
    return tuple(links)
