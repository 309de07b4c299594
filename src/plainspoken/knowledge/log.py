"""The log of what happened: events only ever appended, several missions in one store.

An entry is on disk before `append` returns. The robot is told to act only afterwards, so the log
is never behind the world by more than the action under way.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Mapping, Sequence
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
from plainspoken.knowledge.database import Database, Duplicate, Session
from plainspoken.knowledge.sqlite import SqliteDatabase
from plainspoken.world.event import Entry, Event, Instant, Step, entry_from_json

Also = Callable[[Session, Step], None]
"""What is kept in the transaction of an append, told the step of its last entry."""


class OvertakenError(PlainspokenError):
    """Somebody else has written to the log of a mission: whoever was carrying it out lets go."""

    def __init__(self, mission: MissionId, step: Step) -> None:
        self.mission, self.step = mission, step
        super().__init__(
            f"somebody else goes on with the mission {mission}",
            where=f"step {step} of its log is there already",
            hint="`plainspoken missions` tells who; nothing was written here",
        )


class EventLog(Protocol):
    """Where the events of missions are kept."""

    def append(
        self,
        mission: MissionId,
        time: str,
        instant: Instant,
        events: Sequence[Event],
        *,
        at: Step | None = None,
    ) -> tuple[Entry, ...]:
        """Keep events, all of them or none, as the next entries of a mission.

        at: the step that the first one has to become, None for whichever is next
        raises OvertakenError: when the log does not end there
        """

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


class Log:
    """An event log in a database, for several missions, threads and processes."""

    def __init__(self, database: Database) -> None:
        self.database = database

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
        self.database.close()

    def append(
        self,
        mission: MissionId,
        time: str,
        instant: Instant,
        events: Sequence[Event],
        *,
        at: Step | None = None,
        also: Also | None = None,
    ) -> tuple[Entry, ...]:
        """Keep events, all of them or none, as the next entries of a mission.

        at: the step that the first one has to become: with it, of two who carry one mission out,
            only one can ever write, and it has written before its robot hears of it
        also: what is kept together with them
        raises OvertakenError: when the log does not end at `at`
        """
        try:
            with self.database.writing() as session:
                step, previous = _end(session, mission)
                if at is not None and step != at:
                    raise OvertakenError(mission, at)
                entries = tuple(
                    Entry(step + index, time, instant, event) for index, event in enumerate(events)
                )
                _insert(session, mission, previous, [(e.step, canonical(e)) for e in entries])
                if also is not None:
                    also(session, step + len(entries) - 1)
        except Duplicate as error:  # PostgreSQL lets two read the same end
            raise OvertakenError(mission, at or 0) from error
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
        with self.database.writing() as session:
            if _end(session, mission)[0]:
                raise PlainspokenError(
                    f"the store has a mission {mission!r} already",
                    where=self.database.place,
                    hint="import it into another store",
                )
            texts = [(link.step, link.text) for link in links]
            _insert(session, mission, genesis(mission), texts)

    def entries(
        self, mission: MissionId, since: Step = 0, most: int | None = None
    ) -> tuple[Entry, ...]:
        """The entries of a mission in order, so many at most; none where it is not known.

        raises InputFileError: naming the step, where an entry cannot be read
        """
        found = []
        for link in self.links(mission, since, most):
            try:
                found.append(entry_from_json(json.loads(link.text)))
            except (ValueError, KeyError, TypeError) as error:
                raise InputFileError(
                    "the entry cannot be read",
                    self.database.place,
                    field=f"step {link.step} of mission {mission}",
                    hint="someone else may have changed the store: verify the mission's log",
                ) from error
        return tuple(found)

    def links(
        self, mission: MissionId, since: Step = 0, most: int | None = None
    ) -> tuple[Link, ...]:
        """The entries of a mission as they are stored, with the hash up to each."""
        sql = "SELECT step, document, hash FROM entry WHERE mission = ? AND step >= ? ORDER BY step"
        limit = () if most is None else (most,)
        with self.database.reading() as session:
            rows = session.rows(sql + " LIMIT ?" * len(limit), (mission, since, *limit))
        return tuple(Link(*row) for row in rows)

    def missions(self) -> tuple[MissionId, ...]:
        """The missions that have entries, oldest first."""
        with self.database.reading() as session:
            rows = session.rows("SELECT mission FROM entry GROUP BY mission ORDER BY min({row})")
        return tuple(mission for (mission,) in rows)

    def verify(self, mission: MissionId) -> Break | None:
        """Where the entries are not as they were written, None where all are.

        A mission that is not known is broken at step 0: its entries may have been deleted.
        """
        links = self.links(mission)
        if not links:
            return Break(mission, 0, "there are no entries of this mission")
        return first_break(mission, links)


class SqliteLog(Log):
    """An event log in one SQLite file."""

    def __init__(self, path: str | Path) -> None:
        """Open a log, made where there is none; `:memory:` is one that nobody else sees.

        raises InputFileError: when the file is no store
        """
        super().__init__(SqliteDatabase(path))


def _end(session: Session, mission: MissionId) -> tuple[Step, Hash]:
    """The next step of a mission, and the hash to chain it to."""
    rows = session.rows(
        "SELECT step, hash FROM entry WHERE mission = ? ORDER BY step DESC LIMIT 1", (mission,)
    )
    return (rows[0][0] + 1, rows[0][1]) if rows else (0, genesis(mission))


def _insert(
    session: Session, mission: MissionId, previous: Hash, texts: Sequence[tuple[Step, str]]
) -> None:
    for step, text in texts:
        previous = chained(previous, text)
        session.change(
            "INSERT INTO entry (mission, step, document, hash) VALUES (?, ?, ?, ?)",
            (mission, step, text, previous),
        )
