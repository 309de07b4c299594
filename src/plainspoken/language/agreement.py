"""Two readers of one sentence: what both say is taken, else the surer one, or the person is asked.

The rules and the network go wrong in different places. How often a reading is right, given what
the other one says, was fitted on domains that neither had seen: `python benchmarks/reader.py`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

from plainspoken.automata.equivalence import equivalent
from plainspoken.errors import FormulaTooLargeError
from plainspoken.language.extracted import (
    Extraction,
    Reading,
    ReferringExpression,
    Status,
    idleness,
    names_of,
    over_placeholders,
    patterns_of,
)
from plainspoken.language.frame import ARTICLES
from plainspoken.language.learned import Learned
from plainspoken.language.reference import Form
from plainspoken.language.refusal import unknown_spans
from plainspoken.language.sentence import Sentence
from plainspoken.language.whereabouts import can_be_met, places_of_robots
from plainspoken.language.word import Word
from plainspoken.logic.english import say
from plainspoken.logic.formula import atoms
from plainspoken.logic.pattern import Patrolling
from plainspoken.world.landmark import LandmarkType
from plainspoken.world.symbol import SymbolId

ACCEPTED = 0.4
"""A reading that is likelier than this is taken."""
ASKED = 0.25
"""One that is likelier than this is asked about."""
NO_MISSION = 0.5
"""What the network takes for no mission with more than this is not accepted on the rules' word."""
ACCEPTED_ALONE = 0.55
"""The same for one that the rules do not understand."""
SURE_OF_NO_CLASH = 0.95
"""The network's own estimate with which it is asked about where the rules read a contradiction."""
_JOINING = frozenset(("and", "then", "or"))
_ENDS = frozenset((".", ";", "!", ","))
_STAYING = frozenset(
    ("stand", "sit", "shelter", "hover", "bide", "camp", "perch", "rest", "loiter")
)
_LIGHT = frozenset(("more", "another", "except", "e", "less", "every", "single"))
_STANDING = frozenset(("in", "at", "on", "near"))
_OTHERS_BEHIND = frozenset(("tell", "ask"))
_DANGLING = ARTICLES | frozenset(
    ("and", "or", "if", "until", "unless", "while", "when", "whenever", "your", "every", "each")
)
SURE_OF_PLACES = 0.97
"""The network's own estimate with which it is followed where the rules read another order."""
_FILLED = 1.5
"""More words than were said, by this much, are a list that was left to the rules."""
_FOUND_BY_WORDS = 0.8
"""The score of an expression that the network found."""
_GAP = 3
"""Words that may stand between two that name one symbol."""

WEIGHTS = {
    "bias": 0.222,
    "own": 0.655,
    "agreed": 1.142,
    "denied": -0.693,
    "refused": -0.294,
}
"""Of the logistic regression in `likelihood`."""


def evidence(heard: Learned, ruled: Extraction, *, agreed: bool) -> dict[str, float]:
    """What tells how likely the network's reading is the one that is meant.

    own: the log-odds of its own estimate; agreed, denied, refused: what the rules say of it
    """
    own = min(max(heard.probability, 1e-4), 1 - 1e-4)
    return {
        "bias": 1.0,
        "own": math.log(own / (1 - own)),
        "agreed": float(agreed),
        "denied": float(not agreed and ruled.status is Status.OK),
        "refused": float(ruled.status is Status.REJECT),
    }


def likelihood(found: Mapping[str, float]) -> float:
    """The probability that follows from the evidence."""
    total = sum(WEIGHTS[name] * value for name, value in found.items())
    return round(1 / (1 + math.exp(-total)), 3)


