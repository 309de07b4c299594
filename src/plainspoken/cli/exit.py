"""Exit statuses, and files that are written whole or not at all."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

from plainspoken.errors import InputFileError

BAD_INPUT = 2
NO = 3
"""The question was understood, and the answer is no: unsolvable, rejected, not valid."""


def write_whole(path: Path, text: str) -> None:
    """Write a file so that a reader, or a crash, never sees half of it.

    raises InputFileError: when the folder cannot be written to
    """
    try:
        with tempfile.NamedTemporaryFile(
            "w", encoding="utf-8", dir=path.parent, prefix=f".{path.name}.", delete=False
        ) as file:
            file.write(text)
        # A temporary file is private; what the user asked for has the usual rights.
        umask = os.umask(0)
        os.umask(umask)
        Path(file.name).chmod(0o666 & ~umask)
        Path(file.name).replace(path)
    except OSError as error:
        raise InputFileError(
            f"cannot write the file: {error.strerror}", path, hint="does the folder exist?"
        ) from error
