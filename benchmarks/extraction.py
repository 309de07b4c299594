"""How many sentences of a file become the formula that they should, by equivalence on all traces.

    python benchmarks/extraction.py examples/vineyard/landmarks.json SENTENCES.jsonl [--failures]

A line of the file holds "id", "utterance" and the gold "literal" and "formula". --failures lists
the sentences that went wrong; without it a held-out file stays unread.
"""

import json
import statistics
import sys
import time
from collections import Counter
from pathlib import Path

from plainspoken.automata.equivalence import equivalent
from plainspoken.language.extraction import extract
from plainspoken.language.grounding import Vocabulary
from plainspoken.logic.syntax import parse, unparse
from plainspoken.world.landmark import read_landmarks


def main() -> None:
    landmarks, sentences = (Path(argument) for argument in sys.argv[1:3])
    vocabulary = Vocabulary.of(read_landmarks(landmarks))
    right: Counter[str] = Counter()
    status: Counter[str] = Counter()
    seconds = []
    rows = [json.loads(line) for line in sentences.read_text().splitlines() if line.strip()]
    for row in rows:
        started = time.perf_counter()
        extraction = extract(row["utterance"], vocabulary)
        seconds.append(time.perf_counter() - started)
        status[extraction.status] += 1
        reading = extraction.reading if extraction.formula is not None else None
        wrong = []
        for kind in ("literal", "formula"):
            if reading is not None and equivalent(getattr(reading, kind), parse(row[kind])):
                right[kind] += 1
            else:
                wrong.append(kind)
        if wrong and "--failures" in sys.argv:
            print(f"{row['id']}: {row['utterance']}")
            print(f"  gold {row['literal']}")
            said = unparse(reading.literal) if reading else extraction.reason or extraction.question
            print(f"  got  {said}   ({', '.join(wrong)})")
    total = len(rows)
    for kind in ("literal", "formula"):
        print(f"{kind:8} {right[kind]:4} of {total}  {right[kind] / total:.1%}")
    print("status  ", ", ".join(f"{kind} {number}" for kind, number in sorted(status.items())))
    print(f"median   {statistics.median(seconds) * 1000:.1f} ms a sentence")


if __name__ == "__main__":
    main()
