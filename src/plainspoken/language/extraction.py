"""From one utterance to one grounded formula, or to a question, or to a reason why not."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum
from typing import Any

from plainspoken.automata.equivalence import satisfiable
from plainspoken.language.clause import Act, Clause, Operand, statements
from plainspoken.language.colour import without_colour
from plainspoken.language.ellipsis import resolved
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.item import Item, items
from plainspoken.language.lexicon import Kind
from plainspoken.language.lifting import Lifted, lifted
from plainspoken.language.reading import clauses
from plainspoken.language.reference import Reference
from plainspoken.language.word import Word, words
from plainspoken.logic.english import say
from plainspoken.logic.formula import Atom, Formula, conjunction, substituted
from plainspoken.logic.pattern import NAMES
from plainspoken.logic.syntax import unparse
from plainspoken.logic.trace import holds
from plainspoken.world.symbol import SymbolId

LEAST_SURE = 0.6
"""A reference with a lower score is asked about."""
LONGEST = 2000
"""Characters of an utterance; nobody says more in one breath."""
MOST_ALTERNATIVES = 4


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
    """One formula that the utterance may mean, in both readings and said back in English."""

    formula: Formula
    literal: Formula
    english: str
    score: float


@dataclass(frozen=True, slots=True)
class Extraction:
    """What became of an utterance.

    reading:  the formula, where there is one to confirm (status ok) or to ask about (clarify)
    pattern:  the names of the mission patterns, joined by " & "
    lifted:   the literal formula over placeholders a, b, c, ...
    note:     what the person should know of an accepted formula
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
            "alternatives": [
                {
                    "formula": unparse(each.formula),
                    "literal": unparse(each.literal),
                    "english": each.english,
                    "score": each.score,
                }
                for each in self.alternatives
            ],
            "question": self.question,
            "reason": self.reason,
            "note": self.note,
            "seconds": self.seconds,
        }


def extract(utterance: str, vocabulary: Vocabulary) -> Extraction:
    """Translate an utterance. Never raises for what a person may say."""
    started = time.perf_counter()
    found = _Extractor(utterance, vocabulary).extraction()
    return replace(found, seconds=round(time.perf_counter() - started, 6))


