"""A question and a log become an answer: words, and the claims and evidence they rest on."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import assert_never

from plainspoken.questions.alternative import tell_why_not
from plainspoken.questions.chance import tell_cause, tell_what_if
from plainspoken.questions.claim import Answer, Draft
from plainspoken.questions.doubt import asks_how_known, tell_how_known
from plainspoken.questions.fact import tell_state, tell_when
from plainspoken.questions.future import tell_future
from plainspoken.questions.kind import Kind
from plainspoken.questions.length import Length
from plainspoken.questions.moment import Moment
from plainspoken.questions.morphology import listed
from plainspoken.questions.past import tell_count, tell_past, tell_so_far
from plainspoken.questions.present import tell_now
from plainspoken.questions.progress import tell_constraint, tell_progress
from plainspoken.questions.question import Question, question_of
from plainspoken.questions.reason import tell_why
from plainspoken.questions.source import tell_change, tell_source
from plainspoken.world.event import Entry, Step

CAN_ASK = (
    "You can ask what I'm doing, what I've done, what comes next and why, how far I am, and how "
    "things stand"
)


def answer(
    question: str,
    entries: Sequence[Entry],
    at: Step | None = None,
    *,
    length: Length = Length.BRIEF,
) -> Answer:
    """Answer a question about a mission as if asked at a step of its log.

    at: the last step that is known, None for the end of the log
    raises PlainspokenError: when the log does not begin with an accepted mission
    """
    return answer_at(question, Moment(entries, at), length=length)


def answer_at(question: str | Question, moment: Moment, *, length: Length = Length.BRIEF) -> Answer:
    """Answer a question at a moment; for many questions about one."""
    asked = question_of(question, moment.lexicon) if isinstance(question, str) else question
    draft = Draft(moment, length)
    _tell(draft, asked)
    return draft.finish(asked.kind)


def _told_before_its_kind(draft: Draft, question: Question) -> bool:
    """Answer what a question is about whatever its kind: where facts come from, who wants what."""
    if draft.moment.facts is not None and asks_how_known(question):
        tell_how_known(draft, question)  # not every fact is known: each says where it comes from
        return True
    if tell_source(draft, question) or tell_change(draft, question):
        return True
    if question.other is None:
        return False
    _ask_back(draft, question.kind, question.other)
    return True


def _tell(draft: Draft, question: Question) -> None:
    if _told_before_its_kind(draft, question):
        return
    answered = True
    match question.kind:
        case Kind.NOW:
            tell_now(draft, question)
        case Kind.PAST:
            tell_past(draft, question)
        case Kind.FUTURE:
            tell_future(draft, question)
        case Kind.WHY_ACTION:
            tell_why(draft, question)
        case Kind.STATE:
            if _asks_what_is_done(question):
                tell_progress(draft, question)
            else:
                tell_state(draft, question)
        case Kind.PROGRESS:
            tell_progress(draft, question)
        case Kind.CONSTRAINT:
            if not tell_constraint(draft, question):
                tell_so_far(draft, question, hoped=False)
        case Kind.COUNT_HISTORY:
            tell_count(draft, question)
        case Kind.WHEN:
            tell_when(draft, question)
        case Kind.WHY_NOT:
            answered = tell_why_not(draft, question)
            if not answered and not (question.referents.actions or question.referents.objects):
                tell_now(draft, question)  # "What's the hold-up?": what I'm at, and why.
                answered = True
        case Kind.WHY_HAPPENED:
            answered = tell_cause(draft, question)
            if not answered and (question.referents.actions or question.referents.objects):
                tell_why(draft, question)
                answered = True
            elif not answered and draft.moment.ended is not None:
                tell_now(draft, question)  # "How did it end?"
                answered = True
        case Kind.WHAT_IF:
            answered = tell_what_if(draft, question)
        case Kind.REPORT:
            _not_yet(
                draft,
                "You are telling me something, and here I note nothing: `plainspoken report` does",
            )
        case Kind.COMMAND:
            _not_yet(
                draft,
                "You want something done, and here I only answer: `plainspoken missions change` "
                "changes a mission",
            )
        case Kind.CHITCHAT:
            _chat(draft)
        case _:
            assert_never(question.kind)
    if not answered:
        _not_yet(draft, "I can't answer that yet")


def _asks_what_is_done(question: Question) -> bool:
    """`Which lines are done?`: of things of a kind, and no fact of them."""
    done = re.search(r"\b(?:done|finished|left|through)\b", question.text.lower())
    return bool(done and question.referents.kinds and not question.referents.predicates)


_WANTED = {
    Kind.NOW: "what I'm doing",
    Kind.PAST: "what I've done",
    Kind.FUTURE: "what I'll do",
    Kind.WHY_ACTION: "what I do something for",
    Kind.WHY_NOT: "why I don't do something",
    Kind.WHY_HAPPENED: "how something came about",
    Kind.WHEN: "when something is or was",
    Kind.STATE: "how things stand",
    Kind.PROGRESS: "how far I am",
    Kind.WHAT_IF: "what I do if something comes about",
    Kind.CONSTRAINT: "whether I keep to what you asked",
    Kind.COUNT_HISTORY: "how often I did something",
}
"""What a person may want to know, by the kind of the question."""


def _ask_back(draft: Draft, *kinds: Kind) -> None:
    """Ask what is meant, where a text may be of several kinds."""
    draft.known = False
    wanted = [f"ask {_WANTED[kind]}" for kind in kinds if kind in _WANTED]
    if Kind.REPORT in kinds:
        wanted.append("tell me something")
    if Kind.COMMAND in kinds:
        wanted.append("have me do something")
    draft.say(
        f"I'm not sure what you mean. Do you want to {listed(wanted, 'or')}?"
        if wanted
        else f"I'm not sure what you mean. {CAN_ASK}"
    )


def _not_yet(draft: Draft, why: str) -> None:
    draft.known = False
    draft.say(why)
    draft.say(CAN_ASK)


def _chat(draft: Draft) -> None:
    draft.known = False
    draft.say(f"I can only talk about my mission. {CAN_ASK}")
