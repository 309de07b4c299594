"""What a command imports: planning for a formula needs neither the language nor the missions."""

from __future__ import annotations

import subprocess
import sys
import time

import pytest


def imported_by(*arguments: str) -> set[str]:
    done = subprocess.run(
        [sys.executable, "-X", "importtime", "-m", "plainspoken", *arguments],
        capture_output=True,
        text=True,
        check=True,
    )
    lines = [line for line in done.stderr.splitlines() if line.startswith("import time:")]
    return {line.rpartition("|")[2].strip() for line in lines}


def test_planning_for_a_formula_imports_only_what_planning_needs() -> None:
    loaded = imported_by("plan", "--goal", "F robot_at_rob_l1")
    for room in ("language.extraction", "language.grounding", "mission", "questions", "knowledge"):
        assert f"plainspoken.{room}" not in loaded
    assert not loaded & {"rich.console", "simplemma", "sqlite3", "importlib.metadata"}


@pytest.mark.parametrize("arguments", [("--help",), ("plan", "--goal", "F robot_at_rob_l1")])
def test_a_command_starts_quickly(arguments: tuple[str, ...]) -> None:
    spent = []
    for _ in range(3):
        started = time.perf_counter()
        subprocess.run(
            [sys.executable, "-m", "plainspoken", *arguments], capture_output=True, check=True
        )
        spent.append(time.perf_counter() - started)
    assert min(spent) < 1.5, "0.1 s and 0.25 s on a calm machine; a loaded one may take its time"
