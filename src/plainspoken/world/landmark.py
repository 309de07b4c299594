"""Landmarks: the symbols that a person may speak of, with the words for each.

A landmarks file is JSON: an id for each symbol, with a description, a type (location, condition
or action) and, if wanted, further names.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import Any

from plainspoken.errors import AmbiguousSymbolError, InputFileError, UnknownSymbolError
from plainspoken.logic.syntax import is_proposition
from plainspoken.world.domain import Parameter, Problem
from plainspoken.world.symbol import SymbolId, flat, resolve

MOST_DERIVED = 2000
"""More landmarks than this are not derived from a problem: nobody would read them."""


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
    """

    id: SymbolId
    description: str
    type: LandmarkType
    names: tuple[str, ...] = ()

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
    try:
        document = json.loads(
            Path(path).read_text(encoding="utf-8-sig"), object_pairs_hook=_unique(path)
        )
    except OSError as error:
        raise InputFileError(
            f"cannot read the file: {error.strerror}", path, hint="check the path"
        ) from error
    except json.JSONDecodeError as error:
        raise InputFileError(
            f"not JSON: {error.msg}", path, line=error.lineno, column=error.colno
        ) from error
    except (UnicodeDecodeError, RecursionError) as error:
        raise InputFileError("not a JSON text in UTF-8", path) from error
    return landmarks_from_json(document, path, problem)


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
            except (UnknownSymbolError, AmbiguousSymbolError) as error:
                raise InputFileError(error.what, path, field=id, hint=error.hint) from error
    return landmarks


def landmarks_to_json(landmarks: Landmarks) -> dict[str, Any]:
    """The document that `landmarks_from_json` reads."""
    return {
        one.id: {
            "description": one.description,
            "type": str(one.type),
            **({"names": list(one.names)} if one.names else {}),
        }
        for one in landmarks.values()
    }


def derived_landmarks(problem: Problem) -> Landmarks:
    """Landmarks made from the names in a domain and problem, where no file gives them.

    One for each ground atom that an action can change, each action, and each action with one
    object. A predicate that ties a thing to a place (`robot-at ?r ?l`) gives locations, of the
    first robot only under the bare name of the place.
    """
    found: dict[SymbolId, Landmark] = {}
    for predicate in sorted(problem.changing_predicates):
        parameters = problem.domain.predicates[predicate]
        for binding in problem.bindings(parameters):
            arguments = tuple(binding.values())
            id = flat(" ".join([predicate, *arguments]))
            words, type, names = _words_of_atom(predicate, arguments, parameters, problem)
            found[id] = Landmark(id, words, type, names)
            if len(found) > MOST_DERIVED:
                return found
    for schema in problem.domain.actions:
        id = f"{flat(schema.name)}_executed"
        found[id] = Landmark(id, f"to {spaced(schema.name)}", LandmarkType.ACTION)
        for parameter in schema.parameters:
            for name in problem.objects_for(parameter):
                if parameter.types != ("object",) and _is_mover(parameter, problem):
                    continue
                one = f"{flat(schema.name)}_{flat(name)}_executed"
                words = f"to {spaced(schema.name)} {spaced(name)}"
                found.setdefault(one, Landmark(one, words, LandmarkType.ACTION))
    return found


def spaced(name: str) -> str:
    """A PDDL name as words: `robot-at` is "robot at", `line3` is "line 3"."""
    words = name.replace("-", " ").replace("_", " ")
    return "".join(
        f" {character}"
        if character.isdigit()
        and index
        and words[index - 1].isalpha()
        and not _is_code(words, index)
        else character
        for index, character in enumerate(words)
    )


def _is_code(words: str, index: int) -> bool:
    """Whether the letters before a digit are a code such as `l` in `l0`, not a word."""
    head = words[:index].split(" ")[-1]
    return len(head) < 3


def _is_mover(parameter: Parameter, problem: Problem) -> bool:
    return any(
        problem.objects_for(Parameter("?", (each,))) and each in _mover_types(problem)
        for each in parameter.types
    )


def _mover_types(problem: Problem) -> frozenset[str]:
    """The types of what is somewhere: the first place of a changing `...at` predicate."""
    found: set[str] = set()
    for predicate in problem.changing_predicates:
        parameters = problem.domain.predicates[predicate]
        if len(parameters) == 2 and predicate.split("-")[-1].split("_")[-1] in ("at", "in"):
            found.update(parameters[0].types)
    return frozenset(found - {"object"})


def _words_of_atom(
    predicate: str,
    arguments: tuple[str, ...],
    parameters: tuple[Parameter, ...],
    problem: Problem,
) -> tuple[str, LandmarkType, tuple[str, ...]]:
    words = [spaced(argument) for argument in arguments]
    tail = predicate.replace("_", "-").split("-")
    if len(arguments) == 2 and tail[-1] in ("at", "in", "on"):
        names = (f"{words[0]} {tail[-1]} {words[1]}",)
        first = next(iter(problem.objects_for(parameters[0])), None)
        if tail[-1] == "at" and arguments[0] == first and "robot" in predicate + words[0]:
            return words[1], LandmarkType.LOCATION, names
        return f"{words[0]} is {tail[-1]} {words[1]}", LandmarkType.CONDITION, ()
    if len(arguments) == 1:
        return f"{words[0]} is {spaced(predicate)}", LandmarkType.CONDITION, ()
    if len(arguments) == 2:
        return f"{words[0]} is {spaced(predicate)} {words[1]}", LandmarkType.CONDITION, ()
    return " ".join([spaced(predicate), *words]), LandmarkType.CONDITION, ()


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
    return Landmark(id, " ".join(description.split()), type, tuple(names))


def _unique(path: str | Path) -> Any:
    def pairs(items: list[tuple[str, Any]]) -> dict[str, Any]:
        seen: dict[str, Any] = {}
        for name, value in items:
            if name in seen:
                raise InputFileError("an entry stands twice", path, field=name)
            seen[name] = value
        return seen

    return pairs
