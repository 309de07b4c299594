"""Robots over ROS 2, against real servers in another process: `make ros2` runs this."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from uuid import uuid4

import pytest
from tests.backends.activities.errands import ARRIVED, GO, PROBLEM, robot_of
from tests.mission import small_vineyard
from tests.mission.conformance import RobotConformance, ended
from tests.mission.small_vineyard import accepted, policy_for, replanned
from tests.stores import store_in

from plainspoken.backends.activities.configuration import robot_from
from plainspoken.backends.activities.robot import ActivityRobot
from plainspoken.backends.ros2_message import fields_of, message_of, objection
from plainspoken.errors import InputFileError
from plainspoken.logic.syntax import parse
from plainspoken.mission.executive import accept
from plainspoken.mission.mission import Mission, Status
from plainspoken.mission.observation import CancelAsked, Observation
from plainspoken.mission.robot import Failed, GoalStatus, Robot, Succeeded, UnderWay, Unreachable
from plainspoken.mission.run import Patience, run_mission
from plainspoken.world.domain import State
from plainspoken.world.event import (
    ActionFailed,
    ActionFinished,
    ActionProgressed,
    Entry,
    Event,
)

pytestmark = [
    pytest.mark.skipif(
        find_spec("rclpy") is None, reason="needs ROS 2: `make ros2` installs it and runs this"
    ),
    pytest.mark.filterwarnings("ignore:module 'sre_:DeprecationWarning"),  # by ROS's lark
]
SERVER = Path(__file__).parent / "ros2_server.py"
HEAD = """\
ros2: {namespace: "NAMESPACE", silence: 1, discovery: 30}
services:
  drive:
    {via: ros2, action: drive, type: test_msgs/action/Fibonacci, doing: "step {sequence.-1}"}
  look: {via: ros2, service: look, type: std_srvs/srv/Trigger, succeeds: {success: true}}
  grip:
    via: ros2
    service: grip
    type: std_srvs/srv/SetBool
    timeout: 2
    succeeds: {success: true}
    reason: "{message}"
"""
VINEYARD = (
    HEAD
    + """\
objects: {l0: {order: 8}, wh: {order: -1}}
actions:
  move: {do: {call: drive, with: {order: "{to.order}"}, as: "driving to {to}"}}
  check-grape:
    do: {sequence: [{call: drive, with: {order: 1}}, {call: look}]}
    outcomes:
      - {when: {message: ripe}, facts: ["ripe {g}"]}
      - {when: {message: unripe}, facts: ["unripe {g}"]}
  ask-human: {do: {if: ["ripe {g}"]}, outcomes: [{when: {}, facts: ["ripe {g}"]}]}
  harvest-grape: {do: {call: grip, with: {data: true}}}
  drop-grape:
    do: {selection: [{call: grip, with: {data: false}}, {call: drive, with: {order: 1}}]}
    outcomes: [{when: {}, facts: ["not full {b}"]}]
  call-support: {do: {call: look}, outcomes: [{when: {}, facts: ["robot-at {s} {to}"]}]}
  empty-box: {do: {call: look}}
  sign-off: {do: {call: look}}
"""
)
ERRANDS = (
    HEAD
    + """\
actions:
  go: {do: GO}
  grasp: {do: {call: look}, outcomes: [{when: {}, facts: ["held {t}"]}]}
"""
)


class Ros2Bench:
    """Servers in a process of their own; stopped, they answer nobody."""

    problem = small_vineyard.PROBLEM
    action = "move rob wh l0"
    rejected = "move rob l0 wh"

    def __init__(self, folder: Path, stack: ExitStack) -> None:
        self.folder, self._stack = folder, stack
        self.namespace = f"/test_{uuid4().hex[:8]}"
        self.start()
        stack.callback(self.stop)

    def start(self) -> None:
        ready = self.folder / "ready"
        ready.unlink(missing_ok=True)
        self._server = subprocess.Popen([sys.executable, SERVER, self.folder, self.namespace])
        until = time.monotonic() + 20
        while not ready.exists() and time.monotonic() < until:
            time.sleep(0.02)

    def stop(self) -> None:
        """End it as it should be: a killed one stays in everybody's graph for a while."""
        self._server.terminate()
        try:
            self._server.wait(timeout=5)
        except subprocess.TimeoutExpired:
            self.kill()

    def kill(self) -> None:
        self._server.kill()
        self._server.wait()

    def lose(self) -> None:
        self._server.send_signal(signal.SIGSTOP)

    def restore(self) -> None:
        self._server.send_signal(signal.SIGCONT)

    def file(self, text: str) -> str:
        return text.replace("NAMESPACE", self.namespace)

    def robot(self, state: State | None = None) -> Robot:
        file = self.folder / "robots.yaml"
        store = self._stack.enter_context(store_in(self.folder))
        file.write_text(self.file(VINEYARD))
        return self._stack.enter_context(robot_from(file, self.problem, store, state=state))

    def begun(self) -> int:
        return self._lines("begun")

    def done(self) -> int:
        return self._lines("done")

    def _lines(self, name: str) -> int:
        file = self.folder / name
        return len(file.read_text().splitlines()) if file.exists() else 0


