"""Questions that were written before the rules, or without a look at them, over four domains."""

from pathlib import Path
from random import Random

import pytest
from tests.questions.judge import Judge
from tests.questions.missions import FURTHER, SETTINGS, accepted, run

from plainspoken.questions.answer import answer_at
from plainspoken.questions.moment import Moment, lexicon_of
from plainspoken.questions.question import question_of

ROWS = tuple(
    tuple(part.strip() for part in line.split("|"))
    for line in (Path(__file__).parent / "asked.txt").read_text().splitlines()
    if line and not line.startswith("#")
)
LEXICA = {
    name: lexicon_of(accepted({**SETTINGS, **FURTHER}[name]))
    for name in ("vineyard", "depot", "soup", "kitchen")
}
NOT_YET = {
    "Describe what you are at right now.",  # "at" is taken for a place
    "Why did the stove go out?",  # to go is what the robot does there
    "Why does the fridge stand open?",  # so is to open
    "You're not going into line 3, are you?",
    "Is work in progress?",
}
"""Questions that are still taken for another kind."""


@pytest.mark.parametrize(("setting", "kind", "objects", "text"), ROWS)
def test_an_unseen_question_is_of_its_kind(
    setting: str, kind: str, objects: str, text: str
) -> None:
    question = question_of(text, LEXICA[setting])
    right = (str(question.kind), set(question.referents.objects)) == (kind, set(objects.split()))
    assert right != (text in NOT_YET)


@pytest.mark.parametrize("name", ["reacting", "depot", "soup", "kitchen"])
def test_no_answer_to_them_claims_what_is_not_so(name: str) -> None:
    asked = {"reacting": "vineyard"}.get(name, name)
    texts = [text for setting, _, _, text in ROWS if setting == asked]
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
