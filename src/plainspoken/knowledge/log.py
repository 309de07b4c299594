"""The log of what happened: events only ever appended, several missions in one store.

An entry is on disk before `append` returns. The robot is told to act only afterwards, so the log
is never behind the world by more than the action under way.
"""

from __future__ import annotations

import json
import os
import sqlite3
import sys
import threading
import time as clock
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from types import TracebackType
from typing import Protocol, Self

from plainspoken.errors import InputFileError, PlainspokenError
from plainspoken.knowledge.chain import (
    Break,
    Hash,
    Link,
    MissionId,
    canonical,
    chained,
    first_break,
    genesis,
)
from plainspoken.world.event import Entry, Event, Instant, Step, entry_from_json

BUSY_SECONDS = 30.0
"""How long one process waits for another that is writing to the same store."""


class EventLog(Protocol):
    """Where the events of missions are kept."""

    def append(
        self, mission: MissionId, time: str, instant: Instant, events: Sequence[Event]
    ) -> tuple[Entry, ...]:
        """Keep events, all of them or none, as the next entries of a mission."""

    def entries(self, mission: MissionId, since: Step = 0) -> tuple[Entry, ...]:
        """The entries of a mission in order; none where it is not known."""

    def missions(self) -> tuple[MissionId, ...]:
        """The missions that have entries, oldest first."""

    def verify(self, mission: MissionId) -> Break | None:
        """Where the entries are not as they were written, None where all are."""


def store_path(url: str | None, environment: Mapping[str, str] = os.environ) -> Path:
    """The file that `--store` names: `sqlite:///path` or a path.

    Without one, `plainspoken.sqlite` in `PLAINSPOKEN_HOME`, or else where the platform keeps a
    user's data (`XDG_DATA_HOME` on Linux).
    raises PlainspokenError: when the URL is of another kind of store
    """
    if url:
        scheme, separator, rest = url.partition("://")
        if not separator:
            return Path(url).expanduser()
        # sqlite:///run.db is relative, sqlite:////var/run.db absolute, as SQLAlchemy has it.
        if scheme == "sqlite" and len(rest) > 1 and rest[0] == "/":
            return Path(rest[1:]).expanduser()
        raise PlainspokenError(
            f"cannot keep a log in {url!r}", hint="give a path, or sqlite:///path"
        )
    home = environment.get("PLAINSPOKEN_HOME")
    if home:
        folder = Path(home).expanduser()
    elif sys.platform == "darwin":
        folder = Path.home() / "Library" / "Application Support" / "plainspoken"
    else:
        shared = environment.get("XDG_DATA_HOME") or "~/.local/share"
        folder = Path(shared).expanduser() / "plainspoken"
    return folder / "plainspoken.sqlite"