@pytest.fixture
def bench(tmp_path: Path) -> Iterator[Ros2Bench]:
    with ExitStack() as stack:
        yield Ros2Bench(tmp_path, stack)


class TestRos2Robot(RobotConformance):
    @pytest.fixture
    def bench(self, tmp_path: Path) -> Iterator[Ros2Bench]:
        with ExitStack() as stack:
            yield Ros2Bench(tmp_path, stack)


@contextmanager
def errands(bench: Ros2Bench, go: str) -> Iterator[ActivityRobot]:
    with robot_of(bench.file(ERRANDS).replace("GO", go), bench.folder) as robot:
        yield robot


def outcome(bench: Ros2Bench, go: str) -> GoalStatus:
    with errands(bench, go) as robot:
        robot.send("m/1", GO)
        return ended(robot, "m/1")


def test_feedback_is_told_in_the_words_of_the_file(bench: Ros2Bench) -> None:
    told = set()
    with errands(bench, "{call: drive, with: {order: 4}, as: driving}") as robot:
        robot.send("m/1", GO)
        status: GoalStatus = UnderWay()
        while isinstance(status, UnderWay):
            told.add(status.doing)
            status = robot.wait("m/1", 0.02)
    assert status == Succeeded(ARRIVED)
    assert {"driving: step 2", "driving: step 3"} & told, told


@pytest.mark.parametrize(
    ("go", "reason"),
    [
        ("{call: drive, with: {order: 0}}", "rejected by drive"),
        ("{call: drive, with: {order: 2000}}", "aborted: {'sequence': []}"),
        ("{call: grip, with: {data: false}}", "the gripper is stuck"),
    ],
)
def test_a_refusal_is_a_failure_with_its_reason(go: str, reason: str, bench: Ros2Bench) -> None:
    assert outcome(bench, go) == Failed(reason, PROBLEM.initial)


def test_a_service_answers_and_its_result_may_be_asked_to_be_more(bench: Ros2Bench) -> None:
    assert outcome(bench, "{call: look, when: {message: ripe}}") == Succeeded(ARRIVED)


def test_a_topic_is_something_to_look_at(bench: Ros2Bench) -> None:
    text = bench.file(ERRANDS).replace("GO", "{call: look}")
    load = "  load: {via: ros2, topic: load, type: test_msgs/msg/BasicTypes}\n"
    seen = 'facts: {"held {t}": {call: load, when: {float32_value: {">": 0.4}}}}\n'
    text = text.replace("actions:", load + "actions:") + seen
    with robot_of(text, bench.folder) as robot:
        assert "held mug" in robot.state()


def test_a_robot_that_is_not_there_is_unreachable_and_is_found_once_it_is(
    bench: Ros2Bench,
) -> None:
    bench.kill()
    text = bench.file(ERRANDS).replace("discovery: 30", "discovery: 1")
    text = text.replace("GO", "{call: drive, with: {order: 2}}")
    with robot_of(text, bench.folder) as robot:
        with pytest.raises(Unreachable, match="no server for drive"):
            robot.send("m/1", GO)
        with pytest.raises(Unreachable, match="no server for drive"):
            robot.state()
        bench.start()
        until = time.monotonic() + 20
        status: GoalStatus = UnderWay()
        while isinstance(status, UnderWay) and time.monotonic() < until:
            try:
                status = robot.wait("m/1", 0.2)
            except Unreachable:
                time.sleep(0.1)
    assert status == Succeeded(ARRIVED)
    assert bench.begun() == 1


@pytest.mark.parametrize(
    ("go", "said"),
    [
        ("{call: drive, with: {ordr: 1}}", "no field 'ordr' (it has: order)"),
        ("{call: drive, with: {order: soon}}", "'order' is int32, not 'soon'"),
        ("{call: drive, with: {order: 1.5}}", "'order' is int32, not 1.5"),
        ("{call: grip, with: {data: 1}}", "'data' is boolean, not 1"),
    ],
)
def test_fields_that_do_not_fit_the_type_are_refused_with_their_line(
    go: str, said: str, tmp_path: Path
) -> None:
    text = ERRANDS.replace("NAMESPACE", "/nowhere").replace("GO", go)
    with pytest.raises(InputFileError) as caught, robot_of(text, tmp_path):
        pass
    assert said in caught.value.what
    assert go in text.splitlines()[(caught.value.line or 0) - 1]


