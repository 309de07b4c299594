"""Landmarks made from the names of a domain and problem alone."""

from pathlib import Path

import pytest

from plainspoken.language.extraction import extract
from plainspoken.language.grounding import Vocabulary
from plainspoken.logic.syntax import unparse
from plainspoken.world.derivation import derived_landmarks
from plainspoken.world.domain import Problem
from plainspoken.world.landmark import LandmarkType
from plainspoken.world.pddl import read_domain, read_problem
from plainspoken.world.symbol import resolve

VINEYARD = Path(__file__).parents[2] / "examples" / "vineyard"

PORTERS = """
(define (domain porters)
  (:requirements :typing)
  (:types robot room tray - object)
  (:predicates (in ?r - robot ?m - room) (next-to ?a ?b - room) (carrying ?r - robot ?t - tray)
               (on-shelf ?t - tray) (is-locked ?m - room))
  (:action go :parameters (?r - robot ?a ?b - room)
    :precondition (and (in ?r ?a) (next-to ?a ?b) (not (is-locked ?b)))
    :effect (and (not (in ?r ?a)) (in ?r ?b)))
  (:action pick-up :parameters (?r - robot ?t - tray)
    :precondition (on-shelf ?t) :effect (and (carrying ?r ?t) (not (on-shelf ?t))))
  (:action unlock :parameters (?r - robot ?m - room)
    :precondition (is-locked ?m) :effect (not (is-locked ?m))))
"""
TWO_PORTERS = """
(define (problem two) (:domain porters)
  (:objects ann bob - robot lobby ward1 - room tray1 tray2 - tray)
  (:init (in ann lobby) (in bob lobby) (next-to lobby ward1) (on-shelf tray1) (on-shelf tray2)
         (is-locked ward1))
  (:goal (and)))
"""
UNTYPED = """
(define (domain untyped)
  (:predicates (room ?r) (ball ?b) (at-robot ?r) (at ?b ?r) (carry ?b) (free))
  (:action move :parameters (?from ?to)
    :precondition (and (room ?from) (room ?to) (at-robot ?from))
    :effect (and (at-robot ?to) (not (at-robot ?from))))
  (:action pick :parameters (?obj ?room)
    :precondition (and (ball ?obj) (room ?room) (at ?obj ?room) (at-robot ?room) (free))
    :effect (and (carry ?obj) (not (at ?obj ?room)) (not (free)))))
"""
TWO_ROOMS = """
(define (problem rooms) (:domain untyped)
  (:objects rooma roomb ball1 ball2)
  (:init (room rooma) (room roomb) (ball ball1) (ball ball2) (at-robot rooma) (free)
         (at ball1 rooma) (at ball2 rooma))
  (:goal (at ball1 roomb)))
"""


def problem_of(tmp_path: Path, domain: str, problem: str) -> Problem:
    (tmp_path / "domain.pddl").write_text(domain)
    (tmp_path / "problem.pddl").write_text(problem)
    return read_problem(tmp_path / "problem.pddl", read_domain(tmp_path / "domain.pddl"))


@pytest.fixture(scope="module")
def vineyard() -> Problem:
    return read_problem(VINEYARD / "problem.pddl", read_domain(VINEYARD / "domain.pddl"))


@pytest.mark.parametrize(
    ("id", "description", "type"),
    [
        ("robot_at_rob_l1", "line 1", LandmarkType.LOCATION),
        ("robot_at_rob_wh", "the warehouse", LandmarkType.LOCATION),
        ("robot_at_sup_l1", "the support is at line 1", LandmarkType.CONDITION),
        ("full_b", "the box is full", LandmarkType.CONDITION),
        ("ripe_g2", "grape 2 is ripe", LandmarkType.CONDITION),
        ("in_hand_g0", "grape 0 is in the hand", LandmarkType.CONDITION),
        ("harvest_grape_executed", "to harvest a grape", LandmarkType.ACTION),
        ("harvest_grape_g1_executed", "to harvest grape 1", LandmarkType.ACTION),
        ("sign_off_l3_executed", "to sign off line 3", LandmarkType.ACTION),
    ],
)
def test_names_of_a_problem_become_words(
    vineyard: Problem, id: str, description: str, type: LandmarkType
) -> None:
    landmark = derived_landmarks(vineyard)[id]
    assert (landmark.description, landmark.type) == (description, type)


def test_every_derived_landmark_names_something_of_the_problem(vineyard: Problem) -> None:
    for id in derived_landmarks(vineyard):
        assert resolve(id, vineyard).id == id


@pytest.mark.parametrize(
    ("sentence", "literal"),
    [
        ("Clear line 2, but never enter line 3 while the box is full.",
         "F cleared_l2 & G(full_b -> !robot_at_rob_l3)"),
        ("Harvest grape 1 after checking grape 1.",
         "G(check_grape_g1_executed -> F harvest_grape_g1_executed)"),
        ("As soon as the box is full, call the support robot.",
         "G(full_b -> X call_support_executed)"),
        ("Go to the warehouse and then to line 0.", "F(robot_at_rob_wh & F robot_at_rob_l0)"),
    ],
)  # fmt: skip
def test_derived_words_are_understood(vineyard: Problem, sentence: str, literal: str) -> None:
    extraction = extract(sentence, Vocabulary.of(derived_landmarks(vineyard)), None)
    assert extraction.reading is not None, extraction.reason
    assert unparse(extraction.reading.literal) == literal


def test_the_place_of_one_of_two_robots_is_asked_for(tmp_path: Path) -> None:
    vocabulary = Vocabulary.of(derived_landmarks(problem_of(tmp_path, PORTERS, TWO_PORTERS)))
    asked = extract("Go to ward 1.", vocabulary, None)
    assert asked.status == "clarify"
    assert asked.question is not None
    assert "Ann at ward 1 or Bob at ward 1" in asked.question
    told = extract("Bob goes to ward 1.", vocabulary, None)
    assert told.reading is not None, told.reason
    assert unparse(told.reading.literal) == "F in_bob_ward1"


def test_two_robots_and_their_acts_are_told_apart(tmp_path: Path) -> None:
    landmarks = derived_landmarks(problem_of(tmp_path, PORTERS, TWO_PORTERS))
    assert landmarks["ann_executes_unlock"].phrases == (
        "to unlock a room with Ann", "Ann unlocks a room", "robot Ann unlocks a room",
        "Ann unlocks", "robot Ann unlocks", "to unlock Ann",
    )  # fmt: skip
    assert landmarks["carrying_ann_tray1"].description == "Ann is carrying tray 1"
    assert landmarks["is_locked_ward1"].description == "ward 1 is locked"


def test_static_predicates_stand_for_types_where_there_are_none(tmp_path: Path) -> None:
    landmarks = derived_landmarks(problem_of(tmp_path, UNTYPED, TWO_ROOMS))
    assert landmarks["at_robot_rooma"].description == "room A"
    assert landmarks["at_ball1_rooma"].description == "ball 1 is in room A"
    assert "at_rooma_ball1" not in landmarks
    assert landmarks["pick_ball2_executed"].description == "to pick ball 2"
