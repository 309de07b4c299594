"""Questions to people, kept in the store, so that they outlive whoever asked them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime

from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.database import Database
from plainspoken.knowledge.queue import Standing
from plainspoken.mission.robot import Unheard
from plainspoken.mission.service import CallId, CallStatus, Done, Going, NotDone

CANNOT = "cannot"
"""The answer of a person who could not do what was asked."""


@dataclass(frozen=True, slots=True)
class Question:
    """Something that a mission waits to be told. answers: those it understands; none is any."""

    call: CallId
    text: str
    answers: tuple[str, ...]
    asked: str


class Questions:
    """The questions to people, which several processes share."""

    def __init__(self, database: Database) -> None:
        self._database = database

    def ask(self, call: CallId, text: str, answers: Sequence[str]) -> None:
        """Put a question, once; one that was withdrawn is open again."""
        with self._database.writing() as session:
            session.change(
                "INSERT INTO question (call, question, answers, asked) VALUES (?, ?, ?, ?)"
                " ON CONFLICT (call) DO UPDATE SET withdrawn = 0",
                (call, text, "\n".join(answers), datetime.now(UTC).isoformat(timespec="seconds")),
            )

    def open(self) -> tuple[Question, ...]:
        """The questions that nobody has answered, the oldest first.

        Those of a mission that is over are none, also where nobody was there to withdraw them.
        """
        with self._database.reading() as session:
            rows = session.rows(
                "SELECT call, question, answers, asked FROM question"
                " WHERE answer IS NULL AND withdrawn = 0 AND NOT EXISTS (SELECT 1 FROM place"
                " WHERE standing = ? AND substr(call, 1, length(mission) + 1) = mission || '/')"
                " ORDER BY number",
                (Standing.OVER,),
            )
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
        with self._database.writing() as session:
            changed = session.change(
                "UPDATE question SET answer = ?, reporter = ?, answered = ?"
                " WHERE call = ? AND answer IS NULL AND withdrawn = 0",
                (
                    known.get(said.lower(), said),
                    reporter,
                    datetime.now(UTC).isoformat(timespec="seconds"),
                    call,
                ),
            )
        if not changed:  # somebody else was faster
            raise none

    def withdraw(self, call: CallId) -> None:
        """Nobody needs to answer any more."""
        with self._database.writing() as session:
            session.change(
                "UPDATE question SET withdrawn = 1 WHERE call = ? AND answer IS NULL", (call,)
            )

    def status(self, call: CallId) -> CallStatus:
        """What became of a question, as of any call."""
        with self._database.reading() as session:
            rows = session.rows(
                "SELECT question, answer, reporter, withdrawn FROM question WHERE call = ?",
                (call,),
            )
        if not rows:
            return Unheard()
        text, answer, reporter, withdrawn = rows[0]
        if answer == CANNOT:
            return NotDone(f"{reporter} could not: {text}")
        if answer is not None:
            return Done({"answer": answer, "reporter": reporter})
        return (
            NotDone("nobody was asked any longer")
            if withdrawn
            else Going({"doing": f"a person is asked: {text}"})
        )
