"""What excludes what, against every state that can be reached."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from tests.strategies import problems

from plainspoken.planning.exclusion import Exclusions
from plainspoken.world.domain import GroundAtom, Problem, State
from plainspoken.world.pddl import read_domain, read_problem
from plainspoken.world.scene import applicable_actions, successors

EXAMPLES = Path(__file__).parents[2] / "examples"
MOST_STATES = 400


def reached(problem: Problem) -> list[State]:
    """States that can be reached: all of a small problem, the nearest of a larger one."""
    found = {problem.initial: None}
    queue = [problem.initial]
    while queue and len(found) < MOST_STATES:
        state = queue.pop(0)
        for action in applicable_actions(problem, state):
            for after in successors(problem, state, action):
                if after not in found:
                    found[after] = None
                    queue.append(after)
    return list(found)


def every_atom(problem: Problem) -> Iterator[GroundAtom]:
    for predicate, parameters in problem.domain.predicates.items():
        for binding in problem.bindings(parameters):
            yield " ".join([predicate, *(binding[each.name] for each in parameters)])


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(problems())
def test_what_is_excluded_is_so_in_no_state_and_a_group_has_one_in_each(problem: Problem) -> None:
    exclusions = Exclusions(problem)
    atoms = sorted({atom for state in reached(problem) for atom in state})
    for state in reached(problem):
        literals = [(atom, atom in state) for atom in atoms]
        for literal in literals:
            assert exclusions.is_possible(literal)
            for atom, holds in exclusions.implied(literal):
                assert (atom in state) == holds
        for atom in atoms:
            group = exclusions.group(atom)
            assert not group or sum(each in state for each in group) == 1


def example(name: str) -> Exclusions:
    folder = EXAMPLES / name
    domain = read_domain(folder / "domain.pddl")
    return Exclusions(read_problem(folder / "problem.pddl", domain))


@pytest.mark.parametrize(
    ("name", "group"),
    [
        ("vineyard", {"ripe g2", "unripe g2", "unknown g2", "unchecked g2"}),
        ("vineyard", {"hand-empty rob", "in-hand g0", "in-hand g1", "in-hand g2", "in-hand g3"}),
        ("kitchen", {"hand-empty rob", "holding onion", "holding carrot", "holding milk"}),
    ],
)
def test_what_a_thing_can_be_is_a_group_and_there_is_no_other(name: str, group: set[str]) -> None:
    exclusions = example(name)
    assert all(set(exclusions.group(atom)) == group for atom in group)


def test_what_can_be_by_itself_is_of_no_group() -> None:
    exclusions = example("vineyard")
    assert exclusions.group("full b") == exclusions.group("cleared l0") == ()
    assert exclusions.group("no such atom") == ()


def test_what_never_changes_is_possible_only_as_it_is() -> None:
    exclusions = example("vineyard")
    assert exclusions.is_possible(("adjacent l0 l1", True))
    assert not exclusions.is_possible(("adjacent l0 l1", False))
    assert not exclusions.is_possible(("adjacent l0 l3", True))


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(problems(), st.data())
def test_what_nobody_knows_at_first_excludes_only_what_it_excludes_either_way(
    problem: Problem, data: st.DataObject
) -> None:
    changing = sorted(
        atom for atom in every_atom(problem) if atom.split()[0] in problem.changing_predicates
    )
    unknown = data.draw(st.sets(st.sampled_from(changing), max_size=3)) if changing else set()
    exclusions = Exclusions(problem, frozenset(unknown))
    true = data.draw(st.sets(st.sampled_from(sorted(unknown)))) if unknown else set()
    drawn = replace(problem, initial=(problem.initial - unknown) | true)
    states = reached(drawn)
    atoms = sorted({atom for state in states for atom in state} | unknown)
    for state in states:
        for literal in [(atom, atom in state) for atom in atoms]:
            assert exclusions.is_possible(literal)
            for atom, holds in exclusions.implied(literal):
                assert (atom in state) == holds
        for atom in atoms:
            group = exclusions.group(atom)
            assert not group or sum(each in state for each in group) == 1


def test_of_a_group_of_which_one_is_so_the_others_are_not() -> None:
    exclusions = example("store-room")
    assert exclusions.exclude(("in parcel red-room", True), ("in parcel blue-room", True))
    assert exclusions.is_possible(("in parcel blue-room", True))
    assert exclusions.is_possible(("locked blue-room", True))
    assert exclusions.group("in parcel blue-room") == exclusions.group("in parcel red-room") != ()
