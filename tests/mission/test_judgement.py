"""What is known of a request after each instant, judged by the plain semantics of all traces."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.mission.small_vineyard import PROBLEM, accepted, policy_for
from tests.mission.store_room import SITE as STORE_ROOM
from tests.mission.store_room import Kept
from tests.strategies import formulas, traces

from plainspoken.automata.verdict import Monitor, Verdict
from plainspoken.logic.formula import And, Formula, atoms, conjuncts
from plainspoken.logic.syntax import parse
from plainspoken.logic.trace import Letter, Trace, holds
from plainspoken.mission.command import Plan
from plainspoken.mission.executive import Advance, accept, advance
from plainspoken.mission.judgement import broken_parts, first_breach, judgements, reached
from plainspoken.mission.observation import (
    ActionDone,
    NotPlanned,
    Observation,
    PauseAsked,
    Sensed,
)
from plainspoken.mission.observation import Told as Reported
from plainspoken.pipeline import Request, Site, accepted_as, find_policy, replanner
from plainspoken.planning.solver import Solved
from plainspoken.world.event import Entry, MissionEnded, VerdictReached
from plainspoken.world.scene import successors
from plainspoken.world.sense import Sense, senses_to_json


class Told:
    """A mission that is told things, and its log."""

    def __init__(self, goal: str) -> None:
        self.entries: list[Entry] = []
        formula = parse(goal)
        self.now = self._kept(accept(accepted(formula), policy_for(formula)))

    def hears(self, observation: Observation) -> Advance:
        self.now = self._kept(advance(self.now.mission, observation))
        return self.now

    def does(self) -> Advance:
        """The action under way turns out in the first of its ways."""
        goal = self.now.mission.in_flight
        assert goal is not None
        state = successors(PROBLEM, self.now.mission.world, goal.action)[0]
        return self.hears(ActionDone(goal.goal_id, state))

    def _kept(self, now: Advance) -> Advance:
        for event in now.events:
            self.entries.append(Entry(len(self.entries), "t", now.mission.instant, event))
        return now


def ways_on(names: Sequence[str], most: int) -> list[list[Letter]]:
    letters = [
        frozenset(name for name, here in zip(names, chosen, strict=True) if here)
        for chosen in product((False, True), repeat=len(names))
    ]
    return [list(way) for length in range(most + 1) for way in product(letters, repeat=length)]


@given(st.lists(formulas(), min_size=1, max_size=3), traces(longest=3))
def test_what_is_called_broken_is_met_by_no_way_to_go_on(parts: list[Formula], seen: Trace) -> None:
    goal = And(tuple(parts)) if len(parts) > 1 else parts[0]
    broken = broken_parts(Monitor.of(goal).after_all(seen))
    if broken:
        asked = [parse(clause) for clause in broken]
        names = sorted(frozenset[str]().union(*map(atoms, asked)))[:3]
        for way in ways_on(names, 2 if len(names) > 2 else 3):
            assert not all(holds(clause, [*seen, *way]) for clause in asked)


@given(st.lists(formulas(), min_size=1, max_size=3), traces(longest=3), traces(longest=3))
def test_what_some_way_to_go_on_meets_is_not_called_broken(
    parts: list[Formula], seen: Trace, rest: Trace
) -> None:
    goal = And(tuple(parts)) if len(parts) > 1 else parts[0]
    if holds(goal, [*seen, *rest]):
        assert broken_parts(Monitor.of(goal).after_all(seen)) == ()


@pytest.mark.parametrize(
    ("goal", "trace", "broken"),
    [
        ("F a & G !a", "|", ("F a", "G !a")),
        ("F a & F b & (!a U b) & (!b U a)", "", ()),
        ("(!a U b) & (!b U (a & !b))", "", ("!a U b", "!b U (a & !b)")),
        ("F a & X !true", "|b", ("X !true",)),
        ("F a & F b", "|", ()),
        ("G(a -> X b) & G(c -> !b) & F c & X c", "a", ("G(a -> X b)", "G(c -> !b)", "X c")),
        ("F a & G b", "b|", ("G b",)),
    ],
)
def test_the_clauses_that_are_in_each_others_way(
    goal: str, trace: str, broken: tuple[str, ...]
) -> None:
    monitor = Monitor.of(parse(goal)).after_all(frozenset(instant) for instant in trace.split("|"))
    found = broken_parts(monitor)
    assert [parse(clause) for clause in found] == [parse(clause) for clause in broken]


def test_after_each_instant_the_whole_and_each_clause_are_judged() -> None:
    told = Told("F cleared_l0 & G robot_at_sup_wh")
    while not told.now.mission.is_over:
        told.does()
    found = list(judgements(told.entries))
    assert [each.instant for each in found] == list(range(told.now.mission.instant + 1))
    clauses = [dict(each.clauses) for each in found]
    assert [each["F cleared_l0"] for each in clauses][-1] == Verdict.SATISFIED
    assert {each["G robot_at_sup_wh"] for each in clauses} == {Verdict.HOLDS_SO_FAR}
    assert found[-1].verdict is Verdict.HOLDS_SO_FAR
    assert first_breach(found) is None


def test_the_instant_that_broke_a_clause_is_named_with_the_entry_that_began_it() -> None:
    told = Told("F cleared_l0 & G robot_at_sup_wh")
    told.does()
    away = told.now.mission.world - {"robot-at sup wh"} | {"robot-at sup l0"}
    told.hears(Sensed("camera", away))
    breach = first_breach(judgements(told.entries))
    assert breach is not None
    assert (breach.instant, breach.action) == (2, None)
    assert breach.broken == ("G robot_at_sup_wh",)
    assert told.entries[breach.step].kind == "observation_made"
    # It is said while the action is still under way, not at the end.
    assert told.now.mission.in_flight is not None
    assert told.entries[-1].event == VerdictReached("violated", "G robot_at_sup_wh")


def test_clauses_that_only_together_are_lost_are_announced_as_soon_as_no_policy_is_followed() -> (
    None
):
    told = Told("F cleared_l0")
    apart = Monitor.of(parse("F a & G !a & F b")).after_all([frozenset()])
    mission = replace(told.now.mission, monitor=apart, in_flight=None)
    assert reached(mission) is None  # the policy that is followed proves that there is a way
    found = reached(replace(mission, node=None))
    assert found == VerdictReached("violated", together=("F a", "G !a"))


def test_what_the_domain_cannot_mend_is_announced_as_lost_with_the_reason() -> None:
    told = Told("F cleared_l0")
    told.does()
    site = Site(PROBLEM, "", "")
    # The grape is gone and was never checked: no action of the domain brings it back.
    gone = told.now.mission.world - {"unchecked g0", "grape-at g0 l0"}
    now = told.hears(ActionDone("m/2", gone))
    (command,) = now.commands
    assert isinstance(command, Plan)
    found = replanner(site)(command.state, command.remaining, lambda: None)
    assert isinstance(found, NotPlanned)
    assert found.hopeless
    now = told.hears(found)
    announced, ended = now.events
    assert announced == VerdictReached("violated", reason=found.reason)
    assert isinstance(ended, MissionEnded)
    assert ended.outcome == "stopped"
    breach = first_breach(judgements(told.entries))
    assert breach is not None
    assert breach.reason == found.reason


def test_what_luck_could_still_do_is_not_announced_as_lost() -> None:
    told = Told("F cleared_l0")
    now = told.hears(NotPlanned("I can't promise it."))
    assert now.events[-1] == MissionEnded("stopped", satisfied=False, reason="I can't promise it.")
    assert not any(isinstance(event, VerdictReached) for event in now.events)


def test_a_paused_mission_says_at_once_what_a_report_has_broken() -> None:
    told = Told("F cleared_l0 & G robot_at_sup_wh")
    told.does()
    told.hears(PauseAsked("ada"))
    away = told.now.mission.world - {"robot-at sup wh"}
    now = told.hears(Sensed("camera", away))
    assert VerdictReached("violated", "G robot_at_sup_wh") in now.events


def test_conjuncts_are_judged_as_they_are_written() -> None:
    goal = parse("F cleared_l0 & G robot_at_sup_wh")
    told = Told("F cleared_l0 & G robot_at_sup_wh")
    (first, *_) = judgements(told.entries)
    assert [parse(clause) for clause, _ in first.clauses] == list(conjuncts(goal))


def test_what_was_only_assumed_and_is_otherwise_has_the_instant_judged_anew() -> None:
    goal = parse("F in_parcel_ramp & G !full_ramp")
    ending = find_policy(STORE_ROOM.problem, goal)
    assert isinstance(ending, Solved)
    senses = senses_to_json([Sense("full {p}", ("eye",), needed=True)])
    request = Request("m", goal, robot={"senses": senses})
    kept = Kept()
    first = accept(accepted_as(STORE_ROOM, request), ending.policy)
    kept.record(0, first.events)
    then = advance(
        first.mission, Reported("ada", "the ramp is full", added=frozenset({"full ramp"}))
    )
    kept.record(then.mission.instant, then.events)
    assert isinstance(kept.entries[-1].event, MissionEnded)
    assert [(each.instant, each.verdict) for each in judgements(kept.entries)] == [
        (0, Verdict.OPEN),
        (0, Verdict.VIOLATED),
    ]
    breach = first_breach(judgements(kept.entries))
    assert breach is not None
    assert breach.broken == ("G !full_ramp",)
    assert kept.entries[breach.step].kind == "report_received"
