"""Every kind of event goes to JSON and comes back."""

import json
from dataclasses import fields
from typing import get_args

import pytest

from plainspoken.world.event import (
    KINDS,
    ActionFailed,
    ActionFinished,
    ActionOverdue,
    ActionProgressed,
    ActionResent,
    ActionStarted,
    Cancelled,
    ChangeRefused,
    ChangeRequested,
    DeviationNoticed,
    Entry,
    Event,
    LookRequested,
    MissionAccepted,
    MissionEnded,
    ObservationMade,
    Paused,
    PolicyChosen,
    ReportReceived,
    RequestChanged,
    Resumed,
    RobotFound,
    RobotLost,
    TakenUp,
    VerdictReached,
    entry_from_json,
)

STATE = frozenset({"robot-at rob l1", "full b", "adjacent l0 l1"})
EVENTS: tuple[Event, ...] = (
    MissionAccepted(
        "m1",
        "clear line 1",
        "F cleared_l1",
        "eventually line 1 is cleared",
        "(define (domain d))",
        "(define (problem p))",
        {"full_b": {"description": "the box is full", "type": "condition", "names": ["voll"]}},
        ("adjacent l0 l1",),
        STATE,
        {"name": "simulator", "seed": 7, "steering": [1, 2]},
    ),
    MissionAccepted("m1", None, "F a", "eventually a", "", "", {}, (), frozenset()),
    PolicyChosen({"status": "solved", "nodes": [{"id": 0, "successors": [1]}]}),
    PolicyChosen({}, "the support robot was away"),
    ActionStarted("move rob l0 l1", 3, "m1-3"),
    ActionFinished("move rob l0 l1", "m1-3", STATE, 4),
    ActionFinished("move rob l0 l1", "m1-3", STATE, None, ("full b",)),
    ActionFailed("move rob l0 l1", "m1-3", "a wheel is stuck", STATE),
    ObservationMade("camera", ("ripe g0",), (), STATE),
    ObservationMade("eye", (), (), STATE, ({"atom": "full b", "holds": None, "by": "eye"},)),
    LookRequested("Ada", ("full b", "ripe g0")),
    ReportReceived("Ada", "I emptied the box", (), ("full b",), STATE),
    DeviationNoticed("move rob l0 l1", "it is at line 2", covered=True, node=2),
    DeviationNoticed(None, "the box is empty", covered=False),
    VerdictReached("violated", "G !full_b"),
    VerdictReached("satisfied"),
    Paused("Ada"),
    Resumed("restart"),
    TakenUp("worker 2"),
    Cancelled("Ada"),
    ActionProgressed("m1-3", 0.5, "closing the gripper"),
    ActionResent("move rob l0 l1", "m1-3"),
    ActionOverdue("move rob l0 l1", "m1-3", 61.5),
    RobotLost("no answer"),
    RobotFound(),
    ChangeRequested("Ada", "skip line 3", ({"since": 0, "goal": "F cleared_l1"},), "Clear line 1."),
    RequestChanged("Ada", "skip line 3", ({"since": 0, "goal": "F cleared_l1"},), "Clear line 1."),
    ChangeRefused("Ada", "skip line 3", "it is done already"),
    MissionEnded("finished", satisfied=True),
    MissionEnded("stopped", satisfied=False, reason="no policy is left"),
)


def through_json(entry: Entry) -> Entry:
    return entry_from_json(json.loads(json.dumps(entry.to_json())))


def test_every_kind_of_event_has_an_example_here_and_a_name() -> None:
    assert {type(event) for event in EVENTS} == set(KINDS.values()) == set(get_args(Event))
    assert all(KINDS[event.kind] is type(event) for event in EVENTS)
    assert len(KINDS) == len(get_args(Event))


@pytest.mark.parametrize("event", EVENTS, ids=lambda event: f"{event.kind}{EVENTS.index(event)}")
def test_an_entry_goes_to_json_and_comes_back(event: Event) -> None:
    entry = Entry(5, "2026-03-01T12:00:00+00:00", 2, event)
    assert through_json(entry) == entry


@pytest.mark.parametrize("event", EVENTS, ids=lambda event: f"{event.kind}{EVENTS.index(event)}")
def test_an_entry_is_one_flat_object_that_begins_with_its_place(event: Event) -> None:
    document = Entry(5, "2026-03-01T12:00:00+00:00", 2, event).to_json()
    assert list(document)[:4] == ["step", "time", "kind", "instant"]
    assert set(document) == {"step", "time", "kind", "instant", *(f.name for f in fields(event))}
    assert "\n" not in json.dumps(document)


def test_a_state_is_written_in_sorted_order() -> None:
    document = Entry(0, "t", 0, ActionFinished("a", "g", STATE, None)).to_json()
    assert document["state"] == ["adjacent l0 l1", "full b", "robot-at rob l1"]


def test_fields_that_a_later_version_wrote_are_read_over() -> None:
    document = {**Entry(0, "t", 0, Paused("Ada")).to_json(), "mood": "calm"}
    assert entry_from_json(document) == Entry(0, "t", 0, Paused("Ada"))


def test_a_field_that_an_earlier_version_did_not_write_has_its_default() -> None:
    document = Entry(0, "t", 0, MissionEnded("finished", satisfied=True)).to_json()
    del document["reason"]
    assert entry_from_json(document).event == MissionEnded("finished", satisfied=True)


@pytest.mark.parametrize("missing", ["step", "time", "instant", "kind", "by"])
def test_a_document_without_a_field_it_needs_is_no_entry(missing: str) -> None:
    document = Entry(0, "t", 0, Paused("Ada")).to_json()
    del document[missing]
    with pytest.raises(KeyError, match=missing):
        entry_from_json(document)


@pytest.mark.parametrize(
    "change", [{"kind": "sang"}, {"kind": ["paused"]}, {"state": None}, {"state": "full b"}]
)
def test_a_document_of_no_known_kind_or_with_no_state_is_no_entry(
    change: dict[str, object],
) -> None:
    document = Entry(0, "t", 0, ActionFinished("a", "g", STATE, None)).to_json() | change
    with pytest.raises((KeyError, TypeError)):
        entry_from_json(document)
