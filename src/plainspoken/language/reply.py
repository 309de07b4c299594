"""A checked parse of what a language model replies: formulas over known landmarks, or an error.

No word of a reply goes further. The error says what is wrong in a way that can be told the model,
and shows a person no more of the reply than the piece that is at fault.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, replace
from difflib import get_close_matches
from typing import Any, TypeVar

from plainspoken.errors import FormulaSyntaxError, PlainspokenError
from plainspoken.language.extraction import ReferringExpression
from plainspoken.language.grounding import Vocabulary
from plainspoken.logic.formula import Atom, Constant, Formula, atoms, conjunction, subformulas
from plainspoken.logic.pattern import (
    NAMES,
    BoundDelay,
    PastAvoidance,
    Pattern,
    PromptPrecedence,
    PromptReaction,
)
from plainspoken.logic.recognition import recognised
from plainspoken.logic.syntax import parse, unparse
from plainspoken.world.symbol import SymbolId

LONGEST_REPLY = 50_000
"""Characters of a reply; a longer one is not looked at."""
LONGEST_FORMULA = 4_000
MOST_READINGS = 4
MOST_EXPRESSIONS = 200
MODEL_SCORE = 0.5
"""How sure a grounding is that rests on a model's word alone."""

T = TypeVar("T")
_FENCED = re.compile(r"\s*```(?:json)?\s*\n(?P<inside>.*)\n\s*```\s*", re.DOTALL)


class UnusableReplyError(PlainspokenError):
    """A model's reply cannot be used; what, where and hint can be told the model."""


@dataclass(frozen=True, slots=True)
class ModelReading:
    """One formula that a model gives, in both readings.

    pattern: the patterns it is made of, joined by " & "; None where some part is of none
    """

    literal: Formula
    executable: Formula
    pattern: str | None


@dataclass(frozen=True, slots=True)
class ModelTranslation:
    """What a model makes of an utterance: no reading where it sees no mission."""

    readings: tuple[ModelReading, ...]
    expressions: tuple[ReferringExpression, ...] = ()


def reading_from(text: str, utterance: str, vocabulary: Vocabulary) -> ModelTranslation:
    """Check a reply to `extraction_messages`.

    raises UnusableReplyError: unless its formulas speak of landmarks alone, and of those alone
        whose expressions the utterance holds
    """
    document = _document(text, "expressions", "readings")
    spoken = matches(document["expressions"], vocabulary.landmarks)
    expressions = located(spoken, utterance)
    named = {each.symbol for each in expressions}
    found = formulas(document["readings"], vocabulary.landmarks, "the list of symbols")
    for literal, executable in found:
        unspoken = sorted((atoms(literal) | atoms(executable)) - named)
        if unspoken:
            raise UnusableReplyError(
                f"the formula speaks of {_shortened(unspoken[0])}, and no expression does",
                where=_shortened(unparse(literal)),
                hint="quote the words of the utterance that mean it, or leave it out",
            )
    return ModelTranslation(tuple(_reading(*each, vocabulary) for each in found), expressions)


def expressions_from(text: str, utterance: str) -> tuple[str, ...]:
    """Check a reply to `recognition_messages`: words of the utterance."""
    quoted = _texts(_document(text, "expressions")["expressions"], "expressions")
    for each in quoted:
        _position(each, utterance)
    return quoted


def symbols_from(
    text: str, expressions: Collection[str], vocabulary: Vocabulary
) -> tuple[tuple[str, SymbolId], ...]:
    """Check a reply to `grounding_messages`: a landmark for expressions that were asked about."""
    spoken = matches(_document(text, "symbols")["symbols"], vocabulary.landmarks)
    for each, _ in spoken:
        if each not in expressions:
            raise UnusableReplyError("that expression was not asked about", where=_shortened(each))
    return spoken


def lifted_from(text: str, names: Collection[str]) -> tuple[tuple[Formula, Formula], ...]:
    """Check a reply to `translation_messages`: formulas over the placeholders."""
    return formulas(_document(text, "readings")["readings"], names, "the placeholders")


def grounded(
    lifted: tuple[Formula, Formula], ground: Callable[[Formula], Formula], vocabulary: Vocabulary
) -> ModelReading:
    """A reading over placeholders made one over landmarks."""
    literal, executable = lifted
    return _reading(ground(literal), ground(executable), vocabulary)


def matches(value: object, known: Collection[SymbolId]) -> tuple[tuple[str, SymbolId], ...]:
    """Expressions with the id of a known landmark each."""
    found = []
    for entry in _list(value, "expressions", MOST_EXPRESSIONS):
        pair = _fields(entry, "text", "symbol")
        if pair["symbol"] not in known:
            raise _unknown(pair["symbol"], known, "the list of symbols")
        found.append((pair["text"], pair["symbol"]))
    return tuple(found)


def located(
    spoken: Collection[tuple[str, SymbolId]], utterance: str
) -> tuple[ReferringExpression, ...]:
    """Where in the utterance each expression stands.

    raises UnusableReplyError: for one that does not stand there
    """
    found = []
    for text, symbol in dict.fromkeys(spoken):
        start = _position(text, utterance)
        end = start + len(text)
        found.append(ReferringExpression(utterance[start:end], start, end, symbol, MODEL_SCORE))
    return tuple(sorted(found, key=lambda each: (each.start, each.symbol)))


