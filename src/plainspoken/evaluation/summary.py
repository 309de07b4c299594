"""What the results of an experiment come to: shares by group and pattern, endings, seconds."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from plainspoken.evaluation.corpus import Row
from plainspoken.evaluation.experiment import Outcome, Result, UnexplainedError
from plainspoken.evaluation.metric import Mentions, Share, percentile

Judged = tuple[Row, Result]

COMBINED = "combined"
"""Sentences of several patterns; apart, most combinations would have one sentence."""


@dataclass(frozen=True, slots=True)
class Accuracy:
    """How many of some sentences became the right formula.

    executable: of the sentences whose corpus gives that reading
    """

    name: str
    literal: Share
    executable: Share


@dataclass(frozen=True, slots=True)
class Summary:
    """The figures of one run over one corpus.

    corpus, mode, version: what was measured
    groups, patterns:      the largest first; groups is empty where the corpus names none
    confusion:             how often a gold pattern was recognised as another, or ended otherwise
    mentions:              over all sentences whose corpus says what is mentioned
    failures:              every sentence that is not right, with its result
    median, p95:           seconds a sentence; None where none were measured
    """

    corpus: str
    mode: str
    version: str
    total: Accuracy
    groups: tuple[Accuracy, ...]
    patterns: tuple[Accuracy, ...]
    confusion: dict[tuple[str, str], int]
    mentions: Mentions
    outcomes: dict[Outcome, int]
    failures: tuple[Judged, ...]
    median: float | None
    p95: float | None


def summarised(
    rows: Sequence[Row], results: Sequence[Result], *, corpus: str, mode: str, version: str
) -> Summary:
    """Sum up a run; results are in the order of the rows.

    raises UnexplainedError: where some run ended in a way that has no name
    """
    judged = list(zip(rows, results, strict=True))
    unexplained = [result for result in results if not _explained(result)]
    if unexplained:
        raise UnexplainedError(unexplained)
    seconds = [result.seconds for result in results if result.seconds is not None]
    counted = Counter(result.outcome for result in results)
    return Summary(
        corpus,
        mode,
        version,
        _accuracy("all", judged),
        _split(judged, lambda row: row.group),
        _split(judged, lambda row: _class_of(row.pattern)),
        dict(
            sorted(
                Counter(
                    (_class_of(row.pattern), _recognised(result)) for row, result in judged
                ).items()
            )
        ),
        sum((result.mentions for result in results if result.mentions), Mentions()),
        {outcome: counted[outcome] for outcome in Outcome if outcome is not Outcome.UNEXPLAINED},
        tuple(each for each in judged if each[1].outcome is not Outcome.RIGHT),
        percentile(seconds, 50),
        percentile(seconds, 95),
    )


def summary_to_json(summary: Summary) -> dict[str, Any]:
    """The figures as `eval --json` prints them."""
    return {
        "corpus": summary.corpus,
        "mode": summary.mode,
        "version": summary.version,
        "total": _accuracy_to_json(summary.total),
        "groups": [_accuracy_to_json(each) for each in summary.groups],
        "patterns": [_accuracy_to_json(each) for each in summary.patterns],
        "confusion": [
            {"gold": gold, "recognised": recognised, "count": count}
            for (gold, recognised), count in summary.confusion.items()
        ],
        "referring_expressions": {
            "recall": share_to_json(summary.mentions.recall),
            "precision": share_to_json(summary.mentions.precision),
            "grounding": share_to_json(summary.mentions.grounding),
        },
        "outcomes": {str(outcome): count for outcome, count in summary.outcomes.items()},
        "seconds": {"median": summary.median, "p95": summary.p95},
        "failures": [
            {
                "id": row.id,
                "utterance": row.utterance,
                "outcome": str(result.outcome),
                "formula": result.formula,
                "reason": result.reason,
            }
            for row, result in summary.failures
        ],
    }


def share_to_json(share: Share) -> dict[str, Any]:
    """A share with its value and 95% interval."""
    low, high = share.interval
    return {"count": share.count, "total": share.total, "value": share.value, "ci95": [low, high]}


def _accuracy_to_json(accuracy: Accuracy) -> dict[str, Any]:
    return {
        "name": accuracy.name,
        "literal": share_to_json(accuracy.literal),
        "executable": share_to_json(accuracy.executable),
    }


def _explained(result: Result) -> bool:
    if result.outcome in (Outcome.ASKED, Outcome.REFUSED, Outcome.FAILED):
        return bool(result.reason)
    return result.outcome is not Outcome.UNEXPLAINED


def _accuracy(name: str, judged: Sequence[Judged]) -> Accuracy:
    return Accuracy(
        name,
        Share.of(result.literal for _, result in judged),
        Share.of(result.executable is True for row, result in judged if row.executable is not None),
    )


def _split(judged: Sequence[Judged], name_of: Callable[[Row], str | None]) -> tuple[Accuracy, ...]:
    parts: dict[str, list[Judged]] = {}
    for each in judged:
        name = name_of(each[0])
        if name is not None:
            parts.setdefault(name, []).append(each)
    # What stands for no single pattern comes last.
    order = sorted(parts, key=lambda name: (name == COMBINED, -len(parts[name]), name))
    return tuple(_accuracy(name, parts[name]) for name in order)


def _class_of(pattern: str) -> str:
    return COMBINED if " & " in pattern else pattern


def _recognised(result: Result) -> str:
    if result.outcome in (Outcome.ASKED, Outcome.REFUSED, Outcome.FAILED):
        return f"({result.outcome})"
    return _class_of(result.pattern) if result.pattern else "(none named)"
