"""Automata of formulas that make others explode: seconds and peak memory, each in a process.

    python benchmarks/automata.py [--markdown]

The automata are explored to the end, as for planning: one for each conjunct, every state that can
be reached, whether it can still accept, and the guards between them. The targets are a second and
200 MB for each formula, the process included.
"""

from __future__ import annotations

import argparse
import json
import re
import resource
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

FORMULAS = {
    "F a1 & ... & F a14": " & ".join(f"F a{i}" for i in range(14)),
    "F(a1 & F(a2 & ... )), 40 deep": "F(" * 40 + "true" + "".join(f" & a{i})" for i in range(40)),
    "G(a1 -> F b1) & ..., 12 times": " & ".join(f"G(a{i} -> F b{i})" for i in range(12)),
    "(!a1 U b1) & ..., 12 times": " & ".join(f"(!a{i} U b{i})" for i in range(12)),
}
SECONDS = 1.0
MEGABYTES = 200.0


@dataclass(frozen=True)
class Size:
    """What one formula took. seconds: of the construction alone; the others of the process."""

    seconds: float
    process_seconds: float
    megabytes: float
    automata: int
    states: int


def measured(formula: str) -> Size:
    """Build the automata of a formula in a process of its own."""
    command = [sys.executable, __file__, "--one"]
    done = subprocess.run(command, input=formula, capture_output=True, text=True, check=True)
    return Size(**json.loads(done.stdout))


def build(formula: str) -> Size:
    """What the process does."""
    from plainspoken.automata.construction import automata_for
    from plainspoken.logic.syntax import parse

    started = time.perf_counter()
    automata = automata_for(parse(formula))
    for automaton in automata:
        automaton.can_accept(automaton.initial)  # explores every state
    seconds = time.perf_counter() - started
    megabytes = _most_megabytes()
    return Size(seconds, time.process_time(), megabytes, len(automata), sum(map(len, automata)))


def _most_megabytes() -> float:
    """The most memory that this program had.

    What the system counts for a process begins with what its parent had when it was made, so that
    a large one would be counted here; Linux knows the program's own, too.
    """
    status = Path("/proc/self/status")
    if status.exists():
        found = re.search(r"^VmHWM:\s+(\d+) kB", status.read_text(), re.MULTILINE)
        if found is not None:
            return int(found[1]) / 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--one", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--markdown", action="store_true", help="a table for docs/results.md")
    chosen = parser.parse_args()
    if chosen.one:
        print(json.dumps(vars(build(sys.stdin.read()))))
        return
    rows = [("formula", "automata", "states", "seconds", "CPU s, process", "MB")]
    for name, formula in FORMULAS.items():
        size = measured(formula)
        numbers = (f"{size.seconds:.3f}", f"{size.process_seconds:.2f}", f"{size.megabytes:.0f}")
        rows.append((name, str(size.automata), str(size.states), *numbers))
    for number, row in enumerate(rows):
        if chosen.markdown:
            print(f"| {' | '.join(row)} |" + ("\n|---|---|---|---|---|---|" if not number else ""))
        else:
            print(
                "  ".join(f"{cell:<32}" if i == 0 else f"{cell:>14}" for i, cell in enumerate(row))
            )


if __name__ == "__main__":
    main()