def test_a_message_takes_what_yaml_wrote_and_gives_it_back() -> None:
    from geometry_msgs.msg import PoseStamped, PoseWithCovariance
    from test_msgs.msg import BasicTypes, Nested, UnboundedSequences

    for type, fields in (
        (PoseStamped, {"header": {"frame_id": "map"}, "pose": {"position": {"x": 3, "y": 0.5}}}),
        (PoseWithCovariance, {"covariance": list(range(36))}),
        (
            BasicTypes,
            {"bool_value": True, "byte_value": 7, "char_value": 65, "uint64_value": 2**63},
        ),
        (Nested, {"basic_types_value": {"float64_value": 1}}),
        (
            UnboundedSequences,
            {
                "string_values": ["a", "b"],
                "float32_values": [1, 2.5],
                "basic_types_values": [{"int8_value": -3}, {}],
            },
        ),
    ):
        assert objection(type, fields) is None
        assert_holds(fields_of(message_of(type, fields)), fields)


def assert_holds(found: Any, expected: Any) -> None:
    """The fields are as they were written; those that were not are there, too."""
    if isinstance(expected, dict):
        for name, value in expected.items():
            assert_holds(found[name], value)
    elif isinstance(expected, list):
        assert len(found) == len(expected)
        for one, other in zip(found, expected, strict=True):
            assert_holds(one, other)
    else:
        assert found == expected


@pytest.mark.parametrize(
    ("fields", "said"),
    [
        ({"pose": {"position": {"w": 1}}}, "no field 'pose.position.w'"),
        ({"pose": 3}, "'pose' is geometry_msgs/Pose, not 3"),
        ({"pose": {"position": {"x": "far"}}}, "'pose.position.x' is double, not 'far'"),
        ({"header": {"frame_id": 3}}, "'header.frame_id' is string, not 3"),
        ({"header": {"stamp": {"sec": 2**40}}}, "'header.stamp.sec' is int32"),
    ],
)
def test_a_field_that_does_not_fit_is_named_with_its_place(
    fields: dict[str, Any], said: str
) -> None:
    from geometry_msgs.msg import PoseStamped

    assert said in (objection(PoseStamped, fields) or "")


def test_placeholders_are_left_open_until_they_are_filled() -> None:
    from geometry_msgs.msg import PoseWithCovariance

    fields = {"pose": {"position": {"x": "{to.x}"}}, "covariance": ["{a}"]}
    assert objection(PoseWithCovariance, fields) is None
    assert objection(PoseWithCovariance, {"pose": "{pose}"}) is None


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("test_msgs/action/Fibonacci", "test_msgs/action/Fibonaci", "no action 'Fibonaci'"),
        ("test_msgs/action/Fibonacci", "no_msgs/action/Drive", "no package 'no_msgs'"),
        ("test_msgs/action/Fibonacci", "test_msgs/Fibonacci", "package/action/Name"),
        ("action: drive, ", "", "one of action, service and topic"),
        ("silence: 1", "silense: 1", "no key 'silense'"),
    ],
)
def test_a_type_that_is_not_there_is_refused_with_its_line(
    old: str, new: str, said: str, tmp_path: Path
) -> None:
    text = ERRANDS.replace("NAMESPACE", "/nowhere").replace("GO", "{call: look}")
    assert old in text
    with pytest.raises(InputFileError) as caught, robot_of(text.replace(old, new), tmp_path):
        pass
    assert said in f"{caught.value.what} {caught.value.hint}"
    assert caught.value.line is not None


def test_a_robot_in_a_name_space_of_its_own_is_named_by_the_call_and_found_again(
    bench: Ros2Bench,
) -> None:
    text = bench.file(ERRANDS).replace("action: drive,", 'action: "{space}/drive",')
    text = text.replace("GO", f'{{call: drive, with: {{space: "{bench.namespace}", order: 8}}}}')
    with robot_of(text, bench.folder) as robot:
        robot.send("m/1", GO)
        assert isinstance(robot.wait("m/1", 0.1), UnderWay)
    with robot_of(text, bench.folder) as again:
        assert ended(again, "m/1") == Succeeded(ARRIVED)
    assert bench.begun() == 1


