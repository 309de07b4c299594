"""A picture of a run in SVG: a bar a pattern, with its interval."""

from __future__ import annotations

from html import escape

from plainspoken.evaluation.metric import Share
from plainspoken.evaluation.summary import Accuracy, Summary

LEFT = 210
"""Where the bars begin; the names stand before."""
BAR = 420
"""The length of 100%."""
RIGHT = 150
TOP = 64
ROW = 34
THICK = 11

_STYLE = """
text { font: 13px system-ui, sans-serif; fill: #24292f }
.title { font-weight: 600; font-size: 15px }
.small { font-size: 11px; fill: #57606a }
.grid { stroke: #d0d7de; stroke-width: 1 }
.literal { fill: #0969da }
.executable { fill: #bf8700 }
.interval { stroke: #24292f; stroke-width: 1.2; fill: none }
@media (prefers-color-scheme: dark) {
  text { fill: #e6edf3 }
  .small { fill: #9198a1 }
  .grid { stroke: #3d444d }
  .interval { stroke: #e6edf3 }
}
"""


def picture(summary: Summary) -> str:
    """The accuracy of both readings, in all, by group and by pattern, as an SVG document."""
    lines = (summary.total, *summary.groups, *summary.patterns)
    width, height = LEFT + BAR + RIGHT, TOP + ROW * len(lines) + 34
    title = f"Extraction: {summary.total.literal.total} sentences, mode {summary.mode}"
    size = f'viewBox="0 0 {width} {height}" width="{width}" height="{height}"'
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} role="img" aria-label="{escape(title)}">',
        f"<style>{_STYLE}</style>",
        f'<text class="title" x="12" y="24">{escape(title)}</text>',
        *_legend(),
        *_grid(TOP + ROW * len(lines)),
    ]
    for number, line in enumerate(lines):
        parts += _line(line, TOP + ROW * number)
    parts.append("</svg>")
    return "\n".join(parts) + "\n"


def _legend() -> list[str]:
    return [
        f'<rect class="literal" x="{LEFT}" y="38" width="12" height="{THICK}"/>',
        f'<text class="small" x="{LEFT + 18}" y="48">literal</text>',
        f'<rect class="executable" x="{LEFT + 80}" y="38" width="12" height="{THICK}"/>',
        f'<text class="small" x="{LEFT + 98}" y="48">executable</text>',
        f'<text class="small" x="{LEFT + 190}" y="48">whiskers: 95% intervals (Wilson)</text>',
    ]


def _grid(bottom: int) -> list[str]:
    parts = []
    for percent in range(0, 101, 20):
        x = LEFT + BAR * percent / 100
        at = f'class="small" x="{x:g}" y="{bottom + 16}"'
        parts.append(f'<line class="grid" x1="{x:g}" y1="{TOP - 4}" x2="{x:g}" y2="{bottom}"/>')
        parts.append(f'<text {at} text-anchor="middle">{percent}%</text>')
    return parts


def _line(line: Accuracy, y: int) -> list[str]:
    bars = [("literal", line.literal), ("executable", line.executable)]
    shown = [(kind, share) for kind, share in bars if share.total]
    parts = [
        f'<text x="{LEFT - 10}" y="{y + 17}" text-anchor="end">{escape(line.name)}</text>',
        f'<text class="small" x="{LEFT + BAR + 14}" y="{y + 17}">{escape(_counts(shown))}</text>',
    ]
    for place, (kind, share) in enumerate(shown):
        parts += _bar(kind, share, y + 1 + place * (THICK + 2))
    return parts


def _bar(kind: str, share: Share, y: int) -> list[str]:
    low, high = (LEFT + BAR * end for end in share.interval)
    middle = y + THICK / 2
    length = BAR * (share.value or 0)
    whisker = f"M{low:.1f} {middle - 3:g}v6M{low:.1f} {middle:g}H{high:.1f}m0 -3v6"
    return [
        f'<rect class="{kind}" x="{LEFT}" y="{y}" width="{length:.1f}" height="{THICK}"/>',
        f'<path class="interval" d="{whisker}"/>',
    ]


def _counts(bars: list[tuple[str, Share]]) -> str:
    return " · ".join(f"{share.count}/{share.total}" for _, share in bars)
