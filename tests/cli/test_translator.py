"""Choosing who translates, and what the doctor says of language models."""

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from plainspoken.backends import pydantic_ai
from plainspoken.cli import plainspoken
from plainspoken.cli.doctor import model_findings
from plainspoken.language.completion import CompletionError

SAID = "Visit line 2"


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("PLAINSPOKEN_HOME", str(tmp_path))
    for name in ("PLAINSPOKEN_MODEL", "OPENAI_BASE_URL", *pydantic_ai.KEYS["openai"]):
        monkeypatch.delenv(name, raising=False)
    return tmp_path


def answer_with(text: str, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Have every model that is named say one thing."""
    named = []

    def connected(name: str, **_: object) -> object:
        named.append(name)
        return lambda *_: text

    monkeypatch.setattr(pydantic_ai, "connected", connected)
    return named


def reading(formula: str) -> str:
    return json.dumps(
        {
            "expressions": [{"text": "line 2", "symbol": "robot_at_rob_l2"}],
            "readings": [{"literal": formula, "executable": formula}],
        }
    )


@pytest.mark.parametrize("command", ["extract", "plan", "run"])
def test_every_command_that_takes_a_sentence_takes_a_translator(command: str) -> None:
    shown = CliRunner().invoke(plainspoken, [command, "--help"]).output
    for option in ("--mode", "--model", "--model-timeout", "--stages", "PLAINSPOKEN_MODEL"):
        assert option in shown


def test_without_a_mode_no_model_is_asked(monkeypatch: pytest.MonkeyPatch, home: Path) -> None:
    named = answer_with("junk", monkeypatch)
    monkeypatch.setenv("PLAINSPOKEN_MODEL", "openai:m")
    done = CliRunner().invoke(plainspoken, ["extract", SAID])
    assert done.exit_code == 0, done.output
    assert named == []
    assert not (home / "completions").exists()


def test_a_mode_without_a_model_is_bad_usage() -> None:
    done = CliRunner().invoke(plainspoken, ["extract", SAID, "--mode", "both"])
    assert done.exit_code == 2
    assert "PLAINSPOKEN_MODEL" in done.output


def test_a_model_is_asked_and_its_words_are_kept(
    monkeypatch: pytest.MonkeyPatch, home: Path
) -> None:
    named = answer_with(reading("F robot_at_rob_l2"), monkeypatch)
    arguments = ["extract", SAID, "--mode", "llm", "--model", "openai:m", "--json"]
    done = CliRunner().invoke(plainspoken, arguments)
    assert done.exit_code == 0, done.output
    assert json.loads(done.output)["formula"] == "F robot_at_rob_l2"
    assert named == ["openai:m"]
    assert (home / "completions" / "log.jsonl").read_text().count("\n") == 1


def test_a_plan_for_a_disagreement_is_not_made_but_asked_about(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    answer_with(reading("G !robot_at_rob_l2"), monkeypatch)
    monkeypatch.setenv("PLAINSPOKEN_MODEL", "openai:m")
    done = CliRunner().invoke(plainspoken, ["plan", "--say", SAID, "--mode", "both"])
    assert done.exit_code == 3
    assert "Which do you mean?" in done.output


def test_a_model_that_cannot_be_reached_is_bad_input() -> None:
    arguments = ["extract", SAID, "--mode", "llm", "--model", "openai:m"]
    done = CliRunner().invoke(plainspoken, arguments)
    assert isinstance(done.exception, CompletionError)


def test_the_doctor_tells_where_a_key_stands_and_never_what_it_is() -> None:
    environment = {
        "ANTHROPIC_API_KEY": "sk-very-secret",
        "OLLAMA_BASE_URL": "http://127.0.0.1:9/v1",
    }
    found = model_findings(environment)
    rows = {row[0]: row for row in found}
    assert rows["anthropic"][1] == "ANTHROPIC_API_KEY"
    assert rows["openai"][1:] == ("", "--model openai:NAME", "set OPENAI_API_KEY")
    assert rows["ollama"][1] == ""
    assert "sk-very-secret" not in str(found)


def test_the_doctor_shows_an_extra_in_its_brackets(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("plainspoken.cli.doctor._version", lambda _: "")
    done = CliRunner().invoke(plainspoken, ["doctor"], env={"COLUMNS": "200"})
    assert "pip install 'plainspoken[llm]'" in done.output
