"""The words of a domain that a speech recogniser should expect."""

from __future__ import annotations

from itertools import pairwise

from plainspoken.language.expression import PREPOSITIONS
from plainspoken.language.frame import ARTICLES
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.lexicon import is_general
from plainspoken.language.word import Word, words
from plainspoken.world.landmark import LandmarkType

MOST_HINTS = 60
"""A recogniser has room for a few, and hears what was never said when it is told many."""
MOST_NUMBERED = 2
"""Of "site 0" to "site 255": the recogniser knows how to count."""
_ORDER = (LandmarkType.LOCATION, LandmarkType.CONDITION, LandmarkType.ACTION)


def hints(vocabulary: Vocabulary, most: int = MOST_HINTS) -> tuple[str, ...]:
    """The words that the domain's names are made of, each once, a noun with its number: "site 2".

    Names of places come first, then of what is the case, then of what is done.
    """
    found: dict[str, None] = {}
    numbered: dict[str, int] = {}
    for kind in _ORDER:
        for landmark in vocabulary.landmarks.values():
            if landmark.type is kind:
                for phrase in landmark.phrases:
                    for hint in _hints_of(words(phrase)):
                        noun, _, number = hint.partition(" ")
                        if number and hint not in found:
                            numbered[noun] = numbered.get(noun, 0) + 1
                        if not number or numbered[noun] <= MOST_NUMBERED:
                            found[hint] = None
    # "site 2" says "site", too.
    with_numbers = {hint.partition(" ")[0] for hint in found if " " in hint}
    return tuple(hint for hint in found if hint not in with_numbers)[:most]


def _hints_of(said: tuple[Word, ...]) -> list[str]:
    found = []
    following: list[Word | None] = [later for _, later in pairwise(said)]
    for word, later in zip(said, [*following, None], strict=True):
        if not word.text.isalpha() or word.text in ARTICLES | PREPOSITIONS:
            continue
        if later is not None and later.text.isdigit():
            found.append(f"{word.text} {later.text}")
        elif not is_general(word):
            found.append(word.text)
    return found
