"""Questions that people put before the rules were made for them and the listener learned them."""

from pathlib import Path
from random import Random

import pytest
from tests.questions.asked import Asked, asked_in
from tests.questions.judge import Judge
from tests.questions.missions import run

from plainspoken.questions.answer import answer_at
from plainspoken.questions.moment import Moment

FOLDER = Path(__file__).parent
QUESTIONS = tuple(
    each
    for name in ("asked", "people", "people_again")
    for each in asked_in(FOLDER / f"{name}.txt")
)


@pytest.mark.parametrize("asked", QUESTIONS, ids=lambda each: each.text)
def test_a_question_that_was_learned_from_is_of_its_kind(asked: Asked) -> None:
    assert asked.understood, asked.taken_for


@pytest.mark.parametrize(
    "name", ["reacting", "depot", "soup", "kitchen", "hospital", "reading_room"]
)
def test_no_answer_to_them_claims_what_is_not_so(name: str) -> None:
    asked = {"reacting": "vineyard"}.get(name, name)
    texts = [each.text for each in QUESTIONS if each.setting == asked]
    for seed in range(2):
        entries = run(name, seed, most=60)
        chance = Random(seed)
        steps = [*chance.sample(range(1, len(entries)), 3), len(entries) - 1]
        for at in steps:
            moment, judge = Moment(entries, at), Judge(entries, at)
            for text in texts:
                found = answer_at(text, moment).to_json(0, text, 0.0)
                assert judge.failures(found) == [], (text, at, found["answer"])
                assert found["answer"], text
                assert "(" not in found["answer"], text
                assert "there is a next step" not in found["answer"], text
