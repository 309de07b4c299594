"""The shapes of a map, drawn around 0, 0, for style sheets to colour."""

from __future__ import annotations

from plainspoken.web.page.layout import Mark, Point
from plainspoken.web.page.markup import Html, tag

_LEAVES = (
    *((0.08, -8.0), (0.17, 8.0), (0.33, -9.0), (0.42, 7.0)),
    *((0.6, 8.0), (0.68, -8.0), (0.84, 7.0), (0.92, -7.0)),
)


def trellis(at: Point, to: Point) -> list[Html]:
    """A row of vines: posts, wires and leaves between them."""
    (x1, y1), (x2, y2) = at, to
    y1 -= 34
    wires = [
        tag("line", x1=x1 + d, y1=y1, x2=x2 + d, y2=y2, class_="wire") for d in (-7.0, 0.0, 7.0)
    ]
    posts = [
        tag("line", x1=x1 + (x2 - x1) * s - 14, y1=y1 + (y2 - y1) * s,
            x2=x1 + (x2 - x1) * s + 14, y2=y1 + (y2 - y1) * s, class_="post")
        for s in (0.0, 0.25, 0.5, 0.75, 1.0)
    ]  # fmt: skip
    leaves = [
        tag("circle", cx=x1 + (x2 - x1) * s + d, cy=y1 + (y2 - y1) * s, r=9.0, class_="leaf")
        for s, d in _LEAVES
    ]
    return [*posts, *wires, *leaves]


def bunch(mark: Mark) -> list[Html]:
    """A bunch of grapes with the sign of what is known of it."""
    berries = [(-9, -8), (0, -10), (9, -8), (-5, 0), (5, 0), (0, 8)]
    return [
        tag("circle", r=22.0, class_="halo"),
        *(
            tag("circle", cx=float(x), cy=float(y), r=6.5, class_=f"berry {mark.tone}")
            for x, y in berries
        ),
        *([tag("text", mark.sign, class_="badge", x=17.0, y=-8.0)] if mark.sign else []),
    ]


def box(mark: Mark, count: int) -> list[Html]:
    """A crate that fills: empty, a third for each thing in it, and brimful once it is full."""
    level = 20.0 if mark.tone != "plain" else min(count, 2) * 7.0
    return [
        tag("rect", x=-16.0, y=-10.0, width=32.0, height=22.0, rx=3.0, class_=f"crate {mark.tone}"),
        tag("rect", x=-14.0, y=10.0 - level, width=28.0, height=level, class_="filling"),
        *([tag("text", mark.sign, class_="badge", x=18.0, y=0.0)] if mark.sign else []),
    ]


def robot(number: int, *, busy: bool) -> list[Html]:
    """A robot around 0, 0; each has its own shade and stripes, the one at work a ring."""
    ring = [tag("circle", r=30.0, class_="ring")] if busy else []
    return [
        *ring,
        tag("rect", x=-20.0, y=-14.0, width=40.0, height=26.0, rx=8.0,
            class_=f"body body-{number % 3}"),
        tag("circle", cx=-12.0, cy=14.0, r=6.0, class_="wheel"),
        tag("circle", cx=12.0, cy=14.0, r=6.0, class_="wheel"),
        tag("circle", cx=-7.0, cy=-3.0, r=3.5, class_="eye"),
        tag("circle", cx=7.0, cy=-3.0, r=3.5, class_="eye"),
    ]  # fmt: skip
