"""The kinds of questions."""

from __future__ import annotations

import re
from enum import StrEnum


class Kind(StrEnum):
    """The kinds of questions, as `ask --batch` writes them."""

    NOW = "now"
    PAST = "past"
    FUTURE = "future"
    WHY_ACTION = "why_action"
    WHY_NOT = "why_not"
    WHY_HAPPENED = "why_happened"
    WHEN = "when"
    STATE = "state"
    PROGRESS = "progress"
    WHAT_IF = "what_if"
    CONSTRAINT = "constraint"
    COUNT_HISTORY = "count_history"
    REPORT = "report"
    COMMAND = "command"
    CHITCHAT = "chitchat"


_SMALL_TALK = re.compile(
    r"^(?:hello|hi|hey|good (?:morning|afternoon|evening|night|day|bye)|goodbye|bye|see you|thanks?"
    r"|thank you|cheers|nice|great|cool|perfect|well done|good (?:job|work|robot)|ok(?:ay)?|sorry"
    r"|i (?:love|like) you)\b(?: (?:a lot|\w+)){0,3}$"
)
_OUT_OF_SCOPE = re.compile(
    r"^(?:who|what) are you$|\byour (?:name|favou?rite|age|birthday|family|opinion|feelings?)\b"
    r"|^how (?:are you|do you (?:do|feel)|old are you)(?: \w+)?$"
    r"|\b(?:joke|weather|meaning of life)\b"
    r"|^are you (?:happy|sad|tired|alive|human|conscious|bored|a robot|real)\b|system prompt"
    r"|do you (?:like|love|dream|enjoy|believe in|speak)\b"
    r"|^who (?:made|built|created|designed)(?: you)?$"
    r"|^what can (?:you (?:do|answer|tell|talk about)|i ask)|\bsing\b|^tell me about yourself"
    r"|^help(?: me)?$|^happy \w+$|^pretend (?:to|you)\b|^(?:ignore|disregard|forget) "
    r"(?:all |any )?(?:your|previous|the (?:above|previous|prior)|these)\b"
)


def is_small_talk(plain: str) -> bool:
    """Whether a normalised text is a greeting, or about what no mission is about."""
    return bool(_SMALL_TALK.search(plain) or _OUT_OF_SCOPE.search(plain))
