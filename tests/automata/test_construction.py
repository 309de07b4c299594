"""Automata against the semantics: steps, guards, what can and must accept, and their size."""

import subprocess
import sys
import time
from functools import reduce
from itertools import combinations, product

import pytest
from hypothesis import given
from tests.strategies import PROPOSITIONS, formulas, traces

from plainspoken.automata import construction, unfolding
from plainspoken.automata.construction import Automaton, automata_for
from plainspoken.errors import FormulaTooLargeError
from plainspoken.logic.formula import Always, Atom, Eventually, Formula, conjunction
from plainspoken.logic.syntax import parse
from plainspoken.logic.trace import Letter, Trace, holds

LETTERS: tuple[Letter, ...] = tuple(
    frozenset(names) for n in range(4) for names in combinations(PROPOSITIONS, n)
)


def read(automaton: Automaton, trace: Trace) -> int:
    return reduce(automaton.step, trace, automaton.initial)


def explored(formula: Formula) -> Automaton:
    automaton = Automaton(formula)
    automaton.can_accept(automaton.initial)
    return automaton


@given(formulas(), traces())
def test_an_automaton_accepts_the_traces_that_satisfy_its_formula(
    formula: Formula, trace: Trace
) -> None:
    automaton = Automaton(formula)
    assert automaton.accepts(read(automaton, trace)) == holds(formula, trace)


@given(formulas(), traces())
def test_the_automata_of_the_conjuncts_accept_together_what_satisfies_the_formula(
    formula: Formula, trace: Trace
) -> None:
    verdicts = [a.accepts(read(a, trace)) for a in automata_for(formula)]
    assert all(verdicts) == holds(formula, trace)


@given(formulas(), traces(longest=3))
def test_the_guards_of_a_state_are_disjoint_cover_all_letters_and_lead_where_a_step_does(
    formula: Formula, trace: Trace
) -> None:
    automaton = Automaton(formula)
    state = read(automaton, trace)
    guards = automaton.guards(state)
    for letter in LETTERS:
        assert [g.target for g in guards if g.admits(letter)] == [automaton.step(state, letter)]


@given(formulas(), traces(longest=3))
def test_the_residual_of_a_state_is_what_the_formula_says_of_the_rest(
    formula: Formula, seen: Trace
) -> None:
    automaton = Automaton(formula)
    residual = automaton.residual(read(automaton, seen))
    for rest in ([letter] for letter in LETTERS):
        assert holds(residual, rest) == holds(formula, [*seen, *rest])


@given(formulas(("a", "b"), 5), traces(("a", "b"), 3))
def test_a_state_can_accept_if_the_trace_can_go_on_to_satisfy_the_formula(
    formula: Formula, seen: Trace
) -> None:
    automaton = Automaton(formula)
    state = read(automaton, seen)
    reachable = {state}
    todo = [state]
    while todo:
        for letter in map(frozenset, ("", "a", "b", "ab")):
            target = automaton.step(todo[-1], letter)
            if target not in reachable:
                reachable.add(target)
                todo.insert(0, target)
        todo.pop()
    verdicts = {automaton.accepts(each) for each in reachable}
    assert automaton.can_accept(state) == (True in verdicts)
    assert automaton.must_accept(state) == (False not in verdicts)


@given(formulas(("a", "b"), 5), traces(("a", "b"), 3), traces(("a", "b"), 4))
def test_no_way_to_go_on_contradicts_what_a_state_can_and_must_accept(
    formula: Formula, seen: Trace, rest: Trace
) -> None:
    automaton = Automaton(formula)
    state = read(automaton, seen)
    for trace in (seen, [*seen, *rest]):
        if holds(formula, trace):
            assert automaton.can_accept(state)
        else:
            assert not automaton.must_accept(state)


@pytest.mark.parametrize(
    ("formula", "trace", "can", "must"),
    [
        ("F a", "", True, False),
        ("F a", "b", True, False),
        ("F a", "a", True, True),
        ("G a", "a", True, False),
        ("G a", "b", False, False),
        ("F a & G !a", "", False, False),
        ("X X true", "|", True, False),
        ("X X true", "||", True, True),
        ("G(a -> X b)", "a", True, False),
        ("G(a -> X b)", "a|a", False, False),
        ("true", "", True, True),
        ("false", "", False, False),
    ],
)
def test_what_can_and_what_must_become_of_a_trace(
    formula: str, trace: str, *, can: bool, must: bool
) -> None:
    automaton = Automaton(parse(formula))
    state = read(automaton, [frozenset(letter) for letter in trace.split("|")])
    assert automaton.can_accept(state) is can
    assert automaton.must_accept(state) is must


def test_before_anything_is_read_a_formula_that_asks_for_an_instant_does_not_hold() -> None:
    assert not Automaton(parse("F true")).accepts(Automaton.initial)
    assert Automaton(parse("G a")).accepts(Automaton.initial)


def test_propositions_that_the_formula_does_not_read_change_nothing() -> None:
    automaton = Automaton(parse("F a"))
    assert automaton.atoms == ("a",)
    assert automaton.step(0, frozenset({"a", "z"})) == automaton.step(0, frozenset("a"))
    assert automaton.step(0, frozenset("z")) == 0


def test_a_conjunct_that_is_said_twice_has_one_automaton() -> None:
    assert len(automata_for(parse("F a & G b & F a"))) == 2
    assert len(automata_for(parse("!(a | b)"))) == 2
    assert len(automata_for(parse("F a | G b"))) == 1


