"""What is asked: a text becomes a kind, the things it speaks of and the span of time it means.

The grammar of the words and what they speak of decide. No model and no domain: what a question
speaks of is looked up in the lexicon of the mission.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from enum import StrEnum

from plainspoken.questions.grammar import shape_of
from plainspoken.questions.intent import kind_of
from plainspoken.questions.kind import Kind
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.referent import Referents, first_words, referents_of
from plainspoken.questions.spelling import normal


class Span(StrEnum):
    """Which part of the time a question is about."""

    ALL = "all"
    FIRST = "first"
    LAST = "last"
    """The last thing done, or the very next one."""
    BEFORE = "before"
    AFTER = "after"
    EVER = "ever"


@dataclass(frozen=True, slots=True)
class Question:
    """What is asked.

    span:   the part of the past or future that is meant
    yes_no: whether yes or no would answer it
    form:   the question word where it decides the answer: where, which, how many, who, what
    """

    kind: Kind
    text: str
    referents: Referents
    span: Span = Span.ALL
    yes_no: bool = False
    form: str = ""


_FORMS = frozenset({"where", "which", "how many", "who", "whose", "what", "how"})


_ABOUT_PLACES = (Kind.PAST, Kind.FUTURE, Kind.COUNT_HISTORY, Kind.WHEN)
"""Kinds for which going to a place is being there: "did you enter", "have you been to"."""


def _other_deeds(referents: Referents) -> bool:
    """Whether an action is named that does more than go somewhere."""
    going = {name for name, _ in referents.goals}
    return any(name not in going for name in referents.actions)


def question_of(text: str, lexicon: Lexicon) -> Question:
    """Read a question, a report or a command."""
    plain = normal(text)
    referents = referents_of(plain, lexicon)
    me = lexicon.synonyms(lexicon.me) if lexicon.me else frozenset()
    shape = shape_of(
        plain,
        question_mark=text.rstrip().endswith("?"),
        names=first_words(lexicon),
        me=me,
    )
    kind = kind_of(shape, referents, plain)
    if referents.visits and kind in _ABOUT_PLACES and not _other_deeds(referents):
        goes = referents.visits if referents.actions else referents.atoms or referents.visits
        referents = replace(referents, atoms=goes, actions=())
    return Question(
        kind,
        text,
        referents,
        _span(plain, kind),
        shape.yes_no,
        shape.wh if shape.wh in _FORMS else _form(plain),
    )


def _span(plain: str, kind: Kind) -> Span:
    if re.search(r"\bever\b", plain):
        return Span.EVER
    if re.search(r"\bbefore (?!now)\w+", plain):
        return Span.BEFORE
    if re.search(r"\b(?:after|since)\b(?! now)|\w (?:once|when|as soon as)\b", plain):
        return Span.AFTER
    if kind is Kind.PAST and re.search(r"\bfirst\b", plain):
        return Span.FIRST
    last = r"\b(?:last|just|previous|latest|most recent|a moment ago)\b"
    first = r"\b(?:next|right after|immediately)\b"
    if re.search(last, plain) or (kind is Kind.FUTURE and re.search(first, plain)):
        return Span.LAST
    return Span.ALL


def _form(plain: str) -> str:
    found = re.search(r"\b(where|which|how many|who|whose|what|how)\b", plain)
    return found[1] if found else ""
