"""The element that draws a policy, with Cytoscape.js."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from nicegui import events, ui


class PolicyGraph(ui.element, component="static/policy.js"):
    """A graph to move about in, to search, and to pick from."""

    def __init__(self, library: str, picked: Callable[[str], object]) -> None:
        """Draw nothing yet; library: where Cytoscape.js is served."""
        super().__init__()
        self._props["library"] = library
        self._props["graph"] = {"nodes": [], "edges": []}

        def handle(event: events.GenericEventArguments) -> object:
            return picked(str(event.args))

        self.on("pick", handle)

    def show(self, graph: dict[str, Any]) -> None:
        """Draw another state of the graph."""
        if graph != self._props["graph"]:
            self._props["graph"] = graph
            self.update()

    def find(self, words: str) -> None:
        """Light up what has these words, and go there."""
        self.run_method("find", words)

    def fit(self) -> None:
        """Show all of it."""
        self.run_method("fit")

    def here(self) -> None:
        """Go to the present."""
        self.run_method("here")
