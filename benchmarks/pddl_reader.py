"""How long our PDDL reader takes beside the `pddl` package, on the vineyard and on a large problem.

    python benchmarks/pddl_reader.py

Each figure is the median of seven fresh processes, imports included, in milliseconds of CPU time.
"""

import statistics
import subprocess
import sys
import tempfile
from itertools import pairwise
from pathlib import Path

VINEYARD = Path(__file__).parents[1] / "examples" / "vineyard"
OURS = """
from plainspoken.world.pddl import read_domain, read_problem
read_problem(sys.argv[2], read_domain(sys.argv[1]))
"""
THEIRS = """
from pddl import parse_domain, parse_problem
parse_domain(sys.argv[1]); parse_problem(sys.argv[2])
"""
LARGE_DOMAIN = """(define (domain walk) (:requirements :typing :non-deterministic) (:types place)
(:predicates (at ?p - place) (next ?a ?b - place))
(:action walk :parameters (?a ?b - place) :precondition (and (at ?a) (next ?a ?b))
 :effect (oneof (and (not (at ?a)) (at ?b)) (and))))"""


def milliseconds(program: str, domain: Path, problem: Path) -> float:
    timed = f"import sys, time\n{program}\nprint(time.process_time() * 1000)"  # since process start
    command = [sys.executable, "-c", timed, str(domain), str(problem)]
    runs = [
        float(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        for _ in range(7)
    ]
    return statistics.median(runs)


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        domain, problem = Path(folder, "domain.pddl"), Path(folder, "problem.pddl")
        domain.write_text(LARGE_DOMAIN)
        places = [f"p{i}" for i in range(8193)]
        steps = " ".join(f"(next {a} {b})" for a, b in pairwise(places))
        problem.write_text(
            f"(define (problem long) (:domain walk) (:objects {' '.join(places)} - place)"
            f" (:init (at p0) {steps}) (:goal (at p8192)))"
        )
        nothing = milliseconds("", domain, problem)
        print(f"{'Python alone':28}{nothing:8.0f}")
        for name, program in (("plainspoken", OURS), ("pddl", THEIRS)):
            for label, files in (
                ("vineyard", (VINEYARD / "domain.pddl", VINEYARD / "problem.pddl")),
                ("8,193 initial atoms", (domain, problem)),
            ):
                print(f"{name + ', ' + label:28}{milliseconds(program, *files):8.0f}")


if __name__ == "__main__":
    main()
