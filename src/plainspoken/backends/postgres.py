"""Missions in PostgreSQL: for workers on any number of machines.

Whether a worker lives is seen in two ways: its row, which it has to renew, and a lock of its own
connection, which the server takes away the moment that the process ends.
"""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.database import (
    Duplicate,
    Session,
    StoreError,
    WorkerId,
    native,
    without_password,
)

if TYPE_CHECKING:
    import psycopg

NATIVE = {"{now}": "extract(epoch FROM clock_timestamp())", "{row}": "number", "?": "%s"}
SCHEMA = "plainspoken"
CONNECT_SECONDS = 5
ALONE = 0x706C6E
"""The advisory lock of whoever gives or takes places."""
LIVES = 0x706C6F
"""The first half of the advisory locks that say that a worker lives."""


class _Session:
    def __init__(self, connection: psycopg.Connection[tuple[Any, ...]]) -> None:
        self._connection = connection

    def rows(self, sql: str, values: Sequence[object] = ()) -> list[tuple[Any, ...]]:
        return self._connection.execute(_query(sql), values).fetchall()

    def change(self, sql: str, values: Sequence[object] = ()) -> int:
        return self._connection.execute(_query(sql), values).rowcount


def _query(sql: str) -> bytes:
    return native(sql, NATIVE).encode()


class PostgresDatabase:
    """Connections to one database, each used by one thread at a time."""

    def __init__(self, url: str) -> None:
        """Connect, and make the tables where there are none yet.

        raises StoreError: when the database cannot be reached or used, or psycopg is not installed
        """
        self._url = url
        self._idle: queue.LifoQueue[psycopg.Connection[tuple[Any, ...]]] = queue.LifoQueue()
        self._living: dict[WorkerId, psycopg.Connection[tuple[Any, ...]]] = {}
        self._lock = threading.Lock()
        try:
            import psycopg
        except ImportError as error:
            raise PlainspokenError(
                "a store in PostgreSQL needs the package psycopg",
                where=self.place,
                hint="pip install 'plainspoken[postgres]'",
            ) from error
        self._psycopg = psycopg
        with self.writing() as session:
            _prepare(session)

    @property
    def place(self) -> str:
        return without_password(self._url)

    @contextmanager
    def reading(self) -> Iterator[Session]:
        with self._connection() as connection:
            yield _Session(connection)

    @contextmanager
    def writing(self) -> Iterator[Session]:
        with self._connection() as connection, connection.transaction():
            yield _Session(connection)

    def alone(self, session: Session) -> None:
        session.rows("SELECT pg_advisory_xact_lock(?)", (ALONE,))

    def stay(self, worker: WorkerId) -> None:
        with self._errors():
            connection = self._connected()
            connection.execute(
                _query("SELECT pg_advisory_lock(?, hashtext(?::text))"), (LIVES, worker)
            )
        with self._lock:
            self._living[worker] = connection

    def leave(self, worker: WorkerId) -> None:
        with self._lock:
            connection = self._living.pop(worker, None)
        if connection is not None:
            connection.close()

    def is_gone(self, worker: WorkerId) -> bool:
        if worker in self._living:
            return False
        with self.reading() as session:
            values = (LIVES, worker)
            free = session.rows("SELECT pg_try_advisory_lock(?, hashtext(?::text))", values)[0][0]
            if free:
                session.rows("SELECT pg_advisory_unlock(?, hashtext(?::text))", values)
        return bool(free)

    def close(self) -> None:
        for worker in tuple(self._living):
            self.leave(worker)
        while True:
            try:
                self._idle.get_nowait().close()
            except queue.Empty:
                return

    def _connected(self) -> psycopg.Connection[tuple[Any, ...]]:
        connection = self._psycopg.connect(
            self._url,
            autocommit=True,
            connect_timeout=CONNECT_SECONDS,
            application_name="plainspoken",
        )
        connection.execute(f"SET search_path TO {SCHEMA}")
        return connection

    @contextmanager
    def _connection(self) -> Iterator[psycopg.Connection[tuple[Any, ...]]]:
        """One connection for one thread; kept for the next unless something was wrong with it."""
        with self._errors():
            try:
                connection = self._idle.get_nowait()
            except queue.Empty:
                connection = self._connected()
            try:
                yield connection
            except self._psycopg.OperationalError:
                connection.close()
                raise
            finally:
                if not connection.closed:
                    self._idle.put(connection)

    @contextmanager
    def _errors(self) -> Iterator[None]:
        try:
            yield
        except self._psycopg.errors.UniqueViolation as error:
            raise Duplicate(str(error)) from error
        except self._psycopg.OperationalError as error:
            raise StoreError(
                f"the store cannot be reached: {_first_line(error)}",
                where=self.place,
                hint="does the server run, and does the database exist? `createdb NAME` makes one",
            ) from error
        except self._psycopg.Error as error:
            raise StoreError(
                f"the store cannot be used: {_first_line(error)}", where=self.place
            ) from error


