"""A mission inside an action: planned for itself, carried out by its own robot, told of."""

from __future__ import annotations

import time
from pathlib import Path

import pytest
from click.testing import CliRunner
from tests.backends.activities.errands import (
    ARRIVED,
    DOMAIN_TEXT,
    GRASP,
    PROBLEM,
    PROBLEM_TEXT,
    VIA,
    robot_of,
)
from tests.backends.activities.scripted import SCRIPTS, named
from tests.mission.conformance import ended

from plainspoken.cli import plainspoken
from plainspoken.errors import InputFileError, PlainspokenError
from plainspoken.knowledge.log import SqliteLog
from plainspoken.mission.mission import mission_from
from plainspoken.mission.robot import Failed, GoalStatus, Succeeded, UnderWay
from plainspoken.mission.service import Done, NotDone
from plainspoken.world.event import TakenUp

GO = "go hall kitchen"
INNER = """\
(define (domain walking) (:requirements :strips)
  (:predicates (standing) (walking) (there))
  (:action rise :precondition (not (standing)) :effect (standing))
  (:action walk :precondition (standing) :effect (there)))
"""
INNER_PROBLEM = "(define (problem w) (:domain walking) (:objects) (:init) (:goal (there)))"
OUTER_FILE = f"""\
services:
  walk:
    {{
      via: mission, domain: inner.pddl, problem: walk.pddl, goal: "F there", robots: inner.yaml
    }}
  arm: {{{VIA}, script: arm}}
actions:
  go: {{do: {{call: walk, as: "walking to {{to}}"}}}}
{GRASP}"""
INNER_FILE = f"""\
services:
  legs: {{{VIA}, script: legs}}
actions:
  rise: {{do: {{call: legs}}}}
  walk: {{do: {{call: legs}}}}
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "inner.pddl").write_text(INNER)
    (tmp_path / "walk.pddl").write_text(INNER_PROBLEM)
    (tmp_path / "inner.yaml").write_text(INNER_FILE)
    return tmp_path


def test_its_end_is_the_actions_end_and_its_log_is_in_the_store(folder: Path) -> None:
    with robot_of(OUTER_FILE, folder) as robot:
        robot.send("m/1", GO)
        assert ended(robot, "m/1") == Succeeded(ARRIVED)
    assert named() == ["legs", "legs"]
    with SqliteLog(folder / "store.sqlite") as log:
        (inner,) = log.missions()
        assert inner == "m/1:0#1"
        assert mission_from(log.entries(inner)).satisfied
        assert log.verify(inner) is None


def test_what_it_is_doing_is_what_the_action_is_doing(folder: Path) -> None:
    SCRIPTS["legs"] = [5, Done({}), 5, Done({})]
    told = set()
    with robot_of(OUTER_FILE, folder) as robot:
        robot.send("m/1", GO)
        status: GoalStatus = UnderWay()
        while isinstance(status, UnderWay):
            told.add(status.doing)
            status = robot.wait("m/1", 0.01)
    # Planning is over too soon to be seen each time; walking takes its time.
    assert any("legs" in each or "rising" in each for each in told if each), told


def test_a_mission_that_stops_fails_the_action_with_its_reason(folder: Path) -> None:
    SCRIPTS["legs"] = [NotDone("a cramp")] * 9
    with robot_of(OUTER_FILE, folder) as robot:
        robot.send("m/1", GO)
        status = ended(robot, "m/1")
    assert isinstance(status, Failed)
    assert "failed 4 times in a row" in status.reason
    assert status.state == PROBLEM.initial


def test_a_goal_that_cannot_be_planned_for_says_why(folder: Path) -> None:
    with robot_of(OUTER_FILE.replace("F there", "F (there & walking)"), folder) as robot:
        robot.send("m/1", GO)
        status = ended(robot, "m/1")
    assert isinstance(status, Failed)
    assert "walking" in status.reason


def test_cancelling_the_action_cancels_the_mission(folder: Path) -> None:
    SCRIPTS["legs"] = [999, Done({})]
    with robot_of(OUTER_FILE, folder) as robot:
        robot.send("m/1", GO)
        while not named():
            robot.wait("m/1", 0.01)
        robot.cancel("m/1")
        assert ended(robot, "m/1") == Failed("cancelled", PROBLEM.initial)
    with SqliteLog(folder / "store.sqlite") as log:
        assert mission_from(log.entries("m/1:0#1")).status == "cancelled"


def test_a_program_that_takes_over_goes_on_with_it(folder: Path) -> None:
    SCRIPTS["legs"] = [Done({}), 30, Done({})]
    with robot_of(OUTER_FILE, folder) as robot:
        robot.send("m/1", GO)
        until = time.monotonic() + 10
        while len(named()) < 2 and time.monotonic() < until:
            robot.wait("m/1", 0.01)
    with robot_of(OUTER_FILE, folder) as again:
        assert ended(again, "m/1") == Succeeded(ARRIVED)
    assert named() == ["legs", "legs"], "what was done before is not done again"


def test_it_is_not_gone_on_with_apart_from_the_mission_it_is_part_of(folder: Path) -> None:
    SCRIPTS["legs"] = [999, Done({})]
    with robot_of(OUTER_FILE, folder) as robot:
        robot.send("m/1", GO)
        while not named():
            robot.wait("m/1", 0.01)
    store = str(folder / "store.sqlite")
    done = CliRunner().invoke(plainspoken, ["missions", "resume", "m/1:0#1", "--store", store])
    assert isinstance(done.exception, PlainspokenError)
    assert done.exception.hint == "plainspoken missions resume m"


@pytest.mark.parametrize("asked", ["pause", "cancel"])
def test_nothing_is_asked_of_it_apart_from_the_mission_it_is_part_of(
    folder: Path, asked: str
) -> None:
    SCRIPTS["legs"] = [999, Done({})]
    with robot_of(OUTER_FILE, folder) as robot:
        robot.send("m/1", GO)
        while not named():
            robot.wait("m/1", 0.01)
    store = str(folder / "store.sqlite")
    done = CliRunner().invoke(plainspoken, ["missions", asked, "m/1:0#1", "--store", store])
    assert isinstance(done.exception, PlainspokenError)
    assert done.exception.hint == f"plainspoken missions {asked} m"
    shown = CliRunner().invoke(plainspoken, ["missions", "--store", store])
    assert "an action of m" in shown.output


def test_it_stops_where_another_process_goes_on_with_it(folder: Path) -> None:
    SCRIPTS["legs"] = [5, Done({})]
    with robot_of(OUTER_FILE, folder) as robot, SqliteLog(folder / "store.sqlite") as log:
        robot.send("m/1", GO)
        while not log.entries("m/1:0#1"):
            time.sleep(0.001)
        log.append("m/1:0#1", "t", 0, [TakenUp("another")])
        status = ended(robot, "m/1")
        assert isinstance(status, Failed)
        assert "goes on" in status.reason or "carries" in status.reason, status.reason
        assert [each.kind for each in log.entries("m/1:0#1")][-1] == "taken_up"


def test_it_may_be_simulated_and_begin_where_the_action_says(folder: Path) -> None:
    (folder / "errands.pddl").write_text(DOMAIN_TEXT)
    (folder / "home.pddl").write_text(PROBLEM_TEXT)
    text = OUTER_FILE.replace(
        'domain: inner.pddl, problem: walk.pddl, goal: "F there", robots: inner.yaml',
        'domain: errands.pddl, problem: home.pddl, goal: "F at_{to}", robots: simulator,'
        ' start: ["not at {from}", "at {to}"]',
    ).replace("{call: walk, as", '{call: walk, with: {to: "{to}", from: "{from}"}, as')
    with robot_of(text, folder) as robot:
        robot.send("m/1", GO)
        assert ended(robot, "m/1") == Succeeded(ARRIVED)
    with SqliteLog(folder / "store.sqlite") as log:
        assert "action_started" not in [entry.kind for entry in log.entries("m/1:0#1")]


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("robots: inner.yaml", "robots: robots.yaml"), "inside itself"),
        (('goal: "F there", ', ""), "'goal' is missing"),
        (("F there", "F at_{to}"), "goal needs the fields to"),
        (("robots: inner.yaml", "robots: none.yaml"), "cannot read the file"),
        (("problem: walk.pddl", "problem: none.pddl"), "cannot read the file"),
    ],
)
def test_a_mission_that_cannot_be_is_refused_before_anything_moves(
    change: tuple[str, str], said: str, folder: Path
) -> None:
    with pytest.raises(InputFileError, match=said), robot_of(OUTER_FILE.replace(*change), folder):
        pass
