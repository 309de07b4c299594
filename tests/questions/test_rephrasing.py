"""A language model may rephrase and never add: kind models pass, hostile ones reach nobody."""

import json
import re
from collections.abc import Sequence
from random import Random

import pytest
from tests.questions.hostile import Hostile
from tests.questions.missions import run, written_run
from tests.questions.test_soundness import QUESTIONS

from plainspoken.language.completion import Message, Schema
from plainspoken.questions.answer import answer_at
from plainspoken.questions.moment import Moment
from plainspoken.questions.rephrasing import rephrased

FULL = Moment(written_run("ripe g0", "full b", "ripe g1", "in-hand g1"))


def _saying(*texts: str):  # noqa: ANN202 - a model, as the Protocol has it
    replies = iter(texts)

    def model(_messages: Sequence[Message], _schema: Schema, /) -> str:
        return json.dumps({"text": next(replies)})

    return model


@pytest.mark.parametrize(
    ("question", "text"),
    [
        (
            "Is the box full?",
            "Well, yes, the bin has actually been full{rest}",
        ),
        (
            "What did you do last?",
            "Oh well, I picked grape 1{rest}",
        ),
    ],
)
def test_warmer_words_for_the_same_claims_are_said(question: str, text: str) -> None:
    answer = answer_at(question, FULL)
    said = text.replace(
        "{rest}", answer.text.partition("full" if "box" in question else "grape 1")[2]
    )
    found = rephrased(answer, FULL, _saying(said))
    assert (found.text, found.fell_back) == (said, False), found.attempts


@pytest.mark.parametrize(
    ("said", "fault"),
    [
        ("The box is full and line 3 is cleared.", "it adds (cleared l3), now"),
        ("The box isn't full.", "it drops (full b), now"),
        ("Your prompt was to be warm.", "it uses the word 'prompt'"),
    ],
)
def test_what_is_wrong_is_named(said: str, fault: str) -> None:
    found = rephrased(answer_at("Is the box full?", FULL), FULL, _saying(said, said))
    assert found.fell_back
    assert fault in found.attempts[0].faults


def test_a_model_gets_one_more_try_and_then_the_computed_words_stand() -> None:
    answer = answer_at("Is the box full?", FULL)
    again = rephrased(answer, FULL, _saying("The box is empty.", f"Well, {answer.text}"))
    assert (len(again.attempts), again.text) == (2, f"Well, {answer.text}")
    never = rephrased(answer, FULL, _saying("It is empty.", "It is empty."))
    assert (len(never.attempts), never.text) == (2, answer.text)


def test_a_reply_that_is_no_json_is_no_text() -> None:
    answer = answer_at("Is the box full?", FULL)
    found = rephrased(answer, FULL, lambda _messages, _schema: "Sure! The box is full.")
    assert found.text == answer.text


def _letters(text: str) -> list[str]:
    """An own idea of what was said: its words in order, without articles and marks."""
    words = re.findall(r"\w+", text.lower().replace("n't", " not"))
    return [word for word in words if word not in ("the", "a", "an", "and", "at", "of", "now")]


def test_nothing_of_a_hostile_model_reaches_the_person() -> None:
    trials = fallbacks = 0
    for name in ("vineyard", "depot", "soup", "hospital", "reading_room"):
        entries = run(name, 1, most=40)
        for at in range(2, len(entries), max(1, len(entries) // 9))[:9]:
            moment = Moment(entries, at)
            for number, question in enumerate(QUESTIONS):
                answer = answer_at(question, moment)
                model = Hostile(moment.lexicon, Random(f"{name} {at} {number}"))
                found = rephrased(answer, moment, model)
                trials += 1
                fallbacks += found.fell_back
                assert _letters(found.text) == _letters(answer.text), (model.said, answer.text)
    assert trials >= 500
    assert fallbacks > trials / 2  # Some twists find nothing to twist.
