import json
from pathlib import Path
from typing import Any

import pytest
from tests.evaluation.small_corpus import small_rows, written

from plainspoken.errors import InputFileError
from plainspoken.evaluation.batch import FromReplies, read_replies, requests
from plainspoken.evaluation.corpus import Row
from plainspoken.evaluation.experiment import Outcome, Result, run_experiment
from plainspoken.language.prompting import RESPONSE_SCHEMA


def reply_to(id: str, content: str | None, **message: Any) -> dict[str, Any]:
    body = {"choices": [{"message": {"role": "assistant", "content": content, **message}}]}
    return {"custom_id": id, "response": {"status_code": 200, "body": body}, "error": None}


def said(formula: str, executable: str, *expressions: tuple[str, str]) -> str:
    return json.dumps(
        {
            "expressions": [{"text": text, "symbol": symbol} for text, symbol in expressions],
            "readings": [{"literal": formula, "executable": executable}],
        }
    )


GOOD = [
    reply_to(
        "three",
        said(
            "!attic U cellar", "!attic W cellar", ("the attic", "attic"), ("the cellar", "cellar")
        ),
    ),
    reply_to("one", said("F hall", "F hall", ("the hall", "hall"))),
    reply_to(
        "two",
        said(
            "F(attic & F hall)", "F(attic & F hall)", ("The hall", "hall"), ("the attic", "attic")
        ),
    ),
]


def scored(rows: tuple[Row, ...], path: Path) -> list[Result]:
    translate = FromReplies(read_replies(path, {row.id for row in rows}))
    return [result for result, _ in run_experiment(rows, "batch", translate, timed=False)]


def test_a_request_is_as_the_batch_api_wants_it(tmp_path: Path) -> None:
    rows = small_rows(tmp_path)
    lines = [json.loads(json.dumps(each)) for each in requests(rows, "some-model")]
    assert [line["custom_id"] for line in lines] == ["one", "two", "three"]
    first = lines[0]
    assert (first["method"], first["url"]) == ("POST", "/v1/chat/completions")
    body = first["body"]
    assert (body["model"], body["temperature"]) == ("some-model", 0)
    assert {each["role"] for each in body["messages"]} == {"system", "user", "assistant"}
    assert "Go to the hall." in body["messages"][-1]["content"]
    assert body["response_format"]["type"] == "json_schema"
    assert body["response_format"]["json_schema"]["schema"] == RESPONSE_SCHEMA
    assert body["response_format"]["json_schema"]["strict"] is True


def test_the_gold_is_not_in_a_request(tmp_path: Path) -> None:
    row = small_rows(tmp_path)[2]
    (request,) = requests((row,), "m")
    assert "!attic" not in json.dumps(request)


def test_replies_are_scored_like_any_run_in_the_order_of_the_corpus(tmp_path: Path) -> None:
    rows = small_rows(tmp_path)
    one, two, three = scored(rows, written(tmp_path / "out.jsonl", GOOD))
    assert [each.id for each in (one, two, three)] == ["one", "two", "three"]
    assert (one.outcome, three.outcome) == (Outcome.RIGHT, Outcome.RIGHT)
    assert two.outcome is Outcome.WRONG_FORMULA
    assert one.mentions is not None
    assert one.mentions.recall.value == 1
    assert one.seconds is None


@pytest.mark.parametrize(
    ("reply", "reason"),
    [
        (None, "no reply to this sentence"),
        (
            {"custom_id": "one", "response": None, "error": {"message": "batch expired"}},
            "batch expired",
        ),
        (
            {
                "custom_id": "one",
                "response": {"status_code": 429, "body": {"error": {"message": "slow down"}}},
            },
            "slow down",
        ),
        ({"custom_id": "one", "response": {"status_code": 500, "body": "?"}}, "status 500"),
        ({"custom_id": "one", "response": {"status_code": 200, "body": {}}}, "empty"),
        (reply_to("one", None, refusal="I would rather not"), "I would rather not"),
        (reply_to("one", "F hall"), "not one JSON object"),
        (reply_to("one", said("F garden", "F garden", ("the hall", "garden"))), "garden"),
        (reply_to("one", said("F (hall", "F hall", ("the hall", "hall"))), "not an LTLf"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_a_request_that_got_nothing_of_use_has_failed_with_the_reason(
    reply: dict[str, Any] | None, reason: str, tmp_path: Path
) -> None:
    rows = small_rows(tmp_path)[:1]
    path = written(tmp_path / "out.jsonl", [] if reply is None else [reply])
    (result,) = scored(rows, path)
    assert result.outcome is Outcome.FAILED
    assert reason in (result.reason or "")


def test_an_answer_that_was_cut_off_has_failed(tmp_path: Path) -> None:
    cut = reply_to("one", '{"expr')
    cut["response"]["body"]["choices"][0]["finish_reason"] = "length"
    (result,) = scored(small_rows(tmp_path)[:1], written(tmp_path / "out.jsonl", [cut]))
    assert "cut off" in (result.reason or "")


@pytest.mark.parametrize(
    ("replies", "what"),
    [
        ([GOOD[0], reply_to("nine", "")], "no sentence 'nine'"),
        ([GOOD[0], GOOD[0]], "two replies"),
        ([GOOD[0], {"response": {}}], "expected a reply"),
    ],
    ids=["of another corpus", "twice", "of nothing"],
)
def test_a_line_that_answers_none_of_the_requests_is_named(
    replies: list[dict[str, Any]], what: str, tmp_path: Path
) -> None:
    with pytest.raises(InputFileError, match=what) as caught:
        read_replies(
            written(tmp_path / "out.jsonl", replies), {row.id for row in small_rows(tmp_path)}
        )
    assert caught.value.line == 2