def test_a_formula_that_is_always_true_or_false_has_one_state() -> None:
    for text in ("true", "false", "G true & !F false"):
        assert len(explored(parse(text))) == 1
    assert len(explored(parse("F a & G !a"))) <= 2


def test_cubes_with_one_target_that_differ_in_one_sign_are_one_cube() -> None:
    automaton = Automaton(parse("G(a -> F b)"))
    signs = {(g.positive, g.negative): g.target for g in automaton.guards(0)}
    assert len(signs) <= 3
    nested = Automaton(parse("a U (b U (c U (d U (e U f))))"))
    assert len(nested.guards(0)) <= 7


# Sizes: (formula, states over all automata). A state more is a reason to look, not always a fault.

SIZES = {
    "fourteen places in any order": (" & ".join(f"F a{i}" for i in range(14)), 28),
    "twelve responses": (" & ".join(f"G(a{i} -> F b{i})" for i in range(12)), 24),
    "twelve untils": (" & ".join(f"(a{i} U b{i})" for i in range(12)), 36),
    "twelve weak untils": (" & ".join(f"(!a{i} W b{i})" for i in range(12)), 36),
    "forty nested eventually": ("F(" * 40 + "a" + ")" * 40, 2),
    "forty places in order": ("".join(f"F(a{i} & " for i in range(40)) + "true" + ")" * 40, 41),
    "thirty places in strict order": (
        "".join(f"F(a{i} & X " for i in range(30)) + "true" + ")" * 30,
        32,
    ),
    "thirteen nested untils": (" U (".join(f"a{i}" for i in range(13)) + ")" * 12, 14),
    "fourteen alternatives": (" | ".join(f"F a{i}" for i in range(14)), 2),
    "eight places as one automaton": ("(" + " & ".join(f"F a{i}" for i in range(8)) + ") | z", 257),
    "patrolling": ("G(F a & F b & F c)", 8),
    "at most three times": ("!F(a & X F(a & X F(a & X F a)))", 5),
}


@pytest.mark.parametrize("name", SIZES)
def test_the_automata_of_common_missions_are_small_and_quickly_built(name: str) -> None:
    text, states = SIZES[name]
    formula = parse(text)
    start = time.process_time()
    automata = automata_for(formula)
    for automaton in automata:
        automaton.can_accept(automaton.initial)
    assert time.process_time() - start < 1
    assert sum(map(len, automata)) <= states


@given(formulas(("a", "b"), 4))
def test_no_two_states_of_a_small_automaton_share_their_residual(formula: Formula) -> None:
    automaton = explored(formula)
    residuals = [automaton.residual(state) for state in range(len(automaton))]
    assert len(set(residuals)) == len(residuals)


# Too large


def test_an_automaton_too_large_to_explore_is_stepped_all_the_same() -> None:
    automaton = Automaton(conjunction(*(Eventually(Atom(f"a{i}")) for i in range(14))))
    start = time.process_time()
    assert automaton.can_accept(automaton.initial)
    assert not automaton.must_accept(automaton.initial)
    state = read(automaton, [frozenset({f"a{i}"}) for i in range(14)])
    assert automaton.accepts(state)
    assert time.process_time() - start < 5


def test_a_state_with_too_many_guards_names_the_part_of_the_formula(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(unfolding, "MOST_CUBES", 100)
    formula = Eventually(conjunction(*(Always(Eventually(Atom(f"a{i}"))) for i in range(8))))
    with pytest.raises(FormulaTooLargeError) as caught:
        Automaton(formula).guards(0)
    assert caught.value.part.startswith("F(G F a0 & ")


def test_where_too_little_is_known_an_automaton_can_accept_and_need_not(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(construction, "MOST_GUARDS", 3)
    automaton = Automaton(parse("F a & F b"))
    assert automaton.can_accept(0)
    assert not automaton.must_accept(0)


# Order of sets

GUARDS = """
from plainspoken.automata.construction import automata_for
from plainspoken.logic.syntax import parse
for text in ("G(a -> (b U c)) & F(a & X F b)", "(a | b) U (c & d) | F(e & !f)", "G(F a & F b)"):
    for automaton in automata_for(parse(text)):
        print(automaton.atoms)
        automaton.can_accept(0)
        for state in range(len(automaton)):
            for g in automaton.guards(state):
                print(state, sorted(g.positive), sorted(g.negative), g.target)
            print(automaton.residual(state))
"""


def test_the_order_of_sets_never_decides_how_an_automaton_is_numbered() -> None:
    printed = {
        subprocess.run(
            [sys.executable, "-c", GUARDS],
            check=True,
            capture_output=True,
            text=True,
            env={"PYTHONHASHSEED": seed, "PYTHONPATH": ":".join(sys.path)},
        ).stdout
        for seed in ("0", "1", "2")
    }
    assert len(printed) == 1
    assert len(printed.pop().splitlines()) > 50


@pytest.mark.parametrize(("first", "second"), [*product(["F a", "G a", "a U b"], repeat=2)])
def test_automata_of_several_formulas_do_not_share_state(first: str, second: str) -> None:
    alone = [explored(parse(second)).residual(s) for s in range(len(explored(parse(second))))]
    explored(parse(first))
    after = explored(parse(second))
    assert [after.residual(s) for s in range(len(after))] == alone
