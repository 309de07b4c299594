import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.mission.small_vineyard import PROBLEM

from plainspoken.errors import PlainspokenError, UnknownSymbolError
from plainspoken.mission.robot import Failed, Seconds, Succeeded, UnderWay, Unheard
from plainspoken.mission.simulator import FORCED_TRIES, Simulator, Steering, steering_from
from plainspoken.world.domain import State
from plainspoken.world.scene import applicable_actions, successors

TO_THE_LINE = "move rob wh l0"
CHECK = "check-grape rob g0 l0"
CALL = "call-support rob sup wh l0"


def done(robot: Simulator, goal_id: str, action: str) -> State:
    robot.send(goal_id, action)
    status = robot.wait(goal_id, 0.0)
    assert isinstance(status, Succeeded)
    return status.state


@given(st.integers(), st.lists(st.integers(0, 100), max_size=15))
def test_every_outcome_is_one_that_the_domain_allows(seed: int, picks: list[int]) -> None:
    robot = Simulator(PROBLEM, seed=seed)
    for number, pick in enumerate(picks):
        before = robot.state()
        actions = list(applicable_actions(PROBLEM, before))
        action = actions[pick % len(actions)]
        state = done(robot, str(number), action)
        assert state == robot.state()
        assert state in successors(PROBLEM, before, action)


def outcomes_of_a_check(steering: tuple[Steering, ...]) -> set[str]:
    found = set()
    for seed in range(30):
        robot = Simulator(PROBLEM, seed=seed, steering=steering)
        done(robot, "1", TO_THE_LINE)
        found |= {a for a in done(robot, "2", CHECK) if a.endswith(" g0")}
    return found


def test_without_steering_each_outcome_comes_about_for_some_seed() -> None:
    assert outcomes_of_a_check(()) == {"ripe g0", "unripe g0", "unknown g0"}


@pytest.mark.parametrize(
    ("texts", "left"),
    [
        (["unripe g0"], {"unripe g0"}),
        (["not ripe g0", "not unknown g0"], {"unripe g0"}),
        (["!ripe_g0"], {"unripe g0", "unknown g0"}),
        (["ripe_g0", "unripe g0"], {"ripe g0"}),
        (["full b"], {"ripe g0", "unripe g0", "unknown g0"}),
    ],
)
def test_steering_leaves_the_outcomes_that_grant_the_first_wishes_it_can(
    texts: list[str], left: set[str]
) -> None:
    assert outcomes_of_a_check(tuple(steering_from(text, PROBLEM) for text in texts)) == left


def test_steering_against_a_retry_gives_way_to_chance_after_a_few_tries() -> None:
    robot = Simulator(PROBLEM, seed=1, steering=(Steering("robot-at sup wh"),))
    done(robot, "go", TO_THE_LINE)
    came = ["robot-at sup l0" in done(robot, str(number), CALL) for number in range(FORCED_TRIES)]
    assert not any(came)
    for number in range(100):
        if "robot-at sup l0" in done(robot, f"more {number}", CALL):
            return
    pytest.fail("the support robot never came")


def test_steering_by_what_is_not_there_or_no_fact_is_refused() -> None:
    with pytest.raises(UnknownSymbolError) as caught:
        steering_from("unripe g9", PROBLEM)
    assert "unripe_g0" in caught.value.nearest
    with pytest.raises(PlainspokenError, match="not a fact"):
        steering_from("move_executed", PROBLEM)


@given(st.integers(), st.integers(0, 4))
def test_a_run_that_is_taken_up_in_a_new_simulator_goes_on_as_it_would_have(
    seed: int, cut: int
) -> None:
    actions = [TO_THE_LINE, CALL, CHECK, "move rob l0 wh", TO_THE_LINE]
    whole = Simulator(PROBLEM, seed=seed)
    states = [whole.state()]
    for number, action in enumerate(actions):
        if action == CALL and "robot-at sup l0" in states[-1]:
            continue
        states.append(done(whole, str(number), action))
    resumed = Simulator(
        PROBLEM,
        seed=seed,
        state=states[cut],
        history=list(zip(states[:cut], actions[:cut], strict=True)),
    )
    for number, action in enumerate(actions[cut:], start=cut):
        assert done(resumed, str(number), action) == states[number + 1]


def test_the_same_goal_id_twice_is_one_action() -> None:
    robot = Simulator(PROBLEM)
    first = done(robot, "1", TO_THE_LINE)
    robot.send("1", TO_THE_LINE)
    assert robot.wait("1", 0.0) == Succeeded(first)
    assert robot.state() == first


def test_what_was_never_sent_was_never_heard() -> None:
    assert Simulator(PROBLEM).wait("1", 0.0) == Unheard()


def test_what_cannot_be_done_fails_and_changes_nothing() -> None:
    robot = Simulator(PROBLEM)
    for goal_id, action in (("1", CHECK), ("2", "fly rob"), ("3", "move rob wh nowhere")):
        robot.send(goal_id, action)
        assert robot.wait(goal_id, 0.0) == Failed("its precondition does not hold", robot.state())
    assert robot.state() == PROBLEM.initial


def test_by_default_nobody_sleeps_and_simulated_time_passes() -> None:
    def no_sleep(seconds: Seconds) -> None:
        raise AssertionError(f"slept for {seconds} s")

    robot = Simulator(PROBLEM, sleep=no_sleep, durations={"move": (5.0, 5.0)})
    done(robot, "1", TO_THE_LINE)
    assert robot.elapsed == 5.0


def test_at_a_pace_it_sleeps_in_naps_and_tells_how_far_it_is() -> None:
    naps: list[Seconds] = []
    robot = Simulator(PROBLEM, pace=0.25, sleep=naps.append, durations={"move": (8.0, 8.0)})
    robot.send("1", TO_THE_LINE)
    assert robot.wait("1", 0.75) == UnderWay(0.375)
    assert robot.wait("1", 0.75) == UnderWay(0.75)
    assert isinstance(robot.wait("1", 0.75), Succeeded)
    assert naps == [0.75, 0.75, 0.5]


def test_a_cancelled_action_changes_nothing() -> None:
    robot = Simulator(PROBLEM, pace=1.0, sleep=lambda _: None)
    robot.send("1", TO_THE_LINE)
    robot.cancel("1")
    assert robot.wait("1", 1.0) == Failed("cancelled", PROBLEM.initial)


def test_what_a_person_changes_is_seen() -> None:
    robot = Simulator(PROBLEM)
    robot.disturb(added=["full b"], deleted=["hand-empty rob"])
    assert robot.state() == (PROBLEM.initial | {"full b"}) - {"hand-empty rob"}
