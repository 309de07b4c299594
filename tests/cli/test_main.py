"""The command line as a stranger meets it: help, exit statuses, errors."""

import json
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
VINEYARD = ROOT / "examples" / "vineyard"
SITE = ["--domain", str(VINEYARD / "domain.pddl"), "--problem", str(VINEYARD / "problem.pddl")]


def run(*arguments: str, cwd: Path, **more: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "plainspoken", *arguments],
        cwd=cwd,
        env={**os.environ, "PLAINSPOKEN_HOME": str(cwd / "home"), "COLUMNS": "100", **more},
        capture_output=True,
        text=True,
        check=False,
        stdin=subprocess.DEVNULL,
    )


def test_help_lists_every_command_with_an_example_and_is_quick(tmp_path: Path) -> None:
    started = time.perf_counter()
    done = run("--help", cwd=tmp_path)
    assert done.returncode == 0
    for command in ("demo", "extract", "plan", "check", "export", "run", "ask", "eval", "doctor"):
        assert command in done.stdout
    assert time.perf_counter() - started < 2, "a loaded machine may take its time, not this much"
    loaded = subprocess.run(
        [sys.executable, "-X", "importtime", "-m", "plainspoken", "--help"],
        capture_output=True,
        text=True,
        check=True,
    ).stderr
    for slow in ("simplemma", "rich.console", "sqlite3", "plainspoken.pipeline"):
        assert slow not in loaded


@pytest.mark.parametrize(
    "command",
    [
        "demo",
        "extract",
        "plan",
        "check",
        "export",
        "run",
        "ask",
        "missions",
        "work",
        "eval",
        "doctor",
    ],
)
def test_every_command_has_help(command: str, tmp_path: Path) -> None:
    done = run(command, "--help", cwd=tmp_path)
    assert done.returncode == 0
    assert "Usage" in done.stdout


