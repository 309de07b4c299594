"""Language models of any provider, through pydantic-ai: `provider:name`.

We ask for the model's native structured output (what pydantic-ai's `NativeOutput` asks for) by its
direct API and take the text: our own checked parse decides on it, and our own words correct it, so
that an agent's retries and its parse would only stand between. A model without native structured
output is asked for text; the prompt says what the object looks like.
"""

from __future__ import annotations

import asyncio
import os
import socket
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

from plainspoken.language.completion import (
    PATIENCE,
    CompletionError,
    CompletionTimeoutError,
    Message,
    Role,
    Schema,
    Seconds,
)

if TYPE_CHECKING:
    from pydantic_ai.models import Model

GET_IT = "pip install 'plainspoken[llm]'"
OLLAMA = "http://localhost:11434/v1"
MOST_TOKENS = 2048
"""Of a reply: enough for every translation, and a model that rambles is cut off."""

KEYS = {
    "openai": ("OPENAI_API_KEY",),
    "openai-chat": ("OPENAI_API_KEY",),
    "anthropic": ("ANTHROPIC_API_KEY",),
    "google": ("GOOGLE_API_KEY", "GEMINI_API_KEY"),
}
"""The environment variables that a provider's key may stand in."""


def is_installed() -> bool:
    """Whether the extra is there."""
    return find_spec("pydantic_ai") is not None


def answers(url: str, patience: Seconds = 1.0) -> bool:
    """Whether a server listens where a URL points to; nothing is sent to it."""
    parts = urlsplit(url)
    try:
        port = parts.port or (443 if parts.scheme == "https" else 80)
        with socket.create_connection((parts.hostname or "", port), timeout=patience):
            return True
    except (OSError, ValueError):
        return False


@dataclass(frozen=True)
class ProviderModel:
    """A pydantic-ai model as a `LanguageModel`."""

    model: Model
    patience: Seconds = PATIENCE
    most_tokens: int = MOST_TOKENS

    def __call__(self, messages: Sequence[Message], schema: Schema, /) -> str:
        from pydantic_ai import exceptions

        try:
            # A loop and connections of its own: nothing stays open behind a reply.
            response = asyncio.run(self._response(messages, schema))
        except (exceptions.ModelRequestTimeout, exceptions.ModelTimeoutError) as error:
            raise CompletionTimeoutError(self.patience) from error
        except exceptions.ModelHTTPError as error:
            # The body may quote the key that was refused, so only the status is told.
            raise CompletionError(
                f"the language model's server answered with status {error.status_code}",
                where=self.model.model_name,
                hint="401 or 403: look at the key; 404: at the model's name; 429: try again later",
            ) from None
        except exceptions.ContentFilterError:
            raise CompletionError(
                "the language model refused to answer", where=self.model.model_name
            ) from None
        except (exceptions.AgentRunError, exceptions.UserError, OSError) as error:
            raise CompletionError(
                f"the language model broke down ({type(error).__name__})",
                where=self.model.model_name,
                hint="`plainspoken doctor` shows which backends answer",
            ) from None
        text: str = response.text or ""
        if not text:
            raise CompletionError("the language model gave no text", where=self.model.model_name)
        return text

    async def _response(self, messages: Sequence[Message], schema: Schema) -> Any:
        from pydantic_ai.direct import model_request

        async with self.model:
            return await model_request(
                self.model,
                _conversation(messages),
                model_settings={
                    "temperature": 0.0,
                    "max_tokens": self.most_tokens,
                    "timeout": self.patience,
                    "request_timeout": self.patience,
                },
                model_request_parameters=_parameters(self.model, schema),
            )


def connected(
    name: str,
    *,
    patience: Seconds = PATIENCE,
    environment: Mapping[str, str] = os.environ,
) -> ProviderModel:
    """The model that `provider:name` names; keys come from the environment.

    With OPENAI_BASE_URL, `openai:name` speaks to that server, by the chat API that such servers
    have. `ollama:name` speaks to OLLAMA_BASE_URL, or to this machine.
    raises CompletionError: when the extra, the key or the provider is missing
    """
    provider, separator, model = name.partition(":")
    if not separator or not provider or not model:
        raise CompletionError(
            f"{name!r} names no model",
            hint="provider:name, such as openai:gpt-5, anthropic:claude-sonnet-4-5, "
            "google:gemini-2.5-pro, ollama:qwen3, or local",
        )
    if not is_installed():
        raise CompletionError("language models are not installed", hint=GET_IT)
    if provider in ("openai", "openai-chat") and environment.get("OPENAI_BASE_URL"):
        key = environment.get("OPENAI_API_KEY")
        return served(environment["OPENAI_BASE_URL"], model, key=key, patience=patience)
    if provider == "ollama":
        return _ollama(model, environment, patience)
    if provider in KEYS and not any(environment.get(key) for key in KEYS[provider]):
        raise CompletionError(
            f"there is no key for {provider}", hint=f"set {' or '.join(KEYS[provider])}"
        )
    return ProviderModel(_inferred(name), patience)


def served(
    url: str, model: str, *, key: str | None = None, patience: Seconds = PATIENCE
) -> ProviderModel:
    """A model of any server that speaks OpenAI's chat API."""
    if not is_installed():
        raise CompletionError("language models are not installed", hint=GET_IT)
    from pydantic_ai.models.openai import OpenAIChatModel
    from pydantic_ai.providers.openai import OpenAIProvider

    # The client asks for a key even where the server does not.
    provider = OpenAIProvider(base_url=url, api_key=key or "none-needed")
    return ProviderModel(OpenAIChatModel(model, provider=provider), patience)


def _ollama(model: str, environment: Mapping[str, str], patience: Seconds) -> ProviderModel:
    from pydantic_ai.models.ollama import OllamaModel
    from pydantic_ai.providers.ollama import OllamaProvider

    url = environment.get("OLLAMA_BASE_URL") or OLLAMA
    provider = OllamaProvider(base_url=url, api_key=environment.get("OLLAMA_API_KEY"))
    return ProviderModel(OllamaModel(model, provider=provider), patience)


def _inferred(name: str) -> Model:
    from pydantic_ai.exceptions import UserError
    from pydantic_ai.models import infer_model

    try:
        return infer_model(name)
    except (UserError, ValueError) as error:
        raise CompletionError(
            f"there is no model {name!r} to be had: {error}",
            hint="provider:name, such as openai:gpt-5 or ollama:qwen3",
        ) from None
    except ImportError as error:
        raise CompletionError(f"the client for {name!r} is not installed", hint=GET_IT) from error


def _parameters(model: Model, schema: Schema) -> Any:
    from pydantic_ai.models import ModelRequestParameters
    from pydantic_ai.output import OutputObjectDefinition

    if not model.profile.get("supports_json_schema_output", False):
        return ModelRequestParameters()
    return ModelRequestParameters(
        output_mode="native",
        output_object=OutputObjectDefinition(
            json_schema=dict(schema), name="translation", strict=True
        ),
    )


def _conversation(messages: Sequence[Message]) -> list[Any]:
    from pydantic_ai.messages import (
        ModelRequest,
        ModelResponse,
        SystemPromptPart,
        TextPart,
        UserPromptPart,
    )

    said: list[Any] = []
    for message in messages:
        match message.role:
            case Role.SYSTEM:
                said.append(ModelRequest(parts=[SystemPromptPart(content=message.text)]))
            case Role.USER:
                said.append(ModelRequest(parts=[UserPromptPart(content=message.text)]))
            case Role.MODEL:
                said.append(ModelResponse(parts=[TextPart(content=message.text)]))
    return said
