"""Fit the listener of questions: python -m training.questions. See README.md beside this.

python -m training.questions              # on all questions, into the package
python -m training.questions --held-out   # what it is worth on missions that it has not seen
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from training.asked import ROOT, Asked, judged, written

from plainspoken.questions.agreement import settled
from plainspoken.questions.kind import Kind
from plainspoken.questions.listener import KINDS, ROWS, Array, Listener, meaning_of, rows_of
from plainspoken.questions.question import ruled_kind

STEPS = 60
PACE = {"table": 0.05, "meaning": 0.01}
SHRINKAGE = {"table": 1e-4, "meaning": 1e-3}
"""How much large weights cost; of a few tried on missions held out."""
SPREAD = 0.3
"""The deviation to which each number of a meaning is brought."""
SMOOTHED = 0.05
"""The share of each label that is spread over all kinds: some labels can be argued about."""
FOLDS = 5


def fitted(questions: Sequence[Asked], meanings: Array) -> Listener:
    """The weights under which the kinds are likeliest, by gradient descent over all questions.

    source: Kingma and Ba, Adam: A Method for Stochastic Optimization, 2015
    """
    runs = _Runs([rows_of(each.said, each.shape) for each in questions])
    centre, spread = meanings.mean(axis=0), meanings.std(axis=0) + 1e-6
    brought = (meanings - centre) / spread * np.float32(SPREAD)
    target = np.full((len(questions), len(KINDS)), SMOOTHED / len(KINDS), np.float32)
    target[np.arange(len(questions)), [KINDS.index(each.kind) for each in questions]] += (
        1 - SMOOTHED
    )
    weights = {
        "table": np.zeros((len(runs.known), len(KINDS)), np.float32),
        "meaning": np.zeros((meanings.shape[1], len(KINDS)), np.float32),
    }
    moments = {name: (np.zeros_like(each), np.zeros_like(each)) for name, each in weights.items()}
    for step in range(1, STEPS + 1):
        scores = runs.summed(weights["table"]) + brought @ weights["meaning"]
        chances = np.exp(scores - scores.max(axis=1, keepdims=True))
        chances /= chances.sum(axis=1, keepdims=True)
        wrong = (chances - target) / len(questions)
        slopes = {"table": runs.spread_out(wrong), "meaning": brought.T @ wrong}
        for name, slope in slopes.items():
            change = slope + SHRINKAGE[name] * weights[name]
            mean, square = moments[name]
            mean += 0.1 * (change - mean)
            square += 0.01 * (change * change - square)
            stride = PACE[name] * (1 - step / (STEPS + 1)) / (1 - 0.9**step)
            weights[name] -= stride * mean / (np.sqrt(square / (1 - 0.99**step)) + 1e-8)
    table = np.zeros((ROWS, len(KINDS)), np.float32)
    table[runs.known] = weights["table"]
    meaning = weights["meaning"] * np.float32(SPREAD) / spread[:, None]
    return Listener(table, meaning, -centre @ meaning)


class _Runs:
    """Which rows of the table each question adds up, as arrays that numpy sums quickly."""

    def __init__(self, rows: Sequence[Sequence[int]]) -> None:
        sizes = [len(each) for each in rows]
        self.known, self._flat = np.unique(np.concatenate(rows).astype(int), return_inverse=True)
        self._starts = np.concatenate([[0], np.cumsum(sizes)[:-1]])
        self._order = np.argsort(self._flat, kind="stable")
        self._owner = np.repeat(np.arange(len(rows)), sizes)[self._order]
        self._edges = np.concatenate([[0], np.flatnonzero(np.diff(self._flat[self._order])) + 1])

    def summed(self, table: Array) -> Array:
        found: Array = np.add.reduceat(table[self._flat], self._starts, axis=0)
        return found

    def spread_out(self, wrong: Array) -> Array:
        """How much the rows of the questions that have a run are wrong, for each run."""
        found: Array = np.add.reduceat(wrong[self._owner], self._edges, axis=0)
        return found


def pack(found: Listener, path: Path) -> None:
    """Store weights as `listener.unpacked` reads them."""
    scale = np.abs(found.table).max(axis=0) / 127
    np.savez_compressed(
        path,
        table=np.round(found.table / scale).clip(-127, 127).astype(np.int8),
        scale=scale.astype(np.float32),
        meaning=found.meaning.astype(np.float16),
        bias=found.bias.astype(np.float32),
    )


def held_out(own: Sequence[Asked], others: Sequence[Asked]) -> list[dict[Kind, float]]:
    """What a listener makes of each question that has seen none of its mission."""
    meanings = np.stack([meaning_of(each.said) for each in (*own, *others)])
    missions = sorted({each.mission for each in own})
    found: dict[int, dict[Kind, float]] = {}
    for fold in range(FOLDS):
        held = set(missions[fold::FOLDS])
        kept = [i for i, each in enumerate((*own, *others)) if each.mission not in held]
        heard = fitted([(*own, *others)[i] for i in kept], meanings[kept])
        found |= {
            i: heard.hear(each.said, each.shape)
            for i, each in enumerate(own)
            if each.mission in held
        }
    return [found[i] for i in range(len(own))]


def report(own: Sequence[Asked], others: Sequence[Asked]) -> None:
    """Print how many kinds are right on missions held out, by rules, listener, and both."""
    heard = held_out(own, others)
    ruled = [ruled_kind(each.text, each.lexicon) for each in own]
    both = [settled(rule, chances) for rule, chances in zip(ruled, heard, strict=True)]
    print("| kind | of | rules | listener | both |\n| --- | ---: | ---: | ---: | ---: |")
    for kind in (*KINDS, None):
        at = [i for i, each in enumerate(own) if kind in (None, each.kind)]
        right = [
            sum(ruled[i] is own[i].kind for i in at),
            sum(max(heard[i], key=heard[i].__getitem__) is own[i].kind for i in at),
            sum(both[i].kind is own[i].kind for i in at),
        ]
        shares = " | ".join(f"{100 * each / len(at):.1f}%" for each in right)
        print(f"| {kind or 'all'} | {len(at)} | {shares} |")
    for low, high in ((0.0, 0.2), (0.2, 0.3), (0.3, 0.4), (0.4, 0.6), (0.6, 0.8), (0.8, 1.01)):
        at = [i for i, each in enumerate(both) if low <= each.chance < high]
        right_now = sum(both[i].kind is own[i].kind for i in at)
        print(f"chance {low:.1f} to {min(high, 1.0):.1f}: {right_now} of {len(at)} right")


def main() -> None:
    """Fit, and store the weights or print what they are worth."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=ROOT / "src/plainspoken/questions/listener.npz")
    parser.add_argument("--held-out", action="store_true", help="print what it is worth")
    asked = parser.parse_args()
    own, others = list(written()), list(judged())
    if asked.held_out:
        report(own, others)
        return
    every = [*own, *others]
    pack(fitted(every, np.stack([meaning_of(each.said) for each in every])), asked.out)
    print(f"wrote {asked.out}, {asked.out.stat().st_size / 1e3:.0f} kB, {len(every)} questions")


if __name__ == "__main__":
    main()
