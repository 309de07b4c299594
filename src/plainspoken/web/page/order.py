"""Plain orders to a mission, which need no understanding: pause, go on, cancel."""

from __future__ import annotations

import re
from typing import Literal

from plainspoken.questions.spelling import normal

Order = Literal["pause", "resume", "cancel"]

_POLITE = r"(?:(?:please|now|ok|okay|just|robot|can you|could you|would you) )*"
_END = r"(?: (?:please|now|here|for a moment|for now|the mission|this mission|it|everything|that))*"
_ORDERS: dict[Order, re.Pattern[str]] = {
    "pause": re.compile(rf"{_POLITE}(?:pause|stop|wait|halt|hold on|freeze){_END}"),
    "resume": re.compile(rf"{_POLITE}(?:go on|resume|continue|carry on|go ahead){_END}"),
    "cancel": re.compile(rf"{_POLITE}(?:cancel|abort|give up|call off|call it off){_END}"),
}


def order_in(text: str) -> Order | None:
    """The order that a text is, and nothing more: "stop", and not "stop at line 2"."""
    plain = normal(text)
    return next((order for order, words in _ORDERS.items() if words.fullmatch(plain)), None)
