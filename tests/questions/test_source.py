"""Who said so: the answers that rest on what people reported, or had changed."""

from __future__ import annotations

import pytest
from tests.questions.test_change import GOAL, after, begun, change, lexicon, policy_from, site

from plainspoken.logic.syntax import parse
from plainspoken.mission.executive import advance
from plainspoken.mission.observation import Observation
from plainspoken.pipeline import Request, accepted_as
from plainspoken.questions.answer import answer
from plainspoken.questions.conversation import Conversation, message_of
from plainspoken.questions.moment import Moment
from plainspoken.questions.report import understood
from plainspoken.world.event import Entry, Event, Instant


def log_of(*steps: tuple[Instant, tuple[Event, ...]]) -> list[Entry]:
    entries: list[Entry] = []
    for instant, events in steps:
        for event in events:
            time = f"2026-05-01T09:{len(entries):02}:00.000+00:00"
            entries.append(Entry(len(entries), time, instant, event))
    return entries


def reported(*further: Observation) -> list[Entry]:
    """A mission whose line 2 Anna has cleared, and what happened then."""
    now = begun()
    steps = [(now.mission.instant, now.events)]
    told = understood("I cleared line 2 myself", lexicon(), now.mission.world)
    for each in (message_of(told, "Anna"), *further):
        now = advance(now.mission, each)
        steps.append((now.mission.instant, now.events))
    return log_of(*steps)


@pytest.mark.parametrize(
    ("question", "text"),
    [
        ("who cleared line 2?", 'Anna reported it at 09:03: "I cleared line 2 myself".'),
        (
            "how do you know that line 2 is cleared?",
            'Anna reported it at 09:03: "I cleared line 2 myself".',
        ),
        ("who says that line 2 is cleared?", "Anna reported it"),
        ("what did Anna report?", 'told by Anna at 09:03: "I cleared line 2 myself".'),
        ("what has been reported?", "told by Anna"),
        ("how do you know that the box is not full?", "From the start"),
    ],
)
def test_what_people_reported_is_told_with_their_name_and_the_time(
    question: str, text: str
) -> None:
    found = answer(question, reported())
    assert text in found.text
    assert found.evidence


def test_what_the_robot_did_itself_is_told_as_its_own() -> None:
    now = begun()
    steps = [(0, now.events)]
    for _ in range(6):
        now = after(now, 1)
        steps.append((now.mission.instant, now.events))
    entries = log_of(*steps)
    assert "I checked grape 3 at 09:" in answer("who checked grape 3?", entries).text
    assert answer("what has been reported?", entries).text == (
        "Nobody has reported anything so far."
    )


def test_why_something_is_not_done_names_who_had_it_skipped() -> None:
    now = after(begun(), 1)
    steps = [(0, begun().events), (1, now.events)]
    asked = advance(now.mission, message_of(change("skip line 3", now.mission), "Bea"))
    steps.append((1, asked.events))
    done = after(asked, 1)
    steps.append((2, done.events))
    taken = advance(done.mission, policy_from(done.mission, "F cleared_l2 & G !robot_at_rob_l1"))
    steps.append((2, taken.events))
    for question in ("Why aren't you doing line 3?", "Why did you skip line 3?"):
        assert "Because Bea told me at 09:0" in answer(question, log_of(*steps)).text
    assert "Bea" not in answer("Why aren't you doing line 2?", log_of(*steps)).text


def moment() -> Moment:
    accepted = accepted_as(site(), Request("m", parse(GOAL)))
    return Moment(log_of((0, (accepted, *begun().events[1:]))))


def test_a_report_in_a_conversation_is_said_back_and_agreed_to() -> None:
    said = Conversation().say("I cleared line 2 myself", moment())
    assert said.answer.text == "I understand: line 2 is cleared. Is that right?"
    assert said.agreed is None
    assert said.then.say("no", moment()).agreed is None
    agreed = said.then.say("yes", moment()).agreed
    assert agreed is not None
    again = said.then.say("What are you doing?", moment())
    assert again.agreed is None
    assert again.then.pending is None


def test_a_question_in_a_conversation_is_answered_by_number_or_by_name() -> None:
    said = Conversation().say("I checked grape 1", moment())
    assert "(2) grape 1 is unripe" in said.answer.text
    for words in ("2", "the second", "unripe"):
        then = said.then.say(words, moment())
        assert then.agreed is not None, words
        assert then.answer.text.startswith("Noted: grape 1 is unripe")


def test_a_change_of_mind_in_a_conversation_is_said_back_and_agreed_to() -> None:
    said = Conversation().say("skip line 3", moment())
    assert said.answer.text.startswith("From now on: Make sure that line 2 is cleared")
    assert said.then.say("yes please", moment()).agreed is not None
