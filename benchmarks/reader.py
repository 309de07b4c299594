"""What the learned reader is worth beside the rules, on domains that it was not trained on.

    python benchmarks/reader.py                     the domains held out of training
    python benchmarks/reader.py FOLDER ...          other corpora: landmarks and sentences.jsonl
    python benchmarks/reader.py --write             fit `language.agreement`, too

Prints the accuracy of the rules alone, of the network alone, and of both as they are used; the
weights of `agreement.likelihood`, fitted on half of the domains; and on the other half how true
its probabilities come. A reading is right when its literal formula is equivalent to the corpus's.
"""

import json
import re
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median

from confidence import Row, fitted, reliability

ROOT = Path(__file__).resolve().parents[1]
MODULE = ROOT / "src" / "plainspoken" / "language" / "agreement.py"
HELD_OUT = (
    "places/museum", "operators/construction", "colloquial/hotel", "farms-and-wards/dairy",
    "crowd/campus", "spoken/care-home",
)  # fmt: skip
"""The same as in training/train.py; a test holds the two together."""


@dataclass(frozen=True)
class Judged:
    """One sentence: what each made of it. features: of the likelihood; None where none is asked."""

    domain: str
    rules: bool
    network: bool
    both: str
    features: dict[str, float] | None
    seconds: float


def corpora() -> Iterator[tuple[str, Path, str | None]]:
    for name in HELD_OUT:
        folder, domain = name.split("/")
        yield name, ROOT / "training" / "corpus" / folder, domain
    yield "library", ROOT / "benchmarks" / "corpora" / "library", None


def judged(name: str, folder: Path, domain: str | None) -> Iterator[Judged]:
    from plainspoken.language.agreement import evidence, same
    from plainspoken.language.extracted import Reading, Status
    from plainspoken.language.extraction import by_rules, extract
    from plainspoken.language.grounding import Vocabulary
    from plainspoken.language.learned import learned
    from plainspoken.language.sentence import Sentence
    from plainspoken.logic.syntax import parse
    from plainspoken.world.landmark import read_landmarks

    known: dict[str | None, Vocabulary] = {}
    for line in (folder / "sentences.jsonl").read_text(encoding="utf-8").splitlines():
        row = json.loads(line)
        if domain not in (None, row.get("domain")):
            continue
        of = row.get("domain")
        if of not in known:
            file = folder / (f"landmarks-{of}.json" if of else "landmarks.json")
            known[of] = Vocabulary.of(read_landmarks(file))
        literal = parse(row["literal"])
        gold = Reading(literal, literal, "", 1.0)
        sentence = Sentence.of(row["utterance"], known[of])
        ruled, heard = by_rules(sentence), learned(sentence)
        started = time.perf_counter()
        found = extract(row["utterance"], known[of])
        seconds = time.perf_counter() - started
        right = found.reading is not None and same(found.reading, gold)
        agreed = heard.reading is not None and ruled.reading is not None
        agreed = agreed and same(heard.reading, ruled.reading)
        yield Judged(
            name,
            ruled.status is Status.OK and same(ruled.reading, gold),
            heard.reading is not None and same(heard.reading, gold),
            "right" if right and found.status is Status.OK
            else "wrong" if found.status is Status.OK
            else "asked, rightly" if any(same(each, gold) for each in found.alternatives)
            else str(found.status),
            evidence(heard, ruled, agreed=agreed) if heard.reading is not None else None,
            seconds,
        )  # fmt: skip


def table(rows: Sequence[Judged]) -> None:
    print(
        "| domain | sentences | rules | network | both | wrong | asked, and the meaning among it |"
    )
    print("| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    for name in (*dict.fromkeys(each.domain for each in rows), "all"):
        mine = [each for each in rows if name in (each.domain, "all")]
        counts = (
            sum(each.rules for each in mine),
            sum(each.network for each in mine),
            *(
                sum(each.both == how for each in mine)
                for how in ("right", "wrong", "asked, rightly")
            ),
        )
        shares = " | ".join(f"{100 * count / len(mine):.1f}%" for count in counts)
        print(f"| {name} | {len(mine)} | {shares} |")
    print(f"\nmedian {1000 * median(each.seconds for each in rows):.1f} ms a sentence")


def main() -> None:
    named = [Path(each) for each in sys.argv[1:] if not each.startswith("-")]
    places = [(each.name, each, None) for each in named] or list(corpora())
    rows = [each for place in places for each in judged(*place)]
    table(rows)
    told = [each for each in rows if each.features is not None]
    names = tuple(told[0].features or ())
    domains = sorted({each.domain for each in told})
    data = [
        (each.domain, Row("", tuple((each.features or {}).values()), each.network))
        for each in told
    ]  # fmt: skip
    half = set(domains[::2])
    weights = fitted([row for domain, row in data if domain in half])
    rest = [row for domain, row in data if domain not in half] or [row for _, row in data]
    print(f"\nfitted on {sorted(half)}, judged on the rest:")
    error = reliability(rest, weights)
    print(f"expected calibration error {error:.3f}")
    final = {
        name: round(weight, 3)
        for name, weight in zip(names, fitted([row for _, row in data]), strict=True)
    }
    print(f"fitted on all: {final}")
    if "--write" in sys.argv:
        lines = "".join(f'    "{name}": {weight},\n' for name, weight in final.items())
        block = f"WEIGHTS = {{\n{lines}}}\n"
        text = re.sub(r"WEIGHTS = \{.*?\}\n", block, MODULE.read_text(), flags=re.DOTALL)
        MODULE.write_text(text)


if __name__ == "__main__":
    main()
