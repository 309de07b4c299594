"""What is said on the page of one mission: questions, answers, and what was done about them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from plainspoken.questions.chronicle import Line
from plainspoken.questions.claim import Answer
from plainspoken.web.page.markup import Html, tag
from plainspoken.world.domain import Problem
from plainspoken.world.event import Step

MOST_TURNS = 200


@dataclass(frozen=True, slots=True)
class Said:
    """One thing that was said, at a time and a step of the log.

    answer: where the mission said it, what that rests on; None where it rests on nothing
    time:   when a person said it; empty where the mission did
    """

    who: str
    text: str
    answer: Answer | None = None
    time: str = ""
    step: Step = 0

    @property
    def is_by_person(self) -> bool:
        return bool(self.time)


@dataclass
class Talk:
    """All that was said about one mission here, by whomever."""

    turns: list[Said] = field(default_factory=list)

    def add(self, *said: Said) -> None:
        """Note what was said; of very much, the latest."""
        self.turns.extend(said)
        del self.turns[:-MOST_TURNS]


def with_questions(lines: Sequence[Line], turns: Sequence[Said], last: Step) -> list[Line]:
    """The lines of a log, and among them what people said of it up to a step."""
    asked = [
        Line(each.step, (), each.time, 0, "person", f'{each.who} said: "{each.text}"')
        for each in turns
        if each.is_by_person and each.step <= last
    ]
    return sorted([*lines, *asked], key=lambda line: (line.going, line.time)) if asked else [*lines]


def bubbles(turns: Sequence[Said], problem: Problem) -> Html:
    """A conversation, in which an answer points at what it rests on."""
    return tag("ol", *(_bubble(i, each, problem) for i, each in enumerate(turns)), class_="turns")


def _bubble(number: int, said: Said, problem: Problem) -> Html:
    answer = said.answer
    if answer is None:
        own, kind = tag("span", said.who, class_="who"), "person" if said.is_by_person else "robot"
        return tag("li", own, tag("p", said.text), class_=kind, data_key=f"turn {number}")
    steps = [each for each in answer.evidence if isinstance(each, int)]
    nodes = [str(each).split()[-1] for each in answer.evidence if isinstance(each, str)]
    spoken = [claim.fluent for claim in (*answer.claims, *answer.denied)]
    spoken += [claim.action for claim in answer.actions]
    things = sorted({w for atom in spoken for w in atom.split()[1:] if w in problem.objects})
    rests = len(steps) + len(nodes)
    return tag(
        "li",
        tag("span", said.who, class_="who"),
        tag("p", said.text),
        tag("button", f"rests on {rests} {'place' if rests == 1 else 'places'} of the record",
            type="button", class_="evidence", data_light=True,
            aria_label="show what this answer rests on") if rests else None,
        class_="robot",
        data_key=f"turn {number}",
        data_steps=" ".join(map(str, steps)),
        data_nodes=" ".join(nodes),
        data_things=" ".join(things),
    )  # fmt: skip
