"""A harbour to speak of, and language models that are functions."""

import json
from collections.abc import Callable, Sequence

from plainspoken.language.completion import LanguageModel, Message, Schema
from plainspoken.language.grounding import Vocabulary
from plainspoken.world.landmark import Landmark, LandmarkType

_LANDMARKS = (
    Landmark("at_quay", "the quay", LandmarkType.LOCATION),
    Landmark("at_dock", "the dock", LandmarkType.LOCATION),
    Landmark("at_tower", "the tower", LandmarkType.LOCATION),
    Landmark("full_tank", "the tank is full", LandmarkType.CONDITION),
    Landmark("refuel_executed", "to refuel", LandmarkType.ACTION),
)
HARBOUR = Vocabulary.of({each.id: each for each in _LANDMARKS})
SAID = "Go to the quay, and after that to the dock."
QUAY, DOCK = ("the quay", "at_quay"), ("the dock", "at_dock")
SEQUENCE = "F(at_quay & F at_dock)"


def reply(
    *readings: str | tuple[str, str], spoken: Sequence[tuple[str, str]] = (QUAY, DOCK)
) -> str:
    """A well-formed reply; a reading is its literal formula, or that and the executable one."""
    pairs = [(each, each) if isinstance(each, str) else each for each in readings]
    return json.dumps(
        {
            "expressions": [{"text": text, "symbol": symbol} for text, symbol in spoken],
            "readings": [{"literal": one, "executable": other} for one, other in pairs],
        }
    )


class Fake:
    """A model that says one thing after another, and remembers what it was told."""

    def __init__(self, *replies: str | Exception) -> None:
        self._replies = list(replies)
        self.asked: list[Sequence[Message]] = []

    def __call__(self, messages: Sequence[Message], schema: Schema, /) -> str:
        self.asked.append(messages)
        said = self._replies.pop(0) if len(self._replies) > 1 else self._replies[0]
        if isinstance(said, Exception):
            raise said
        return said


def answering(answer: Callable[[str], str]) -> LanguageModel:
    """A model that is a function of the last message."""
    return lambda messages, _: answer(messages[-1].text)
