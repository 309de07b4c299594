"""PDDL files in: text to `Domain` and `Problem`, forgiving of what is found in the wild.

Missing requirements, missing `:parameters` and a problem that names its domain otherwise are read
with a warning, sections in any order. What cannot be planned for (numbers, durations, derived
predicates) is refused by name and line.
"""

from __future__ import annotations

import logging
from collections.abc import Mapping
from pathlib import Path

from plainspoken.world.domain import (
    AllOf,
    Condition,
    Domain,
    GroundAtom,
    Parameter,
    Problem,
    State,
    ground,
)
from plainspoken.world.expression import SUPPORTED_HINT, UNSUPPORTED, Expression, PddlFile
from plainspoken.world.schema import SchemaReader

log = logging.getLogger(__name__)

_DOMAIN_SECTIONS = (":requirements", ":types", ":constants", ":predicates", ":action")
_PROBLEM_SECTIONS = (":domain", ":requirements", ":objects", ":init", ":goal", ":metric")


def read_domain(path: str | Path) -> Domain:
    """Read a PDDL domain file.

    raises InputFileError: with the line, when it is no domain that we can plan in
    """
    return _domain(PddlFile(path))


def parse_domain(text: str, source: str) -> Domain:
    """The domain that a text defines; source names it in errors.

    raises InputFileError: with the line, when it is no domain that we can plan in
    """
    return _domain(PddlFile(source, text))


def read_problem(path: str | Path, domain: Domain) -> Problem:
    """Read a PDDL problem file of a domain.

    raises InputFileError: with the line
    """
    return _problem(PddlFile(path), domain)


def parse_problem(text: str, domain: Domain, source: str) -> Problem:
    """The problem of a domain that a text defines; source names it in errors.

    raises InputFileError: with the line
    """
    return _problem(PddlFile(source, text), domain)


def _domain(file: PddlFile) -> Domain:
    name, sections = _sections(file, "domain", _DOMAIN_SECTIONS)
    types: dict[str, str] = {}
    constants: dict[str, str] = {}
    predicates: dict[str, tuple[Parameter, ...]] = {}
    for section in sections:
        if section[0] == ":types":
            types = _objects(file, section)
            types.pop("object", None)
            _refuse_cycles(file, types, section)
        elif section[0] == ":constants":
            constants = _objects(file, section)
        elif section[0] == ":predicates":
            predicates = _predicates(file, section)
    domain = Domain(name, types, constants, predicates, ())
    for section in sections:
        if section[0] == ":constants":
            _check_types(file, section, domain)
        elif section[0] == ":predicates":
            for entry in section[1:]:
                if isinstance(entry, Expression):
                    _check_types(file, entry, domain)
    schemas = [section for section in sections if section[0] == ":action"]
    actions = tuple(SchemaReader(file, domain).action(schema) for schema in schemas)
    required = {word for section in sections if section[0] == ":requirements" for word in section}
    if ":non-deterministic" not in required and any(map(_has_oneof, schemas)):
        log.warning("%s: oneof without the requirement :non-deterministic", file.path)
    return Domain(name, types, constants, predicates, actions, file.humps)


def _problem(file: PddlFile, domain: Domain) -> Problem:
    name, sections = _sections(file, "problem", _PROBLEM_SECTIONS)
    by_name = {str(section[0]): section for section in sections}
    named = by_name.get(":domain", Expression())[1:]
    if named != [domain.name]:
        shown = " ".join(map(str, named)) or "no domain"
        log.warning("%s: the problem is for %s, planning with %s", file.path, shown, domain.name)
    objects = dict(domain.constants)
    if ":objects" in by_name:
        section = by_name[":objects"]
        for one, type in _objects(file, section).items():
            if objects.setdefault(one, type) != type:
                file.fail(f"{one} is a {type} here and a {objects[one]} in the domain", section)
        _check_types(file, section, domain)
    if ":init" not in by_name:
        file.fail("a problem needs an (:init ...)", file.root)
    reader = SchemaReader(file, domain, objects)
    goal: Condition = AllOf()
    if ":goal" in by_name and len(by_name[":goal"]) > 1:
        if len(by_name[":goal"]) > 2:
            file.expected("one condition as the goal", by_name[":goal"][2], by_name[":goal"])
        goal = reader.condition(by_name[":goal"][1], by_name[":goal"])
    initial, unknown, oneofs = _initial(file, by_name[":init"], reader)
    humps = {**file.humps, **domain.humps}
    return Problem(
        name, domain, objects, initial, goal, str(file.path), humps, unknown=unknown, oneofs=oneofs
    )


