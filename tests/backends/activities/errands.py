"""A small domain whose actions tests make into activities, and robots' files for it."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tests.stores import store_in

from plainspoken.backends.activities.configuration import robot_from
from plainspoken.backends.activities.robot import ActivityRobot
from plainspoken.world.domain import State
from plainspoken.world.pddl import parse_domain, parse_problem

DOMAIN_TEXT = """
(define (domain errands) (:requirements :strips :typing :non-deterministic)
  (:types place thing)
  (:predicates (at ?p - place) (road ?a ?b - place) (lies ?t - thing ?p - place)
               (held ?t - thing) (free))
  (:action go :parameters (?from ?to - place)
    :precondition (and (at ?from) (road ?from ?to))
    :effect (and (not (at ?from)) (at ?to)))
  (:action grasp :parameters (?t - thing ?p - place)
    :precondition (and (at ?p) (lies ?t ?p) (free))
    :effect (oneof (and (not (lies ?t ?p)) (held ?t) (not (free))) (and))))
"""
PROBLEM_TEXT = """
(define (problem home) (:domain errands)
  (:objects hall kitchen - place mug - thing)
  (:init (at hall) (road hall kitchen) (road kitchen hall) (lies mug kitchen) (free))
  (:goal (held mug)))
"""
PROBLEM = parse_problem(PROBLEM_TEXT, parse_domain(DOMAIN_TEXT, "errands"), "home")
GO = "go hall kitchen"
ARRIVED = (PROBLEM.initial - {"at hall"}) | {"at kitchen"}
VIA = "via: tests.backends.activities.scripted"
SERVICES = f"""\
services:
  drive: {{{VIA}, script: drive}}
  arm: {{{VIA}, script: arm}}
  look: {{{VIA}, script: look}}
"""
GRASP = """\
  grasp:
    do: {call: arm, with: {thing: "{t}"}}
    outcomes:
      - {when: {held: true}, facts: ["held {t}"]}
      - {when: {held: false}, facts: ["not held {t}"]}
"""


def file_of(go: str, *, more: str = "") -> str:
    """A robots' file in which `go` is this activity."""
    return f"{SERVICES}actions:\n  go:\n    do:\n{textwrap.indent(go, ' ' * 6)}\n{GRASP}{more}"


@contextmanager
def robot_of(text: str, folder: Path, state: State | None = None) -> Iterator[ActivityRobot]:
    """The robot of a robots' file; one folder is one journal."""
    file = folder / "robots.yaml"
    file.write_text(text)
    with store_in(folder) as store, robot_from(file, PROBLEM, store, state=state) as robot:
        yield robot
