"""What the page of a mission asks of it, each thing confirmed by a person who has seen it in words.

Whoever commands says which step they saw; where somebody else commanded since then, they are told
and nothing is done.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from dataclasses import dataclass

from nicegui import ui

from plainspoken.errors import PlainspokenError
from plainspoken.language.extracted import Reading, Status
from plainspoken.logic.formula import conjunction
from plainspoken.mission.mission import MissionId
from plainspoken.mission.observation import ChangeAsked, Told
from plainspoken.mission.request import Clause
from plainspoken.pipeline import Site, understand
from plainspoken.questions.fluents import fluents_in
from plainspoken.questions.morphology import listed
from plainspoken.web.desk import Desk, Reply, UnseenError
from plainspoken.web.page.frame import Text, Visitor, button, confirmed, tell
from plainspoken.web.page.living import Living
from plainspoken.web.page.panels import buttons
from plainspoken.web.page.view import View


@dataclass(frozen=True)
class Commands:
    """The commands of one visitor to one mission; view: what they look at."""

    desk: Desk
    mission: MissionId
    visitor: Visitor
    view: Callable[[], View]

    async def pause(self) -> None:
        """Pause at once: nobody has to confirm that a robot should stand."""
        await self._ask(self.desk.pause)

    async def resume(self) -> None:
        """Go on; whoever paused or reported since is told of."""
        await self._ask(self.desk.resume)

    async def cancel(self) -> None:
        """Give the mission up, once that is confirmed."""
        if await confirmed(
            "Cancel this mission?",
            f"“{self.view().title}” is given up for good. What was done stays done.",
            "Yes, cancel it",
            danger=True,
        ):
            await self._ask(self.desk.cancel)

    async def report(self, text: str) -> str:
        """Have somebody confirm what a report says, and record it; gives what to answer."""
        view = self.view()
        found = reported(text, view)
        if found is None:
            return "I can't tell which fact that is. Say it like: “the box is full”."
        told, english = found
        told = Told(self.visitor.name, text, told.added, told.deleted)
        if not await confirmed("Note this?", f"I understand: {english}.", "Yes, note it"):
            return "I haven't noted it."
        try:
            await asyncio.to_thread(self.desk.report, self.mission, told)
        except PlainspokenError as error:
            return f"I couldn't note it: {error.what}."
        return f"Noted: {english}."

    async def change(self, text: str = "") -> None:
        """Say what should be done instead, or as well."""
        site = await asyncio.to_thread(self.desk.site, self.mission)
        with ui.dialog() as dialog, ui.element("div").classes("card dialog"):
            Text("h2", "Change what is asked for")
            said = ui.textarea(label="What should be done?", value=text).props(
                "outlined autogrow autofocus maxlength=2000"
            )
            shown = ui.element("div").classes("changed").props('aria-live="polite"')

            async def heard() -> None:
                await self._understood(said.value or "", site, shown, dialog)

            said.on("keydown.enter.exact.prevent", heard)
            with ui.element("div").classes("row"):
                button("Understand", heard, "main")
                button("Leave it as it is", dialog.close)
        dialog.props('aria-label="change what is asked for"')
        dialog.on_value_change(lambda event: None if event.value else dialog.delete())
        dialog.open()
        if text:
            await heard()

    async def _understood(
        self, text: str, site: Site, shown: ui.element, dialog: ui.dialog
    ) -> None:
        found = await asyncio.to_thread(understand, text, site)
        shown.clear()
        with shown:
            if found.status is Status.OK and found.reading is not None:
                self._offered(text, found.reading, dialog)
            elif found.status is Status.CLARIFY:
                Text("p", found.question or "Which do you mean?", "question")
                answers = [each.english for each in found.alternatives]

                def chosen(index: str) -> None:
                    shown.clear()
                    with shown:
                        self._offered(text, found.alternatives[int(index)], dialog)

                Living(buttons(answers, "answers", "button answer")).on_pick(chosen)
            else:
                Text("p", found.reason or "I do not understand that.", "refusal")

    def _offered(self, text: str, reading: Reading, dialog: ui.dialog) -> None:
        Text("p", reading.english, "english")

        async def agreed(*, instead: bool) -> None:
            dialog.close()
            await self._ask_change(text, reading, instead=instead)

        with ui.element("div").classes("row"):
            button("Yes, instead of all that was asked", lambda: agreed(instead=True), "main")
            button("Yes, as well", lambda: agreed(instead=False), "main")

    async def _ask_change(self, text: str, reading: Reading, *, instead: bool) -> None:
        seen = self.view().step

        def asked() -> Reply:
            now = self.desk.mission(self.mission)
            new = Clause(reading.formula, now.instant)
            clauses = (new,) if instead else (*now.brief.clauses, new)
            site = self.desk.site(self.mission)
            english = site.in_words(conjunction(*(each.goal for each in clauses)))
            change = ChangeAsked(self.visitor.name, text, clauses, english)
            return self.desk.change(self.mission, change, seen=seen)

        await self._told(asked)

    async def _ask(self, command: Callable[..., Reply]) -> None:
        seen = self.view().step
        await self._told(lambda: command(self.mission, self.visitor.name, seen=seen))

    async def _told(self, command: Callable[[], Reply]) -> None:
        """Carry a command out, and tell of others who commanded meanwhile."""
        if not self.visitor.may_command:
            ui.notify("You may look and ask here; an operator commands.", type="warning")
            return
        try:
            reply = await asyncio.to_thread(command)
        except UnseenError as error:
            others = "; ".join(map(str, error.commands))
            ui.notify(
                f"Nothing was done: meanwhile {others}. Look, and ask again if you still want it.",
                type="warning", close_button="Close", timeout=12_000,
            )  # fmt: skip
        except PlainspokenError as error:
            tell(error)
        else:
            if reply.meanwhile:
                ui.notify(f"Meanwhile {'; '.join(map(str, reply.meanwhile))}.", type="info")


def reported(text: str, view: View) -> tuple[Told, str] | None:
    """The facts that a report states, with their words; None where it states none."""
    moment = view.moment
    said = [each for each in fluents_in(text, moment.lexicon) if moment.changes(each.atom)]
    added = frozenset(each.atom for each in said if each.holds)
    deleted = frozenset(each.atom for each in said if not each.holds)
    if not said or added & deleted:
        return None
    words = [moment.lexicon.clause(each.atom).said(negative=not each.holds) for each in said]
    return Told("", text, added, deleted), listed(words)