def _initial(
    file: PddlFile, section: Expression, reader: SchemaReader
) -> tuple[State, State, tuple[tuple[GroundAtom, ...], ...]]:
    """What is true at first, what is not known then, and groups of which one is true."""
    true: set[GroundAtom] = set()
    unknown: set[GroundAtom] = set()
    oneofs: list[tuple[GroundAtom, ...]] = []
    for literal in section[1:]:
        if not isinstance(literal, Expression) or not literal:
            file.expected("an atom such as (robot-at rob l0)", literal, section)
        # A domain may have a predicate of that name: (unknown g1) is an atom of it.
        if literal[0] in ("unknown", "oneof") and any(
            isinstance(part, Expression) for part in literal[1:]
        ):
            group = _unknown(file, literal, reader)
            unknown.update(group)
            oneofs += [group] if literal[0] == "oneof" else []
            continue
        if literal[0] == "=":
            file.fail("not supported: numeric fluents (=)", literal, SUPPORTED_HINT)
        if literal[0] == "not":
            reader.condition(literal, section)
            continue  # what is not said to be true is false anyway
        true.add(ground(reader.atom(literal), {}))
    # Somebody has to plan: of each group one atom is taken for true, the first unless :init says.
    true.update(group[0] for group in oneofs if true.isdisjoint(group))
    return frozenset(true), frozenset(unknown), tuple(oneofs)


def _unknown(file: PddlFile, entry: Expression, reader: SchemaReader) -> tuple[GroundAtom, ...]:
    """The atoms of `(unknown (full b))` or of `(oneof (at k r1) (at k r2))`."""
    atoms = []
    for part in entry[1:]:
        if not isinstance(part, Expression) or not part or part[0] in ("not", "and", "or"):
            file.expected("an atom such as (full b)", part, entry)
        atoms.append(ground(reader.atom(part), {}))
    least = 2 if entry[0] == "oneof" else 1
    if len(set(atoms)) < least or (least == 1 and len(atoms) > 1):
        file.expected(
            "two atoms or more, of which one is true" if least > 1 else "one atom", entry, entry
        )
    return tuple(dict.fromkeys(atoms))


def _sections(file: PddlFile, kind: str, known: tuple[str, ...]) -> tuple[str, list[Expression]]:
    """The name of a domain or problem, and its sections."""
    match file.root[:2]:
        case ["define", [("domain" | "problem") as found, str(name)] as head]:
            if found != kind:
                file.fail(
                    f"this is a {found} file, expected a {kind}",
                    head,
                    "are domain and problem swapped?",
                )
        case _:
            file.expected(f"(define ({kind} NAME) ...)", file.root, file.root)
    sections: list[Expression] = []
    for section in file.root[2:]:
        if not isinstance(section, Expression) or not section:
            file.expected("a section such as (:init ...)", section, file.root)
        word = str(section[0])
        if word in UNSUPPORTED and len(section) > 1:
            file.not_supported(word, section)
        if word not in known and word not in UNSUPPORTED:
            file.fail(f"unknown section {word}", section, f"sections: {' '.join(known)}")
        if word != ":action" and any(section[0] == other[0] for other in sections):
            file.fail(f"a second {word} section", section, "make one of the two")
        sections.append(section)
    return name, sections


def _objects(file: PddlFile, section: Expression) -> dict[str, str]:
    """Names and their one type: objects, constants, or types and their parents."""
    found: dict[str, str] = {}
    for name, types in file.typed(section[1:], section):
        if len(types) != 1:
            file.fail(f"{name} needs one type, not (either ...)", section)
        if name.startswith("?"):
            file.expected("a name without a question mark", name, section)
        if found.setdefault(name, types[0]) != types[0]:
            file.fail(f"{name} is a {found[name]} and a {types[0]}", section, "give it one type")
    return found


def _predicates(file: PddlFile, section: Expression) -> dict[str, tuple[Parameter, ...]]:
    found: dict[str, tuple[Parameter, ...]] = {}
    for entry in section[1:]:
        if not isinstance(entry, Expression) or not entry or not isinstance(entry[0], str):
            file.expected("a predicate such as (robot-at ?r - robot)", entry, section)
        places = file.parameters(entry[1:], entry)
        if len({place.name for place in places}) < len(places):
            # `(on ?x ?x)` is found in the wild for a predicate of two arguments.
            places = tuple(
                Parameter(f"?{index}", place.types) for index, place in enumerate(places, start=1)
            )
        if found.setdefault(entry[0], places) != places:
            file.fail(f"a second, different predicate {entry[0]}", entry)
    return found


def _check_types(file: PddlFile, entry: Expression, domain: Domain) -> None:
    known = {"object", *domain.types, *domain.types.values()}
    for name, types in file.typed(entry[1:], entry):
        for each in types:
            if each not in known:
                file.fail(f"{name} has the unknown type {each!r}", entry)


def _refuse_cycles(file: PddlFile, types: Mapping[str, str], at: Expression) -> None:
    for start in types:
        seen = [start]
        while (parent := types.get(seen[-1], "object")) != "object":
            if parent in seen:
                file.fail(f"the type {parent!r} is below itself", at)
            seen.append(parent)


def _has_oneof(entry: Expression | str) -> bool:
    return isinstance(entry, Expression) and (entry[:1] == ["oneof"] or any(map(_has_oneof, entry)))