def formulas(
    value: object, known: Collection[str], source: str
) -> tuple[tuple[Formula, Formula], ...]:
    """The literal and executable formula of each reading, over known propositions."""
    found = []
    for entry in _list(value, "readings", MOST_READINGS):
        pair = _fields(entry, "literal", "executable")
        literal, executable = (_formula(text, known, source) for text in pair.values())
        if atoms(literal) != atoms(executable):
            raise UnusableReplyError(
                "the literal and the executable formula speak of different things",
                where=_shortened(unparse(executable)),
            )
        found.append((literal, executable))
    return tuple(dict.fromkeys(found))


def _reading(literal: Formula, executable: Formula, vocabulary: Vocabulary) -> ModelReading:
    """A reading, its executable formula derived where the literal one is made of patterns."""
    found = recognised(literal)
    known = [_for_robots(each, vocabulary) for each in found if isinstance(each, Pattern)]
    if len(known) < len(found):
        return ModelReading(literal, executable, None)
    derived = conjunction(*(each.executable for each in known))
    names = dict.fromkeys(NAMES[type(each)] for each in known)
    return ModelReading(literal, derived, " & ".join(names))


def _for_robots(pattern: Pattern, vocabulary: Vocabulary) -> Pattern:
    """The pattern with what its literal formula does not tell."""
    if isinstance(pattern, PastAvoidance):
        # A guard demands nothing by itself; what else is demanded stands beside it.
        return replace(pattern, demanded=False)
    if isinstance(pattern, PromptReaction | PromptPrecedence | BoundDelay):
        trigger = pattern.trigger
        persists = not isinstance(trigger, Atom) or vocabulary.persists(trigger.name)
        return replace(pattern, persists=persists)
    return pattern


def _document(text: str, *names: str) -> dict[str, Any]:
    if len(text) > LONGEST_REPLY:
        raise UnusableReplyError(f"the reply is longer than {LONGEST_REPLY} characters")
    fenced = _FENCED.fullmatch(text)
    try:
        document = json.loads(fenced["inside"] if fenced else text)
    except (ValueError, RecursionError) as error:
        raise UnusableReplyError("the reply is not one JSON object") from error
    if not isinstance(document, dict):
        raise UnusableReplyError("the reply is not one JSON object")
    for name in names:
        if name not in document:
            raise UnusableReplyError(f"the field {name!r} is missing")
    return document


def _list(value: object, name: str, most: int) -> list[object]:
    if not isinstance(value, list):
        raise UnusableReplyError(f"the field {name!r} is not a list")
    if len(value) > most:
        raise UnusableReplyError(f"the field {name!r} has more than {most} entries")
    return value


def _texts(value: object, name: str) -> tuple[str, ...]:
    found = [each for each in _list(value, name, MOST_EXPRESSIONS) if isinstance(each, str)]
    if not isinstance(value, list) or len(found) < len(value):
        raise UnusableReplyError(f"the field {name!r} is not a list of texts")
    return tuple(dict.fromkeys(found))


def _fields(entry: object, *names: str) -> dict[str, str]:
    if not isinstance(entry, Mapping) or not all(isinstance(entry.get(n), str) for n in names):
        raise UnusableReplyError(f"expected an object with the texts {' and '.join(names)}")
    return {name: entry[name] for name in names}


def _position(expression: str, utterance: str) -> int:
    """Where an expression stands; a model may change the case of what it quotes."""
    start = utterance.find(expression)
    if start < 0 and len(utterance.lower()) == len(utterance):
        start = utterance.lower().find(expression.lower())
    if start < 0 or not expression.strip():
        raise UnusableReplyError(
            "the expression does not stand in the utterance",
            where=_shortened(expression),
            hint="quote the words exactly as they stand",
        )
    return start


def _formula(text: str, known: Collection[str], source: str) -> Formula:
    if len(text) > LONGEST_FORMULA:
        raise UnusableReplyError(f"the formula is longer than {LONGEST_FORMULA} characters")
    try:
        formula = parse(text)
    except FormulaSyntaxError as error:
        raise UnusableReplyError(error.what, where=error.where, hint=error.hint) from error
    for name in sorted(atoms(formula)):
        if name not in known:
            raise _unknown(name, known, source)
    if any(isinstance(part, Constant) for part in subformulas(formula)):
        raise UnusableReplyError("a mission holds no true or false", where=_shortened(text))
    return formula


def _unknown(name: str, known: Collection[str], source: str) -> UnusableReplyError:
    nearest = get_close_matches(name[:100], sorted(known), n=3, cutoff=0.5)
    return UnusableReplyError(
        f"{_shortened(name)} is not in {source}",
        hint=f"did you mean {' or '.join(nearest)}?" if nearest else f"use only {source}",
    )


def _shortened(text: str) -> str:
    flat = "".join(character if character.isprintable() else " " for character in text)
    return flat if len(flat) <= 60 else flat[:57] + "..."
