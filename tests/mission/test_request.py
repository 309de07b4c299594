"""A change of mind: what it does to a mission, and what its verdict then means."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.mission.small_vineyard import PROBLEM, accepted, policy_for, replanned
from tests.strategies import formulas

from plainspoken.automata.verdict import Verdict
from plainspoken.errors import PlainspokenError, UnknownSymbolError
from plainspoken.logic.formula import Formula, atoms
from plainspoken.logic.syntax import parse
from plainspoken.logic.trace import holds
from plainspoken.mission.command import Plan
from plainspoken.mission.executive import Advance, accept, advance
from plainspoken.mission.observation import (
    ActionDone,
    ChangeAsked,
    NotPlanned,
    PauseAsked,
    Planned,
    ResumeAsked,
)
from plainspoken.mission.request import (
    Clause,
    Past,
    clauses_from_json,
    clauses_to_json,
    monitor_of,
    symbols_of,
)
from plainspoken.planning.policy import Policy
from plainspoken.world.event import ChangeRefused, RequestChanged
from plainspoken.world.scene import applicable_actions, successors
from plainspoken.world.symbol import letter

GOAL = parse("F cleared_l0")
GO = "move rob wh l0"
THERE = successors(PROBLEM, PROBLEM.initial, GO)[0]
CHECKED = successors(PROBLEM, THERE, "check-grape rob g0 l0")[0]


def kinds(now: Advance) -> list[str]:
    return [event.kind for event in now.events]


def asked(now: Advance, *clauses: Clause) -> Advance:
    return advance(now.mission, ChangeAsked("ada", "something else", clauses))


def at_the_line() -> Advance:
    start = accept(accepted(GOAL), policy_for(GOAL)).mission
    return advance(start, ActionDone("m/1", THERE))


def waiting(*clauses: Clause) -> Advance:
    """Something else was asked while the check was under way, which has now ended."""
    now = asked(at_the_line(), *clauses)
    assert kinds(now) == ["change_requested"]
    return advance(now.mission, ActionDone("m/2", CHECKED))


def planned(now: Advance) -> Policy:
    (command,) = now.commands
    assert isinstance(command, Plan)
    policy = replanned(command.state, command.remaining)
    assert isinstance(policy, Policy)
    return policy


def test_a_change_waits_for_the_action_under_way_and_for_a_policy() -> None:
    home = Clause(parse("F robot_at_rob_wh"), since=1)
    now = waiting(home)
    assert kinds(now) == ["action_finished"]
    now = advance(now.mission, Planned(planned(now)))
    assert kinds(now) == ["request_changed", "policy_chosen", "action_started"]
    assert now.mission.brief.clauses == (home,)
    assert now.mission.in_flight is not None
    assert now.mission.in_flight.action == "move rob l0 wh"


def test_a_change_that_cannot_be_planned_leaves_everything_as_it_was() -> None:
    now = waiting(Clause(parse("F full_b"), since=1))
    now = advance(now.mission, NotPlanned("nothing is left to pick"))
    assert kinds(now) == ["change_refused", "action_started"]
    assert now.events[0] == ChangeRefused("ada", "something else", "nothing is left to pick")
    assert now.mission.brief.clauses == (Clause(GOAL),)


def test_a_change_that_the_past_has_broken_is_refused_at_once() -> None:
    now = asked(at_the_line(), Clause(parse("G robot_at_rob_wh")))
    assert kinds(now) == ["change_requested", "change_refused"]
    assert now.mission.change is None


def test_a_clause_that_begins_now_forgets_what_was_before() -> None:
    stay = Clause(parse("G robot_at_rob_l0"), since=1)
    now = waiting(stay)
    now = advance(now.mission, Planned(planned(now)))
    assert now.events[-1].kind == "mission_ended"
    assert now.mission.satisfied


def test_a_paused_mission_takes_a_change_up_when_it_goes_on() -> None:
    now = asked(advance(at_the_line().mission, PauseAsked("ada")), Clause(parse("F full_b"), 1))
    now = advance(now.mission, ActionDone("m/2", CHECKED))
    assert now.commands == ()
    now = advance(now.mission, ResumeAsked("ada"))
    assert [type(command).__name__ for command in now.commands] == ["Look"]


def test_a_policy_that_is_not_for_the_change_is_refused_and_the_mission_goes_on() -> None:
    now = waiting(Clause(parse("F full_b"), since=1))
    now = advance(now.mission, Planned(policy_for(GOAL)))
    assert kinds(now)[0] == "change_refused"
    assert not any(isinstance(event, RequestChanged) for event in now.events)


def test_clauses_that_name_what_the_domain_has_not_are_an_error() -> None:
    with pytest.raises(UnknownSymbolError):
        asked(at_the_line(), Clause(parse("F flying_rob")))


@pytest.mark.parametrize("since", [-1, 2])
def test_a_clause_cannot_begin_at_an_instant_that_is_no_part_of_the_trace(since: int) -> None:
    with pytest.raises(PlainspokenError, match="cannot begin"):
        asked(at_the_line(), Clause(GOAL, since))


@given(st.lists(st.builds(Clause, formulas(), st.integers(0, 9)), max_size=3))
def test_clauses_come_back_from_json(clauses: list[Clause]) -> None:
    assert clauses_from_json(clauses_to_json(clauses), "test") == tuple(clauses)


@pytest.mark.parametrize("document", [{}, {"since": 0}, {"since": "x", "goal": "F a"}])
def test_what_are_no_clauses_is_refused(document: dict[str, object]) -> None:
    with pytest.raises(PlainspokenError, match="clauses"):
        clauses_from_json([document], "test")


SAID = [parse(text) for text in ("F cleared_l0", "G !full_b", "check_grape_executed R !full_b")]


@given(st.sampled_from(SAID), st.integers(0, 4), st.randoms(use_true_random=False))
def test_a_clause_is_judged_by_the_trace_from_its_instant_on(
    goal: Formula, since: int, chance: object
) -> None:
    choose = chance.choice  # type: ignore[attr-defined]
    past = Past(PROBLEM.initial, None)
    for _ in range(since + 3):
        action = choose(list(applicable_actions(PROBLEM, past.state)))
        past = Past(choose(successors(PROBLEM, past.state, action)), action, past)
    clause = Clause(goal, since)
    symbols = symbols_of([clause], PROBLEM)
    (first, _), *rest = past.moments()[since:]
    letters = (letter(symbols, first, None), *(letter(symbols, *moment) for moment in rest))
    verdict = monitor_of([clause], symbols, past).verdict
    assert (verdict in (Verdict.SATISFIED, Verdict.HOLDS_SO_FAR)) == holds(goal, letters)
    assert atoms(goal) == {symbol.id for symbol in symbols}
