"""What is now, and what an action can make of it, each rule of PDDL in a small example."""

from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.strategies import problems

from plainspoken.errors import PlainspokenError
from plainspoken.world.domain import (
    Add,
    AllOf,
    AnyOf,
    AtomCondition,
    Condition,
    Delete,
    Effect,
    Equal,
    Exists,
    ForAll,
    ForEach,
    NotCondition,
    OneOf,
    Parameter,
    Problem,
    State,
    Together,
    When,
)
from plainspoken.world.scene import (
    applicable_actions,
    instances,
    is_applicable,
    satisfies,
    successors,
)

ReadProblem = Callable[[str, str], Problem]

DOMAIN = """(define (domain lamps)
  (:types lamp room)
  (:constants one two - lamp)
  (:predicates (on ?l - lamp) (in ?l - lamp ?r - room) (next ?a ?b - room) (dark) (p) (q) (r))
  (:action act :parameters (?l - lamp) :precondition {precondition} :effect {effect}))
"""
PROBLEM = """(define (problem two) (:domain lamps)
  (:objects hall attic - room)
  (:init (in one hall) (in two attic) (next hall attic)))
"""


@pytest.fixture
def lamps(problem_of: ReadProblem) -> Callable[..., Problem]:
    """The two lamps, with one action of the given precondition and effect."""

    def read(precondition: str = "()", effect: str = "()") -> Problem:
        return problem_of(DOMAIN.format(precondition=precondition, effect=effect), PROBLEM)

    return read


def state(*atoms: str) -> State:
    return frozenset(atoms)


# Conditions


@pytest.mark.parametrize(
    ("condition", "on", "expected"),
    [
        ("()", [], True),
        ("(and)", [], True),
        ("(or)", [], False),
        ("(on ?l)", ["on one"], True),
        ("(on ?l)", ["on two"], False),
        ("(not (on ?l))", ["on two"], True),
        ("(and (on ?l) (p))", ["on one"], False),
        ("(or (on ?l) (p))", ["on one"], True),
        ("(imply (p) (q))", [], True),
        ("(imply (p) (q))", ["p"], False),
        ("(imply (p) (q))", ["p", "q"], True),
        ("(= ?l one)", [], True),
        ("(= ?l two)", [], False),
        ("(not (= ?l two))", [], True),
        ("(= ?l ?l)", [], True),
        ("(forall (?k - lamp) (on ?k))", ["on one"], False),
        ("(forall (?k - lamp) (on ?k))", ["on one", "on two"], True),
        ("(exists (?k - lamp) (on ?k))", ["on two"], True),
        ("(exists (?k - lamp) (on ?k))", [], False),
        ("(exists (?l - lamp) (on ?l))", ["on two"], True),
        ("(exists (?k - lamp) (and (on ?k) (not (= ?k ?l))))", ["on one"], False),
        ("(exists (?k - lamp) (and (on ?k) (not (= ?k ?l))))", ["on two"], True),
        ("(forall (?k - lamp) (exists (?r - room) (in ?k ?r)))", ["in one hall"], False),
        (
            "(forall (?k - lamp) (exists (?r - room) (in ?k ?r)))",
            ["in one hall", "in two hall"],
            True,
        ),
        ("(exists (?r - room) (forall (?k - lamp) (in ?k ?r)))", ["in one hall"], False),
    ],
)
def test_a_condition_holds_in_a_state_as_the_table_says(
    lamps: Callable[..., Problem], condition: str, on: list[str], *, expected: bool
) -> None:
    assert is_applicable(lamps(condition), state(*on), "act one") is expected


def test_over_no_objects_every_one_fits_and_none_exists(problem_of: ReadProblem) -> None:
    domain = DOMAIN.format(precondition="()", effect="()").replace("one two - lamp", "")
    problem = problem_of(domain, "(define (problem none) (:domain lamps) (:init))")
    lamp = (Parameter("?k", ("lamp",)),)
    never = AnyOf()
    assert satisfies(state(), ForAll(lamp, never), problem)
    assert not satisfies(state(), Exists(lamp, AllOf()), problem)


# Effects