class _Extractor:
    def __init__(self, utterance: str, vocabulary: Vocabulary) -> None:
        self._utterance = utterance
        self._vocabulary = vocabulary

    def extraction(self) -> Extraction:
        utterance = self._utterance
        if not utterance.strip():
            return self._rejected("Nothing was said. Say what the robot should get done.")
        if len(utterance) > LONGEST:
            return self._rejected(
                f"That is {len(utterance)} characters long, and I can take {LONGEST}. "
                "Say it in shorter pieces."
            )
        said, found = resolved(words(utterance), self._vocabulary)
        shaped = without_colour(items(said, found), said)
        problem = self._not_understood(said, shaped, found)
        if problem is not None:
            return problem
        return self._translated(said, found, shaped)

    def _rejected(
        self, reason: str, expressions: tuple[ReferringExpression, ...] = ()
    ) -> Extraction:
        return Extraction(
            self._utterance, Status.REJECT, reason=reason, referring_expressions=expressions
        )

    def _text(self, said: Sequence[Word], first: int, last: int) -> str:
        return self._utterance[said[first].start : said[last - 1].end]

    def _expressions(
        self, said: Sequence[Word], found: Sequence[Reference]
    ) -> tuple[ReferringExpression, ...]:
        return tuple(
            ReferringExpression(
                self._text(said, each.first, each.last),
                said[each.first].start,
                said[each.last - 1].end,
                each.symbol,
                each.score,
            )
            for each in found
        )

    def _not_understood(
        self, said: Sequence[Word], shaped: Sequence[Item], found: Sequence[Reference]
    ) -> Extraction | None:
        """A rejection where words that matter stand for nothing in the domain."""
        spans: list[tuple[int, int]] = []
        for item in shaped:
            if item.kind is Kind.UNKNOWN:
                if spans and spans[-1][1] == item.first:
                    spans[-1] = (spans[-1][0], item.last)
                else:
                    spans.append((item.first, item.last))
        if not spans and found:
            return None
        expressions = self._expressions(said, found)
        if not spans:
            return self._rejected(
                "I found nothing in that sentence that the robot can visit, watch or do. "
                + self._suggestions(self._utterance),
                expressions,
            )
        partial = {each.last: each for each in found if each.score < 1.0}
        spans = [
            (partial[first].first if first in partial else first, last) for first, last in spans
        ]
        texts = [self._text(said, first, last) for first, last in spans]
        places = [
            f'"{text}" (characters {said[first].start} to {said[last - 1].end})'
            for text, (first, last) in zip(texts, spans, strict=True)
        ]
        return self._rejected(
            f"I do not understand {_listed(places, 'and')}. " + self._suggestions(texts[0]),
            expressions,
        )

    def _suggestions(self, text: str) -> str:
        nearest = self._vocabulary.nearest(text)
        named = [f'"{landmark.description}"' for landmark in nearest]
        return f"The nearest that I know: {_listed(named, 'and')}." if named else ""

    def _translated(
        self, said: Sequence[Word], found: Sequence[Reference], shaped: Sequence[Item]
    ) -> Extraction:
        expressions = self._expressions(said, found)
        parsed = clauses(shaped)
        rivals = next((each for each in found if each.rivals), None)
        reading, patterns, over_placeholders, idle = self._reading(parsed, {})
        if idle.remarks:
            return self._rejected(
                "That tells me how things are. Say what to do about it, or begin with "
                '"make sure that".',
                expressions,
            )
        open_end = next(
            (
                each
                for place, each in enumerate(parsed)
                if _is_open(each, parsed[max(place - 1, 0) : place + 2])
            ),
            None,
        )
        if open_end is not None and reading is not None:
            word = str(open_end.connector or "not").replace("_", " ")
            return self._rejected(
                f'I do not see what you mean after "{word}". Name the place, the condition '
                "or the action.",
                expressions,
            )
        if reading is None:
            return self._rejected(
                "That allows something, but asks for nothing."
                if idle.permissions
                else "I found what you speak of, but not what to do about it. "
                "Say for example to visit, avoid, or wait.",
                expressions,
            )
        unsure = rivals or next((each for each in found if each.score < LEAST_SURE), None)
        if unsure is not None:
            return self._asked(said, parsed, unsure, expressions)
        if not satisfiable(reading.formula):
            return self._contradiction(parsed, reading, expressions)
        return Extraction(
            self._utterance,
            Status.OK,
            reading,
            patterns,
            over_placeholders,
            expressions,
            note=_note(reading.formula),
        )

    def _reading(
        self, parsed: Sequence[Clause], chosen: dict[SymbolId, SymbolId]
    ) -> tuple[Reading | None, str, str, Lifted]:
        names: dict[SymbolId, str] = {}

        def placeholder(operand: Operand) -> Atom:
            symbol = operand.reference.symbol
            return Atom(names.setdefault(symbol, _placeholder(len(names))))

        def persists(operand: Operand) -> bool:
            symbol = operand.reference.symbol
            return operand.negated or self._vocabulary.persists(symbol)

        result: Lifted = lifted(statements(parsed), placeholder, persists)
        if not result.patterns:
            return None, "", "", result
        symbols = {name: chosen.get(symbol, symbol) for symbol, name in names.items()}

        def grounded(formula: Formula) -> Formula:
            return substituted(formula, lambda name: Atom(symbols[name]))

        literal = conjunction(*(each.literal for each in result.patterns))
        executable = grounded(conjunction(*(each.executable for each in result.patterns)))
        scores = [o.reference.score for clause in parsed for o in clause.operands]
        reading = Reading(
            executable,
            grounded(literal),
            say(executable, self._vocabulary.landmarks),
            round(min(scores, default=1.0), 3),
        )
        pattern = " & ".join(dict.fromkeys(NAMES[type(each)] for each in result.patterns))
        return reading, pattern, unparse(literal), result

    def _asked(
        self,
        said: Sequence[Word],
        parsed: Sequence[Clause],
        unclear: Reference,
        expressions: tuple[ReferringExpression, ...],
    ) -> Extraction:
        """A question which of several symbols is meant, with a reading for each."""
        candidates = (unclear.symbol, *unclear.rivals)[:MOST_ALTERNATIVES]
        readings = []
        pattern = over_placeholders = ""
        for symbol in candidates:
            reading, pattern, over_placeholders, _ = self._reading(parsed, {unclear.symbol: symbol})
            if reading is not None:
                readings.append(reading)
        text = self._text(said, unclear.first, unclear.last)
        named = [self._vocabulary.landmarks[symbol].description for symbol in candidates]
        question = (
            f'What do you mean by "{text}": {_listed(named, "or")}?'
            if len(named) > 1
            else f'By "{text}", do you mean "{named[0]}"?'
        )
        return Extraction(
            self._utterance,
            Status.CLARIFY,
            readings[0],
            pattern,
            over_placeholders,
            expressions,
            tuple(readings),
            question=question,
        )

    def _contradiction(
        self,
        parsed: Sequence[Clause],
        reading: Reading,
        expressions: tuple[ReferringExpression, ...],
    ) -> Extraction:
        """A rejection that names two parts that cannot both be, where there are such."""
        landmarks = self._vocabulary.landmarks
        parts = reading.formula.operands if hasattr(reading.formula, "operands") else ()
        clash = next(
            (
                (one, other)
                for i, one in enumerate(parts)
                for other in parts[i + 1 :]
                if not satisfiable(conjunction(one, other))
            ),
            None,
        )
        if clash is None:
            reason = f'This cannot be met, whatever happens: "{reading.english}"'
        else:
            one, other = (say(part, landmarks) for part in clash)
            reason = f'These two cannot both be: "{one}" and "{other}"'
        return self._rejected(reason, expressions)


def _is_open(clause: Clause, near: Sequence[Clause]) -> bool:
    """Whether a clause begins something and names nothing: "before leaving", "but never both"."""
    if clause.operands:
        return False
    if clause.connector is not None:
        return True
    attached = any(each.connector is not None and each.operands for each in near)
    return clause.act is Act.AVOID and not clause.flags and not attached


def _placeholder(number: int) -> str:
    return chr(ord("a") + number) if number < 26 else f"p{number}"


def _note(formula: Formula) -> str | None:
    """Said of a formula that the shortest trace without any symbol true already satisfies."""
    if holds(formula, (frozenset(),)):
        return "Doing nothing at all already satisfies this."
    return None


def _listed(texts: Sequence[str], conjunction: str) -> str:
    if len(texts) == 1:
        return texts[0]
    return f"{', '.join(texts[:-1])} {conjunction} {texts[-1]}"