def test_the_demo_tells_the_whole_story(tmp_path: Path) -> None:
    done = run("demo", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    for heading in ("referring expressions", "formula", "said back", "plan", "what to try next"):
        assert heading in done.stdout
    assert "everything asked for is satisfied" in done.stdout
    again = run("ask", "What did you do?", cwd=tmp_path)
    assert again.returncode == 0
    assert "call" in again.stdout


def test_plan_check_and_export_work_together(tmp_path: Path) -> None:
    goal = "F cleared_l2 & G !robot_at_rob_l3"
    planned = run("plan", *SITE, "--goal", goal, "--out", "policy.json", cwd=tmp_path)
    assert planned.returncode == 0, planned.stderr
    document = json.loads((tmp_path / "policy.json").read_text())
    assert document["status"] == "solved"
    assert set(document["seconds"]) >= {"parse", "ground", "automaton", "search", "total"}
    checked = run("check", *SITE, "--goal", goal, "--policy", "policy.json", cwd=tmp_path)
    assert checked.returncode == 0, checked.stdout + checked.stderr
    other = run("check", *SITE, "--goal", "F cleared_l1", "--policy", "policy.json", cwd=tmp_path)
    assert other.returncode == 3
    assert run("export", "dot", "policy.json", cwd=tmp_path).stdout.startswith("digraph")
    assert run("export", "mermaid", "policy.json", cwd=tmp_path).stdout.startswith("flowchart")
    assert run("export", "hoa", goal, cwd=tmp_path).stdout.count("HOA: v1") == 2


def test_an_unsolvable_goal_is_a_no_that_is_written_down(tmp_path: Path) -> None:
    done = run("plan", *SITE, "--goal", "robot_at_rob_l1", "--out", "no.json", cwd=tmp_path)
    assert done.returncode == 3
    document = json.loads((tmp_path / "no.json").read_text())
    assert document["status"] == "unsolvable"
    assert document["reason"]


def test_a_run_is_recorded_and_can_be_asked_about_at_any_step(tmp_path: Path) -> None:
    done = run("run", "--say", "Clear line 2", "--log", "run.jsonl", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    lines = [json.loads(line) for line in (tmp_path / "run.jsonl").read_text().splitlines()]
    assert [line["step"] for line in lines] == list(range(len(lines)))
    assert lines[0]["kind"] == "mission_accepted"
    assert lines[-1]["kind"] == "mission_ended"
    (tmp_path / "q.jsonl").write_text('{"id": 1, "question": "What are you doing?"}\n')
    batch = ["ask", "--log", "run.jsonl", "--at", "4", "--batch", "q.jsonl", "--out", "a.jsonl"]
    assert run(*batch, cwd=tmp_path).returncode == 0
    answer = json.loads((tmp_path / "a.jsonl").read_text())
    assert answer["kind"] == "now"
    assert {"fluent", "from", "to", "certainty"} <= set(answer["claims"][0])
    again = run("run", "--say", "Clear line 2", "--log", "run.jsonl", cwd=tmp_path)
    assert again.returncode == 2
    assert "--overwrite" in again.stderr


def test_extract_batch_answers_every_line_with_the_fields_of_the_contract(tmp_path: Path) -> None:
    (tmp_path / "in.jsonl").write_text(
        '{"id": "a", "utterance": "Visit line 2"}\n\n{"id": "b", "utterance": "Sing a song"}\n'
    )
    landmarks = str(VINEYARD / "landmarks.json")
    batch = ["extract", "--landmarks", landmarks, "--batch", "in.jsonl", "--out", "out.jsonl"]
    assert run(*batch, cwd=tmp_path).returncode == 0
    good, bad = map(json.loads, (tmp_path / "out.jsonl").read_text().splitlines())
    assert good["id"] == "a"
    assert good["formula"] == good["literal"] == "F robot_at_rob_l2"
    assert good["referring_expressions"][0]["start"] == 6
    assert bad["status"] == "reject"
    assert bad["reason"]


def test_a_sentence_that_cannot_be_grounded_is_refused_with_its_words(tmp_path: Path) -> None:
    done = run("extract", "Visit the moon", cwd=tmp_path)
    assert done.returncode == 3
    assert "moon" in done.stderr


OTHER_POLICY = json.dumps(
    {
        "status": "solved",
        "kind": "strong",
        "goal": "F at_home",
        "initial": 0,
        "static": [],
        "nodes": [{"id": 0, "state": ["at home"], "action": None, "successors": []}],
    }
)
BAD = {
    "missing file": (["plan", "-d", "nowhere.pddl", "-p", "p.pddl"], "nowhere.pddl"),
    "broken PDDL": (["plan", "-d", "broken.pddl", "-p", str(VINEYARD / "problem.pddl")], ":2"),
    "unknown symbol": (["plan", *SITE, "--goal", "F robot_at_rob_l9"], "robot_at_rob_l9"),
    "bad formula": (["plan", *SITE, "--goal", "F (a & & b)"], "^"),
    "landmark of nothing": (["run", *SITE, "--landmarks", "odd.json"], "robot_at_rob_l9"),
    "landmarks that are no JSON": (
        ["extract", "Visit line 1", "--landmarks", "broken.pddl"],
        "broken.pddl:1",
    ),
    "no policy in the file": (
        ["check", *SITE, "--goal", "F cleared_l2", "--policy", "none.json"],
        "none.json",
    ),
    "policy of another problem": (
        ["check", *SITE, "--goal", "F cleared_l2", "--policy", "other.json"],
        "other.json",
    ),
    "a log that is none": (["ask", "What now?", "--log", "odd.json"], "odd.json:1"),
    "a step that is none": (["ask", "What now?", "--mission", "nobody"], "nobody"),
    "half a problem": (["plan", "--domain", "d.pddl"], "--problem"),
    "batch line that is none": (["extract", "--batch", "odd.json"], "odd.json:1"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_input_is_an_error_with_its_place_and_writes_nothing(case: str, tmp_path: Path) -> None:
    (tmp_path / "broken.pddl").write_text("(define (domain d)\n  (:predicates (p)\n")
    (tmp_path / "none.json").write_text('{"status": "unsolvable"}')
    (tmp_path / "other.json").write_text(OTHER_POLICY)
    (tmp_path / "odd.json").write_text(
        '{"robot_at_rob_l9": {"description": "line 9", "type": "location"}}'
    )
    arguments, named = BAD[case]
    before = sorted(tmp_path.iterdir())
    done = run(*arguments, *(["--out", "out"] if arguments[0] == "plan" else []), cwd=tmp_path)
    assert done.returncode == 2, done.stdout + done.stderr
    assert named in done.stderr
    assert "Traceback" not in done.stderr
    assert [path for path in sorted(tmp_path.iterdir()) if path.name != "home"] == before


@pytest.mark.parametrize("sentence", ["", "   ", "🍇🍇🍇", "visita la riga due", "x " * 5000])
def test_what_is_no_mission_is_refused_politely(sentence: str, tmp_path: Path) -> None:
    done = run("extract", sentence, cwd=tmp_path)
    assert done.returncode in (2, 3)
    assert done.stderr
    assert "Traceback" not in done.stderr
