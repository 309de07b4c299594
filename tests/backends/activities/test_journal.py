"""Notes are on the disk when `note` returns, and are there for the next process."""

from contextlib import closing
from pathlib import Path

import pytest

from plainspoken.backends.activities.journal import Journal
from plainspoken.errors import InputFileError


def test_the_last_note_counts_and_outlives_the_journal(tmp_path: Path) -> None:
    path = tmp_path / "deeper" / "journal.jsonl"
    with closing(Journal(path)) as journal:
        assert journal.get("m/1", "action") is None
        journal.note("m/1", "action", "go")
        journal.note("m/1", "action", {"grüß": [1, None]})
        with closing(Journal(path)) as meanwhile:
            assert meanwhile.get("m/1", "action") == {"grüß": [1, None]}
    with closing(Journal(path)) as again:
        assert again.get("m/1", "action") == {"grüß": [1, None]}
        assert again.get("m/2", "action") is None


def test_a_line_that_a_crash_tore_is_left_out_and_what_follows_is_whole(tmp_path: Path) -> None:
    path = tmp_path / "journal.jsonl"
    with closing(Journal(path)) as journal:
        journal.note("m/1", "action", "go")
        journal.note("m/1", "heard", value=True)
    path.write_text(path.read_text()[:-9])
    for _ in range(2):
        with closing(Journal(path)) as again:
            assert again.get("m/1", "action") == "go"
            assert again.get("m/1", "heard") is None
            again.note("m/2", "action", "stay")
    with closing(Journal(path)) as last:
        assert last.get("m/2", "action") == "stay"


def test_two_programs_see_each_others_notes(tmp_path: Path) -> None:
    path = tmp_path / "journal.jsonl"
    with closing(Journal(path)) as one, closing(Journal(path)) as other:
        one.note("m/1", "action", "go")
        assert other.get("m/1", "action") == "go"
        other.note("m/1", "heard", value=True)
        assert one.get("m/1", "heard") is True
        with path.open("a") as torn:
            torn.write('{"subject": "m/1", "key": "ended", "va')
        assert one.get("m/1", "ended") is None
        other.note("m/1", "ended", "done")
        assert one.get("m/1", "ended") == "done"


def test_a_file_of_something_else_is_refused_with_its_line(tmp_path: Path) -> None:
    path = tmp_path / "journal.jsonl"
    path.write_text('{"subject": "a", "key": "b", "value": 1}\nhello\n{"key": 3}\n')
    with pytest.raises(InputFileError) as caught:
        Journal(path)
    assert caught.value.line == 2
