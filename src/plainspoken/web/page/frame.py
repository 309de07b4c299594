"""What every page has: its head, its header, and the small elements that the others are made of."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

from nicegui import app, ui
from nicegui.elements.mixins.text_element import TextElement

from plainspoken.errors import PlainspokenError
from plainspoken.web.desk import Desk
from plainspoken.web.page.cards import Cards
from plainspoken.web.page.live import Feeds

STATIC = Path(__file__).parent / "static"
ASSETS = "/page"


class Visitor(Protocol):
    """Who looks at a page, and whether they may do more than look and ask."""

    @property
    def name(self) -> str: ...
    @property
    def may_command(self) -> bool: ...


@dataclass(frozen=True)
class House:
    """What all pages share.

    robot:   the robot of missions that are started here, for their log
    missing: what there is to do before anybody can speak here
    """

    desk: Desk
    feeds: Feeds
    cards: Cards
    robot: dict[str, Any] = field(default_factory=dict)
    missing: str | None = None


class Text(TextElement):
    """An element that holds text, such as a heading; whatever the text is, it is no HTML."""

    def __init__(self, tag: str, text: str = "", classes: str = "") -> None:
        super().__init__(tag=tag, text=text)
        self.classes(classes)


def button(text: str, pressed: Callable[[], object], kind: str = "plain") -> Text:
    """A button of one of the kinds: main, plain, danger, chip."""
    found = Text("button", text, f"button {kind}").props("type=button")
    found.on("click", lambda _: pressed(), args=[])
    return found


def share_assets() -> None:
    """Serve what pages load besides the framework; from here, never from another site."""
    app.add_static_files(ASSETS, STATIC)
    ui.add_head_html(
        f'<link rel="stylesheet" href="{ASSETS}/page.css">'
        f'<script defer src="{ASSETS}/page.js"></script>'
        f'<script defer src="{ASSETS}/aloud.js"></script>'
        '<meta name="color-scheme" content="light dark">',
        shared=True,
    )


@contextmanager
def framed(visitor: Visitor, classes: str) -> Iterator[ui.element]:
    """The header, and the main part to fill."""
    Text("a", "Skip to the content", "skip").props('href="#main"')
    with ui.element("header").classes("top"):
        Text("a", "plainspoken", "brand").props('href="/"')
        with ui.element("nav").props('aria-label="pages"'):
            Text("a", "New mission").props('href="/"')
            Text("a", "Missions").props('href="/missions"')
        if visitor.may_command:
            Text("span", visitor.name, "visitor operator")
        else:
            Text("span", f"{visitor.name} (may look and ask)", "visitor")
    with ui.element("main").props('id="main" tabindex="-1"').classes(classes) as main:
        yield main


async def confirmed(title: str, text: str, yes: str, *, danger: bool = False) -> bool:
    """Ask in a dialog before something is done; Escape is no."""
    with ui.dialog() as dialog, ui.element("div").classes("card dialog"):
        Text("h2", title)
        Text("p", text)
        with ui.element("div").classes("row"):
            button(yes, lambda: dialog.submit(True), "danger" if danger else "main").props(
                "autofocus"
            )
            button("No, leave it", lambda: dialog.submit(False))
    dialog.props(f'aria-label="{title}"')
    answer = bool(await dialog)
    dialog.delete()
    return answer


def tell(error: PlainspokenError) -> None:
    """Show what went wrong, and what to do next."""
    hint = f" {error.hint}" if error.hint else ""
    ui.notify(f"{error.what}.{hint}", type="negative", close_button="Close", timeout=12_000)
