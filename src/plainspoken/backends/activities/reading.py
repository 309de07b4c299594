"""Activities and facts, from the YAML of a robots' file, checked against domain and services."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from plainspoken.backends.activities.document import Section, Value, did_you_mean
from plainspoken.mission.activity import (
    Activity,
    Call,
    Condition,
    Literal,
    Parallel,
    Retry,
    Selection,
    Sequence,
    Within,
)
from plainspoken.mission.service import Service
from plainspoken.mission.template import COMPARISONS, Table, paths_in
from plainspoken.world.domain import Parameter, Problem

KINDS = ("call", "sequence", "selection", "parallel", "retry", "if")
"""What an activity can be; each may have a `limit`."""
OF_EVERY_ACTION = ("action", "goal")
"""Placeholders beside the parameters: the ground action, and the goal id."""


@dataclass(frozen=True)
class Scope:
    """What templates may name: parameters, and what is known of the objects that fit them.

    more:    further words; results: services, of whose results nobody knows the fields before
    """

    problem: Problem
    parameters: tuple[Parameter, ...]
    objects: Table
    more: tuple[str, ...] = ()
    results: tuple[str, ...] = ()

    @property
    def names(self) -> dict[str, Parameter]:
        return {parameter.name.removeprefix("?"): parameter for parameter in self.parameters}

    def check(self, value: Value) -> Any:
        """A template as Python has it, once everything that it names is known to be there.

        raises InputFileError: at the text that names what is not
        """
        for text in _texts(value):
            for path in paths_in(text.plain()):
                self._check(path, text)
        return value.plain()

    def _check(self, path: str, at: Value) -> None:
        name, _, key = path.partition(".")
        parameter = self.names.get(name)
        if parameter is None and (name in self.results if key else name in self.more):
            return
        if parameter is None:
            raise at.error(
                f"there is no {{{name}}} here", did_you_mean(name, [*self.names, *self.more])
            )
        for each in self.problem.objects_for(parameter) if key else ():
            known: Any = self.objects.get(each, {})
            for part in key.split("."):
                if not isinstance(known, Mapping) or part not in known:
                    raise at.error(
                        f"of the object {each!r} no {key!r} is known",
                        f"`objects` has to say it of everything that {{{name}}} may be",
                    )
                known = known[part]


@dataclass(frozen=True)
class ActivityReader:
    """Reads the activity of one action."""

    scope: Scope
    services: Mapping[str, Service]

    def read(self, value: Value) -> Activity:
        """The activity that a value of the file describes.

        raises InputFileError: with the line, and what was expected
        """
        section = value.section()
        kinds = [kind for kind in KINDS if kind in section]
        if len(kinds) != 1:
            found = " and ".join(kinds) or f"only {', '.join(section.keys) or 'nothing'}"
            raise value.error(f"an activity is one of {', '.join(KINDS)}; here is {found}")
        limit = section.positive("limit", 0.0)
        activity = self._kind(kinds[0], section)
        return Within(activity, limit) if limit else activity

    def _kind(self, kind: str, section: Section) -> Activity:
        match kind:
            case "call":
                return self._call(section)
            case "sequence":
                section.only("sequence", "limit")
                return Sequence(self._parts(section.entries["sequence"]))
            case "selection":
                section.only("selection", "limit")
                return Selection(self._parts(section.entries["selection"]))
            case "parallel":
                section.only("parallel", "needs", "limit")
                needs = section.get("needs")
                one = needs is not None and needs.one_of(["all", "one"]) == "one"
                return Parallel(self._parts(section.entries["parallel"]), one)
            case "retry":
                return self._retry(section)
            case _:
                section.only("if", "limit")
                facts = section.entries["if"].items()
                return Condition(tuple(fact_of(fact, self.scope) for fact in facts))

    def _parts(self, value: Value) -> tuple[Activity, ...]:
        parts = tuple(map(self.read, value.items()))
        if not parts:
            raise value.error("there is nothing in it")
        return parts

    def _retry(self, section: Section) -> Retry:
        section.only("retry", "times", "pause", "growth", "longest", "limit")
        part = self.read(section.entries["retry"])
        times = section.need("times", "how often in all: a whole number, at least 2")
        usual = Retry(part, times.count(2))
        return Retry(
            part,
            usual.times,
            section.positive("pause", usual.pause),
            section.positive("growth", usual.growth),
            section.positive("longest", usual.longest),
        )

    def _call(self, section: Section) -> Call:
        section.only("call", "with", "as", "when", "limit")
        name, fields = asked(section, self.services, self.scope)
        words, when = section.get("as"), section.get("when")
        if words is not None:
            words.text()
            self.scope.check(words)
        return Call(
            name,
            fields,
            None if words is None else words.text(),
            {} if when is None else expected(when),
        )


def asked(
    section: Section, services: Mapping[str, Service], scope: Scope
) -> tuple[str, dict[str, Any]]:
    """The service that `call` names, and the fields under `with`.

    raises InputFileError: when there is no such service, or its fields are others
    """
    call = section.need("call", "which of the services")
    name = call.text()
    if name not in services:
        raise call.error(f"there is no service {name!r}", did_you_mean(name, services))
    given = section.get("with")
    fields: dict[str, Any] = {}
    if given is not None:
        given.section()
        fields = scope.check(given)
    objection = services[name].objection(fields)
    if objection is not None:
        raise (call if given is None else given).error(objection)
    return name, fields


def expected(value: Value) -> dict[str, Any]:
    """What a result has to be: `{field: value}`, with lists of values, or comparisons."""
    for _, wanted in value.section():
        plain = wanted.plain()
        if isinstance(plain, Mapping):
            wanted.section().only(*COMPARISONS)
    found: dict[str, Any] = value.plain()
    return found


def fact_of(value: Value, scope: Scope) -> Literal:
    """A fact of the domain, with placeholders for parameters: `full {b}`, `not full {b}`.

    raises InputFileError: when the domain has no such predicate, or no such object
    """
    fact = Literal.of(value.text())
    predicate, *terms = fact.atom.split() or [""]
    predicates = scope.problem.domain.predicates
    if predicate not in predicates:
        raise value.error(
            f"the domain has no predicate {predicate!r}", did_you_mean(predicate, predicates)
        )
    parameters = predicates[predicate]
    if len(terms) != len(parameters):
        named = " ".join(parameter.name for parameter in parameters)
        raise value.error(f"{predicate!r} has {len(parameters)} arguments: {named or 'none'}")
    scope.check(value)
    for term, parameter in zip(terms, parameters, strict=True):
        fitting = scope.problem.objects_for(parameter)
        if not term.startswith("{") and term not in fitting:
            raise value.error(f"{term!r} fits no {predicate!r}", did_you_mean(term, fitting))
    return fact


def _texts(value: Value) -> Iterable[Value]:
    """Every scalar in a value, with its place."""
    plain = value.plain()
    if isinstance(plain, Mapping):
        for _, inner in value.section():
            yield from _texts(inner)
    elif isinstance(plain, list):
        for inner in value.items():
            yield from _texts(inner)
    else:
        yield value
