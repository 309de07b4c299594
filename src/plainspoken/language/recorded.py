"""A language model whose replies are kept: asked the same again, it is not asked.

In the folder: `replies/` holds one file for each prompt, named by its hash, and `log.jsonl` every
question that was asked and its reply, for inspection. Neither ever holds a key: only the messages
and the texts come here.
"""

from __future__ import annotations

import hashlib
import json
import os
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from plainspoken.language.completion import CompletionError, LanguageModel, Message, Schema

LOG = "log.jsonl"


def prompt_hash(name: str, messages: Sequence[Message], schema: Schema) -> str:
    """The name of a prompt: the same text to the same model, the same name."""
    conversation = [[str(message.role), message.text] for message in messages]
    document = json.dumps([name, conversation, schema], sort_keys=True)
    return hashlib.sha256(document.encode()).hexdigest()


@dataclass(frozen=True)
class RecordedModel:
    """Keeps a model's replies in a folder and writes down what was said.

    name:  of the model, as the user gave it: another model's replies are not its own
    clock: seconds since the epoch
    """

    model: LanguageModel
    name: str
    folder: Path
    clock: Callable[[], float] = time.time

    def __call__(self, messages: Sequence[Message], schema: Schema, /) -> str:
        key = prompt_hash(self.name, messages, schema)
        kept = self.folder / "replies" / f"{key}.txt"
        try:
            return kept.read_bytes().decode()
        except FileNotFoundError:
            pass
        except (OSError, UnicodeDecodeError) as error:
            raise CompletionError(
                "a kept reply cannot be read", where=str(kept), hint="delete the file"
            ) from error
        started = self.clock()
        try:
            reply = self.model(messages, schema)
        except CompletionError as error:
            self._log(key, messages, started, error=error.what)
            raise
        # A reply may hold half of a surrogate pair, which no file can.
        reply = reply.encode("utf-8", "replace").decode()
        self._log(key, messages, started, reply=reply)
        self._keep(kept, reply)
        return reply

    def _log(self, key: str, messages: Sequence[Message], started: float, **ending: str) -> None:
        entry = {
            "time": started,
            "seconds": round(self.clock() - started, 3),
            "model": self.name,
            "prompt": key,
            "messages": [{"role": str(each.role), "text": each.text} for each in messages],
            **ending,
        }
        record = json.dumps(entry) + "\n"
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            # One write of one record: two processes that append do not tear each other's.
            log = os.open(self.folder / LOG, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o600)
            try:
                os.write(log, record.encode())
            finally:
                os.close(log)
        except OSError as error:
            raise _unwritable(self.folder, error) from error

    def _keep(self, kept: Path, reply: str) -> None:
        try:
            kept.parent.mkdir(parents=True, exist_ok=True)
            with tempfile.NamedTemporaryFile(
                "wb", dir=kept.parent, prefix=".", delete=False
            ) as file:
                file.write(reply.encode())
            Path(file.name).replace(kept)
        except OSError as error:
            raise _unwritable(self.folder, error) from error


def _unwritable(folder: Path, error: OSError) -> CompletionError:
    return CompletionError(
        f"cannot keep what the language model says: {error.strerror}",
        where=str(folder),
        hint="set PLAINSPOKEN_HOME to a folder that can be written to",
    )
