"""Text back to fluents: sentences written by hand, each with the fluents that it states."""

import re
from pathlib import Path

import pytest
from tests.questions.asked import lexicon
from tests.questions.missions import run

from plainspoken.questions.answer import answer_at
from plainspoken.questions.fluents import Fluent, Time, fluents_in, read
from plainspoken.questions.length import Length
from plainspoken.questions.moment import Moment

NOT_YET = {"The atlas is back in its place."}
"""Sentences that are not read as they should be."""
_GOLD = re.compile(r"(?:(was|will|may|start|end|never)([+-]\d+)?:)?(!)?(.+)")


def _fluent(text: str) -> Fluent:
    found = _GOLD.fullmatch(text)
    assert found is not None, text
    time = Time(found[1] or "now")
    offset = int(found[2]) if found[2] else None
    return Fluent(found[4], not found[3] and time is not Time.NEVER, time, offset)


ROWS = [
    tuple(part.strip() for part in line.split("|"))
    for line in (Path(__file__).parent / "sentences.txt").read_text().splitlines()
    if not line.startswith("#")
]


@pytest.mark.parametrize(
    ("setting", "gold", "text"), ROWS, ids=[f"{row[0]}: {row[2]}" for row in ROWS]
)
def test_a_sentence_states_its_fluents_and_no_others(setting: str, gold: str, text: str) -> None:
    wanted = {_fluent(each.strip()) for each in gold.split(",") if each.strip()}
    assert (set(fluents_in(text, lexicon(setting))) == wanted) != (text in NOT_YET)


def test_what_cannot_be_read_is_said_and_not_guessed() -> None:
    reading = read("The box is full. The barn is on fire.", lexicon("vineyard"))
    assert reading.fluents == (Fluent("full b"),)
    assert reading.unread == ("the barn is on fire",)


@pytest.mark.parametrize("name", ["vineyard", "depot", "soup", "hospital", "reading_room"])
def test_what_is_read_in_an_answer_about_now_is_so(name: str) -> None:
    entries = run(name, 3, most=40)
    for at in range(1, len(entries), 5):
        moment = Moment(entries, at)
        said = answer_at("What is the situation?", moment, length=Length.FULL).text
        for fluent in fluents_in(said, moment.lexicon):
            if fluent.time is Time.NOW:
                assert fluent.holds == (fluent.atom in moment.whole(moment.state)), said


@pytest.mark.parametrize(
    ("fluent", "instants"),
    [
        (Fluent("full b"), [4]),
        (Fluent("full b", time=Time.WAS), [0, 1, 2, 3]),
        (Fluent("full b", time=Time.WAS, offset=-2), [2]),
        (Fluent("full b", time=Time.START), [0]),
        (Fluent("full b", time=Time.WILL), [5, 6]),
        (Fluent("full b", time=Time.END), [6]),
        (Fluent("full b", holds=False, time=Time.NEVER), [0, 1, 2, 3, 4]),
    ],
)
def test_a_time_is_a_span_of_instants(fluent: Fluent, instants: list[int]) -> None:
    assert list(fluent.instants(now=4, last=6)) == instants
