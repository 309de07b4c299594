"""How fast extraction is: median, p95, the first sentence, memory, and large vocabularies.

    python benchmarks/extraction_speed.py [EXAMPLE ...]

Times are CPU time. The first sentence is timed in a process of its own, with all that has to be
loaded before it.
Memory is measured behind 500 sentences and behind 5,000: it must not grow with what was said.
"""

from __future__ import annotations

import resource
import statistics
import subprocess
import sys
import time
from collections.abc import Sequence
from itertools import cycle, islice
from pathlib import Path

from plainspoken.evaluation.corpus import read_corpus
from plainspoken.evaluation.metric import percentile
from plainspoken.language.extraction import extract
from plainspoken.language.grounding import Vocabulary
from plainspoken.world.landmark import Landmark, Landmarks, LandmarkType, read_landmarks

EXAMPLES = Path(__file__).parents[1] / "examples"
SIZES = (50, 300, 500, 2000)
FEW, MANY = 500, 5000
FIRST = """
import sys, time
from plainspoken.language.extraction import extract
from plainspoken.language.grounding import Vocabulary
from plainspoken.world.landmark import read_landmarks
vocabulary = Vocabulary.of(read_landmarks(sys.argv[1]))
extract(sys.argv[2], vocabulary)
print(time.process_time())  # since process start
"""
STATES = ("open", "clean", "locked", "busy", "full")
ACTS = ("sweep", "inspect", "paint", "repair", "measure")


def megabytes() -> float:
    """The most memory that this process has had."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def large(size: int) -> Landmarks:
    """A made-up domain: numbered sites, what is so of each, and what is done to each."""
    found: dict[str, Landmark] = {}
    number = 0
    while len(found) < size:
        site = f"site {number}"
        found[f"at_{number}"] = Landmark(f"at_{number}", site, LandmarkType.LOCATION)
        state, act = STATES[number % 5], ACTS[number % 5]
        found[f"is_{number}"] = Landmark(
            f"is_{number}", f"{site} is {state}", LandmarkType.CONDITION
        )
        found[f"do_{number}"] = Landmark(f"do_{number}", f"to {act} {site}", LandmarkType.ACTION)
        number += 1
    return dict(islice(found.items(), size))


def spoken_of_sites() -> list[str]:
    """Sentences for the made-up domain, some with words that it does not have."""
    return [
        "Go to site 3 and then to site 7.",
        "Never enter site 2 while site 1 is locked.",
        "As soon as site 0 is open, sweep site 5.",
        "Visit sites 4, 5 and 6 in any order, but site 5 before site 6.",
        "Inspect site 1 after painting site 2.",
        "If the harbour is full, go to site 1.",
        "Wait at site 8 until site 3 is busy.",
    ]


def timed(sentences: Sequence[str], vocabulary: Vocabulary) -> list[float]:
    """The milliseconds of CPU time that each takes."""
    extract(sentences[0], vocabulary)
    found = []
    for sentence in sentences:
        started = time.process_time()
        extract(sentence, vocabulary)
        found.append(1000 * (time.process_time() - started))
    return found


def row(name: str, milliseconds: Sequence[float]) -> None:
    p95, p99 = (percentile(milliseconds, each) or 0.0 for each in (95, 99))
    print(
        f"| {name} | {len(milliseconds)} | {statistics.median(milliseconds):.1f} | {p95:.1f} "
        f"| {p99:.1f} | {max(milliseconds):.1f} |",
        flush=True,
    )


def first_sentence(landmarks: Path, sentence: str, times: int = 5) -> float:
    """Seconds of CPU time until the first answer, in a fresh process: the median of some."""
    taken = [
        float(
            subprocess.run(
                [sys.executable, "-c", FIRST, str(landmarks), sentence],
                check=True,
                capture_output=True,
                text=True,
            ).stdout
        )
        for _ in range(times)
    ]
    return statistics.median(taken)


def main(names: Sequence[str]) -> None:
    print("| vocabulary | sentences | median ms | p95 | p99 | slowest |")
    print("| --- | ---: | ---: | ---: | ---: | ---: |")
    for name in names:
        landmarks = read_landmarks(EXAMPLES / name / "landmarks.json")
        rows = read_corpus(EXAMPLES / name / "sentences.jsonl", landmarks)
        row(name, timed([each.utterance for each in rows], Vocabulary.of(landmarks)))
    for size in SIZES:
        started = time.process_time()
        vocabulary = Vocabulary.of(large(size))
        compiled = time.process_time() - started
        sentences = list(islice(cycle(spoken_of_sites()), 70))
        row(f"{size} landmarks, compiled in {compiled:.2f} s", timed(sentences, vocabulary))
    one = EXAMPLES / names[0] / "landmarks.json"
    known = first_sentence(one, "Never sign anything.")
    unknown = first_sentence(one, "Go to the depository, please.")
    print(f"\nfirst sentence with loading: {known:.2f} s; with a word to look up: {unknown:.2f} s")
    landmarks = read_landmarks(one)
    rows = read_corpus(one.with_name("sentences.jsonl"), landmarks)
    vocabulary = Vocabulary.of(landmarks)
    said = cycle([each.utterance for each in rows])
    for sentence in islice(said, FEW):
        extract(sentence, vocabulary)
    few = megabytes()
    for sentence in islice(said, MANY - FEW):
        extract(sentence, vocabulary)
    print(f"memory: {few:.0f} MB after {FEW} sentences, {megabytes():.0f} MB after {MANY}")


if __name__ == "__main__":
    main(sys.argv[1:] or ["vineyard", "warehouse", "kitchen"])
