"""The whole story on the vineyard: every pattern of the paper is planned, run and satisfied."""

from collections.abc import Generator, Sequence
from functools import cache

import pytest
from tests.language.recordings import heard, pcm16, tone, wav

from plainspoken.knowledge.facts import facts_after
from plainspoken.language.recording import UnreadableRecordingError
from plainspoken.language.transcription import Samples, SilentAudio, Transcript
from plainspoken.logic.formula import atoms
from plainspoken.logic.syntax import parse
from plainspoken.logic.trace import holds
from plainspoken.mission.mission import Mission
from plainspoken.mission.run import Record
from plainspoken.mission.simulator import Simulator
from plainspoken.pipeline import (
    Request,
    Site,
    bundled,
    carry_out,
    find_policy,
    go_on,
    open_site,
    site_of,
    transcribe_upload,
    understand,
)
from plainspoken.planning.solver import Solved, Unsolvable
from plainspoken.world.event import Entry, Event, Instant, MissionAccepted, MissionEnded
from plainspoken.world.symbol import resolve_all

MISSIONS = {
    "visit": "Visit lines 1 and 3",
    "sequenced visit": "Go to line 1, then line 2",
    "ordered visit": "Visit line 3, but not before line 2",
    "strict ordered visit": "F(robot_at_rob_l1 & F robot_at_rob_l2) & (!robot_at_rob_l2 U "
    "robot_at_rob_l1) & (!robot_at_rob_l1 U (robot_at_rob_l1 U (!robot_at_rob_l1 U "
    "robot_at_rob_l2)))",
    "global avoidance": "Clear line 2 and never visit line 1",
    "past avoidance": "Clear line 2, and do not enter line 3 until line 2 is cleared",
    "future avoidance": "Visit line 1, and once you have visited line 1, never visit line 0 again",
    "wait": "Stay in line 0 until the support robot is at line 0",
    "delayed reaction": "Clear line 2, and whenever the box is full, empty the box",
    "prompt reaction": "Clear line 2, and as soon as the box is full, call the support robot",
    "bound delay": "Clear line 1, and call the support robot right after harvesting a grape "
    "and at no other time",
    "two clauses": "Clear line 2, but never enter line 3 while the bin is full, "
    "and call the support robot as soon as it is.",
}


@cache
def vineyard() -> Site:
    folder = bundled("vineyard")
    return open_site(folder / "domain.pddl", folder / "problem.pddl", folder / "landmarks.json")


def recording(entries: list[Entry]) -> Record:
    def record(instant: Instant, events: Sequence[Event]) -> Sequence[Entry]:
        new = [
            Entry(len(entries) + i, "2026-01-01T00:00:00Z", instant, event)
            for i, event in enumerate(events)
        ]
        entries.extend(new)
        return new

    return record


def played(events: Generator[Entry, None, Mission]) -> Mission:
    while True:
        try:
            next(events)
        except StopIteration as end:
            mission: Mission = end.value
            return mission


@pytest.mark.parametrize("pattern", MISSIONS)
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_every_pattern_is_understood_planned_run_and_satisfied(pattern: str, seed: int) -> None:
    site = vineyard()
    said = MISSIONS[pattern]
    goal = parse(said) if "(" in said else understand(said, site).formula
    assert goal is not None, understand(said, site)
    ending = find_policy(site.problem, goal)
    assert isinstance(ending, Solved)
    entries: list[Entry] = []
    simulator = Simulator(site.problem, seed=seed)
    request = Request("m", goal, said)
    mission = played(carry_out(site, request, ending.policy, simulator, recording(entries)))
    assert mission.satisfied
    assert entries[-1].event == MissionEnded("finished", satisfied=True)
    letters = facts_after(entries).letters(resolve_all(atoms(goal), site.problem))
    assert holds(goal, letters)


@pytest.mark.parametrize(
    ("goal", "named"),
    [
        ("robot_at_rob_l1 U cleared_l2", "robot_at_rob_l1"),
        ("F cleared_l2 & G !robot_at_rob_l2", "l2"),
    ],
)
def test_an_impossible_mission_is_refused_with_what_is_in_the_way(goal: str, named: str) -> None:
    ending = find_policy(vineyard().problem, parse(goal))
    assert isinstance(ending, Unsolvable)
    assert named in ending.reason.said()


def test_a_mission_goes_on_from_its_log_alone() -> None:
    site = vineyard()
    goal = parse("F cleared_l2 & F robot_at_rob_wh")
    ending = find_policy(site.problem, goal)
    assert isinstance(ending, Solved)
    entries: list[Entry] = []
    simulator = Simulator(site.problem, seed=5)
    events = carry_out(site, Request("m", goal), ending.policy, simulator, recording(entries))
    for _ in range(6):
        next(events)
    events.close()
    accepted = entries[0].event
    assert isinstance(accepted, MissionAccepted)
    rebuilt = site_of(accepted)
    again = go_on(rebuilt, tuple(entries), simulator, recording(entries), by="test")
    assert played(again).satisfied


def test_landmarks_are_derived_where_no_file_gives_them() -> None:
    folder = bundled("vineyard")
    site = open_site(folder / "domain.pddl", folder / "problem.pddl")
    assert {"robot_at_rob_l2", "full_b", "harvest_grape_executed"} <= set(site.landmarks)


def test_a_recording_that_somebody_sends_is_heard_with_the_words_of_the_site() -> None:
    told: list[tuple[str, ...]] = []

    def hears(_: Samples, hints: Sequence[str], /) -> Transcript:
        told.append(tuple(hints))
        return heard("Never enter line 3.")

    sent = wav(pcm16(tone(440, 1)))
    found = transcribe_upload(sent, "audio/wav", vineyard(), hears)
    assert found.text == "Never enter line 3."
    assert {"warehouse", "grape 0"} <= set(told[0])
    with pytest.raises(UnreadableRecordingError, match="audio/webm"):
        transcribe_upload(sent, "audio/webm", vineyard(), hears)
    with pytest.raises(SilentAudio):
        transcribe_upload(wav(bytes(32_000)), "audio/wav", vineyard(), hears)
