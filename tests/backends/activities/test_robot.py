"""Activities carried out: what is called, when, what is told of it, and what comes of it."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

import pytest
from tests.backends.activities import scripted
from tests.backends.activities.errands import ARRIVED, GO, PROBLEM, file_of, robot_of
from tests.backends.activities.scripted import AWAY, CALLED, CANCELLED, SCRIPTS, named
from tests.mission.conformance import ended

from plainspoken.backends.activities import tree
from plainspoken.backends.activities.robot import ActivityRobot
from plainspoken.mission.robot import Failed, GoalStatus, Succeeded, UnderWay, Unreachable
from plainspoken.mission.service import Done, NotDone

TWO_STEPS = """\
sequence:
  - {call: look, as: "looking around"}
  - {call: drive, with: {to: "{to}"}, as: "driving to {to}"}
"""


def sent_and_ended(robot: ActivityRobot) -> GoalStatus:
    robot.send("m/1", GO)
    return ended(robot, "m/1")


def outcome(text: str, folder: Path, action: str = GO) -> GoalStatus:
    """What an action comes to on a robot that was just set up."""
    with robot_of(text, folder) as robot:
        robot.send("m/1", action)
        return ended(robot, "m/1")


def test_a_call_has_its_fields_filled_and_its_end_is_the_actions(tmp_path: Path) -> None:
    text = file_of('{call: drive, with: {to: "{to}", note: "{action} as {goal}"}}')
    assert outcome(text, tmp_path) == Succeeded(ARRIVED)
    assert CALLED == [("drive", {"to": "kitchen", "note": "go hall kitchen as m/1"})]


def test_what_is_known_of_an_object_can_be_filled_in(tmp_path: Path) -> None:
    objects = "objects: {hall: {x: 0}, kitchen: {x: 4.5}}\n"
    outcome(file_of('{call: drive, with: {x: "{to.x}"}}', more=objects), tmp_path)
    assert CALLED == [("drive", {"x": 4.5})]


def test_a_sequence_stops_at_the_first_failure_and_repeats_its_reason(tmp_path: Path) -> None:
    SCRIPTS["look"] = [NotDone("the lens is dirty")]
    assert outcome(file_of(TWO_STEPS), tmp_path) == Failed("the lens is dirty", PROBLEM.initial)
    assert named() == ["look"]


def test_a_selection_goes_on_to_the_next_way_after_a_failure(tmp_path: Path) -> None:
    SCRIPTS["arm"] = [NotDone("out of reach")]
    text = file_of("selection: [{call: arm}, {call: drive}, {call: look}]")
    assert outcome(text, tmp_path) == Succeeded(ARRIVED)
    assert named() == ["arm", "drive"]


def test_parallel_calls_are_under_way_at_once_and_all_have_to_end(tmp_path: Path) -> None:
    SCRIPTS.update(arm=[3, Done({})], drive=[1, Done({})])
    with robot_of(file_of("parallel: [{call: arm}, {call: drive}]"), tmp_path) as robot:
        robot.send("m/1", GO)
        assert named() == ["arm", "drive"]
        assert robot.wait("m/1", 0.0) == UnderWay(2 / 3, "arm 1")
        assert ended(robot, "m/1") == Succeeded(ARRIVED)


def test_where_one_is_enough_the_others_are_given_up(tmp_path: Path) -> None:
    SCRIPTS.update(arm=[99, Done({})], drive=[1, Done({})])
    text = file_of("parallel: [{call: arm}, {call: drive}]\nneeds: one")
    assert outcome(text, tmp_path) == Succeeded(ARRIVED)
    assert CANCELLED == ["arm"]


def test_a_retry_tries_again_and_says_for_the_how_manieth_time(tmp_path: Path) -> None:
    SCRIPTS["drive"] = [NotDone("blocked"), NotDone("blocked"), 2, Done({})]
    text = file_of("retry: {call: drive, as: driving}\ntimes: 3\npause: 0.01")
    with robot_of(text, tmp_path) as robot:
        robot.send("m/1", GO)
        told: list[str | None] = []
        status: GoalStatus = UnderWay()
        while isinstance(status, UnderWay):
            status = robot.wait("m/1", 0.0)
            if isinstance(status, UnderWay):
                told.append(status.doing)
        assert status == Succeeded(ARRIVED)
    assert named() == ["drive"] * 3
    assert "try 3 of 3: driving: drive 1" in told


def test_a_retry_fails_after_its_last_try_with_the_last_reason(tmp_path: Path) -> None:
    SCRIPTS["drive"] = [NotDone("blocked"), NotDone("blocked for good")]
    text = file_of("retry: {call: drive}\ntimes: 2\npause: 0.01")
    assert outcome(text, tmp_path) == Failed("blocked for good", PROBLEM.initial)


def test_pauses_between_tries_are_kept(tmp_path: Path) -> None:
    now = 0.0
    SCRIPTS["drive"] = [NotDone("blocked"), NotDone("blocked"), Done({})]
    text = file_of("retry: {call: drive}\ntimes: 3\npause: 2\ngrowth: 3")
    with robot_of(text, tmp_path) as robot:
        robot._clock = lambda: now
        times = []
        robot.send("m/1", GO)
        while isinstance(robot.wait("m/1", 0.0), UnderWay):
            times.append(len(CALLED))
            now += 1.0
        assert times == [1, 1, 2, 2, 2, 2, 2, 2]


def test_what_takes_too_long_is_given_up_before_anything_else_begins(tmp_path: Path) -> None:
    SCRIPTS["arm"] = [99, Done({})]
    text = file_of("selection:\n  - {call: arm, limit: 0.05}\n  - {call: drive}")
    assert outcome(text, tmp_path) == Succeeded(ARRIVED)
    assert (named(), CANCELLED) == (["arm", "drive"], ["arm"])


def test_a_limit_says_how_long_it_was(tmp_path: Path) -> None:
    SCRIPTS["arm"] = [99, Done({})]
    assert outcome(file_of("{call: arm, limit: 0.05}"), tmp_path) == Failed(
        "took longer than 0.05 s", PROBLEM.initial
    )


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        ('["at {from}", "not held mug"]', Succeeded(ARRIVED)),
        ('["at {to}", "free"]', Failed("not so: at kitchen", PROBLEM.initial)),
    ],
)
def test_a_condition_is_about_what_is_true_at_that_moment(
    condition: str, expected: GoalStatus, tmp_path: Path
) -> None:
    text = file_of(f"sequence:\n  - if: {condition}\n  - {{call: drive}}")
    assert outcome(text, tmp_path) == expected


def test_a_result_that_is_not_as_it_should_be_is_a_failure_with_the_services_reason(
    tmp_path: Path,
) -> None:
    SCRIPTS["drive"] = [Done({"success": False, "message": "wheel stuck"})]
    text = file_of("{call: drive}").replace(
        "script: drive", 'script: drive, succeeds: {success: true}, reason: "{message}"'
    )
    assert outcome(text, tmp_path) == Failed("wheel stuck", PROBLEM.initial)


@pytest.mark.parametrize(
    ("charge", "expected"),
    [
        (0.5, Succeeded(ARRIVED)),
        (0.1, Failed("drive gave {'charge': 0.1}", PROBLEM.initial)),
    ],
)
def test_a_call_may_ask_more_of_a_result_than_the_service_does(
    charge: float, expected: GoalStatus, tmp_path: Path
) -> None:
    SCRIPTS["drive"] = [Done({"charge": charge})]
    assert outcome(file_of("{call: drive, when: {charge: {'>': 0.2}}}"), tmp_path) == expected


@pytest.mark.parametrize("held", [True, False])
def test_the_result_says_which_outcome_came_about(held: object, tmp_path: Path) -> None:
    SCRIPTS["arm"] = [Done({"held": held})]
    with robot_of(file_of("{call: drive}"), tmp_path, ARRIVED) as robot:
        robot.send("m/1", "grasp mug kitchen")
        status = ended(robot, "m/1")
    assert isinstance(status, Succeeded)
    assert ("held mug" in status.state) is held
    assert ("lies mug kitchen" in status.state) is not held


def test_it_tells_in_words_which_step_goes_on(tmp_path: Path) -> None:
    SCRIPTS.update(look=[1, Done({})], drive=[2, Done({})])
    with robot_of(file_of(TWO_STEPS), tmp_path) as robot:
        robot.send("m/1", GO)
        told = [robot.wait("m/1", 0.0) for _ in range(3)]
    assert told[0] == UnderWay(0.5, "step 2 of 2: driving to kitchen: drive 0")
    assert told[1] == UnderWay(0.75, "step 2 of 2: driving to kitchen: drive 1")
    assert told[2] == Succeeded(ARRIVED)


def test_what_a_service_says_is_told_now_and_then_and_the_next_step_at_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tree, "TOLD_EVERY", 2.0)
    now = 0.0
    SCRIPTS.update(look=[6, Done({})], drive=[2, Done({})])
    with robot_of(file_of(TWO_STEPS), tmp_path) as robot:
        robot._clock = lambda: now
        robot.send("m/1", GO)
        told = []
        for _ in range(6):
            status = robot.wait("m/1", 0.0)
            assert isinstance(status, UnderWay)
            told.append((status.doing or "").rpartition(": ")[2])
            now += 1.0
    assert told == ["look 0", "look 0", "look 3", "look 3", "look 5", "drive 0"]


def test_cancelling_ends_what_is_under_way_and_begins_nothing_more(tmp_path: Path) -> None:
    SCRIPTS["look"] = [99, Done({})]
    with robot_of(file_of(TWO_STEPS), tmp_path) as robot:
        robot.send("m/1", GO)
        robot.cancel("m/1")
        assert ended(robot, "m/1") == Failed("cancelled", PROBLEM.initial)
    assert (named(), CANCELLED) == (["look"], ["look"])


def test_cancelling_in_a_pause_between_tries_ends_it(tmp_path: Path) -> None:
    SCRIPTS["drive"] = [NotDone("blocked")]
    with robot_of(file_of("retry: {call: drive}\ntimes: 3\npause: 60"), tmp_path) as robot:
        robot.send("m/1", GO)
        robot.cancel("m/1")
        assert robot.wait("m/1", 0.0) == Failed("cancelled", PROBLEM.initial)


def test_a_call_that_ends_before_its_cancellation_is_done_all_the_same(tmp_path: Path) -> None:
    SCRIPTS["drive"] = [1, Done({})]
    with robot_of(file_of("{call: drive}"), tmp_path) as robot:
        robot.send("m/1", GO)
        scripted.SERVICES["drive"].ended["m/1:0#1"] = Done({})
        robot.cancel("m/1")
        assert ended(robot, "m/1") == Succeeded(ARRIVED)


class _Killed(Exception):
    """The process dies here."""


@pytest.mark.parametrize("notes", range(1, 8))
def test_a_process_that_dies_at_any_note_in_the_journal_leaves_no_call_made_twice(
    notes: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    SCRIPTS.update(look=[2, Done({})], drive=[2, Done({})])
    with robot_of(file_of(TWO_STEPS), tmp_path) as robot:
        left = iter(range(notes))
        note = robot._journal.note

        def dying(subject: str, key: str, value: object) -> None:
            if next(left, None) is None:
                raise _Killed
            note(subject, key, value)

        monkeypatch.setattr(robot._journal, "note", dying)
        with suppress(_Killed):
            sent_and_ended(robot)
    with robot_of(file_of(TWO_STEPS), tmp_path) as again:
        assert ended(again, "m/1") == Succeeded(ARRIVED)
    assert named() == ["look", "drive"]


def test_a_way_that_was_given_up_before_a_crash_is_not_gone_again(tmp_path: Path) -> None:
    SCRIPTS.update(arm=[99, Done({})], drive=[3, Done({})])
    text = file_of("selection:\n  - {call: arm, limit: 0.05}\n  - {call: drive}")
    with robot_of(text, tmp_path) as robot:
        robot.send("m/1", GO)
        while "drive" not in named():
            robot.wait("m/1", 0.01)
    with robot_of(text, tmp_path) as again:
        assert ended(again, "m/1") == Succeeded(ARRIVED)
    assert (named(), CANCELLED) == (["arm", "drive"], ["arm"])


def test_an_action_that_the_file_says_otherwise_now_is_not_gone_on_with(tmp_path: Path) -> None:
    SCRIPTS["drive"] = [9, Done({})]
    with robot_of(file_of("{call: drive}"), tmp_path) as robot:
        robot.send("m/1", GO)
    with robot_of(file_of("{call: arm}"), tmp_path) as again:
        status = again.wait("m/1", 0.0)
    assert isinstance(status, Failed)
    assert "something else of go" in status.reason
    assert named() == ["drive"]


def test_a_service_that_forgot_what_it_had_begun_is_not_called_again(tmp_path: Path) -> None:
    SCRIPTS["drive"] = [9, Done({})]
    with robot_of(file_of("{call: drive}"), tmp_path) as robot:
        robot.send("m/1", GO)
        robot.wait("m/1", 0.0)
        scripted.SERVICES["drive"].calls.clear()
        assert ended(robot, "m/1") == Failed("drive has forgotten the call", PROBLEM.initial)
    assert named() == ["drive"]


def test_a_service_that_cannot_be_reached_is_called_once_it_can(tmp_path: Path) -> None:
    AWAY.add("drive")
    with robot_of(file_of(TWO_STEPS), tmp_path) as robot:
        with pytest.raises(Unreachable, match="drive"):
            sent_and_ended(robot)
        with pytest.raises(Unreachable, match="drive"):
            robot.state()
        AWAY.clear()
        assert robot.state() == PROBLEM.initial
        assert ended(robot, "m/1") == Succeeded(ARRIVED)
    assert named() == ["look", "drive"]


SENSED = """\
facts:
  "at {p}": {call: look, with: {what: place}, when: {place: "{p}"}}
