import pytest
from tests.mission.small_vineyard import PROBLEM, accepted, policy_for, replanned

from plainspoken.logic.formula import Formula
from plainspoken.logic.syntax import parse
from plainspoken.mission.command import Attach, CancelAction, Look, Plan, Send
from plainspoken.mission.executive import Advance, accept, advance, queued
from plainspoken.mission.mission import Limits, Status, mission_from
from plainspoken.mission.observation import (
    ActionDone,
    ActionNotDone,
    CancelAsked,
    NeverHeard,
    NotPlanned,
    PauseAsked,
    Planned,
    ResumeAsked,
    Sensed,
    TakeUpAsked,
    Told,
)
from plainspoken.planning.policy import Policy
from plainspoken.world.domain import State
from plainspoken.world.event import (
    DeviationNoticed,
    Entry,
    MissionEnded,
    ObservationMade,
    PolicyChosen,
    ReportReceived,
    VerdictReached,
)
from plainspoken.world.scene import successors

CLEARED = parse("F cleared_l0")
START = PROBLEM.initial
GO = "move rob wh l0"
CHECK = "check-grape rob g0 l0"


def started(goal: Formula = CLEARED, limits: Limits | None = None) -> Advance:
    return accept(accepted(goal), policy_for(goal), limits)


def kinds(now: Advance) -> list[str]:
    return [event.kind for event in now.events]


def after_action(now: Advance, state: State) -> Advance:
    assert now.mission.in_flight is not None
    return advance(now.mission, ActionDone(now.mission.in_flight.goal_id, state))


def at_the_line(goal: Formula = CLEARED) -> Advance:
    """The mission after its first action, with the check under way."""
    return after_action(started(goal), successors(PROBLEM, START, GO)[0])


def found_to_be(what: str) -> State:
    return at_the_line().mission.world - {"unchecked g0"} | {f"{what} g0"}


def test_a_mission_begins_with_all_that_is_needed_to_understand_its_log() -> None:
    now = started()
    assert kinds(now) == ["mission_accepted", "policy_chosen", "action_started"]
    assert now.commands == (Send("m/1", GO),)
    assert now.mission.status is Status.RUNNING


@pytest.mark.parametrize(
    ("what", "action"),
    [("ripe", "harvest-grape rob g0 l0"), ("unripe", "sign-off rob l0")],
)
def test_the_observed_state_picks_the_next_action(what: str, action: str) -> None:
    now = after_action(at_the_line(), found_to_be(what))
    assert kinds(now) == ["action_finished", "action_started"]
    assert now.commands == (Send("m/3", action),)
    assert now.mission.instant == 2


def test_a_mission_ends_where_the_policy_does_and_says_that_it_is_satisfied() -> None:
    now = after_action(at_the_line(), found_to_be("unripe"))
    now = after_action(now, now.mission.world | {"cleared l0"})
    assert now.events[1:] == (VerdictReached("satisfied"), MissionEnded("finished", True))
    assert now.mission.status is Status.FINISHED
    assert now.commands == ()


def test_a_goal_that_holds_already_needs_no_action() -> None:
    now = started(parse("F robot_at_rob_wh"))
    assert kinds(now)[2:] == ["verdict_reached", "mission_ended"]


def test_an_outcome_that_the_model_does_not_have_is_a_deviation_said_in_words() -> None:
    now = after_action(at_the_line(), at_the_line().mission.world | {"full b", "ripe g0"})
    (deviation,) = (e for e in now.events if isinstance(e, DeviationNoticed))
    assert deviation.action == CHECK
    assert deviation.description == (
        "after check-grape rob g0 l0: full b is true and should be false;"
        " unchecked g0 is true and should be false"
    )
    assert not deviation.covered
    assert now.commands == (Plan(now.mission.world, parse("X F cleared_l0")),)
    assert now.mission.status is Status.PLANNING


def test_after_a_deviation_it_goes_on_from_a_node_of_the_policy_where_that_is_sound() -> None:
    # The robot finds itself at the warehouse again: where the policy began.
    now = after_action(at_the_line(), START)
    assert kinds(now) == ["action_finished", "deviation_noticed", "action_started"]
    deviation = now.events[1]
    assert isinstance(deviation, DeviationNoticed)
    assert (deviation.covered, deviation.node) == (True, 0)
    assert now.commands == (Send("m/3", GO),)


