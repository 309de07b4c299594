"""Where a run is recorded: the store, and a file of JSON lines where one is asked for."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from pathlib import Path

from plainspoken.errors import InputFileError
from plainspoken.knowledge.jsonl import JsonlWriter
from plainspoken.knowledge.log import EventLog
from plainspoken.mission.mission import MissionId
from plainspoken.mission.run import Record
from plainspoken.world.event import Entry, Event, Instant


def utc_now() -> datetime:
    """The clock that entries are dated by."""
    return datetime.now(UTC)


def written_too(record: Record, file: JsonlWriter | None) -> Record:
    """Stores events first, then writes them to the file."""

    def recorded(instant: Instant, events: Sequence[Event]) -> Sequence[Entry]:
        entries = record(instant, events)
        if file is not None:
            for entry in entries:
                file.write(entry)
        return entries

    return recorded


def recorder(kept: EventLog, mission: MissionId, now: Callable[[], datetime]) -> Record:
    """Stores events of a mission that nobody else knows of."""

    def record(instant: Instant, events: Sequence[Event]) -> Sequence[Entry]:
        time = now().isoformat(timespec="milliseconds")
        return kept.append(mission, time, instant, events)

    return record


def fresh_file(path: Path, *, overwrite: bool) -> None:
    """Make sure that a run does not go on in the file of another.

    raises InputFileError: when the file holds something and is not to be replaced
    """
    if path.exists() and path.stat().st_size:
        if not overwrite:
            raise InputFileError(
                "the file holds a log already, and a log is only ever appended to",
                path,
                hint="give another name, or --overwrite to replace it",
            )
        path.unlink()
