"""The words of a sentence that turn its meaning round when one of them is heard wrong.

A recogniser that drops "never" makes an order of a ban. So these words are shown in a way that
nobody reads over, wherever somebody confirms a sentence that was spoken.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from plainspoken.language.word import NUMBERS, ORDINALS, Word, words


class Weight(StrEnum):
    """Why a word deserves a second look."""

    NEGATION = "negation"
    LIMIT = "limit"  # until when, from when, how far: "until", "before", "only"
    NUMBER = "number"
    UNCLEAR = "unclear"  # the recogniser was not sure


@dataclass(frozen=True, slots=True)
class Emphasis:
    """A word to look at again. start, end: characters of the text."""

    start: int
    end: int
    weight: Weight

    def to_json(self) -> dict[str, Any]:
        return {"start": self.start, "end": self.end, "weight": str(self.weight)}


_NEGATION_WORDS = """
    not never no none nor neither nobody nothing nowhere without avoid avoiding except cannot
    forbidden stop cease refrain
"""
_LIMIT_WORDS = """
    until till unless before after while only always every whenever
    if then first last most least exactly again
"""
_WEIGHTS = dict.fromkeys(_LIMIT_WORDS.split(), Weight.LIMIT)
_WEIGHTS |= dict.fromkeys(_NEGATION_WORDS.split(), Weight.NEGATION)
_WEIGHTS |= dict.fromkeys((*NUMBERS, *ORDINALS, "once", "twice", "thrice"), Weight.NUMBER)
_INSIDE_A_WORD = "'\u2019"


def emphases(text: str) -> tuple[Emphasis, ...]:
    """The negations, limits and numbers of a sentence, in its order, each a whole word."""
    found: dict[tuple[int, int], Emphasis] = {}
    for word in words(text):
        weight = weight_of(word)
        if weight is not None:
            start, end = _whole(text, word)
            found[start, end] = Emphasis(start, end, weight)
    return tuple(found.values())


def weight_of(word: Word) -> Weight | None:
    """Why a word deserves a second look, if it does."""
    return Weight.NUMBER if word.text.isdigit() else _WEIGHTS.get(word.text)


def _whole(text: str, word: Word) -> tuple[int, int]:
    """The place of a word with what is printed as one word with it: "n't" is in "don't"."""
    if word.text != "not":
        return word.start, word.end
    start, end = word.start, word.end
    while start and (text[start - 1].isalnum() or text[start - 1] in _INSIDE_A_WORD):
        start -= 1
    while end < len(text) and text[end].isalnum():
        end += 1
    return start, end
