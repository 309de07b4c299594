import pytest
from tests.mission.small_vineyard import DOMAIN_TEXT, PROBLEM, PROBLEM_TEXT

from plainspoken.cli.simulated import PATIENT_SECONDS, Settings, simulated
from plainspoken.errors import PlainspokenError
from plainspoken.mission.fault import FaultyRobot
from plainspoken.mission.simulator import Simulator
from plainspoken.pipeline import Site

SITE = Site(PROBLEM, DOMAIN_TEXT, PROBLEM_TEXT)


@pytest.mark.parametrize(
    "settings",
    [Settings(), Settings(7, ["unripe g0"], ["hanging:0.2", "person"], 30.0)],
)
def test_a_resumed_mission_finds_its_robot_as_it_was_set(settings: Settings) -> None:
    again = Settings.of(settings.to_json())
    assert again.to_json() == settings.to_json()
    assert type(simulated(SITE, again, mission="m")[0]) is (
        FaultyRobot if settings.faults else Simulator
    )


def test_a_robot_that_faults_strike_is_timed_by_its_own_clock() -> None:
    robot, patience = simulated(SITE, Settings(faults=["lost:1"]), mission="m")
    assert patience.action("anything") == PATIENT_SECONDS
    before = patience.clock()
    patience.sleep(10.0)
    assert patience.clock() >= before + 10.0
    assert isinstance(robot, FaultyRobot)


def test_what_is_no_wish_and_no_fault_is_refused() -> None:
    with pytest.raises(PlainspokenError):
        simulated(SITE, Settings(faults=["sulking"]), mission="m")
    with pytest.raises(PlainspokenError):
        simulated(SITE, Settings(steering=["happy rob"]), mission="m")
