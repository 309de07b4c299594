"""Relative clauses on "any": "never enter any site that is not safe", unfolded for each thing.

What the clause says of a thing becomes the condition under which the sentence goes for it: "while
site 1 is not safe, never enter site 1; while site 2 is not safe, ...".
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from plainspoken.language.agency import mover_at
from plainspoken.language.expression import PREPOSITIONS, Shape
from plainspoken.language.frame import Thing
from plainspoken.language.grounding import Vocabulary
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
        bare = _is_bare(said, index)
        if said[index].text not in _ANY and not bare:
            continue
        noun = index if bare else index + 1
        while noun < len(said) - 2 and said[noun].text in ("of", "the"):
            noun += 1
        if noun + 1 >= len(said):
            continue
        if said[noun + 1].text in _RELATIVE:
            members = members_of(said, index, noun, vocabulary)
            longer = _unfolded(said, index, noun, members, vocabulary)
        elif _points_back(said, noun) is not None and not bare:
            members = members_of(said, index, noun, vocabulary)
            longer = _each_with_its_own(said, index, noun, members, vocabulary)
        else:
            continue
        if longer is not None:
            return longer
    return said


def _is_bare(said: Sequence[Word], index: int) -> bool:
    """Whether a plural stands for any of its kind: "avoid sites that are not safe"."""
    before = said[index - 1] if index else None
    return (
        said[index].text.endswith("s")
        and said[index].stems != {said[index].text}
        and said[index + 1].text in _RELATIVE
        and before is not None
        and before.text not in _ANY | {"the", "of", "these", "those"}
        and not before.number.isdigit()
    )


def _points_back(said: Sequence[Word], noun: int) -> int | None:
    """Where a pronoun in a clause behind speaks of the same place: "while the crane is in it"."""
    joined = False
    for index in range(noun + 1, len(said)):
        if said[index].text in _STOPS:
            return None
        joined |= said[index].text in _CONNECTORS
        into = said[index - 1].text in PREPOSITIONS
        if joined and (said[index].text == "there" or (said[index].text == "it" and into)):
            return index
    return None


def _each_with_its_own(
    said: tuple[Word, ...],
    index: int,
    noun: int,
    members: Sequence[Thing],
    vocabulary: Vocabulary,
) -> tuple[Word, ...] | None:
    """Say of each place by itself what is said of any: "never be in site 1 while it is in site 1".

    Otherwise all of the places would be spoken of, and the pronoun would be only the last of them.
    """
    begin = max((i + 1 for i in range(index) if said[i].text in _STOPS), default=0)
    end = next((i for i in range(noun, len(said)) if said[i].text in _STOPS), len(said))
    back = _points_back(said, noun)
    between = said[noun + 1 : back]
    if back is None or len(members) < 2 or not set(members) <= set(vocabulary.frames.places) or (
        any(vocabulary.frames.mentioned(between, i) is not None and not mover_at(
            between, i, vocabulary.frames) for i in range(len(between)))
    ):  # fmt: skip
        return None
    unfolded: list[Word] = []
    for member in members:
        own = tuple(Word(text, said[noun].start, said[noun].end) for text in member)
        there = tuple(Word(text, said[back].start, said[back].end) for text in member)
        if said[back].text == "there":
            there = (replace(there[0], text="at"), *there)
        mark = [replace(own[0], text=";")] if unfolded else []
        unfolded += [*mark, *said[begin:index], *own, *between, *there, *said[back + 1 : end]]
    return (*said[:begin], *unfolded, *said[end:])


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
    only = next((i for i, word in enumerate(before) if word.text == "only"), None)
    unfolded: list[Word] = []
    for member in members:
        own = tuple(Word(text, said[noun].start, said[noun].end) for text in member)
        condition = _condition(own, told, vocabulary)
        if condition is None:
            continue
        here = own[0]
        mark = replace(here, text=";")
        if only is not None and not denied:
            # "only enter sites that are safe" forbids the others.
            never = (*before[:only], replace(before[only], text="never"), *before[only + 1 :])
            unless = replace(here, text="unless")
            unfolded += [*([mark] if unfolded else []), *never, *own, *behind, unless, *condition]
            continue
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
