from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plainspoken.errors import InputFileError
from plainspoken.evaluation.experiment import Outcome, Result
from plainspoken.evaluation.journal import (
    Journal,
    read_results,
    result_from_json,
    result_to_json,
)
from plainspoken.evaluation.metric import Mentions, Share

shares = st.builds(Share, st.integers(0, 9), st.integers(0, 9))
results = st.builds(
    Result,
    id=st.text(),
    key=st.text(),
    outcome=st.sampled_from(Outcome),
    literal=st.booleans(),
    executable=st.none() | st.booleans(),
    formula=st.none() | st.text(),
    pattern=st.none() | st.text(),
    reason=st.none() | st.text(),
    mentions=st.none() | st.builds(Mentions, shares, shares, shares),
    seconds=st.none() | st.floats(0, 100),
)
ONE = Result("one", "k", Outcome.RIGHT, literal=True, seconds=0.5)
TWO = Result("two", "k", Outcome.REFUSED, reason="no\nway", mentions=Mentions(Share(1, 2)))


@given(results)
def test_a_result_survives_its_line(result: Result) -> None:
    assert result_from_json(result_to_json(result)) == result


def test_a_second_run_goes_on_where_the_first_stopped(tmp_path: Path) -> None:
    path = tmp_path / "new" / "results.jsonl"
    with Journal(path, resume=True) as journal:
        assert journal.known == {}
        journal.append(ONE)
    with path.open("a") as file:
        file.write('{"id": "two", "ke')  # killed while writing
    with Journal(path, resume=True) as journal:
        assert journal.known == {("one", "k"): ONE}
        journal.append(TWO)
    assert read_results(path) == {("one", "k"): ONE, ("two", "k"): TWO}


def test_without_resume_a_run_starts_afresh(tmp_path: Path) -> None:
    path = tmp_path / "results.jsonl"
    for _ in range(2):
        with Journal(path, resume=False) as journal:
            assert journal.known == {}
            journal.append(ONE)
    assert len(path.read_text().splitlines()) == 1


def test_of_two_lines_for_a_sentence_the_later_counts(tmp_path: Path) -> None:
    again = Result("one", "k", Outcome.FAILED, reason="late")
    with Journal(tmp_path / "r.jsonl", resume=False) as journal:
        journal.append(ONE)
        journal.append(again)
    assert read_results(tmp_path / "r.jsonl") == {("one", "k"): again}


@pytest.mark.parametrize("line", ["{", "[]", "{}", '{"id": "one", "mentions": 3}', "\x00"])
def test_a_line_that_is_no_result_is_named(line: str, tmp_path: Path) -> None:
    path = tmp_path / "r.jsonl"
    path.write_text(f"{line}\n")
    with pytest.raises(InputFileError, match="not a result") as caught:
        Journal(path, resume=True)
    assert caught.value.line == 1


def test_a_folder_that_cannot_be_written_to_is_named(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(InputFileError, match="cannot write"):
        Journal(tmp_path / "file" / "r.jsonl", resume=False)
