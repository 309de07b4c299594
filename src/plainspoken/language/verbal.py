"""Verbs of acts by themselves: when a word for an act is one, and when it is something else."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from plainspoken.language.expression import PARTICLES
from plainspoken.language.frame import ARTICLES
from plainspoken.language.kinship import nouns_of
from plainspoken.language.lexicon import PHRASES, Kind
from plainspoken.language.word import Word

_DETERMINERS = ARTICLES | frozenset(
    ("each", "every", "any", "no", "one", "another", "first", "next", "this", "that", "of", "more")
)
_COMPOUNDS_WORDS = """
    that time times hour hours day days point room area station spot place
"""
_COMPOUNDS = frozenset(_COMPOUNDS_WORDS.split())
_SPANS = frozenset(("next", "same", "following", "very", "first", "end", "one", "that", "turn"))
_ONWARD = frozenset(
    ("over", "up", "down", "back", "out", "straight", "right", "on", "only", "along")
)
_WHITHER = frozenset(
    ("to", "into", "towards", "toward", "through", "in", "on", "onto", "there", "past", "near")
)


def is_noun(said: Sequence[Word], index: int) -> bool:
    """Whether a word for an act is a noun here: "the inspection of a tank", "after every wash"."""
    own = said[index].text
    if any(own in nouns_of(stem) for stem in _verbs_of(own)):
        return True
    before = said[index - 1].text if index else ""
    return before in _DETERMINERS and said[index].stems == {own}


def _verbs_of(noun: str) -> Iterator[str]:
    """The words that a noun may be made from: shorter ones with the same beginning."""
    for end in range(3, len(noun)):
        yield noun[:end]
        yield noun[:end] + "e"
        yield noun[:end] + "y"


def is_idle(said: Sequence[Word], index: int) -> bool:
    """Whether a verb by itself stands in an idiom or a compound: "call it a day", "wash time"."""
    if any(
        len(pattern) > 1
        and index + len(pattern) <= len(said)
        and all(
            word.text == text or (text.startswith("~") and text[1:] in word.stems)
            for word, text in zip(said[index:], pattern, strict=False)
        )
        for stem in said[index].stems
        for pattern, _ in PHRASES.get(stem, ())
    ):
        return True
    behind = [word.text for word in said[index + 1 : index + 3]]
    if len(behind) == 2 and behind[0] == "it" and behind[1] in ARTICLES:
        return True
    return bool(behind) and behind[0] in _COMPOUNDS


def is_motion(said: Sequence[Word], span: tuple[int, int], parts: int) -> bool:
    """Whether an act such as "move" is only the verb of "move to site 1", "the crane moves in".

    span, parts: where the act is named, and by how many content words
    """
    first, last = span
    verb = last - 1
    if parts == 1 and last - first > 1:
        return False
    if parts > 1 and said[verb].text in PARTICLES:
        verb -= 1
    moves = any(
        pattern == ("~" + stem,) and kind is Kind.GO
        for stem in said[verb].stems
        for pattern, kind in PHRASES.get(stem, PHRASES.get("~" + stem, []))
    )
    behind = last
    while behind < len(said) and said[behind].text in _ONWARD:
        behind += 1
    follows = said[behind].text if behind < len(said) else ""
    if follows in ("in", "on"):
        into = [word.text for word in said[behind + 1 : behind + 3] if word.text not in ARTICLES]
        return moves and parts == 1 and not set(into) & _SPANS
    return moves and follows in _WHITHER
