import json
import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.knowledge.a_run import ENTRIES, STEPS

from plainspoken.errors import InputFileError, PlainspokenError
from plainspoken.knowledge.chain import Break, first_break, linked
from plainspoken.knowledge.log import SqliteLog, store_path
from plainspoken.world.event import Paused, Resumed


@pytest.fixture
def store(tmp_path: Path) -> Path:
    path = tmp_path / "log.sqlite"
    with SqliteLog(path) as log:
        for entry in ENTRIES:
            log.append("m1", entry.time, entry.instant, [entry.event])
        log.append("m2", "t", 0, [STEPS[0][1], Paused("ada")])
    return path


def test_what_is_appended_comes_back_equal_and_in_order(store: Path) -> None:
    with SqliteLog(store) as log:
        assert log.entries("m1") == ENTRIES
        assert log.entries("m1", since=3) == ENTRIES[3:]
        assert log.entries("nobody's") == ()
        assert log.missions() == ("m1", "m2")


def test_an_untouched_log_is_whole(store: Path) -> None:
    with SqliteLog(store) as log:
        assert log.verify("m1") is None
        assert log.verify("m2") is None


def test_a_mission_without_entries_is_not_called_whole(store: Path) -> None:
    with SqliteLog(store) as log:
        assert log.verify("m3") == Break("m3", 0, "there are no entries of this mission")


def test_the_store_refuses_to_change_or_delete_an_entry(store: Path) -> None:
    with sqlite3.connect(store) as connection:
        for deed in ("UPDATE entry SET document = ''", "DELETE FROM entry"):
            with pytest.raises(sqlite3.IntegrityError, match="only ever appended"):
                connection.execute(deed)
    connection.close()


@pytest.mark.parametrize(
    ("deed", "step"),
    [
        ("UPDATE entry SET document = replace(document, 'no oil', 'no gas') WHERE step = 7", 7),
        ("UPDATE entry SET step = step + 1 WHERE step = 8", 8),
        ("DELETE FROM entry WHERE step = 4 AND mission = 'm1'", 4),
        ("UPDATE entry SET hash = lower(hex(randomblob(32))) WHERE step = 2", 2),
        ("UPDATE entry SET document = '{}' WHERE mission = 'm1' AND step = 0", 0),
    ],
)
def test_who_gets_round_the_refusal_leaves_a_chain_that_breaks_there(
    store: Path, deed: str, step: int
) -> None:
    connection = sqlite3.connect(store)
    with connection:
        connection.execute("DROP TRIGGER no_update")
        connection.execute("DROP TRIGGER no_delete")
        connection.execute(deed)
    connection.close()
    with SqliteLog(store) as log:
        broken = log.verify("m1")
        assert broken is not None
        assert broken.step == step
        assert log.verify("m2") is None


def test_a_chain_does_not_fit_another_mission() -> None:
    assert first_break("m1", linked("m1", ENTRIES)) is None
    assert first_break("m2", linked("m1", ENTRIES)) is not None


def test_an_entry_that_cannot_be_read_is_named_by_its_step(store: Path) -> None:
    connection = sqlite3.connect(store)
    with connection:
        connection.execute("DROP TRIGGER no_update")
        connection.execute("UPDATE entry SET document = '{]' WHERE mission = 'm1' AND step = 5")
    connection.close()
    with SqliteLog(store) as log, pytest.raises(InputFileError, match="cannot be read") as caught:
        log.entries("m1")
    assert "step 5 of mission m1" in str(caught.value)


def test_events_of_one_decision_are_kept_together_or_not_at_all(store: Path) -> None:
    with SqliteLog(store) as log:
        with pytest.raises(TypeError):
            log.append("m1", "t", 3, [Paused("ada"), Paused(by=object())])  # type: ignore[arg-type]
        assert log.entries("m1") == ENTRIES
        (entry,) = log.append("m1", "t", 3, [Resumed("ada")])
        assert entry.step == len(ENTRIES)