@pytest.mark.parametrize(
    ("effect", "before", "after"),
    [
        ("()", ["p"], [["p"]]),
        ("(p)", [], [["p"]]),
        ("(not (p))", ["p", "q"], [["q"]]),
        ("(and (p) (not (q)))", ["q"], [["p"]]),
        # where one outcome adds and deletes an atom, it is true afterwards
        ("(and (p) (not (p)))", ["p"], [["p"]]),
        ("(and (not (p)) (p))", [], [["p"]]),
        # conditions are read in the state before the action
        ("(and (p) (when (p) (q)))", [], [["p"]]),
        ("(and (not (p)) (when (p) (q)))", ["p"], [["q"]]),
        ("(and (when (p) (and (not (p)) (q))) (when (q) (and (not (q)) (p))))", ["p"], [["q"]]),
        (
            "(and (when (p) (and (not (p)) (q))) (when (q) (and (not (q)) (p))))",
            ["p", "q"],
            [["p", "q"]],
        ),
        ("(when (p) (when (q) (r)))", ["p"], [["p"]]),
        ("(when (p) (when (q) (r)))", ["p", "q"], [["p", "q", "r"]]),
        # quantified effects
        ("(forall (?k - lamp) (on ?k))", [], [["on one", "on two"]]),
        ("(forall (?k - lamp) (when (not (on ?k)) (on ?k)))", ["on two"], [["on one", "on two"]]),
        ("(forall (?k - lamp) (when (= ?k ?l) (on ?k)))", [], [["on one"]]),
        # one outcome of each, in the order of the file; one that changes nothing is kept
        ("(oneof (p) (q))", [], [["p"], ["q"]]),
        ("(oneof (p) (and))", ["p"], [["p"]]),
        ("(oneof (p) (and))", [], [["p"], []]),
        ("(oneof (and) (p))", [], [[], ["p"]]),
        ("(oneof (p))", [], [["p"]]),
        # outcomes that come to the same state are one
        ("(oneof (p) (and (p) (not (r))))", [], [["p"]]),
        # nested and multiplied
        ("(oneof (oneof (p) (q)) (r))", [], [["p"], ["q"], ["r"]]),
        ("(and (oneof (p) (and)) (oneof (q) (and)))", [], [["p", "q"], ["p"], ["q"], []]),
        ("(when (p) (oneof (q) (r)))", [], [[]]),
        ("(when (p) (oneof (q) (r)))", ["p"], [["p", "q"], ["p", "r"]]),
        (
            "(forall (?k - lamp) (oneof (on ?k) (and)))",
            [],
            [["on one", "on two"], ["on one"], ["on two"], []],
        ),
        (
            "(forall (?k - lamp) (when (on ?k) (oneof (not (on ?k)) (and))))",
            ["on two"],
            [[], ["on two"]],
        ),
        ("(oneof (and (p) (oneof (q) (and))) (and))", [], [["p", "q"], ["p"], []]),
        # an add wins over a delete of another part, within one choice of outcomes
        ("(and (oneof (p) (not (p))) (not (p)))", ["p"], [["p"], []]),
    ],
)
def test_an_action_leads_to_the_states_of_its_outcomes(
    lamps: Callable[..., Problem], effect: str, before: list[str], after: list[list[str]]
) -> None:
    found = successors(lamps(effect=effect), state(*before), "act one")
    assert found == tuple(state(*atoms) for atoms in after)


def test_an_action_that_is_not_applicable_leads_nowhere(lamps: Callable[..., Problem]) -> None:
    problem = lamps("(p)", "(q)")
    for action in ("act one", "act hall", "act one two", "act", "fly one", "act nobody"):
        assert not is_applicable(problem, state(), action)
        with pytest.raises(PlainspokenError, match="not applicable"):
            successors(problem, state(), action)


@pytest.mark.parametrize("action", ["", " "])
def test_no_action_at_all_is_not_applicable_either(
    lamps: Callable[..., Problem], action: str
) -> None:
    assert not is_applicable(lamps(), state(), action)


def test_two_schemas_of_one_name_are_taken_together(problem_of: ReadProblem) -> None:
    second = "(:action act :parameters (?l - lamp) :precondition (q) :effect (oneof (r) (and)))"
    text = DOMAIN.format(precondition="(p)", effect="(on ?l)")
    problem = problem_of(text.rstrip().removesuffix(")") + second + ")", PROBLEM)
    assert successors(problem, state("p"), "act one") == (state("p", "on one"),)
    assert successors(problem, state("q"), "act one") == (state("q", "r"), state("q"))
    both = state("p", "q")
    assert successors(problem, both, "act one") == (both | {"on one"}, both | {"r"}, both)
    assert len(list(instances(problem, "act one"))) == 2


def test_the_applicable_actions_come_in_the_order_of_the_files(
    lamps: Callable[..., Problem],
) -> None:
    problem = lamps("(exists (?r - room) (in ?l ?r))")
    assert list(applicable_actions(problem, problem.initial)) == ["act one", "act two"]
    assert list(applicable_actions(problem, state("in two hall"))) == ["act two"]


