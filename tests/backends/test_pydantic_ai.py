"""Language models through pydantic-ai, without any provider: its own models for tests."""

import json
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from tests.language.harbour import HARBOUR, SAID, SEQUENCE, reply

from plainspoken.backends import pydantic_ai as backend
from plainspoken.backends.pydantic_ai import ProviderModel, answers, connected
from plainspoken.language.completion import CompletionError, CompletionTimeoutError
from plainspoken.language.extraction import Status, extract
from plainspoken.language.prompting import RESPONSE_SCHEMA, extraction_messages
from plainspoken.language.recorded import RecordedModel
from plainspoken.language.second_opinion import Mode, SecondOpinion
from plainspoken.logic.syntax import parse

with_the_extra = pytest.mark.skipif(
    find_spec("pydantic_ai") is None, reason="needs pydantic-ai: make llm"
)


def function_model(answer: Callable[..., Any], **profile: bool) -> Any:
    """A pydantic-ai model whose reply is computed from the request."""
    from pydantic_ai.messages import ModelResponse, TextPart
    from pydantic_ai.models.function import FunctionModel

    async def respond(messages: Any, info: Any) -> Any:
        said = answer(messages, info)
        said = await said if hasattr(said, "__await__") else said
        return ModelResponse(parts=[TextPart(content=said)])

    return FunctionModel(respond, profile={"supports_json_schema_output": True, **profile})


@with_the_extra
def test_a_request_carries_the_conversation_the_schema_and_temperature_zero() -> None:
    seen = []

    def answer(messages: Any, info: Any) -> str:
        seen.append((messages, info))
        return reply(SEQUENCE)

    asked = extraction_messages(SAID, HARBOUR)
    said = ProviderModel(function_model(answer), patience=7)(asked, RESPONSE_SCHEMA)
    assert said == reply(SEQUENCE)
    ((messages, info),) = seen
    told = [part.content for message in messages for part in message.parts]
    assert told == [message.text for message in asked]
    assert messages[0].parts[0].part_kind == "system-prompt"
    assert messages[-1].parts[0].part_kind == "user-prompt"
    assert info.model_settings["temperature"] == 0.0
    assert info.model_settings["request_timeout"] == 7
    parameters = info.model_request_parameters
    assert parameters.output_mode == "native"
    assert parameters.output_object.json_schema["required"] == ["expressions", "readings"]


@with_the_extra
def test_a_model_without_structured_output_is_asked_for_text() -> None:
    seen = []

    def answer(_: Any, info: Any) -> str:
        seen.append(info.model_request_parameters.output_mode)
        return "text"

    model = function_model(answer, supports_json_schema_output=False)
    assert ProviderModel(model)(extraction_messages(SAID, HARBOUR), RESPONSE_SCHEMA) == "text"
    assert seen == ["text"]


@with_the_extra
def test_the_whole_way_from_a_sentence_to_a_formula() -> None:
    found = SecondOpinion(ProviderModel(function_model(lambda *_: reply(SEQUENCE))), Mode.LLM)
    assert found(SAID, HARBOUR).formula == parse(SEQUENCE)


@with_the_extra
def test_a_model_that_makes_up_an_object_is_corrected_and_then_left() -> None:
    from pydantic_ai.models.test import TestModel

    model = TestModel(custom_output_text=json.dumps({"expressions": [], "readings": ["a"]}))
    found = SecondOpinion(ProviderModel(model), Mode.LLM)(SAID, HARBOUR)
    assert found.formula == extract(SAID, HARBOUR).formula
    assert "embedded translator alone" in (found.note or "")


@with_the_extra
def test_a_request_that_takes_too_long_is_cancelled() -> None:
    import asyncio

    async def sleep() -> str:
        await asyncio.sleep(30)
        return "late"

    model = ProviderModel(function_model(lambda *_: sleep()), patience=0.1)
    with pytest.raises(CompletionTimeoutError):
        model(extraction_messages(SAID, HARBOUR), RESPONSE_SCHEMA)


