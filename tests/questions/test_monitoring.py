"""A request that was changed on the way, as questions see it."""

from tests.mission.small_vineyard import PROBLEM, accepted, policy_for, replanned

from plainspoken.automata.verdict import Verdict
from plainspoken.logic.syntax import parse, unparse
from plainspoken.mission.command import Plan
from plainspoken.mission.executive import Advance, accept, advance
from plainspoken.mission.observation import ActionDone, ChangeAsked, Lost, Planned, Progressed
from plainspoken.mission.request import Clause
from plainspoken.planning.policy import Policy
from plainspoken.questions.answer import answer
from plainspoken.questions.moment import Moment
from plainspoken.questions.monitoring import Letters
from plainspoken.world.event import Entry
from plainspoken.world.scene import successors

GO = "move rob wh l0"
THERE = successors(PROBLEM, PROBLEM.initial, GO)[0]
CHECKED = successors(PROBLEM, THERE, "check-grape rob g0 l0")[0]
HOME = Clause(parse("F robot_at_rob_wh"), since=1)


class Told:
    """A mission that is told things, and its log."""

    def __init__(self) -> None:
        goal = parse("F cleared_l0")
        self.entries: list[Entry] = []
        self.now = self._kept(accept(accepted(goal), policy_for(goal)))

    def hears(self, observation: object) -> None:
        self.now = self._kept(advance(self.now.mission, observation))  # type: ignore[arg-type]

    def _kept(self, now: Advance) -> Advance:
        for event in now.events:
            self.entries.append(Entry(len(self.entries), "t", now.mission.instant, event))
        return now


def changed() -> Told:
    """Half-way to a cleared line, and told to go home instead."""
    told = Told()
    told.hears(ActionDone("m/1", THERE))
    told.hears(ChangeAsked("ada", "go home instead", (HOME,), "Visit the warehouse."))
    told.hears(ActionDone("m/2", CHECKED))
    (command,) = told.now.commands
    assert isinstance(command, Plan)
    policy = replanned(command.state, command.remaining)
    assert isinstance(policy, Policy)
    told.hears(Planned(policy))
    return told


def test_after_a_change_the_request_is_the_new_one_and_the_past_is_as_it_was() -> None:
    moment = Moment(changed().entries)
    assert [unparse(part.formula) for part in moment.parts] == ["F robot_at_rob_wh"]
    assert [part.verdict for part in moment.parts] == [Verdict.OPEN]
    assert [unparse(part.formula) for part in moment.parts_at(1)] == ["F cleared_l0"]


def test_where_the_robot_was_before_a_clause_began_does_not_count_for_it() -> None:
    letters = Letters(PROBLEM, ((0, "F robot_at_rob_wh"), (1, "F robot_at_rob_wh")))
    parts = letters.parts_after([PROBLEM.initial, THERE], [None, GO])
    assert [part.verdict for part in parts] == [Verdict.SATISFIED, Verdict.OPEN]


def test_no_action_led_to_the_instant_that_a_clause_begins_with() -> None:
    letters = Letters(PROBLEM, ((0, "F move_executed"), (1, "F move_executed")))
    parts = letters.parts_after([PROBLEM.initial, THERE], [None, GO])
    assert [part.verdict for part in parts] == [Verdict.SATISFIED, Verdict.OPEN]


def test_why_is_answered_by_what_is_asked_for_now() -> None:
    said = answer("Why are you going there?", changed().entries).text
    assert "warehouse" in said
    assert "cleared" not in said


def test_what_the_robot_says_of_its_action_is_told() -> None:
    told = Told()
    told.hears(Progressed("m/1", 0.5, "turning"))
    assert "(turning)" in answer("What are you doing?", told.entries).text


def test_a_lost_connection_is_told_before_anything_else() -> None:
    told = Told()
    told.hears(Lost("no answer"))
    assert answer("What are you doing?", told.entries).text.startswith("The connection")