def test_the_vineyard_goes_as_its_story_says(vineyard: Problem) -> None:
    start = vineyard.initial
    assert list(applicable_actions(vineyard, start)) == [
        "move rob l0 l1",
        "move rob l0 wh",
        "check-grape rob g0 l0",
        "call-support rob sup wh l0",
    ]
    ripe, unripe, unknown = successors(vineyard, start, "check-grape rob g0 l0")
    assert "ripe g0" in ripe
    assert "unripe g0" in unripe
    assert "unknown g0" in unknown
    assert is_applicable(vineyard, unripe, "sign-off rob l0")
    assert not is_applicable(vineyard, ripe, "sign-off rob l0")
    here, away = successors(vineyard, start, "call-support rob sup wh l0")
    assert "robot-at sup l0" in here
    assert away == start
    loaded = here | {"inside g0 b", "inside g1 b", "full b"}
    (emptied,) = successors(vineyard, loaded, "empty-box rob sup b l0 wh")
    assert emptied - here == {"stored g0", "stored g1", "robot-at sup wh"}
    assert here - emptied == {"robot-at sup l0"}


# Against another reading of the definition: substitute the objects first, then look.


def _grounded(part: Condition, problem: Problem, bound: dict[str, str]) -> Condition:
    """The condition with objects for variables and without quantifiers."""
    match part:
        case AtomCondition(name, terms):
            return AtomCondition(name, tuple(bound.get(term, term) for term in terms))
        case Equal(left, right):
            return AllOf() if bound.get(left, left) == bound.get(right, right) else AnyOf()
        case NotCondition(inner):
            return NotCondition(_grounded(inner, problem, bound))
        case AllOf(parts):
            return AllOf(tuple(_grounded(each, problem, bound) for each in parts))
        case AnyOf(parts):
            return AnyOf(tuple(_grounded(each, problem, bound) for each in parts))
        case ForAll((), inner) | Exists((), inner):
            return _grounded(inner, problem, bound)
        case ForAll((first, *rest), inner):
            body = ForAll(tuple(rest), inner)
            return AllOf(tuple(_grounded(body, problem, bound | b) for b in _of(first, problem)))
        case Exists((first, *rest), inner):
            body = Exists(tuple(rest), inner)
            return AnyOf(tuple(_grounded(body, problem, bound | b) for b in _of(first, problem)))
    raise AssertionError(part)


def _of(parameter: Parameter, problem: Problem) -> list[dict[str, str]]:
    return [{parameter.name: name} for name in problem.objects_for(parameter)]


def _true(part: Condition, now: State) -> bool:
    match part:
        case AtomCondition(name, terms):
            return " ".join((name, *terms)) in now
        case NotCondition(inner):
            return not _true(inner, now)
        case AllOf(parts):
            return all(_true(each, now) for each in parts)
        case AnyOf(parts):
            return any(_true(each, now) for each in parts)
    raise AssertionError(part)


Choice = Callable[[int], int]


def _outcome(
    effect: Effect, problem: Problem, bound: dict[str, str], now: State, choose: Choice
) -> list[tuple[bool, str]]:
    """The literals of one outcome, each `oneof` decided by `choose`."""
    match effect:
        case Add(atom) | Delete(atom):
            words = [atom.predicate, *(bound.get(term, term) for term in atom.terms)]
            return [(isinstance(effect, Add), " ".join(words))]
        case Together(parts):
            return [x for each in parts for x in _outcome(each, problem, bound, now, choose)]
        case When(condition, inner):
            if _true(_grounded(condition, problem, bound), now):
                return _outcome(inner, problem, bound, now, choose)
            return []
        case ForEach((parameter,), inner):
            return [
                x
                for more in _of(parameter, problem)
                for x in _outcome(inner, problem, bound | more, now, choose)
            ]
        case OneOf(parts):
            return _outcome(parts[choose(len(parts))], problem, bound, now, choose)
    raise AssertionError(effect)


@given(problems(), st.integers(0, 2**16))
def test_every_random_outcome_is_a_successor_and_every_successor_some_outcome(
    problem: Problem, dice: int
) -> None:
    for action in applicable_actions(problem, problem.initial):
        expected = successors(problem, problem.initial, action)
        found = set()
        # The dice, read digit by digit, choose outcomes; counting on from them finds the others.
        for seed in range(dice, dice + 200):
            for schema, bound in instances(problem, action):
                if not _true(_grounded(schema.precondition, problem, dict(bound)), problem.initial):
                    continue
                rest = seed

                def choose(sides: int) -> int:
                    nonlocal rest
                    rest, chosen = divmod(rest, sides)
                    return chosen

                literals = _outcome(schema.effect, problem, dict(bound), problem.initial, choose)
                added = {atom for positive, atom in literals if positive}
                deleted = {atom for positive, atom in literals if not positive}
                found.add((problem.initial - deleted) | added)
        assert found <= set(expected)
        if len(expected) <= 4:
            assert found == set(expected)
