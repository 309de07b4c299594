import pytest

from plainspoken.world.domain import Problem
from plainspoken.world.pddl import parse_domain, parse_problem
from plainspoken.world.sense import Sense, Senses, atoms_of, implied, left_open

DOMAIN = parse_domain(
    "(define (domain d) (:requirements :typing) (:types room key)"
    " (:predicates (in ?k - key ?r - room) (open ?r - room) (unknown ?k - key))"
    " (:action lock :parameters (?r - room) :precondition (open ?r) :effect (not (open ?r))))",
    "d",
)


def problem(init: str) -> Problem:
    return parse_problem(
        "(define (problem p) (:domain d) (:objects r1 r2 r3 - room k - key)"
        f" (:init {init}) (:goal (open r1)))",
        DOMAIN,
        "p",
    )


def test_what_is_unknown_is_false_until_somebody_says() -> None:
    read = problem("(unknown (open r1))")
    assert read.unknown == {"open r1"}
    assert read.initial == frozenset()


def test_what_is_stated_beside_it_is_what_is_assumed() -> None:
    assert problem("(open r1) (unknown (open r1))").initial == {"open r1"}


def test_of_a_group_the_first_is_assumed_unless_another_is_stated() -> None:
    group = "(oneof (in k r1) (in k r2) (in k r3))"
    assert problem(group).initial == {"in k r1"}
    assert problem(group + " (in k r2)").initial == {"in k r2"}
    assert problem(group).oneofs == (("in k r1", "in k r2", "in k r3"),)


def test_a_predicate_may_be_called_unknown() -> None:
    read = problem("(unknown k)")
    assert read.initial == {"unknown k"}
    assert not read.unknown


@pytest.mark.parametrize(
    ("pattern", "atom", "fits"),
    [
        ("in {k} {r}", "in k r1", True),
        ("in {k} r1", "in k r2", False),
        ("in {x} {x}", "in k r1", False),
        ("in {x} {x}", "in k k", True),
        ("open {r}", "in k r1", False),
    ],
)
def test_a_pattern_fits_atoms_whose_objects_stand_for_its_placeholders(
    pattern: str, atom: str, *, fits: bool
) -> None:
    assert Sense(pattern).fits(atom) is fits


def test_the_atoms_of_a_pattern_are_those_of_its_types() -> None:
    assert list(atoms_of("in {k} {r}", problem(""))) == ["in k r1", "in k r2", "in k r3"]
    assert list(atoms_of("open r2", problem(""))) == ["open r2"]


def test_of_several_rules_for_one_atom_the_first_counts() -> None:
    senses = Senses((Sense("open r1", lasts=5.0), Sense("open {r}", lasts=9.0)), {"in_k_r1": 3.0})
    assert [senses.lasts(atom) for atom in ("open r1", "open r2", "in k r1", "in k r2")] == [
        5.0,
        9.0,
        3.0,
        None,
    ]


GROUP = ("a", "b", "c")


@pytest.mark.parametrize(
    ("told", "follows"),
    [
        ({"a": True}, {"b": False, "c": False}),
        ({"a": False}, {}),
        ({"a": False, "b": False}, {"c": True}),
        ({}, {}),
    ],
)
def test_exactly_one_of_a_group_is_true(told: dict[str, bool], follows: dict[str, bool]) -> None:
    assert implied(told, [GROUP]) == follows


def test_what_is_left_of_a_group_after_some_were_told() -> None:
    assert left_open([GROUP], {"a": False}) == (("b", "c"),)
    assert left_open([GROUP], {"a": True}) == ()
    # Whether it was true before an action changed it nobody knows.
    assert left_open([GROUP], {}, ["a"]) == ()
