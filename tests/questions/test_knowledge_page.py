"""docs/knowledge.md is true: what it shows is what comes out."""

import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner

from plainspoken.cli import plainspoken

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "knowledge.md").read_text()


def block(language: str) -> str:
    found = re.search(rf"```{language}\n(.*?)```", PAGE, re.DOTALL)
    assert found is not None
    return found[1]


def run(command: str) -> str:
    name, *arguments = shlex.split(command)
    assert name == "plainspoken"
    placed = [str(ROOT / each) if each.startswith("examples/") else each for each in arguments]
    done = CliRunner().invoke(plainspoken, placed)
    assert done.exit_code == 0, done.output
    return done.stdout.strip()


def test_the_example_runs_and_its_answers_are_those(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    run(f"{block('sh').strip()} --store store.sqlite")
    shown = block("text").strip().splitlines()
    assert len(shown) == 10
    for command, answer in zip(shown[::2], shown[1::2], strict=True):
        assert run(command.removeprefix("> ")) == answer
    exec(block("python"), {})  # noqa: S102 - the page is ours
    assert f"It prints `{capsys.readouterr().out.strip()}`." in PAGE


def test_the_problem_on_the_page_is_the_one_of_the_example() -> None:
    problem = " ".join((ROOT / "examples" / "store-room" / "problem.pddl").read_text().split())
    for line in block("lisp").strip().splitlines():
        assert line in problem
