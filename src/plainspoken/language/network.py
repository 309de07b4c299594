"""A small transformer that reads a marked utterance and writes mission patterns.

An encoder reads pieces of words and marks; a decoder writes tokens of the notation and, for a
symbol, points at its mark. What is computed here is what `training/train.py` trains.

Source: Vaswani et al., Attention Is All You Need, 2017 (layers); Vinyals, Fortunato and Jaitly,
Pointer Networks, 2015 (symbols). The encoder begins as the lower layers of all-MiniLM-L6-v2
(Wang et al., MiniLM, 2020).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.resources import as_file, files
from typing import Any

import numpy as np
import numpy.typing as npt

from plainspoken.language.marking import Mark, Marked
from plainspoken.language.notation import TOKENS
from plainspoken.language.reference import Form
from plainspoken.language.wordpiece import Pieces
from plainspoken.world.landmark import LandmarkType
from plainspoken.world.symbol import SymbolId

Array = npt.NDArray[np.float32]

STOP = "<end>"
REFUSE = "<reject>"
WRITTEN = (STOP, REFUSE, *TOKENS)
"""What the decoder can write beside symbols."""
_REFUSED = WRITTEN.index(REFUSE)
SLOTS = 20
"""Symbols of one utterance."""
LONGEST = 200
"""Pieces and marks of one utterance."""
MOST_TOKENS = 60
TYPES = tuple(LandmarkType)
FORMS = (*Form, None)


@dataclass(frozen=True, slots=True)
class Written:
    """What a network makes of an utterance.

    tokens:      in the notation, None where it finds no mission, or is not made for such length
    probability: of just these tokens, by its own estimate
    refusal:     the probability that there is no mission, by its own estimate
    """

    tokens: tuple[str, ...] | None
    probability: float
    refusal: float


class Network:
    """Weights, and the arithmetic that they are for."""

    def __init__(self, weights: Mapping[str, Array], pieces: Sequence[str], heads: int) -> None:
        self._weights = weights
        self._pieces = Pieces(pieces)
        self._heads = heads
        names = {name.split(".")[1] for name in weights if name.startswith("enc.")}
        self._encoders = sorted(names, key=int)
        names = {name.split(".")[1] for name in weights if name.startswith("dec.")}
        self._decoders = sorted(names, key=int)
        # One product instead of three: a call costs about as much as so small a product.
        self._together = {
            f"{stack}.{number}": _joined(weights, f"{stack}.{number}", "qkv")
            for stack, numbers in (("enc", self._encoders), ("dec", self._decoders))
            for number in numbers
        }

    def write(self, said: Marked) -> Written:
        """Write the patterns that an utterance asks for, the likeliest token after the other."""
        symbols = tuple(dict.fromkeys(each.symbol for each in said if isinstance(each, Mark)))[
            :SLOTS
        ]
        slots = {symbol: index for index, symbol in enumerate(symbols)}
        if not symbols:
            return Written(None, 1.0, 1.0)
        if len(said) > LONGEST:
            return Written(None, 0.0, 0.0)
        inputs, marks = self._inputs(said, slots)
        read = self._encoded(inputs)
        pointed = np.stack([read[marks[index]].mean(axis=0) for index in range(len(symbols))])
        return self._decoded(read, pointed, symbols)

    def _inputs(
        self, said: Sequence[str | Mark], slots: Mapping[SymbolId, int]
    ) -> tuple[Array, Mapping[int, list[int]]]:
        """A row for each piece and mark, and at which rows the marks of each slot stand."""
        weights = self._weights
        rows: list[Array] = [weights["emb.weight"][self._pieces.start]]
        marks: dict[int, list[int]] = {index: [] for index in slots.values()}
        for each in said:
            if isinstance(each, str):
                rows += [weights["emb.weight"][piece] for piece in self._pieces.of(each)]
            elif each.symbol in slots:
                marks[slots[each.symbol]].append(len(rows))
                rows.append(self._mark(each, slots[each.symbol]))
        rows = [*rows[: LONGEST - 1], weights["emb.weight"][self._pieces.end]]
        kept = {slot: [row for row in at if row < LONGEST - 1] or [0] for slot, at in marks.items()}
        inputs = np.stack(rows) + weights["pos.weight"][: len(rows)]
        return self._normed(inputs, "norm", 1e-12), kept

    def _mark(self, mark: Mark, slot: int) -> Array:
        features = self._weights["feat.weight"]
        found: Array = (
            self._weights["slot.weight"][slot]
            + features[TYPES.index(mark.type)]
            + features[len(TYPES) + FORMS.index(mark.form)]
            + features[8 + mark.negated]
            + features[10 + mark.carried]
        )
        return found

    def states(self, words: Sequence[str]) -> tuple[Array, ...]:
        """What the encoder makes of plain words, layer by layer: a row for each of their pieces."""
        rows, _ = self._inputs(words, {})
        return tuple(each[1:-1] for each in self._layers(rows))

    def _encoded(self, rows: Array) -> Array:
        *_, last = self._layers(rows)
        return last

    def _layers(self, rows: Array) -> Iterator[Array]:
        for number in self._encoders:
            name = f"enc.{number}"
            q, k, v = self._asked(rows, name)
            heard = self._linear(_attended(q, k, v, self._heads), f"{name}.o")
            rows = self._normed(rows + heard, f"{name}.n1", 1e-12)
            thought = self._linear(_gelu(self._linear(rows, f"{name}.a")), f"{name}.b")
            rows = self._normed(rows + thought, f"{name}.n2", 1e-12)
            yield rows

    def _decoded(self, read: Array, pointed: Array, symbols: Sequence[SymbolId]) -> Written:
        weights = self._weights
        keys = self._linear(pointed, "key").T
        across = {
            number: tuple(self._linear(read, f"dec.{number}.c{part}") for part in "kv")
            for number in self._decoders
        }
        before: dict[str, list[tuple[Array, Array]]] = {number: [] for number in self._decoders}
        row = weights["oemb.weight"][len(WRITTEN)]
        tokens: list[str] = []
        likelihood = refusal = 0.0
        for place in range(MOST_TOKENS):
            state = row + weights["opos.weight"][place]
            for number in self._decoders:
                state = self._step(state, number, before[number], across[number])
            scores = np.concatenate(
                (
                    self._linear(state, "head"),
                    self._linear(state, "ptr") @ keys * np.float32(4 / np.sqrt(len(state))),
                )
            )
            best = int(scores.argmax())
            chances = np.exp(scores - scores[best])
            chances /= chances.sum()
            likelihood += float(np.log(chances[best]))
            if not tokens:
                refusal = float(chances[_REFUSED])
            if best < len(WRITTEN):
                token = WRITTEN[best]
                if token in (STOP, REFUSE):
                    refused = token == REFUSE
                    wrote = None if refused else tuple(tokens)
                    return Written(wrote, float(np.exp(likelihood)), refusal)
                row = weights["oemb.weight"][best]
            else:
                token = symbols[best - len(WRITTEN)]
                row = self._linear(pointed[best - len(WRITTEN)], "slotin")
            tokens.append(token)
        return Written(tuple(tokens), 0.0, refusal)

    def _step(
        self,
        state: Array,
        number: str,
        before: list[tuple[Array, Array]],
        across: tuple[Array, ...],
    ) -> Array:
        """One token through one layer of the decoder; what later ones look back at is kept."""
        name, heads = f"dec.{number}", self._heads // 2
        q, k, v = self._asked(state, name)
        before.append((k, v))
        keys, values = (np.stack(each) for each in zip(*before, strict=True))
        heard = _attended(q[None], keys, values, heads)[0]
        state = self._normed(state + self._linear(heard, f"{name}.o"), f"{name}.n1", 1e-5)
        q = self._linear(state, f"{name}.cq")
        seen = _attended(q[None], across[0], across[1], heads)[0]
        state = self._normed(state + self._linear(seen, f"{name}.co"), f"{name}.n2", 1e-5)
        thought = self._linear(_gelu(self._linear(state, f"{name}.a")), f"{name}.b")
        return self._normed(state + thought, f"{name}.n3", 1e-5)

    def _asked(self, rows: Array, name: str) -> tuple[Array, Array, Array]:
        """The queries, keys and values of a layer's own rows."""
        weight, bias = self._together[name]
        found = rows @ weight + bias
        width = found.shape[-1] // 3
        return found[..., :width], found[..., width : 2 * width], found[..., 2 * width :]

    def _linear(self, rows: Array, name: str) -> Array:
        found: Array = rows @ self._weights[f"{name}.weight"] + self._weights[f"{name}.bias"]
        return found

    def _normed(self, rows: Array, name: str, least: float) -> Array:
        centred = rows - rows.mean(axis=-1, keepdims=True)
        spread = np.sqrt((centred * centred).mean(axis=-1, keepdims=True) + np.float32(least))
        found: Array = (
            centred / spread * self._weights[f"{name}.weight"] + self._weights[f"{name}.bias"]
        )
        return found


