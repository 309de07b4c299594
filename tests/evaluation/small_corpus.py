"""A corpus of a few sentences about three rooms, and a translator that is told what to say."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from plainspoken.evaluation.corpus import Row, read_corpus
from plainspoken.language.extraction import Extraction, Reading, ReferringExpression, Status
from plainspoken.logic.syntax import parse
from plainspoken.world.landmark import Landmark, LandmarkType

LANDMARKS = {
    id: Landmark(id, words, LandmarkType.LOCATION)
    for id, words in {"hall": "the hall", "attic": "the attic", "cellar": "the cellar"}.items()
}

ROWS: list[dict[str, Any]] = [
    {
        "id": "one",
        "utterance": "Go to the hall.",
        "group": "navigation",
        "pattern": "visit",
        "literal": "F hall",
        "formula": "F hall",
        "referring_expressions": [{"text": "the hall", "start": 6, "end": 14, "symbol": "hall"}],
        "traces": {"accepted": [[["hall"]]], "rejected": [[["attic"], []]]},
    },
    {
        "id": "two",
        "utterance": "The hall, then the attic.",
        "group": "navigation",
        "pattern": "sequenced visit",
        "literal": "F(hall & F attic)",
        "formula": "F(hall & F attic)",
        "referring_expressions": [
            {"text": "The hall", "symbol": "hall"},
            {"text": "the attic", "symbol": "attic"},
        ],
    },
    {
        "id": "three",
        "utterance": "Not the attic before the cellar.",
        "group": "generic",
        "pattern": "past avoidance",
        "literal": "!attic U cellar",
        "formula": "!attic W cellar",
    },
]


def written(path: Path, rows: list[dict[str, Any]] | None = None) -> Path:
    text = "".join(json.dumps(row) + "\n" for row in (ROWS if rows is None else rows))
    path.write_text(text, encoding="utf-8")
    return path


def small_rows(folder: Path) -> tuple[Row, ...]:
    return read_corpus(written(folder / "sentences.jsonl"), LANDMARKS)


def accepted(row: Row, literal: str, formula: str | None = None, **more: Any) -> Extraction:
    reading = Reading(parse(formula or literal), parse(literal), "", 1.0)
    return Extraction(row.utterance, Status.OK, reading, **more)


def mentioned(row: Row, text: str, symbol: str) -> ReferringExpression:
    start = row.utterance.index(text)
    return ReferringExpression(text, start, start + len(text), symbol, 1.0)


def told(answers: dict[str, Callable[[Row], Extraction]]) -> Callable[[Row, object], Extraction]:
    """Translate each row as the answer under its id says."""
    return lambda row, _vocabulary: answers[row.id](row)


def right(row: Row, _vocabulary: object = None) -> Extraction:
    """Say what the gold says; a function of a module, so that another process can be told."""
    assert row.executable is not None
    return Extraction(
        row.utterance, Status.OK, Reading(row.executable, row.literal, "", 1.0), row.pattern
    )
