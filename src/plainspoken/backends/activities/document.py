"""YAML that people write, read so that every complaint names the line.

Nothing here knows of robots. A `Section` is one mapping of the file; asking it for a key of the
wrong kind, or telling it which keys there are, raises InputFileError at the very place.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path
from typing import Any

import yaml

from plainspoken.errors import InputFileError
from plainspoken.world.document import read_text

_KINDS = {
    str: "a text",
    bool: "true or false",
    float: "a number",
    dict: "a mapping",
    list: "a list",
}


class _Loader(yaml.SafeLoader):
    """YAML 1.2 in what matters here: `yes`, `on` and dates are texts; true and false are not."""

    yaml_implicit_resolvers = {  # noqa: RUF012 - the name and its type are the base class's
        first: [(tag, found) for tag, found in resolvers if not tag.endswith(("bool", "timestamp"))]
        for first, resolvers in yaml.SafeLoader.yaml_implicit_resolvers.items()
    }


_Loader.add_implicit_resolver(
    "tag:yaml.org,2002:bool", re.compile("^(?:true|True|TRUE|false|False|FALSE)$"), list("tTfF")
)


def read_yaml(path: Path) -> Section:
    """The mapping that a YAML file holds.

    raises InputFileError: with line and column
    """
    text = read_text(path)
    try:
        node = yaml.compose(text, Loader=_Loader)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark
        raise InputFileError(
            f"not YAML: {error.problem or error.context}",
            path,
            line=None if mark is None else mark.line + 1,
            column=None if mark is None else mark.column + 1,
        ) from error
    except (yaml.YAMLError, RecursionError) as error:
        raise InputFileError(f"not YAML: {error}", path) from error
    if node is None:
        raise InputFileError("the file is empty", path)
    return Value(node, path, "").section()


@dataclass(frozen=True)
class Value:
    """One value in a YAML file, and where it stands. key: what leads to it in a mapping."""

    node: yaml.Node
    path: Path
    field: str
    key: yaml.Node | None = None

    def error(self, what: str, hint: str | None = None) -> InputFileError:
        """A complaint about this value."""
        block = isinstance(self.node, yaml.CollectionNode) and not self.node.flow_style
        # A block begins on the line after its key, where nobody would look for what it lacks.
        mark = (self.key if block and self.key is not None else self.node).start_mark
        return InputFileError(
            what,
            self.path,
            line=mark.line + 1,
            column=mark.column + 1,
            field=self.field or None,
            hint=hint,
        )

    def plain(self) -> Any:
        """The value as Python has it; mappings have texts for keys."""
        if isinstance(self.node, yaml.MappingNode):
            return {key: value.plain() for key, value in self.section().entries.items()}
        if isinstance(self.node, yaml.SequenceNode):
            return [value.plain() for value in self.items()]
        try:
            return _Loader("").construct_object(self.node)
        except (yaml.YAMLError, ValueError) as error:
            raise self.error(f"cannot be read: {self.node.value!r}") from error

    def section(self) -> Section:
        if not isinstance(self.node, yaml.MappingNode):
            raise self.wrong(dict)
        keys, entries = _entries(self)
        return Section(self, keys, entries)

    def items(self) -> list[Value]:
        if not isinstance(self.node, yaml.SequenceNode):
            raise self.wrong(list)
        return [
            Value(item, self.path, f"{self.field}[{number}]")
            for number, item in enumerate(self.node.value)
        ]

    def text(self) -> str:
        found = self.plain()
        if not isinstance(found, str):
            raise self.wrong(str)
        return found

    def number(self) -> float:
        found = self.plain()
        if isinstance(found, bool) or not isinstance(found, int | float):
            raise self.wrong(float)
        return float(found)

    def count(self, least: int) -> int:
        """A whole number that is not less than this."""
        found = self.plain()
        if isinstance(found, bool) or not isinstance(found, int) or found < least:
            raise self.error(f"expected a whole number, at least {least}, got {found!r}")
        return found

    def flag(self) -> bool:
        found = self.plain()
        if not isinstance(found, bool):
            raise self.wrong(bool)
        return found

    def one_of(self, choices: Iterable[str]) -> str:
        """A text that is one of these."""
        found, choices = self.text(), sorted(choices)
        if found not in choices:
            raise self.error(f"{found!r} is not known here", did_you_mean(found, choices))
        return found

    def wrong(self, kind: type) -> InputFileError:
        """A complaint that the value is not of the kind that is expected."""
        found = (
            "a mapping"
            if isinstance(self.node, yaml.MappingNode)
            else "a list"
            if isinstance(self.node, yaml.SequenceNode)
            else f"{self.node.value!r}"
        )
        return self.error(f"expected {_KINDS[kind]}, got {found}")


@dataclass(frozen=True)
class Section:
    """A mapping, and where it stands."""

    at: Value
    keys: Mapping[str, Value]
    entries: Mapping[str, Value]

    def __contains__(self, key: str) -> bool:
        return key in self.entries

    def __iter__(self) -> Iterator[tuple[str, Value]]:
        return iter(self.entries.items())

    def only(self, *known: str) -> None:
        """Refuse any key that is none of these."""
        for key, place in self.keys.items():
            if key not in known:
                raise place.error(f"there is no key {key!r} here", did_you_mean(key, known))

    def get(self, key: str) -> Value | None:
        return self.entries.get(key)

    def need(self, key: str, what: str) -> Value:
        """A value that has to be there; what: what it says, for the complaint."""
        found = self.entries.get(key)
        if found is None:
            raise self.at.error(f"the key {key!r} is missing", f"it says {what}")
        return found

    def text(self, key: str) -> str | None:
        found = self.entries.get(key)
        return None if found is None else found.text()

    def positive(self, key: str, default: float) -> float:
        """A number greater than 0."""
        found = self.entries.get(key)
        if found is None:
            return default
        number = found.number()
        if number <= 0:
            raise found.error(f"expected a number greater than 0, got {found.node.value}")
        return number

    def mapping(self, key: str) -> dict[str, Any]:
        """A mapping as Python has it, empty where there is none."""
        found = self.entries.get(key)
        if found is None:
            return {}
        found.section()
        plain: dict[str, Any] = found.plain()
        return plain


def _entries(value: Value) -> tuple[dict[str, Value], dict[str, Value]]:
    """The keys of a mapping and what they lead to, both with their places."""
    keys: dict[str, Value] = {}
    found: dict[str, Value] = {}
    for key_node, node in value.node.value:
        name = key_node.value if isinstance(key_node, yaml.ScalarNode) else None
        key = Value(key_node, value.path, f"{value.field}.{name}" if value.field else str(name))
        if name is None:
            raise Value(key_node, value.path, value.field).error("a key is one word or text")
        if name in found:
            raise key.error("the key stands twice")
        keys[name], found[name] = key, Value(node, value.path, key.field, key_node)
    return keys, found


def did_you_mean(found: str, known: Iterable[str]) -> str:
    """A hint with the nearest of the names that would be right, and all of them."""
    known = sorted(known)
    near = get_close_matches(found, known, n=1)
    choices = f"expected one of: {', '.join(known) or 'nothing'}"
    return f"did you mean {near[0]!r}? {choices}" if near else choices