"""


def seeing(robot: ActivityRobot, place: str) -> frozenset[str]:
    SCRIPTS["look"] = [Done({"place": place})]
    return robot.state()


def test_what_is_sensed_counts_for_more_than_what_was_believed(tmp_path: Path) -> None:
    with robot_of(file_of("{call: drive}", more=SENSED), tmp_path) as robot:
        assert seeing(robot, "kitchen") == ARRIVED
        assert seeing(robot, "hall") == PROBLEM.initial
        assert seeing(robot, "nowhere") == PROBLEM.initial - {"at hall"}
    assert CALLED == [("look", {"what": "place"})] * 3, "one question answers for every place"


def test_eyes_that_do_not_answer_are_a_lost_connection_and_no_guess(tmp_path: Path) -> None:
    with robot_of(file_of("{call: drive}", more=SENSED), tmp_path) as robot:
        SCRIPTS["look"] = [NotDone("no picture")]
        with pytest.raises(Unreachable, match="no picture"):
            robot.state()
        AWAY.add("look")
        with pytest.raises(Unreachable, match="look"):
            robot.state()


def test_a_service_may_tell_all_that_is_true(tmp_path: Path) -> None:
    more = "state: {call: look, atoms: atoms}\n"
    with robot_of(file_of("{call: drive}", more=more), tmp_path) as robot:
        SCRIPTS["look"] = [Done({"atoms": ["at kitchen", "held mug"]})]
        assert robot.state() == {"at kitchen", "held mug", "road hall kitchen", "road kitchen hall"}


def test_what_people_report_is_believed_until_something_else_is_seen(tmp_path: Path) -> None:
    with robot_of(file_of("{call: drive}"), tmp_path) as robot:
        robot.believe(added=["held mug"], deleted=["free"])
        assert robot.state() == (PROBLEM.initial | {"held mug"}) - {"free"}
