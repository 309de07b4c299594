"""The translators that are measured: the embedded one, and those with a language model.

In use, a language model that fails is replaced by the embedded translator, which says so. In an
experiment its figure would be another's: here such a run fails, with the reason.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from plainspoken.automata.equivalence import satisfiable
from plainspoken.evaluation.corpus import Row
from plainspoken.language.completion import Message, Schema, within
from plainspoken.language.extraction import Extraction, extract
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.second_opinion import (
    SecondOpinion,
    translated,
    translated_in_stages,
)


def embedded(row: Row, vocabulary: Vocabulary) -> Extraction:
    """Translate a row's sentence without a language model."""
    return extract(row.utterance, vocabulary)


@dataclass(frozen=True, slots=True)
class WithModel:
    """Translates with a language model that has to give something that can be used."""

    opinion: SecondOpinion

    def __call__(self, row: Row, vocabulary: Vocabulary) -> Extraction:
        """Translate a row's sentence.

        raises CompletionError, UnusableReplyError: where the model gives nothing to use
        raises FormulaTooLargeError: where its formula is too large to be checked
        """
        opinion = self.opinion
        said: dict[tuple[Message, ...], str] = {}

        def remembered(messages: Sequence[Message], schema: Schema, /) -> str:
            conversation = tuple(messages)
            if conversation not in said:
                said[conversation] = opinion.model(messages, schema)
            return said[conversation]

        ask = translated_in_stages if opinion.staged else translated
        found = ask(row.utterance, vocabulary, within(remembered, opinion.patience))
        for reading in found.readings:
            satisfiable(reading.executable)
        # Asked the same again, the model is remembered; what it said is known to be of use.
        return replace(opinion, model=remembered)(row.utterance, vocabulary)
