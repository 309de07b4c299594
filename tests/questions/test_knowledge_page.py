"""docs/knowledge.md is true: what it shows is what comes out."""

import re
import shlex
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "knowledge.md").read_text()


def block(language: str) -> str:
    found = re.search(rf"```{language}\n(.*?)```", PAGE, re.DOTALL)
    assert found is not None
    return found[1]


def run(arguments: list[str], folder: Path) -> str:
    placed = [str(ROOT / each) if each.startswith("examples/") else each for each in arguments]
    done = subprocess.run(
        [sys.executable, *placed], cwd=folder, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def test_the_example_runs_and_its_answers_are_those(tmp_path: Path) -> None:
    store = ["--store", str(tmp_path / "store.sqlite")]
    run(["-m", *shlex.split(block("sh")), *store], tmp_path)
    shown = block("text").strip().splitlines()
    assert len(shown) == 10
    for command, answer in zip(shown[::2], shown[1::2], strict=True):
        assert run(["-m", *shlex.split(command.removeprefix("> "))], tmp_path) == answer
    printed = run(["-c", block("python")], tmp_path)
    assert f"It prints `{printed}`." in PAGE


def test_the_problem_on_the_page_is_the_one_of_the_example() -> None:
    problem = " ".join((ROOT / "examples" / "store-room" / "problem.pddl").read_text().split())
    for line in block("lisp").strip().splitlines():
        assert line in problem
