"""Which of several readings an answer chooses: "the first", "yes", "right after", "the red one"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from plainspoken.language.extracted import Reading
from plainspoken.language.word import ORDINALS, words

_YES_WORDS = """
    yes yeah yep yup sure right correct exactly indeed ok okay affirmative y aye absolutely
    please do that's it is what i mean meant that
"""
_YES = frozenset(_YES_WORDS.split())
_SURELY = frozenset(
    ("yes", "yeah", "yep", "yup", "sure", "right", "correct", "exactly", "indeed", "ok", "okay",
     "affirmative", "y", "aye", "absolutely")
)  # fmt: skip
_NO = frozenset(("no", "nope", "neither", "none", "n", "nah", "wrong", "negative"))
_LIGHT_WORDS = """
    the a an one ones please i mean meant it is to of option number answer choice would like take
    that this s go with by let us say well oh just only do so be go visit
"""
_LIGHT = frozenset(_LIGHT_WORDS.split())
_LETTERS = {letter: number for number, letter in enumerate("abcdef", start=1)}


@dataclass(frozen=True, slots=True)
class Declined:
    """None of the readings is meant."""


def chosen(text: str, readings: Sequence[Reading]) -> Reading | Declined | None:
    """The reading that an answer chooses; None where it is no answer, or none that can be told."""
    said = [word.text for word in words(text) if not word.is_mark]
    if not said:
        return None
    named = _by_name(said, readings)
    if named is not None:
        return named
    if said[0] in _NO and set(said[1:]) <= _NO | _YES | _LIGHT | {"not", "of", "them", "these"}:
        return Declined()
    if len(readings) == 1 and said[0] in _SURELY and set(said) <= _YES | _LIGHT:
        return readings[0]
    return _by_number(said, readings)


def _by_number(said: Sequence[str], readings: Sequence[Reading]) -> Reading | None:
    telling = [text for text in said if text not in _LIGHT - {"a"}]
    if len(telling) > 1:
        telling = [text for text in telling if text != "a"]
    if len(telling) != 1 or len(readings) < 2:
        return None
    (text,) = telling
    if text in ("last", "latter"):
        return readings[-1]
    if text == "former":
        return readings[0]
    (word,) = words(text)
    number = ORDINALS.get(text) or (word.number if word.number.isdigit() else None)
    place = int(number) if number else _LETTERS.get(text, 0)
    return readings[place - 1] if 0 < place <= len(readings) else None


def _by_name(said: Sequence[str], readings: Sequence[Reading]) -> Reading | None:
    """The one reading whose answer has all words that tell, where no other has."""
    if len(readings) < 2:
        return None
    telling = [stems for text in said if text not in _LIGHT for stems in [_stems(text)]]
    own = [_own(each) for each in readings]
    fitting = [
        reading
        for reading, known in zip(readings, own, strict=True)
        if telling and all(stems & known for stems in telling)
    ]
    return fitting[0] if len(fitting) == 1 else None


def _own(reading: Reading) -> frozenset[str]:
    text = reading.answer or reading.english
    return frozenset(stem for word in words(text) for stem in word.stems)


def _stems(text: str) -> frozenset[str]:
    return frozenset(stem for word in words(text) for stem in word.stems)
