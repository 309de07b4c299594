"""From one utterance to one grounded formula, or to a question, or to a reason why not."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace

from plainspoken.errors import FormulaTooLargeError
from plainspoken.language.agreement import settled
from plainspoken.language.ambiguity import Ambiguity, ambiguity
from plainspoken.language.confidence import LEAST_CONFIDENT, confidence, features, is_senseless
from plainspoken.language.contradiction import contradiction, in_two_places
from plainspoken.language.extracted import (
    Extraction,
    Reading,
    ReferringExpression,
    Status,
    idleness,
    listed,
    literal_of,
    names_of,
)
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.learned import Reader, learned
from plainspoken.language.paraphrase import asked_whether, paraphrases
from plainspoken.language.reference import Reference
from plainspoken.language.refusal import (
    LONGEST,
    aimless,
    broken_off,
    idle,
    not_understood,
    unfinished,
    unknown_spans,
    unspeakable,
)
from plainspoken.language.sentence import Meaning, Sentence, reading_of
from plainspoken.language.slip import Slip, asked_about, mended, slips
from plainspoken.language.thesaurus import thesaurus
from plainspoken.logic.syntax import unparse
from plainspoken.world.symbol import SymbolId

__all__ = ["LONGEST", "Extraction", "Reading", "ReferringExpression", "Status", "extract"]

LEAST_SURE = 0.6
"""A reference with a lower score is asked about."""
MOST_ALTERNATIVES = 4


def extract(utterance: str, vocabulary: Vocabulary, reader: Reader | None = learned) -> Extraction:
    """Translate an utterance. Never raises for what a person may say.

    reader: what reads it beside the rules; None for the rules alone
    """
    started = time.perf_counter()
    reason = unspeakable(utterance)
    if reason is not None:
        found = Extraction(utterance, Status.REJECT, reason=reason)
    else:
        found = _understanding(Sentence.of(utterance, vocabulary), reader)
    return replace(found, seconds=round(time.perf_counter() - started, 6))


def by_rules(sentence: Sentence) -> Extraction:
    """What the rules alone make of a sentence."""
    reason = not_understood(sentence)
    if reason is not None:
        return _rejected(sentence, reason)
    sentence = sentence.parsed()
    meaning = sentence.meaning()
    # A remark is no mission even where the rest is one: it may have been meant as a condition.
    utterance = sentence.utterance
    reason = idle(meaning, utterance) or broken_off(utterance)
    if reason is not None:
        return replace(_rejected(sentence, reason), final=True)
    reason = aimless(meaning) or unfinished(sentence.clauses)
    if reason is not None:
        return _rejected(sentence, reason)
    try:
        return _translated(sentence, meaning)
    except FormulaTooLargeError:
        return _rejected(sentence, "That is too much at once. Say it in shorter pieces.")


def _rejected(sentence: Sentence, reason: str) -> Extraction:
    return Extraction(
        sentence.utterance,
        Status.REJECT,
        reason=reason,
        referring_expressions=sentence.expressions,
    )


def _translated(sentence: Sentence, meaning: Meaning) -> Extraction:
    unsure = next((each for each in sentence.references if each.rivals), None) or next(
        (each for each in sentence.references if each.score < LEAST_SURE), None
    )
    if unsure is not None:
        return _which_symbol(sentence, meaning, unsure)
    reading = reading_of(meaning.patterns, sentence.vocabulary, meaning.score)
    reason = contradiction(sentence, meaning)
    if reason is not None:
        return replace(_rejected(sentence, reason), clashing=True)
    doubt = ambiguity(sentence, meaning)
    if doubt is not None:
        return _which_structure(sentence, meaning, doubt)
    sure = confidence(features(sentence, meaning))
    if sure < LEAST_CONFIDENT or any(map(is_senseless, meaning.patterns)):
        return _is_it_this(sentence, meaning, reading, sure)
    return replace(_understood(sentence, meaning, Status.OK, reading), confidence=sure)


def _is_it_this(sentence: Sentence, meaning: Meaning, reading: Reading, sure: float) -> Extraction:
    """A question whether a reading that is not sure enough is the one that is meant."""
    asked = _understood(sentence, meaning, Status.CLARIFY, reading)
    return replace(
        asked,
        alternatives=(replace(reading, answer="yes"),),
        question=f'Do you mean: "{reading.english}"?',
        confidence=sure,
    )


def _understood(
    sentence: Sentence, meaning: Meaning, status: Status, reading: Reading
) -> Extraction:
    return Extraction(
        sentence.utterance,
        status,
        reading,
        names_of(meaning.patterns),
        unparse(literal_of(meaning.lifted)),
        sentence.expressions,
        note=_note(sentence, reading) if status is Status.OK else None,
    )


def _understanding(sentence: Sentence, reader: Reader | None) -> Extraction:
    """What the readers say; before that, what was heard wrong; behind it, what it may be called."""
    found = by_rules(sentence)
    unknown: Sequence[tuple[int, int]] = ()
    if found.status is not Status.OK:
        unknown = unknown_spans(sentence)
        heard = slips(sentence.words, unknown, sentence.vocabulary)
        asked = _asked_whether(found, heard, sentence.vocabulary) if heard else None
        if asked is not None:
            return asked
    if reader is not None and not found.final:
        found = settled(sentence, found, reader(sentence))
    if found.status is not Status.REJECT or not unknown:
        return found
    return _otherwise_called(sentence, found, unknown) or found


def _otherwise_called(
    sentence: Sentence, found: Extraction, unknown: Sequence[tuple[int, int]]
) -> Extraction | None:
    """A question whether something is called otherwise in the domain."""
    vocabulary = sentence.vocabulary
    for meant in paraphrases(sentence.words, unknown, vocabulary, thesaurus()):
        asked = _asked_whether(found, meant, vocabulary)
        if asked is not None:
            return replace(asked, question=asked_whether(found.utterance, meant))
    return None


def _asked_whether(
    found: Extraction, likely: Sequence[Slip], vocabulary: Vocabulary
) -> Extraction | None:
    """The question whether other words were meant, where those make sense."""
    utterance = found.utterance
    instead = by_rules(Sentence.of(mended(utterance, likely), vocabulary))
    if instead.status is not Status.OK or instead.reading is None:
        return None
    readings = (replace(instead.reading, answer="yes"),)
    return replace(
        instead,
        utterance=utterance,
        status=Status.CLARIFY,
        referring_expressions=found.referring_expressions,
        alternatives=readings,
        question=asked_about(utterance, likely, instead.referring_expressions, vocabulary),
        note=None,
    )


def _note(sentence: Sentence, reading: Reading) -> str | None:
    notes = (idleness(reading.formula), in_two_places(reading, sentence.vocabulary.landmarks))
    return " ".join(filter(None, notes)) or None


def _which_structure(sentence: Sentence, meaning: Meaning, doubt: Ambiguity) -> Extraction:
    """A question about the structure of a sentence, with a reading for each answer."""
    readings = tuple(
        reading_of(each.patterns, sentence.vocabulary, meaning.score, each.answer, each.english)
        for each in doubt.options
    )
    asked = _understood(sentence, meaning, Status.CLARIFY, readings[0])
    return replace(asked, alternatives=readings, question=doubt.question)


def _which_symbol(sentence: Sentence, meaning: Meaning, unclear: Reference) -> Extraction:
    """A question which of several symbols is meant, with a reading for each."""
    vocabulary = sentence.vocabulary
    candidates = (unclear.symbol, *unclear.rivals)[:MOST_ALTERNATIVES]
    named = [vocabulary.landmarks[symbol].description for symbol in candidates]
    readings = tuple(
        reading_of(
            sentence.meaning(chosen=_alike(sentence, unclear, place)).patterns,
            vocabulary,
            meaning.score,
            name if len(candidates) > 1 else "yes",
        )
        for place, name in enumerate(named)
    )
    text = sentence.text(unclear.first, unclear.last)
    question = (
        f'What do you mean by "{text}": {listed(named, "or")}?'
        if len(named) > 1
        else f'By "{text}", do you mean "{named[0]}"?'
    )
    asked = _understood(sentence, meaning, Status.CLARIFY, readings[0])
    return replace(asked, alternatives=readings, question=question)


def _alike(sentence: Sentence, unclear: Reference, place: int) -> dict[SymbolId, SymbolId]:
    """The same choice for all that is unclear alike: one robot's places, not one of each."""
    return {
        each.symbol: (each.symbol, *each.rivals)[place]
        for each in sentence.references
        if len(each.rivals) == len(unclear.rivals)
    }
