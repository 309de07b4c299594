"""Changes of mind in words: the clauses that they come to, and what the trace then says."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from plainspoken.language.extracted import Status
from plainspoken.logic.syntax import parse, unparse
from plainspoken.mission.executive import Advance, accept, advance
from plainspoken.mission.mission import Mission
from plainspoken.mission.observation import ActionDone, NotPlanned, Planned
from plainspoken.pipeline import Request, Site, accepted_as, bundled, find_policy, open_site
from plainspoken.planning.solver import Solved
from plainspoken.questions.change import ChangeOfMind, wanted
from plainspoken.questions.conversation import message_of
from plainspoken.questions.lexicon import Lexicon
from plainspoken.world.scene import successors

GOAL = "F cleared_l2 & F cleared_l3 & G !robot_at_rob_l1"


@cache
def site() -> Site:
    names = ("domain.pddl", "problem.pddl", "landmarks.json")
    return open_site(*(bundled("vineyard") / name for name in names))


@cache
def lexicon() -> Lexicon:
    return Lexicon(site().problem, site().landmarks)


@cache
def begun(goal: str = GOAL) -> Advance:
    ending = find_policy(site().problem, parse(goal))
    assert isinstance(ending, Solved)
    return accept(accepted_as(site(), Request("m", parse(goal))), ending.policy)


def after(now: Advance, actions: int) -> Advance:
    """The mission some actions later, each with its first outcome."""
    for _ in range(actions):
        goal = now.mission.in_flight
        assert goal is not None
        state = successors(site().problem, now.mission.world, goal.action)[0]
        now = advance(now.mission, ActionDone(goal.goal_id, state))
    return now


def policy_from(mission: Mission, goal: str) -> Planned:
    """What a planner finds from where a mission is."""
    ending = find_policy(replace(site().problem, initial=mission.world), parse(goal))
    assert isinstance(ending, Solved)
    return Planned(ending.policy)


def change(
    text: str, mission: Mission | None = None, *, instead: bool | None = None
) -> ChangeOfMind:
    return wanted(text, mission or begun().mission, lexicon(), instead=instead)


def goals(found: ChangeOfMind) -> set[str]:
    assert found.meant is not None, found
    return {unparse(each.goal) for each in found.meant.clauses}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("skip line 3", {"F cleared_l2", "G !robot_at_rob_l1"}),
        ("never mind line 2", {"F cleared_l3", "G !robot_at_rob_l1"}),
        ("you needn't do line 3", {"F cleared_l2", "G !robot_at_rob_l1"}),
        ("don't clear line 3 any more", {"F cleared_l2", "G !robot_at_rob_l1"}),
        ("line 3 first", {"F(cleared_l3 & F cleared_l2)", "G !robot_at_rob_l1"}),
        ("line 2 last", {"F(cleared_l3 & F cleared_l2)", "G !robot_at_rob_l1"}),
        (
            "first go to the warehouse",
            {
                "F(robot_at_rob_wh & F cleared_l2)",
                "F(robot_at_rob_wh & F cleared_l3)",
                "G !robot_at_rob_l1",
            },
        ),
        (
            "and don't forget line 0",
            {"F cleared_l2", "F cleared_l3", "F cleared_l0", "G !robot_at_rob_l1"},
        ),
        ("line 0 instead of line 3", {"F cleared_l2", "F cleared_l0", "G !robot_at_rob_l1"}),
        ("stop after line 2", {"F cleared_l2", "G !robot_at_rob_l1"}),
        ("stop after this action", {"G !robot_at_rob_l1"}),
        ("forget all that and go to the warehouse", {"F robot_at_rob_wh"}),
        ("instead, clear line 0", {"F cleared_l0"}),
    ],
)
def test_a_change_of_mind_is_a_formula_over_what_is_left(text: str, expected: set[str]) -> None:
    assert goals(change(text)) == expected


def test_what_stays_keeps_its_instant_and_what_is_new_counts_from_now() -> None:
    now = after(begun(), 2)
    found = change("and don't forget line 0", now.mission)
    assert found.meant is not None
    since = {unparse(each.goal): each.since for each in found.meant.clauses}
    assert since["F cleared_l2"] == since["G !robot_at_rob_l1"] == 0
    assert since["F cleared_l0"] == now.mission.instant == 2


def test_stopping_after_a_thing_waits_until_the_policy_leaves_it() -> None:
    now = begun("F cleared_l0")
    assert now.mission.in_flight is not None
    assert now.mission.in_flight.action == "check-grape rob g0 l0"
    found = change("stop after this grape", now.mission)
    (goal,) = goals(found)
    assert goal.startswith("F(")
    assert "unripe_g0" in goal
    assert "inside_g0_b" in goal


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("skip line 1", "Nothing is asked of line 1"),
        ("stop", "pause the mission"),
        ("cancel everything", "missions cancel"),
        ("what are you doing?", "question"),
        ("gibberish foo", "do not understand"),
        ("stop after this elephant", "do not know"),
        ("", "Nothing is said"),
        ("x" * 100_000, "too long"),
    ],
)
def test_what_changes_nothing_is_refused_with_a_reason(text: str, reason: str) -> None:
    found = change(text)
    assert found.status is Status.REJECT
    assert reason in str(found.reason)


def test_a_whole_sentence_is_asked_about_unless_it_says_where_it_belongs() -> None:
    found = change("Call the support robot")
    assert [each.answer for each in found.choices] == ["besides", "instead"]
    assert len(goals(change("Call the support robot", instead=False))) == 4
    assert len(goals(change("Call the support robot", instead=True))) == 1
    assert len(goals(change("also call the support robot"))) == 4


def test_a_change_that_is_planned_is_carried_out_and_one_without_a_plan_is_not_made() -> None:
    now = after(begun(), 1)
    found = change("skip line 3", now.mission)
    asked = advance(now.mission, message_of(found, "bea"))
    assert asked.mission.change is not None
    done = after(asked, 1)
    refused = advance(done.mission, NotPlanned("no way"))
    assert refused.events[0].kind == "change_refused"
    assert refused.mission.brief.clauses == now.mission.brief.clauses
    taken = advance(done.mission, policy_from(done.mission, "F cleared_l2 & G !robot_at_rob_l1"))
    assert [each.kind for each in taken.events[:2]] == ["request_changed", "policy_chosen"]
