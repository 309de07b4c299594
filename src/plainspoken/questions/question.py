"""What is asked: a text becomes a kind, the things it speaks of and the span of time it means.

Rules over English words, in an order that is the rule: the first that fits decides. No model and
no domain: what a question speaks of is looked up in the lexicon of the mission.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import StrEnum

from plainspoken.questions.kind import (
    AUXILIARY,
    COMMAND,
    OUT_OF_SCOPE,
    REPORT,
    RULES,
    SMALL_TALK,
    Kind,
)
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.referent import Referents, normal, referents_of


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


_YES_NO = re.compile(rf"^(?:and |so |but |then |now )?{AUXILIARY} ")
_REQUEST = re.compile(r"^(?:please )?(?:can|could|would) you (?:please |kindly |just |now )?(\w+)")
_IMPERATIVE = re.compile(r"^(?:please |now |robot |then )*(\w+)")
_TELLING = frozenset(
    {"tell", "show", "list", "give", "name", "explain", "describe", "say", "report"}
    | {"summarise", "summarize", "recap", "remind"}
)


def question_of(text: str, lexicon: Lexicon) -> Question:
    """Read a question, a report or a command."""
    plain = normal(text)
    referents = referents_of(plain, lexicon)
    kind = _kind(plain, referents, is_question=text.rstrip().endswith("?"))
    return Question(
        kind,
        text,
        referents,
        _span(plain, kind),
        _YES_NO.match(plain) is not None,
        _form(plain),
    )


def _kind(plain: str, referents: Referents, *, is_question: bool) -> Kind:
    empty = not referents.objects
    if empty and (SMALL_TALK.search(plain) or OUT_OF_SCOPE.search(plain)):
        return Kind.CHITCHAT
    if re.match(r"(?:please )?do not (?!you\b|i\b)", plain) and not is_question:
        return Kind.COMMAND
    asked = re.match(
        rf"(?:and |so |but |then )*(?:what|where|which|who|whose|how|why|when|{AUXILIARY})\b", plain
    )
    request = _REQUEST.match(plain)
    if request and request[1] not in _TELLING and request[1] in referents.verbs:
        return Kind.COMMAND
    told = re.sub(
        r"^(?:(?:please|can you|could you|would you|kindly|now) )*(?:tell|show|remind|explain|"
        r"describe|say|give|list|name)(?: to)?(?: me| us)? ?(?:about |again )?",
        "",
        plain,
    )
    if not asked and told == plain:
        imperative = _IMPERATIVE.match(plain)
        if COMMAND.match(plain) and not plain.startswith("now what"):
            return Kind.COMMAND
        if imperative and imperative[1] in referents.verbs and not is_question:
            return Kind.COMMAND
        if REPORT.match(plain) and not is_question:
            return Kind.REPORT
    if told != plain:
        found = _by_rules(told or plain)
        return found if found is not None else Kind.STATE
    found = _by_rules(plain)
    if found is not None:
        return _corrected(found, plain, referents)
    return Kind.STATE if referents.objects or referents.predicates else Kind.CHITCHAT


def _by_rules(plain: str) -> Kind | None:
    for kind, pattern in RULES:
        if pattern.search(plain):
            return kind
    return None


def _corrected(kind: Kind, plain: str, referents: Referents) -> Kind:
    """Where the words alone mislead: what is spoken of decides between neighbours."""
    if kind is Kind.COUNT_HISTORY and plain.startswith("how many"):
        # "How many clean mugs did you find" counts what is so, "how many did you pick" deeds.
        counts_deeds = bool(referents.actions) or re.search(r"\b(?:times|actions|steps)\b", plain)
        return Kind.COUNT_HISTORY if counts_deeds else Kind.STATE
    if kind is Kind.STATE and plain.startswith("are you ") and referents.actions:
        return kind if referents.atoms else Kind.NOW
    passive = re.match(r"(?:who|has|have|was|were) ", plain)
    if kind is Kind.STATE and passive and referents.actions and not referents.atoms:
        return Kind.PAST
    if (
        kind is Kind.PROGRESS
        and referents.objects
        and not re.search(r"\b(?:you|we|it|mission|job|task|work|left|how|progress)\b", plain)
    ):
        return Kind.STATE
    if (
        kind is Kind.NOW
        and re.match(r"(?:where|is|are|which|how many) ", plain)
        and (re.match(r"where", plain) or referents.predicates)
    ):
        return Kind.STATE
    return kind


def _span(plain: str, kind: Kind) -> Span:
    if re.search(r"\bever\b", plain):
        return Span.EVER
    if re.search(r"\bbefore (?!now)\w+", plain):
        return Span.BEFORE
    if re.search(r"\b(?:after|since)\b(?! now)", plain):
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
