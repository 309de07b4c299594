"""What a robot was told and what became of it, in the store before it is done.

A note is durable before the call that it is about is made. A process that takes over, on whichever
machine, reads it, walks the activity again, and finds each call where the dead one left it: so no
call is made twice because nobody remembers it.
"""

from __future__ import annotations

import json
from typing import Any

from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.database import Database


class Journal:
    """Notes by subject and key; the last one counts. Programs see what the others have noted."""

    def __init__(self, database: Database) -> None:
        self._database = database

    def get(self, subject: str, key: str) -> Any:
        """The last note; None where there is none."""
        with self._database.reading() as session:
            rows = session.rows(
                "SELECT document FROM note WHERE subject = ? AND topic = ?", (subject, key)
            )
        if not rows:
            return None
        try:
            return json.loads(rows[0][0])
        except ValueError as error:
            raise PlainspokenError(
                f"the note {key!r} on {subject} cannot be read",
                where=self._database.place,
                hint="someone else may have changed the store",
            ) from error

    def note(self, subject: str, key: str, value: Any) -> None:
        """Write a note down; it is durable when this returns."""
        with self._database.writing() as session:
            session.change(
                "INSERT INTO note (subject, topic, document) VALUES (?, ?, ?)"
                " ON CONFLICT (subject, topic) DO UPDATE SET document = excluded.document",
                (subject, key, json.dumps(value, ensure_ascii=False)),
            )
