import json
from collections.abc import Sequence
from pathlib import Path

import pytest
from tests.evaluation.small_corpus import small_rows

from plainspoken.evaluation.experiment import Outcome, Result, run_experiment
from plainspoken.evaluation.translation import WithModel, embedded
from plainspoken.language.completion import CompletionError, Message, Schema
from plainspoken.language.second_opinion import Mode, SecondOpinion

HALL = json.dumps(
    {
        "expressions": [{"text": "the hall", "symbol": "hall"}],
        "readings": [{"literal": "F hall", "executable": "F hall"}],
    }
)


class Told:
    """A model that says one thing after the other, and counts."""

    def __init__(self, *replies: str) -> None:
        self.replies = list(replies)

    def __call__(self, _messages: Sequence[Message], _schema: Schema, /) -> str:
        if not self.replies:
            raise CompletionError("the model has gone home")
        return self.replies.pop(0)


def result_of(folder: Path, model: Told, mode: Mode = Mode.LLM) -> Result:
    opinion = WithModel(SecondOpinion(model, mode))
    ((result, _),) = run_experiment(small_rows(folder)[:1], mode, opinion)
    return result


def test_the_embedded_translator_needs_no_model(tmp_path: Path) -> None:
    ((result, _),) = run_experiment(small_rows(tmp_path)[:1], "embedded", embedded)
    assert result.outcome is Outcome.RIGHT


@pytest.mark.parametrize("mode", [Mode.LLM, Mode.BOTH])
def test_a_sentence_is_asked_of_the_model_once(mode: Mode, tmp_path: Path) -> None:
    model = Told(HALL, "never said")
    assert result_of(tmp_path, model, mode).outcome is Outcome.RIGHT
    assert model.replies == ["never said"]


def test_a_reply_may_be_corrected_as_in_use(tmp_path: Path) -> None:
    assert result_of(tmp_path, Told("F hall", HALL)).outcome is Outcome.RIGHT


@pytest.mark.parametrize(
    ("model", "reason"),
    [(Told(), "gone home"), (Told("a", "b", "c"), "not one JSON object")],
    ids=["no reply", "no reply of use"],
)
def test_the_embedded_translator_does_not_stand_in_for_a_model_that_fails(
    model: Told, reason: str, tmp_path: Path
) -> None:
    result = result_of(tmp_path, model)
    assert result.outcome is Outcome.FAILED
    assert reason in (result.reason or "")
