"""Vineyards of more and more lines: what `plainspoken plan` takes, and how it grows.

    python benchmarks/vineyards.py [--lines 4,16,64,256] [--grapes N] [--timeout S] [--markdown]
    python benchmarks/vineyards.py --write FOLDER --lines 16     the problem and its formula only

The domain is examples/vineyard/domain.pddl; the lines and a warehouse stand on a ring, each line
with its grapes, unchecked. The goal is "clear every line, never enter one while the box is full":

    F cleared_l0 & ... & F cleared_lN
    & G((full_b & !robot_at_rob_l0) -> WX !robot_at_rob_l0) & ... the same for every line

Whoever is outside a line while the box is full is outside it at the next instant too, if there is
one. A move does not change the box; so these are the moves into a line with a full box, and no
others: the robot may be in a line when the box becomes full, and has it emptied there.

Seconds and megabytes are those of the whole process: start, parsing, grounding, automata, search,
validation and writing the policy. The exponent is the slope of the least-squares line through the
logarithms of lines and seconds, once through all sizes and once from 16 lines on, where the cost
of starting no longer counts.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from math import log
from pathlib import Path

DOMAIN = Path(__file__).resolve().parents[1] / "examples" / "vineyard" / "domain.pddl"


@dataclass(frozen=True)
class Measured:
    """One size. stages: what `plan` says its stages took; the search's proof is the policy."""

    lines: int
    status: str
    wall: float
    cpu: float
    megabytes: float
    nodes: int
    file_megabytes: float
    stages: dict[str, float]


def problem_text(lines: int, grapes: int, known: str) -> str:
    """The vineyard as PDDL; known: what is known of each grape, `ripe` or `unchecked`."""
    places = [*(f"l{i}" for i in range(lines)), "wh"]
    ring = zip(places, [*places[1:], places[0]], strict=True)
    where = [(f"g{i}-{j}", f"l{i}") for i in range(lines) for j in range(grapes)]
    facts = ["(robot-at rob l0) (robot-at sup wh)", "(carries rob b) (hand-empty rob)"]
    facts += [f"(adjacent {a} {b}) (adjacent {b} {a})" for a, b in ring]
    facts += [f"(grape-at {grape} {line}) ({known} {grape})" for grape, line in where]
    wanted = " ".join(f"(cleared l{i})" for i in range(lines))
    return "\n".join(
        [
            f"(define (problem vineyard-{lines}-{grapes})",
            "  (:domain vineyard)",
            f"  (:objects rob - harvester sup - support {' '.join(places[:-1])} - line",
            f"    wh - warehouse {' '.join(grape for grape, _ in where)} - grape b - box)",
            "  (:init",
            *(f"    {fact}" for fact in facts),
            "  )",
            f"  (:goal (and {wanted})))\n",
        ]
    )


def goal_text(lines: int) -> str:
    """Clear every line, never enter one while the box is full."""
    clear = [f"F cleared_l{i}" for i in range(lines)]
    outside = [f"!robot_at_rob_l{i}" for i in range(lines)]
    return " & ".join([*clear, *(f"G((full_b & {away}) -> WX {away})" for away in outside)])


def measured(lines: int, grapes: int, known: str, timeout: float) -> Measured:
    """Plan for a vineyard in a process of its own."""
    with tempfile.TemporaryDirectory() as folder:
        problem, out = Path(folder) / "problem.pddl", Path(folder) / "policy.json"
        problem.write_text(problem_text(lines, grapes, known))
        command = [sys.executable, "-m", "plainspoken", "plan", "--domain", str(DOMAIN)]
        command += ["--problem", str(problem), "--goal", goal_text(lines), "--out", str(out)]
        started = time.perf_counter()
        process = subprocess.Popen([*command, "--timeout", str(timeout)], stdout=subprocess.DEVNULL)
        _, _, usage = os.wait4(process.pid, 0)
        wall = time.perf_counter() - started
        policy = json.loads(out.read_text())
        return Measured(
            lines,
            policy["status"],
            wall,
            usage.ru_utime + usage.ru_stime,
            usage.ru_maxrss / 1024,
            len(policy["nodes"]),
            out.stat().st_size / 1e6,
            policy["seconds"],
        )


def exponent(found: list[Measured]) -> float | None:
    """The slope of log seconds over log lines; None where the solved sizes are too close."""
    points = [(log(each.lines), log(each.cpu)) for each in found if each.status == "solved"]
    if not points or max(points)[0] - min(points)[0] < log(3.9):
        return None
    x_mean = sum(x for x, _ in points) / len(points)
    y_mean = sum(y for _, y in points) / len(points)
    above = sum((x - x_mean) * (y - y_mean) for x, y in points)
    return above / sum((x - x_mean) ** 2 for x, _ in points)


def table(found: list[Measured], *, markdown: bool) -> str:
    """A row for each size, and the exponents."""
    stages = ("parse", "ground", "automaton", "search")
    head = ["lines", "status", "wall s", "CPU s", "MB", "nodes", "file MB", *stages]
    rows = [
        [
            str(each.lines),
            each.status,
            f"{each.wall:.2f}",
            f"{each.cpu:.2f}",
            f"{each.megabytes:.0f}",
            str(each.nodes),
            f"{each.file_megabytes:.2f}",
            *(f"{each.stages.get(stage, 0):.2f}" for stage in stages),
        ]
        for each in found
    ]
    if markdown:
        lines = [f"| {' | '.join(row)} |" for row in (head, ["---"] * len(head), *rows)]
    else:
        lines = ["".join(f"{cell:>11}" for cell in row) for row in (head, *rows)]
    for title, part in (("all sizes", found), ("16 lines on", [f for f in found if f.lines > 15])):
        slope = exponent(part)
        if slope is not None:
            lines += ["", f"CPU seconds grow as lines to the power of {slope:.2f} ({title})."]
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--lines", default="4,16,64,256")
    parser.add_argument("--grapes", type=int, default=1, help="grapes on each line")
    parser.add_argument("--known", choices=["ripe", "unripe", "unchecked"], default="ripe")
    parser.add_argument("--timeout", type=float, default=600.0)
    parser.add_argument("--write", type=Path, metavar="FOLDER")
    parser.add_argument("--markdown", action="store_true")
    chosen = parser.parse_args()
    sizes = [int(text) for text in chosen.lines.split(",")]
    if chosen.write:
        for lines in sizes:
            problem = problem_text(lines, chosen.grapes, chosen.known)
            (chosen.write / f"vineyard-{lines}.pddl").write_text(problem)
            (chosen.write / f"vineyard-{lines}.ltlf").write_text(goal_text(lines) + "\n")
        return
    found = []
    for lines in sizes:
        found.append(measured(lines, chosen.grapes, chosen.known, chosen.timeout))
        print(found[-1], file=sys.stderr, flush=True)
    print(table(found, markdown=chosen.markdown))


if __name__ == "__main__":
    main()
