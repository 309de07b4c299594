"""One mission at one step of its log, as everything that the page shows of it.

A view is made from the entries alone, so that the present and any moment of the past are shown by
the same code. All words come from `questions`; here they are only put in order.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import datetime
from functools import cached_property
from typing import Any, TypeVar

from plainspoken.automata.verdict import Verdict
from plainspoken.knowledge.facts import Fact, Facts, Knowledge, facts_after
from plainspoken.logic.english import say
from plainspoken.logic.formula import conjunction
from plainspoken.mission.mission import Status
from plainspoken.planning.diagram import rules
from plainspoken.planning.policy import Policy
from plainspoken.questions.chronicle import Line, chronicle, ended_because
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.moment import Moment
from plainspoken.questions.morphology import listed, sentence
from plainspoken.questions.narration import present_deed
from plainspoken.web.page.drawing import Drawing, Scene
from plainspoken.web.page.markup import Html
from plainspoken.world.domain import GroundAction
from plainspoken.world.event import ChangeRequested, Entry, Step

Made = TypeVar("Made")


@dataclass(frozen=True, slots=True)
class Clause:
    """One part of the request, in words, with what is known of it."""

    english: str
    verdict: Verdict


@dataclass(frozen=True, slots=True)
class Known:
    """A fact in words, with what is known of it, and the things that it is about."""

    text: str
    knowledge: Knowledge
    things: tuple[str, ...]

    @property
    def fact(self) -> Fact:
        return self.knowledge.fact


class View:
    """What there is to see of a mission at a step of its log."""

    def __init__(self, entries: Sequence[Entry], drawing: Drawing, at: Step | None = None) -> None:
        self.moment = Moment(entries, at)
        self.entries = self.moment.entries
        self.drawing = drawing
        self._made: dict[Callable[[View], Any], Any] = {}

    def once(self, make: Callable[[View], Made]) -> Made:
        """What is made of this view, made once for all who look at it."""
        if make not in self._made:
            self._made[make] = make(self)
        made: Made = self._made[make]
        return made

    @property
    def step(self) -> Step:
        """The last step that is known."""
        return self.entries[-1].step

    @property
    def title(self) -> str:
        """What was asked for, as it was said."""
        mission = self.moment.mission
        return mission.sentence or mission.english or mission.goal

    @cached_property
    def status(self) -> Status:
        moment = self.moment
        if moment.ended is not None:
            return Status(moment.ended.outcome)
        if moment.paused:
            return Status.PAUSED
        return Status.PLANNING if moment.chosen is None else Status.RUNNING

    @property
    def is_over(self) -> bool:
        return self.moment.ended is not None

    @cached_property
    def doing(self) -> str:
        """What goes on, in a sentence."""
        moment = self.moment
        if moment.ended is not None:
            reached = moment.certain[1] if moment.certain else None
            told = "everything asked for is satisfied" if moment.ended.satisfied else (
                ended_because(moment.ended, reached, moment.lexicon)
                or "not everything asked for is satisfied"
            )  # fmt: skip
            return sentence(f"{moment.ended.outcome}: {told}")
        if moment.started is not None:
            doing = [present_deed(moment.lexicon.deed(action)) for action in self.actions]
            if len(doing) == 1 and moment.doing:
                doing = [f"{doing[0]} ({moment.doing})"]
            waiting = ", and then I pause" if moment.paused else ""
            return sentence(listed(doing) + waiting)
        if moment.paused:
            return "I've paused, and wait until I'm told to go on."
        return "I'm deciding what to do next."

    @property
    def actions(self) -> tuple[GroundAction, ...]:
        """What goes on, that which was begun first before what other robots do beside it."""
        started = self.moment.started
        beside = tuple(each.action for _, each in self.moment.beside)
        return () if started is None else (started.action, *beside)

    @cached_property
    def map(self) -> Html:
        return self.drawing.svg(Scene(self.moment.whole(self.moment.state), self.actions))

    @cached_property
    def lines(self) -> tuple[Line, ...]:
        """What happened, the oldest first."""
        return chronicle(self.entries, self.moment.lexicon)

    @cached_property
    def clauses(self) -> tuple[Clause, ...]:
        """The parts of the request, as they are asked for now."""
        landmarks = self.moment.lexicon.landmarks
        return tuple(
            Clause(say(conjunction(*(p.formula for p in each.parts)), landmarks), each.verdict)
            for each in self.moment.demands
        )

    @cached_property
    def change_asked(self) -> ChangeRequested | None:
        """What somebody wants instead, where that is not settled yet."""
        for entry in reversed(self.entries):
            if entry.kind in ("request_changed", "change_refused", "mission_ended"):
                return None
            if isinstance(entry.event, ChangeRequested):
                return entry.event
        return None

    def rules(self, policy: Policy) -> str:
        """What a policy does when, in words."""
        lexicon = self.moment.lexicon
        return rules(
            policy,
            action=lambda action: lexicon.deed(action).bare,
            atom=lambda atom: lexicon.clause(atom).said(),
        )

    @cached_property
    def facts(self) -> Facts:
        return facts_after(self.entries)

    def known(self, at: datetime) -> tuple[Known, ...]:
        """Every fact that could be otherwise and was ever true, looked at or unknown; latest first.

        at: when it is looked at: what was seen too long before is not known any more
        """
        objects = self.moment.problem.objects
        found = [
            Known(
                sentence(_in_words(each, self.moment.lexicon)),
                each,
                tuple(word for word in each.fact.atom.split()[1:] if word in objects),
            )
            for each in self.facts.all_known(at)
            if each.fact.atom not in self.facts.static
        ]
        return tuple(sorted(found, key=lambda each: (-each.fact.step, each.text)))

    @property
    def fades(self) -> bool:
        """Whether facts are known for a while only."""
        return bool(self.facts.senses)

    @cached_property
    def suggestions(self) -> tuple[str, ...]:
        """Questions that fit the moment."""
        moment, lexicon = self.moment, self.moment.lexicon
        deeds = [each.action for each in moment.happenings]
        if self.status is Status.PLANNING:
            return ("Where are you?",)
        if self.is_over:
            found = ["What did you do?", "Did you do everything I asked for?"]
        elif moment.started is not None:
            found = ["What are you doing now?", "Why?", "What will you do next?"]
        else:
            found = ["What did you do last?", "What will you do next?"]
        if moment.deviations:
            found.append("What went wrong?")
        if deeds:
            found.append(f"Why did you {lexicon.deed(deeds[-1]).bare}?")
        found.append("How far are you?" if not self.is_over else "How did it end?")
        return tuple(dict.fromkeys(found))[:5]


def _in_words(known: Knowledge, lexicon: Lexicon) -> str:
    """What is known, was known, or is not known of a fact."""
    clause, fact = lexicon.clause(known.fact.atom), known.fact
    if fact.holds is None:
        return f"whether {clause.said()}"
    if known.is_stale:
        return f"{clause.said('was', negative=not fact.holds)}, when I last knew"
    return clause.said(negative=not fact.holds)


def age(then: str, now: datetime) -> str:
    """How long ago something was: `12 s`, `5 min`, `3 h`, `2 d`."""
    seconds = max(0.0, (now - datetime.fromisoformat(then)).total_seconds())
    for size, unit in ((86400, "d"), (3600, "h"), (60, "min")):
        if seconds >= size:
            return f"{seconds / size:.0f} {unit}"
    return f"{seconds:.0f} s"
