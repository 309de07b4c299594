"""A short run, written out by hand: a door that opens, a report, and a lamp that fails."""

from plainspoken.world.event import (
    ActionFailed,
    ActionFinished,
    ActionStarted,
    Entry,
    Event,
    MissionAccepted,
    MissionEnded,
    ObservationMade,
    PolicyChosen,
    ReportReceived,
)

ACCEPTED = MissionAccepted(
    mission="m1",
    sentence="più luce, per favore",
    goal="F lit_lamp",
    english="the lamp is lit at some time",
    domain="(define (domain d))",
    problem="(define (problem p))",
    landmarks={"lit_lamp": {"description": "the lamp is lit", "type": "condition"}},
    static=("part-of lamp room",),
    state=frozenset({"shut door"}),
    robot={"name": "simulator", "seed": 7},
)
POLICY = PolicyChosen(policy={"status": "solved", "nodes": []})
STEPS: tuple[tuple[int, Event], ...] = (
    (0, ACCEPTED),
    (0, POLICY),
    (0, ActionStarted("open door", 0, "m1/1")),
    (1, ActionFinished("open door", "m1/1", frozenset({"open door"}), 1)),
    (1, ObservationMade("camera", (), (), frozenset({"open door"}))),
    (2, ReportReceived("ada", "I lit it", ("lit lamp",), (), frozenset({"open door", "lit lamp"}))),
    (2, ActionStarted("light lamp", 1, "m1/2")),
    (3, ActionFailed("light lamp", "m1/2", "no oil", frozenset({"open door"}))),
    (3, MissionEnded("stopped", False, "no oil")),
)
ENTRIES = tuple(
    Entry(step, f"2026-11-22T10:00:{step:02d}Z", instant, event)
    for step, (instant, event) in enumerate(STEPS)
)
