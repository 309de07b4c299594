"""Files that people give us, as text or JSON, with errors that name the place."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from plainspoken.errors import InputFileError


def read_text(path: str | Path) -> str:
    """The text of a file in UTF-8, without its byte order mark.

    raises InputFileError: when it cannot be read
    """
    try:
        return Path(path).read_text(encoding="utf-8-sig")
    except OSError as error:
        raise InputFileError(
            f"cannot read the file: {error.strerror}", path, hint="check the path"
        ) from error
    except (UnicodeDecodeError, ValueError) as error:
        raise InputFileError("not a text file in UTF-8", path) from error


def read_json(path: str | Path) -> object:
    """The JSON document in a file; no object in it has a name twice.

    raises InputFileError: with the line, or the name
    """

    def unique(items: list[tuple[str, Any]]) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for name, value in items:
            if name in found:
                raise InputFileError("an entry stands twice", path, field=name)
            found[name] = value
        return found

    try:
        return json.loads(read_text(path), object_pairs_hook=unique)
    except json.JSONDecodeError as error:
        raise InputFileError(
            f"not JSON: {error.msg}", path, line=error.lineno, column=error.colno
        ) from error
    except RecursionError as error:
        raise InputFileError("not JSON: nested too deep", path) from error
