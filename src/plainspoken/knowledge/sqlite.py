"""Missions in one SQLite file: for any number of processes on one machine."""

from __future__ import annotations

import fcntl
import os
import sqlite3
import threading
import time as clock
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from plainspoken.errors import InputFileError
from plainspoken.knowledge.database import Duplicate, Session, StoreError, WorkerId, native

BUSY_SECONDS = 30.0
"""How long one process waits for another that is writing to the same store."""
NATIVE = {"{now}": "((julianday('now') - 2440587.5) * 86400.0)", "{row}": "rowid"}


class StoreFileError(InputFileError, StoreError):
    """The file of a store cannot be used."""


class _Session:
    def __init__(self, connection: sqlite3.Connection) -> None:
        self._connection = connection

    def rows(self, sql: str, values: Sequence[object] = ()) -> list[tuple[Any, ...]]:
        return self._connection.execute(native(sql, NATIVE), values).fetchall()

    def change(self, sql: str, values: Sequence[object] = ()) -> int:
        return self._connection.execute(native(sql, NATIVE), values).rowcount


class SqliteDatabase:
    """One connection, which the threads of a process take turns at."""

    def __init__(self, path: str | Path) -> None:
        """Open a store, made where there is none; `:memory:` is one that nobody else sees.

        raises StoreFileError: when the file is no such store
        """
        self._path = path
        self._lock = threading.Lock()
        self._seen: dict[WorkerId, int] = {}
        with self._errors():
            if str(path) != ":memory:":
                Path(path).parent.mkdir(parents=True, exist_ok=True)
            self._connection = sqlite3.connect(
                path, timeout=BUSY_SECONDS, isolation_level=None, check_same_thread=False
            )
            _prepare(self._connection)

    @property
    def place(self) -> str:
        return str(self._path)

    @contextmanager
    def reading(self) -> Iterator[Session]:
        with self._lock, self._errors():
            yield _Session(self._connection)

    @contextmanager
    def writing(self) -> Iterator[Session]:
        """One transaction; other processes wait from before anything is read."""
        with self._lock, self._errors(), _transaction(self._connection):
            yield _Session(self._connection)

    def alone(self, session: Session) -> None:
        """Nothing to do: SQLite has one writer at a time."""

    def stay(self, worker: WorkerId) -> None:
        """Hold a lock that the system takes away when the process ends, `kill -9` included."""
        if str(self._path) == ":memory:":
            return
        path = self._sign(worker)
        with self._errors():
            path.parent.mkdir(exist_ok=True)
            descriptor = os.open(path, os.O_CREAT | os.O_RDWR, 0o600)
            fcntl.flock(descriptor, fcntl.LOCK_EX)
        self._seen[worker] = descriptor

    def leave(self, worker: WorkerId) -> None:
        descriptor = self._seen.pop(worker, None)
        if str(self._path) != ":memory:":
            self._sign(worker).unlink(missing_ok=True)
        if descriptor is not None:
            os.close(descriptor)

    def is_gone(self, worker: WorkerId) -> bool:
        if worker in self._seen or str(self._path) == ":memory:":
            return False
        try:
            descriptor = os.open(self._sign(worker), os.O_RDWR)
        except OSError:
            return False  # it may run where our files are not seen: its heart tells
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            return False
        else:
            return True
        finally:
            os.close(descriptor)

    def close(self) -> None:
        for worker in tuple(self._seen):
            self.leave(worker)
        with self._lock:
            self._connection.close()

    def _sign(self, worker: WorkerId) -> Path:
        return Path(f"{self._path}.workers") / worker

    @contextmanager
    def _errors(self) -> Iterator[None]:
        try:
            yield
        except sqlite3.OperationalError as error:
            hint = "another process is writing: try again" if "locked" in str(error) else None
            raise StoreFileError(f"cannot use the store: {error}", self._path, hint=hint) from error
        except sqlite3.IntegrityError as error:
            if "UNIQUE" in str(error) or "PRIMARY KEY" in str(error):
                raise Duplicate(str(error)) from error
            raise StoreFileError(f"cannot use the store: {error}", self._path) from error
        except sqlite3.DatabaseError as error:
            raise StoreFileError(
                f"not a store of plainspoken: {error}", self._path, hint="give another --store"
            ) from error
        except OSError as error:
            raise StoreFileError(f"cannot use the store: {error.strerror}", self._path) from error


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


def m002_places(connection: sqlite3.Connection) -> None:
    """Whose turn it is, who carries what out, and what is asked of it: see `knowledge.queue`."""
    connection.execute(
        "CREATE TABLE place (number INTEGER PRIMARY KEY, mission TEXT NOT NULL UNIQUE,"
        " standing TEXT NOT NULL, worker TEXT, trouble TEXT)"
    )
    connection.execute(
        "CREATE TABLE reservation (mission TEXT NOT NULL, robot TEXT NOT NULL,"
        " PRIMARY KEY (mission, robot))"
    )
    connection.execute(
        "CREATE TABLE message (number INTEGER PRIMARY KEY AUTOINCREMENT, mission TEXT NOT NULL,"
        " document TEXT NOT NULL, posted REAL NOT NULL, answered INTEGER)"
    )
    connection.execute("CREATE TABLE worker (id TEXT PRIMARY KEY, heard REAL NOT NULL)")
    connection.execute("CREATE INDEX place_open ON place (number) WHERE standing <> 'over'")
    connection.execute("CREATE INDEX reservation_robot ON reservation (robot, mission)")
    connection.execute("CREATE INDEX message_open ON message (mission) WHERE answered IS NULL")


def m003_robots(connection: sqlite3.Connection) -> None:
    """What robots of a file were told, and what people are asked: see `backends`."""
    connection.execute(
        "CREATE TABLE note (subject TEXT NOT NULL, topic TEXT NOT NULL, document TEXT NOT NULL,"
        " PRIMARY KEY (subject, topic))"
    )
    connection.execute(
        "CREATE TABLE question (number INTEGER PRIMARY KEY, call TEXT NOT NULL UNIQUE,"
        " question TEXT NOT NULL, answers TEXT NOT NULL, asked TEXT NOT NULL, answer TEXT,"
        " reporter TEXT, answered TEXT, withdrawn INTEGER NOT NULL DEFAULT 0)"
    )


CHANGES: tuple[Callable[[sqlite3.Connection], None], ...] = (
    m001_entries,
    m002_places,
    m003_robots,
)
"""Each changes the tables of a store by one version; none is ever edited."""
