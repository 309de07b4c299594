"""A question as the network hears it: words, and the parts that they play in the mission.

What a thing is called says nothing of what is asked about it, so each name becomes `the thing`,
`the place` or `the person`, and what was learned in one domain serves in another.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import StrEnum

from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.referent import Index, index_of
from plainspoken.questions.spelling import normal


class Role(StrEnum):
    """What a word is in the mission that is asked about."""

    NAMED = "named"
    """It stands for something that was named."""
    ME = "me"
    """It stands for the robot that speaks."""
    KIND = "kind"
    DEED = "deed"
    """A form of the verb of an action."""
    FACT = "fact"
    """A word of what can become so or not so."""


ROLES = tuple(Role)


@dataclass(frozen=True, slots=True)
class Spoken:
    """A word as it is heard."""

    word: str
    roles: frozenset[Role] = frozenset()


_MARKS = re.compile(r"([.,;:!?]+|\s+[-–—]+\s+)(?=\s|$)")
_TITLE = re.compile(r"\b(mr|mrs|ms|dr|prof)\.", re.IGNORECASE)
_BEFORE_A_NAME = frozenset(
    {"the", "a", "an", "my", "your", "our", "that", "this", "which", "old", "mr", "mrs"}
)


def spoken(text: str, lexicon: Lexicon) -> tuple[Spoken, ...]:
    """The words of a text with their roles, marks of punctuation among them."""
    index = index_of(lexicon)
    found: list[Spoken] = []
    for number, part in enumerate(_MARKS.split(_TITLE.sub(r"\1", text))):
        if number % 2:
            found.append(Spoken(part.strip()[0]))
        elif plain := normal(part):
            found += _clause(plain, index, lexicon)
    return tuple(found)


def _clause(plain: str, index: Index, lexicon: Lexicon) -> list[Spoken]:
    found: list[Spoken] = []
    end = 0
    for start, stop, names in index.named_in(plain):
        found += _words(plain[end:start], index)
        end = stop
        if names == (lexicon.me,):
            found.append(Spoken("robot", frozenset({Role.ME})))
            continue
        if not (found and found[-1].word in _BEFORE_A_NAME):
            found.append(Spoken("the"))
        # "Line 9" names nothing where there are four, and is said of a line all the same.
        word = _stand_in(names[0], index, lexicon) if names else "thing"
        found.append(Spoken(word, frozenset({Role.NAMED})))
    return found + _words(plain[end:], index)


def _stand_in(name: str, index: Index, lexicon: Lexicon) -> str:
    """What a name becomes: a place is where the robot can be."""
    if lexicon.is_person(name):
        return "person"
    return "place" if any(index.visits((name,))) else "thing"


def _words(plain: str, index: Index) -> list[Spoken]:
    sets = (
        (Role.KIND, index.kind_words),
        (Role.DEED, index.deed_words),
        (Role.FACT, index.fact_words),
    )
    return [
        Spoken(word, frozenset(role for role, words in sets if word in words))
        for word in plain.split()
    ]
