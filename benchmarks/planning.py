"""Every row of the planning benchmarks, each in a process of its own with a limit on CPU time.

    python benchmarks/planning.py COLLECTION [--limit S] [--only TEXT] [--out CSV] [--svg SVG]
                                  [--markdown] [--warm]

COLLECTION holds `fond/<domain>/<problem>.pddl` and `ltlf/`, each with a `baseline.csv` of what
other planners took. Each row is a run of `plainspoken plan --out`, and its CPU time that of the
whole process: start, imports, parsing, search, validation and writing the policy. The policy that
was written is checked once more, outside the measured time.

With --warm: nothing but the rows that a baseline takes less than a second for, solved some times
in this process; the median without the first round.
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import resource
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from dataclasses import asdict, dataclass
from math import log10
from pathlib import Path

from plainspoken.logic.formula import Formula
from plainspoken.logic.syntax import parse
from plainspoken.planning.goal import problem_goal
from plainspoken.planning.policy import read_policy
from plainspoken.planning.solver import solve
from plainspoken.planning.validation import Valid, validate
from plainspoken.world.domain import Problem
from plainspoken.world.pddl import read_domain, read_problem

Baselines = dict[str, dict[str, tuple[str, float]]]
"""Status and CPU seconds of other planners, by row and planner."""


@dataclass(frozen=True)
class Row:
    """One problem, and the formula where it is not the problem's own goal."""

    name: str
    domain: Path
    problem: Path
    formula: str | None


@dataclass(frozen=True)
class Run:
    """How one row ended. cpu: seconds of the whole process; checked: what the validator says."""

    name: str
    status: str
    cpu: float
    nodes: int
    checked: str


def domain_of(problem: Path) -> Path:
    """The domain file beside a problem: one of the same suffix, or the only one."""
    own = problem.with_name(problem.name.replace("p_", "d_", 1))
    if own != problem and own.exists():
        return own
    return next(iter(sorted(problem.parent.glob("domain*.pddl"))))


def rows_of(collection: Path) -> list[Row]:
    found = []
    for problem in sorted((collection / "fond").glob("*/p*.pddl")):
        name = f"{problem.parent.name}/{problem.stem}"
        found.append(Row(name, domain_of(problem), problem, None))
    baseline = collection / "ltlf" / "baseline.csv"
    with baseline.open(newline="") as file:
        for line in csv.DictReader(file):
            ltlf = collection / "ltlf"
            found.append(
                Row(
                    f"ltlf/{line['id']}",
                    ltlf / line["domain"],
                    ltlf / line["problem"],
                    line["formula"],
                )
            )
    return found


def baselines(collection: Path) -> Baselines:
    """What the other planners took."""
    found: Baselines = {}
    with (collection / "fond" / "baseline.csv").open(newline="") as file:
        for line in csv.DictReader(file):
            name = f"{line['domain']}/{Path(line['problem']).stem}"
            found.setdefault(name, {})[line["planner"]] = (line["status"], float(line["cpu"]))
    with (collection / "ltlf" / "baseline.csv").open(newline="") as file:
        for line in csv.DictReader(file):
            spent = (line["status"], float(line["total_cpu"]))
            found.setdefault(f"ltlf/{line['id']}", {})["fond4ltlf"] = spent
    return found


