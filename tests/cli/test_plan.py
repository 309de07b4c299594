"""What `plan` says where there is no policy, and the ways to look at one."""

from __future__ import annotations

import json
from pathlib import Path

from click.testing import CliRunner

from plainspoken.cli.check import check
from plainspoken.cli.export import export
from plainspoken.cli.plan import plan

VINEYARD = Path(__file__).resolve().parents[2] / "examples" / "vineyard"
FILES = ["--domain", str(VINEYARD / "domain.pddl"), "--problem", str(VINEYARD / "problem.pddl")]


def test_why_there_is_no_policy_is_said_in_words_and_kept_with_formulas(tmp_path: Path) -> None:
    out = tmp_path / "no.json"
    goal = "F cleared_l2 & F cleared_l0 & G !robot_at_rob_l2"
    done = CliRunner().invoke(plan, ["--goal", goal, "--out", str(out)])
    assert done.exit_code == 3
    document = json.loads(out.read_text())
    reason = document["reason"]
    assert "line 2 is cleared" in reason
    assert "never visit line 2" in reason
    assert "line 0" not in reason
    assert not any(sign in reason for sign in ("_", "&", "G !"))
    assert document["reason_detail"]["parts"] == ["F cleared_l2", "G !robot_at_rob_l2"]


def test_a_lucky_way_is_told_and_taken_only_on_request(tmp_path: Path) -> None:
    no = CliRunner().invoke(plan, ["--goal", "F stored_g2"])
    assert no.exit_code == 3
    assert "With luck: move to line 1, move to line 2, check grape 2" in no.output
    assert "when I check grape 2, it may be that grape 2 is unripe" in no.output
    assert "--lucky" in no.stderr
    out = tmp_path / "weak.json"
    yes = CliRunner().invoke(plan, ["--goal", "F stored_g2", "--lucky", "--out", str(out)])
    assert yes.exit_code == 0
    assert "only with luck" in yes.stderr
    document = json.loads(out.read_text())
    assert (document["status"], document["kind"]) == ("solved", "weak")
    assert document["gaps"]
    judged = CliRunner().invoke(check, [*FILES, "-g", "F stored_g2", "--policy", str(out)])
    assert judged.exit_code == 0
    assert "no guarantee" in judged.output


def test_a_policy_is_exported_as_rules_and_as_a_compact_diagram(tmp_path: Path) -> None:
    out = str(tmp_path / "policy.json")
    goal = "F cleared_l1 & F cleared_l2"
    assert CliRunner().invoke(plan, ["--goal", goal, "--out", out]).exit_code == 0
    listed = CliRunner().invoke(export, ["rules", out, "--words"]).output
    assert "if grape 1 is unripe: sign off line 1" in listed
    whole = CliRunner().invoke(export, ["mermaid", out]).output
    compact = CliRunner().invoke(export, ["mermaid", out, "--compact"]).output
    assert len(compact.splitlines()) < len(whole.splitlines())
