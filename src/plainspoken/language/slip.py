"""Slips of a speech recogniser: words of an utterance that sound like words of the domain.

What was heard is never replaced silently: a slip is put to the person as a question.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from functools import cache
from itertools import pairwise

from plainspoken.language.expression import PREPOSITIONS
from plainspoken.language.extracted import ReferringExpression, listed
from plainspoken.language.frame import ARTICLES
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.word import Word, is_known, words

_SOUNDS_LIKE_NUMBERS = """to 2; too 2; tu 2; for 4; fore 4; won 1; ate 8; tree 3; free 3; fife 5;
    sicks 6; sex 6; heaven 7; nein 9; tin 10"""
NUMBERS_BY_SOUND = dict(each.split() for each in _SOUNDS_LIKE_NUMBERS.split(";"))
"""Words that a number is taken for: "to" for "two"."""
MOST_SLIPS = 3
LIKE_A_WORD = 0.8
"""How much a word of English has to sound like another to be taken for a slip."""
LIKE_A_NON_WORD = 0.74
"""The same, for what is no word of English."""

_NUMBERLESS = frozenset(("every", "each", "all", "any", "no"))
_SPELLINGS = tuple(
    (re.compile(pattern), sound)
    for pattern, sound in (
        (r"^(?:kn|gn|pn)", "n"), (r"^wr", "r"), (r"^ps", "s"), (r"^wh", "w"), (r"^x", "s"),
        (r"x", "ks"), (r"isl", "il"), (r"mb$", "m"), (r"ph", "f"), (r"gh(?=t)", ""),
        (r"gh$", "f"), (r"sch", "sk"), (r"t(?=io|ia)|sh|tch|ch", "x"), (r"th", "0"),
        (r"dge?", "j"), (r"ck", "k"), (r"c(?=[eiy])|z", "s"), (r"[cq]", "k"),
        (r"g(?=[eiy])", "j"), (r"v", "f"), (r"(?<=.)[wyh]", ""), (r"[aeiou]+", "a"),
        (r"(?<=.)a$", ""), (r"(.)\1+", r"\1"),
    )
)  # fmt: skip
"""Spellings and how they sound, roughly; a vowel is a vowel."""
_NEAR_SOUNDS = frozenset(
    frozenset(pair) for pair in ("bp", "td", "gk", "mn", "jx", "sx", "f0", "0t", "s0", "lr")
)


@dataclass(frozen=True, slots=True)
class Slip:
    """Words that were probably heard wrong.

    start, end: characters of the utterance
    meant:      what was probably said there
    """

    start: int
    end: int
    meant: str


@cache
def sound(word: str) -> str:
    """What a word sounds like, in few letters: "rows" and "rose" are "ras"."""
    text = word.lower()
    if text.endswith("es") or (len(text) > 3 and text.endswith("e")):
        text = re.sub(r"([^aeiou])e(s?)$", r"\1\2", text)  # silent: "rose"
    for pattern, replacement in _SPELLINGS:
        text = pattern.sub(replacement, text)
    return text


def likeness(one: str, other: str) -> float:
    """How much two words sound alike, and are spelled alike: 1 the same, 0 not at all."""
    a, b = sound(one), sound(other)
    longest = max(len(a), len(b))
    heard = 1 - _distance(a, b) / longest if longest else 0.0
    return 0.7 * heard + 0.3 * SequenceMatcher(None, one, other, autojunk=False).ratio()


def _distance(one: str, other: str) -> float:
    """How many sounds differ; a near sound counts half, a vowel half."""
    row = [float(i) for i in range(len(other) + 1)]
    for i, a in enumerate(one, start=1):
        before, row[0] = row[0], float(i)
        for j, b in enumerate(other, start=1):
            near = frozenset((a, b)) in _NEAR_SOUNDS
            changed = before + (0.0 if a == b else 0.5 if near else 1.0)
            gone = row[j] + (0.5 if a == "a" else 1.0)
            added = row[j - 1] + (0.5 if b == "a" else 1.0)
            before, row[j] = row[j], min(changed, gone, added)
    return row[-1]


def slips(
    said: Sequence[Word], unknown: Sequence[tuple[int, int]], vocabulary: Vocabulary
) -> tuple[Slip, ...]:
    """The slips that would explain an utterance that is not understood; none where some cannot be.

    unknown: the words, first and one after the last, that stand for nothing
    """
    found = list(_numbers(said, vocabulary))
    known = _domain_words(vocabulary)
    taken = {slip.start for slip in found}
    for first, last in unknown:
        index = first
        while index < last:
            if said[index].start in taken or _is_heard(said[index], vocabulary):
                index += 1
                continue
            slip, index = _slip_at(said, index, known)
            if slip is None:
                return ()
            found.append(slip)
    return tuple(sorted(found, key=lambda each: each.start)) if len(found) <= MOST_SLIPS else ()


def _is_heard(word: Word, vocabulary: Vocabulary) -> bool:
    """Whether a word is one of the domain, and is only missing its neighbour."""
    return (
        word.is_mark
        or word.number.isdigit()
        or any(stem in vocabulary.by_stem for stem in word.stems)
    )


def mended(utterance: str, found: Sequence[Slip]) -> str:
    """What was probably said."""
    for each in sorted(found, key=lambda each: -each.start):
        utterance = utterance[: each.start] + each.meant + utterance[each.end :]
    return utterance


def _numbers(said: Sequence[Word], vocabulary: Vocabulary) -> Iterator[Slip]:
    """A word that sounds like a number, behind a noun that goes with numbers: "site to"."""
    for index, (noun, word) in enumerate(pairwise(said)):
        number = NUMBERS_BY_SOUND.get(word.text)
        if number is None or (index and said[index - 1].text in _NUMBERLESS):
            continue
        following = said[index + 2] if index + 2 < len(said) else None
        if following is not None and (following.text in ARTICLES or vocabulary.members(following)):
            continue  # "from the site to the store", "from site to site"
        if any(members[-1] == number for members in vocabulary.members(noun)):
            yield Slip(word.start, word.end, number)


def _slip_at(said: Sequence[Word], index: int, known: Sequence[str]) -> tuple[Slip | None, int]:
    """The slip that a word is part of, alone or with a neighbour, and the word after it."""
    spans = [(index, index + 1)]
    if index + 1 < len(said):
        spans.append((index, index + 2))  # "cat hedral"
    if index:
        spans.append((index - 1, index + 1))
    best: tuple[float, Slip, int] | None = None
    for first, last in spans:
        texts = [each.text for each in said[first:last]]
        if not all(text.isalpha() and text.isascii() for text in texts):
            continue
        text = "".join(texts)
        least = LIKE_A_WORD if len(texts) > 1 or is_known(text) else LIKE_A_NON_WORD
        for word in known:
            score = likeness(text, word)
            if score >= least and len(text) > 2 and (best is None or score > best[0]):
                slip = Slip(said[first].start, said[last - 1].end, word)
                best = (score, slip, last)
    return (best[1], best[2]) if best else (None, index + 1)


def _domain_words(vocabulary: Vocabulary) -> tuple[str, ...]:
    """The words that the domain's names are made of, with their plurals."""
    found: dict[str, None] = {}
    for landmark in vocabulary.landmarks.values():
        for phrase in landmark.phrases:
            for word in words(phrase):
                if word.text.isalpha() and word.text not in ARTICLES | PREPOSITIONS:
                    found[word.text] = None
    return tuple(found) + tuple(
        f"{word}s" for word in found if is_known(f"{word}s") and f"{word}s" not in found
    )


