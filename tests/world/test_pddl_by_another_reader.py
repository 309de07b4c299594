"""Domains and problems compared with what the `pddl` package reads in them."""

from collections.abc import Callable
from pathlib import Path

import pddl
import pytest
from pddl.logic import base, effects, predicates

from plainspoken.world.domain import (
    Add,
    AllOf,
    AnyOf,
    AtomCondition,
    Condition,
    Delete,
    Effect,
    Equal,
    Exists,
    ForAll,
    ForEach,
    NotCondition,
    OneOf,
    Parameter,
    Problem,
    Together,
    When,
)

ReadProblem = Callable[[str, str], Problem]
VINEYARD = Path(__file__).resolve().parents[2] / "examples" / "vineyard"

FAMILY = """(define (domain family)
  (:requirements :strips :typing :equality :disjunctive-preconditions :negative-preconditions
    :universal-preconditions :existential-preconditions :conditional-effects :non-deterministic)
  (:types adult child - person person place)
  (:constants home - place)
  (:predicates (at ?p - person ?l - place) (knows ?a ?b - person) (happy ?p - person) (rain))
  (:action go
    :parameters (?p - person ?from ?to - place)
    :precondition (and (at ?p ?from) (not (= ?from ?to)) (or (not (rain)) (= ?to home)))
    :effect (and (at ?p ?to) (not (at ?p ?from))
      (when (and (rain) (not (happy ?p))) (happy ?p))))
  (:action party
    :parameters (?l - place)
    :precondition (and (exists (?a - adult) (at ?a ?l))
      (forall (?c - child) (imply (at ?c ?l) (happy ?c))))
    :effect (and (forall (?p - person) (when (at ?p ?l) (happy ?p)))
      (oneof (rain) (not (rain)) (and))))
)
"""
FAMILY_PROBLEM = """(define (problem sunday)
  (:domain family)
  (:objects ann bob - adult kim - child park - place)
  (:init (at ann home) (at bob home) (at kim park) (knows ann bob) (rain))
  (:goal (and (at ann park) (happy kim) (knows ann bob))))
"""
BLOCKS = """(define (domain blocks)
  (:requirements :strips :non-deterministic)
  (:predicates (on ?x ?y) (clear ?x) (table ?x))
  (:action put
    :parameters (?x ?y)
    :precondition (and (clear ?x) (clear ?y) (table ?x))
    :effect (oneof (and (on ?x ?y) (not (clear ?y)) (not (table ?x))) (and (clear ?x))))
)
"""
BLOCKS_PROBLEM = """(define (problem two) (:domain blocks) (:objects b1 b2)
  (:init (clear b1) (clear b2) (table b1) (table b2)) (:goal (on b1 b2)))
"""


def _both(operator: str, operands: list[object]) -> object:
    """An `and` or `or` without order, repetition, nesting or a single operand."""
    flat: set[object] = set()
    for each in operands:
        inner = isinstance(each, tuple) and each[0] == operator
        flat |= each[1] if inner else {each}
    return flat.pop() if len(flat) == 1 else (operator, frozenset(flat))


def _ours(part: Condition | Effect) -> object:
    match part:
        case AtomCondition(name, terms):
            return (name, terms)
        case Equal(left, right):
            return ("=", frozenset((left, right)))
        case Add(atom):
            return _ours(atom)
        case NotCondition(inner) | Delete(inner):
            return ("not", _ours(inner))
        case AllOf(parts) | Together(parts):
            return _both("and", list(map(_ours, parts)))
        case AnyOf(parts):
            return _both("or", list(map(_ours, parts)))
        case OneOf(parts):
            return ("oneof", frozenset(map(_ours, parts)))
        case When(condition, effect):
            return ("when", _ours(condition), _ours(effect))
        case ForAll(parameters, inner) | ForEach(parameters, inner):
            return ("forall", frozenset(map(_our_parameter, parameters)), _ours(inner))
        case Exists(parameters, inner):
            return ("exists", frozenset(map(_our_parameter, parameters)), _ours(inner))


def _our_parameter(parameter: Parameter) -> tuple[str, frozenset[str]]:
    return (parameter.name, frozenset(parameter.types))


def _their_term(term: object) -> str:
    return f"?{term.name}" if isinstance(term, pddl.logic.Variable) else term.name


def _their_parameter(variable: pddl.logic.Variable) -> tuple[str, frozenset[str]]:
    return (_their_term(variable), frozenset(variable.type_tags or ["object"]))


def _theirs(part: object) -> object:
    match part:
        case predicates.Predicate():
            return (part.name, tuple(map(_their_term, part.terms)))
        case predicates.EqualTo():
            return ("=", frozenset((_their_term(part.left), _their_term(part.right))))
        case base.Not():
            return ("not", _theirs(part.argument))
        case base.And():
            return _both("and", list(map(_theirs, part.operands)))
        case base.Or():
            return _both("or", list(map(_theirs, part.operands)))
        case base.Imply():
            left, right = map(_theirs, part.operands)
            return _both("or", [("not", left), right])
        case base.OneOf():
            return ("oneof", frozenset(map(_theirs, part.operands)))
        case effects.When():
            return ("when", _theirs(part.condition), _theirs(part.effect))
        case effects.Forall():
            variables = frozenset(map(_their_parameter, part.variables))
            return ("forall", variables, _theirs(part.effect))
        case base.ForallCondition() | base.ExistsCondition():
            kind = "forall" if isinstance(part, base.ForallCondition) else "exists"
            variables = frozenset(map(_their_parameter, part.variables))
            return (kind, variables, _theirs(part.condition))
    raise AssertionError(f"unexpected {type(part)}")


@pytest.mark.parametrize(
    ("domain", "problem"),
    [
        ((VINEYARD / "domain.pddl").read_text(), (VINEYARD / "problem.pddl").read_text()),
        (FAMILY, FAMILY_PROBLEM),
        (BLOCKS, BLOCKS_PROBLEM),
    ],
    ids=["vineyard", "family", "blocks"],
)
def test_both_readers_of_pddl_see_the_same(
    tmp_path: Path, problem_of: ReadProblem, domain: str, problem: str
) -> None:
    ours = problem_of(domain, problem)
    their_domain = pddl.parse_domain(tmp_path / "domain.pddl")
    theirs = pddl.parse_problem(tmp_path / "problem.pddl")

    assert ours.domain.name == their_domain.name
    assert ours.domain.types == {
        str(name): str(parent or "object") for name, parent in their_domain.types.items()
    }
    assert {
        (name, *map(_our_parameter, parameters))
        for name, parameters in ours.domain.predicates.items()
    } == {(p.name, *map(_their_parameter, p.terms)) for p in their_domain.predicates}
    assert {
        (a.name, *map(_our_parameter, a.parameters)): (_ours(a.precondition), _ours(a.effect))
        for a in ours.domain.actions
    } == {
        (a.name, *map(_their_parameter, a.parameters)): (_theirs(a.precondition), _theirs(a.effect))
        for a in their_domain.actions
    }

    constants = {*theirs.objects, *their_domain.constants}
    assert ours.name == theirs.name
    assert ours.objects == {str(o.name): str(o.type_tag or "object") for o in constants}
    assert ours.initial == {" ".join([f.name, *map(_their_term, f.terms)]) for f in theirs.init}
    assert _ours(ours.goal) == _theirs(theirs.goal)