def run(row: Row, limit: int) -> Run:
    """Solve a row by the command line under a CPU limit, and have its policy checked."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "policy.json"
        site = ["--domain", str(row.domain), "--problem", str(row.problem)]
        goal = ["--goal", row.formula] if row.formula else []
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        finished = subprocess.run(
            [sys.executable, "-m", "plainspoken", "plan", *site, *goal, "--out", str(out)],
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1)),
            stdout=subprocess.DEVNULL,
            stderr=None if os.environ.get("SHOW") else subprocess.DEVNULL,
            check=False,
        )
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        if not out.exists():
            # The kernel's count of the limit and ours differ by a second or so: ask the signal.
            stopped = -finished.returncode in (signal.SIGXCPU, signal.SIGKILL)
            return Run(row.name, "out of time" if stopped else "failed", cpu, 0, "")
        policy = json.loads(out.read_text())
        if policy["status"] != "solved":
            return Run(row.name, policy["status"], cpu, 0, policy["reason"])
        checked = subprocess.run(
            [sys.executable, __file__, "--check", *map(str, (row.domain, row.problem, out))],
            input=row.formula or "",
            capture_output=True,
            text=True,
            check=False,
        ).stdout.strip()
        return Run(row.name, "solved", cpu, len(policy["nodes"]), checked)


def goal_of(problem: Problem, formula: str | None) -> Formula:
    return parse(formula) if formula else problem_goal(problem)


def check(domain_file: str, problem_file: str, policy_file: str) -> None:
    """What the checking process does; the formula stands in its input."""
    problem = read_problem(problem_file, read_domain(domain_file))
    verdict = validate(problem, goal_of(problem, sys.stdin.read()), read_policy(policy_file))
    print("valid" if isinstance(verdict, Valid) else f"INVALID: {verdict.reason}")


def warm_milliseconds(row: Row, rounds: int = 7) -> tuple[float, float]:
    """The median of some rounds in this process: to solve, and to read the files and solve."""
    solving, whole = [], []
    for _ in range(rounds + 1):
        started = time.perf_counter()
        problem = read_problem(row.problem, read_domain(row.domain))
        goal = goal_of(problem, row.formula)
        read = time.perf_counter()
        solve(problem, goal)
        ended = time.perf_counter()
        solving.append(1000 * (ended - read))
        whole.append(1000 * (ended - started))
    # The first round imports and fills caches.
    return statistics.median(solving[1:]), statistics.median(whole[1:])


def warm_table(rows: list[Row], known: Baselines) -> str:
    """Warm times of the rows that take some baseline less than a second."""
    lines = [f"{'row':28} {'baseline s':>10} {'solve ms':>9} {'read + solve ms':>16}"]
    for row in rows:
        spent = [cpu for status, cpu in known.get(row.name, {}).values() if status == "solved"]
        if spent and min(spent) < 1:
            solving, whole = warm_milliseconds(row)
            lines.append(f"{row.name:28} {min(spent):10.2f} {solving:9.1f} {whole:16.1f}")
    return "\n".join(lines)


def table(runs: list[Run], known: Baselines, *, markdown: bool) -> str:
    """The rows beside the baselines, and the totals."""
    planners = {"prp": "PRP", "pal": "Paladinus", "fond4ltlf": "FOND4LTLf+PRP"}
    rows = [["row", "status", "CPU s", "nodes", *planners.values()]]
    for each in runs:
        shown = []
        for planner in planners:
            status, cpu = known.get(each.name, {}).get(planner, ("", 0.0))
            shown.append(f"{cpu:.2f}" if status == "solved" else "-" if status else "")
        status = each.status if each.checked in ("", "valid") else f"{each.status} (!)"
        if each.status == "unsolvable":
            status = "unsolvable, proven"
        rows.append([each.name, status, f"{each.cpu:.2f}", str(each.nodes or ""), *shown])
    if markdown:
        rows.insert(1, ["---"] * len(rows[0]))
        lines = [f"| {' | '.join(row)} |" for row in rows]
    else:
        widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
        lines = [
            "  ".join(
                cell.ljust(width) if i < 2 else cell.rjust(width)
                for i, (cell, width) in enumerate(zip(row, widths, strict=True))
            )
            for row in rows
        ]
    return "\n".join([*lines, "", *totals(runs, known)])


def totals(runs: list[Run], known: Baselines) -> list[str]:
    """A sentence for each acceptance figure."""
    lines = [f"{each.name}: {each.checked}" for each in runs if each.checked not in ("", "valid")]
    for title, chosen in (("FOND", False), ("LTLf", True)):
        part = [r for r in runs if r.name.startswith("ltlf/") == chosen]
        solved = sum(r.status == "solved" and r.checked == "valid" for r in part)
        no = sum(r.status == "unsolvable" for r in part)
        found = f"{solved} solved with a checked policy, {no} proven unsolvable"
        lines.append(f"{title}: {found}, of {len(part)}")
    ratios = [
        r.cpu / known[r.name]["prp"][1]
        for r in runs
        if r.status == "solved" and known.get(r.name, {}).get("prp", ("", 0))[0] == "solved"
    ]
    if ratios:
        lines.append(
            f"CPU to PRP on {len(ratios)} common rows, median: {statistics.median(ratios):.2f}"
        )
    slowest = max((r.cpu for r in runs if r.name.startswith("ltlf/")), default=0)
    lines.append(f"slowest LTLf row: {slowest:.2f} s")
    return lines


def coverage_svg(runs: list[Run], known: Baselines, limit: float) -> str:
    """How many FOND rows are decided within a CPU time, on a logarithmic axis."""
    decided = {r.name: r.cpu for r in runs if r.status in ("solved", "unsolvable")}
    names = {r.name for r in runs if not r.name.startswith("ltlf/")}
    series = {"plainspoken": sorted(cpu for name, cpu in decided.items() if name in names)}
    for title, planner in (("PRP", "prp"), ("Paladinus", "pal")):
        spent = [known.get(name, {}).get(planner, ("", 0.0)) for name in names]
        series[title] = sorted(cpu for status, cpu in spent if status == "solved")
    left, right, top, bottom, low = 50, 520, 20, 320, 0.05

    def x(seconds: float) -> float:
        share = (log10(max(seconds, low)) - log10(low)) / (log10(limit) - log10(low))
        return left + (right - left) * share

    def y(count: int) -> float:
        return bottom - (bottom - top) * count / max(len(names), 1)

    parts = [
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 640 360" font-size="12">',
        '<rect width="640" height="360" fill="white"/>',
    ]
    for tick in (0.1, 1, 10, limit):
        parts.append(_line(x(tick), top, x(tick), bottom))
        parts.append(_text(x(tick), bottom + 18, f"{tick:g} s", "middle"))
    for count in range(0, len(names) + 1, 10):
        parts.append(_line(left, y(count), right, y(count)))
        parts.append(_text(left - 8, y(count) + 4, str(count), "end"))
    colours = ("#00a862", "#3366cc", "#cc6633")
    for (title, times), colour in zip(series.items(), colours, strict=True):
        steps = " ".join(f"H {x(time):.1f} V {y(n):.1f}" for n, time in enumerate(times, 1))
        path = f"M {left} {y(0):.1f} {steps} H {right}"
        parts.append(f'<path d="{path}" fill="none" stroke="{colour}" stroke-width="2"/>')
        parts.append(_text(right + 6, y(len(times)) + 4, f"{title} {len(times)}", "start"))
    parts.append(_text((left + right) / 2, 354, "CPU time of the whole process", "middle"))
    return "\n".join([*parts, "</svg>"]) + "\n"


def _line(x1: float, y1: float, x2: float, y2: float) -> str:
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="#ddd"/>'


def _text(x: float, y: float, text: str, anchor: str) -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{text}</text>'


def main() -> None:
    if sys.argv[1:2] == ["--check"]:
        check(*sys.argv[2:5])
        return
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("collection", type=Path)
    parser.add_argument("--limit", type=int, default=60)
    parser.add_argument("--only", default="", help="rows whose name has one of these, by commas")
    parser.add_argument("--out", type=Path)
    parser.add_argument("--svg", type=Path)
    parser.add_argument("--markdown", action="store_true", help="a table for docs/results.md")
    parser.add_argument("--warm", action="store_true", help="only warm times, in this process")
    chosen = parser.parse_args()
    known = baselines(chosen.collection)
    rows = [
        row
        for row in rows_of(chosen.collection)
        if any(text in row.name for text in chosen.only.split(","))
    ]
    if chosen.warm:
        print(warm_table(rows, known))
        return
    runs = []
    for row in rows:
        runs.append(run(row, chosen.limit))
        print(runs[-1], file=sys.stderr, flush=True)
    print(table(runs, known, markdown=chosen.markdown))
    if chosen.out:
        with chosen.out.open("w", newline="") as file:
            writer = csv.DictWriter(file, list(asdict(runs[0])))
            writer.writeheader()
            writer.writerows(map(asdict, runs))
    if chosen.svg:
        chosen.svg.write_text(coverage_svg(runs, known, chosen.limit))


if __name__ == "__main__":
    main()