def test_a_node_with_the_right_state_and_another_memory_of_the_goal_is_not_gone_on_from() -> None:
    goal = parse("F cleared_l0 & G(full_b -> F robot_at_rob_wh)")
    now = at_the_line(goal)
    now = advance(now.mission, Sensed("camera", now.mission.world | {"full b"}))
    # Empty again; the policy knows this state, but there it need not go back to the warehouse.
    now = after_action(now, found_to_be("unripe"))
    assert kinds(now) == ["action_finished", "deviation_noticed"]
    (command,) = now.commands
    assert isinstance(command, Plan)
    policy = replanned(command.state, command.remaining)
    assert isinstance(policy, Policy)
    assert {node.action for node in policy.nodes} == {
        "sign-off rob l0",
        "move rob l0 wh",
        None,
    }
    assert advance(now.mission, Planned(policy)).mission.status is Status.RUNNING


def test_the_plan_asked_for_is_for_what_is_left_of_the_goal() -> None:
    now = after_action(at_the_line(), at_the_line().mission.world | {"full b"})
    (command,) = now.commands
    assert isinstance(command, Plan)
    policy = replanned(command.state, command.remaining)
    assert isinstance(policy, Policy)
    now = advance(now.mission, Planned(policy))
    assert kinds(now) == ["policy_chosen", "action_started"]
    assert isinstance(now.events[0], PolicyChosen)
    assert now.events[0].reason is not None


def test_a_plan_that_forgets_what_is_left_of_the_goal_is_refused() -> None:
    now = after_action(at_the_line(), at_the_line().mission.world | {"full b"})
    (command,) = now.commands
    assert isinstance(command, Plan)
    policy = replanned(command.state, parse("F full_b"))
    assert isinstance(policy, Policy)
    now = advance(now.mission, Planned(policy))
    assert isinstance(now.events[0], MissionEnded)
    assert now.events[0].outcome == "stopped"
    assert not now.events[0].satisfied


def test_a_policy_for_another_goal_is_refused_before_anything_moves() -> None:
    now = accept(accepted(CLEARED), policy_for(parse("F robot_at_rob_l0")))
    assert kinds(now) == ["mission_accepted", "mission_ended"]
    assert now.commands == ()


def test_without_another_plan_it_stops_safely_and_says_why() -> None:
    now = after_action(at_the_line(), at_the_line().mission.world | {"full b"})
    now = advance(now.mission, NotPlanned("the line is closed"))
    assert now.events == (MissionEnded("stopped", False, "the line is closed"),)


def test_a_violation_is_announced_when_it_is_unavoidable_and_the_mission_stops() -> None:
    now = at_the_line(parse("F cleared_l0 & G robot_at_sup_wh"))
    now = after_action(now, now.mission.world - {"robot-at sup wh"})
    assert kinds(now) == ["action_finished", "verdict_reached", "mission_ended"]
    assert now.events[1] == VerdictReached("violated", "G robot_at_sup_wh")


def test_a_violation_while_the_robot_is_at_it_is_announced_before_the_action_ends() -> None:
    now = at_the_line(parse("F cleared_l0 & G robot_at_sup_wh"))
    now = advance(now.mission, Sensed("camera", now.mission.world - {"robot-at sup wh"}))
    assert kinds(now) == ["observation_made", "verdict_reached"]
    assert now.mission.in_flight is not None


def test_a_pause_lets_the_action_end_and_starts_no_other() -> None:
    now = advance(started().mission, PauseAsked("ada"))
    assert (kinds(now), now.commands) == (["paused"], ())
    assert now.mission.status is Status.PAUSED
    assert not now.mission.is_at_rest
    now = after_action(now, successors(PROBLEM, START, GO)[0])
    assert (kinds(now), now.commands) == (["action_finished"], ())
    assert now.mission.is_at_rest
    assert advance(now.mission, PauseAsked("ada")).events == ()


