import multiprocessing
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path

import pytest
from tests.evaluation.small_corpus import accepted, mentioned, right, small_rows, told

from plainspoken.errors import PlainspokenError
from plainspoken.evaluation.corpus import Row
from plainspoken.evaluation.experiment import (
    Outcome,
    Result,
    UnexplainedError,
    key_of,
    run_experiment,
)
from plainspoken.evaluation.metric import Share
from plainspoken.evaluation.summary import summarised
from plainspoken.language.extraction import Extraction, Status

Answer = Callable[[Row], Extraction]


def broken(row: Row) -> Extraction:
    raise KeyError(row.id)


def failing(row: Row) -> Extraction:
    raise PlainspokenError("no reply", where=row.id)


def results_of(rows: tuple[Row, ...], **answers: Answer) -> list[Result]:
    translate = told({row.id: right for row in rows} | answers)
    return [result for result, _ in run_experiment(rows, "test", translate)]


@pytest.mark.parametrize(
    ("answer", "outcome"),
    [
        (right, Outcome.RIGHT),
        (lambda row: accepted(row, "F(hall & (F attic))"), Outcome.RIGHT),
        (lambda row: accepted(row, "F(hall & F attic)", "F attic"), Outcome.WRONG_FORMULA),
        (lambda row: accepted(row, "F(attic & F hall)"), Outcome.WRONG_FORMULA),
        (lambda row: accepted(row, "F(cellar & F attic)"), Outcome.WRONG_GROUNDING),
        (
            lambda row: Extraction(row.utterance, Status.CLARIFY, question="Which hall?"),
            Outcome.ASKED,
        ),
        (lambda row: Extraction(row.utterance, Status.REJECT, reason="no"), Outcome.REFUSED),
        (failing, Outcome.FAILED),
        (broken, Outcome.UNEXPLAINED),
        (lambda row: Extraction(row.utterance, Status.OK), Outcome.UNEXPLAINED),
        (lambda row: Extraction(row.utterance, Status.REJECT), Outcome.UNEXPLAINED),
        (lambda row: Extraction(row.utterance, Status.CLARIFY), Outcome.UNEXPLAINED),
    ],
    ids=[
        "the gold",
        "equivalent to the gold",
        "the executable reading wrong",
        "the order wrong",
        "a symbol wrong",
        "a question",
        "a refusal",
        "a failure",
        "a mistake of ours",
        "accepted without a formula",
        "refused without a reason",
        "asked without a question",
    ],
)
def test_every_run_ends_in_a_named_outcome(
    answer: Answer, outcome: Outcome, tmp_path: Path
) -> None:
    result = results_of(small_rows(tmp_path), two=answer)[1]
    assert result.outcome is outcome
    told_why = {Outcome.ASKED, Outcome.REFUSED, Outcome.FAILED, Outcome.UNEXPLAINED}
    assert bool(result.reason) is (outcome in told_why)


def test_the_readings_are_judged_apart(tmp_path: Path) -> None:
    wrong = results_of(
        small_rows(tmp_path), three=lambda row: accepted(row, "!attic U cellar", "F cellar")
    )[2]
    assert (wrong.literal, wrong.executable) == (True, False)


def test_a_row_without_an_executable_reading_is_judged_by_the_literal_one(tmp_path: Path) -> None:
    row = replace(small_rows(tmp_path)[2], executable=None)
    (result,) = results_of((row,), three=lambda row: accepted(row, "!attic U cellar", "F hall"))
    assert (result.outcome, result.executable) == (Outcome.RIGHT, None)


def test_a_question_with_a_reading_is_no_right_answer(tmp_path: Path) -> None:
    def asking(row: Row) -> Extraction:
        return replace(right(row), status=Status.CLARIFY, question="Really?")

    result = results_of(small_rows(tmp_path), one=asking)[0]
    assert (result.outcome, result.literal, result.formula) == (Outcome.ASKED, False, None)


def test_mentions_are_compared_where_the_corpus_gives_them(tmp_path: Path) -> None:
    def answer(row: Row) -> Extraction:
        hall = mentioned(row, "The hall", "hall")
        return accepted(row, "F hall", referring_expressions=(hall,))

    _, two, three = results_of(small_rows(tmp_path), two=answer)
    assert two.mentions is not None
    assert two.mentions.recall == Share(1, 2)
    assert three.mentions is None


def test_a_mistake_of_ours_fails_the_whole_table(tmp_path: Path) -> None:
    rows = small_rows(tmp_path)
    results = results_of(rows, two=broken)
    with pytest.raises(UnexplainedError, match="no table") as caught:
        summarised(rows, results, corpus="c", mode="test", version="1")
    assert "two: KeyError" in str(caught.value)


@pytest.mark.parametrize("outcome", [Outcome.ASKED, Outcome.REFUSED, Outcome.FAILED])
def test_an_ending_without_its_reason_fails_the_whole_table(
    outcome: Outcome, tmp_path: Path
) -> None:
    rows = small_rows(tmp_path)[:1]
    with pytest.raises(UnexplainedError):
        summarised(rows, [Result("one", "k", outcome)], corpus="c", mode="test", version="1")


def test_what_is_known_is_not_run_again_unless_it_failed(tmp_path: Path) -> None:
    rows = small_rows(tmp_path)
    first = results_of(
        (rows[0], rows[1]), one=lambda row: accepted(row, "F attic"), two=failing
    ) + results_of(rows[2:], three=broken)
    asked: list[str] = []

    def counting(row: Row, _: object) -> Extraction:
        asked.append(row.id)
        return right(row)

    known = {(each.id, each.key): each for each in first}
    second = list(run_experiment(rows, "test", counting, known=known))
    assert asked == ["two", "three"]
    assert [new for _, new in second] == [False, True, True]
    assert second[0][0] == first[0]
    assert [each.outcome for each, _ in second[1:]] == [Outcome.RIGHT, Outcome.RIGHT]


def test_a_result_is_known_by_all_that_it_depends_on(tmp_path: Path) -> None:
    row = small_rows(tmp_path)[0]
    others = [
        replace(row, utterance="Go to the hall!"),
        replace(row, literal=row.landmarks and small_rows(tmp_path)[1].literal),
        replace(row, landmarks=row.landmarks[:1]),
        replace(row, mentions=None),
    ]
    keys = {key_of(row, "test"), key_of(row, "llm"), *(key_of(each, "test") for each in others)}
    assert len(keys) == 2 + len(others)
    assert key_of(replace(row), "test") == key_of(row, "test")


def test_processes_give_the_same_results_in_the_same_order(tmp_path: Path) -> None:
    rows = small_rows(tmp_path)
    alone = [result for result, _ in run_experiment(rows, "test", right, timed=False)]
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as executor:
        both = run_experiment(rows, "test", right, executor=executor, timed=False)
        assert [result for result, _ in both] == alone


def test_seconds_are_given_only_where_they_are_ours_to_measure(tmp_path: Path) -> None:
    rows = small_rows(tmp_path)
    timed = [result.seconds for result, _ in run_experiment(rows, "test", right)]
    assert all(seconds is not None and seconds >= 0 for seconds in timed)
    untimed = run_experiment(rows, "test", right, timed=False)
    assert [result.seconds for result, _ in untimed] == [None] * 3
