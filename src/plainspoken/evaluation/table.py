"""A summary as tables: values first, so that the terminal and a page show the same."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from plainspoken.evaluation.metric import Share
from plainspoken.evaluation.summary import Accuracy, Summary


@dataclass(frozen=True, slots=True)
class Table:
    """A title, and rows of cells under the names of their columns; the first column is text."""

    title: str
    columns: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def tables(summary: Summary) -> tuple[Table, ...]:
    """The figures of a run, from the one that matters most to the details."""
    return (
        _accuracies("Accuracy", (summary.total, *summary.groups), "group"),
        _accuracies("Accuracy by pattern", summary.patterns, "pattern"),
        _outcomes(summary),
        *_mentions(summary),
        confusion(summary),
    )


def markdown(summary: Summary) -> str:
    """The tables as a page, with every sentence that is not right."""
    parts = ["# Extraction", caption(summary)]
    for table in tables(summary):
        parts.append(f"## {table.title}")
        parts.append(lines(table))
    if summary.failures:
        parts.append("## Not right")
        parts.append(lines(failures(summary)))
    return "\n\n".join(parts) + "\n"


def caption(summary: Summary) -> str:
    """What was measured, how, and how long a sentence took."""
    measured = (
        f"{summary.total.literal.total} sentences of `{summary.corpus}`, mode {summary.mode}, "
        f"plainspoken {summary.version}. "
        "A formula is right when it is equivalent to the gold one over all non-empty finite "
        "traces; in brackets 95% intervals (Wilson)."
    )
    if summary.median is None or summary.p95 is None:
        return measured
    return (
        f"{measured} A sentence takes {_duration(summary.median)}, {_duration(summary.p95)} at p95."
    )


def failures(summary: Summary) -> Table:
    """Every sentence that is not right, with what came of it."""
    rows = (
        (row.id, row.utterance, str(result.outcome), result.reason or result.formula or "")
        for row, result in summary.failures
    )
    return Table("Not right", ("id", "utterance", "outcome", "recognised, or why not"), tuple(rows))


def confusion(summary: Summary) -> Table:
    """Gold patterns down, recognised ones across; a column a pattern that was recognised."""
    gold = sorted({gold for gold, _ in summary.confusion})
    # Endings without a pattern, in brackets, stand after the patterns.
    recognised = sorted(
        {name for _, name in summary.confusion}, key=lambda name: (name.startswith("("), name)
    )
    rows = []
    for one in gold:
        counts = [summary.confusion.get((one, other), 0) for other in recognised]
        rows.append((one, *(str(count) if count else "" for count in counts)))
    return Table("Patterns, gold by recognised", ("gold", *recognised), tuple(rows))


def mistaken(summary: Summary) -> Table:
    """The cells of the confusion that are off its diagonal, the largest first."""
    cells = [(count, pair) for pair, count in summary.confusion.items() if pair[0] != pair[1]]
    rows = [
        (gold, recognised, str(count))
        for count, (gold, recognised) in sorted(cells, key=lambda each: (-each[0], each[1]))
    ]
    return Table("Patterns taken for others", ("gold", "recognised", "sentences"), tuple(rows))


def shown(share: Share) -> str:
    """A share as "94.0% [83.8, 97.9] 47/50"."""
    if share.value is None:
        return "-"
    low, high = share.interval
    return f"{share.value:.1%} [{100 * low:.1f}, {100 * high:.1f}] {share.count}/{share.total}"


def _accuracies(title: str, lines: Sequence[Accuracy], column: str) -> Table:
    return Table(
        title,
        (column, "literal", "executable"),
        tuple((line.name, shown(line.literal), shown(line.executable)) for line in lines),
    )


def _outcomes(summary: Summary) -> Table:
    total = summary.total.literal.total
    rows = (
        (str(outcome), str(count), f"{count / total:.1%}")
        for outcome, count in summary.outcomes.items()
    )
    return Table("How the runs ended", ("outcome", "sentences", "share"), tuple(rows))


def _mentions(summary: Summary) -> tuple[Table, ...]:
    mentions = summary.mentions
    if not mentions.recall.total:
        return ()
    rows = (
        ("recall", shown(mentions.recall)),
        ("precision", shown(mentions.precision)),
        ("grounding", shown(mentions.grounding)),
    )
    return (Table("Referring expressions", ("measure", "share"), rows),)


def _duration(seconds: float) -> str:
    return f"{seconds * 1000:.1f} ms" if seconds < 1 else f"{seconds:.1f} s"


def lines(table: Table) -> str:
    """A table as Markdown."""
    rule = ("---", *("---:" for _ in table.columns[1:]))
    cells = (table.columns, rule, *(tuple(map(_cell, row)) for row in table.rows))
    return "\n".join(f"| {' | '.join(row)} |" for row in cells)


def _cell(text: str) -> str:
    return " ".join(text.split()).replace("|", "\\|")