def _first_line(error: Exception) -> str:
    return (str(error).splitlines() or [type(error).__name__])[0]


def _prepare(session: Session) -> None:
    session.rows("SELECT pg_advisory_xact_lock(?)", (ALONE,))  # several may begin at once
    session.change(f"CREATE SCHEMA IF NOT EXISTS {SCHEMA}")
    session.change("CREATE TABLE IF NOT EXISTS version (number INTEGER PRIMARY KEY)")
    ((version,),) = session.rows("SELECT coalesce(max(number), 0) FROM version")
    for number, change in enumerate(CHANGES[version:], start=version + 1):
        change(session)
        session.change("INSERT INTO version (number) VALUES (?)", (number,))


def m001_missions(session: Session) -> None:
    """The log, with a trigger that refuses what it never does, and the queue."""
    session.change(
        "CREATE TABLE entry (number BIGSERIAL, mission TEXT NOT NULL, step INTEGER NOT NULL,"
        " document TEXT NOT NULL, hash TEXT NOT NULL, PRIMARY KEY (mission, step))"
    )
    session.change(
        "CREATE FUNCTION only_append() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN"
        " RAISE EXCEPTION 'the log is only ever appended to'; END $$"
    )
    session.change(
        "CREATE TRIGGER only_append BEFORE UPDATE OR DELETE OR TRUNCATE ON entry"
        " FOR EACH STATEMENT EXECUTE FUNCTION only_append()"
    )
    session.change(
        "CREATE TABLE place (number BIGSERIAL PRIMARY KEY, mission TEXT NOT NULL UNIQUE,"
        " standing TEXT NOT NULL, worker TEXT, trouble TEXT)"
    )
    session.change(
        "CREATE TABLE reservation (mission TEXT NOT NULL, robot TEXT NOT NULL,"
        " PRIMARY KEY (mission, robot))"
    )
    session.change(
        "CREATE TABLE message (number BIGSERIAL PRIMARY KEY, mission TEXT NOT NULL,"
        " document TEXT NOT NULL, posted DOUBLE PRECISION NOT NULL, answered INTEGER)"
    )
    session.change("CREATE TABLE worker (id TEXT PRIMARY KEY, heard DOUBLE PRECISION NOT NULL)")
    session.change("CREATE INDEX place_open ON place (number) WHERE standing <> 'over'")
    session.change("CREATE INDEX reservation_robot ON reservation (robot, mission)")
    session.change("CREATE INDEX message_open ON message (mission) WHERE answered IS NULL")


def m002_robots(session: Session) -> None:
    """What robots of a file were told, and what people are asked."""
    session.change(
        "CREATE TABLE note (subject TEXT NOT NULL, topic TEXT NOT NULL, document TEXT NOT NULL,"
        " PRIMARY KEY (subject, topic))"
    )
    session.change(
        "CREATE TABLE question (number BIGSERIAL PRIMARY KEY, call TEXT NOT NULL UNIQUE,"
        " question TEXT NOT NULL, answers TEXT NOT NULL, asked TEXT NOT NULL, answer TEXT,"
        " reporter TEXT, answered TEXT, withdrawn INTEGER NOT NULL DEFAULT 0)"
    )


CHANGES: tuple[Callable[[Session], None], ...] = (m001_missions, m002_robots)
"""Each changes the tables by one version; none is ever edited."""
