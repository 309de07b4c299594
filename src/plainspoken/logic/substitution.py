"""Mission patterns with other formulas for their operands."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields, replace
from typing import Any

from plainspoken.logic.formula import Formula, substituted
from plainspoken.logic.pattern import Choice, Pattern


def renamed(pattern: Pattern, name: Callable[[str], Formula]) -> Pattern:
    """The pattern with a formula for each proposition of it."""
    if isinstance(pattern, Choice):
        return Choice(
            tuple(tuple(renamed(each, name) for each in option) for option in pattern.options)
        )
    changed: dict[str, Any] = {}  # a pattern's fields differ in type: formulas, numbers
    for field in fields(pattern):
        value = getattr(pattern, field.name)
        if isinstance(value, tuple):
            changed[field.name] = tuple(substituted(each, name) for each in value)
        elif not isinstance(value, (bool, int)):
            changed[field.name] = substituted(value, name)
    return replace(pattern, **changed)
