"""`plainspoken extract` at a terminal: the question, its answer, and examples."""

import json
import os
import pty
import subprocess
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LANDMARKS = str(ROOT / "examples" / "vineyard" / "landmarks.json")


def extract(*arguments: str, home: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "plainspoken", "extract", "--landmarks", LANDMARKS, *arguments],
        env={**os.environ, "PLAINSPOKEN_HOME": str(home)},
        capture_output=True,
        text=True,
        check=False,
        stdin=subprocess.DEVNULL,
    )


def at_a_terminal(*arguments: str, answers: tuple[str, ...], home: Path) -> tuple[int, str, str]:
    """Run the command with a terminal for its standard input, and type answers."""
    ours, theirs = pty.openpty()
    command = [sys.executable, "-m", "plainspoken", "extract", "--landmarks", LANDMARKS]
    process = subprocess.Popen(
        [*command, *arguments],
        env={**os.environ, "PLAINSPOKEN_HOME": str(home)},
        stdin=theirs,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    os.close(theirs)
    try:
        os.write(ours, "".join(f"{each}\n" for each in answers).encode())
        out, err = process.communicate(timeout=60)
    finally:
        os.close(ours)
    return process.returncode, out, err


@pytest.mark.parametrize("answer", ["right after", "b"])
def test_the_question_is_asked_and_the_answer_taken(answer: str, tmp_path: Path) -> None:
    status, out, err = at_a_terminal(
        "Visit line 1, then line 2 right away.", answers=(answer,), home=tmp_path
    )
    assert status == 0
    assert "Should line 2 come right after line 1, or just later?" in err
    assert out.strip() == "F(robot_at_rob_l1 & X robot_at_rob_l2)"


def test_an_answer_that_cannot_be_told_is_asked_for_again(tmp_path: Path) -> None:
    status, out, err = at_a_terminal("Go to the line.", answers=("banana", "2"), home=tmp_path)
    assert status == 0
    assert "I cannot tell which you mean." in err
    assert out.strip() == "F robot_at_rob_l2"


def test_no_ends_in_a_refusal_and_nothing_leaves_the_question_open(tmp_path: Path) -> None:
    status, out, _ = at_a_terminal("Go to rose 2.", answers=("no",), home=tmp_path)
    assert (status, out) == (3, "")
    status, out, err = at_a_terminal("Go to rose 2.", answers=("",), home=tmp_path)
    assert (status, out) == (0, "")
    assert 'do you mean "row 2"?' in err


@pytest.mark.parametrize("option", ["--no-input", "--json"])
def test_an_option_stops_the_asking(option: str, tmp_path: Path) -> None:
    started = time.perf_counter()
    status, out, err = at_a_terminal("Go to the line.", option, answers=(), home=tmp_path)
    assert time.perf_counter() - started < 30
    assert status == 0
    assert "What do you mean by" in out + err


def test_without_a_terminal_the_question_is_printed(tmp_path: Path) -> None:
    done = extract("Go to the line.", home=tmp_path)
    assert done.returncode == 0
    assert "What do you mean by" in done.stderr


def test_examples_go_with_the_english(tmp_path: Path) -> None:
    done = extract("Visit line 1, then line 2.", home=tmp_path)
    assert "For example: line 1, then line 2" in done.stderr
    assert "Not: line 2, then line 1" in done.stderr
    document = json.loads(extract("Visit line 1, then line 2.", "--json", home=tmp_path).stdout)
    assert [each["english"] for each in document["examples"]["rejected"]] == [
        "line 2, then line 1",
        "line 1",
    ]
    assert document["confidence"] > 0.5


def test_the_help_tells_of_the_question(tmp_path: Path) -> None:
    text = " ".join(extract("--help", home=tmp_path).stdout.split())
    assert "--no-input" in text
    assert "at a terminal, type the letter or the words of an answer" in text
