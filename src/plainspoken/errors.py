"""The errors that plainspoken raises: a small tree, each saying what, where and what next."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches
from pathlib import Path


class PlainspokenError(Exception):
    """Something the caller gave us cannot be used.

    what:  one line that says what is wrong
    where: the place (file, line, column, field or the text itself with a caret), or None
    hint:  what to do next, or None
    """

    def __init__(self, what: str, *, where: str | None = None, hint: str | None = None) -> None:
        self.what = what
        self.where = where
        self.hint = hint
        super().__init__(what)

    def __str__(self) -> str:
        lines = [self.what]
        if self.where:
            lines += [f"  {line}" for line in self.where.splitlines()]
        if self.hint:
            lines.append(f"hint: {self.hint}")
        return "\n".join(lines)

    def __reduce__(self) -> tuple[object, ...]:
        # Pickle would call the class with `args`, and subclasses take more than one line of text.
        return _revived, (type(self), self.what, self.__dict__)


def _revived(
    kind: type[PlainspokenError], what: str, fields: dict[str, object]
) -> PlainspokenError:
    error = kind.__new__(kind, what)
    error.__dict__.update(fields)
    return error


class FormulaSyntaxError(PlainspokenError):
    """A text is not an LTLf formula.

    column counts from 0, in characters of the text.
    """

    def __init__(self, text: str, column: int, expected: str, hint: str) -> None:
        self.text = text
        self.column = column
        self.expected = expected
        shown, shown_column = _window(text, column)
        super().__init__(
            "not an LTLf formula",
            where=f"{shown}\n{' ' * shown_column}^ {expected}",
            hint=hint,
        )


class FormulaTooLargeError(PlainspokenError):
    """The automaton of one part of a formula is too large to work with."""

    def __init__(self, part: str) -> None:
        self.part = part
        super().__init__(
            "the formula asks for too many things at once",
            where=part if len(part) <= 200 else part[:197] + "...",
            hint="parts joined by & at the top are kept apart: say it as several of them",
        )


class InputFileError(PlainspokenError):
    """A file cannot be read, or does not hold what it should.

    line and column count from 1; field names the place in a JSON document.
    """

    def __init__(
        self,
        what: str,
        path: str | Path,
        *,
        line: int | None = None,
        column: int | None = None,
        field: str | None = None,
        hint: str | None = None,
    ) -> None:
        self.path = Path(path)
        self.line = line
        self.column = column
        self.field = field
        place = str(path)
        if line is not None:
            place += f":{line}"
            if column is not None:
                place += f":{column}"
        if field is not None:
            place += f", field {field}"
        super().__init__(what, where=place, hint=hint)


class UnknownSymbolError(PlainspokenError):
    """A formula or a file names a symbol that the planning problem does not have."""

    def __init__(self, symbol: str, known: Iterable[str], *, where: str | None = None) -> None:
        self.symbol = symbol
        self.nearest = tuple(get_close_matches(symbol, sorted(known), n=3, cutoff=0.5))
        hint = (
            f"did you mean {' or '.join(self.nearest)}?"
            if self.nearest
            else "`plainspoken doctor --domain D --problem P` lists the symbols of a problem"
        )
        super().__init__(f"the planning problem has no symbol {symbol!r}", where=where, hint=hint)


class AmbiguousSymbolError(UnknownSymbolError):
    """An id stands for several atoms or actions of the planning problem, so for none of them.

    readings: in PDDL
    """

    def __init__(self, symbol: str, readings: Iterable[str]) -> None:
        super().__init__(symbol, known=())
        self.readings = tuple(readings)
        self.what = f"the symbol {symbol!r} can be read as {' or '.join(self.readings)}"
        self.hint = "rename one of the objects in the planning problem"
        self.args = (self.what,)


def _window(text: str, column: int, width: int = 72) -> tuple[str, int]:
    """Cut a long line to what surrounds the column, on one line."""
    flat = "".join(character if character.isprintable() else " " for character in text)
    if len(flat) <= width:
        return flat, column
    start = max(0, min(column - width // 2, len(flat) - width))
    head = "..." if start else ""
    tail = "..." if start + width < len(flat) else ""
    return head + flat[start : start + width] + tail, column - start + len(head)
