"""What is not known is said as such, with what was known last, and never as if it were so."""

from dataclasses import replace
from datetime import UTC, datetime, timedelta

import pytest
from tests.mission.store_room import GOAL, SITE

from plainspoken.pipeline import Request, accepted_as
from plainspoken.questions.answer import answer_at
from plainspoken.questions.claim import Answer
from plainspoken.questions.dialogue import Dialogue
from plainspoken.questions.moment import Moment
from plainspoken.world.event import Entry, ObservationMade, ReportReceived
from plainspoken.world.sense import Sense, senses_to_json

START = datetime(2026, 11, 22, 10, tzinfo=UTC)
SENSES = senses_to_json(
    [Sense("full {p}", ("camera",), 600.0, needed=True), Sense("in {x} {p}", ("camera",))]
)
ACCEPTED = accepted_as(SITE, Request("m", GOAL, robot={"senses": SENSES}))


def log(*told: tuple[str, bool | None]) -> list[Entry]:
    """A log in which a camera told these facts, a minute each."""
    entries = [Entry(0, START.isoformat(), 0, ACCEPTED)]
    state = ACCEPTED.state
    for step, (atom, holds) in enumerate(told, start=1):
        if holds is not None:
            state = state | {atom} if holds else state - {atom}
        time = (START + timedelta(minutes=step)).isoformat()
        sensed = ({"atom": atom, "holds": holds, "by": "camera", "time": time},)
        entries.append(Entry(step, time, 0, ObservationMade("camera", (), (), state, sensed)))
    return entries


def asked(question: str, entries: list[Entry], *, minutes: float) -> Answer:
    return answer_at(question, Moment(entries, now=START + timedelta(minutes=minutes)))


def test_what_nobody_said_is_not_known() -> None:
    found = asked("Is the ramp full?", log(), minutes=1)
    assert found.text == (
        "I don't know whether the ramp is full: nobody has told me, and I haven't looked."
    )
    assert not found.known
    assert found.wanted == ("full ramp",)
    assert not found.claims
    assert not found.denied


def test_what_was_seen_too_long_ago_is_said_with_its_age_and_not_as_so() -> None:
    found = asked("Is the ramp full?", log(("full ramp", False)), minutes=13)
    assert (
        found.text
        == "I don't know any more; I last saw twelve minutes ago that the ramp wasn't full."
    )
    assert not found.claims
    assert not found.denied
    assert 1 in found.evidence


def test_it_is_known_while_it_is_fresh() -> None:
    found = asked("Is the ramp full?", log(("full ramp", True)), minutes=5)
    assert found.text == "Yes, the ramp is full, as I saw four minutes ago."
    assert [claim.fluent for claim in found.claims] == ["full ramp"]


def test_a_look_that_could_tell_nothing_is_said() -> None:
    found = asked("Is the ramp full?", log(("full ramp", None)), minutes=5)
    assert "I looked, and couldn't tell" in found.text
    assert 1 in found.evidence


@pytest.mark.parametrize(
    ("question", "text"),
    [
        ("Where is the parcel?", "I don't know whether the parcel is in the blue room or"),
        ("How many rooms are full?", "None that I know of. I don't know whether the ramp is full."),
        ("Which rooms are locked?", "None that I know of."),
        (
            "Which rooms are not full?",
            "The blue room, the hall and the red room aren't full. I don't",
        ),
        ("Since when is the ramp full?", "I don't know whether the ramp is full"),
    ],
)
def test_lists_and_counts_tell_what_is_known_from_what_is_not(question: str, text: str) -> None:
    found = asked(question, log(), minutes=1)
    assert found.text.startswith(text)
    about = {"full ramp", "in parcel red-room", "in parcel blue-room", "locked red-room"}
    assert not about & {claim.fluent for claim in (*found.claims, *found.denied)}
    assert about & set(found.wanted)


def test_where_a_fact_is_known_from_is_told() -> None:
    seen = log(("full ramp", True))
    found = asked("How do you know that the ramp is full?", seen, minutes=3)
    assert found.text == "I saw it two minutes ago, through camera: the ramp is full."
    assert 1 in found.evidence
    report = ReportReceived(
        "Ada", "", (), (), seen[1].event.state, ({"atom": "full ramp", "holds": True},)
    )  # type: ignore[union-attr]
    told = [*seen, replace(seen[1], step=2, event=report)]
    # Since when it is so, and from whom, stays; it was only heard of again.
    assert asked("Who told you that the ramp is full?", told, minutes=3).claims == found.claims


def test_how_do_you_know_speaks_of_the_answer_before() -> None:
    moment = Moment(log(("full ramp", True)), now=START + timedelta(minutes=3))
    _, dialogue = Dialogue().ask("Is the ramp full?", moment)
    found, _ = dialogue.ask("How do you know?", moment)
    assert found.text == "I saw it two minutes ago, through camera: the ramp is full."
    alone, _ = Dialogue().ask("How do you know?", moment)
    assert not alone.known


def test_the_past_is_not_claimed_of_what_was_only_assumed() -> None:
    moment = Moment(log(), now=START)
    assert "in parcel red-room" in moment.believed
    assert "in parcel red-room" not in moment.state
    assert "in parcel red-room" not in moment.runs