APPEND_FIFTY = """
import sys
from plainspoken.knowledge.log import SqliteLog
from plainspoken.world.event import Paused
with SqliteLog(sys.argv[1]) as log:
    for number in range(50):
        log.append("m", str(number), 0, [Paused(sys.argv[2]), Paused(sys.argv[2])])
"""


def test_two_processes_append_at_once_and_the_chain_stays_whole(tmp_path: Path) -> None:
    path = tmp_path / "new" / "log.sqlite"
    writers = [
        subprocess.Popen([sys.executable, "-c", APPEND_FIFTY, path, name]) for name in ("a", "b")
    ]
    assert [writer.wait(timeout=100) for writer in writers] == [0, 0]
    with SqliteLog(path) as log:
        entries = log.entries("m")
        assert [entry.step for entry in entries] == list(range(200))
        assert log.verify("m") is None
        who = [entry.event.by for entry in entries if isinstance(entry.event, Paused)]
    assert who[0::2] == who[1::2]
    assert [entry.time for entry in entries[::2] if entry.event == Paused("a")] == [
        str(number) for number in range(50)
    ]


def test_a_mission_is_restored_byte_for_byte_and_only_once(store: Path, tmp_path: Path) -> None:
    with SqliteLog(store) as log, SqliteLog(tmp_path / "other.sqlite") as other:
        other.restore("m1", log.links("m1"))
        assert other.links("m1") == log.links("m1")
        with pytest.raises(PlainspokenError, match="already"):
            other.restore("m1", log.links("m1"))
        with pytest.raises(PlainspokenError, match="cannot import") as caught:
            other.restore("m9", log.links("m1"))
    assert caught.value.where == "step 0"


def test_a_file_of_another_kind_is_refused_by_its_name(tmp_path: Path) -> None:
    path = tmp_path / "notes.txt"
    path.write_text("milk, bread\n" * 100)
    with pytest.raises(InputFileError, match="not a store") as caught:
        SqliteLog(path)
    assert caught.value.path == path


def test_a_store_in_a_place_that_cannot_be_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(InputFileError, match="cannot use the store"):
        SqliteLog(tmp_path / "file" / "log.sqlite")


@pytest.mark.parametrize(
    ("url", "environment", "path"),
    [
        ("runs/log.db", {}, "runs/log.db"),
        ("sqlite:///log.db", {}, "log.db"),
        ("sqlite:////var/log.db", {}, "/var/log.db"),
        (None, {"PLAINSPOKEN_HOME": "/p", "XDG_DATA_HOME": "/x"}, "/p/plainspoken.sqlite"),
    ],
)
def test_the_store_is_where_the_url_or_the_environment_says(
    url: str | None, environment: dict[str, str], path: str
) -> None:
    assert store_path(url, environment) == Path(path)


@pytest.mark.skipif(sys.platform == "darwin", reason="macOS keeps it in ~/Library")
def test_without_any_word_the_store_is_with_the_users_data() -> None:
    assert store_path(None, {"XDG_DATA_HOME": "/x"}) == Path("/x/plainspoken/plainspoken.sqlite")
    default = store_path(None, {})
    assert default == Path.home() / ".local" / "share" / "plainspoken" / "plainspoken.sqlite"


@pytest.mark.parametrize("url", ["postgresql://host/db", "sqlite://", "sqlite:///"])
def test_a_store_of_another_kind_is_refused_with_what_to_say_instead(url: str) -> None:
    with pytest.raises(PlainspokenError) as caught:
        store_path(url, {})
    assert caught.value.hint == "give a path, or sqlite:///path"


@given(st.text(), st.text())
def test_any_text_survives_the_log(by: str, time: str) -> None:
    with SqliteLog(":memory:") as log:
        (entry,) = log.append("m", time, 0, [Paused(by)])
        assert log.entries("m") == (entry,)
        assert entry.event == Paused(by)


def test_the_stored_text_is_one_line_of_json_in_ascii(store: Path) -> None:
    with SqliteLog(store) as log:
        for link in log.links("m1"):
            assert link.text.isascii()
            assert "\n" not in link.text
            assert list(json.loads(link.text))[:3] == ["step", "time", "kind"]
