"""Fit the listener of questions: python -m training.questions. See README.md beside this.

    python -m training.questions              # on all questions, into the package
    python -m training.questions --held-out   # what it is worth on domains that it has not seen
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import numpy.typing as npt
from training.asked import ROOT, Asked, judged, written

from plainspoken.questions.listener import KINDS, ROWS, Listener, rows_of

Table = npt.NDArray[np.float32]
STEPS = 60
RATE = 0.05
SHRINKAGE = 1e-4
"""How much a large weight costs; of several tried on domains held out."""
SMOOTHED = 0.05
"""The share of each label that is spread over all kinds: some labels can be argued about."""


def fitted(questions: Sequence[Asked], steps: int = STEPS, shrinkage: float = SHRINKAGE) -> Table:
    """The weights under which the kinds are likeliest, by gradient descent (Adam) over all."""
    rows = [rows_of(each.said, each.shape) for each in questions]
    flat = np.concatenate([np.array(each) for each in rows])
    known, flat = np.unique(flat, return_inverse=True)
    owner = np.repeat(np.arange(len(rows)), [len(each) for each in rows])
    starts = np.concatenate([[0], np.cumsum([len(each) for each in rows])[:-1]])
    order = np.argsort(flat, kind="stable")
    edges = np.concatenate([[0], np.flatnonzero(np.diff(flat[order])) + 1])
    target = np.full((len(rows), len(KINDS)), SMOOTHED / len(KINDS), np.float32)
    target[np.arange(len(rows)), [KINDS.index(each.kind) for each in questions]] += 1 - SMOOTHED
    weights = np.zeros((len(known), len(KINDS)), np.float32)
    mean, spread = np.zeros_like(weights), np.zeros_like(weights)
    for step in range(1, steps + 1):
        scores = np.add.reduceat(weights[flat], starts, axis=0)
        chances = np.exp(scores - scores.max(axis=1, keepdims=True))
        chances /= chances.sum(axis=1, keepdims=True)
        wrong = (chances - target) / len(rows)
        slope = np.add.reduceat(wrong[owner[order]], edges, axis=0) + shrinkage * weights
        mean = 0.9 * mean + 0.1 * slope
        spread = 0.99 * spread + 0.01 * slope * slope
        pace = RATE * (1 - step / (steps + 1))
        weights -= pace * (mean / (1 - 0.9**step)) / (np.sqrt(spread / (1 - 0.99**step)) + 1e-8)
    table = np.zeros((ROWS, len(KINDS)), np.float32)
    table[known] = weights
    return table


def pack(table: Table, path: Path) -> None:
    """Store weights as `listener.unpacked` reads them: 8 bits, a scale for each kind."""
    scale = np.abs(table).max(axis=0) / 127
    weights = np.round(table / scale).clip(-127, 127).astype(np.int8)
    np.savez_compressed(path, weights=weights, scale=scale.astype(np.float32))


def main() -> None:
    """Fit, and store the weights or print what they are worth."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--out", type=Path, default=ROOT / "src/plainspoken/questions/listener.npz"
    )
    parser.add_argument("--held-out", action="store_true", help="print what it is worth")
    asked = parser.parse_args()
    own, others = list(written()), list(judged())
    if asked.held_out:
        report(own, others)
        return
    pack(fitted([*own, *others]), asked.out)
    print(f"wrote {asked.out}, {asked.out.stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    main()
