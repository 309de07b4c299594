"""What a step rests on is looked at before it, where nobody knows it or it was seen long ago."""

from collections.abc import Sequence
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.mission.store_room import GOAL, SITE, Kept, carried_out, veiled

from plainspoken.knowledge.facts import facts_after
from plainspoken.logic.trace import holds
from plainspoken.mission.command import Look, Sense
from plainspoken.mission.executive import Advance, accept, advance
from plainspoken.mission.mailbox import from_message, to_message
from plainspoken.mission.mission import mission_from
from plainspoken.mission.observation import (
    ActionDone,
    ActionNotDone,
    CancelAsked,
    FactsTold,
    LookAsked,
    PauseAsked,
    Sensed,
    TakeUpAsked,
    Told,
)
from plainspoken.mission.request import symbols_of
from plainspoken.mission.sensing import Telling
from plainspoken.mission.simulator import Steering
from plainspoken.pipeline import Request, accepted_as, find_policy
from plainspoken.planning.solver import Solved
from plainspoken.world.event import ActionStarted, MissionEnded, ObservationMade
from plainspoken.world.sense import Sense as Rule
from plainspoken.world.sense import senses_to_json

EVERYTHING = [
    Rule("locked {p}", ("eye",), needed=True),
    Rule("full {p}", ("eye",), 60.0, needed=True),
]


def begun(senses: Sequence[Rule] = EVERYTHING) -> Advance:
    ending = find_policy(SITE.problem, GOAL)
    assert isinstance(ending, Solved)
    request = Request("m", GOAL, robot={"senses": senses_to_json(senses)})
    return accept(accepted_as(SITE, request), ending.policy)


def eye(atom: str, *, holds: bool | None) -> FactsTold:
    return FactsTold((Telling(atom, holds, "eye", "2026-11-22T10:00:00+00:00"),))


@settings(deadline=None, max_examples=60)
@given(st.integers(0, 10_000))
def test_a_mission_comes_to_its_end_whatever_is_hidden_and_its_verdict_is_that_of_the_trace(
    seed: int,
) -> None:
    robot, world = veiled(seed)
    mission, entries = carried_out(robot)
    assert mission.ended == MissionEnded("finished", satisfied=True)
    assert "in parcel ramp" in world.state()
    facts = facts_after(entries)
    letters = facts.letters(symbols_of(mission.brief.clauses, SITE.problem))
    assert holds(GOAL, letters)
    # What it believes in the end is so, but for what nobody needed to know.
    unknown = mission.lookout.unknown
    assert mission.world - unknown == world.state() - unknown
    assert mission == replace(mission_from(entries), limits=mission.limits)


def test_no_action_begins_before_what_it_needs_is_known() -> None:
    first = begun()
    assert not any(isinstance(event, ActionStarted) for event in first.events)
    assert first.commands == (Sense("m/look-1", ("locked red-room",)),)
    then = advance(first.mission, eye("locked red-room", holds=False))
    assert [type(event) for event in then.events] == [ObservationMade, ActionStarted]
    assert then.mission.instant == 0


def test_a_look_that_contradicts_what_was_assumed_is_a_deviation_at_the_same_instant() -> None:
    then = advance(begun().mission, eye("locked red-room", holds=True))
    assert [event.kind for event in then.events] == ["observation_made", "deviation_noticed"]
    assert then.mission.instant == 0
    assert "locked red-room" in then.mission.state


def test_a_known_fact_that_turns_out_to_have_changed_is_a_new_instant() -> None:
    known = advance(begun().mission, eye("locked red-room", holds=False)).mission
    paused = advance(known, PauseAsked("ada")).mission
    done = advance(paused, ActionDone("m/1", paused.world - {"at rob hall"} | {"at rob red-room"}))
    seen = advance(done.mission, LookAsked("ada", frozenset({"locked red-room"}))).mission
    changed = advance(seen, eye("locked red-room", holds=True)).mission
    assert changed.instant == done.mission.instant + 1


