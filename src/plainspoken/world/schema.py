"""Action schemas, conditions and effects, from the expressions of a PDDL file."""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping
from typing import TypeVar

from plainspoken.world.domain import (
    Action,
    Add,
    AllOf,
    AnyOf,
    AtomCondition,
    Condition,
    Delete,
    Domain,
    Effect,
    Equal,
    Exists,
    ForAll,
    ForEach,
    NotCondition,
    OneOf,
    Parameter,
    Together,
    When,
)
from plainspoken.world.expression import UNSUPPORTED, Expression, PddlFile

log = logging.getLogger(__name__)
T = TypeVar("T")


class SchemaReader:
    """Reads conditions, effects and actions of one domain, checking names and arities.

    objects: those of the problem; None while the domain itself is read
    """

    def __init__(
        self, file: PddlFile, domain: Domain, objects: Mapping[str, str] | None = None
    ) -> None:
        self._file = file
        self._domain = domain
        self._objects = domain.constants if objects is None else objects
        self._variables: set[str] = set()

    def action(self, section: Expression) -> Action:
        name = section[1] if len(section) > 1 else ""
        if not isinstance(name, str) or not name or name.startswith(":"):
            self._file.expected("(:action NAME ...)", section, section)
        parts: dict[str, Expression | str] = {}
        rest = iter(section[2:])
        for key in rest:
            value = next(rest, None)
            if not isinstance(key, str) or not key.startswith(":") or value is None:
                self._file.expected("a part of an action such as :effect (...)", key, section)
            if key not in (":parameters", ":precondition", ":effect"):
                self._file.fail(f"the action {name} has an unknown part {key}", section)
            if key in parts:
                self._file.fail(f"the action {name} has a second {key}", section)
            parts[key] = value
        words = parts.get(":parameters", Expression())
        if ":parameters" not in parts:
            log.warning("%s:%d: action %s has no :parameters", self._file.path, section.line, name)
        if not isinstance(words, Expression):
            self._file.expected(":parameters (?x - type ...)", words, section)
        parameters = self._parameters(words, section)
        self._variables = {parameter.name for parameter in parameters}
        precondition = self.condition(parts.get(":precondition", Expression()), section)
        effect = self.effect(parts.get(":effect", Expression()), section)
        return Action(name, parameters, precondition, effect, section.line)

    def _parameters(self, words: Expression, at: Expression) -> tuple[Parameter, ...]:
        parameters = self._file.parameters(words, at)
        known = {"object", *self._domain.types, *self._domain.types.values()}
        names = [parameter.name for parameter in parameters]
        for parameter in parameters:
            if names.count(parameter.name) > 1:
                self._file.fail(f"the variable {parameter.name} stands twice", at)
            for each in parameter.types:
                if each not in known:
                    self._file.fail(f"{parameter.name} has the unknown type {each!r}", at)
        return parameters

    def _term(self, term: Expression | str, at: Expression) -> str:
        if isinstance(term, Expression):
            self._file.expected("a name or variable", term, at)
        if term.startswith("?"):
            if term not in self._variables:
                self._file.fail(f"the variable {term} is not bound", at)
        elif term not in self._objects:
            self._file.fail(f"there is no object {term!r}", at)
        return term

    def atom(self, entry: Expression) -> AtomCondition:
        name = entry[0]
        if not isinstance(name, str):
            self._file.expected("an atom", entry, entry)
        parameters = self._domain.predicates.get(name)
        if parameters is None and name in UNSUPPORTED:
            self._file.not_supported(name, entry)
        if parameters is None:
            self._file.fail(f"there is no predicate {name!r}", entry, self._nearest(name))
        if len(parameters) != len(entry) - 1:
            self._file.fail(
                f"{name} takes {len(parameters)} arguments, got {len(entry) - 1}", entry
            )
        terms = tuple(self._term(term, entry) for term in entry[1:])
        for term, parameter in zip(terms, parameters, strict=True):
            own = self._objects.get(term)
            if own is not None and not {*self._domain.ancestors(own)} & {*parameter.types}:
                wanted = " or ".join(parameter.types)
                log.warning(
                    "%s:%d: %s is a %s, where %s takes a %s",
                    *(self._file.path, entry.line, term, own, name, wanted),
                )
        return AtomCondition(name, terms)

    def _nearest(self, name: str) -> str:
        return f"the predicates are {', '.join(sorted(self._domain.predicates)) or 'none'}"

    def _scoped(
        self, entry: Expression, read: Callable[[Expression | str, Expression], T]
    ) -> tuple[tuple[Parameter, ...], T]:
        """The variables and the body of a quantifier."""
        if len(entry) != 3 or not isinstance(entry[1], Expression):
            self._file.expected(f"({entry[0]} (?x - type) ...)", entry, entry)
        parameters = self._parameters(entry[1], entry)
        outer = self._variables
        self._variables = outer | {parameter.name for parameter in parameters}
        body = read(entry[2], entry)
        self._variables = outer
        return parameters, body

    def condition(self, entry: Expression | str, at: Expression) -> Condition:
        if isinstance(entry, str):
            self._file.expected("a condition in parentheses", entry, at)
        if not entry:
            return AllOf()
        match entry[0]:
            case "and":
                return AllOf(tuple(self.condition(part, entry) for part in entry[1:]))
            case "or":
                return AnyOf(tuple(self.condition(part, entry) for part in entry[1:]))
            case "not" if len(entry) == 2:
                return NotCondition(self.condition(entry[1], entry))
            case "imply" if len(entry) == 3:
                left, right = (self.condition(part, entry) for part in entry[1:])
                return AnyOf((NotCondition(left), right))
            case "forall":
                return ForAll(*self._scoped(entry, self.condition))
            case "exists":
                return Exists(*self._scoped(entry, self.condition))
            case "=" if len(entry) == 3:
                return Equal(self._term(entry[1], entry), self._term(entry[2], entry))
            case "not" | "imply" | "=":
                self._file.fail(f"{entry[0]} has the wrong number of parts: {entry}", entry)
            case _:
                return self.atom(entry)

    def effect(self, entry: Expression | str, at: Expression) -> Effect:
        if isinstance(entry, str):
            self._file.expected("an effect in parentheses", entry, at)
        if not entry:
            return Together()
        match entry[0]:
            case "and":
                return Together(tuple(self.effect(part, entry) for part in entry[1:]))
            case "oneof" if len(entry) > 1:
                return OneOf(tuple(self.effect(part, entry) for part in entry[1:]))
            case "when" if len(entry) == 3:
                return When(self.condition(entry[1], entry), self.effect(entry[2], entry))
            case "forall":
                return ForEach(*self._scoped(entry, self.effect))
            case "not" if len(entry) == 2 and isinstance(entry[1], Expression) and entry[1]:
                return Delete(self.atom(entry[1]))
            case "not" | "when" | "oneof":
                self._file.fail(f"{entry[0]} has the wrong number of parts: {entry}", entry)
            case _:
                return Add(self.atom(entry))