def _attended(queries: Array, keys: Array, values: Array, heads: int) -> Array:
    """Scaled dot-product attention, by heads. queries: (n, d); keys and values: (m, d)."""
    width = queries.shape[1] // heads
    q, k, v = (
        each.reshape(len(each), heads, width).transpose(1, 0, 2) for each in (queries, keys, values)
    )
    scores = q @ k.transpose(0, 2, 1) * np.float32(1 / np.sqrt(width))
    scores = np.exp(scores - scores.max(axis=-1, keepdims=True))
    scores /= scores.sum(axis=-1, keepdims=True)
    found: Array = (scores @ v).transpose(1, 0, 2).reshape(len(queries), -1)
    return found


def _joined(weights: Mapping[str, Array], name: str, parts: str) -> tuple[Array, Array]:
    """Several linear maps of the same rows as one."""
    return (
        np.concatenate([weights[f"{name}.{part}.weight"] for part in parts], axis=1),
        np.concatenate([weights[f"{name}.{part}.bias"] for part in parts]),
    )


def _gelu(rows: Array) -> Array:
    """The Gaussian error linear unit in its tanh form (Hendrycks and Gimpel, 2016)."""
    inner = rows * rows
    inner *= np.float32(0.044715)
    inner += 1
    inner *= rows
    inner *= np.float32(0.7978845608)
    np.tanh(inner, out=inner)
    inner += 1
    inner *= rows
    inner *= np.float32(0.5)
    return inner


@cache
def network() -> Network:
    """The network that comes with the package."""
    with (
        as_file(files("plainspoken.language").joinpath("reader.npz")) as path,
        np.load(path) as file,
    ):
        return Network(*unpacked(file))


def unpacked(stored: Mapping[str, npt.NDArray[Any]]) -> tuple[dict[str, Array], list[str], int]:
    """Weights as they are stored: matrices as 8-bit integers with a scale for each row."""
    weights: dict[str, Array] = {}
    for name in stored:
        if name.endswith(".scale") or name in ("pieces", "heads"):
            continue
        values = stored[name]
        if values.dtype == np.int8:
            values = values.astype(np.float32) * stored[f"{name}.scale"][:, None]
            if not name.startswith(("emb", "pos", "slot.", "feat", "oemb", "opos")):
                values = np.ascontiguousarray(values.T)
        weights[name] = values.astype(np.float32)
    pieces = bytes(stored["pieces"]).decode().split("\n")
    return weights, pieces, int(stored["heads"])
