from pathlib import Path

import pytest
from tests.mission.small_vineyard import PROBLEM, accepted, policy_for

from plainspoken.errors import PlainspokenError
from plainspoken.logic.syntax import parse
from plainspoken.mission.executive import accept, advance
from plainspoken.mission.mission import mission_from
from plainspoken.mission.observation import PauseAsked
from plainspoken.mission.request import Clause, acceptance
from plainspoken.world.domain import Problem
from plainspoken.world.event import Entry
from plainspoken.world.pddl import read_domain, read_problem

GOAL = parse("F cleared_l0")
FIRST = accept(accepted(GOAL), policy_for(GOAL))
ENTRIES = [Entry(step, "t", 0, event) for step, event in enumerate(FIRST.events)]


def test_a_mission_comes_back_from_its_entries_alone() -> None:
    assert mission_from(ENTRIES) == FIRST.mission
    paused = advance(FIRST.mission, PauseAsked("ada"))
    assert mission_from([*ENTRIES, Entry(3, "t", 0, paused.events[0])]) == paused.mission


def test_a_mission_whose_log_breaks_off_within_a_decision_comes_back_before_it() -> None:
    assert mission_from(ENTRIES[:2]).in_flight is None
    assert mission_from(ENTRIES[:1]).policy is None


@pytest.mark.parametrize(
    ("entries", "what"),
    [
        ([], "empty log"),
        (ENTRIES[1:], "begins with mission_accepted"),
        ([ENTRIES[0], ENTRIES[0]], "accepted once"),
        ([Entry(0, "t", 4, FIRST.events[0])], "expected instant 0, got 4"),
    ],
)
def test_entries_that_are_no_log_of_one_mission_are_refused(
    entries: list[Entry], what: str
) -> None:
    with pytest.raises(PlainspokenError, match=what):
        mission_from(entries)


def test_what_no_action_changes_is_kept_once_and_apart_from_the_state() -> None:
    event = accepted(GOAL)
    assert set(event.static) == {
        "adjacent l0 wh",
        "adjacent wh l0",
        "carries rob b",
        "grape-at g0 l0",
    }
    assert event.state | set(event.static) == PROBLEM.initial
    assert FIRST.mission.world == PROBLEM.initial


def vineyard() -> tuple[Problem, str, str]:
    folder = Path(__file__).parents[2] / "examples" / "vineyard"
    domain = read_domain(folder / "domain.pddl")
    problem = read_problem(folder / "problem.pddl", domain)
    return (
        problem,
        (folder / "domain.pddl").read_text(),
        (folder / "problem.pddl").read_text(),
    )


def test_the_texts_in_the_first_event_are_the_problem() -> None:
    problem, domain_text, problem_text = vineyard()
    event = acceptance(
        "m", problem, parse("F cleared_l2"), domain_text=domain_text, problem_text=problem_text
    )
    mission = mission_from([Entry(0, "t", 0, event)])
    assert mission.brief.problem == problem
    assert mission.brief.clauses == (Clause(parse("F cleared_l2")),)
    assert mission.world == problem.initial
