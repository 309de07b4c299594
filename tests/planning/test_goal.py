"""The problem's own goal as a formula, whatever its atoms are called."""

from __future__ import annotations

from pathlib import Path

from plainspoken.logic.formula import Atom, Eventually, atoms
from plainspoken.logic.syntax import unparse
from plainspoken.planning.goal import denoted, problem_goal
from plainspoken.planning.solver import Solved, solve
from plainspoken.planning.validation import Valid, validate
from plainspoken.world.domain import Problem
from plainspoken.world.pddl import read_domain, read_problem
from plainspoken.world.symbol import AtomSymbol


def problem_from(folder: Path, domain: str, problem: str) -> Problem:
    (folder / "domain.pddl").write_text(domain)
    (folder / "problem.pddl").write_text(problem)
    return read_problem(folder / "problem.pddl", read_domain(folder / "domain.pddl"))


def test_quantifiers_are_expanded_over_the_objects(tmp_path: Path) -> None:
    problem = problem_from(
        tmp_path,
        "(define (domain d) (:types t) (:predicates (p ?x - t) (q ?x - t))"
        " (:action a :parameters (?x - t) :precondition (and) :effect (p ?x)))",
        "(define (problem p) (:domain d) (:objects a b - t) (:init (q b))"
        " (:goal (forall (?x - t) (or (p ?x) (q ?x)))))",
    )
    assert unparse(problem_goal(problem)) == "F((p_a | q_a) & (p_b | q_b))"
    ending = solve(problem, problem_goal(problem))
    assert isinstance(ending, Solved)
    assert [node.action for node in ending.policy.nodes] == ["a a", None]


def test_atoms_that_flatten_to_one_id_are_kept_apart(tmp_path: Path) -> None:
    problem = problem_from(
        tmp_path,
        "(define (domain d) (:predicates (on ?x) (on-a ?x) (f))"
        " (:action one :parameters (?x) :precondition (and) :effect (on ?x))"
        " (:action two :parameters (?x) :precondition (and) :effect (on-a ?x)))",
        "(define (problem p) (:domain d) (:objects b a-b) (:init) (:goal (and (on a-b) (on-a b))))",
    )
    goal = problem_goal(problem)
    symbols = [denoted(name, problem) for name in sorted(atoms(goal))]
    assert {s.atom for s in symbols if isinstance(s, AtomSymbol)} == {"on a-b", "on-a b"}
    ending = solve(problem, goal)
    assert isinstance(ending, Solved)
    assert sum(node.action is not None for node in ending.policy.nodes) == 2
    assert isinstance(validate(problem, goal, ending.policy), Valid)


def test_an_atom_that_is_a_word_of_the_grammar_stands_for_itself(tmp_path: Path) -> None:
    problem = problem_from(
        tmp_path,
        "(define (domain d) (:predicates (true) (x))"
        " (:action a :parameters () :precondition (and) :effect (true)))",
        "(define (problem p) (:domain d) (:init) (:goal (true)))",
    )
    assert problem_goal(problem) == Eventually(Atom("true"))
    ending = solve(problem, problem_goal(problem))
    assert isinstance(ending, Solved)
    assert isinstance(validate(problem, problem_goal(problem), ending.policy), Valid)
