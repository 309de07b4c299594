"""The general words of English that shape a mission, compiled for matching.

No word of any domain stands here or in the two tables that this joins.
"""

from __future__ import annotations

from plainspoken.language.kind import Kind
from plainspoken.language.phrases import PHRASES_OF_DOING
from plainspoken.language.timing import PHRASES_OF_TIMING
from plainspoken.language.word import Word

__all__ = ["MARKS", "PHRASES", "Kind", "is_general"]


def is_general(word: Word) -> bool:
    """Whether a word by itself stands in the lexicon."""
    return any(
        pattern in ((word.text,), ("~" + stem,))
        for stem in word.stems | {word.text}
        for pattern, _ in PHRASES.get(stem, ())
    )


MARKS = dict.fromkeys(",:()[]–—-", Kind.COMMA) | dict.fromkeys(".;!?…", Kind.STOP)
"""What punctuation does; any other mark is passed over."""


def _compiled() -> dict[str, list[tuple[tuple[str, ...], Kind]]]:
    table: dict[str, list[tuple[tuple[str, ...], Kind]]] = {}
    taken: set[tuple[str, ...]] = set()
    for kind, text in (*PHRASES_OF_DOING.items(), *PHRASES_OF_TIMING.items()):
        for part in text.split(";"):
            pattern = tuple(part.split())
            if pattern and pattern not in taken:
                taken.add(pattern)
                table.setdefault(pattern[0].lstrip("~"), []).append((pattern, kind))
    for candidates in table.values():
        candidates.sort(key=lambda entry: (-len(entry[0]), entry[0][0].startswith("~")))
    return table


PHRASES = _compiled()
"""Entries by their first word, longest first; of one pattern, the first kind listed counts, and
of two as long the one that gives the word itself and not any inflection."""
