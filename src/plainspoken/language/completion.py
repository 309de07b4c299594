"""What a language model is to us: messages in, text out, within a time.

A model is anything that can be called so; a fake is a function. What it says is text and no more:
`prompting` decides whether it can be used.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Any, Protocol

from plainspoken.errors import PlainspokenError
from plainspoken.language.patience import waited_for

Schema = Mapping[str, Any]
"""A JSON schema that the text should keep to; not every model does."""
Seconds = float
PATIENCE: Seconds = 60.0
"""How long a model may take over one reply, unless told otherwise."""


class Role(StrEnum):
    """Whose words a message holds."""

    SYSTEM = "system"
    USER = "user"
    MODEL = "model"


@dataclass(frozen=True, slots=True)
class Message:
    role: Role
    text: str


class LanguageModel(Protocol):
    """Completes a conversation, at temperature 0.

    raises CompletionError: when there is no reply to be had
    """

    def __call__(self, messages: Sequence[Message], schema: Schema, /) -> str: ...


class CompletionError(PlainspokenError):
    """A language model gave no reply: it is missing, refused, or broke down."""


class CompletionTimeoutError(CompletionError):
    """A language model did not reply in time."""

    def __init__(self, seconds: Seconds) -> None:
        self.seconds = seconds
        super().__init__(
            f"the language model did not answer within {seconds:g} s",
            hint="give it more time with --model-timeout, or use a smaller model",
        )


def within(model: LanguageModel, seconds: Seconds) -> LanguageModel:
    """The model, given up on after so many seconds, whatever it is waiting for."""

    def complete(messages: Sequence[Message], schema: Schema, /) -> str:
        return waited_for(lambda: model(messages, schema), seconds, CompletionTimeoutError(seconds))

    return complete
