"""Questions to people, in a file beside the store, so that they outlive whoever asked them."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from plainspoken.errors import PlainspokenError
from plainspoken.mission.robot import Unheard
from plainspoken.mission.service import CallId, CallStatus, Done, Going, NotDone

QUESTIONS = ".questions.sqlite"
"""Where questions are kept: beside the store, under its name."""
CANNOT = "cannot"
"""The answer of a person who could not do what was asked."""
_TABLE = """
create table if not exists question (
    call text primary key, question text not null, answers text not null, asked text not null,
    answer text, reporter text, answered text, withdrawn integer not null default 0
)
"""


@dataclass(frozen=True, slots=True)
class Question:
    """Something that a mission waits to be told. answers: those it understands; none is any."""

    call: CallId
    text: str
    answers: tuple[str, ...]
    asked: str


class Questions:
    """The questions to people, in a file that several processes share."""

    def __init__(self, store: Path) -> None:
        self._path = store.with_name(store.name + QUESTIONS)

    def ask(self, call: CallId, text: str, answers: Sequence[str]) -> None:
        """Put a question, once."""
        with self._connection() as connection:
            connection.execute(
                "insert or ignore into question (call, question, answers, asked)"
                " values (?, ?, ?, ?)",
                (call, text, "\n".join(answers), datetime.now(UTC).isoformat(timespec="seconds")),
            )

    def open(self) -> tuple[Question, ...]:
        """The questions that nobody has answered, the oldest first."""
        with self._connection() as connection:
            rows = connection.execute(
                "select call, question, answers, asked from question"
                " where answer is null and not withdrawn order by rowid"
            ).fetchall()
        return tuple(
            Question(call, text, tuple(answers.split("\n")) if answers else (), asked)
            for call, text, answers, asked in rows
        )

    def answer(self, call: CallId, answer: str, reporter: str) -> None:
        """Answer an open question.

        raises PlainspokenError: when there is none, or it has other answers
        """
        question = next((each for each in self.open() if each.call == call), None)
        none = PlainspokenError(
            f"no open question {call!r}", hint="`plainspoken answer` lists those there are"
        )
        if question is None:
            raise none
        said = answer.strip()
        known = {each.lower(): each for each in (*question.answers, CANNOT)}
        if question.answers and said.lower() not in known:
            raise PlainspokenError(
                f"{said!r} does not answer: {question.text}",
                hint=f"one of: {', '.join(known.values())}",
            )
        with self._connection() as connection:
            changed = connection.execute(
                "update question set answer = ?, reporter = ?, answered = ?"
                " where call = ? and answer is null and not withdrawn",
                (
                    known.get(said.lower(), said),
                    reporter,
                    datetime.now(UTC).isoformat(timespec="seconds"),
                    call,
                ),
            )
        if not changed.rowcount:  # somebody else was faster
            raise none

    def withdraw(self, call: CallId) -> None:
        """Nobody needs to answer any more."""
        with self._connection() as connection:
            connection.execute(
                "update question set withdrawn = 1 where call = ? and answer is null", (call,)
            )

    def status(self, call: CallId) -> CallStatus:
        """What became of a question, as of any call."""
        with self._connection() as connection:
            row = connection.execute(
                "select question, answer, reporter, withdrawn from question where call = ?",
                (call,),
            ).fetchone()
        if row is None:
            return Unheard()
        text, answer, reporter, withdrawn = row
        if answer == CANNOT:
            return NotDone(f"{reporter} could not: {text}")
        if answer is not None:
            return Done({"answer": answer, "reporter": reporter})
        return (
            NotDone("nobody was asked any longer")
            if withdrawn
            else Going({"doing": f"a person is asked: {text}"})
        )

    @contextmanager
    def _connection(self) -> Iterator[sqlite3.Connection]:
        """Opened for each use: another process may be at it, and threads share nothing."""
        try:
            self._path.parent.mkdir(parents=True, exist_ok=True)
            with closing(sqlite3.connect(self._path, timeout=10)) as connection, connection:
                connection.execute(_TABLE)
                yield connection
        except sqlite3.Error as error:
            raise PlainspokenError(
                f"cannot use the questions to people: {error}", where=str(self._path)
            ) from error
