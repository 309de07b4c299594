"""HTML as text that is escaped by being made: only `tag` writes angle brackets."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape

_VOID = frozenset({"br", "circle", "hr", "input", "line", "path", "polygon", "rect"})


class Html(str):
    """Text that is HTML already; every other text is escaped where it is put in."""

    __slots__ = ()


Attribute = str | float | bool | None
Child = str | Html | None


def tag(name: str, *inside: Child, **attributes: Attribute) -> Html:
    """An element: `tag("b", "1 < 2", class_="x")`.

    attributes: with a hyphen for each underscore within; None and False leave it out
    """
    head = " ".join((name, *_written(attributes)))
    if name in _VOID:
        return Html(f"<{head}/>")
    return Html(f"<{head}>{joined(inside)}</{name}>")


def joined(parts: Iterable[Child]) -> Html:
    """Some pieces one after the other, those that are plain text escaped."""
    return Html("".join(escaped(part) for part in parts if part is not None))


def escaped(text: str) -> Html:
    """Plain text as HTML; what is HTML already stays as it is."""
    return text if isinstance(text, Html) else Html(escape(text))


def _written(attributes: dict[str, Attribute]) -> Iterable[str]:
    for name, value in attributes.items():
        if value is None or value is False:
            continue
        plain = name.rstrip("_").replace("_", "-")
        text = f"{value:g}" if isinstance(value, float) else str(value)
        yield plain if value is True else f'{plain}="{escape(text)}"'
