from tests.mission.small_vineyard import PROBLEM

from plainspoken.automata.verdict import Monitor
from plainspoken.logic.formula import Formula, atoms
from plainspoken.logic.syntax import parse
from plainspoken.mission.coverage import sound_nodes
from plainspoken.planning.policy import NodeId, Policy, PolicyNode
from plainspoken.world.domain import State
from plainspoken.world.symbol import letter, resolve_all

HOME: State = frozenset({"robot-at rob wh", "robot-at sup wh"})
LINE: State = frozenset({"robot-at rob l0", "robot-at sup wh"})
BOTH: State = frozenset({"robot-at rob l0", "robot-at sup l0"})
GO, CALL = "move rob wh l0", "call-support rob sup wh l0"


def sound(policy: Policy, goal: Formula, *seen: State) -> tuple[NodeId, ...]:
    symbols = resolve_all(atoms(goal), PROBLEM)
    monitor = Monitor.of(goal).after_all(letter(symbols, state, None) for state in seen)
    return sound_nodes(policy, seen[-1], monitor, symbols)


def policy(*nodes: PolicyNode) -> Policy:
    return Policy("strong-cyclic", "", 0, frozenset(), nodes)


CALLING = policy(
    PolicyNode(0, HOME, GO, (1,)),
    PolicyNode(1, LINE, CALL, (1, 2)),
    PolicyNode(2, BOTH, None),
)


def test_a_policy_that_tries_until_it_is_lucky_is_sound() -> None:
    goal = parse("F robot_at_sup_l0")
    assert sound(CALLING, goal, HOME) == (0,)
    assert sound(CALLING, goal, HOME, LINE) == (1,)
    assert sound(CALLING, goal, HOME, LINE, BOTH) == (2,)


def test_a_state_that_the_policy_does_not_have_is_nowhere() -> None:
    assert sound(CALLING, parse("true"), frozenset({"full b"})) == ()


def test_a_policy_that_stops_too_early_for_the_memory_is_not_sound() -> None:
    assert sound(CALLING, parse("F robot_at_rob_wh & F robot_at_sup_l0"), LINE) == ()
    assert sound(CALLING, parse("F robot_at_rob_wh & F robot_at_sup_l0"), HOME, LINE) == (1,)


def test_a_retry_that_breaks_the_goal_when_unlucky_is_not_sound() -> None:
    assert (
        sound(CALLING, parse("F robot_at_sup_l0 & G !(call_support_executed & X true)"), LINE) == ()
    )


def test_a_policy_that_can_only_go_round_is_not_sound() -> None:
    round_and_round = policy(PolicyNode(0, LINE, CALL, (1,)), PolicyNode(1, BOTH, "x", (0,)))
    assert sound(round_and_round, parse("true"), LINE) == ()


def test_an_action_that_leads_nowhere_is_no_stop() -> None:
    assert sound(policy(PolicyNode(0, LINE, CALL, ())), parse("true"), LINE) == ()


def test_of_two_nodes_with_one_state_the_one_for_the_memory_is_found() -> None:
    goal = parse("F(robot_at_rob_l0 & X F robot_at_rob_wh)")
    there_and_back = policy(
        PolicyNode(0, HOME, GO, (1,)),
        PolicyNode(1, LINE, "move rob l0 wh", (2,)),
        PolicyNode(2, HOME, None),
    )
    assert sound(there_and_back, goal, HOME) == (0,)
    assert sound(there_and_back, goal, HOME, LINE, HOME) == (0, 2)