def settled(sentence: Sentence, ruled: Extraction, heard: Learned) -> Extraction:
    """What becomes of a sentence that both have read.

    ruled: what the rules say of it: a formula, a question, or a reason why not
    """
    if _is_said_back(ruled):
        return ruled
    unsure = ruled.status is Status.CLARIFY and ruled.confidence is not None
    if ruled.status is Status.CLARIFY and not unsure:
        return ruled  # which symbol, or which structure, only the person knows
    if heard.reading is None:
        return _unheard(ruled, heard)
    agreed = ruled.reading is not None and same(ruled.reading, heard.reading)
    likely = likelihood(evidence(heard, ruled, agreed=agreed))
    if agreed and (ruled.status is Status.OK or likely >= ACCEPTED):
        return _accepted(ruled, likely)
    if not meets(heard.reading, sentence):
        return ruled
    said = heard.reading.english or say(heard.reading.formula, sentence.vocabulary.landmarks)
    reading = replace(heard.reading, english=said)
    if ruled.status is Status.OK and _is_of_places(sentence):
        # The rules know orders of places and errands best: there the network has to be surer.
        sure = heard.probability >= SURE_OF_PLACES
        return _taken(sentence, reading, likely) if sure else ruled
    if ruled.status is Status.REJECT and (names_the_unknown(sentence) or breaks_off(sentence)):
        return ruled
    if ruled.clashing:
        sure = heard.probability >= SURE_OF_NO_CLASH
        return _perhaps(sentence, reading, likely) if sure else ruled
    if ruled.status is Status.REJECT and likely < ACCEPTED_ALONE:
        return _perhaps(sentence, reading, likely) if likely >= ASKED else ruled
    if likely >= ACCEPTED:
        return _taken(sentence, reading, likely)
    if ruled.status is Status.OK and _is_filled_in(sentence):
        return ruled  # so long a list is beyond the network
    if ruled.status is Status.OK:
        return _either(sentence, ruled, reading, likely)
    return _perhaps(sentence, reading, likely) if likely >= ASKED else ruled


def names_the_unknown(sentence: Sentence) -> bool:
    """Whether a word that nobody knows may name what is asked for, and not only colour it.

    So it does before a place ("the hay barn", of a barn), as a deed with its own object ("dig a
    hole"), by itself ("and dance", "juggle in the lobby"), and as whoever else is to do it ("tell
    Charlie to").
    """
    said = sentence.words
    known = {index for each in sentence.references for index in range(each.first, each.last)}
    unknown = {index for span in unknown_spans(sentence) for index in range(*span)} - known
    named = {each.first for each in sentence.references if each.form is Form.NOUN}
    for index in unknown:
        before = said[index - 1].text if index else "."
        behind = [word.text for word in said[index + 1 : index + 2]] or ["."]
        more = before in _JOINING and behind[0] in _ENDS
        strays = before in _JOINING | _ENDS and said[index].stems.isdisjoint(_STAYING) and (
            behind[0] in _STANDING or (behind[0] in ARTICLES and index + 2 in unknown)
        )  # fmt: skip
        modified = index + 1 in named and said[index].text not in _LIGHT
        if modified or more or strays or before in _OTHERS_BEHIND:
            return True
    return False


def breaks_off(sentence: Sentence) -> bool:
    """Whether an utterance ends with a word that something has to follow."""
    said = [word.text for word in sentence.words if not word.is_mark]
    return bool(said) and said[-1] in _DANGLING


def same(one: Reading, other: Reading) -> bool:
    """Whether two readings say the same."""
    if one.literal == other.literal:
        return True
    if atoms(one.literal) != atoms(other.literal):
        return False
    try:
        return equivalent(one.literal, other.literal)
    except FormulaTooLargeError:
        return False


def meets(reading: Reading, sentence: Sentence) -> bool:
    """Whether a reading can be met, with no robot in two places at once."""
    landmarks = sentence.vocabulary.landmarks
    patrols = any(isinstance(each, Patrolling) for each in reading.patterns)
    apart = () if patrols else places_of_robots(landmarks, sorted(atoms(reading.formula)))
    try:
        return can_be_met(reading.formula, apart)
    except FormulaTooLargeError:
        return False


def _is_said_back(ruled: Extraction) -> bool:
    """Whether an utterance is put as a meaning is said back: then that is what it means.

    Brackets stand for nothing that is spoken; where meanings are said back, the rules read them.
    """
    reading = ruled.reading
    return (
        ruled.status is Status.OK
        and reading is not None
        and ("(" in ruled.utterance or _plain(reading.english) == _plain(ruled.utterance))
    )


def _plain(text: str) -> str:
    return "".join(c for c in text.lower() if c.isalnum())


