"""`plainspoken eval` as a user meets it."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from tests.evaluation.small_corpus import LANDMARKS, ROWS, written
from tests.evaluation.test_batch import GOOD

FILES = ["extraction.md", "extraction.svg", "results.jsonl"]


def run(*arguments: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "plainspoken", "eval", "extraction", *arguments],
        cwd=cwd,
        env={**os.environ, "PLAINSPOKEN_HOME": str(cwd / "home"), "COLUMNS": "100"},
        capture_output=True,
        text=True,
        check=False,
        stdin=subprocess.DEVNULL,
    )


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A corpus with its landmarks beside it."""
    written(tmp_path / "sentences.jsonl")
    entries = {
        one.id: {"description": one.description, "type": str(one.type)}
        for one in LANDMARKS.values()
    }
    (tmp_path / "landmarks.json").write_text(json.dumps(entries))
    return tmp_path


def test_a_corpus_is_measured_and_written_down(folder: Path) -> None:
    done = run("--corpus", "sentences.jsonl", "--out", "out", cwd=folder)
    assert done.returncode == 0, done.stderr
    assert "Accuracy by pattern" in done.stdout
    assert sorted(file.name for file in (folder / "out").iterdir()) == FILES
    assert len((folder / "out" / "results.jsonl").read_text().splitlines()) == len(ROWS)


def test_a_second_run_goes_on_with_what_is_there(folder: Path) -> None:
    first = run("-c", "sentences.jsonl", "--out", "out", "--json", cwd=folder)
    kept = folder / "out" / "results.jsonl"
    lines = kept.read_text().splitlines(keepends=True)
    kept.write_text("".join(lines[1:]) + '{"id": "tor')
    again = run("-c", "sentences.jsonl", "--out", "out", "--resume", "--json", cwd=folder)
    assert again.returncode == 0, again.stderr
    ids = [json.loads(line)["id"] for line in kept.read_text().splitlines()]
    assert ids == ["two", "three", "one"]
    figures = [json.loads(done.stdout) for done in (first, again)]
    for each in figures:
        del each["seconds"]
    assert figures[0] == figures[1]


def test_two_processes_come_to_the_same_figures(folder: Path) -> None:
    figures = []
    for workers in ("1", "2"):
        done = run("-c", "sentences.jsonl", "--workers", workers, "--json", cwd=folder)
        assert done.returncode == 0, done.stderr
        figures.append(json.loads(done.stdout))
        del figures[-1]["seconds"]
    assert figures[0] == figures[1]


def test_a_batch_goes_out_and_its_replies_come_back(folder: Path) -> None:
    done = run("-c", "sentences.jsonl", "--export-batch", "requests.jsonl", cwd=folder)
    assert done.returncode == 0, done.stderr
    requests = (folder / "requests.jsonl").read_text().splitlines()
    assert [json.loads(line)["custom_id"] for line in requests] == [row["id"] for row in ROWS]
    written(folder / "replies.jsonl", GOOD)
    done = run("-c", "sentences.jsonl", "--import-batch", "replies.jsonl", "--json", cwd=folder)
    assert done.returncode == 0, done.stderr
    figures = json.loads(done.stdout)
    assert figures["mode"] == "batch"
    assert figures["total"]["literal"]["count"] == 2
    assert figures["seconds"] == {"median": None, "p95": None}


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--resume"], "--resume"),
        (["--export-batch", "a", "--import-batch", "b"], "not both"),
        (["--mode", "llm", "--model", ""], "--model"),
        (["--corpus", "nowhere.jsonl"], "nowhere.jsonl"),
        (["--corpus", "bad.jsonl"], "bad.jsonl:2"),
        (["--corpus", "sentences.jsonl", "--import-batch", "bad.jsonl"], "bad.jsonl:1"),
    ],
    ids=["resume", "both batches", "no model", "no file", "bad row", "bad reply"],
)
def test_bad_input_is_named_with_status_2(arguments: list[str], said: str, folder: Path) -> None:
    written(folder / "bad.jsonl", [ROWS[0], {"utterance": "Go"}])
    done = run(*arguments, cwd=folder)
    assert done.returncode == 2, done.stdout
    assert said in done.stderr
    assert "Traceback" not in done.stderr
