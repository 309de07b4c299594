"""What may be asked of a mission from outside its process, as the store keeps it."""

from __future__ import annotations

import json
from typing import Any, assert_never

from plainspoken.errors import PlainspokenError
from plainspoken.mission.observation import (
    CancelAsked,
    ChangeAsked,
    LookAsked,
    PauseAsked,
    ResumeAsked,
    Told,
)
from plainspoken.mission.request import clauses_from_json, clauses_to_json

Asked = PauseAsked | ResumeAsked | CancelAsked | Told | ChangeAsked | LookAsked


def to_message(asked: Asked) -> str:
    """The JSON text of a request."""
    document: dict[str, Any]
    match asked:
        case PauseAsked(by):
            document = {"ask": "pause", "by": by}
        case ResumeAsked(by):
            document = {"ask": "resume", "by": by}
        case CancelAsked(by):
            document = {"ask": "cancel", "by": by}
        case LookAsked(by, atoms):
            document = {"ask": "look", "by": by, "atoms": sorted(atoms)}
        case Told(reporter, text, added, deleted):
            document = {
                "ask": "report",
                "by": reporter,
                "text": text,
                "added": sorted(added),
                "deleted": sorted(deleted),
            }
        case ChangeAsked(by, text, clauses, english):
            document = {
                "ask": "change",
                "by": by,
                "text": text,
                "clauses": clauses_to_json(clauses),
                "english": english,
            }
        case _:
            assert_never(asked)
    return json.dumps(document)


def from_message(text: str) -> Asked:
    """Read what `to_message` wrote.

    raises PlainspokenError: when it is no request, such as one of a later version
    """
    try:
        document = json.loads(text)
        match document["ask"]:
            case "pause":
                return PauseAsked(document["by"])
            case "resume":
                return ResumeAsked(document["by"])
            case "cancel":
                return CancelAsked(document["by"])
            case "look":
                return LookAsked(document["by"], frozenset(document["atoms"]))
            case "report":
                added, deleted = frozenset(document["added"]), frozenset(document["deleted"])
                return Told(document["by"], document["text"], added, deleted)
            case "change":
                clauses = clauses_from_json(document["clauses"], "a change that was asked for")
                return ChangeAsked(document["by"], document["text"], clauses, document["english"])
            case _:
                raise PlainspokenError(
                    "not a request to a mission",
                    where=text,
                    hint="it may come from a later version of plainspoken",
                )
    except (ValueError, KeyError, TypeError) as error:
        raise PlainspokenError("not a request to a mission", where=text) from error


def asked_by(text: str) -> tuple[str, str]:
    """What a request asks for, in a word, and who asks; whatever its version."""
    try:
        document = json.loads(text)
        return str(document["ask"]), str(document["by"])
    except (ValueError, KeyError, TypeError):
        return "do something", "somebody"
