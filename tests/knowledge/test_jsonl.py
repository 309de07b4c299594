import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from tests.knowledge.a_run import ENTRIES

from plainspoken.errors import InputFileError
from plainspoken.knowledge.chain import linked
from plainspoken.knowledge.jsonl import JsonlWriter, read_jsonl, write_jsonl
from plainspoken.knowledge.log import SqliteLog
from plainspoken.world.event import MissionAccepted


@pytest.fixture
def run(tmp_path: Path) -> Path:
    path = tmp_path / "run.jsonl"
    with JsonlWriter(path) as writer:
        for entry in ENTRIES:
            writer.write(entry)
    return path


def test_entries_come_back_equal_from_the_lines_of_a_file(run: Path) -> None:
    read = read_jsonl(run)
    assert (read.mission, read.entries, read.torn_line) == ("m1", ENTRIES, None)


def test_each_line_has_the_fields_that_others_script_against(run: Path) -> None:
    for number, line in enumerate(run.read_text().splitlines()):
        assert {"step": number, "kind": ENTRIES[number].kind}.items() <= json.loads(line).items()


def test_each_line_is_out_before_the_next_is_begun(tmp_path: Path) -> None:
    path = tmp_path / "run.jsonl"
    with JsonlWriter(path) as writer:
        for written, entry in enumerate(ENTRIES, start=1):
            writer.write(entry)
            assert read_jsonl(path).entries == ENTRIES[:written]


def test_a_file_is_continued_where_it_ends(run: Path, tmp_path: Path) -> None:
    path = tmp_path / "parts.jsonl"
    for entry in ENTRIES:
        with JsonlWriter(path) as writer:
            writer.write(entry)
    assert path.read_bytes() == run.read_bytes()


def test_another_run_is_not_mixed_in(run: Path) -> None:
    with JsonlWriter(run) as writer, pytest.raises(InputFileError, match="goes on with step 9"):
        writer.write(ENTRIES[0])
    assert read_jsonl(run).entries == ENTRIES


@given(st.data())
def test_a_file_torn_anywhere_reads_as_the_entries_before_the_tear(
    tmp_path_factory: pytest.TempPathFactory, data: st.DataObject
) -> None:
    whole = b"".join(
        link.text[:-1].encode() + f',"hash":"{link.hash}"}}\n'.encode()
        for link in linked("m1", ENTRIES)
    )
    first = whole.index(b"\n") + 1
    cut = data.draw(st.integers(first, len(whole) - 1))
    path = tmp_path_factory.mktemp("torn") / "run.jsonl"
    path.write_bytes(whole[:cut])
    read = read_jsonl(path)
    # A line that lacks only its line feed is whole.
    lines = whole[:cut].count(b"\n") + whole[cut:].startswith(b"\n")
    assert read.entries == ENTRIES[:lines]
    assert (read.torn_line is None) == (whole[cut - 1 : cut] == b"\n" or whole[cut] == ord("\n"))
    with JsonlWriter(path) as writer:
        for entry in ENTRIES[lines:]:
            writer.write(entry)
    assert path.read_bytes() == whole


WRITE_FOR_EVER = """
import sys
from itertools import count
from plainspoken.knowledge.jsonl import JsonlWriter
from plainspoken.world.event import Entry, Paused
from tests.knowledge.a_run import ENTRIES
with JsonlWriter(sys.argv[1]) as writer:
    writer.write(ENTRIES[0])
    for step in count(1):
        writer.write(Entry(step, "t", 0, Paused("x" * 5000)))
        print(step, flush=True)
"""


def test_a_killed_writer_has_lost_no_line_that_it_had_finished(tmp_path: Path) -> None:
    path = tmp_path / "run.jsonl"
    writer = subprocess.Popen(
        [sys.executable, "-c", WRITE_FOR_EVER, path],
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))},
    )
    assert writer.stdout is not None
    with writer:
        told = [int(writer.stdout.readline()) for _ in range(40)]
        writer.send_signal(signal.SIGKILL)
        told += [int(line) for line in writer.stdout.read().split()]
    assert len(read_jsonl(path).entries) > told[-1]


SEALED = b"".join(
    link.text[:-1].encode() + f',"hash":"{link.hash}"}}\n'.encode()
    for link in linked("m1", ENTRIES)
)


