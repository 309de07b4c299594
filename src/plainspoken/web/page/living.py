"""An element whose HTML is brought up to date in place: what has the focus or moves stays."""

from __future__ import annotations

from collections.abc import Callable

from nicegui import events, ui

from plainspoken.web.page.markup import Html


class Living(ui.element, component="static/living.js"):
    """Shows HTML of ours; elements with `data-pick` can be picked."""

    def __init__(self, content: Html | None = None, *, tag: str = "div") -> None:
        super().__init__()
        self._props["content"] = content or Html()
        self._props["tag"] = tag

    def show(self, content: Html) -> None:
        """Bring what is shown up to date."""
        if content != self._props["content"]:
            self._props["content"] = content
            self.update()

    def on_pick(self, picked: Callable[[str], object]) -> Living:
        """Call back with what `data-pick` says of an element that was clicked."""

        def handle(event: events.GenericEventArguments) -> object:
            return picked(str(event.args))

        self.on("pick", handle)
        return self
