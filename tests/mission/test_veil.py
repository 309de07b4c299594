"""What a simulated robot sees of what is hidden from it."""

from pathlib import Path

from tests.mission.store_room import SITE

from plainspoken.mission.kept_simulator import KeptSimulator
from plainspoken.mission.robot import Succeeded
from plainspoken.mission.veil import VeiledRobot


def test_what_an_action_changed_is_seen_also_where_it_ended_before_anybody_asked(
    tmp_path: Path,
) -> None:
    at_once = KeptSimulator(tmp_path / "world", "w", SITE.problem, pace=0.0)
    robot = VeiledRobot(at_once, SITE.problem)
    robot.send("m/1", "go rob hall red-room")
    robot.send("m/2", "take rob parcel red-room")
    status = robot.wait("m/2", 1.0)
    assert isinstance(status, Succeeded)
    assert "has rob parcel" in status.state
    assert "in parcel red-room" not in status.state
    assert "in parcel red-room" not in robot.state()
