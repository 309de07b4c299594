"""The page where a mission begins: say it, see what was understood, plan it, confirm it."""

from __future__ import annotations

import asyncio
import threading
from concurrent.futures import ThreadPoolExecutor
from functools import partial

from nicegui import ui

from plainspoken.errors import PlainspokenError
from plainspoken.language.correction import corrected
from plainspoken.language.dialogue import Dialogue
from plainspoken.language.example import examples
from plainspoken.language.extracted import Extraction, Reading, Status
from plainspoken.logic.formula import Formula, conjunction
from plainspoken.logic.syntax import unparse
from plainspoken.mission.mission import new_mission_id
from plainspoken.pipeline import Request, Site, why_not
from plainspoken.planning.policy import Policy
from plainspoken.planning.solver import Ending, OutOfTime, Solved, Unsolvable
from plainspoken.planning.unsolvable import parts_of
from plainspoken.planning.watch import Progress
from plainspoken.web.desk import PlanningStopped
from plainspoken.web.page.frame import House, Text, Visitor, button, framed, tell
from plainspoken.web.page.living import Living
from plainspoken.web.page.microphone import Dictation, Recorder
from plainspoken.web.page.panels import buttons
from plainspoken.web.page.spoken import marked, pictured
from plainspoken.work.shift import utc_now

PATIENCE = 120.0
"""Seconds that planning may take; whoever waits can stop it before."""
LONGEST = 2000
PLANNERS = ThreadPoolExecutor(4, "planning")
"""Apart from the threads that show things: who plans for minutes keeps nobody from watching."""


