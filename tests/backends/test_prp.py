"""An external PRP, played by a program that writes the format of PRP 0.4."""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

import pytest

from plainspoken.backends.prp import PrpError, read_prp_policy, solve_with_prp
from plainspoken.logic.syntax import parse
from plainspoken.planning.solver import OutOfTime, Solved
from plainspoken.planning.validation import Valid, validate
from plainspoken.world.domain import Problem
from plainspoken.world.pddl import read_domain, read_problem

ROOT = Path(__file__).resolve().parents[2]
VINEYARD = ROOT / "examples" / "vineyard"
GOAL = "F cleared_l1 & G(full_b -> !robot_at_rob_l3) & X X X true"

PLAYED = """
import sys
from collections import deque
from pathlib import Path
from plainspoken.planning.goal import problem_goal
from plainspoken.planning.solver import solve
from plainspoken.world.pddl import read_domain, read_problem

problem = read_problem(sys.argv[2], read_domain(sys.argv[1]))
assert sys.argv[3:] == ["--dump-policy", "2"], sys.argv
print("1. Running translator")
ending = solve(problem, problem_goal(problem))
if not hasattr(ending, "policy"):
    print("No solution -- aborting repairs.")
    sys.exit(1)
policy = ending.policy
atoms = sorted({a for node in policy.nodes for a in node.state} | policy.static)
# One variable for the states of the first automaton, as the translator would find; else two values.
group = [a for a in atoms if a.startswith("at-1-")]
variables = [[f"Atom {a}()" for a in group] + ["<none of those>"]]
variables += [[f"Atom {a}()", f"NegatedAtom {a}()"] for a in atoms if a not in group]
with open("output", "w") as out:
    print("begin_version", 3, "end_version", "begin_metric", 0, "end_metric", sep="\\n", file=out)
    print(len(variables), file=out)
    for i, values in enumerate(variables):
        print("begin_variable", f"var{i}", -1, len(values), *values, sep="\\n", file=out)
        print("end_variable", file=out)
    print("begin_state", "end_state", sep="\\n", file=out)

def holds(node):
    true = {f"Atom {a}()" for a in node.state | policy.static}
    return " ".join(
        f"var{i}:{next((k for k, v in enumerate(values) if v in true), len(values) - 1)}"
        for i, values in enumerate(variables)
    )

distance = {node.id: 0 for node in policy.nodes if node.action is None}
todo = deque(distance)
while todo:
    id = todo.popleft()
    for node in policy.nodes:
        if id in node.successors and node.id not in distance:
            distance[node.id] = distance[id] + 1
            todo.append(node.id)
with open("policy.out", "w") as out, open("policy.fsap", "w") as fsap:
    for node in sorted(policy.nodes, key=lambda node: distance[node.id]):
        act = f"{node.action}  / SC / d={distance[node.id]}" if node.action else "goal / SC / d=0"
        print(f"\\nIf holds: {holds(node)}\\nExecute: {act}", file=out)
        if node.action:
            # A nearer rule that is forbidden, and a far one that is not strong-cyclic.
            other = next(a.name for a in problem.domain.actions if a.name != node.action)
            print(f"\\nIf holds: {holds(node)}\\nExecute: {other}  / SC / d=0", file=out)
            print(f"\\nIf holds: {holds(node)}\\nForbid: {other} ", file=fsap)
            print(f"\\nIf holds: {holds(node)}\\nExecute: {other} / NSC / d=0", file=out)
sys.exit(6)
"""


def program(folder: Path, text: str) -> Path:
    path = folder / "prp"
    path.write_text(f"#!{sys.executable}\n{text}")
    path.chmod(0o755)
    return path


@pytest.fixture(scope="module")
def vineyard() -> Problem:
    return read_problem(VINEYARD / "problem.pddl", read_domain(VINEYARD / "domain.pddl"))


def test_a_policy_is_read_back_mapped_to_the_original_problem_and_valid(
    vineyard: Problem, tmp_path: Path
) -> None:
    ending = solve_with_prp(vineyard, parse(GOAL), program(tmp_path, PLAYED), timeout=60)
    assert isinstance(ending, Solved)
    assert ending.policy.goal
    assert isinstance(validate(vineyard, parse(GOAL), ending.policy), Valid)


