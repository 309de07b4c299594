"""The network's arithmetic, judged by the plain definitions written out in loops."""

import math
from collections.abc import Sequence

import numpy as np
import pytest

from plainspoken.language.marking import Mark, Marked
from plainspoken.language.network import (
    LONGEST,
    SLOTS,
    WRITTEN,
    Network,
    network,
    unpacked,
)
from plainspoken.language.reference import Form
from plainspoken.language.wordpiece import END, START, UNKNOWN, Pieces
from plainspoken.world.landmark import LandmarkType

WIDTH, HEADS = 24, 4
PIECES = [UNKNOWN, START, END, "go", "to", "##ing", "then", "never", "."]
SAID = (
    "go", "to", Mark("hall", LandmarkType.LOCATION, Form.NOUN), "then",
    Mark("lit", LandmarkType.CONDITION, Form.FINITE, negated=True), "going", ".",
    Mark("attic", LandmarkType.LOCATION, length=1), "attic",
)  # fmt: skip


def weights(seed: int) -> dict[str, np.ndarray]:
    draw = np.random.default_rng(seed)
    made = {}

    def linear(name: str, inner: int, outer: int) -> None:
        made[f"{name}.weight"] = draw.normal(0, 0.3, (inner, outer)).astype(np.float32)
        made[f"{name}.bias"] = draw.normal(0, 0.3, outer).astype(np.float32)

    def norm(name: str) -> None:
        made[f"{name}.weight"] = draw.normal(1, 0.1, WIDTH).astype(np.float32)
        made[f"{name}.bias"] = draw.normal(0, 0.1, WIDTH).astype(np.float32)

    tables = {"emb": len(PIECES), "pos": LONGEST, "slot": SLOTS, "feat": 12,
              "oemb": len(WRITTEN) + 1, "opos": 64}  # fmt: skip
    for name, rows in tables.items():
        made[f"{name}.weight"] = draw.normal(0, 0.5, (rows, WIDTH)).astype(np.float32)
    for name in ("norm", "enc.0.n1", "enc.0.n2", "dec.0.n1", "dec.0.n2", "dec.0.n3"):
        norm(name)
    parts = ("enc.0.q", "enc.0.k", "enc.0.v", "enc.0.o", "dec.0.q", "dec.0.k", "dec.0.v", "dec.0.o",
             "dec.0.cq", "dec.0.ck", "dec.0.cv", "dec.0.co", "ptr", "key", "slotin")  # fmt: skip
    for name in parts:
        linear(name, WIDTH, WIDTH)
    for name, inner in (("enc.0", 4 * WIDTH), ("dec.0", 2 * WIDTH)):
        linear(f"{name}.a", WIDTH, inner)
        linear(f"{name}.b", inner, WIDTH)
    linear("head", WIDTH, len(WRITTEN))
    return made


Row = Sequence[float]