@with_the_extra
def test_what_a_server_says_of_a_refused_key_goes_nowhere(tmp_path: Path) -> None:
    from pydantic_ai.exceptions import ModelHTTPError

    def refuse(*_: object) -> str:
        raise ModelHTTPError(401, "m", {"error": "Incorrect API key provided: sk-very-secret"})

    model = RecordedModel(ProviderModel(function_model(refuse)), "a:m", tmp_path)
    found = SecondOpinion(model, Mode.BOTH)(SAID, HARBOUR)
    assert found.status is Status.OK
    assert "status 401" in (found.note or "")
    assert "sk-very" not in json.dumps(found.to_json())
    assert "sk-very" not in "".join(f.read_text() for f in tmp_path.rglob("*") if f.is_file())


@with_the_extra
def test_an_empty_reply_and_a_breakdown_are_our_errors() -> None:
    from pydantic_ai.exceptions import ContentFilterError, UnexpectedModelBehavior

    def breaking(error: Exception) -> Any:
        def respond(*_: object) -> str:
            raise error

        return function_model(respond)

    models = {
        "refused": breaking(ContentFilterError("no")),
        "broke down": breaking(UnexpectedModelBehavior("what")),
        "no text": function_model(lambda *_: ""),
    }
    for said, model in models.items():
        with pytest.raises(CompletionError, match=said):
            ProviderModel(model)(extraction_messages(SAID, HARBOUR), RESPONSE_SCHEMA)


@with_the_extra
@pytest.mark.parametrize(
    ("name", "environment", "url"),
    [
        ("openai:m", {"OPENAI_BASE_URL": "http://127.0.0.1:1/v1"}, "http://127.0.0.1:1/v1/"),
        ("ollama:m", {}, "http://localhost:11434/v1/"),
        ("ollama:m", {"OLLAMA_BASE_URL": "http://127.0.0.1:2/v1"}, "http://127.0.0.1:2/v1/"),
    ],
)
def test_a_server_of_ones_own_needs_no_key(
    name: str, environment: dict[str, str], url: str
) -> None:
    model = connected(name, environment=environment).model
    assert model.base_url == url
    assert model.model_name == "m"


@with_the_extra
@pytest.mark.parametrize("provider", ["openai", "anthropic", "google"])
def test_a_key_in_its_usual_variable_is_enough(
    provider: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    key = backend.KEYS[provider][0]
    monkeypatch.delenv("OPENAI_BASE_URL", raising=False)
    monkeypatch.setenv(key, "sk-none")
    model = connected(f"{provider}:some-model", environment={key: "sk-none"}).model
    assert model.model_name == "some-model"


@with_the_extra
@pytest.mark.parametrize("provider", ["openai", "anthropic", "google"])
def test_a_missing_key_is_named_before_anything_is_sent(provider: str) -> None:
    with pytest.raises(CompletionError, match="no key") as caught:
        connected(f"{provider}:m", environment={})
    assert backend.KEYS[provider][0] in (caught.value.hint or "")


@with_the_extra
def test_a_provider_that_is_none_is_our_error() -> None:
    with pytest.raises(CompletionError, match="no model"):
        connected("nosuch:m", environment={})


@pytest.mark.parametrize("name", ["", "gpt", ":m", "openai:"])
def test_a_name_without_a_provider_is_explained(name: str) -> None:
    with pytest.raises(CompletionError, match="names no model") as caught:
        connected(name, environment={})
    assert "anthropic:" in (caught.value.hint or "")


def test_without_the_extra_the_error_says_how_to_get_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(backend, "is_installed", lambda: False)
    with pytest.raises(CompletionError) as caught:
        connected("openai:m", environment={"OPENAI_API_KEY": "x"})
    assert caught.value.hint == backend.GET_IT


def test_a_server_that_is_not_there_does_not_answer() -> None:
    assert not answers("http://127.0.0.1:9/v1")
    assert not answers("nonsense")
    assert not answers("http://127.0.0.1:99999999/v1")