class Say:
    """The conversation that leads to one mission."""

    def __init__(self, house: House, visitor: Visitor) -> None:
        self.house, self.visitor = house, visitor
        self.place = next(iter(house.desk.places))
        self.dialogue = Dialogue(self.site.vocabulary)
        self.microphone: Recorder | None = None
        self.stopped: threading.Event | None = None
        self.progress: Progress | None = None

    @property
    def site(self) -> Site:
        return self.house.desk.places[self.place]

    def build(self) -> None:
        """Lay the page out."""
        with framed(self.visitor, "say"):
            Text("h1", "What should be done?")
            if len(self.house.desk.places) > 1:
                ui.select(
                    list(self.house.desk.places), value=self.place, label="Place",
                    on_change=lambda event: self._moved(str(event.value)),
                ).props("outlined dense").classes("place")  # fmt: skip
            self.text = ui.textarea(label="Say it in your own words").props(
                f'outlined autogrow maxlength={LONGEST} id="say"'
            )
            self.text.on("keydown.enter.exact.prevent", self._heard)
            dictation = Dictation(self.text, Living().props('aria-live="polite"'))
            with ui.element("div").classes("row"):
                button("Understand", self._heard, "main")
                self.more = button("Start again", self._afresh)
                self.more.set_visibility(False)
                if self.visitor.may_command:
                    self.microphone = dictation.microphone(self.house.missing, place=self.place)
            self.understood = (
                ui.element("section").classes("understood").props('aria-live="polite"')
            )
            self.plan = ui.element("section").classes("planning").props('aria-live="polite"')

    def _moved(self, place: str) -> None:
        self.place = place
        if self.microphone is not None:
            self.microphone.speak_of(place=place)
        self._afresh()

    def _afresh(self) -> None:
        self._stop()
        self.dialogue = Dialogue(self.site.vocabulary)
        self.text.value = ""
        self.understood.clear()
        self.plan.clear()
        self.more.set_visibility(False)

    async def _heard(self) -> None:
        text = (self.text.value or "").strip()
        if not text:
            return
        self._stop()
        self.dialogue = Dialogue(self.site.vocabulary)
        turn = await asyncio.to_thread(self.dialogue.say, text)
        self.dialogue = turn.dialogue
        self._show(turn.extraction)

    # -- what was understood -----------------------------------------------------------------------

    def _show(self, found: Extraction) -> None:
        self.more.set_visibility(True)
        self.plan.clear()
        self.understood.clear()
        with self.understood, ui.element("div").classes("card"):
            Text(
                "h2", {"ok": "I understand", "clarify": "One question"}.get(found.status, "Not yet")
            )
            if found.referring_expressions:
                sentence = marked(found.utterance, found.referring_expressions, self.site.landmarks)
                Living(sentence).on_pick(lambda index: self._correct(found, int(index)))
            match found.status:
                case Status.OK if found.reading is not None:
                    self._meaning(found, found.reading)
                case Status.CLARIFY:
                    self._question(found)
                case _:
                    Text("p", found.reason or "I do not understand that.", "refusal")
                    self._what_can_be_said()

    def _meaning(self, found: Extraction, reading: Reading) -> None:
        Text("p", reading.english, "english")
        if found.note:
            Text("p", found.note, "note")
        shown = pictured(examples(reading.formula, self.site.landmarks), self.site.landmarks)
        if shown is not None:
            Text("h3", "For example")
            Living(shown)
        with ui.element("details"):
            Text("summary", "The formula")
            Text("code", unparse(reading.formula))
        if self.visitor.may_command:
            with ui.element("div").classes("row"):
                button(
                    "Yes, make a plan",
                    lambda: self._make_plan(reading.formula, found.utterance),
                    "main",
                )
        else:
            Text("p", "You may look and ask here; an operator starts missions.", "note")

    def _question(self, found: Extraction) -> None:
        Text("p", found.question or "Which do you mean?", "question")
        answers = [
            each.english if each.answer in ("", "yes") else f"{each.answer}: {each.english}"
            for each in found.alternatives
        ]
        Living(buttons(answers, "answers", "button answer")).on_pick(
            lambda index: self._chosen(found, found.alternatives[int(index)])
        )

    def _chosen(self, found: Extraction, reading: Reading) -> None:
        self._show(found.settled_on(reading))

    def _correct(self, found: Extraction, index: int) -> None:
        """Let somebody choose what a piece of the sentence speaks of."""
        if found.reading is None:
            return
        each = found.referring_expressions[index]
        landmarks = self.site.landmarks
        own = landmarks[each.symbol].type if each.symbol in landmarks else None
        options = {
            id: one.description
            for id, one in sorted(landmarks.items(), key=lambda item: item[1].type is not own)
        }
        with ui.dialog() as dialog, ui.element("div").classes("card dialog"):
            Text("h2", f"What is “{each.text}”?")
            meant = ui.select(options, value=each.symbol, label="It means", with_input=True)
            meant.props("outlined")

            def agreed() -> None:
                dialog.close()
                self._show(corrected(found, index, str(meant.value), self.site.vocabulary))

            with ui.element("div").classes("row"):
                button("Use this", agreed, "main")
                button("Leave it", dialog.close)
        dialog.props('aria-label="what a piece of the sentence means"')
        dialog.on_value_change(lambda event: None if event.value else dialog.delete())
        dialog.open()

    def _what_can_be_said(self) -> None:
        some = [each.description for each in self.site.landmarks.values()][:12]
        Text("p", f"What I know here, for example: {'; '.join(some)}.", "note")

    # -- planning ----------------------------------------------------------------------------------

    def _stop(self) -> None:
        if self.stopped is not None:
            self.stopped.set()

    async def _make_plan(self, goal: Formula, sentence: str) -> None:
        self._stop()
        stopped = self.stopped = threading.Event()
        self.progress = None
        self.plan.clear()
        with self.plan, ui.element("div").classes("card"):
            Text("h2", "Planning")
            told = Text("p", "looking for a plan that works whatever happens …")
            button("Stop planning", stopped.set)
            timer = ui.timer(0.3, lambda: told.set_text(_so_far(self.progress)))
        try:
            plan = partial(
                self.house.desk.plan, self.place, goal,
                timeout=PATIENCE, stopped=stopped, on_progress=self._progressed,
            )  # fmt: skip
            ending: Ending | None = await asyncio.get_running_loop().run_in_executor(PLANNERS, plan)
        except PlanningStopped:
            ending = None
        except PlainspokenError as error:
            tell(error)
            ending = None
        timer.deactivate()
        if self.stopped is stopped:
            self._planned(ending, goal, sentence)

    def _progressed(self, progress: Progress) -> None:
        self.progress = progress

    def _planned(self, ending: Ending | None, goal: Formula, sentence: str) -> None:
        self.plan.clear()
        with self.plan, ui.element("div").classes("card"):
            match ending:
                case None:
                    Text("h2", "Planning was stopped")
                    button("Plan again", lambda: self._make_plan(goal, sentence))
                case Solved(policy=policy):
                    self._confirm(goal, sentence, policy)
                case _:
                    self._impossible(ending, goal, sentence)

    def _confirm(self, goal: Formula, sentence: str, policy: Policy) -> None:
        Text("h2", "Start this mission?")
        Text("p", self.site.in_words(goal), "english")
        Text("p", _described(policy), "note")
        with ui.element("div").classes("row"):
            button("Yes, start", lambda: self._start(goal, sentence, policy), "main")
            button("No", self._afresh)

    def _start(self, goal: Formula, sentence: str, policy: Policy) -> None:
        request = Request(new_mission_id(utc_now), goal, sentence, self.house.robot)
        try:
            mission = self.house.desk.start(self.place, request, policy)
        except PlainspokenError as error:
            tell(error)
        else:
            ui.navigate.to(f"/missions/{mission}")

    def _impossible(self, ending: Unsolvable | OutOfTime, goal: Formula, sentence: str) -> None:
        Text("h2", "That cannot be done")
        Text("p", why_not(ending, self.site), "refusal")
        if isinstance(ending, OutOfTime):
            button("Try for longer", lambda: self._make_plan(goal, sentence))
            return
        parts = parts_of(goal)
        in_the_way = getattr(ending.reason, "parts", None) or (
            getattr(ending.reason, "part", None),
        )
        changes = [(part, conjunction(*(p for p in parts if p != part)))
                   for part in in_the_way if part in parts and len(parts) > 1]  # fmt: skip
        if changes:
            Text("h3", "What could be changed")
            texts = [f"Leave out: {self.site.in_words(part)}" for part, _ in changes]
            Living(buttons(texts, "changes", "button answer")).on_pick(
                lambda index: self._make_plan(
                    changes[int(index)][1], self.site.in_words(changes[int(index)][1])
                )
            )
        Text("p", "Or say it in other words above.", "note")


def _so_far(progress: Progress | None) -> str:
    if progress is None:
        return "looking for a plan that works whatever happens …"
    return (
        f"{progress.closed} situations settled, {progress.waiting} to look at, "
        f"{progress.dead} dead ends; {progress.seconds:.0f} s"
    )


def _described(policy: Policy) -> str:
    """What a plan promises, in words."""
    count = f"{len(policy.nodes)} situation{'' if len(policy.nodes) == 1 else 's'}"
    if policy.kind == "strong":
        return f"The plan covers {count}, and ends whatever happens."
    return f"The plan covers {count}; where something does not work out, I try again."