@given(st.integers(0, len(SEALED) - 1), st.integers(1, 255))
@example(len(SEALED) - 1, ord("\n") ^ ord(" "))
@example(SEALED.index(b"\n"), ord("\n") ^ ord("\r"))
@example(SEALED.rindex(b'"hash"') + 1, 1)
def test_a_change_of_any_byte_is_noticed(
    tmp_path_factory: pytest.TempPathFactory, place: int, mask: int
) -> None:
    path = tmp_path_factory.mktemp("tampered") / "run.jsonl"
    changed = SEALED[:place] + bytes([SEALED[place] ^ mask]) + SEALED[place + 1 :]
    path.write_bytes(changed)
    try:
        noticed = read_jsonl(path).torn_line is not None
    except InputFileError as error:
        noticed = error.line is not None
    assert noticed


def test_a_changed_line_is_named(run: Path) -> None:
    run.write_text(run.read_text().replace("I lit it", "I lit one"))
    with pytest.raises(InputFileError, match="not the one that was written") as caught:
        read_jsonl(run)
    assert caught.value.line == 6


def test_a_missing_line_is_named(run: Path) -> None:
    lines = run.read_text().splitlines(keepends=True)
    run.write_text("".join(lines[:4] + lines[5:]))
    with pytest.raises(InputFileError, match="expected step 4, got step 5") as caught:
        read_jsonl(run)
    assert caught.value.line == 5


@pytest.mark.parametrize(
    ("line", "what"),
    [
        ('{"step": 1, "time": "t", "kind": "danced", "instant": 0}', "unknown kind of event"),
        ('{"step": 1, "time": "t", "kind": "paused", "instant": 0}', "the field 'by' is missing"),
        ('{"step": 1, "kind": "paused", "by": "a", "instant": 0}', "the field 'time' is missing"),
        ("[1]", "expected a JSON object"),
        ("{]", "not a JSON text"),
        ('{"step": 1, "time": "t", "kind": [], "instant": 0}', "a field has the wrong type"),
    ],
)
def test_a_line_that_is_no_entry_is_named_with_what_is_wrong(
    tmp_path: Path, line: str, what: str
) -> None:
    path = tmp_path / "run.jsonl"
    path.write_text(f"{json.dumps(ENTRIES[0].to_json())}\n{line}\n")
    with pytest.raises(InputFileError, match=what) as caught:
        read_jsonl(path)
    assert caught.value.line == 2


def test_a_file_written_by_another_hand_without_hashes_is_read(tmp_path: Path) -> None:
    path = tmp_path / "run.jsonl"
    path.write_text("".join(json.dumps(entry.to_json()) + "\r\n\n" for entry in ENTRIES))
    assert read_jsonl(path).entries == ENTRIES
    with pytest.raises(InputFileError, match="no hashes to go on from"):
        JsonlWriter(path)


@pytest.mark.parametrize("content", ["", "\n\n", '{"step": 0, "time": "t", "kind"'])
def test_a_file_that_begins_no_run_is_refused(tmp_path: Path, content: str) -> None:
    path = tmp_path / "run.jsonl"
    path.write_text(content)
    with pytest.raises(InputFileError, match="begins with"):
        read_jsonl(path)


def test_a_file_that_is_not_there_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputFileError, match="cannot read"):
        read_jsonl(tmp_path / "none.jsonl")
    with pytest.raises(InputFileError, match="cannot write"):
        JsonlWriter(tmp_path)


def test_a_mission_goes_out_of_one_store_and_into_another_unchanged(tmp_path: Path) -> None:
    path = tmp_path / "m1.jsonl"
    with SqliteLog(":memory:") as here, SqliteLog(":memory:") as there:
        for entry in ENTRIES:
            here.append("m1", entry.time, entry.instant, [entry.event])
        write_jsonl(here.links("m1"), path)
        read = read_jsonl(path)
        there.restore(read.mission, read.links)
        assert there.entries("m1") == ENTRIES
        assert there.verify("m1") is None
    assert path.read_bytes() == SEALED


def test_a_log_from_before_a_field_was_added_is_read_with_its_default(tmp_path: Path) -> None:
    path = tmp_path / "run.jsonl"
    document = ENTRIES[0].to_json()
    del document["robot"]
    path.write_text(json.dumps(document) + "\n")
    (entry,) = read_jsonl(path).entries
    assert isinstance(entry.event, MissionAccepted)
    assert entry.event.robot == {}
