"""Word errors of speech recognition on sentences of the bundled domains, with noise.

    python benchmarks/word_error.py [--rows FILE.jsonl] [--each 22] [--folder WEIGHTS] [--markdown]

Of each bundled domain, sentences of examples/*/sentences.jsonl with a weighty word (a negation, a
limit or a number), evenly spaced. espeak-ng says each in one of eight voices and one of three
speeds, in turn; pink noise is added at several ratios of speech to noise. Whisper hears each twice:
told the domain's words, and not. Needs the extra [speech], its weights and espeak-ng. Rows are kept
in FILE, so that a run which was interrupted goes on, and printed at the end.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from plainspoken.backends.espeak import Espeak
from plainspoken.backends.whisper import Whisper
from plainspoken.language.emphasis import Weight, emphases
from plainspoken.language.extraction import Status, extract
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.hint import hints
from plainspoken.language.recording import read_wav
from plainspoken.language.transcription import SAMPLE_RATE, Samples, Transcript
from plainspoken.language.word import words
from plainspoken.pipeline import bundled
from plainspoken.world.landmark import read_landmarks

DOMAINS = ("vineyard", "kitchen", "warehouse")
VOICES = (
    "en-gb",
    "en-us",
    "en-gb-scotland",
    "en-us+f3",
    "en-gb-x-rp",
    "en-gb+f2",
    "en-029",
    "en-us+m3",
)
SPEEDS = (140, 160, 180)
RATIOS: tuple[int | None, ...] = (None, 20, 10)
LONGEST = 90
Key = tuple[str, int | None, bool]


def sentences(domain: str, each: int) -> list[str]:
    lines = (bundled(domain) / "sentences.jsonl").read_text().splitlines()
    said = [json.loads(line)["utterance"] for line in lines]
    weighty = [text for text in said if emphases(text) and len(text) <= LONGEST]
    return [weighty[i * len(weighty) // each] for i in range(each)]


def noisy(samples: Samples, ratio: int | None, seed: int) -> Samples:
    """The samples with half a second before and after, in noise that is as loud throughout."""
    padded = np.pad(samples, SAMPLE_RATE // 2)
    if ratio is None:
        return padded
    spectrum = np.fft.rfft(np.random.default_rng(seed).standard_normal(len(padded)))
    spectrum /= np.sqrt(np.maximum(np.arange(len(spectrum)), 1))  # pink: engines, wind, people
    noise = np.fft.irfft(spectrum, len(padded))
    power = float(np.mean(samples**2)) / 10 ** (ratio / 10)
    noise *= np.sqrt(power / np.mean(noise**2))
    return np.clip(padded + noise, -1, 1).astype(np.float32)


def said_in(text: str) -> list[str]:
    """The words of a text as they are compared: lower case, numbers in digits, no punctuation."""
    return [word.number for word in words(text) if not word.is_mark]


def aligned(said: Sequence[str], heard: Sequence[str]) -> list[tuple[int | None, int | None]]:
    """The cheapest pairing of two texts' words; None where one has nothing for the other's."""
    cost = np.zeros((len(said) + 1, len(heard) + 1), int)
    cost[:, 0], cost[0, :] = range(len(said) + 1), range(len(heard) + 1)
    for i, one in enumerate(said, start=1):
        for j, other in enumerate(heard, start=1):
            same = cost[i - 1, j - 1] + (one != other)
            cost[i, j] = min(same, cost[i - 1, j] + 1, cost[i, j - 1] + 1)
    pairs: list[tuple[int | None, int | None]] = []
    i, j = len(said), len(heard)
    while i or j:
        if i and j and cost[i, j] == cost[i - 1, j - 1] + (said[i - 1] != heard[j - 1]):
            i, j = i - 1, j - 1
            pairs.append((i, j))
        elif i and cost[i, j] == cost[i - 1, j] + 1:
            i -= 1
            pairs.append((i, None))
        else:
            j -= 1
            pairs.append((None, j))
    return pairs[::-1]


def compared(sentence: str, heard: Transcript, vocabulary: Vocabulary) -> dict[str, Any]:
    """What was lost, what of that is marked, and what became of the formula."""
    said, got = said_in(sentence), said_in(heard.text)
    pairs = aligned(said, got)
    weighty = [bool(emphases(word)) for word in said]
    marked = _marked(heard)
    unclear = [Weight.UNCLEAR in weights for weights in marked]
    wrong = [(i, j) for i, j in pairs if i is None or j is None or said[i] != got[j]]
    lost = [(i, j) for i, j in wrong if i is not None and weighty[i]]
    errors_heard = {j for _, j in wrong if j is not None}
    before, after = extract(sentence, vocabulary), extract(heard.text, vocabulary)
    outcome = "not compared"
    if before.status is Status.OK:
        same = after.status is Status.OK and after.formula == before.formula
        outcome = "same" if same else "other" if after.status is Status.OK else "asked"
    return {
        "words": len(said),
        "errors": len(wrong),
        "weighty": sum(weighty),
        "lost": len(lost),
        "lost_unmarked": sum(not _has_lead(pairs, pair, marked) for pair in lost),
        "wrong_heard": len(errors_heard),
        "wrong_unclear": sum(unclear[j] for j in errors_heard),
        "right_unclear": sum(unclear) - sum(unclear[j] for j in errors_heard),
        "right_heard": len(got) - len(errors_heard),
        "outcome": outcome,
        "any_unclear": any(unclear),
        "confidences": _confidences(heard, [j not in errors_heard for j in range(len(got))]),
    }


def _marked(heard: Transcript) -> list[set[Weight]]:
    """The marks of each word that `said_in` gives of a transcript."""
    found = [word for word in words(heard.text) if not word.is_mark]
    return [
        {e.weight for e in heard.emphases if e.start < word.end and word.start < e.end}
        for word in found
    ]


def _confidences(heard: Transcript, right: list[bool]) -> list[tuple[str, float, bool]]:
    """Each word of a transcript with its confidence, and whether it was said."""
    found, place = [], 0
    for word in heard.words:
        parts = len(said_in(word.text))
        if parts:
            found.append((word.text, round(word.confidence, 3), all(right[place : place + parts])))
        place += parts
    return found


def _has_lead(
    pairs: list[tuple[int | None, int | None]],
    pair: tuple[int | None, int | None],
    marked: list[set[Weight]],
) -> bool:
    """Whether the eye is led to where a word was lost: a word there or beside it is marked."""
    place = pairs.index(pair)
    near = pairs[max(place - 1, 0) : place + 2]
    return any(marked[j] for _, j in near if j is not None)


def measured(model: Whisper, each: int, done: set[Key]) -> Iterator[dict[str, Any]]:
    """A row for each recording that is not done, all without noise first."""
    for ratio in RATIOS:
        number = 0
        for domain in DOMAINS:
            vocabulary = Vocabulary.of(read_landmarks(bundled(domain) / "landmarks.json"))
            told = hints(vocabulary)
            for sentence in sentences(domain, each):
                number += 1
                voice = Espeak(VOICES[number % len(VOICES)], SPEEDS[number % len(SPEEDS)])
                open_still = [p for p in (False, True) if (sentence, ratio, p) not in done]
                if not open_still:
                    continue
                samples = noisy(read_wav(voice.recorded(sentence)), ratio, number)
                for prompted in open_still:
                    started = time.process_time()
                    heard = model(samples, told if prompted else ())
                    seconds = time.process_time() - started
                    yield {
                        "domain": domain,
                        "sentence": sentence,
                        "heard": heard.text,
                        "voice": f"{voice.voice} {voice.speed}",
                        "ratio": ratio,
                        "prompted": prompted,
                        "seconds": heard.seconds,
                        "cpu": seconds,
                        **compared(sentence, heard, vocabulary),
                    }


def table(rows: Sequence[dict[str, Any]]) -> list[list[str]]:
    head = ["noise", "told the words", "word errors", "weighty lost", "with nothing marked there",
            "same formula", "asked or refused", "another formula", "with nothing unclear",
            "CPU s a second"]  # fmt: skip
    found = [head]
    for ratio in RATIOS:
        for prompted in (False, True):
            part = [r for r in rows if r["ratio"] == ratio and r["prompted"] is prompted]
            if not part:
                continue
            total = {name: sum(r[name] for r in part) for name in SUMS}
            rated = [r for r in part if r["outcome"] != "not compared"]
            counts = [
                sum(r["outcome"] == kind for r in rated) for kind in ("same", "asked", "other")
            ]
            silent = sum(r["outcome"] == "other" and not r["any_unclear"] for r in rated)
            found.append([
                "none" if ratio is None else f"{ratio} dB",
                "yes" if prompted else "no",
                f"{total['errors'] / total['words']:.1%}",
                f"{total['lost']} of {total['weighty']}",
                str(total["lost_unmarked"]),
                *(f"{count} of {len(rated)}" for count in counts),
                str(silent),
                f"{total['cpu'] / total['seconds']:.2f}",
            ])  # fmt: skip
    return found


SUMS = ("words", "errors", "weighty", "lost", "lost_unmarked", "cpu", "seconds",
        "wrong_heard", "wrong_unclear", "right_unclear", "right_heard")  # fmt: skip


def marks(rows: Sequence[dict[str, Any]]) -> str:
    """How well the mark for unclear words tells wrong ones from right ones, told the words."""
    part = [r for r in rows if r["prompted"]]
    total = {name: sum(r[name] for r in part) for name in SUMS}
    whole = [r["any_unclear"] for r in part if not r["errors"]]
    return (
        f"Told the words, {total['wrong_unclear']} of {total['wrong_heard']} words heard wrong are "
        f"marked as unclear, and {total['right_unclear']} of {total['right_heard']} heard right: "
        f"{sum(whole)} of {len(whole)} texts without any error have such a mark, too."
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rows", type=Path, help="kept here, and gone on from")
    parser.add_argument("--each", type=int, default=22, help="sentences of each domain")
    parser.add_argument("--folder", type=Path, help="weights other than the packages'")
    parser.add_argument("--markdown", action="store_true", help="for docs/results.md")
    chosen = parser.parse_args()
    rows: list[dict[str, Any]] = []
    if chosen.rows and chosen.rows.exists():
        rows = [json.loads(line) for line in chosen.rows.read_text().splitlines()]
    done: set[Key] = {(r["sentence"], r["ratio"], r["prompted"]) for r in rows}
    for row in measured(Whisper(chosen.folder), chosen.each, done):
        rows.append(row)
        if chosen.rows:
            with chosen.rows.open("a") as file:
                file.write(json.dumps(row, ensure_ascii=False) + "\n")
        print(f"\r{len(rows)}", end="", file=sys.stderr, flush=True)
    found = table(rows)
    if chosen.markdown:
        print(*(f"| {' | '.join(line)} |" for line in found[:1]), sep="\n")
        print(f"|{' --- |' * len(found[0])}")
        print(*(f"| {' | '.join(line)} |" for line in found[1:]), sep="\n")
    else:
        widths = [max(map(len, column)) for column in zip(*found, strict=True)]
        for line in found:
            print("  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)))
    print(
        f"\n{len({r['sentence'] for r in rows})} sentences, {len(rows)} recordings. {marks(rows)}"
    )


if __name__ == "__main__":
    main()
