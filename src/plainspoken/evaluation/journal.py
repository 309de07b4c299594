"""Results as a file, a JSON object a line, appended as they come, so that a run can go on."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from types import TracebackType
from typing import Any, Self, TextIO

from plainspoken.errors import InputFileError
from plainspoken.evaluation.corpus import RowId
from plainspoken.evaluation.experiment import Key, Outcome, Result
from plainspoken.evaluation.metric import Mentions, Share


class Journal:
    """A results file that is written to; afresh, or after what it holds."""

    def __init__(self, path: Path, *, resume: bool) -> None:
        self.known: Mapping[tuple[RowId, Key], Result] = {}
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            if resume and path.exists():
                self.known = read_results(path)
                _drop_torn_line(path)
            self._file: TextIO = path.open("a" if resume else "w", encoding="utf-8", newline="\n")
        except OSError as error:
            raise InputFileError(f"cannot write the file: {error.strerror}", path) from error

    def append(self, result: Result) -> None:
        """Add a line; it is on its way to the disk when this returns."""
        self._file.write(json.dumps(result_to_json(result), ensure_ascii=False) + "\n")
        self._file.flush()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        place: TracebackType | None,
    ) -> None:
        self._file.close()


def read_results(path: Path) -> dict[tuple[RowId, Key], Result]:
    """Read a results file; of two lines for one sentence the later counts.

    A process that is killed may leave its last line unfinished; that one is left out.
    raises InputFileError: with the line that is no result
    """
    *whole, _ = path.read_bytes().split(b"\n")
    found = {}
    for line, text in enumerate(whole, start=1):
        try:
            result = result_from_json(json.loads(text))
        except (ValueError, KeyError, TypeError) as error:
            raise InputFileError(
                "the line is not a result", path, line=line, hint="start afresh, without --resume"
            ) from error
        found[result.id, result.key] = result
    return found


def result_to_json(result: Result) -> dict[str, Any]:
    """The fields of a line."""
    mentions = result.mentions
    return {
        "id": result.id,
        "key": result.key,
        "outcome": str(result.outcome),
        "literal": result.literal,
        "executable": result.executable,
        "formula": result.formula,
        "pattern": result.pattern,
        "reason": result.reason,
        "mentions": None
        if mentions is None
        else {
            name: [share.count, share.total]
            for name, share in (
                ("recall", mentions.recall),
                ("precision", mentions.precision),
                ("grounding", mentions.grounding),
            )
        },
        "seconds": result.seconds,
    }


def result_from_json(document: dict[str, Any]) -> Result:
    """What `result_to_json` wrote.

    raises KeyError, TypeError, ValueError: for anything else
    """
    mentions = document["mentions"]
    return Result(
        **{
            **document,
            "outcome": Outcome(document["outcome"]),
            "mentions": None
            if mentions is None
            else Mentions(**{name: Share(*pair) for name, pair in mentions.items()}),
        }
    )


def _drop_torn_line(path: Path) -> None:
    with path.open("r+b") as file:
        raw = file.read()
        file.truncate(raw.rfind(b"\n") + 1)