def test_what_a_person_reports_need_not_be_looked_at_any_more() -> None:
    paused = advance(begun().mission, PauseAsked("ada")).mission
    both = frozenset({"full ramp", "locked blue-room"})
    asked = advance(paused, LookAsked("bob", both))
    assert asked.commands == (Sense("m/look-1", tuple(sorted(both))),)
    reported = Told("cem", "the ramp is free", deleted=frozenset({"full ramp"}))
    then = advance(asked.mission, reported)
    assert then.commands == (Sense("m/look-1", ("locked blue-room",)),)


def test_what_nothing_can_tell_stops_the_mission_and_says_so() -> None:
    then = advance(begun().mission, eye("locked red-room", holds=None)).mission
    assert then.ended is not None
    assert then.ended.outcome == "stopped"
    assert then.ended.reason == "nothing could tell whether locked red-room"


def test_what_no_service_can_tell_is_assumed() -> None:
    first = begun(senses=[])
    assert any(isinstance(event, ActionStarted) for event in first.events)


def test_a_stale_fact_is_looked_at_again_before_it_is_relied_on() -> None:
    known = advance(begun().mission, eye("locked red-room", holds=False)).mission
    failed = ActionNotDone("m/1", "a wheel is stuck", known.world)
    assert isinstance(advance(known, failed).events[-1], ActionStarted)
    stale = advance(known, failed, frozenset({"locked red-room"}))
    assert stale.commands == (Sense("m/look-2", ("locked red-room",)),)
    assert isinstance(
        advance(stale.mission, eye("locked red-room", holds=False)).events[-1], ActionStarted
    )


@pytest.mark.parametrize("asked", [PauseAsked("ada"), CancelAsked("ada")])
def test_a_look_never_keeps_a_mission_from_being_paused_or_cancelled(asked: PauseAsked) -> None:
    then = advance(begun().mission, asked)
    assert then.mission.is_at_rest
    assert not any(isinstance(command, Sense) for command in then.commands)


def test_the_same_look_is_asked_for_again_after_a_restart() -> None:
    first = begun()
    kept = Kept()
    kept.record(0, first.events)
    again = advance(mission_from(kept.entries), TakeUpAsked("another worker"))
    assert again.commands == (Look(),)
    seen = advance(again.mission, Sensed("robot", again.mission.world))
    assert seen.commands == first.commands


def test_a_person_may_have_a_fact_looked_at_while_the_mission_is_paused() -> None:
    paused = advance(begun().mission, PauseAsked("ada")).mission
    asked = advance(paused, LookAsked("bob", frozenset({"full ramp", "at rob hall"})))
    assert asked.commands == (Sense("m/look-1", ("full ramp",)),)  # nothing tells where rob is
    assert not asked.mission.is_at_rest
    told = advance(asked.mission, eye("full ramp", holds=True)).mission
    assert told.is_at_rest
    assert "full ramp" in told.state


def test_a_report_settles_what_was_unknown() -> None:
    told = Told("ada", "it's open", deleted=frozenset({"locked red-room"}))
    then = advance(begun().mission, told).mission
    assert "locked red-room" not in then.lookout.unknown
    assert then.in_flight is not None


def test_one_of_a_group_that_is_found_settles_the_others() -> None:
    rules = [Rule("in {x} {p}", ("eye",), needed=True)]
    first = begun(senses=rules).mission
    assert first.lookout.unknown >= {"in parcel red-room", "in parcel blue-room"}
    asked = advance(first, LookAsked("ada", frozenset({"in parcel red-room"}))).mission
    then = advance(asked, eye("in parcel red-room", holds=False)).mission
    assert "in parcel blue-room" in then.state
    assert not then.lookout.unknown & {"in parcel red-room", "in parcel blue-room"}


def test_a_request_for_a_look_is_kept_as_a_message() -> None:
    asked = LookAsked("ada", frozenset({"full ramp"}))
    assert from_message(to_message(asked)) == asked


def test_wishes_decide_what_is_hidden() -> None:
    wish = (Steering("locked red-room"), Steering("in parcel red-room", wanted=False))
    for seed in range(5):
        world = veiled(seed, wish)[1].state()
        assert "locked red-room" in world
        assert "in parcel blue-room" in world
