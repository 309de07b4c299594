"""The solver against exhaustive fixpoints on small random tasks, explanations included.

    python benchmarks/differential.py [--count N] [--first SEED]

Each task has an LTLf goal over atoms and action symbols, and nested, conditional and quantified
effects (`tests/strategies.py`). What is compared, for each of strong and strong-cyclic: whether
there is a policy; whether the policy is valid; and whether the parts named as impossible are so,
and possible without any one of them. Exit status 1 where anything differs.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from pathlib import Path
from random import Random

ROOT = Path(__file__).resolve().parents[1]


def compared(seed: int, counts: Counter[str]) -> list[str]:
    """What differs for one task."""
    from tests.planning.brute import is_solvable
    from tests.planning.explained import fault
    from tests.strategies import Builder, problem_with_goal

    from plainspoken.logic.formula import atoms, conjunction
    from plainspoken.planning.goal import problem_goal
    from plainspoken.planning.solver import Solved, Unsolvable, solve
    from plainspoken.planning.validation import Invalid, validate

    problem, goal = problem_with_goal(seed)
    if seed % 3 == 0:
        goal = conjunction(problem_goal(problem), goal)
    else:
        names = tuple(sorted(atoms(goal))) or ("done",)
        further = (Builder(Random(-seed - each)).goal(names) for each in range(seed % 4))
        goal = conjunction(goal, *further)
    found = []
    verdicts = {}
    for strong in (True, False):
        kind = "strong" if strong else "strong-cyclic"
        ending = solve(problem, goal, strong=strong)
        verdicts[kind] = isinstance(ending, Solved)
        if verdicts[kind] != is_solvable(problem, goal, strong=strong):
            found.append(f"{seed} {kind}: the solver says {type(ending).__name__}")
        elif isinstance(ending, Solved):
            verdict = validate(problem, goal, ending.policy)
            if isinstance(verdict, Invalid):
                found.append(f"{seed} {kind}: the policy is not valid: {verdict.reason}")
        elif isinstance(ending, Unsolvable):
            reason = ending.reason
            wrong = fault(problem, goal, reason, strong=strong)
            if wrong is not None:
                found.append(f"{seed} {kind}: {reason.said()} {wrong}")
            parts = len(reason.detail()["parts"])
            known = "minimal" if reason.detail()["minimal"] else "not known to be minimal"
            counts[
                f"  why no {kind} policy: {reason.detail()['kind']}, {parts} parts, {known}"
            ] += 1
    if verdicts["strong"]:
        counts["strong"] += 1
    else:
        counts["strong-cyclic only" if verdicts["strong-cyclic"] else "unsolvable"] += 1
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=3000)
    parser.add_argument("--first", type=int, default=0, help="the seed of the first task")
    chosen = parser.parse_args()
    sys.path.insert(0, str(ROOT))
    started = time.monotonic()
    counts: Counter[str] = Counter()
    wrong = []
    for seed in range(chosen.first, chosen.first + chosen.count):
        wrong += compared(seed, counts)
    for name, count in sorted(counts.items(), key=lambda each: (each[0].startswith(" "), each[0])):
        print(f"{count:6}  {name}")
    print(f"{chosen.count} tasks, {len(wrong)} disagreements, {time.monotonic() - started:.0f} s")
    print("\n".join(wrong), end="\n" if wrong else "")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
