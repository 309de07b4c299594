"""Where the places of a site lie on its map, and how its things look: a file, or worked out.

A layout file is JSON, see docs/page.md:

    {"places": {"l0": {"at": [130, 330], "shape": "row", "to": [130, 80]}},
     "types": {"grape": {"shape": "grape", "marks": {"ripe": {"tone": "good", "sign": "●"}}}},
     "keeps": {"in-hand": "robot", "stored": "wh"}}
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from plainspoken.errors import InputFileError
from plainspoken.world.document import read_json

WIDTH, HEIGHT = 800.0, 480.0
MARGIN = 80.0
SHAPES = ("stop", "row", "house")
TONES = ("plain", "good", "bad", "doubt", "unseen", "done")
_ROUNDS = 300

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Spot:
    """A place on the map: where robots stop there, and for a row, where it ends."""

    at: Point
    shape: str = "stop"
    to: Point | None = None


@dataclass(frozen=True, slots=True)
class Mark:
    """How a thing looks of which a predicate is true: a tone, and a sign for whoever sees none."""

    tone: str
    sign: str


@dataclass(frozen=True)
class Layout:
    """A map as far as a file says.

    marks: by type and predicate
    keeps: by predicate of one thing, the place that has it then, or `robot`
    """

    places: Mapping[str, Spot] = field(default_factory=dict)
    shapes: Mapping[str, str] = field(default_factory=dict)
    marks: Mapping[tuple[str, str], Mark] = field(default_factory=dict)
    keeps: Mapping[str, str] = field(default_factory=dict)


def read_layout(path: Path) -> Layout:
    """Read a layout file.

    raises InputFileError: with the field that is wrong
    """
    return layout_from_json(read_json(path), path)


def layout_from_json(document: object, path: Path | str) -> Layout:
    """Check a parsed layout document; path is for the errors.

    raises InputFileError: with the field that is wrong
    """
    top = _object(document, path, "(top)")
    places = {
        name: _spot(_object(entry, path, f"places.{name}"), path, f"places.{name}")
        for name, entry in _object(top.get("places", {}), path, "places").items()
    }
    shapes: dict[str, str] = {}
    marks: dict[tuple[str, str], Mark] = {}
    for type_, entry in _object(top.get("types", {}), path, "types").items():
        given = _object(entry, path, f"types.{type_}")
        if "shape" in given:
            shapes[type_] = str(given["shape"])
        for predicate, mark in _object(
            given.get("marks", {}), path, f"types.{type_}.marks"
        ).items():
            marks[type_, predicate] = _mark(mark, path, f"types.{type_}.marks.{predicate}")
    keeps = _object(top.get("keeps", {}), path, "keeps")
    return Layout(places, shapes, marks, {name: str(keeper) for name, keeper in keeps.items()})


def _spot(entry: Mapping[str, Any], path: Path | str, where: str) -> Spot:
    shape = entry.get("shape", "stop")
    if shape not in SHAPES:
        raise InputFileError(
            f"there is no shape {shape!r}", path, field=f"{where}.shape", hint=_either(SHAPES)
        )
    to = None if "to" not in entry else _point(entry["to"], path, f"{where}.to")
    if shape == "row" and to is None:
        raise InputFileError("a row needs its other end", path, field=f"{where}.to")
    return Spot(_point(entry.get("at"), path, f"{where}.at"), shape, to)


def _mark(entry: object, path: Path | str, where: str) -> Mark:
    given = _object(entry, path, where)
    tone = given.get("tone", "plain")
    if tone not in TONES:
        raise InputFileError(
            f"there is no tone {tone!r}", path, field=f"{where}.tone", hint=_either(TONES)
        )
    return Mark(tone, str(given.get("sign", ""))[:2])


def _either(names: Sequence[str]) -> str:
    return f"one of {', '.join(names)}"


def _point(value: object, path: Path | str, where: str) -> Point:
    if (
        isinstance(value, list)
        and len(value) == 2
        and all(isinstance(each, int | float) and math.isfinite(each) for each in value)
    ):
        return float(value[0]), float(value[1])
    raise InputFileError("expected [x, y]", path, field=where, hint="the map is 800 by 480")


def _object(value: object, path: Path | str, where: str) -> Mapping[str, Any]:
    if not isinstance(value, dict):
        raise InputFileError(f"expected an object, got {type(value).__name__}", path, field=where)
    return value


def arranged(names: Sequence[str], ways: Sequence[tuple[str, str]]) -> Mapping[str, Point]:
    """Points for the nodes of a graph, neighbours near each other; the same for the same graph.

    Source: Fruchterman, Reingold, Graph drawing by force-directed placement, 1991; begun on a
    circle and not at random, so that a map looks the same tomorrow.
    """
    count = len(names)
    if count == 0:
        return {}
    if count == 1:
        return {names[0]: (WIDTH / 2, HEIGHT / 2)}
    turns = np.linspace(0.0, 2 * np.pi, count, endpoint=False) - np.pi / 2
    spots = np.stack([np.cos(turns), np.sin(turns)], axis=1)
    number = {name: index for index, name in enumerate(names)}
    joined = np.zeros((count, count))
    for first, second in ways:
        joined[number[first], number[second]] = joined[number[second], number[first]] = 1.0
    ideal = 1.6 / math.sqrt(count)
    for heat in np.linspace(0.12, 0.002, _ROUNDS if count <= 150 else _ROUNDS // 6):
        apart = spots[:, None, :] - spots[None, :, :]
        far = np.maximum(np.linalg.norm(apart, axis=2), 1e-3)
        push = ideal**2 / far**2 - joined * far / ideal
        step = (apart * push[:, :, None]).sum(axis=1) - 0.1 * spots
        size = np.maximum(np.linalg.norm(step, axis=1, keepdims=True), 1e-9)
        spots += step / size * np.minimum(size, heat)
    low, high = spots.min(axis=0), spots.max(axis=0)
    scaled = (spots - low) / np.maximum(high - low, 1e-6)
    x = MARGIN + scaled[:, 0] * (WIDTH - 2 * MARGIN)
    y = MARGIN + scaled[:, 1] * (HEIGHT - 2 * MARGIN)
    return {name: (round(float(x[i]), 1), round(float(y[i]), 1)) for i, name in enumerate(names)}
