"""Policies as short lists of rules."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from tests.strategies import problems_with_goals

from plainspoken.logic.formula import Formula
from plainspoken.logic.syntax import parse
from plainspoken.planning.decision_list import DecisionList, decision_list
from plainspoken.planning.diagram import compact, dot, mermaid, rules
from plainspoken.planning.policy import Policy
from plainspoken.planning.solver import Solved, solve
from plainspoken.world.domain import Problem
from plainspoken.world.pddl import read_domain, read_problem

VINEYARD = Path(__file__).resolve().parents[2] / "examples" / "vineyard"


@pytest.fixture(scope="module")
def vineyard() -> Problem:
    return read_problem(VINEYARD / "problem.pddl", read_domain(VINEYARD / "domain.pddl"))


def policy_for(problem: Problem, text: str) -> Policy:
    ending = solve(problem, parse(text))
    assert isinstance(ending, Solved)
    return ending.policy


def does_the_same(listed: DecisionList, policy: Policy) -> bool:
    """Whether the list, carried out with its memory, takes the policy's actions."""
    todo = [(policy.node(policy.initial), 0)]
    seen = set()
    while todo:
        node, memory = todo.pop()
        if (node.id, memory) in seen:
            continue
        seen.add((node.id, memory))
        action = listed.rules[listed.chosen(node.state, memory)].action
        if action != node.action or memory != listed.memory[node.id]:
            return False
        for id in node.successors:
            after = policy.node(id)
            assert action is not None
            todo.append((after, listed.remembered(memory, node.state, action, after.state)))
    return True


@settings(max_examples=300, suppress_health_check=[HealthCheck.too_slow])
@given(problems_with_goals())
def test_each_node_first_matches_a_rule_with_its_action(drawn: tuple[Problem, Formula]) -> None:
    ending = solve(*drawn)
    if isinstance(ending, Solved):
        listed = decision_list(ending.policy)
        assert does_the_same(listed, ending.policy)
        assert len(listed.rules) <= len(ending.policy.nodes)
        assert {listed.rule_of(node) for node in ending.policy.nodes} == set(
            range(len(listed.rules))
        )


@pytest.mark.parametrize(
    ("text", "nodes_a_rule"),
    [
        ("F cleared_l2", 1.2),
        ("F cleared_l0 & F cleared_l1 & F cleared_l2 & G(full_b -> !robot_at_rob_l3)", 3),
        ("F(cleared_l1 & F(robot_at_rob_l3 & F(robot_at_rob_l1 & F cleared_l2)))", 3),
    ],
)
def test_rules_are_few_and_short(vineyard: Problem, text: str, nodes_a_rule: float) -> None:
    policy = policy_for(vineyard, text)
    listed = decision_list(policy)
    assert does_the_same(listed, policy)
    assert len(policy.nodes) >= nodes_a_rule * len(listed.rules)
    assert sum(len(rule.facts) for rule in listed.rules) <= 2.5 * len(listed.rules)
    assert listed == decision_list(policy)


def test_what_the_state_does_not_decide_is_remembered(vineyard: Problem) -> None:
    policy = policy_for(vineyard, "F(robot_at_rob_l1 & F(robot_at_rob_l2 & F robot_at_rob_l1))")
    listed = decision_list(policy)
    assert does_the_same(listed, policy)
    assert rules(policy) == (
        "  1. if robot-at rob l0: move rob l0 l1\n"
        "  2. if robot-at rob l2: move rob l2 l1\n"
        "  3. if the memory is 0: move rob l1 l2\n"
        "  4. otherwise: stop\n"
        "The memory is 0 at the start, and changes so (the first that fits counts):\n"
        "  0 to 1, by: move rob l2 l1\n"
    )


def test_a_compact_diagram_has_a_box_for_each_rule(vineyard: Problem) -> None:
    policy = policy_for(vineyard, "F cleared_l1 & F cleared_l2")
    drawing = compact(policy)
    assert len(drawing.boxes) == len(decision_list(policy).rules) < len(policy.nodes)
    assert len(dot(drawing).splitlines()) == 6 + len(drawing.boxes) + len(drawing.edges)
    assert "done" in mermaid(drawing)
