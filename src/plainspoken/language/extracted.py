"""What became of an utterance, as values: a formula, a question, or a reason why neither."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum
from typing import Any

from plainspoken.logic.formula import Atom, Formula, conjunction, subformulas, substituted
from plainspoken.logic.pattern import NAMES, Pattern
from plainspoken.logic.recognition import recognised
from plainspoken.logic.substitution import renamed
from plainspoken.logic.syntax import unparse
from plainspoken.logic.trace import holds
from plainspoken.world.symbol import SymbolId


class Status(StrEnum):
    """How an extraction ended."""

    OK = "ok"
    CLARIFY = "clarify"
    REJECT = "reject"


@dataclass(frozen=True, slots=True)
class ReferringExpression:
    """A piece of the utterance and the symbol that it speaks of."""

    text: str
    start: int
    end: int
    symbol: SymbolId
    score: float


@dataclass(frozen=True, slots=True)
class Reading:
    """One formula that the utterance may mean, in both readings and said back in English.

    answer:   what to say to choose it, where it is one of several: "right after"
    patterns: what it is made of, over symbols; empty where nobody knows
    """

    formula: Formula
    literal: Formula
    english: str
    score: float
    answer: str = ""
    patterns: tuple[Pattern, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """The fields of an alternative."""
        return {
            "formula": unparse(self.formula),
            "literal": unparse(self.literal),
            "english": self.english,
            "score": self.score,
            "answer": self.answer or None,
        }


@dataclass(frozen=True, slots=True)
class Extraction:
    """What became of an utterance.

    reading:    the formula, where there is one to confirm (status ok) or to ask about (clarify)
    pattern:    the names of the mission patterns, joined by " & "
    lifted:     the literal formula over placeholders a, b, c, ...
    note:       what the person should know of an accepted formula
    confidence: how likely the reading is the one that is meant
    final:      whether a refusal stands whatever else may be read into the utterance
    clashing:   whether it is refused because its parts cannot be together
    """

    utterance: str
    status: Status
    reading: Reading | None = None
    pattern: str | None = None
    lifted: str | None = None
    referring_expressions: tuple[ReferringExpression, ...] = ()
    alternatives: tuple[Reading, ...] = ()
    question: str | None = None
    reason: str | None = None
    note: str | None = None
    confidence: float | None = None
    final: bool = False
    clashing: bool = False
    seconds: float = field(default=0.0, compare=False)

    @property
    def formula(self) -> Formula | None:
        """The executable formula of an accepted utterance."""
        return self.reading.formula if self.reading and self.status is Status.OK else None

    def to_json(self) -> dict[str, Any]:
        """The fields that `extract --batch` writes, without the id."""
        reading = self.reading
        return {
            "utterance": self.utterance,
            "status": str(self.status),
            "formula": unparse(reading.formula) if reading else None,
            "literal": unparse(reading.literal) if reading else None,
            "english": reading.english if reading else None,
            "pattern": self.pattern,
            "lifted": self.lifted,
            "referring_expressions": [
                {
                    "text": each.text,
                    "start": each.start,
                    "end": each.end,
                    "symbol": each.symbol,
                    "score": each.score,
                }
                for each in self.referring_expressions
            ],
            "alternatives": [each.to_json() for each in self.alternatives],
            "question": self.question,
            "reason": self.reason,
            "note": self.note,
            "confidence": self.confidence,
            "seconds": self.seconds,
        }

    def settled_on(self, reading: Reading) -> Extraction:
        """The extraction with one of its readings chosen."""
        return replace(
            self,
            status=Status.OK,
            reading=reading,
            pattern=names_of(patterns_of(reading)),
            lifted=over_placeholders(reading.literal),
            alternatives=(),
            question=None,
            note=idleness(reading.formula),
            confidence=1.0,
        )


def patterns_of(reading: Reading) -> tuple[Pattern, ...]:
    """What a reading is made of; without what belongs to no pattern."""
    if reading.patterns:
        return reading.patterns
    return tuple(each for each in recognised(reading.formula) if isinstance(each, Pattern))


def names_of(patterns: Sequence[Pattern]) -> str:
    """What the catalogue calls some patterns, each once."""
    return " & ".join(dict.fromkeys(NAMES[type(each)] for each in patterns))


def literal_of(patterns: Sequence[Pattern]) -> Formula:
    """The literal formula of patterns that are all to hold."""
    return conjunction(*(each.literal for each in patterns))


def executable_of(patterns: Sequence[Pattern]) -> Formula:
    """The executable formula of patterns that are all to hold."""
    return conjunction(*(each.executable for each in patterns))


def grounded(patterns: Sequence[Pattern], symbols: dict[str, SymbolId]) -> tuple[Pattern, ...]:
    """Patterns over placeholders with the symbols put in."""
    return tuple(renamed(each, lambda name: Atom(symbols[name])) for each in patterns)


def placeholder(number: int) -> str:
    """The name of the first symbol spoken of, the second ..."""
    return chr(ord("a") + number) if number < 26 else f"p{number}"


def over_placeholders(literal: Formula) -> str:
    """A formula with a, b, c, ... for its symbols, in the order of its text."""
    names: dict[str, str] = {}
    for part in subformulas(literal):
        if isinstance(part, Atom):
            names.setdefault(part.name, placeholder(len(names)))
    return unparse(substituted(literal, lambda name: Atom(names[name])))


def idleness(formula: Formula) -> str | None:
    """Said of a formula that the shortest trace without any symbol true already satisfies."""
    if holds(formula, (frozenset(),)):
        return "Doing nothing at all already satisfies this."
    return None


def listed(texts: Sequence[str], word: str) -> str:
    """Texts with commas, and a word before the last: "a, b and c"."""
    if len(texts) == 1:
        return texts[0]
    return f"{', '.join(texts[:-1])} {word} {texts[-1]}"
