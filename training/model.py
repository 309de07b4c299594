"""The network of `language.network` in PyTorch, to be trained; its weights have the same names."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import torch
from safetensors.torch import load_file
from torch import Tensor, nn
from torch.nn import functional
from training.examples import Example

from plainspoken.language.network import FORMS, LONGEST, REFUSE, SLOTS, STOP, TYPES, WRITTEN
from plainspoken.language.wordpiece import END, START, UNKNOWN, Pieces

WIDTH = 384
HEADS = 12
_MOST_USUAL = 20_000
"""Pieces beyond this place in the vocabulary, which is by frequency, are left out."""
_BEGIN = len(WRITTEN)


def kept_pieces(vocabulary: Sequence[str]) -> list[int]:
    """Which pieces of BERT's vocabulary are kept: the more usual ones of English, and letters."""
    return [
        number
        for number, piece in enumerate(vocabulary)
        if piece in (UNKNOWN, START, END)
        or (
            piece.isascii()
            and not piece.startswith("[")
            and (number < _MOST_USUAL or len(piece.lstrip("#")) == 1)
        )
    ]


class Encoder(nn.Module):
    """A layer of BERT (Devlin et al., 2019)."""

    def __init__(self, width: int = WIDTH, inner: int = 4 * WIDTH) -> None:
        super().__init__()
        self.q, self.k, self.v, self.o = (nn.Linear(width, width) for _ in range(4))
        self.a, self.b = nn.Linear(width, inner), nn.Linear(inner, width)
        self.n1, self.n2 = nn.LayerNorm(width, 1e-12), nn.LayerNorm(width, 1e-12)
        self.drop = nn.Dropout(0.1)

    def forward(self, rows: Tensor, mask: Tensor) -> Tensor:
        heard = _attended(self.q(rows), self.k(rows), self.v(rows), HEADS, mask=mask)
        rows = self.n1(rows + self.drop(self.o(heard)))
        thought = self.b(functional.gelu(self.a(rows), approximate="tanh"))
        return self.n2(rows + self.drop(thought))


class Decoder(nn.Module):
    """A layer that looks back at what was written, and across at what was read."""

    def __init__(self, width: int = WIDTH, inner: int = 2 * WIDTH) -> None:
        super().__init__()
        self.q, self.k, self.v, self.o = (nn.Linear(width, width) for _ in range(4))
        self.cq, self.ck, self.cv, self.co = (nn.Linear(width, width) for _ in range(4))
        self.a, self.b = nn.Linear(width, inner), nn.Linear(inner, width)
        self.n1, self.n2, self.n3 = (nn.LayerNorm(width) for _ in range(3))
        self.drop = nn.Dropout(0.1)

    def forward(self, rows: Tensor, read: Tensor, mask: Tensor) -> Tensor:
        heads = HEADS // 2
        heard = _attended(self.q(rows), self.k(rows), self.v(rows), heads, causal=True)
        rows = self.n1(rows + self.drop(self.o(heard)))
        seen = _attended(self.cq(rows), self.ck(read), self.cv(read), heads, mask=mask)
        rows = self.n2(rows + self.drop(self.co(seen)))
        thought = self.b(functional.gelu(self.a(rows), approximate="tanh"))
        return self.n3(rows + self.drop(thought))


def _attended(
    q: Tensor, k: Tensor, v: Tensor, heads: int, *, mask: Tensor | None = None, causal: bool = False
) -> Tensor:
    q, k, v = (each.unflatten(-1, (heads, -1)).transpose(1, 2) for each in (q, k, v))
    seen = None if mask is None else mask[:, None, None, :]
    found = functional.scaled_dot_product_attention(q, k, v, attn_mask=seen, is_causal=causal)
    return found.transpose(1, 2).flatten(2)


@dataclass(frozen=True)
class Batch:
    """Examples as numbers. Shapes: (batch, longest), targets with -100 behind their end.

    pieces: ids of pieces, 0 where a mark stands; slots: of marks, -1 elsewhere
    features: (batch, longest, 4), which rows of the table of features a mark adds up
    """

    pieces: Tensor
    slots: Tensor
    features: Tensor
    mask: Tensor
    before: Tensor
    targets: Tensor


