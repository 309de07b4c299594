"""A tug and a crane at either end of a harbour, and gates of which nobody knows whether they are
closed."""

from plainspoken.logic.syntax import parse
from plainspoken.pipeline import Site
from plainspoken.world.pddl import parse_domain, parse_problem

DOMAIN = """(define (domain harbour)
  (:requirements :strips :typing)
  (:types robot place crate)
  (:predicates (at ?r - robot ?p - place) (way ?p ?q - place) (closed ?p - place)
               (in ?c - crate ?p - place) (carries ?r - robot ?c - crate) (empty ?r - robot))
  (:action drive :parameters (?r - robot ?from ?to - place)
    :precondition (and (at ?r ?from) (way ?from ?to) (not (closed ?to)))
    :effect (and (at ?r ?to) (not (at ?r ?from))))
  (:action open-gate :parameters (?r - robot ?p ?q - place)
    :precondition (and (at ?r ?p) (way ?p ?q) (closed ?q))
    :effect (not (closed ?q)))
  (:action lift :parameters (?r - robot ?c - crate ?p - place)
    :precondition (and (at ?r ?p) (in ?c ?p) (empty ?r))
    :effect (and (carries ?r ?c) (not (in ?c ?p)) (not (empty ?r))))
  (:action drop :parameters (?r - robot ?c - crate ?p - place)
    :precondition (and (at ?r ?p) (carries ?r ?c))
    :effect (and (in ?c ?p) (empty ?r) (not (carries ?r ?c)))))
"""
TEXT = """(define (problem two-crates)
  (:domain harbour)
  (:objects tug crane - robot quay yard ship shed - place box1 box2 - crate)
  (:init (at tug quay) (at crane yard) (empty tug) (empty crane)
         (way quay ship) (way ship quay) (way yard shed) (way shed yard)
         (in box1 quay) (in box2 yard)
         (unknown (closed ship)) (unknown (closed shed)))
  (:goal (and (in box1 ship) (in box2 shed))))
"""
SITE = Site(parse_problem(TEXT, parse_domain(DOMAIN, "the domain"), "the problem"), DOMAIN, TEXT)
GOAL = parse("F in_box1_ship & F in_box2_shed")
"""What takes both, with nothing of one in the other's way."""
