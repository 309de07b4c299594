"""Fit the weights of `plainspoken.language.confidence`, and measure how true they come.

    python benchmarks/confidence.py                   examples/ and benchmarks/corpora/ but one
    python benchmarks/confidence.py FOLDER ...        other corpora: landmarks.json, sentences.jsonl
    python benchmarks/confidence.py --write           put the weights into the module, too

`library` and `first-sight-*` are left out: they are for measuring what nobody has worked on.

Every third sentence, by a hash of its words, is held out of the fit; the reliability table and the
expected calibration error are of those. What is rated is whether an accepted sentence has the
formula of the corpus.
"""

import hashlib
import math
import re
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
MODULE = ROOT / "src" / "plainspoken" / "language" / "confidence.py"
HELD_OUT = ("library", "first-sight")
BINS = 10
RIDGE = 1.0
ROUNDS = 30


@dataclass(frozen=True)
class Row:
    """A sentence that was accepted: its features, and whether rightly so."""

    utterance: str
    features: tuple[float, ...]
    right: bool

    @property
    def held_out(self) -> bool:
        return hashlib.sha256(self.utterance.encode()).digest()[0] % 3 == 0


def rows_of(folder: Path) -> Iterator[tuple[dict[str, float], str, bool]]:
    from plainspoken.automata.equivalence import equivalent
    from plainspoken.evaluation.corpus import read_corpus
    from plainspoken.language.confidence import features
    from plainspoken.language.contradiction import contradiction
    from plainspoken.language.extracted import literal_of
    from plainspoken.language.grounding import Vocabulary
    from plainspoken.language.refusal import aimless, idle, not_understood, unfinished
    from plainspoken.language.sentence import Sentence
    from plainspoken.world.landmark import read_landmarks

    named = folder / "landmarks.json"
    landmarks = read_landmarks(named) if named.exists() else None
    corpus = folder / "sentences.jsonl" if folder.is_dir() else folder
    known: dict[tuple[object, ...], Vocabulary] = {}
    for row in read_corpus(corpus, landmarks):
        of = {each.id: each for each in row.landmarks}
        vocabulary = known.setdefault(tuple(of.values()), Vocabulary.of(of))
        sentence = Sentence.of(row.utterance, vocabulary)
        if not_understood(sentence):
            continue
        sentence = sentence.parsed()
        meaning = sentence.meaning()
        refused = idle(meaning, row.utterance) or aimless(meaning) or unfinished(sentence.clauses)
        if refused or contradiction(sentence, meaning):
            continue
        right = equivalent(literal_of(meaning.patterns), row.literal)
        yield dict(features(sentence, meaning)), row.utterance, right


def fitted(rows: Sequence[Row]) -> tuple[float, ...]:
    """Weights of a logistic regression with a ridge, by Newton's method."""
    size = len(rows[0].features)
    weights = [0.0] * size
    for _ in range(ROUNDS):
        slope = [-RIDGE * w if i else 0.0 for i, w in enumerate(weights)]
        bend = [[RIDGE * (i == j and i > 0) for j in range(size)] for i in range(size)]
        for row in rows:
            p = rated(row, weights)
            for i, x in enumerate(row.features):
                slope[i] += (row.right - p) * x
                for j, y in enumerate(row.features):
                    bend[i][j] += p * (1 - p) * x * y
        for i in range(size):
            bend[i][i] += 1e-9
        weights = [w + step for w, step in zip(weights, solved(bend, slope), strict=True)]
    return tuple(weights)


def solved(matrix: list[list[float]], right: list[float]) -> list[float]:
    """Gauss, with the largest pivot."""
    rows = [[*line, value] for line, value in zip(matrix, right, strict=True)]
    for i in range(len(rows)):
        best = max(range(i, len(rows)), key=lambda k: abs(rows[k][i]))
        rows[i], rows[best] = rows[best], rows[i]
        for k in range(len(rows)):
            if k != i:
                factor = rows[k][i] / rows[i][i]
                rows[k] = [a - factor * b for a, b in zip(rows[k], rows[i], strict=True)]
    return [line[-1] / line[i] for i, line in enumerate(rows)]


def rated(row: Row, weights: Sequence[float]) -> float:
    total = sum(w * x for w, x in zip(weights, row.features, strict=True))
    return 1 / (1 + math.exp(-max(-30.0, min(30.0, total))))


def reliability(rows: Sequence[Row], weights: Sequence[float]) -> float:
    """Print what was promised and what came true, and return the expected calibration error."""
    error = 0.0
    print(f"{'confidence':>12} {'sentences':>9} {'promised':>9} {'right':>7}")
    for number in range(BINS):
        inside = [r for r in rows if min(int(rated(r, weights) * BINS), BINS - 1) == number]
        if not inside:
            continue
        promised = sum(rated(r, weights) for r in inside) / len(inside)
        right = sum(r.right for r in inside) / len(inside)
        error += len(inside) / len(rows) * abs(promised - right)
        low, high = number / BINS, (number + 1) / BINS
        print(f"{low:6.1f}-{high:.1f}   {len(inside):9d} {promised:9.3f} {right:7.3f}")
    return error


def main() -> None:
    arguments = [each for each in sys.argv[1:] if not each.startswith("-")]
    folders = [Path(each) for each in arguments] or sorted(
        each.parent
        for folder in ("examples", "benchmarks/corpora")
        for each in (ROOT / folder).glob("*/sentences.jsonl")
        if not each.parent.name.startswith(HELD_OUT)
    )
    found = [each for folder in folders for each in rows_of(folder)]
    names = tuple(found[0][0])
    rows = [Row(text, tuple(named.values()), right) for named, text, right in found]
    kept = [row for row in rows if not row.held_out]
    held = [row for row in rows if row.held_out]
    weights = tuple(round(weight, 3) for weight in fitted(kept))
    print(f"{len(kept)} sentences to fit, {len(held)} held out; weights:")
    table = "".join(f'    "{n}": {w},\n' for n, w in zip(names, weights, strict=True))
    print(table)
    error = reliability(held, weights)
    brier = sum((rated(r, weights) - r.right) ** 2 for r in held) / len(held)
    print(f"expected calibration error {error:.3f}, Brier score {brier:.3f} (held out)")
    for least in (0.2, 0.3, 0.4, 0.5, 0.6):
        asked = [r for r in held if rated(r, weights) < least]
        wrong = sum(not r.right for r in asked)
        print(f"below {least}: {len(asked)} of {len(held)} asked, {wrong} of them wrong")
    if "--write" in sys.argv:
        text = MODULE.read_text()
        block = f"WEIGHTS: Features = {{\n{table}}}\n"
        MODULE.write_text(re.sub(r"WEIGHTS: Features = \{.*?\}\n", block, text, flags=re.DOTALL))


if __name__ == "__main__":
    main()
