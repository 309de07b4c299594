"""A model reads text back to fluents: what it may say, and what is refused."""

import json
from collections.abc import Sequence
from typing import Any

import pytest
from tests.questions.asked import lexicon
from tests.questions.test_fluents import ROWS, _fluent

from plainspoken.language.completion import CompletionError, Message, Schema
from plainspoken.questions.fluents import Fluent, Time
from plainspoken.questions.model_reading import fluents_by_model

LEXICON = lexicon("vineyard")


class Scripted:
    """A model that says what it is told to, and keeps what it was asked."""

    def __init__(self, *replies: str) -> None:
        self._replies = iter(replies)
        self.asked: list[Sequence[Message]] = []

    def __call__(self, messages: Sequence[Message], schema: Schema, /) -> str:
        self.asked.append(tuple(messages))
        return next(self._replies)


def _said(fact: str, *, holds: Any = True, time: str = "now", offset: Any = None) -> str:
    fluent = {"fact": fact, "holds": holds, "time": time, "offset": offset}
    return json.dumps({"fluents": [fluent]})


def test_a_model_is_told_the_facts_and_the_text_and_chooses_among_them() -> None:
    model = Scripted(_said("full b", time="was", offset=-2))
    assert fluents_by_model("The bin was full.", LEXICON, model) == (
        Fluent("full b", time=Time.WAS, offset=-2),
    )
    task, text = model.asked[0]
    assert "full b: the box is full" in task.text
    assert text.text == "The bin was full."


@pytest.mark.parametrize(
    ("reply", "fault"),
    [
        ("Sure! full b", "no JSON"),
        ("[]", "no list of fluents"),
        (_said("on-fire barn"), "no fact 'on-fire barn'"),
        (_said("full b", time="yesterday"), "no time 'yesterday'"),
        (_said("full b", offset="two"), "no number of actions"),
        (_said("full b", offset=True), "no number of actions"),
        ('{"fluents": ["full b"]}', "is no fluent"),
    ],
)
def test_a_reply_that_is_wrong_is_sent_back_once_and_then_refused(reply: str, fault: str) -> None:
    mended = Scripted(reply, _said("full b"))
    assert fluents_by_model("The box is full.", LEXICON, mended) == (Fluent("full b"),)
    assert fault in mended.asked[1][-1].text
    with pytest.raises(CompletionError, match="cannot be used"):
        fluents_by_model("The box is full.", LEXICON, Scripted(reply, reply))


def test_a_model_that_reads_the_gold_sentences_rightly_scores_full_marks() -> None:
    for setting, gold, text in ROWS:
        wanted = {_fluent(each.strip()) for each in gold.split(",") if each.strip()}
        fluents = [
            {"fact": f.atom, "holds": f.holds, "time": f.time.value, "offset": f.offset}
            for f in wanted
        ]
        model = Scripted(json.dumps({"fluents": fluents}))
        assert set(fluents_by_model(text, lexicon(setting), model)) == wanted, text
