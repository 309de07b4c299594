"""The options that say who translates: the embedded translator, a language model, or both."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, TypeVar

import click

if TYPE_CHECKING:
    from plainspoken.language.completion import LanguageModel
    from plainspoken.language.extraction import Extraction
    from plainspoken.language.grounding import Vocabulary

    Translator = Callable[[str, Vocabulary], Extraction]

F = TypeVar("F", bound=Callable[..., Any])

MODES = ("embedded", "llm", "both")
MODEL_VARIABLE = "PLAINSPOKEN_MODEL"
_CHOICE = "plainspoken.translator"


def translator_options(command: F) -> F:
    """Add --mode, --model, --model-timeout and --stages to a command.

    They are kept in the context for `chosen_translator`, not handed to the command.
    """
    for option in reversed(
        [
            click.option(
                "--mode",
                type=click.Choice(MODES),
                default="embedded",
                show_default=True,
                expose_value=False,
                callback=_keep,
                help="Who translates: no language model, one alone, or one as a second opinion.",
            ),
            click.option(
                "--model",
                metavar="PROVIDER:NAME",
                envvar=MODEL_VARIABLE,
                show_envvar=True,
                expose_value=False,
                callback=_keep,
                help="The language model, such as anthropic:NAME, ollama:NAME, local.",
            ),
            click.option(
                "--model-timeout",
                type=click.FloatRange(min=0, min_open=True),
                default=60.0,
                show_default=True,
                metavar="S",
                expose_value=False,
                callback=_keep,
                help="Seconds for one reply of it.",
            ),
            click.option(
                "--stages",
                is_flag=True,
                expose_value=False,
                callback=_keep,
                help="Ask it for one stage at a time.",
            ),
        ]
    ):
        command = option(command)
    return command


def _keep(context: click.Context, option: click.Parameter, value: object) -> None:
    context.meta.setdefault(_CHOICE, {})[option.name] = value


@contextmanager
def chosen_translator() -> Iterator[Translator]:
    """The translator that the options name; a local model is served while the context lasts.

    raises CompletionError: when the model cannot be reached
    """
    from plainspoken.language.extraction import extract

    choice = click.get_current_context().meta.get(_CHOICE, {})
    if choice.get("mode", "embedded") == "embedded":
        yield extract
        return
    name = choice["model"]
    if not name:
        raise click.UsageError(f"--mode {choice['mode']} needs --model, or {MODEL_VARIABLE}")
    from plainspoken.knowledge.log import store_path
    from plainspoken.language.recorded import RecordedModel
    from plainspoken.language.second_opinion import Mode, SecondOpinion

    patience = choice["model_timeout"]
    folder = store_path(None).parent / "completions"
    with language_model(name, patience) as model:
        yield SecondOpinion(
            RecordedModel(model, name, folder), Mode(choice["mode"]), choice["stages"], patience
        )


@contextmanager
def language_model(name: str, patience: float) -> Iterator[LanguageModel]:
    """The model of a name: `local`, `local:WEIGHTS`, or `provider:name`."""
    provider, _, rest = name.partition(":")
    if provider == "local":
        from plainspoken.backends.local_llm import local_model

        with local_model(rest or None, patience=patience) as model:
            yield model
    else:
        from plainspoken.backends.pydantic_ai import connected

        yield connected(name, patience=patience, environment=os.environ)
