"""An utterance as words with their places, and what a word may be an inflection of."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass
from functools import cache

from plainspoken.language.errand import Errand

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

_PARTICIPLES = {
    "rung": "ring", "wound": "wind", "bound": "bind", "ground": "grind", "won": "win",
    "shot": "shoot", "bent": "bend",
}  # fmt: skip
"""What the dictionary takes for words of their own only."""
_PART = re.compile(r"[^\W\d_]+|\d+|[^\w\s]")
_HYPHEN = re.compile(r"\w-\w")
_LETTER = re.compile(r"[^\W\d_]", re.UNICODE)
# What is typed in haste or written down by a recognizer lacks the apostrophe: "dont", "you ve".
# Left out are those that are words of their own: "well", "were", "ill", "id", "shell".
_CONTRACTION = re.compile(
    r"\b(?P<will>wo)(?P<wont>n[' ]?t)\b|\b(?P<can>can)(?P<cant>[' ]?t)\b"
    r"|\b(?P<cannot>can) ?(?P<not>not)\b"
    r"|\b(?P<aux>do|does|did|is|are|was|were|ha[sd]|have|would|could|should|must|need)"
    r"(?P<bare>n ?t)\b"
    r"|\b(?P<who>you|they|we|i)(?P<whos> ?ve|(?<=[uy]) ?(?:re|ll)|(?<=[uy])d)\b"
    r"|\b(?P<what>that|there|what|let|here|it(?= s))(?P<whats> ?s)\b"
    r"|\b(?P<it>it)(?P<its>s)(?= (?:a|an|the|not|never|no|been|ok|okay|fine|to|off|out)\b)"
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
    errand: what the words that it stands for tell, taken together
    """

    text: str
    start: int
    end: int
    joined: bool = False
    errand: Errand | None = None

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
    text = re.sub("[\u2019\u2018\u02bc\u00b4`]", "'", utterance)
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
        ("cannot", "can"), ("not", "not"), ("aux", None), ("bare", "not"), ("nt", "not"),
        ("who", None), ("what", None), ("it", "it"),
    ):  # fmt: skip
        if match[group]:
            said = text or match[group].lower()
            found.append(Word(said, match.start(group), match.end(group)))
    for group in ("whos", "whats", "its", "clitic"):
        if match[group]:
            full = _CLITICS["'" + match[group].lower().strip(" '")]
            found.append(Word(full, match.start(group), match.end(group)))
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
    if text in _PARTICIPLES:
        found.add(_PARTICIPLES[text])
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
