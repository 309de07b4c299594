"""What is asked: a text becomes a kind, the things it speaks of and the span of time it means.

Rules of grammar and a listener that has learned say of which kind it is, no domain known to
either: what a question speaks of is looked up in the lexicon of the mission.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from enum import StrEnum

from plainspoken.questions.agreement import settled
from plainspoken.questions.grammar import Shape, shape_of
from plainspoken.questions.intent import kind_of
from plainspoken.questions.kind import Kind
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.listener import heard
from plainspoken.questions.referent import Referents, first_words, referents_of
from plainspoken.questions.spelling import normal
from plainspoken.questions.spoken import spoken


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
    other:  what else it may be, where it is not clear enough to be answered
    """

    kind: Kind
    text: str
    referents: Referents
    span: Span = Span.ALL
    yes_no: bool = False
    form: str = ""
    other: Kind | None = None


_FORMS = frozenset({"where", "which", "how many", "who", "whose", "what", "how"})


_ABOUT_PLACES = (Kind.PAST, Kind.FUTURE, Kind.COUNT_HISTORY, Kind.WHEN)
"""Kinds for which going to a place is being there: "did you enter", "have you been to"."""


_HANGS_ON = (
    r"(?:and |but |so |then )?(?:if|when|once|after|before|as soon as|while|whenever|until|suppose"
)
_HANGS_ON += r"|supposing|assum\w+|imagine|say|let'?s|in case|provided|should|given|what if)\b"
_ASKS = (
    r"(?:and |but |so )?"
    r"(?:what|where|which|who|why|how|when|are|is|do|does|did|have|has|will|can)\b"
)


def _asked_part(text: str) -> str:
    """The clause that asks, without remarks before it: `I don't get it, why wash the onion?`."""
    parts = [part.strip() for part in re.split(r"[.!?;:,]\s+|\s+[-–—]+\s+", text) if part.strip()]
    asking = [
        index
        for index, part in enumerate(parts)
        if re.match(_ASKS, part, re.IGNORECASE) and part.count(" ") > 1  # "Are you?" is a tag.
    ]
    if not asking or any(re.match(_HANGS_ON, part, re.IGNORECASE) for part in parts):
        return text
    first = asking[0]
    mark = "?" if text.rstrip().endswith("?") else ""
    # "The onion, have you washed it?" names its object first; a name is no remark.
    return ", ".join(parts[first:]) + mark if len(parts[0].split()) > 2 and first else text


def _other_deeds(referents: Referents) -> bool:
    """Whether an action is named that does more than go somewhere."""
    going = {name for name, _ in referents.goals}
    return any(name not in going for name in referents.actions)


def grammar_of(text: str, lexicon: Lexicon) -> tuple[str, Shape]:
    """The part of a text that asks, normalised, and its grammar."""
    plain = normal(_asked_part(text))
    shape = shape_of(
        plain,
        question_mark=text.rstrip().endswith("?"),
        names=first_words(lexicon),
        me=lexicon.synonyms(lexicon.me) if lexicon.me else frozenset(),
    )
    return plain, shape


def ruled_kind(text: str, lexicon: Lexicon) -> Kind:
    """The kind by the rules alone."""
    plain, shape = grammar_of(text, lexicon)
    return kind_of(shape, referents_of(normal(text), lexicon), plain)


def question_of(text: str, lexicon: Lexicon) -> Question:
    """Read a question, a report or a command."""
    referents = referents_of(normal(text), lexicon)
    plain, shape = grammar_of(text, lexicon)
    ruled = kind_of(shape, referents, plain)
    found = settled(ruled, heard(spoken(text, lexicon), shape))
    kind = found.kind
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
        found.other if found.unsure else None,
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
