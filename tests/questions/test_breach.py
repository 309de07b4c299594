"""What broke a request, and when: the instant is the one that the running verdict turned at."""

from hypothesis import given
from hypothesis import strategies as st
from tests.mission.small_vineyard import PROBLEM, accepted, policy_for
from tests.mission.store_room import SITE as STORE_ROOM
from tests.mission.store_room import Kept

from plainspoken.logic.syntax import parse
from plainspoken.mission.executive import Advance, accept, advance
from plainspoken.mission.judgement import first_breach, judgements
from plainspoken.mission.observation import (
    ActionDone,
    FactsTold,
    NotPlanned,
    Observation,
    Sensed,
)
from plainspoken.mission.observation import Told as Reported
from plainspoken.mission.sensing import Telling
from plainspoken.pipeline import Request, accepted_as, find_policy
from plainspoken.planning.solver import Solved
from plainspoken.questions.answer import answer
from plainspoken.questions.breach import broken_at
from plainspoken.questions.moment import Moment
from plainspoken.world.event import Entry, MissionEnded
from plainspoken.world.scene import successors
from plainspoken.world.sense import Sense, senses_to_json

GOAL = parse("F cleared_l0 & G robot_at_sup_wh")
POLICY = policy_for(GOAL)


class Log:
    """A mission that is told things, and its log."""

    def __init__(self) -> None:
        self.entries: list[Entry] = []
        self.now = self._kept(accept(accepted(GOAL), POLICY))

    def hears(self, observation: Observation) -> None:
        self.now = self._kept(advance(self.now.mission, observation))

    def does(self) -> None:
        goal = self.now.mission.in_flight
        assert goal is not None
        state = successors(PROBLEM, self.now.mission.world, goal.action)[0]
        self.hears(ActionDone(goal.goal_id, state))

    def _kept(self, now: Advance) -> Advance:
        for event in now.events:
            self.entries.append(Entry(len(self.entries), "t", now.mission.instant, event))
        return now


@given(st.integers(0, 2), st.integers(0, 3))
def test_the_instant_is_the_one_of_the_first_judgement_that_says_so(
    before: int, later: int
) -> None:
    log = Log()
    for _ in range(before):
        log.does()
    world = log.now.mission.world
    log.hears(Sensed("camera", world - {"robot-at sup wh"}))
    for number in range(later):
        log.hears(Sensed("camera", world - {"robot-at sup wh"} | {f"picked g{number}"}))
    moment = Moment(log.entries)
    breach = first_breach(judgements(log.entries))
    assert breach is not None
    (lost,) = (at for each in moment.demands if (at := broken_at(moment, each)) is not None)
    assert lost == breach.instant == before + 1
    assert moment.steps[lost] == breach.step


def test_who_asks_whether_a_rule_was_broken_hears_when_and_by_what() -> None:
    log = Log()
    log.does()
    log.hears(Reported("ada", "I sent the robot away", deleted=frozenset({"robot-at sup wh"})))
    said = answer("Did you break any rule?", log.entries)
    assert "It was broken at instant 2, when ada reported “I sent the robot away”." in said.text
    assert Moment(log.entries).steps[2] in said.evidence


def test_who_asks_how_far_it_is_hears_why_nothing_can_help_any_more() -> None:
    log = Log()
    log.does()
    gone = log.now.mission.world - {"unchecked g0", "grape-at g0 l0"}
    log.hears(ActionDone("m/2", gone))
    log.hears(NotPlanned("I can't clear line 0.", hopeless=True))
    assert isinstance(log.entries[-1].event, MissionEnded)
    said = answer("How far are you?", log.entries)
    assert "Nothing that I know of would still meet it. I can't clear line 0." in said.text


def test_who_asks_why_it_stopped_hears_the_reason_and_what_somebody_told() -> None:
    log = Log()
    log.does()
    log.hears(Reported("ada", "I sent the robot away", deleted=frozenset({"robot-at sup wh"})))
    log.does()
    said = answer("Why did you stop?", log.entries)
    assert "the request can no longer be met" in said.text
    assert "when ada reported" in said.text


def test_what_was_found_out_of_the_start_is_what_broke_the_request() -> None:
    goal = parse("F in_parcel_ramp & G !full_ramp")
    ending = find_policy(STORE_ROOM.problem, goal)
    assert isinstance(ending, Solved)
    senses = senses_to_json([Sense("full {p}", ("eye",), needed=True)])
    request = Request("m", goal, robot={"senses": senses})
    kept = Kept()
    first = accept(accepted_as(STORE_ROOM, request), ending.policy)
    kept.record(0, first.events)
    seen = FactsTold((Telling("full ramp", holds=True, by="eye"),))
    then = advance(first.mission, seen)
    kept.record(then.mission.instant, then.events)
    said = answer("Why did you stop?", kept.entries)
    assert "It was broken at instant 0, when it was seen that the ramp is full." in said.text
