"""A referring expression that was understood as the wrong symbol, put right by a person."""

from __future__ import annotations

from dataclasses import replace

from plainspoken.language.contradiction import clash
from plainspoken.language.extracted import (
    Extraction,
    Status,
    idleness,
    names_of,
    over_placeholders,
    patterns_of,
)
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.refinement import replaced
from plainspoken.language.sentence import reading_of
from plainspoken.world.symbol import SymbolId


def corrected(
    found: Extraction, place: int, symbol: SymbolId, vocabulary: Vocabulary
) -> Extraction:
    """What an utterance asks for when one of its expressions means another symbol.

    place: of the expression. Whatever else speaks of the symbol it had is taken to have meant the
        same; where that leads to a request that contradicts itself, it is refused.
    """
    old = found.referring_expressions[place].symbol
    expressions = tuple(
        replace(each, symbol=symbol, score=1.0) if each.symbol == old else each
        for each in found.referring_expressions
    )
    if found.reading is None:
        return replace(found, referring_expressions=expressions)
    patterns = replaced(patterns_of(found.reading), old, symbol)
    reason = clash(patterns, vocabulary.landmarks)
    if reason is not None:
        return replace(
            found, status=Status.REJECT, reason=reason, referring_expressions=expressions
        )
    reading = reading_of(patterns, vocabulary, found.reading.score)
    return replace(
        found,
        status=Status.OK,
        reading=reading,
        pattern=names_of(patterns),
        lifted=over_placeholders(reading.literal),
        referring_expressions=expressions,
        alternatives=(),
        question=None,
        reason=None,
        note=idleness(reading.formula),
    )
