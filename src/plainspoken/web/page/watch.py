"""The page of one mission: watch it, steer it, ask it, and look at how it was before."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping

from nicegui import ui

from plainspoken.errors import PlainspokenError
from plainspoken.language.extracted import Status
from plainspoken.mission.mission import Status as Standing
from plainspoken.planning.policy import NodeId, Policy
from plainspoken.questions.conversation import Conversation
from plainspoken.web.page import panels
from plainspoken.web.page.commands import Commands
from plainspoken.web.page.drawing import legend
from plainspoken.web.page.frame import (
    ASSETS,
    House,
    Text,
    Visitor,
    button,
    framed,
    tell,
)
from plainspoken.web.page.graph import PLENTY, Graph, graph_of, naming, situation, walked
from plainspoken.web.page.live import Feed
from plainspoken.web.page.living import Living
from plainspoken.web.page.markup import Html
from plainspoken.web.page.microphone import Dictation
from plainspoken.web.page.order import order_in
from plainspoken.web.page.policy import PolicyGraph
from plainspoken.web.page.speech import Said, bubbles, with_questions
from plainspoken.web.page.view import View
from plainspoken.work.shift import utc_now
from plainspoken.world.event import Step

SLOWEST = 0.1
"""Seconds between two pictures, at least: nobody sees more, and many may watch."""
PLAYED_EVERY = 0.8
"""Seconds between two steps of a mission that is played."""
FADES_EVERY = 5.0
"""Seconds after which it is looked whether what is known is too old."""
READ = 'tabindex="0" role="region" aria-label="{}"'
"""What scrolls can be reached by keyboard, and has a name."""
MOST_FOUND = 3
"""Situations that a search opens in a folded plan."""
TABS = ("Map", "Talk", "Plan", "Events", "Known")


class Watch:
    """One mission in one browser."""

    def __init__(self, house: House, visitor: Visitor, feed: Feed) -> None:
        self.house, self.visitor, self.feed = house, visitor, feed
        self.desk = house.desk
        self.mission = feed.mission
        self.commands = Commands(self.desk, self.mission, visitor, self._latest)
        self.conversation = Conversation()
        self.at: Step | None = None
        self.news = asyncio.Event()
        self.opened: frozenset[NodeId] = frozenset()
        self.whole = False
        self.folds: Mapping[str, frozenset[NodeId]] = {}
        self.policy: Policy | None = None

    # -- layout --------------------------------------------------------------------------------

    def build(self, view: View) -> None:
        """Lay the page out, and show a view."""
        with framed(self.visitor, "mission") as self.main:
            with ui.element("section").classes("head"):
                self.title = Text("h1", view.title)
                with ui.element("div").classes("row"):
                    self.status = Living(tag="span")
                    self.doing = Text("p", classes="doing").props('aria-live="polite"')
                with ui.element("div").classes("row controls"):
                    self._controls()
            Living(panels.tabs(TABS)).classes("tablist")
            with self._panel("map", "Map"):
                self.map = Living()
                Living(panels.legend(legend(view.drawing)))
                self._slider()
            with ui.element("div").classes("side"):
                with self._panel("request", "What was asked for"):
                    self.clauses = Living()
                with self._panel("talk", "Talk"):
                    self._talk()
            with self._panel("plan", "Plan"):
                self._plan()
            with self._panel("events", "Events"):
                self.timeline = (
                    Living().classes("keeps-low scroll").on_pick(lambda step: self._look(int(step)))
                )
            with self._panel("known", "Known"):
                self.known = Living().classes("scroll").props(READ.format("facts"))
        self.player = ui.timer(PLAYED_EVERY, self._next, active=False)
        ui.timer(FADES_EVERY, self._fade)
        self.show(view)

    def _panel(self, name: str, title: str) -> ui.element:
        found = (
            ui.element("section")
            .classes(f"card panel {name}")
            .props(f'id="{name}" aria-labelledby="{name}-title"')
        )
        with found:
            Text("h2", title).props(f'id="{name}-title"')
        return found

    def _controls(self) -> None:
        self.pause = button("Pause", self.commands.pause)
        self.resume = button("Go on", self.commands.resume, "main")
        self.change = button("Change …", self.commands.change)
        self.cancel = button("Cancel …", self.commands.cancel, "danger")

    def _slider(self) -> None:
        with ui.element("div").classes("row replay"):
            self.slider = ui.element("input").props(
                'type="range" min="0" aria-label="moment of the mission"'
            )
            self.slider.on(
                "input", lambda event: self._look(int(event.args)), throttle=0.05,
                js_handler="(event) => emit(event.target.value)",
            )  # fmt: skip
            self.playing = button("Play", self._play, "chip")
            self.live = button("Live", lambda: self._look(None), "chip")
            self.moment = Text("span", classes="when")

    def _plan(self) -> None:
        graph = PolicyGraph(f"{ASSETS}/cytoscape/cytoscape.esm.min.mjs", self._situation)
        self.graph = graph
        with ui.element("div").classes("row") as row:
            search = ui.input(label="Find in the plan").props("outlined dense clearable")
            search.on_value_change(lambda event: self._find(event.value or ""))
            button("Now", graph.here, "chip")
            button("Fit", graph.fit, "chip")
            self.fold = button("Show all", self._unfold, "chip")
        row.move(target_index=1)
        Living(panels.graph_legend())
        self.situation = Text("p", "Choose a box to see what it is about.", "note").props(
            'aria-live="polite"'
        )
        with ui.element("details"):
            Text("summary", "The plan in words")
            self.rules = Text("pre", classes="rules").props('tabindex="0"')

    def _find(self, words: str) -> None:
        """Go to what has some words, and open what holds it."""
        policy, _, _ = walked(self.view.moment)
        if policy is not None and words.strip():
            self.opened |= frozenset(naming(policy, words, self.view.moment.lexicon)[:MOST_FOUND])
            self.news.set()
        self.graph.find(words)

    def _unfold(self) -> None:
        self.whole = not self.whole
        self.opened = frozenset()
        self.fold.set_text("Fold" if self.whole else "Show all")
        self.news.set()

    def _situation(self, picked: str) -> None:
        """Tell what a box of the plan is about, or open one that holds several."""
        policy, _, _ = walked(self.view.moment)
        if policy is None:
            return
        if picked in self.folds:
            self.opened |= {min(self.folds[picked])}
            self.news.set()
        elif picked.isdigit() and int(picked) in policy.by_id:
            self.situation.set_text(situation(policy, int(picked), self.view.moment))

    def _draw_plan(self, view: View) -> None:
        policy, past, present = walked(view.moment)
        if policy is None:
            return
        if self.opened or self.whole:
            lexicon = view.moment.lexicon
            graph = graph_of(policy, past, present, lexicon, opened=self.opened, whole=self.whole)
        else:
            graph = view.once(_folded)
        self.folds = graph.folds
        self.graph.show(graph.to_json())
        self.fold.set_visibility(len(policy.nodes) > PLENTY)
        if policy is not self.policy:
            self.policy = policy
            self.rules.set_text(view.rules(policy))  # long, and the same until planned again

    def _play(self) -> None:
        """Show the mission from its beginning, or from where the slider is, step by step."""
        if self.player.active:
            self.player.deactivate()
        else:
            if self.at is None:
                self._look(0)
            self.player.activate()
        self.playing.set_text("Stop" if self.player.active else "Play")

    def _next(self) -> None:
        if self.at is None:
            self.player.deactivate()
            self.playing.set_text("Play")
        else:
            self._look(self.at + 1)

    def _talk(self) -> None:
        self.talk = Living().classes("keeps-low scroll").props(READ.format("conversation"))
        self.talk.props('aria-live="polite"')
        self.suggested = Living().on_pick(self._suggested)
        heard = Living().props('aria-live="polite"')
        with ui.element("div").classes("row ask"):
            self.question = ui.input(label="Ask, or tell me something").props(
                'outlined dense maxlength=1000 id="ask"'
            )
            self.question.on("keydown.enter.prevent", self._asked)
            button("Ask", self._asked, "main")
        with ui.element("div").classes("row"):
            if self.visitor.may_command:
                dictation = Dictation(self.question, heard)
                dictation.microphone(self.house.missing, mission=self.mission)
            button("Read answers aloud", lambda: None, "chip").props(
                'data-aloud aria-pressed="false"'
            )

    # -- showing -------------------------------------------------------------------------------

    def show(self, view: View) -> None:
        """Bring everything up to date with a view."""
        self.view = view
        past = self.at is not None
        self.main.classes(add="past" if past else "", remove="" if past else "past")
        self.title.set_text(view.title)
        self.status.show(panels.status(view.status))
        self.doing.set_text(view.doing)
        self.map.show(view.map)
        self._draw_plan(view)
        self.clauses.show(view.once(_clauses))
        self.timeline.show(self._timeline(view))
        self._show_known()
        self.talk.show(bubbles(self.feed.talk.turns, view.moment.problem))
        replies = [words for words, _ in self._replies()]
        if replies:
            self.suggested.show(panels.buttons(replies, "answers", "button answer"))
        else:
            self.suggested.show(panels.buttons(view.suggestions, "suggested questions"))
        self.slider.props(f'max="{self.feed.last}" value="{view.step}"')
        self.moment.set_text(f"step {view.step} of {self.feed.last}" if past else "live")
        self.live.set_visibility(past)
        may = self.visitor.may_command and not view.is_over
        self.pause.set_visibility(may and view.status is not Standing.PAUSED)
        self.resume.set_visibility(may and view.status is Standing.PAUSED)
        self.change.set_visibility(may)
        self.cancel.set_visibility(may)

    def _show_known(self) -> None:
        """What is known now; of a moment that is past, as it was known then."""
        view = self.view
        if self.at is not None:
            then = view.moment.asked_at
            self.known.show(panels.known(view.known(then), then, is_past=True))
        elif view.fades:
            self.known.show(_known(view))
        else:
            self.known.show(view.once(_known))

    def _fade(self) -> None:
        """Show what has been known for too long by now, though nothing is new."""
        if self.view.fades and self.at is None:
            self._show_known()

    def _timeline(self, view: View) -> Html:
        turns = self.feed.talk.turns
        if not turns:
            return view.once(_lines)
        return panels.timeline(with_questions(view.lines, turns, view.step))

    async def follow(self) -> None:
        """Show what comes, for as long as there is somebody to see it."""
        while True:
            await self.news.wait()
            self.news.clear()
            self.show(await asyncio.to_thread(self.feed.view, self.at))
            await asyncio.sleep(SLOWEST)

    def _look(self, at: Step | None) -> None:
        self.at = None if at is None or at >= self.feed.last else at
        self.news.set()

    # -- talk ----------------------------------------------------------------------------------

    def _replies(self) -> list[tuple[str, str]]:
        """Answers to what is open between us, each with what is then said."""
        pending = self.conversation.pending
        if pending is None:
            return []
        if pending.status is Status.CLARIFY:
            answers = [each.answer for each in pending.choices]
            numbered = [(each, str(number)) for number, each in enumerate(answers, start=1)]
            return [*numbered, ("None of these", "no")]
        return [("Yes, that is right", "yes"), ("No", "no")]

    async def _suggested(self, place: str) -> None:
        replies = self._replies()
        texts = [said for _, said in replies] or [*self.view.suggestions]
        if int(place) < len(texts):  # it may be another moment by now
            await self._said(texts[int(place)])

    async def _asked(self) -> None:
        text = (self.question.value or "").strip()
        if not text:
            return
        self.question.value = ""
        await self._said(text)

    async def _said(self, text: str) -> None:
        """Take a question, a report, an order or a change of mind."""
        talk, who = self.feed.talk, self.visitor.name
        view = self._latest()
        time = utc_now().isoformat(timespec="milliseconds")
        talk.add(Said(who, text, time=time, step=view.step))
        self.feed.tell()
        order = None if view.is_over else order_in(text)
        if order is not None and not self.visitor.may_command:
            talk.add(Said("robot", "You may look and ask here; an operator commands."))
            self.feed.tell()
            return
        if order is not None:
            await {
                "pause": self.commands.pause,
                "resume": self.commands.resume,
                "cancel": self.commands.cancel,
            }[order]()
            return
        # A question is about the moment that is looked at; what is told is told now.
        about = self.view if self.conversation.pending is None else view
        try:
            said = await asyncio.to_thread(self.conversation.say, text, about.moment)
        except PlainspokenError as error:
            tell(error)
            return
        if not self.visitor.may_command and (said.agreed or said.then.pending):
            self.conversation = Conversation(said.then.dialogue)
            talk.add(Said("robot", "You may look and ask here; an operator tells me things."))
        else:
            self.conversation = said.then
            talk.add(Said("robot", said.answer.text, said.answer))
            if said.agreed is not None:
                await self.commands.tell(said.agreed)
        self.feed.tell()

    def _latest(self) -> View:
        """The mission as it is now, whatever moment of it is looked at."""
        return self.view if self.at is None else self.feed.view()


def _clauses(view: View) -> Html:
    return panels.clauses(view.clauses)


def _lines(view: View) -> Html:
    return panels.timeline(view.lines)


def _known(view: View) -> Html:
    now = utc_now()
    return panels.known(view.known(now), now)


def _folded(view: View) -> Graph:
    policy, past, present = walked(view.moment)
    assert policy is not None  # noqa: S101 - nobody draws a plan before there is one
    return graph_of(policy, past, present, view.moment.lexicon)
