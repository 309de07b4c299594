"""`export pddl`, and its files planned for by `plan`."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path


def run(*arguments: str, cwd: Path) -> str:
    return subprocess.run(
        [sys.executable, "-m", "plainspoken", *arguments],
        cwd=cwd,
        capture_output=True,
        text=True,
        check=True,
    ).stdout


def test_the_compiled_files_are_a_problem_of_their_own(tmp_path: Path) -> None:
    run("export", "pddl", "--goal", "F cleared_l1 & X true", "--out-domain", "d.pddl", cwd=tmp_path)
    assert sorted(file.name for file in tmp_path.iterdir()) == ["d.pddl", "problem-compiled.pddl"]
    site = ["--domain", "d.pddl", "--problem", "problem-compiled.pddl"]
    policy = json.loads(run("plan", *site, "--json", cwd=tmp_path))
    assert policy["status"] == "solved"
    assert policy["nodes"][0]["action"].startswith("do-")


def test_without_files_both_are_printed(tmp_path: Path) -> None:
    printed = run("export", "pddl", "--say", "Go to line 2", cwd=tmp_path)
    assert "(define (domain compiled)" in printed
    assert "(define (problem compiled)" in printed
    assert not list(tmp_path.iterdir())
