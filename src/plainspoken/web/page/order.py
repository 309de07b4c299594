"""What is said to a mission that is no question: what it asks for, to be confirmed."""

from __future__ import annotations

import re
from typing import Literal

from plainspoken.questions.kind import Kind
from plainspoken.questions.spelling import normal

Order = Literal["pause", "resume", "cancel", "change", "report"]

_POLITE = r"(?:(?:please|now|ok|okay|just|robot|can you|could you|would you) )*"
_END = (
    r"(?: (?:please|now|here|for a moment|for now|the mission|this mission|it|everything|that))*$"
)
_CONTROLS: dict[Order, re.Pattern[str]] = {
    "pause": re.compile(rf"^{_POLITE}(?:pause|stop|wait|halt|hold on|freeze){_END}"),
    "resume": re.compile(rf"^{_POLITE}(?:go on|resume|continue|carry on|go ahead){_END}"),
    "cancel": re.compile(rf"^{_POLITE}(?:cancel|abort|give up|call off|call it off){_END}"),
}


def order_in(text: str, kind: Kind) -> Order | None:
    """What somebody wants done who says this; None for a question.

    kind: what the question's reader takes the text for
    """
    plain = normal(text)
    for order, words in _CONTROLS.items():
        if words.match(plain):
            return order
    if kind is Kind.REPORT:
        return "report"
    return "change" if kind is Kind.COMMAND else None
