"""A microphone beside a field of text: what was heard stands in it, to be looked at first."""

from __future__ import annotations

from typing import Any
from urllib.parse import urlencode

from nicegui import events, ui
from nicegui.elements.mixins.value_element import ValueElement

from plainspoken.language.emphasis import Emphasis, Weight, emphases
from plainspoken.language.extraction import LONGEST
from plainspoken.web.gate import SPEECH
from plainspoken.web.page.frame import ASSETS
from plainspoken.web.page.living import Living
from plainspoken.web.page.markup import Html
from plainspoken.web.page.spoken import weighed


class Recorder(ui.element, component="static/microphone.js"):
    """The button, with the level of what it hears.

    missing: what there is to do before anybody can be heard
    about:   the place or the mission that is spoken of
    """

    def __init__(self, missing: str | None, about: dict[str, str]) -> None:
        super().__init__()
        self.speak_of(**about)
        self._props["recorder"] = f"{ASSETS}/recorder.js"
        self._props["missing"] = missing or ""

    def speak_of(self, **about: str) -> None:
        """Expect the words of a place or a mission."""
        self._props["address"] = f"{SPEECH}?{urlencode(about)}"
        self.update()


class Dictation:
    """A field that can be spoken into; the weighty words of what was heard are marked above it."""

    def __init__(self, field: ValueElement[Any], shown: Living) -> None:
        """Mark words in `shown`, as long as what stands in the field was spoken."""
        self._field, self._shown = field, shown
        self._heard: str | None = None
        self._unclear: tuple[Emphasis, ...] = ()
        field.on_value_change(lambda event: self._mark(str(event.value or "")))

    def microphone(self, missing: str | None, **about: str) -> Recorder:
        """A microphone for the field; about: the place or the mission that is spoken of."""
        found = Recorder(missing, about)
        found.on("heard", self._take)
        return found

    def _take(self, event: events.GenericEventArguments) -> None:
        # A browser sends it, so it is no more to be trusted than what is typed.
        said = event.args if isinstance(event.args, dict) else {}
        self._heard = str(said.get("text", ""))[:LONGEST]
        self._unclear = tuple(
            Emphasis(each["start"], each["end"], Weight.UNCLEAR)
            for each in said.get("emphases", ())
            if isinstance(each, dict) and each.get("weight") == Weight.UNCLEAR
            if all(type(each.get(end)) is int for end in ("start", "end"))
        )
        self._field.value = self._heard
        self._mark(self._heard)

    def _mark(self, text: str) -> None:
        """Mark what stands in the field, where it was spoken, and corrected since."""
        if not text:
            self._heard = None
        if self._heard is None:
            self._shown.show(Html())
            return
        unclear = self._unclear if text == self._heard else ()
        self._shown.show(weighed(text, (*emphases(text), *unclear)))