def test_a_mission_that_is_resumed_looks_before_it_moves() -> None:
    now = advance(started().mission, PauseAsked("ada"))
    now = after_action(now, successors(PROBLEM, START, GO)[0])
    now = advance(now.mission, ResumeAsked("ada"))
    assert (kinds(now), now.commands) == (["resumed"], (Look(),))
    seen = advance(now.mission, Sensed("robot", now.mission.world))
    assert kinds(seen) == ["observation_made", "action_started"]
    assert seen.mission.instant == now.mission.instant


def test_what_changed_during_a_pause_is_a_deviation() -> None:
    now = advance(started().mission, PauseAsked("ada"))
    now = after_action(now, successors(PROBLEM, START, GO)[0])
    now = advance(now.mission, ResumeAsked("ada"))
    now = advance(now.mission, Sensed("robot", START))
    assert kinds(now) == ["observation_made", "deviation_noticed", "action_started"]
    assert isinstance(now.events[1], DeviationNoticed)
    assert now.events[1].description.startswith("with no action: robot-at rob wh is true")


def test_an_action_in_flight_is_asked_about_and_not_sent_again() -> None:
    now = advance(started().mission, ResumeAsked("restart"))
    assert (kinds(now), now.commands) == (["resumed"], (Attach("m/1"),))
    now = after_action(now, successors(PROBLEM, START, GO)[0])
    assert kinds(now) == ["action_finished", "action_started"]


def test_an_action_that_the_robot_never_heard_of_is_sent_under_the_same_goal_id() -> None:
    now = advance(started().mission, ResumeAsked("restart"))
    now = advance(now.mission, NeverHeard("m/1"))
    assert (kinds(now), now.commands) == (["action_resent"], (Send("m/1", GO),))


def test_a_cancelled_mission_waits_for_what_becomes_of_its_action() -> None:
    now = advance(started().mission, CancelAsked("ada"))
    assert (kinds(now), now.commands) == (["cancelled"], (CancelAction("m/1"),))
    now = advance(now.mission, ActionNotDone("m/1", "cancelled", START))
    assert kinds(now) == ["action_failed", "mission_ended"]
    assert now.events[-1] == MissionEnded("cancelled", False, "cancelled by ada")
    assert now.mission.status is Status.CANCELLED


def test_a_paused_mission_can_be_cancelled() -> None:
    now = advance(started().mission, PauseAsked("ada"))
    now = after_action(now, successors(PROBLEM, START, GO)[0])
    now = advance(now.mission, CancelAsked("ada"))
    assert kinds(now) == ["cancelled", "mission_ended"]


def test_news_of_an_action_that_is_over_changes_nothing() -> None:
    now = at_the_line()
    for observation in (
        ActionDone("m/1", START),
        ActionNotDone("m/1", "late", START),
        NeverHeard("m/1"),
        Sensed("camera", now.mission.world),
    ):
        again = advance(now.mission, observation)
        assert (again.mission, again.events) == (now.mission, ())


def test_nothing_changes_a_mission_that_is_over() -> None:
    over = advance(started().mission, CancelAsked("ada"))
    over = advance(over.mission, ActionNotDone("m/1", "cancelled", START))
    for observation in (PauseAsked("a"), ResumeAsked("a"), CancelAsked("a"), Told("a", "hi")):
        assert advance(over.mission, observation) == Advance(over.mission, (), ())


def test_a_failed_action_that_changed_nothing_is_tried_again_a_few_times() -> None:
    now = started(limits=Limits(failures=2))
    for attempt in (1, 2):
        now = advance(now.mission, ActionNotDone(f"m/{attempt}", "stuck", START))
        assert kinds(now) == ["action_failed", "action_started"]
        assert now.mission.instant == 0
    now = advance(now.mission, ActionNotDone("m/3", "stuck", START))
    ended = now.events[-1]
    assert isinstance(ended, MissionEnded)
    assert ended.reason == "the robot failed 3 times in a row, last at move rob wh l0"


def test_a_failed_action_that_changed_something_begins_an_instant_without_an_action() -> None:
    now = advance(started().mission, ActionNotDone("m/1", "bumped", START | {"full b"}))
    assert kinds(now) == ["action_failed", "deviation_noticed"]
    assert (now.mission.instant, now.mission.led_by) == (1, None)


