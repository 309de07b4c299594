"""ROS messages to fields and back, by what each type says of itself.

Types come from a configuration (`nav2_msgs/action/NavigateToPose`), so nothing here knows any.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from importlib import import_module
from typing import Any

from plainspoken.errors import PlainspokenError
from plainspoken.mission.template import paths_in

KINDS = ("action", "srv", "msg")
_REALS = ("float", "double", "float32", "float64", "long double")
_TRUTHS = ("boolean", "bool")
_WHOLE = re.compile(r"(u?)int(\d+)")
_WORDS = ("string", "wstring")


class MessageError(PlainspokenError):
    """Fields do not fit a message."""


def type_of(name: str, kind: str) -> Any:
    """The type that a name such as `std_srvs/srv/Trigger` stands for.

    raises MessageError: when it is no such name, or its package is not there
    """
    parts = name.split("/")
    if len(parts) != 3 or parts[1] != kind:
        raise MessageError(f"expected a type such as package/{kind}/Name, got {name!r}")
    try:
        module = import_module(f"{parts[0]}.{kind}")
    except ImportError as error:
        raise MessageError(
            f"there is no package {parts[0]!r} with {kind} types",
            hint=f"install it, or source the workspace that has it: {error}",
        ) from error
    found = getattr(module, parts[2], None)
    if found is None:
        known = ", ".join(each for each in sorted(vars(module)) if each[:1].isupper())
        raise MessageError(f"{parts[0]} has no {kind} {parts[2]!r}", hint=f"it has: {known}")
    return found


def objection(type: Any, fields: Mapping[str, Any]) -> str | None:
    """What does not fit a message type; placeholders stand for values of any kind."""
    try:
        _fill(type(), fields, "", open_ended=True)
    except MessageError as error:
        return error.what if error.hint is None else f"{error.what} ({error.hint})"
    return None


def message_of(type: Any, fields: Mapping[str, Any]) -> Any:
    """A message with these fields; the others keep their defaults.

    raises MessageError: when a field is not there, or its value is of another kind
    """
    message = type()
    _fill(message, fields, "", open_ended=False)
    return message


def fields_of(message: Any) -> dict[str, Any]:
    """What a message holds, as JSON would have it."""
    return {name: _plain(getattr(message, name)) for name in message.get_fields_and_field_types()}


def _plain(value: Any) -> Any:
    if hasattr(value, "get_fields_and_field_types"):
        return fields_of(value)
    if isinstance(value, bool | int | float | str):
        return value
    if isinstance(value, bytes):
        return value[0] if len(value) == 1 else list(value)
    if hasattr(value, "tolist"):
        return value.tolist()  # an array, of Python's or of numpy's
    return [_plain(each) for each in value]


def _fill(message: Any, fields: Mapping[str, Any], place: str, *, open_ended: bool) -> None:
    kinds = message.get_fields_and_field_types()
    for name, value in fields.items():
        if name not in kinds:
            raise MessageError(
                f"the message has no field {place + name!r}",
                hint=f"it has: {', '.join(kinds) or 'none'}",
            )
        if _is_open(value, open_ended):
            continue
        inner = getattr(message, name)
        if hasattr(inner, "get_fields_and_field_types"):
            if not isinstance(value, Mapping):
                raise _unfit(place + name, kinds[name], value)
            _fill(inner, value, f"{place}{name}.", open_ended=open_ended)
            continue
        fitting = _fitting(message, name, kinds[name], value, place, open_ended=open_ended)
        try:
            setattr(message, name, fitting)
        except (AssertionError, TypeError, ValueError, OverflowError) as error:
            raise _unfit(place + name, kinds[name], value) from error


def _fitting(
    message: Any, name: str, kind: str, value: Any, place: str, *, open_ended: bool
) -> Any:
    """A value as the field has it: what YAML wrote as 1 may be a float."""
    inner = _element(kind)
    if inner is None:
        return _scalar(kind, value, place + name)
    if isinstance(value, str) or not isinstance(value, Sequence):
        raise _unfit(place + name, kind, value)
    if "/" in inner:
        element = _nested_type(message, name)
        return list(_messages(element, value, f"{place}{name}.", open_ended=open_ended))
    given = [_scalar(inner, each, place + name) for each in value if not _is_open(each, open_ended)]
    # An array of a fixed length cannot be tried on while some of it is open.
    return given if len(given) == len(value) else getattr(message, name)


def _is_open(value: Any, open_ended: object) -> bool:
    """Whether a value is a placeholder for one that is not known yet."""
    return bool(open_ended) and isinstance(value, str) and any(True for _ in paths_in(value))


def _messages(
    element: Any, values: Sequence[Any], place: str, *, open_ended: bool
) -> Iterator[Any]:
    for value in values:
        if not isinstance(value, Mapping):
            raise _unfit(place.rstrip("."), "a message", value)
        message = element()
        _fill(message, value, place, open_ended=open_ended)
        yield message


def _nested_type(message: Any, name: str) -> Any:
    """The type of the messages in a list, from what the outer type says of its slots."""
    position = list(message.get_fields_and_field_types()).index(name)
    value_type = message.SLOT_TYPES[position].value_type
    return getattr(import_module(".".join(value_type.namespaces)), value_type.name)


def _element(kind: str) -> str | None:
    """What a list is of: `sequence<int32, 3>`, `int32[3]`; None where it is no list."""
    if kind.startswith("sequence<"):
        return kind.removeprefix("sequence<").removesuffix(">").split(",")[0]
    return kind.partition("[")[0] if kind.endswith("]") else None


def _scalar(kind: str, value: Any, place: str) -> Any:
    kind = kind.partition("<")[0]  # a bounded string: string<10>
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    if kind in _REALS:
        fits = is_number
    elif kind in _TRUTHS:
        fits = isinstance(value, bool)
    elif kind in _WORDS:
        fits = isinstance(value, str)
    else:
        fits = is_number and float(value).is_integer() and int(value) in _range(kind)
    if not fits:
        raise _unfit(place, kind, value)
    if kind in _REALS:
        return float(value)
    if kind in _TRUTHS or kind in _WORDS:
        return value
    return bytes([int(value)]) if kind == "octet" else int(value)


def _range(kind: str) -> range:
    """The whole numbers that fit: rclpy checks them only where it is told to."""
    found = _WHOLE.fullmatch(kind)
    if found is None:
        return range(2**8)  # octet and char
    half = 2 ** (int(found[2]) - 1)
    return range(2 * half) if found[1] else range(-half, half)


def _unfit(place: str, kind: str, value: Any) -> MessageError:
    return MessageError(f"the field {place!r} is {kind}, not {value!r}")
