"""A language model as a second opinion on what an utterance means.

Agreement is accepted. Where the two translators differ, a reading that cannot be met or that leaves
out what the utterance names falls away; if both stand, the person is asked.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import TypeVar

from plainspoken.automata.equivalence import equivalent, satisfiable
from plainspoken.errors import FormulaTooLargeError
from plainspoken.language import reply
from plainspoken.language.completion import (
    PATIENCE,
    CompletionError,
    LanguageModel,
    Message,
    Schema,
    Seconds,
    within,
)
from plainspoken.language.extraction import LONGEST, Extraction, Reading, Status, extract
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.prompting import (
    GROUNDING_SCHEMA,
    RECOGNITION_SCHEMA,
    RESPONSE_SCHEMA,
    TRANSLATION_SCHEMA,
    correction,
    extraction_messages,
    grounding_messages,
    placeholders,
    recognition_messages,
    renamed,
    translation_messages,
    with_placeholders,
)
from plainspoken.language.reply import (
    MODEL_SCORE,
    ModelReading,
    ModelTranslation,
    UnusableReplyError,
)
from plainspoken.logic.english import say
from plainspoken.logic.formula import Formula, atoms
from plainspoken.logic.syntax import unparse

T = TypeVar("T")

CORRECTIONS = 2
"""How often a model is told what is wrong with its reply."""


class Mode(StrEnum):
    """Who translates: the embedded translator, a language model, or both."""

    EMBEDDED = "embedded"
    LLM = "llm"
    BOTH = "both"


@dataclass(frozen=True)
class SecondOpinion:
    """A translator that asks a language model.

    staged:   ask for referring expressions, formula and grounding one by one
    patience: for one reply
    """

    model: LanguageModel
    mode: Mode = Mode.BOTH
    staged: bool = False
    patience: Seconds = PATIENCE

    def __call__(self, utterance: str, vocabulary: Vocabulary) -> Extraction:
        """Translate an utterance. Never raises for what a person, or the model, may say."""
        started = time.perf_counter()
        found = self._extraction(utterance, vocabulary)
        return replace(found, seconds=round(time.perf_counter() - started, 6))

    def _extraction(self, utterance: str, vocabulary: Vocabulary) -> Extraction:
        own = extract(utterance, vocabulary)
        if (
            self.mode is Mode.EMBEDDED
            or not utterance.strip()
            or len(utterance) > LONGEST
            or not vocabulary.landmarks
        ):
            return own
        ask = translated_in_stages if self.staged else translated
        try:
            theirs = ask(utterance, vocabulary, within(self.model, self.patience))
        except (CompletionError, UnusableReplyError) as error:
            return _noted(own, f"No second opinion, the embedded translator alone: {error.what}.")
        try:
            if self.mode is Mode.LLM:
                return _of_the_model(utterance, theirs, vocabulary)
            return _of_both(own, theirs, vocabulary)
        except FormulaTooLargeError:
            return _noted(
                own, "The language model's formula is too large: the embedded translator alone."
            )


def translated(utterance: str, vocabulary: Vocabulary, model: LanguageModel) -> ModelTranslation:
    """Ask a model for the whole translation at once.

    raises CompletionError, UnusableReplyError: when it gives none that can be used
    """
    return _asked(
        model,
        extraction_messages(utterance, vocabulary),
        RESPONSE_SCHEMA,
        lambda text: reply.reading_from(text, utterance, vocabulary),
    )


def translated_in_stages(
    utterance: str, vocabulary: Vocabulary, model: LanguageModel
) -> ModelTranslation:
    """Ask a model stage by stage: referring expressions, grounding, symbolic translation.

    Grounding goes first of the last two, so that two expressions for one symbol share a
    placeholder, as in the paper's lifted sentences.
    raises CompletionError, UnusableReplyError: when it gives none that can be used
    source: Argenziano et al. 2025, section "Process Extraction"; after Lang2LTL
    """
    expressions = _asked(
        model,
        recognition_messages(utterance),
        RECOGNITION_SCHEMA,
        lambda text: reply.expressions_from(text, utterance),
    )
    if not expressions:
        return ModelTranslation(())
    spoken = _asked(
        model,
        grounding_messages(expressions, vocabulary),
        GROUNDING_SCHEMA,
        lambda text: reply.symbols_from(text, expressions, vocabulary),
    )
    # One symbol each: a plural needs the translation at once.
    chosen = dict(reversed(spoken))
    if set(chosen) != set(expressions):
        return ModelTranslation(())
    names = placeholders([chosen[text] for text in expressions])
    lifted = _asked(
        model,
        translation_messages(
            with_placeholders(utterance, [(text, names[chosen[text]]) for text in expressions])
        ),
        TRANSLATION_SCHEMA,
        lambda text: reply.lifted_from(text, names.values()),
    )
    symbols = {name: symbol for symbol, name in names.items()}
    readings = tuple(
        reply.grounded(each, lambda formula: renamed(formula, symbols), vocabulary)
        for each in lifted
    )
    return ModelTranslation(readings, reply.located(tuple(chosen.items()), utterance))


def _asked(
    model: LanguageModel,
    messages: Sequence[Message],
    schema: Schema,
    checked: Callable[[str], T],
) -> T:
    """Ask until the reply can be used, telling the model what is wrong."""
    conversation = list(messages)
    for attempt in range(CORRECTIONS + 1):
        text = model(tuple(conversation), schema)
        try:
            return checked(text)
        except UnusableReplyError as error:
            if attempt == CORRECTIONS:
                raise
            shown = text[: reply.LONGEST_FORMULA]
            conversation += correction(shown, str(error))
    raise AssertionError("the last attempt returns or raises")


def _of_the_model(utterance: str, theirs: ModelTranslation, vocabulary: Vocabulary) -> Extraction:
    """What the model says, checked."""
    if not theirs.readings:
        return Extraction(
            utterance,
            Status.REJECT,
            reason="The language model finds nothing in that sentence to ask of the robot.",
            referring_expressions=theirs.expressions,
        )
    possible = [each for each in theirs.readings if satisfiable(each.executable)]
    readings = _told_apart([_in_words(each, vocabulary) for each in possible or theirs.readings])
    if not possible:
        return Extraction(
            utterance,
            Status.REJECT,
            reason=f'This cannot be met, whatever happens: "{readings[0].english}"',
            referring_expressions=theirs.expressions,
        )
    first = possible[0]
    if len(readings) > 1:
        return _question(
            Extraction(utterance, Status.CLARIFY, referring_expressions=theirs.expressions),
            readings,
            "That can be understood in more than one way. Which do you mean?",
        )
    names = placeholders(
        [each.symbol for each in theirs.expressions if each.symbol in atoms(first.literal)]
    )
    return Extraction(
        utterance,
        Status.OK,
        readings[0],
        first.pattern,
        unparse(renamed(first.literal, names)),
        theirs.expressions,
        note="Translated by a language model.",
    )


def _of_both(own: Extraction, theirs: ModelTranslation, vocabulary: Vocabulary) -> Extraction:
    """What the two agree on, or else a question."""
    possible = [
        _in_words(each, vocabulary) for each in theirs.readings if satisfiable(each.executable)
    ]
    match own.status:
        case Status.OK:
            return _against_one(own, theirs, possible)
        case Status.CLARIFY:
            return _against_several(own, possible)
        case Status.REJECT:
            if not possible:
                return own
            # What the embedded translator refuses is never accepted on a model's word alone.
            readings = _told_apart(possible)
            refusal = own.reason or "I do not understand that."
            return _question(
                replace(own, status=Status.CLARIFY, reason=None),
                readings,
                f"{refusal} A language model reads it as follows. Is that what you mean?",
            )


def _against_one(
    own: Extraction, theirs: ModelTranslation, possible: Sequence[Reading]
) -> Extraction:
    mine = own.reading
    assert mine is not None  # noqa: S101 - an accepted utterance has one
    if any(_same(mine, each) for each in possible) and len(possible) == 1:
        return own
    if theirs.readings and not possible:
        return _noted(own, "The language model's reading cannot be met, so this one stands.")
    named = {each.symbol for each in own.referring_expressions if each.score == 1.0}
    heard = [each for each in possible if named & atoms(mine.literal) <= atoms(each.literal)]
    if possible and not heard:
        return _noted(
            own, "The language model's reading leaves out what you named, so this one stands."
        )
    readings = _told_apart([mine, *heard])
    question = (
        "I read that in one way and a language model in another. Which do you mean?"
        if len(readings) > 1
        else "A language model finds no mission in that sentence. Is this what you mean?"
        if not theirs.readings
        else "That can be understood in more than one way. Is this what you mean?"
    )
    return _question(replace(own, status=Status.CLARIFY), readings, question)


def _against_several(own: Extraction, possible: Sequence[Reading]) -> Extraction:
    agreed = [each for each in own.alternatives if any(_same(each, m) for m in possible)]
    if len(agreed) == 1 and len(possible) == 1:
        settled = replace(own, status=Status.OK, reading=agreed[0], alternatives=(), question=None)
        return _noted(settled, "Of several readings, this is the one a language model has, too.")
    readings = _told_apart([*own.alternatives, *possible])
    return _question(own, readings, own.question or "Which do you mean?")


def _question(extraction: Extraction, readings: Sequence[Reading], question: str) -> Extraction:
    return replace(extraction, reading=readings[0], alternatives=tuple(readings), question=question)


def _same(one: Reading, other: Reading) -> bool:
    """Whether two readings say the same; published formulas are compared literally."""
    return one.literal == other.literal or equivalent(one.literal, other.literal)


def _told_apart(readings: Sequence[Reading]) -> list[Reading]:
    """The readings without those that say the same as one before."""
    kept: list[Reading] = []
    for each in readings:
        if not any(_same(each, other) for other in kept):
            kept.append(each)
    return kept


def _in_words(reading: ModelReading, vocabulary: Vocabulary) -> Reading:
    executable: Formula = reading.executable
    return Reading(executable, reading.literal, say(executable, vocabulary.landmarks), MODEL_SCORE)


def _noted(extraction: Extraction, note: str) -> Extraction:
    return replace(extraction, note=f"{extraction.note} {note}" if extraction.note else note)