def test_where_it_finds_none_the_error_repeats_what_it_printed(
    vineyard: Problem, tmp_path: Path
) -> None:
    impossible = parse("F cleared_l1 & G robot_at_rob_l0")
    with pytest.raises(PrpError, match="found no policy") as caught:
        solve_with_prp(vineyard, impossible, program(tmp_path, PLAYED), timeout=60)
    assert "Running translator" in str(caught.value)


def test_what_fails_says_how(vineyard: Problem, tmp_path: Path) -> None:
    goal = parse("F cleared_l1")
    with pytest.raises(PrpError, match="cannot run"):
        solve_with_prp(vineyard, goal, tmp_path / "nowhere")
    with pytest.raises(PrpError, match="left no policy") as caught:
        solve_with_prp(vineyard, goal, program(tmp_path, "raise SystemExit('command time: no')"))
    assert "command time: no" in str(caught.value)


@pytest.mark.parametrize(
    ("old", "new", "what"),
    [
        ('f"{node.action}  / SC', 'f"do-nothing  / SC', "not applicable"),
        ("sorted(policy.nodes, key", "sorted(policy.nodes[1:], key", "no rule"),
        ("Execute: {act}", "Do: {act}", "format of 0.4"),
        ("{holds(node)}\\nExecute: {act}", "var99:0\\nExecute: {act}", "var99"),
    ],
)
def test_what_cannot_be_read_is_refused(
    old: str, new: str, what: str, vineyard: Problem, tmp_path: Path
) -> None:
    assert old in PLAYED
    text = PLAYED.replace(old, new)
    with pytest.raises(PrpError, match=what):
        solve_with_prp(vineyard, parse("F cleared_l1"), program(tmp_path, text), timeout=60)


def is_gone(pid: int) -> bool:
    """Whether a process ends soon; one that nobody has waited for yet counts as ended."""
    for _ in range(50):
        state = subprocess.run(
            ["ps", "-o", "stat=", "-p", str(pid)], capture_output=True, text=True, check=False
        ).stdout.strip()
        if not state or state.startswith("Z"):
            return True
        time.sleep(0.1)
    return False


def test_time_is_a_limit_for_all_of_its_processes(vineyard: Problem, tmp_path: Path) -> None:
    mark = tmp_path / "pid"
    text = (
        "import subprocess\n"
        "child = subprocess.Popen(['sleep', '60'])\n"
        f"open({str(mark)!r}, 'w').write(str(child.pid))\n"
        "child.wait()"
    )
    started = time.monotonic()
    ending = solve_with_prp(vineyard, parse("F cleared_l1"), program(tmp_path, text), timeout=1)
    assert isinstance(ending, OutOfTime)
    assert time.monotonic() - started < 30
    assert is_gone(int(mark.read_text()))


def test_memory_is_limited(vineyard: Problem, tmp_path: Path) -> None:
    text = "import time\ntime.sleep(0.3)\nx = bytearray(2 << 30)\nopen('policy.out', 'w')"
    with pytest.raises(PrpError, match="left no policy") as caught:
        solve_with_prp(
            vineyard, parse("F cleared_l1"), program(tmp_path, text), timeout=60, memory=1 << 30
        )
    assert "MemoryError" in str(caught.value)


def test_a_policy_without_a_task_is_no_policy(tmp_path: Path) -> None:
    (tmp_path / "policy.out").write_text("")
    with pytest.raises(PrpError, match="no output"):
        read_prp_policy(tmp_path)


def test_the_command_line_takes_it_as_an_engine(tmp_path: Path) -> None:
    out = tmp_path / "policy.json"
    plan = [sys.executable, "-m", "plainspoken", "plan", "--goal", GOAL]
    prp = str(program(tmp_path, PLAYED))
    subprocess.run([*plan, "--engine", "prp", "--prp", prp, "--out", str(out)], check=True)
    site = ["--domain", str(VINEYARD / "domain.pddl"), "--problem", str(VINEYARD / "problem.pddl")]
    check = [sys.executable, "-m", "plainspoken", "check", *site, "--goal", GOAL]
    subprocess.run([*check, "--policy", str(out)], check=True)
    refused = subprocess.run(
        [*plan, "--engine", "prp", "--prp", prp, "--strong"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert refused.returncode == 2
    assert "strong-cyclic" in refused.stderr
