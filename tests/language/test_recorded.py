"""Replies kept by the hash of their prompt, and a log of what was said."""

import json
from pathlib import Path

import pytest
from tests.language.harbour import HARBOUR, SAID, Fake

from plainspoken.language.completion import CompletionError, Message, Role
from plainspoken.language.prompting import RESPONSE_SCHEMA, extraction_messages
from plainspoken.language.recorded import LOG, RecordedModel, prompt_hash

ASKED = [Message(Role.USER, "the quay?")]


def test_the_same_prompt_is_asked_once(tmp_path: Path) -> None:
    fake = Fake("one", "two")
    first, second = (RecordedModel(fake, "a:b", tmp_path / "new") for _ in range(2))
    assert first(ASKED, {}) == second(ASKED, {}) == "one"
    assert len(fake.asked) == 1


def test_another_model_another_schema_and_another_prompt_are_asked(tmp_path: Path) -> None:
    fake = Fake("reply")
    RecordedModel(fake, "a:b", tmp_path)(ASKED, {})
    RecordedModel(fake, "a:c", tmp_path)(ASKED, {})
    RecordedModel(fake, "a:b", tmp_path)(ASKED, {"type": "object"})
    RecordedModel(fake, "a:b", tmp_path)([*ASKED, *ASKED], {})
    assert len(fake.asked) == 4


def test_the_log_holds_prompt_reply_and_time(tmp_path: Path) -> None:
    ticks = iter([100.0, 100.5, 101.0])
    RecordedModel(Fake("résumé\n\ud83d"), "a:b", tmp_path, lambda: next(ticks))(ASKED, {})
    (line,) = (tmp_path / LOG).read_text().splitlines()
    assert json.loads(line) == {
        "time": 100.0,
        "seconds": 0.5,
        "model": "a:b",
        "prompt": prompt_hash("a:b", ASKED, {}),
        "messages": [{"role": "user", "text": "the quay?"}],
        "reply": "résumé\n?",
    }


def test_a_failure_is_logged_and_not_kept(tmp_path: Path) -> None:
    fake = Fake(CompletionError("the language model refused to answer"), "a reply")
    model = RecordedModel(fake, "a:b", tmp_path)
    with pytest.raises(CompletionError):
        model(ASKED, {})
    assert model(ASKED, {}) == "a reply"
    first, second = (json.loads(line) for line in (tmp_path / LOG).read_text().splitlines())
    assert first["error"] == "the language model refused to answer"
    assert second["reply"] == "a reply"


def test_no_key_of_the_environment_is_written_down(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("OPENAI_API_KEY", "ANTHROPIC_API_KEY", "GOOGLE_API_KEY"):
        monkeypatch.setenv(name, "sk-very-secret")
    RecordedModel(Fake("x"), "a:b", tmp_path)(extraction_messages(SAID, HARBOUR), RESPONSE_SCHEMA)
    written = [file for file in tmp_path.rglob("*") if file.is_file()]
    assert len(written) == 2
    assert not any(b"sk-very-secret" in file.read_bytes() for file in written)


def test_a_folder_that_cannot_be_written_to_is_named(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(CompletionError, match="cannot") as caught:
        RecordedModel(Fake("x"), "a:b", tmp_path / "file")(ASKED, {})
    assert str(tmp_path) in str(caught.value)


def test_the_hash_of_a_prompt_does_not_depend_on_the_order_of_a_schema() -> None:
    assert prompt_hash("m", ASKED, {"a": 1, "b": 2}) == prompt_hash("m", ASKED, {"b": 2, "a": 1})