class SqliteLog:
    """An event log in one SQLite file, for several missions, threads and processes."""

    def __init__(self, path: str | Path) -> None:
        """Open a store, made where there is none; `:memory:` is one that nobody else sees.

        raises InputFileError: when the file is no such store
        """
        self._path = path
        self._lock = threading.Lock()
        with self._errors():
            if str(path) != ":memory:":
                Path(path).parent.mkdir(parents=True, exist_ok=True)
            self._connection = sqlite3.connect(
                path, timeout=BUSY_SECONDS, isolation_level=None, check_same_thread=False
            )
            _prepare(self._connection)

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
        with self._lock:
            self._connection.close()

    def append(
        self, mission: MissionId, time: str, instant: Instant, events: Sequence[Event]
    ) -> tuple[Entry, ...]:
        """Keep events, all of them or none, as the next entries of a mission."""
        with self._writing():
            step, previous = self._end(mission)
            entries = tuple(
                Entry(step + index, time, instant, event) for index, event in enumerate(events)
            )
            self._insert(mission, previous, [(e.step, canonical(e)) for e in entries])
        return entries

    def restore(self, mission: MissionId, links: Sequence[Link]) -> None:
        """Take in a mission that was exported elsewhere, byte for byte.

        raises PlainspokenError: when the store has the mission, or the chain is broken
        """
        broken = first_break(mission, links)
        if broken is not None:
            raise PlainspokenError(
                f"cannot import the mission {mission!r}: {broken.what}",
                where=f"step {broken.step}",
            )
        with self._writing():
            if self._end(mission)[0]:
                raise PlainspokenError(
                    f"the store has a mission {mission!r} already",
                    where=str(self._path),
                    hint="import it into another store",
                )
            self._insert(mission, genesis(mission), [(link.step, link.text) for link in links])

    def entries(self, mission: MissionId, since: Step = 0) -> tuple[Entry, ...]:
        """The entries of a mission in order; none where it is not known.

        raises InputFileError: naming the step, where an entry cannot be read
        """
        found = []
        for link in self.links(mission, since):
            try:
                found.append(entry_from_json(json.loads(link.text)))
            except (ValueError, KeyError, TypeError) as error:
                raise InputFileError(
                    "the entry cannot be read",
                    self._path,
                    field=f"step {link.step} of mission {mission}",
                    hint="someone else may have changed the store: verify the mission's log",
                ) from error
        return tuple(found)

    def links(self, mission: MissionId, since: Step = 0) -> tuple[Link, ...]:
        """The entries of a mission as they are stored, with the hash up to each."""
        with self._lock, self._errors():
            rows = self._connection.execute(
                "SELECT step, document, hash FROM entry WHERE mission = ? AND step >= ?"
                " ORDER BY step",
                (mission, since),
            ).fetchall()
        return tuple(Link(*row) for row in rows)

    def missions(self) -> tuple[MissionId, ...]:
        """The missions that have entries, oldest first."""
        with self._lock, self._errors():
            rows = self._connection.execute(
                "SELECT mission FROM entry GROUP BY mission ORDER BY min(rowid)"
            ).fetchall()
        return tuple(mission for (mission,) in rows)

    def verify(self, mission: MissionId) -> Break | None:
        """Where the entries are not as they were written, None where all are.

        A mission that is not known is broken at step 0: its entries may have been deleted.
        """
        links = self.links(mission)
        if not links:
            return Break(mission, 0, "there are no entries of this mission")
        return first_break(mission, links)

    def _end(self, mission: MissionId) -> tuple[Step, Hash]:
        """The next step of a mission, and the hash to chain it to."""
        row = self._connection.execute(
            "SELECT step, hash FROM entry WHERE mission = ? ORDER BY step DESC LIMIT 1",
            (mission,),
        ).fetchone()
        return (row[0] + 1, row[1]) if row else (0, genesis(mission))

    def _insert(
        self, mission: MissionId, previous: Hash, texts: Sequence[tuple[Step, str]]
    ) -> None:
        rows = []
        for step, text in texts:
            previous = chained(previous, text)
            rows.append((mission, step, text, previous))
        self._connection.executemany(
            "INSERT INTO entry (mission, step, document, hash) VALUES (?, ?, ?, ?)", rows
        )

    @contextmanager
    def _writing(self) -> Iterator[None]:
        """One transaction; other processes wait from before the end of the chain is read."""
        with self._lock, self._errors(), _transaction(self._connection):
            yield

    @contextmanager
    def _errors(self) -> Iterator[None]:
        try:
            yield
        except sqlite3.OperationalError as error:
            hint = "another process is writing: try again" if "locked" in str(error) else None
            raise InputFileError(f"cannot use the store: {error}", self._path, hint=hint) from error
        except sqlite3.DatabaseError as error:
            raise InputFileError(
                f"not a store of plainspoken: {error}", self._path, hint="give another --store"
            ) from error
        except OSError as error:
            raise InputFileError(f"cannot use the store: {error.strerror}", self._path) from error


@contextmanager
def _transaction(connection: sqlite3.Connection) -> Iterator[None]:
    connection.execute("BEGIN IMMEDIATE")
    try:
        yield
    except BaseException:  # Ctrl-C too: half a decision must not stay in the log
        connection.execute("ROLLBACK")
        raise
    connection.execute("COMMIT")


def _prepare(connection: sqlite3.Connection) -> None:
    deadline = clock.monotonic() + BUSY_SECONDS
    while True:
        try:
            connection.execute("PRAGMA journal_mode = WAL")
            break
        except sqlite3.OperationalError as error:
            # The change to WAL does not wait its turn as a transaction does.
            if "locked" not in str(error) or clock.monotonic() > deadline:
                raise
            clock.sleep(0.01)
    # A command is on disk before the robot hears it, even if the power fails then.
    connection.execute("PRAGMA synchronous = FULL")
    with _transaction(connection):
        (version,) = connection.execute("PRAGMA user_version").fetchone()
        for number, change in enumerate(CHANGES[version:], start=version + 1):
            change(connection)
            connection.execute(f"PRAGMA user_version = {number}")


def m001_entries(connection: sqlite3.Connection) -> None:
    """The first table. Its triggers refuse what an append-only log never does."""
    connection.execute(
        "CREATE TABLE entry (mission TEXT NOT NULL, step INTEGER NOT NULL,"
        " document TEXT NOT NULL, hash TEXT NOT NULL, PRIMARY KEY (mission, step))"
    )
    for deed in ("UPDATE", "DELETE"):
        connection.execute(
            f"CREATE TRIGGER no_{deed.lower()} BEFORE {deed} ON entry"
            " BEGIN SELECT RAISE(ABORT, 'the log is only ever appended to'); END"
        )


CHANGES: tuple[Callable[[sqlite3.Connection], None], ...] = (m001_entries,)
"""Each changes the tables of a store by one version; none is ever edited."""