class Reader(nn.Module):
    """Reads marks and pieces, writes tokens and points at marks."""

    def __init__(self, pieces: int, encoders: int, decoders: int) -> None:
        super().__init__()
        self.emb, self.pos = nn.Embedding(pieces, WIDTH), nn.Embedding(LONGEST, WIDTH)
        self.norm, self.drop = nn.LayerNorm(WIDTH, 1e-12), nn.Dropout(0.1)
        self.slot, self.feat = nn.Embedding(SLOTS, WIDTH), nn.Embedding(12, WIDTH)
        self.enc = nn.ModuleList(Encoder() for _ in range(encoders))
        self.oemb, self.opos = nn.Embedding(_BEGIN + 1, WIDTH), nn.Embedding(64, WIDTH)
        self.dec = nn.ModuleList(Decoder() for _ in range(decoders))
        self.head, self.ptr = nn.Linear(WIDTH, _BEGIN), nn.Linear(WIDTH, WIDTH)
        self.key, self.slotin = nn.Linear(WIDTH, WIDTH), nn.Linear(WIDTH, WIDTH)
        for table in (self.slot, self.feat, self.oemb, self.opos):
            nn.init.normal_(table.weight, std=0.02)

    def start_from(self, folder: Path, kept: Sequence[int]) -> None:
        """Take over the embeddings and the lower layers of a MiniLM."""
        given = load_file(folder / "model.safetensors")
        with torch.no_grad():
            self.emb.weight.copy_(given["embeddings.word_embeddings.weight"][list(kept)])
            places = given["embeddings.position_embeddings.weight"][:LONGEST]
            self.pos.weight.copy_(places + given["embeddings.token_type_embeddings.weight"][0])
            _take(self.norm, given, "embeddings.LayerNorm")
            for number, layer in enumerate(self.enc):
                for mine, theirs in _THEIRS.items():
                    _take(getattr(layer, mine), given, f"encoder.layer.{number}.{theirs}")

    def forward(self, batch: Batch) -> Tensor:
        """The scores of each next token: (batch, longest target, tokens and slots)."""
        marks = self.slot(batch.slots.clamp(min=0)) + self.feat(batch.features).sum(2)
        rows = torch.where((batch.slots >= 0)[..., None], marks, self.emb(batch.pieces))
        rows = self.drop(self.norm(rows + self.pos.weight[: rows.shape[1]]))
        for layer in self.enc:
            rows = layer(rows, batch.mask)
        chosen = (batch.slots[:, None, :] == torch.arange(SLOTS)[None, :, None]).float()
        present = chosen.sum(-1)
        pointed = chosen @ rows / present[..., None].clamp(min=1)
        return self._written(batch, rows, pointed, present > 0)

    def _written(self, batch: Batch, read: Tensor, pointed: Tensor, present: Tensor) -> Tensor:
        before = batch.before
        slot = (before - _BEGIN - 1).clamp(min=0)[..., None].expand(-1, -1, WIDTH)
        symbols = self.slotin(pointed.gather(1, slot))
        state = torch.where(
            (before > _BEGIN)[..., None], symbols, self.oemb(before.clamp(max=_BEGIN))
        )
        state = state + self.opos.weight[: before.shape[1]]
        for layer in self.dec:
            state = layer(state, read, batch.mask)
        pointers = self.ptr(state) @ self.key(pointed).transpose(1, 2) * 4 / math.sqrt(WIDTH)
        pointers = pointers.masked_fill(~present[:, None, :], -1e4)
        return torch.cat([self.head(state), pointers], -1)


_THEIRS = {
    "q": "attention.self.query", "k": "attention.self.key", "v": "attention.self.value",
    "o": "attention.output.dense", "n1": "attention.output.LayerNorm",
    "a": "intermediate.dense", "b": "output.dense", "n2": "output.LayerNorm",
}  # fmt: skip


def _take(layer: nn.Module, given: Mapping[str, Tensor], name: str) -> None:
    layer.weight.copy_(given[f"{name}.weight"])  # type: ignore[operator,union-attr]
    layer.bias.copy_(given[f"{name}.bias"])  # type: ignore[operator,union-attr]


def batch_of(examples: Sequence[Example], pieces: Pieces) -> Batch:
    """Examples as numbers, as `Network` numbers them."""
    inputs = [_input(each, pieces) for each in examples]
    targets = [_target(each) for each in examples]
    size, longest, most = len(inputs), max(map(len, inputs)), max(map(len, targets))
    made = Batch(
        torch.zeros(size, longest, dtype=torch.long),
        torch.full((size, longest), -1),
        torch.zeros(size, longest, 4, dtype=torch.long),
        torch.zeros(size, longest, dtype=torch.bool),
        torch.zeros(size, most, dtype=torch.long),
        torch.full((size, most), -100),
    )
    for row, (read, target) in enumerate(zip(inputs, targets, strict=True)):
        made.mask[row, : len(read)] = True
        for place, each in enumerate(read):
            if isinstance(each, tuple):
                made.slots[row, place] = each[0]
                made.features[row, place] = torch.tensor(each[1:])
            else:
                made.pieces[row, place] = each
        # What is written has no token for the beginning; what stands before has.
        made.targets[row, : len(target)] = torch.tensor([n - (n > _BEGIN) for n in target])
        made.before[row, : len(target)] = torch.tensor([_BEGIN, *target[:-1]])
    return made


def _input(example: Example, pieces: Pieces) -> list[int | tuple[int, ...]]:
    slots = {symbol: slot for slot, symbol in enumerate(example.symbols[:SLOTS])}
    found: list[int | tuple[int, ...]] = [pieces.start]
    for each in example.said:
        if isinstance(each, str):
            found += pieces.of(each)
        elif each.symbol in slots:
            features = (
                TYPES.index(each.type), len(TYPES) + FORMS.index(each.form),
                8 + each.negated, 10 + each.carried,
            )  # fmt: skip
            found.append((slots[each.symbol], *features))
    return [*found[: LONGEST - 1], pieces.end]


def _target(example: Example) -> list[int]:
    if example.tokens is None:
        return [WRITTEN.index(REFUSE), WRITTEN.index(STOP)]
    slots = {symbol: slot for slot, symbol in enumerate(example.symbols)}
    numbers = {token: number for number, token in enumerate(WRITTEN)}
    written = [
        numbers[token] if token in numbers else _BEGIN + 1 + slots[token]
        for token in example.tokens
    ]
    return [*written, WRITTEN.index(STOP)]


def pack(reader: Reader, pieces: Sequence[str], path: Path) -> None:
    """Store weights as `language.network.unpacked` reads them: 8 bits, a scale for each row."""
    stored: dict[str, np.ndarray] = {}
    for name, tensor in reader.state_dict().items():
        values = tensor.float().numpy()
        if values.ndim == 2:
            scale = np.abs(values).max(axis=1) / 127
            scale[scale == 0] = 1
            stored[name] = np.round(values / scale[:, None]).clip(-127, 127).astype(np.int8)
            stored[f"{name}.scale"] = scale.astype(np.float32)
        else:
            stored[name] = values.astype(np.float32)
    stored["pieces"] = np.frombuffer("\n".join(pieces).encode(), dtype=np.uint8)
    stored["heads"] = np.array(HEADS)
    np.savez(path, **stored)
