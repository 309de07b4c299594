"""Words of English that mean nearly the same, from a selection of WordNet.

The table is general: it knows no domain. It is read at the first word that neither the lexicon
nor a domain knows, so that who speaks in the words of the domain never waits for it.
"""

from __future__ import annotations

import gzip
import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from functools import cache
from importlib.resources import files
from typing import Protocol

from plainspoken.language.kinship import opposites

_SAME = 1.0
_MORE_GENERAL = 0.8
_MORE_SPECIAL = 0.75
_RARER = 0.04
"""What each more usual sense of a word takes off."""


class Similarity(Protocol):
    """What knows how near words are in meaning: a thesaurus, or vectors of words."""

    def ranked(self, word: str, names: Collection[str]) -> Sequence[tuple[float, str]]:
        """Those of some names that a word may stand for, best first, each with a score up to 1."""
        ...


class Thesaurus:
    """Senses of words, one an entry: its words with their ranks, and the entries of what is above.

    The rank says how usual a sense is among those of the word, 0 the most. The entries are searched
    as they are: to take them apart would cost a third of a second, and few words are looked up.
    """

    def __init__(self, entries: Sequence[str]) -> None:
        self._entries = entries
        self._near: dict[str, dict[str, float]] = {}

    def near(self, word: str) -> Mapping[str, float]:
        """Words that may be meant by a word, each with a score up to 1."""
        if word not in self._near:
            self._near[word] = self._found(word)
        return self._near[word]

    def _found(self, word: str) -> dict[str, float]:
        own = f" {word}:"
        senses = {number: entry for number, entry in enumerate(self._entries) if own in entry}
        ranks = {number: dict(_words(entry))[word] for number, entry in senses.items()}
        below = re.compile(f" (?:{'|'.join(map(str, senses))})(?= |$)").search if senses else None
        found: dict[str, float] = {}

        def add(entry: str, worth: float, rank: int) -> None:
            for name, usual in _words(entry):
                score = worth - _RARER * (rank + usual)
                found[name] = max(found.get(name, 0.0), score)

        for number, entry in senses.items():
            add(entry, _SAME, ranks[number])
            for above in _above(entry):
                add(self._entries[above], _MORE_GENERAL, ranks[number])
        for entry in filter(below, self._entries) if below else ():
            for above in _above(entry):
                if above in ranks:
                    add(entry, _MORE_SPECIAL, ranks[above])
        for opposite in (word, *opposites(frozenset((word,)))):
            found.pop(opposite, None)
        return found

    def ranked(self, word: str, names: Collection[str]) -> Sequence[tuple[float, str]]:
        """Those of some names that are near a word, the nearest first."""
        known = names if isinstance(names, AbstractSet | Mapping) else frozenset(names)
        found = ((score, name) for name, score in self.near(word).items() if name in known)
        return sorted(found, key=lambda each: (-each[0], each[1]))


@cache
def thesaurus() -> Thesaurus:
    """The thesaurus that comes with the package."""
    table = files("plainspoken.language").joinpath("thesaurus.txt.gz").read_bytes()
    _, _, senses = gzip.decompress(table).decode().partition("\n\n")
    return Thesaurus(senses.splitlines())


def _words(entry: str) -> Iterator[tuple[str, int]]:
    for field in entry.split():
        word, colon, rank = field.partition(":")
        if colon:
            yield word, int(rank)


def _above(entry: str) -> Iterator[int]:
    return (int(field) for field in entry.split() if field.isdigit())
