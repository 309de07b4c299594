"""A corpus as requests of the OpenAI Batch API, and its replies as a run; no network is used.

source: the Batch API reference: a request a line in (custom_id, method, url, body), a reply a
line out (custom_id, response with status_code and body, error).
"""

from __future__ import annotations

import json
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from plainspoken.errors import InputFileError, PlainspokenError
from plainspoken.evaluation.corpus import Row, RowId, json_lines
from plainspoken.evaluation.translation import WithModel
from plainspoken.language.completion import Role
from plainspoken.language.extraction import Extraction
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.prompting import RESPONSE_SCHEMA, extraction_messages
from plainspoken.language.second_opinion import Mode, SecondOpinion

URL = "/v1/chat/completions"

_ROLES = {Role.SYSTEM: "system", Role.USER: "user", Role.MODEL: "assistant"}
"""What the API calls those who speak."""


@dataclass(frozen=True, slots=True)
class NoReply:
    """Why a request has no text for an answer."""

    reason: str


Replies = Mapping[RowId, str | NoReply]


def requests(rows: Sequence[Row], model: str) -> Iterator[dict[str, Any]]:
    """A request for each row, by the id of the row."""
    for row in rows:
        vocabulary = Vocabulary.of({one.id: one for one in row.landmarks})
        yield {
            "custom_id": row.id,
            "method": "POST",
            "url": URL,
            "body": {
                "model": model,
                "temperature": 0,
                "messages": [
                    {"role": _ROLES[each.role], "content": each.text}
                    for each in extraction_messages(row.utterance, vocabulary)
                ],
                "response_format": {
                    "type": "json_schema",
                    "json_schema": {
                        "name": "reading",
                        "strict": True,
                        "schema": dict(RESPONSE_SCHEMA),
                    },
                },
            },
        }


def read_replies(path: str | Path, ids: Collection[RowId]) -> Replies:
    """Read the output of a batch; requests that failed are replies too.

    raises InputFileError: with the line that is no reply, or not to one of the ids
    """
    replies: dict[RowId, str | NoReply] = {}
    for line, document in json_lines(path):
        id = document.get("custom_id")
        if not isinstance(id, str):
            raise InputFileError("expected a reply", path, line=line, field="custom_id")
        if id not in ids:
            raise InputFileError(
                f"the corpus has no sentence {id!r}",
                path,
                line=line,
                field="custom_id",
                hint="give the --corpus that the batch was made from",
            )
        if id in replies:
            raise InputFileError(f"two replies to {id!r}", path, line=line, field="custom_id")
        replies[id] = _reply(document)
    return replies


@dataclass(frozen=True, slots=True)
class FromReplies:
    """Translates a row by looking up what a model said of it."""

    replies: Replies

    def __call__(self, row: Row, vocabulary: Vocabulary) -> Extraction:
        reply = self.replies.get(row.id, NoReply("the batch has no reply to this sentence"))
        if isinstance(reply, NoReply):
            raise PlainspokenError(reply.reason)
        replied = SecondOpinion(lambda _messages, _schema: reply, Mode.LLM)
        return WithModel(replied)(row, vocabulary)


def _reply(document: Mapping[str, Any]) -> str | NoReply:
    """The text of a reply, or what went wrong, in the API's own words."""
    response = _object(document.get("response"))
    body = _object(response.get("body"))
    for error in (document.get("error"), body.get("error")):
        if error:
            said = _object(error).get("message") or json.dumps(error)
            return NoReply(f"the model gave no answer: {said}")
    status = response.get("status_code", 200)
    if status != 200:
        return NoReply(f"the model gave no answer: status {status}")
    choices = body.get("choices")
    choice = _object(choices[0]) if isinstance(choices, list) and choices else {}
    message = _object(choice.get("message"))
    if message.get("refusal"):
        return NoReply(f"the model refused: {message['refusal']}")
    if choice.get("finish_reason") == "length":
        return NoReply("the model's answer was cut off at its longest")
    content = message.get("content")
    if not isinstance(content, str) or not content.strip():
        return NoReply("the model's answer is empty")
    return content


def _object(value: object) -> Mapping[str, Any]:
    return value if isinstance(value, dict) else {}
