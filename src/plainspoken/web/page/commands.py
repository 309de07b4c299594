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
from plainspoken.mission.mission import MissionId, mission_from
from plainspoken.mission.observation import ChangeAsked
from plainspoken.questions.change import ChangeOfMind, wanted
from plainspoken.questions.conversation import message_of
from plainspoken.questions.report import Report
from plainspoken.web.desk import Desk, Reply, UnseenError
from plainspoken.web.page.frame import Text, Visitor, button, confirmed, tell
from plainspoken.web.page.living import Living
from plainspoken.web.page.panels import buttons
from plainspoken.web.page.view import View
from plainspoken.world.event import Step


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
        """Give the mission up, once that is confirmed by somebody who saw it as it was then."""
        seen = self.view().step
        if await confirmed(
            "Cancel this mission?",
            f"“{self.view().title}” is given up for good. What was done stays done.",
            "Yes, cancel it",
            danger=True,
        ):
            await self._ask(self.desk.cancel, seen)

    async def change(self) -> None:
        """Say what should be different, see what that comes to, and confirm it."""
        seen = self.view().step
        with ui.dialog() as dialog, ui.element("div").classes("card dialog"):
            Text("h2", "Change what is asked for")
            said = ui.textarea(label="What should be different?").props(
                "outlined autogrow autofocus maxlength=2000"
            )
            shown = ui.element("div").classes("changed").props('aria-live="polite"')

            async def heard() -> None:
                found = await asyncio.to_thread(self._wanted, said.value or "")
                self._offer(found, shown, dialog, seen)

            said.on("keydown.enter.exact.prevent", heard)
            with ui.element("div").classes("row"):
                button("Understand", heard, "main")
                button("Leave it as it is", dialog.close)
        dialog.props('aria-label="change what is asked for"')
        dialog.on_value_change(lambda event: None if event.value else dialog.delete())
        dialog.open()

    def _wanted(self, text: str) -> ChangeOfMind:
        view = self.view()
        return wanted(text, mission_from(view.entries), view.moment.lexicon)

    def _offer(self, found: ChangeOfMind, shown: ui.element, dialog: ui.dialog, seen: Step) -> None:
        """Say back what was understood, to be confirmed."""
        shown.clear()
        with shown:
            if found.meant is not None:
                Text("p", found.meant.english, "english")

                async def agreed() -> None:
                    dialog.close()
                    await self.tell(found, seen)

                button("Yes, from now on", agreed, "main")
            elif found.choices:
                Text("p", found.question or "Which do you mean?", "question")
                answers = [each.english for each in found.choices]
                Living(buttons(answers, "answers", "button answer")).on_pick(
                    lambda place: self._offer(
                        found.settled_on(found.choices[int(place)]), shown, dialog, seen
                    )
                )
            else:
                Text("p", found.reason or "I do not understand that.", "refusal")

    async def tell(self, agreed: Report | ChangeOfMind, seen: Step | None = None) -> None:
        """Tell the mission what somebody has agreed to.

        seen: the step that they saw then; None for the last
        """
        message = message_of(agreed, self.visitor.name)
        seen = self.view().step if seen is None else seen

        def told() -> Reply:
            if isinstance(message, ChangeAsked):
                return self.desk.change(self.mission, message, seen=seen)
            return self.desk.report(self.mission, message)

        await self._told(told)

    async def _ask(self, command: Callable[..., Reply], seen: Step | None = None) -> None:
        seen = self.view().step if seen is None else seen
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
