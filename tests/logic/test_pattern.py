"""The mission patterns against the formulas of the catalogue, and against traces."""

import pytest

from plainspoken.automata.equivalence import equivalent, implies
from plainspoken.logic.formula import Atom, Not
from plainspoken.logic.pattern import (
    AtLeast,
    AtMost,
    BoundDelay,
    BoundReaction,
    Choice,
    DelayedReaction,
    Exactly,
    FairVisit,
    FutureAvoidance,
    GlobalAvoidance,
    GuardedVisit,
    InstantaneousReaction,
    OrderedVisit,
    PastAvoidance,
    Patrolling,
    Pattern,
    PromptReaction,
    SequencedVisit,
    StrictOrderedVisit,
    Visit,
    Wait,
)
from plainspoken.logic.syntax import parse, unparse
from plainspoken.logic.trace import holds

a, b, c = Atom("a"), Atom("b"), Atom("c")


@pytest.mark.parametrize(
    ("pattern", "literal", "executable"),
    [
        (Visit((a, b)), "F a & F b", None),
        (SequencedVisit((a, b, c)), "F(a & F(b & F c))", None),
        (OrderedVisit((a, b)), "F(a & F b) & (!b U a)", None),
        (StrictOrderedVisit((a, b)), "F(a & F b) & (!b U a) & (!a U (a U (!a U b)))", None),
        (GuardedVisit(a, b), "F a & (!a U b)", None),
        (FairVisit((a, b)), "F a & F b & G(a -> X(!a W b)) & G(b -> X(!b W a))",
         "F a & F b & G(a -> WX(!a W b)) & G(b -> WX(!b W a))"),
        (Patrolling((a, b)), "G F a & G F b", None),
        (GlobalAvoidance((a, b)), "G !a & G !b", None),
        (PastAvoidance(a, b), "!a U b", "!a W b"),
        (PastAvoidance(a, b, demanded=True), "!a U b", None),
        (FutureAvoidance(a, b), "G(a -> X G !b)", "G(a -> WX G !b)"),
        (AtLeast(a, 2), "F(a & (a U (!a & (!a U F a))))", None),
        (AtMost(a, 1), "!F(a & (a U (!a & (!a U F a))))", None),
        (Exactly(a, 1), "F a & !F(a & (a U (!a & (!a U F a))))", None),
        (Wait(a, b), "a U b", None),
        (InstantaneousReaction(a, b), "G(a -> b)", None),
        (DelayedReaction(a, b), "G(a -> F b)", None),
        (PromptReaction(a, b), "G(a -> X b)", "(a -> X b) & G((!a & X a) -> X X b)"),
        (PromptReaction(a, b, persists=False), "G(a -> X b)", None),
        (PromptReaction(Not(a), b), "G(!a -> X b)", "(!a -> X b) & G((a & X !a) -> X X b)"),
        (BoundReaction(a, b), "G(a <-> b)", None),
        (BoundDelay(a, b), "G(a <-> X b)", "(a <-> X b) & G((!a & X a) <-> X X b)"),
        (BoundDelay(a, b, persists=False), "G(a <-> X b)", None),
        (Choice(((Visit((a,)),), (Visit((b,)),))), "F a | F b", None),
    ],
    ids=repr,
)  # fmt: skip
def test_a_pattern_has_the_two_readings_of_the_catalogue(
    pattern: Pattern, literal: str, executable: str | None
) -> None:
    assert equivalent(pattern.literal, parse(literal)), unparse(pattern.literal)
    assert equivalent(pattern.executable, parse(executable or literal))


@pytest.mark.parametrize("times", [1, 2, 3])
def test_counts_count_separate_entries(times: int) -> None:
    visits = [frozenset({"a"}), frozenset({"a"}), frozenset[str]()]
    for said in range(5):
        trace = [frozenset[str](), *visits * said]
        assert holds(AtLeast(a, times).literal, trace) == (said >= times)
        assert holds(AtMost(a, times).literal, trace) == (said <= times)
        assert holds(Exactly(a, times).literal, trace) == (said == times)


def test_rounds_are_what_patrolling_can_have_on_a_finite_trace() -> None:
    rounds = Patrolling((a, b)).rounds(2).literal
    assert unparse(rounds) == "F(a & F(b & F(a & F b)))"


def test_a_stricter_order_implies_a_looser_one() -> None:
    places = (a, b, c)
    strict, ordered = StrictOrderedVisit(places).literal, OrderedVisit(places).literal
    assert implies(strict, ordered)
    assert implies(ordered, SequencedVisit(places).literal)
    assert implies(SequencedVisit(places).literal, Visit(places).literal)
    assert not implies(ordered, strict)