def test_without_luck_it_stops_after_a_bounded_number_of_tries() -> None:
    goal = parse("F robot_at_sup_l0")
    now = started(goal, Limits(revisits=5))
    tries = 0
    while now.mission.in_flight is not None:
        action = now.mission.in_flight.action
        tries += action.startswith("call-support")
        state = now.mission.world
        if action == GO:
            (state,) = successors(PROBLEM, state, action)
        now = after_action(now, state)
    assert tries == 6
    assert isinstance(now.events[-1], MissionEnded)
    assert now.events[-1].reason is not None
    assert now.events[-1].reason.startswith("no luck with call-support")


def test_it_does_not_plan_anew_for_ever() -> None:
    now = started(limits=Limits(replans=2))
    asked = 0
    while not now.mission.is_over:
        match now.commands:
            case (Plan(state, remaining),):
                asked += 1
                policy = replanned(state, remaining)
                assert isinstance(policy, Policy)
                now = advance(now.mission, Planned(policy))
            case _:
                strange = frozenset({f"picked g{now.mission.instant}"})
                now = after_action(now, now.mission.world | strange)
    assert asked == 2
    assert isinstance(now.events[-1], MissionEnded)
    assert now.events[-1].reason == "planned anew 2 times, and went astray again"


def test_a_report_changes_what_is_known_and_is_acted_on() -> None:
    now = at_the_line()
    report = Told("ada", "I found g0 unripe", frozenset({"unripe g0"}), frozenset({"unchecked g0"}))
    now = advance(now.mission, report)
    assert kinds(now) == ["report_received"]
    assert isinstance(now.events[0], ReportReceived)
    assert now.events[0].added == ("unripe g0",)
    # The check that was under way found the same.
    now = after_action(now, now.mission.world)
    assert kinds(now) == ["action_finished", "deviation_noticed", "action_started"]
    assert now.commands == (Send("m/3", "sign-off rob l0"),)


def test_a_robot_need_not_tell_what_never_changes() -> None:
    partial = successors(PROBLEM, START, GO)[0] - started().mission.brief.static
    assert after_action(started(), partial).events == at_the_line().events


def test_an_observation_between_actions_that_changes_nothing_is_not_kept() -> None:
    now = advance(started().mission, PauseAsked("ada"))
    now = after_action(now, successors(PROBLEM, START, GO)[0])
    assert advance(now.mission, Sensed("camera", now.mission.world)).events == ()
    changed = advance(now.mission, Sensed("camera", now.mission.world | {"full b"}))
    assert isinstance(changed.events[0], ObservationMade)
    assert changed.events[0].added == ("full b",)


def test_a_mission_that_is_queued_has_its_policy_and_no_action_yet() -> None:
    events = queued(accepted(CLEARED), policy_for(CLEARED))
    assert [event.kind for event in events] == ["mission_accepted", "policy_chosen"]


def test_a_queued_mission_looks_at_the_world_before_its_first_action() -> None:
    events = queued(accepted(CLEARED), policy_for(CLEARED))
    mission = mission_from([Entry(step, "t", 0, event) for step, event in enumerate(events)])
    taken = advance(mission, TakeUpAsked("w"))
    assert taken.commands == (Look(),)
    seen = advance(taken.mission, Sensed("robot", START))
    assert kinds(seen) == ["observation_made", "action_started"]


def test_whoever_takes_over_asks_about_the_action_under_way() -> None:
    now = started()
    taken = advance(now.mission, TakeUpAsked("w"))
    assert kinds(taken) == ["taken_up"]
    assert taken.commands == (Attach("m/1"),)


def test_whoever_takes_over_leaves_a_pause_and_a_cancellation_as_they_are() -> None:
    now = started()
    paused = advance(now.mission, PauseAsked("ada"))
    taken = advance(paused.mission, TakeUpAsked("w"))
    assert taken.mission.status is Status.PAUSED
    assert taken.commands == (Attach("m/1"),)
    cancelled = advance(now.mission, CancelAsked("ada"))
    taken = advance(cancelled.mission, TakeUpAsked("w"))
    assert taken.commands == (Attach("m/1"), CancelAction("m/1"))
