"""What the store asks of a database, so that SQLite and PostgreSQL keep missions by the same code.

Statements are written with `?` for a value, `{now}` for the database's own clock in seconds
(workers on several machines need one clock to agree on who is late) and `{row}` for the order in
which rows were made.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager
from typing import Any, Protocol
from urllib.parse import urlsplit

from plainspoken.errors import PlainspokenError

WorkerId = str
"""Names one run of one worker process; never used again."""


class StoreError(PlainspokenError):
    """The store cannot be used: it is away, locked, full, or not one of ours."""


class Duplicate(Exception):
    """A row with such a key is there already; nothing of the transaction was kept."""


def native(sql: str, words: Mapping[str, str]) -> str:
    """A statement in the words of one database."""
    for ours, theirs in words.items():
        sql = sql.replace(ours, theirs)
    return sql


def without_password(url: str) -> str:
    """A place that may be shown; paths are as they are."""
    if "://" not in url:
        return url
    parts = urlsplit(url)
    login, at, host = parts.netloc.rpartition("@")
    return parts._replace(netloc=f"{login.partition(':')[0]}{at}{host}", query="").geturl()


class Session(Protocol):
    """One transaction."""

    def rows(self, sql: str, values: Sequence[object] = ()) -> list[tuple[Any, ...]]:
        """What a statement gives back."""

    def change(self, sql: str, values: Sequence[object] = ()) -> int:
        """Carry a statement out; gives how many rows it touched."""


class Database(Protocol):
    """A connection, or several, that threads may share."""

    @property
    def place(self) -> str:
        """Where it is, for people; without a password."""

    def reading(self) -> AbstractContextManager[Session]:
        """Look, and change nothing."""

    def writing(self) -> AbstractContextManager[Session]:
        """All or nothing; durable when it ends.

        raises Duplicate, StoreError
        """

    def alone(self, session: Session) -> None:
        """Have whoever else gives or takes places wait until this transaction ends."""

    def stay(self, worker: WorkerId) -> None:
        """Be seen to live, until this process ends, however it ends."""

    def leave(self, worker: WorkerId) -> None:
        """Take the sign of a worker's life away, one's own or that of one who is gone."""

    def is_gone(self, worker: WorkerId) -> bool:
        """Whether a worker is certain to have ended; False where that cannot be told."""

    def close(self) -> None:
        """Let go of every connection."""
