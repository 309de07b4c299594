"""People as a service: they are asked, and the mission waits until somebody answers.

    services:
      person: {via: human}
    actions:
      ask-human:
        do: {call: person, with: {question: "Is {g} ripe?", answers: [ripe, unripe]}}

A question is a row in the store, so it outlives the process that asked. Whoever answers, with
`plainspoken answer` or from another program or machine, writes into the same row.
"""

from __future__ import annotations

from dataclasses import dataclass

from plainspoken.backends.activities.adapter import COMMON, Around
from plainspoken.backends.activities.document import Section
from plainspoken.backends.questions import Questions
from plainspoken.mission.service import CallId, CallStatus, Fields


def open_adapter(settings: Section | None, around: Around) -> HumanAdapter:
    """The adapter; there is nothing to set."""
    if settings is not None:
        settings.only()
    return HumanAdapter(Questions(around.store.database))


@dataclass(frozen=True)
class HumanAdapter:
    """Makes services that ask people."""

    questions: Questions

    def service(self, settings: Section) -> HumanService:
        settings.only(*COMMON)
        return HumanService(self.questions)

    def close(self) -> None: ...


@dataclass(frozen=True)
class HumanService:
    """Asks a person; `question` and, where only some will do, `answers`."""

    questions: Questions

    def objection(self, fields: Fields) -> str | None:
        unknown = sorted(set(fields) - {"question", "answers"})
        if unknown:
            return f"a person has no field {unknown[0]!r}: there are question and answers"
        if not isinstance(fields.get("question"), str):
            return "a person needs a `question`, in words"
        answers = fields.get("answers", [])
        if not isinstance(answers, list) or not all(isinstance(each, str) for each in answers):
            return "`answers` is a list of words"
        return None

    def begin(self, call: CallId, fields: Fields) -> None:
        self.questions.ask(call, fields["question"], fields.get("answers", ()))

    def status(self, call: CallId) -> CallStatus:
        return self.questions.status(call)

    def cancel(self, call: CallId) -> None:
        self.questions.withdraw(call)

    def reach(self) -> None: ...
