"""A real language model on loopback: it proves the wiring, not the quality."""

from contextlib import suppress
from importlib.util import find_spec
from pathlib import Path

import pytest
from tests.language.harbour import HARBOUR, SAID

from plainspoken.backends import local_llm
from plainspoken.backends.local_llm import local_model, packaged_weights, weights
from plainspoken.language.completion import CompletionError, Message, Role
from plainspoken.language.extraction import Status
from plainspoken.language.prompting import RECOGNITION_SCHEMA, recognition_messages
from plainspoken.language.recorded import LOG, RecordedModel
from plainspoken.language.reply import UnusableReplyError, expressions_from
from plainspoken.language.second_opinion import Mode, SecondOpinion
from plainspoken.logic.formula import atoms

missing = [
    name for name in ("pydantic_ai", "xllamacpp", local_llm.WEIGHTS) if find_spec(name) is None
]
with_a_model = pytest.mark.skipif(bool(missing), reason=f"needs {', '.join(missing)}: make llm")


@with_a_model
@pytest.mark.timeout(300)
def test_a_model_on_this_machine_is_asked_and_what_it_says_is_checked(tmp_path: Path) -> None:
    with local_model(patience=120) as model:
        text = model(recognition_messages(SAID), RECOGNITION_SCHEMA)
        assert '"expressions"' in text, "the server keeps the reply to the schema"
        with suppress(UnusableReplyError):
            assert all(each.lower() in SAID.lower() for each in expressions_from(text, SAID))

        # A small model may say anything here; a formula over landmarks or a reason comes out.
        recorded = RecordedModel(model, "local", tmp_path)
        opinion = SecondOpinion(recorded, Mode.LLM, staged=True, patience=20)
        found = opinion(SAID, HARBOUR)
        assert found.status in Status
        if found.formula is not None:
            assert atoms(found.formula) <= set(HARBOUR.landmarks)
        assert (tmp_path / LOG).read_text().count("\n") >= 1


@with_a_model
def test_the_server_answers_nobody_without_its_key() -> None:
    from plainspoken.backends.pydantic_ai import served

    with local_model(patience=30) as model:
        stranger = served(str(model.model.base_url), "m", key="a guess", patience=30)
        with pytest.raises(CompletionError, match="status 401"):
            stranger([Message(Role.USER, "hello")], RECOGNITION_SCHEMA)


def test_weights_are_a_file_or_a_folder_with_one(tmp_path: Path) -> None:
    file = tmp_path / "small.gguf"
    with pytest.raises(CompletionError, match=r"\.gguf"):
        weights(str(tmp_path))
    file.write_bytes(b"")
    assert weights(str(file)) == weights(str(tmp_path)) == file
    (tmp_path / "another.gguf").write_bytes(b"")
    with pytest.raises(CompletionError, match=r"\.gguf"):
        weights(str(tmp_path))


def test_without_the_package_the_error_says_how_to_get_the_weights(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(local_llm, "WEIGHTS", "no_such_package")
    assert packaged_weights() is None
    with pytest.raises(CompletionError) as caught:
        weights(None)
    assert caught.value.hint == local_llm.GET_WEIGHTS


def test_without_the_server_the_error_says_how_to_get_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(local_llm, "is_installed", lambda: False)
    with pytest.raises(CompletionError) as caught, local_model():
        pass
    assert caught.value.hint == local_llm.GET_SERVER
