"""The words for atoms, from PDDL names alone."""

from plainspoken.questions.lexicon import Lexicon
from plainspoken.world.pddl import parse_domain, parse_problem

DOMAIN = """(define (domain library) (:types room) (:predicates (robot-in ?r - room))
 (:action walk :parameters (?a ?b - room) :precondition (robot-in ?a)
  :effect (and (not (robot-in ?a)) (robot-in ?b))))"""
PROBLEM = """(define (problem one) (:domain library) (:objects hall - room)
 (:init (robot-in hall)) (:goal (robot-in hall)))"""


def test_a_robot_without_a_name_is_said_to_be_where_it_is() -> None:
    problem = parse_problem(PROBLEM, parse_domain(DOMAIN, "domain"), "problem")
    said = Lexicon(problem, {}).clause("robot-in hall").said()
    assert said.startswith("I'm in")
    assert said.endswith("hall")