def asked_about(
    utterance: str,
    found: Sequence[Slip],
    expressions: Sequence[ReferringExpression],
    vocabulary: Vocabulary,
) -> str:
    """The question whether slips are slips.

    expressions: of the mended utterance
    """
    whole = mended(utterance, found)
    heard, meant = [], []
    shift = 0
    for slip in sorted(found, key=lambda each: each.start):
        start = slip.start + shift
        shift += len(slip.meant) - (slip.end - slip.start)
        about = next((e for e in expressions if e.start <= start < e.end), None)
        if about is None:
            heard.append(f'"{utterance[slip.start : slip.end]}"')
            meant.append(f'"{slip.meant}"')
            continue
        before, after = start - about.start, about.end - (start + len(slip.meant))
        heard.append(f'"{utterance[slip.start - before : slip.end + max(after, 0)]}"')
        meant.append(f'"{_name(about, whole, vocabulary)}"')
    return f"By {listed(heard, 'and')}, do you mean {listed(meant, 'and')}?"


def _name(about: ReferringExpression, whole: str, vocabulary: Vocabulary) -> str:
    """What a symbol is called, in the words nearest to what was probably said."""
    text = whole[about.start : about.end].lower()
    return max(
        vocabulary.landmarks[about.symbol].phrases,
        key=lambda phrase: SequenceMatcher(None, text, phrase.lower(), autojunk=False).ratio(),
    )
