"""Corpora of sentences with the formulas that they should become.

Two forms are read, one JSON object a line. The examples' own gives id, utterance, group, pattern,
both readings and the referring expressions. The published sets give utterance, pattern, the
literal formula, and `symbols`, the words for each symbol, from which a row has its own landmarks.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from plainspoken.errors import FormulaSyntaxError, InputFileError
from plainspoken.logic.formula import Atom, Formula, Until, children, conjunction
from plainspoken.logic.syntax import is_proposition, parse
from plainspoken.logic.trace import holds
from plainspoken.world.document import read_text
from plainspoken.world.landmark import Landmark, Landmarks, LandmarkType
from plainspoken.world.symbol import SymbolId

RowId = str

NOT_GIVEN = "not given"
"""The pattern of a row that names none."""

_STRONG_RELEASE = re.compile(r"\S\s*\bM\b\s*(\w+|\(.*\))\s*$", re.DOTALL)
"""From the last sign of the left operand on."""


@dataclass(frozen=True, slots=True)
class Mention:
    """A piece of an utterance, from start to before end, and the symbol that it speaks of."""

    text: str
    start: int
    end: int
    symbol: SymbolId


@dataclass(frozen=True, slots=True)
class Row:
    """A sentence and what it should become.

    group:      navigation or generic, where the corpus says
    pattern:    in lower case, several joined by " & "
    executable: None where the corpus has only the literal reading
    mentions:   None where the corpus does not say
    landmarks:  in a fixed order, so that a row is a value
    """

    id: RowId
    utterance: str
    group: str | None
    pattern: str
    literal: Formula
    executable: Formula | None
    mentions: tuple[Mention, ...] | None
    landmarks: tuple[Landmark, ...]


def read_corpus(path: str | Path, landmarks: Landmarks | None = None) -> tuple[Row, ...]:
    """Read a corpus; landmarks are for the rows that do not bring their own symbols.

    raises InputFileError: with the line, and the field that is wrong
    """
    shared = None if landmarks is None else tuple(landmarks.values())
    rows: dict[RowId, Row] = {}
    for line, document in json_lines(path):
        row = _Reader(path, line, document, shared).row()
        if row.id in rows:
            raise InputFileError(f"the id {row.id!r} stands twice", path, line=line, field="id")
        rows[row.id] = row
    if not rows:
        raise InputFileError("the corpus has no sentences", path)
    return tuple(rows.values())


def brings_landmarks(path: str | Path) -> bool:
    """Whether every row has its own symbols, so that no landmarks are needed.

    raises InputFileError: with the line that is not a JSON object
    """
    return all("symbols" in document for _, document in json_lines(path))


def pattern_name(text: str) -> str:
    """A pattern as we write it: lower case, each once, joined by " & "."""
    parts = (" ".join(part.split()).lower() for part in re.split(r"[+&]", text))
    return " & ".join(dict.fromkeys(parts))


def parse_published(text: str) -> Formula:
    """Read a formula in which the outermost operator may be Spot's strong release, `(a) M (b)`.

    It has no value of its own here: a M b is b U (a & b).
    raises FormulaSyntaxError: with the column that broke it, in the operand where it is in one
    """
    depth = groups = 0
    for column, sign in enumerate(text):
        depth += (sign == "(") - (sign == ")")
        groups += depth == 0 and sign == ")"
        if depth == 0 and (released := _STRONG_RELEASE.match(text, column)):
            left, right = text[: column + 1].strip(), released[1]
            if is_proposition(left) or (left[0] == "(" and left[-1] == ")" and groups == 1):
                release, held = parse(left), parse(right)
                return Until(held, conjunction(release, held))
    return parse(text)


def symbols_of(formula: Formula) -> frozenset[SymbolId]:
    """The atoms of a formula."""
    if isinstance(formula, Atom):
        return frozenset({formula.name})
    return frozenset().union(*map(symbols_of, children(formula)))


def json_lines(path: str | Path) -> Iterator[tuple[int, dict[str, Any]]]:
    """The objects of a file of JSON lines, with the number of each line.

    raises InputFileError: with the line that is not a JSON object
    """
    # Not splitlines(): that also ends a line at signs which JSON allows inside a text.
    for line, text in enumerate(read_text(path).split("\n"), start=1):
        if not text.strip():
            continue
        try:
            document = json.loads(text)
        except (json.JSONDecodeError, RecursionError) as error:
            raise InputFileError("the line is not JSON", path, line=line) from error
        if not isinstance(document, dict):
            raise InputFileError("expected a JSON object", path, line=line)
        yield line, document


@dataclass(frozen=True, slots=True)
class _Reader:
    """One line of a corpus; every complaint names file, line and field."""

    path: str | Path
    line: int
    document: dict[str, Any]
    shared: tuple[Landmark, ...] | None

    def row(self) -> Row:
        utterance = self._text("utterance")
        if utterance is None:
            raise self._wrong("a text is missing", "utterance")
        own = self._own_landmarks()
        landmarks = own if own is not None else self.shared
        if landmarks is None:
            raise self._wrong("no landmarks", "symbols", hint="give a landmarks file, --landmarks")
        known = frozenset(one.id for one in landmarks)
        literal = self._formula("literal", known)
        if literal is None:
            raise self._wrong("a formula is missing", "literal")
        self._check_traces(literal)
        id = self.document.get("id", self.line)
        if not isinstance(id, str | int):
            raise self._wrong("expected a text or a number", "id")
        mentions = self._mentions(utterance, known)
        if mentions is None and own is not None:
            mentions = _spoken(utterance, own)
        return Row(
            str(id),
            utterance,
            self._text("group"),
            pattern_name(self._text("pattern") or NOT_GIVEN),
            literal,
            self._formula("formula", known),
            mentions,
            landmarks,
        )

    def _wrong(self, what: str, field: str, hint: str | None = None) -> InputFileError:
        return InputFileError(what, self.path, line=self.line, field=field, hint=hint)

    def _text(self, field: str) -> str | None:
        text = self.document.get(field)
        if text is not None and not isinstance(text, str):
            raise self._wrong("expected a text", field)
        return text

    def _formula(self, field: str, known: frozenset[SymbolId]) -> Formula | None:
        text = self._text(field)
        if text is None:
            return None
        try:
            formula = parse_published(text)
        except FormulaSyntaxError as error:
            raise self._wrong(f"{error.what}\n{error.where}", field, error.hint) from error
        unknown = sorted(symbols_of(formula) - known)
        if unknown:
            raise self._wrong(f"no landmark is called {', '.join(unknown)}", field)
        return formula

    def _own_landmarks(self) -> tuple[Landmark, ...] | None:
        symbols = self.document.get("symbols")
        if symbols is None:
            return None
        if not isinstance(symbols, dict) or not symbols:
            raise self._wrong('expected an object such as {"blue room": "blue_room"}', "symbols")
        names: dict[SymbolId, list[str]] = {}
        for name, symbol in symbols.items():
            if not isinstance(symbol, str) or not is_proposition(symbol):
                raise self._wrong(f"{symbol!r} cannot be a symbol", f"symbols.{name}")
            if not name.strip():
                raise self._wrong("a symbol without words", "symbols")
            names.setdefault(symbol, []).append(name)
        # The published sets are about places.
        return tuple(
            Landmark(symbol, first, LandmarkType.LOCATION, tuple(others))
            for symbol, (first, *others) in names.items()
        )

    def _mentions(self, utterance: str, known: frozenset[SymbolId]) -> tuple[Mention, ...] | None:
        field = "referring_expressions"
        listed = self.document.get(field)
        if listed is None:
            return None
        if not isinstance(listed, list):
            raise self._wrong("expected a list", field)
        found: list[Mention] = []
        for number, each in enumerate(listed):
            place = f"{field}[{number}]"
            if not isinstance(each, dict) or not isinstance(each.get("text"), str):
                raise self._wrong("expected an object with text and symbol", place)
            text, symbol = each["text"], each.get("symbol")
            if not text.strip():
                raise self._wrong("the text is empty", f"{place}.text")
            if symbol not in known:
                raise self._wrong(f"no landmark is called {symbol}", f"{place}.symbol")
            start = each.get("start", utterance.lower().find(text.lower()))
            if not isinstance(start, int) or start < 0:
                raise self._wrong(f"the utterance does not say {text!r}", f"{place}.text")
            end = start + len(text)
            if utterance[start:end].lower() != text.lower():
                raise self._wrong(
                    f"at {start} the utterance says {utterance[start:end]!r}, not {text!r}", place
                )
            found.append(Mention(text, start, end, symbol))
        return tuple(found)

    def _check_traces(self, literal: Formula) -> None:
        """A gold formula that contradicts the row's own traces would spoil every figure."""
        traces = self.document.get("traces") or {}
        if not isinstance(traces, dict):
            raise self._wrong("expected an object with accepted and rejected", "traces")
        for which, expected in (("accepted", True), ("rejected", False)):
            for number, instants in enumerate(traces.get(which, [])):
                place = f"traces.{which}[{number}]"
                if not isinstance(instants, list) or not all(
                    isinstance(instant, list) and all(isinstance(s, str) for s in instant)
                    for instant in instants
                ):
                    raise self._wrong("expected a list of instants, lists of symbols", place)
                if holds(literal, tuple(map(frozenset, instants))) is not expected:
                    said = "rejects" if expected else "accepts"
                    raise self._wrong(f"the literal formula {said} this trace", place)


def _spoken(utterance: str, landmarks: tuple[Landmark, ...]) -> tuple[Mention, ...]:
    """Where an utterance says the names of its landmarks; of two that overlap, the longer."""
    named = [(phrase, one.id) for one in landmarks for phrase in one.phrases]
    found: list[Mention] = []
    for phrase, symbol in sorted(named, key=lambda each: -len(each[0])):
        for match in re.finditer(rf"(?<!\w){re.escape(phrase)}(?!\w)", utterance, re.IGNORECASE):
            start, end = match.span()
            if all(end <= other.start or other.end <= start for other in found):
                found.append(Mention(match.group(), start, end, symbol))
    return tuple(sorted(found, key=lambda each: each.start))
