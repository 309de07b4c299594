"""Relative clauses on "any": "never enter any site that is not safe", unfolded for each thing.

What the clause says of a thing becomes the condition under which the sentence goes for it: "while
site 1 is not safe, never enter site 1; while site 2 is not safe, ...".
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from plainspoken.language.agency import mover_at
from plainspoken.language.frame import Thing
from plainspoken.language.grounding import PREPOSITIONS, Shape, Vocabulary
from plainspoken.language.reference import references
from plainspoken.language.word import Word

_ANY = frozenset(("any", "every", "each", "all", "a"))
_RELATIVE = frozenset(("that", "which", "who"))
_STOPS = frozenset((".", ";", "!", "?", ":"))
_CONNECTORS = frozenset(
    ("if", "when", "whenever", "while", "until", "till", "unless", "before", "after", "once")
)
_MODALS = frozenset(
    ("must", "should", "has", "have", "needs", "need", "may", "shall", "will", "can", "cannot")
)
_DENIALS = frozenset(("never", "not", "no", "avoid", "without", "nowhere"))


MembersOf = Callable[[Sequence[Word], int, int, Vocabulary], tuple[Thing, ...]]


def unfolded(
    said: tuple[Word, ...], vocabulary: Vocabulary, members_of: MembersOf
) -> tuple[Word, ...]:
    """The utterance with its first such sentence said once for each thing."""
    for index in range(len(said) - 3):
        if said[index].text not in _ANY:
            continue
        noun = index + 1
        while noun < len(said) - 2 and said[noun].text in ("of", "the"):
            noun += 1
        if said[noun + 1].text not in _RELATIVE:
            continue
        longer = _unfolded(said, index, noun, members_of(said, index, noun, vocabulary), vocabulary)
        if longer is not None:
            return longer
    return said


def _unfolded(
    said: tuple[Word, ...],
    index: int,
    noun: int,
    members: Sequence[Thing],
    vocabulary: Vocabulary,
) -> tuple[Word, ...] | None:
    begin = max((i + 1 for i in range(index) if said[i].text in _STOPS), default=0)
    end = next((i for i in range(noun, len(said)) if said[i].text in _STOPS), len(said))
    close = next(
        (
            i for i in range(noun + 2, end)
            if said[i].text in _CONNECTORS | {","}
            or (said[i].text in _MODALS and index == begin and i > noun + 2)
        ),
        end,
    )  # fmt: skip
    before, told, behind = said[begin:index], said[noun + 2 : close], said[close:end]
    if any(word.text in _CONNECTORS for word in before) or not told:
        return None
    denied = any(word.text in _DENIALS for word in before)
    unfolded: list[Word] = []
    for member in members:
        own = tuple(Word(text, said[noun].start, said[noun].end) for text in member)
        condition = _condition(own, told, vocabulary)
        if condition is None:
            continue
        here = own[0]
        mark = replace(here, text=";")
        start = replace(here, text="while" if denied else "whenever")
        unfolded += [*([mark] if unfolded else []), start, *condition, replace(here, text=",")]
        unfolded += [*before, *own, *behind]
    if not unfolded:
        return None
    return (*said[:begin], *unfolded, *said[end:])


def _condition(
    own: tuple[Word, ...], told: tuple[Word, ...], vocabulary: Vocabulary
) -> tuple[Word, ...] | None:
    """What the clause says of one thing: "site 1 is not safe", "the crane is at site 1"."""
    said = (*own, *told)
    for each in references(said, vocabulary):
        whole = each.first == 0 and each.last > len(own)
        if whole and each.shape is Shape.STATE and each.score >= 0.8:
            return said
    place = "".join(word.text for word in told[-1:]) in PREPOSITIONS
    moves = any(mover_at(told, i, vocabulary.frames) for i in range(len(told)))
    return (*told, *own) if place and moves else None
