"""Templates of fields: `{to}` is an argument of the action, `{to.x}` what is known of it.

A text that is one placeholder and nothing else takes the value as it is, a number for one; in a
longer text it is written out. Results and feedback are read with the same paths: `sequence.0`
is the first of a list, `sequence.-1` the last.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from plainspoken.errors import PlainspokenError

_PLACEHOLDER = re.compile(r"\{([A-Za-z_][\w-]*(?:\.[\w-]+)*)\}")
COMPARISONS: Mapping[str, Callable[[Any, Any], bool]] = {
    ">": operator.gt,
    ">=": operator.ge,
    "<": operator.lt,
    "<=": operator.le,
    "not": operator.ne,
}
Table = Mapping[str, Mapping[str, Any]]
"""What is known of objects beside their names, such as where a place is."""


class UnfilledError(PlainspokenError):
    """A template or an expectation names what there is not; path is the name."""

    def __init__(self, path: str, known: Sequence[str]) -> None:
        self.path = path
        super().__init__(
            f"there is no {path!r} to fill in", hint=f"there is: {', '.join(known) or 'nothing'}"
        )


def paths_in(template: object) -> Iterator[str]:
    """Every path that a template names, in its order."""
    if isinstance(template, str):
        yield from _PLACEHOLDER.findall(template)
    elif isinstance(template, Mapping):
        for value in template.values():
            yield from paths_in(value)
    elif isinstance(template, Sequence):
        for value in template:
            yield from paths_in(value)


def filled(template: Any, values: Mapping[str, Any], objects: Table | None = None) -> Any:
    """A template with its placeholders replaced.

    objects: where `{to.x}` finds the x of the object that `to` is
    raises UnfilledError: when a placeholder names nothing
    """
    if isinstance(template, str):
        whole = _PLACEHOLDER.fullmatch(template)
        if whole is not None:
            return value_at(whole[1], values, objects)
        return _PLACEHOLDER.sub(lambda found: str(value_at(found[1], values, objects)), template)
    if isinstance(template, Mapping):
        return {key: filled(value, values, objects) for key, value in template.items()}
    if isinstance(template, Sequence):
        return [filled(value, values, objects) for value in template]
    return template


def value_at(path: str, values: Mapping[str, Any], objects: Table | None = None) -> Any:
    """What a path leads to.

    raises UnfilledError: when it leads nowhere
    """
    here: Any = values
    for part in path.split("."):
        known = objects.get(here) if objects is not None and isinstance(here, str) else here
        if isinstance(known, Mapping) and part in known:
            here = known[part]
        elif isinstance(known, Sequence) and not isinstance(known, str) and _is_index(part, known):
            here = known[int(part)]
        else:
            raise UnfilledError(path, sorted(map(str, known)) if isinstance(known, Mapping) else ())
    return here


def meets(result: Mapping[str, Any], expected: Mapping[str, Any]) -> bool:
    """Whether each path of a result has the value that is expected; one it has not, has none.

    A value may be a list, of which one is enough, or comparisons: `{">": 0.2}`.
    """
    return all(_meets_at(path, value, result) for path, value in expected.items())


def _meets_at(path: str, expected: Any, result: Mapping[str, Any]) -> bool:
    try:
        found = value_at(path, result)
    except UnfilledError:
        return False
    if isinstance(expected, Mapping):
        try:
            return all(COMPARISONS[sign](found, value) for sign, value in expected.items())
        except TypeError:
            return False  # a text is neither more nor less than a number
    if isinstance(expected, Sequence) and not isinstance(expected, str):
        return any(_same(found, value) for value in expected)
    return _same(found, expected)


def _same(found: Any, expected: Any) -> bool:
    """Equality in which true is not 1."""
    return isinstance(found, bool) == isinstance(expected, bool) and bool(found == expected)


def _is_index(part: str, values: Sequence[Any]) -> bool:
    return part.removeprefix("-").isdecimal() and -len(values) <= int(part) < len(values)
