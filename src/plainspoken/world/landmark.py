"""Landmarks: the symbols that a person may speak of, with the words for each.

A landmarks file is JSON: an id for each symbol, with a description, a type (location, condition
or action) and, if wanted, further names.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import Any

from plainspoken.errors import InputFileError, UnknownSymbolError
from plainspoken.logic.syntax import is_proposition
from plainspoken.world.document import read_json
from plainspoken.world.domain import Problem
from plainspoken.world.symbol import SymbolId, resolve


class LandmarkType(StrEnum):
    """What a symbol says: where the robot is, what is the case, or what is done."""

    LOCATION = "location"
    CONDITION = "condition"
    ACTION = "action"


@dataclass(frozen=True, slots=True)
class Landmark:
    """A symbol and its words.

    description: as a person says it: "line 1", "the box is full", "to harvest a grape"
    names:       further ways to say it
    lasts:       seconds for which it is known after it was seen; None for good
    """

    id: SymbolId
    description: str
    type: LandmarkType
    names: tuple[str, ...] = ()
    lasts: float | None = None

    @property
    def persists(self) -> bool:
        """Whether it stays true until something changes it; an action is true for an instant."""
        return self.type is not LandmarkType.ACTION

    @property
    def phrases(self) -> tuple[str, ...]:
        """The description and the further names."""
        return (self.description, *self.names)


Landmarks = Mapping[SymbolId, Landmark]


def read_landmarks(path: str | Path, problem: Problem | None = None) -> Landmarks:
    """Read a landmarks file; with a problem, check that every id names something in it.

    raises InputFileError: with the line or the field
    """
    return landmarks_from_json(read_json(path), path, problem)


def landmarks_from_json(
    document: object, path: str | Path, problem: Problem | None = None
) -> Landmarks:
    """Check a parsed landmarks document; path is for the errors.

    raises InputFileError: with the field
    """
    if not isinstance(document, dict) or not document:
        raise InputFileError(
            "expected an object with an entry for each landmark",
            path,
            hint='for example {"full_b": {"description": "bin is full", "type": "condition"}}',
        )
    landmarks = {}
    for id, entry in document.items():
        landmarks[id] = _landmark(id, entry, path)
        if problem is not None:
            try:
                resolve(id, problem)
            except UnknownSymbolError as error:
                raise InputFileError(error.what, path, field=id, hint=error.hint) from error
    return landmarks


def landmarks_to_json(landmarks: Landmarks) -> dict[str, Any]:
    """The document that `landmarks_from_json` reads."""
    return {
        one.id: {
            "description": one.description,
            "type": str(one.type),
            **({"names": list(one.names)} if one.names else {}),
            **({"lasts": one.lasts} if one.lasts is not None else {}),
        }
        for one in landmarks.values()
    }


def _landmark(id: str, entry: object, path: str | Path) -> Landmark:
    if not is_proposition(id):
        raise InputFileError(
            f"{id!r} cannot be a symbol",
            path,
            field=id,
            hint="letters, digits and underscores, and no operator of the logic (F G U W R X)",
        )
    if not isinstance(entry, dict):
        raise InputFileError("expected an object with description and type", path, field=id)
    description = entry.get("description")
    if not isinstance(description, str) or not description.strip():
        raise InputFileError("a description is missing", path, field=f"{id}.description")
    try:
        type = LandmarkType(entry.get("type", ""))
    except ValueError as error:
        raise InputFileError(
            "expected 'location', 'condition' or 'action'", path, field=f"{id}.type"
        ) from error
    names = entry.get("names", [])
    if not isinstance(names, list) or not all(isinstance(n, str) and n.strip() for n in names):
        raise InputFileError("expected a list of texts", path, field=f"{id}.names")
    return Landmark(
        id, " ".join(description.split()), type, tuple(names), _lasts(id, entry, type, path)
    )


def _lasts(id: str, entry: Mapping[str, Any], type: LandmarkType, path: str | Path) -> float | None:
    lasts = entry.get("lasts")
    if lasts is None:
        return None
    if isinstance(lasts, bool) or not isinstance(lasts, int | float) or not 0 < lasts < math.inf:
        raise InputFileError(
            "expected a number of seconds greater than 0", path, field=f"{id}.lasts"
        )
    if type is LandmarkType.ACTION:
        raise InputFileError(
            "an action is over at once: it cannot last",
            path,
            field=f"{id}.lasts",
            hint="`lasts` says how long a fact is known after it was seen",
        )
    return float(lasts)
