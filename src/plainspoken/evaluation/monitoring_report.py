"""The runs of the monitoring experiment as tables, as a page and as the paper's histogram."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from statistics import mean, median, pstdev

from plainspoken.evaluation.monitoring import Category, Run, Tally, by_distance, score
from plainspoken.evaluation.table import Table, lines

PAPER = {
    Category.PRESENT: ("0.99 ± 0.03", "0.67 ± 0.11"),
    Category.PAST: ("0.96 ± 0.04", "0.80 ± 0.08"),
    Category.FUTURE: ("0.88 ± 0.03", "0.58 ± 0.08"),
}
"""The paper's table of robot answers: soundness and completeness."""
_COLOURS = {"correct": "#2da44e", "hallucinated": "#cf222e", "missing": "#0969da"}


def tables(runs: Mapping[str, Sequence[Run]]) -> tuple[Table, ...]:
    """A table for each metric, of the runs of each way to answer."""
    metrics = (
        ("The paper's metric", False, True),
        ("The paper's metric, without fluents that never change", False, False),
        ("Time-indexed", True, True),
        ("Time-indexed, without fluents that never change", True, False),
    )
    return tuple(
        _table(title, runs, timed=timed, static=static) for title, timed, static in metrics
    )


def _table(title: str, runs: Mapping[str, Sequence[Run]], *, timed: bool, static: bool) -> Table:
    rows = []
    for source, all_runs in runs.items():
        for domain in ("all", *dict.fromkeys(run.situation.domain for run in all_runs)):
            for full in (False, True):
                for category in Category:
                    chosen = [
                        run
                        for run in all_runs
                        if run.situation.full is full
                        and run.situation.category is category
                        and domain in ("all", run.situation.domain)
                    ]
                    if chosen:
                        cells = _cells(chosen, category, timed=timed, static=static)
                        register = "full" if full else "brief"
                        rows.append((source, domain, register, str(category), *cells))
    columns = ("fluents from", "domain", "register", "about", "runs", "soundness", "completeness")
    return Table(title, (*columns, "words (median)", "the paper's"), tuple(rows))


def _cells(
    runs: Sequence[Run], category: Category, *, timed: bool, static: bool
) -> tuple[str, ...]:
    scores = [score(run, timed=timed, static=static) for run in runs]
    sound = [each.soundness for each in scores if each.soundness is not None]
    words = median(len(run.text.split()) for run in runs)
    return (
        str(len(runs)),
        _spread(sound),
        _spread([each.completeness for each in scores]),
        f"{words:g}",
        " / ".join(PAPER[category]),
    )


def _spread(values: Sequence[float]) -> str:
    return f"{mean(values):.3f} ± {pstdev(values):.3f}" if values else "-"


def markdown(runs: Mapping[str, Sequence[Run]], caption: str) -> str:
    """The tables as a page."""
    parts = ["# Monitoring", caption]
    for table in tables(runs):
        parts += [f"## {table.title}", lines(table)]
    return "\n\n".join(parts) + "\n"


def picture(runs: Sequence[Run], *, timed: bool) -> str:
    """The paper's figure as SVG: correct, hallucinated and missing fluents by distance from now."""
    width, height, chart = 860, 300, 380
    size = f'viewBox="0 0 {width} {height}" width="{width}" height="{height}"'
    label = 'role="img" aria-label="Fluents by distance from now"'
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} {label}>',
        "<style>text { font: 12px system-ui, sans-serif; fill: #57606a }</style>",
    ]
    for number, (name, colour) in enumerate(_COLOURS.items()):
        x = 20 + 120 * number
        parts.append(f'<rect x="{x}" y="10" width="12" height="12" fill="{colour}"/>')
        parts.append(f'<text x="{x + 18}" y="21">{name}</text>')
    for number, category in enumerate((Category.PAST, Category.FUTURE)):
        chosen = [run for run in runs if run.situation.category is category]
        left = 20 + number * (chart + 40)
        parts.append(f'<text x="{left}" y="48">{escape(str(category))}: actions from now</text>')
        parts += _bars(by_distance(chosen, timed=timed), left, chart, backwards=number == 0)
    return "\n".join([*parts, "</svg>"]) + "\n"


def _bars(tallies: Mapping[int, Tally], left: int, width: int, *, backwards: bool) -> list[str]:
    parts: list[str] = []
    step = width / max(len(tallies), 1)
    for number, (distance, tally) in enumerate(tallies.items()):
        total = tally.correct + tally.hallucinated + tally.missing
        place = len(tallies) - 1 - number if backwards else number
        x, y = left + place * step, 60.0
        for name, colour in _COLOURS.items():
            tall = 200 * getattr(tally, name) / total if total else 0.0
            parts.append(
                f'<rect x="{x:.1f}" y="{y:.1f}" width="{step * 0.8:.1f}" height="{tall:.1f}"'
                f' fill="{colour}"/>'
            )
            y += tall
        parts.append(f'<text x="{x:.1f}" y="276">{distance}</text>')
    return parts