class Plain:
    """The same network, one number at a time and everything anew for every token."""

    def __init__(self, given: dict[str, np.ndarray]) -> None:
        self.given = {name: value.astype(np.float64) for name, value in given.items()}

    def linear(self, row: Row, name: str) -> list[float]:
        weight, bias = self.given[f"{name}.weight"], self.given[f"{name}.bias"]
        return [
            sum(row[i] * weight[i, o] for i in range(len(row))) + bias[o] for o in range(len(bias))
        ]

    def norm(self, row: Row, name: str, least: float) -> list[float]:
        mean = sum(row) / len(row)
        spread = math.sqrt(sum((x - mean) ** 2 for x in row) / len(row) + least)
        weight, bias = self.given[f"{name}.weight"], self.given[f"{name}.bias"]
        return [(x - mean) / spread * w + b for x, w, b in zip(row, weight, bias, strict=True)]

    def attend(
        self, query: Row, keys: Sequence[Row], values: Sequence[Row], heads: int
    ) -> list[float]:
        width = len(query) // heads
        heard = []
        for head in range(heads):
            part = slice(head * width, (head + 1) * width)
            scores = [
                sum(a * b for a, b in zip(query[part], key[part], strict=True)) / math.sqrt(width)
                for key in keys
            ]
            odds = [math.exp(score) for score in scores]
            shares = [each / sum(odds) for each in odds]
            heard += [
                sum(share * value[part][i] for share, value in zip(shares, values, strict=True))
                for i in range(width)
            ]
        return heard

    def gelu(self, row: Row) -> list[float]:
        inner = math.sqrt(2 / math.pi)
        return [0.5 * x * (1 + math.tanh(inner * (x + 0.044715 * x**3))) for x in row]

    def added(self, *rows: Row) -> list[float]:
        return [sum(each) for each in zip(*rows, strict=True)]

    def thought(self, row: Row, name: str) -> list[float]:
        return self.linear(self.gelu(self.linear(row, f"{name}.a")), f"{name}.b")

    def encoded(self, said: Marked, slots: dict[str, int]) -> tuple[list[Row], list[Row]]:
        tables, pieces = self.given, Pieces(PIECES)
        rows, at = [tables["emb.weight"][pieces.start]], {slot: [] for slot in slots.values()}
        for each in said:
            if isinstance(each, str):
                rows += [tables["emb.weight"][piece] for piece in pieces.of(each)]
                continue
            slot = slots[each.symbol]
            at[slot].append(len(rows))
            form = [*Form, None].index(each.form)
            of_type = tables["feat.weight"][list(LandmarkType).index(each.type)]
            features = [
                tables["feat.weight"][row]
                for row in (3 + form, 8 + each.negated, 10 + each.carried)
            ]
            rows.append(self.added(tables["slot.weight"][slot], of_type, *features))
        rows.append(tables["emb.weight"][pieces.end])
        rows = [
            self.norm(self.added(row, tables["pos.weight"][i]), "norm", 1e-12)
            for i, row in enumerate(rows)
        ]
        keys, values = ([self.linear(r, f"enc.0.{p}") for r in rows] for p in "kv")
        heard = [self.attend(self.linear(r, "enc.0.q"), keys, values, HEADS) for r in rows]
        rows = [
            self.norm(self.added(r, self.linear(h, "enc.0.o")), "enc.0.n1", 1e-12)
            for r, h in zip(rows, heard, strict=True)
        ]
        rows = [self.norm(self.added(r, self.thought(r, "enc.0")), "enc.0.n2", 1e-12) for r in rows]
        pointed = [
            [sum(rows[i][k] for i in at[slot]) / len(at[slot]) for k in range(WIDTH)]
            for slot in sorted(at)
        ]
        return rows, pointed

    def scores(
        self, rows: Sequence[Row], pointed: Sequence[Row], before: Sequence[int]
    ) -> list[float]:
        """The scores of the next token behind some tokens, by their numbers."""
        tables = self.given
        inputs = [tables["oemb.weight"][len(WRITTEN)]]
        inputs += [
            tables["oemb.weight"][token]
            if token < len(WRITTEN)
            else self.linear(pointed[token - len(WRITTEN)], "slotin")
            for token in before
        ]
        states = [self.added(row, tables["opos.weight"][i]) for i, row in enumerate(inputs)]
        keys, values = ([self.linear(s, f"dec.0.{p}") for s in states] for p in "kv")
        query = self.linear(states[-1], "dec.0.q")
        heard = self.linear(self.attend(query, keys, values, HEADS // 2), "dec.0.o")
        state = self.norm(self.added(states[-1], heard), "dec.0.n1", 1e-5)
        keys, values = ([self.linear(r, f"dec.0.c{p}") for r in rows] for p in "kv")
        seen = self.attend(self.linear(state, "dec.0.cq"), keys, values, HEADS // 2)
        state = self.norm(self.added(state, self.linear(seen, "dec.0.co")), "dec.0.n2", 1e-5)
        state = self.norm(self.added(state, self.thought(state, "dec.0")), "dec.0.n3", 1e-5)
        pointer = self.linear(state, "ptr")
        return self.linear(state, "head") + [
            4
            / math.sqrt(WIDTH)
            * sum(a * b for a, b in zip(pointer, self.linear(p, "key"), strict=True))
            for p in pointed
        ]


@pytest.mark.parametrize("seed", range(8))
def test_it_writes_what_the_plain_definition_writes(
    seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    # A random network may never come to an end: the first tokens tell.
    monkeypatch.setattr("plainspoken.language.network.MOST_TOKENS", 6)
    given = weights(seed)
    wrote = Network(given, PIECES, HEADS).write(SAID)
    plain, symbols = Plain(given), ("hall", "lit", "attic")
    rows, pointed = plain.encoded(SAID, {symbol: i for i, symbol in enumerate(symbols)})
    names = (*WRITTEN, *symbols)
    before, likelihood = [], 1.0
    for _ in range(6):
        scores = plain.scores(rows, pointed, before)
        odds = np.exp(np.array(scores) - max(scores))
        best = int(odds.argmax())
        likelihood *= odds[best] / odds.sum()
        if not before:
            assert wrote.refusal == pytest.approx(
                odds[WRITTEN.index("<reject>")] / odds.sum(), abs=1e-3
            )
        if names[best] in ("<end>", "<reject>"):
            assert wrote.probability == pytest.approx(likelihood, rel=1e-2)
            break
        before.append(best)
    expected = tuple(names[each] for each in before)
    assert (wrote.tokens or ())[: len(expected)] == expected


def test_an_utterance_that_names_nothing_is_no_mission() -> None:
    assert Network(weights(0), PIECES, HEADS).write(("go", "to")).tokens is None


def test_more_than_it_can_hold_is_cut_and_not_a_crash() -> None:
    marks = [Mark(f"m{i}", LandmarkType.CONDITION, Form.FINITE) for i in range(60)]
    assert Network(weights(1), PIECES, HEADS).write(("go", *marks)).tokens != ()
    assert Network(weights(1), PIECES, HEADS).write((*["go"] * 400, *marks)).tokens is None


def test_weights_come_back_from_eight_bits_within_a_half_step() -> None:
    given = weights(2)["emb.weight"]
    scale = np.abs(given).max(axis=1) / 127
    stored = {
        "emb.weight": np.round(given / scale[:, None]).astype(np.int8),
        "emb.weight.scale": scale.astype(np.float32),
        "pieces": np.frombuffer("\n".join(PIECES).encode(), dtype=np.uint8),
        "heads": np.array(HEADS),
    }
    found, pieces, heads = unpacked(stored)
    assert np.abs(found["emb.weight"] - given).max() <= scale.max() / 2 + 1e-6
    assert (pieces, heads) == (PIECES, HEADS)


def test_the_network_in_the_package_is_at_most_twenty_megabytes() -> None:
    from importlib.resources import files

    size = len(files("plainspoken.language").joinpath("reader.npz").read_bytes())
    assert size <= 20_000_000
    assert network() is network()