def _is_of_places(sentence: Sentence) -> bool:
    """Whether a sentence speaks of places alone, or of things that are carried between them."""
    known = sentence.vocabulary.landmarks
    found = sentence.references
    return any(each.errand is not None for each in found) or all(
        known[each.symbol].type is LandmarkType.LOCATION for each in found
    )


def _is_filled_in(sentence: Sentence) -> bool:
    """Whether much of a sentence stands for what was not said: a clause for "every" one of many."""
    said = {word.start for word in sentence.words}
    return len(sentence.words) > _FILLED * len(said)


def _unheard(ruled: Extraction, heard: Learned) -> Extraction:
    """What the network takes for no mission is asked about, whatever the rules say."""
    reading = ruled.reading
    if ruled.status is not Status.OK or reading is None or heard.refusal < NO_MISSION:
        return ruled
    return replace(
        ruled,
        status=Status.CLARIFY,
        alternatives=(replace(reading, answer="yes"),),
        question=f'I am not sure that this is a mission. Do you mean: "{reading.english}"?',
        note=None,
    )


def _accepted(ruled: Extraction, likely: float) -> Extraction:
    reading = ruled.reading
    note = idleness(reading.formula) if reading and ruled.status is not Status.OK else ruled.note
    return replace(
        ruled, status=Status.OK, alternatives=(), question=None, note=note, confidence=likely
    )


def _read(sentence: Sentence, reading: Reading, status: Status, likely: float) -> Extraction:
    patterns = patterns_of(reading)
    return Extraction(
        sentence.utterance,
        status,
        reading,
        names_of(patterns) or "none of the catalogue",
        over_placeholders(reading.literal),
        expressions_of(sentence, reading),
        confidence=likely,
    )


def _taken(sentence: Sentence, reading: Reading, likely: float) -> Extraction:
    found = _read(sentence, reading, Status.OK, likely)
    return replace(found, note=idleness(reading.formula))


def _perhaps(sentence: Sentence, reading: Reading, likely: float) -> Extraction:
    return replace(
        _read(sentence, reading, Status.CLARIFY, likely),
        alternatives=(replace(reading, answer="yes"),),
        question=f'I am not sure that I understand. Do you mean: "{reading.english}"?',
    )


def _either(sentence: Sentence, ruled: Extraction, reading: Reading, likely: float) -> Extraction:
    """The two readings side by side, the likelier first."""
    mine = ruled.reading
    assert mine is not None  # noqa: S101 - an accepted sentence has one
    both = (reading, mine) if likely >= ASKED else (mine, reading)
    return replace(
        _read(sentence, both[0], Status.CLARIFY, likely),
        alternatives=both,
        question="I can read that in two ways. Which do you mean?",
    )


def expressions_of(sentence: Sentence, reading: Reading) -> tuple[ReferringExpression, ...]:
    """Where a sentence speaks of the symbols of a reading."""
    meant = atoms(reading.literal)
    found = [each for each in sentence.expressions if each.symbol in meant]
    missing = sorted(meant - {each.symbol for each in found})
    found += [
        ReferringExpression(
            sentence.text(first, last),
            sentence.words[first].start,
            sentence.words[last - 1].end,
            symbol,
            _FOUND_BY_WORDS,
        )
        for symbol in missing
        for first, last in _named(sentence, symbol)
    ]
    return tuple(sorted(found, key=lambda each: (each.start, each.symbol)))


def _named(sentence: Sentence, symbol: SymbolId) -> Sequence[tuple[int, int]]:
    """The words, as close together as they stand, that name a symbol; none where none do."""
    telling = sentence.vocabulary.telling_stems[symbol]
    at = [i for i, word in enumerate(sentence.words) if _tells(word, telling)]
    if not at:
        return ()
    runs = [[at[0]]]
    for index in at[1:]:
        if index - runs[-1][-1] <= _GAP:
            runs[-1].append(index)
        else:
            runs.append([index])
    best = max(runs, key=lambda run: (len(run), -run[0]))
    return ((best[0], best[-1] + 1),)


def _tells(word: Word, telling: frozenset[str]) -> bool:
    return not telling.isdisjoint(word.stems)
