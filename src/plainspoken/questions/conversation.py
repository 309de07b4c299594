"""Questions, reports and changes of mind in a row, about a mission that goes on.

    conversation = Conversation()
    said = conversation.say("I cleared line 2 myself", moment)   # "... Is that right?"
    said = said.then.say("yes", moment)
    said.agreed                                                  # what to tell the mission

Nothing is told the mission that was not said back and agreed to.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from plainspoken.language.extracted import Status
from plainspoken.mission.mission import mission_from
from plainspoken.mission.observation import ChangeAsked, Told
from plainspoken.questions.change import ChangeOfMind, wanted
from plainspoken.questions.claim import Answer
from plainspoken.questions.dialogue import Dialogue
from plainspoken.questions.kind import Kind
from plainspoken.questions.length import Length
from plainspoken.questions.moment import Moment
from plainspoken.questions.question import question_of
from plainspoken.questions.report import Report, settled_on, understood
from plainspoken.questions.spelling import normal

_YES = re.compile(
    r"(?:yes|yeah|yep|yup|y|sure|right|correct|exactly|ok|okay|that is right|agreed|please do)"
    r"(?: please| that is right| exactly| thanks)*"
)
_NO = re.compile(r"(?:no|nope|n|wrong|neither|none|not at all|never ?mind)(?: \w+){0,4}")
_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth")


@dataclass(frozen=True, slots=True)
class Said:
    """What is answered, the conversation after it, and what was agreed to, if anything was."""

    answer: Answer
    then: Conversation
    agreed: Report | ChangeOfMind | None = None


@dataclass(frozen=True, slots=True)
class Conversation:
    """What was spoken of; pending: what was said back, and waits for a yes."""

    dialogue: Dialogue = field(default_factory=Dialogue)
    pending: Report | ChangeOfMind | None = None

    def say(self, text: str, moment: Moment, *, length: Length = Length.BRIEF) -> Said:
        """Take what a person says: an answer where something is pending, or anything else."""
        if self.pending is not None:
            said = self._answered(self.pending, text, moment)
            if said is not None:
                return said
        kind = question_of(text, moment.lexicon).kind
        if kind in (Kind.REPORT, Kind.COMMAND) and moment.ended is None:
            return self._told(text, kind, moment)
        answer, dialogue = self.dialogue.ask(text, moment, length=length)
        return Said(answer, Conversation(dialogue))

    def _told(self, text: str, kind: Kind, moment: Moment) -> Said:
        mission = mission_from(moment.entries)
        heard: Report | ChangeOfMind = (
            understood(text, moment.lexicon, mission.world, moment.mission.unknown)
            if kind is Kind.REPORT
            else wanted(text, mission, moment.lexicon)
        )
        if kind is Kind.REPORT and heard.status is Status.REJECT:
            # "Line 3 first" states nothing, and is no order by its grammar either.
            change = wanted(text, mission, moment.lexicon)
            if change.status is not Status.REJECT:
                heard, kind = change, Kind.COMMAND
        if heard.status is Status.REJECT:
            return self._say(kind, heard.reason or "That is not clear.", None)
        return self._say(kind, _asked(heard), heard)

    def _answered(self, pending: Report | ChangeOfMind, text: str, moment: Moment) -> Said | None:
        """What follows an answer; None where something else was said."""
        kind = Kind.REPORT if isinstance(pending, Report) else Kind.COMMAND
        plain = normal(text)
        if _NO.fullmatch(plain):
            return self._say(kind, "Then nothing is changed.", None)
        if pending.status is Status.CLARIFY:
            number = _which(plain, [each.answer for each in pending.choices])
            if number is None:
                return None
            if isinstance(pending, Report):
                pending = settled_on(pending, pending.choices[number], moment.lexicon)
            else:
                pending = pending.settled_on(pending.choices[number])
        elif not _YES.fullmatch(plain):
            return None
        if isinstance(pending, Report):
            return self._say(kind, f"Noted: {pending.english}.", None, pending)
        return self._say(kind, "All right: I plan for that before the next action.", None, pending)

    def _say(
        self,
        kind: Kind,
        text: str,
        pending: Report | ChangeOfMind | None,
        agreed: Report | ChangeOfMind | None = None,
    ) -> Said:
        answer = Answer(kind, text, known=agreed is not None)
        return Said(answer, replace(self, pending=pending), agreed)


def message_of(agreed: Report | ChangeOfMind, by: str) -> Told | ChangeAsked:
    """What a mission is told once somebody has agreed to what was said back."""
    if isinstance(agreed, Report):
        return Told(by, agreed.text, agreed.added, agreed.deleted)
    if agreed.meant is None:
        raise AssertionError("nobody can agree to what is not clear")
    return ChangeAsked(by, agreed.text, agreed.meant.clauses, agreed.meant.english)


def _asked(heard: Report | ChangeOfMind) -> str:
    """What was understood, as a question."""
    if heard.status is Status.OK:
        if isinstance(heard, Report):
            return f"I understand: {heard.english}. Is that right?"
        english = heard.meant.english if heard.meant else ""
        return f"From now on: {english} Is that right?"
    answers = [each.answer for each in heard.choices]
    listed = " ".join(f"({number}) {each}" for number, each in enumerate(answers, start=1))
    return " ".join(filter(None, (heard.question, listed)))


def _which(plain: str, answers: Sequence[str]) -> int | None:
    """The answer that some words choose."""
    if len(answers) == 1 and _YES.fullmatch(plain):
        return 0
    for number, ordinal in enumerate(_ORDINALS[: len(answers)]):
        if re.fullmatch(rf"(?:the )?(?:{number + 1}|{ordinal})(?: one)?", plain):
            return number
    fitting = [
        number
        for number, each in enumerate(answers)
        if plain and re.search(rf"\b{re.escape(plain)}\b", normal(each))
    ]
    return fitting[0] if len(fitting) == 1 else None
