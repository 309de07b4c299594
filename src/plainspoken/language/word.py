"""An utterance as words with their places, and what a word may be an inflection of."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass
from functools import cache

_NUMBER_WORDS = """
    zero one two three four five six seven eight nine ten eleven twelve thirteen
    fourteen fifteen sixteen seventeen eighteen nineteen twenty
"""
NUMBERS = {word: str(value) for value, word in enumerate(_NUMBER_WORDS.split())}
_ORDINAL_WORDS = """
    first second third fourth fifth sixth seventh eighth ninth tenth
"""
ORDINALS = {
    word: str(value)
    for value, word in enumerate(
        _ORDINAL_WORDS.split(),
        start=1,
    )
}

_PART = re.compile(r"[^\W\d_]+|\d+|[^\w\s]")
_HYPHEN = re.compile(r"\w-\w")
_LETTER = re.compile(r"[^\W\d_]", re.UNICODE)
_CONTRACTION = re.compile(
    r"\b(?P<will>wo)(?P<wont>n't)\b|\b(?P<can>can)(?P<cant>'t)\b|\b(?P<cannot>can)(?P<not>not)\b"
    r"|(?P<nt>n't)\b|(?P<clitic>'(?:re|ve|ll|d|m|s))\b",
    re.IGNORECASE,
)
_CLITICS = {"'re": "are", "'ve": "have", "'ll": "will", "'d": "would", "'m": "am", "'s": "'s"}


@dataclass(frozen=True, slots=True)
class Word:
    """One word, number or mark of an utterance.

    text:  lower case, a contraction spelled out: "n't" is "not"
    start, end: characters of the utterance
    joined: whether it begins what is said of one more thing: "(the jar and) the can are sealed"
    """

    text: str
    start: int
    end: int
    joined: bool = False

    @property
    def number(self) -> str:
        """The word with a number in digits: "two" is "2"."""
        return NUMBERS.get(self.text, self.text)

    @property
    def stems(self) -> frozenset[str]:
        """What it may be an inflection of, itself included."""
        return stems(self.number)

    @property
    def is_mark(self) -> bool:
        return not self.text[0].isalnum()


def words(utterance: str) -> tuple[Word, ...]:
    """Split an utterance. Letters and digits run together are parted: "site2" is "site", "2"."""
    text = utterance.replace("\u2019", "'").replace("\u2018", "'")
    found: list[Word] = []
    position = 0
    for match in _CONTRACTION.finditer(text):
        found += _plain(text, position, match.start())
        found += _spelled_out(match)
        position = match.end()
    return tuple(found + _plain(text, position, len(text)))


def _plain(text: str, start: int, end: int) -> list[Word]:
    return [
        Word(_folded(match.group()), match.start(), match.end())
        for match in _PART.finditer(text, start, end)
        if match.group() != "-" or not _HYPHEN.match(text, max(match.start() - 1, 0))
    ]


def _spelled_out(match: re.Match[str]) -> list[Word]:
    found = []
    for group, text in (
        ("will", "will"), ("wont", "not"), ("can", "can"), ("cant", "not"),
        ("cannot", "can"), ("not", "not"), ("nt", "not"),
    ):  # fmt: skip
        if match[group]:
            found.append(Word(text, match.start(group), match.end(group)))
    if match["clitic"]:
        full = _CLITICS[match["clitic"].lower()]
        found.append(Word(full, match.start("clitic"), match.end("clitic")))
    return found


def _folded(text: str) -> str:
    """Lower case and without accents, where the letters are Latin."""
    plain = unicodedata.normalize("NFKD", text.lower())
    return "".join(c for c in plain if not unicodedata.combining(c)) or text


def is_known(text: str) -> bool:
    """Whether the dictionary of English has a word."""
    import simplemma  # noqa: PLC0415

    return bool(simplemma.is_known(text, lang="en"))


@cache
def stems(text: str) -> frozenset[str]:
    """The words that a word may be an inflection of, itself included."""
    found = {text}
    if not _LETTER.match(text) or len(text) < 3 or not text.isascii():
        return frozenset(found)
    # Loaded at the first word: its dictionary takes a quarter of a second.
    import simplemma  # noqa: PLC0415

    found.add(simplemma.lemmatize(text, lang="en").lower())
    if text.endswith("ves"):
        # "leaves" of a tree, and "shelves": the dictionary takes them for verbs.
        found |= {text[:-3] + end for end in ("f", "fe") if is_known(text[:-3] + end)}
    if text.endswith("ing") and len(text) > 5:
        # The dictionary holds many gerunds as nouns of their own ("building", "closing").
        head = text[:-3]
        shorter = [head[:-1]] if head[-1] == head[-2] else []
        for candidate in (head, head + "e", *shorter):
            if simplemma.is_known(candidate, lang="en"):
                found.add(candidate)
    return frozenset(found)