def test_the_settings_on_the_page_are_read(tmp_path: Path) -> None:
    page = (Path(__file__).parents[2] / "docs" / "robots.md").read_text()
    (block,) = re.findall(r"```yaml\n(ros2:.*?)```", page, re.DOTALL)
    # What the page speaks of is in no wheel: other types stand in for it.
    text = block.replace("nav2_msgs/action/NavigateToPose", "test_msgs/action/Fibonacci")
    text = text.replace("sensor_msgs/msg/BatteryState", "test_msgs/msg/BasicTypes")
    actions = """\
actions:
  go: {do: {sequence: [{call: drive, with: {order: 1}}, {call: grip, with: {data: true}}]}}
  grasp: {do: {call: grip}}
facts: {"held {t}": {call: battery, when: {float32_value: 1.0}}}
"""
    with robot_of(text + actions, tmp_path):
        pass


def carried_out(
    bench: Ros2Bench, goal: str, *, when: dict[int, str] | None = None
) -> tuple[Mission, list[Event]]:
    """Run a mission over the servers; when: what befalls it after so many feedbacks."""
    events: list[Event] = []
    befalls = dict(when or {})
    asked: list[Observation] = []

    def record(instant: int, new: Sequence[Event]) -> Sequence[Entry]:
        entries = [Entry(len(events) + i, "t", instant, event) for i, event in enumerate(new)]
        events.extend(new)
        heard = sum(isinstance(event, ActionProgressed) for event in events)
        what = befalls.pop(heard, None)
        if what == "cancel":
            asked.append(CancelAsked("ada"))
        elif what == "restart":
            bench.kill()
            bench.start()
        return entries

    patience = Patience(news=0.05, lost=30.0)
    run = run_mission(
        accept(accepted(parse(goal)), policy_for(parse(goal))),
        bench.robot(),
        record,
        replanned,
        requests=lambda: asked.pop() if asked else None,
        patience=patience,
    )
    while True:
        try:
            next(run)
        except StopIteration as end:
            mission: Mission = end.value
            return mission, events


CLEARED = "F cleared_l0"


def test_a_mission_over_ros_ends_with_what_was_asked(bench: Ros2Bench) -> None:
    mission, events = carried_out(bench, CLEARED)
    assert mission.status is Status.FINISHED
    assert mission.satisfied
    done = [event.action.split()[0] for event in events if isinstance(event, ActionFinished)]
    assert done == ["move", "check-grape", "harvest-grape", "drop-grape", "sign-off"]
    told = [event.doing for event in events if isinstance(event, ActionProgressed)]
    assert any(each and each.startswith("driving to l0: step") for each in told), told
    assert bench.begun() == 3, "one to get there, one to look closer, one to drop it otherwise"


def test_a_mission_goes_on_after_its_server_died_and_returned(bench: Ros2Bench) -> None:
    mission, events = carried_out(bench, "F robot_at_rob_l0", when={3: "restart"})
    assert mission.status is Status.FINISHED
    failed = [event for event in events if isinstance(event, ActionFailed)]
    assert [each.reason for each in failed] == ["drive has forgotten the call"]
    assert (bench.begun(), bench.done()) == (2, 1)


def test_a_mission_that_is_cancelled_stops_the_robot_on_its_way(bench: Ros2Bench) -> None:
    mission, events = carried_out(bench, "F robot_at_rob_l0", when={2: "cancel"})
    assert mission.status is Status.CANCELLED
    assert [each.reason for each in events if isinstance(each, ActionFailed)] == ["cancelled"]
    assert (bench.begun(), bench.done()) == (1, 0)


def test_a_mission_whose_robot_refuses_stops_with_its_reason(bench: Ros2Bench) -> None:
    mission, events = carried_out(bench, "F(robot_at_rob_l0 & X F robot_at_rob_wh)")
    assert mission.status is Status.STOPPED
    failed = [event.reason for event in events if isinstance(event, ActionFailed)]
    assert failed == ["rejected by drive"] * 4
    assert mission.ended is not None
    assert "failed 4 times in a row" in (mission.ended.reason or "")


def test_the_command_line_runs_a_mission_over_ros(bench: Ros2Bench, tmp_path: Path) -> None:
    (tmp_path / "domain.pddl").write_text(small_vineyard.DOMAIN_TEXT)
    (tmp_path / "problem.pddl").write_text(small_vineyard.PROBLEM_TEXT)
    robots = tmp_path / "robots.yaml"
    robots.write_text(
        bench.file(VINEYARD).replace("via: ros2, ", "").replace("    via: ros2\n", "")
    )
    site = ["-d", tmp_path / "domain.pddl", "-p", tmp_path / "problem.pddl"]
    options = ["--goal", CLEARED, "--robot", "ros2", "--robots", robots, "--json"]
    done = subprocess.run(
        [sys.executable, "-m", "plainspoken", "run", *site, *options],
        env={**os.environ, "PLAINSPOKEN_HOME": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    events = [json.loads(line) for line in done.stdout.splitlines()]
    assert events[-1]["satisfied"]
    assert any("driving to l0: step" in (e.get("doing") or "") for e in events)
