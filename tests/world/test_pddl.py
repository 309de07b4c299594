"""Domain and problem files in: what they mean, what is forgiven, and what is refused where."""

import logging
from collections.abc import Callable
from pathlib import Path

import pytest

from plainspoken.errors import InputFileError
from plainspoken.world.domain import (
    Add,
    AllOf,
    AnyOf,
    AtomCondition,
    Condition,
    Delete,
    Domain,
    Effect,
    Equal,
    Exists,
    ForAll,
    ForEach,
    NotCondition,
    OneOf,
    Parameter,
    Problem,
    Together,
    When,
)
from plainspoken.world.pddl import parse_domain, parse_problem, read_domain, read_problem

ReadDomain = Callable[[str], Domain]
ReadProblem = Callable[[str, str], Problem]

DOMAIN = """(define (domain kitchen)
  (:requirements :typing :non-deterministic)
  (:types cup plate - dish dish - object)
  (:constants sink - object)
  (:predicates
    (clean ?d - dish)
    (on ?d - dish ?where - object)
    (done))
  (:action wash
    :parameters (?d - dish)
    :precondition (and (on ?d sink) (not (clean ?d)))
    :effect (oneof (clean ?d) (and)))
)
"""
PROBLEM = """(define (problem evening)
  (:domain kitchen)
  (:objects red - cup
    blue - plate)
  (:init
    (on red sink)
    (on blue sink))
  (:goal (and (clean red)
    (clean blue)))
)
"""


def test_a_domain_is_read_into_types_constants_predicates_and_actions(
    domain_of: ReadDomain,
) -> None:
    domain = domain_of(DOMAIN)
    assert domain.name == "kitchen"
    assert domain.types == {"cup": "dish", "plate": "dish", "dish": "object"}
    assert domain.constants == {"sink": "object"}
    assert domain.predicates == {
        "clean": (Parameter("?d", ("dish",)),),
        "on": (Parameter("?d", ("dish",)), Parameter("?where", ("object",))),
        "done": (),
    }
    (wash,) = domain.actions
    assert (wash.name, wash.line) == ("wash", 9)
    assert wash.parameters == (Parameter("?d", ("dish",)),)
    clean = AtomCondition("clean", ("?d",))
    assert wash.precondition == AllOf((AtomCondition("on", ("?d", "sink")), NotCondition(clean)))
    assert wash.effect == OneOf((Add(clean), Together()))


def test_a_problem_is_read_into_objects_initial_state_and_goal(problem_of: ReadProblem) -> None:
    problem = problem_of(DOMAIN, PROBLEM)
    assert problem.name == "evening"
    assert problem.objects == {"sink": "object", "red": "cup", "blue": "plate"}
    assert problem.initial == {"on red sink", "on blue sink"}
    assert problem.goal == AllOf(
        (AtomCondition("clean", ("red",)), AtomCondition("clean", ("blue",)))
    )
    assert problem.objects_for(Parameter("?", ("dish",))) == ("red", "blue")
    assert problem.objects_for(Parameter("?", ("cup", "object"))) == ("sink", "red", "blue")


CONDITIONS: dict[str, Condition] = {
    "()": AllOf(),
    "(and)": AllOf(),
    "(or)": AnyOf(),
    "(done)": AtomCondition("done", ()),
    "(not (done))": NotCondition(AtomCondition("done", ())),
    "(imply (done) (clean ?d))": AnyOf(
        (NotCondition(AtomCondition("done", ())), AtomCondition("clean", ("?d",)))
    ),
    "(= ?d sink)": Equal("?d", "sink"),
    "(forall (?e - cup ?f) (on ?e ?f))": ForAll(
        (Parameter("?e", ("cup",)), Parameter("?f")), AtomCondition("on", ("?e", "?f"))
    ),
    "(exists (?e - (either cup plate)) (clean ?e))": Exists(
        (Parameter("?e", ("cup", "plate")),), AtomCondition("clean", ("?e",))
    ),
    "(exists (?d - cup) (clean ?d))": Exists(
        (Parameter("?d", ("cup",)),), AtomCondition("clean", ("?d",))
    ),
}
EFFECTS: dict[str, Effect] = {
    "()": Together(),
    "(done)": Add(AtomCondition("done", ())),
    "(not (done))": Delete(AtomCondition("done", ())),
    "(and (done) (and))": Together((Add(AtomCondition("done", ())), Together())),
    "(when (done) (not (clean ?d)))": When(
        AtomCondition("done", ()), Delete(AtomCondition("clean", ("?d",)))
    ),
    "(forall (?e - dish) (oneof (clean ?e) (done)))": ForEach(
        (Parameter("?e", ("dish",)),),
        OneOf((Add(AtomCondition("clean", ("?e",))), Add(AtomCondition("done", ())))),
    ),
}


@pytest.mark.parametrize("text", CONDITIONS)
def test_every_form_of_a_condition_is_read(domain_of: ReadDomain, text: str) -> None:
    domain = domain_of(DOMAIN.replace("(and (on ?d sink) (not (clean ?d)))", text))
    assert domain.actions[0].precondition == CONDITIONS[text]


@pytest.mark.parametrize("text", EFFECTS)
def test_every_form_of_an_effect_is_read(domain_of: ReadDomain, text: str) -> None:
    domain = domain_of(DOMAIN.replace("(oneof (clean ?d) (and))", text))
    assert domain.actions[0].effect == EFFECTS[text]


# Forgiven


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("  (:requirements :typing :non-deterministic)\n", ""),
        (" :non-deterministic", ""),
        (" - dish dish - object)", " - dish)"),
        ("(domain kitchen)", "(DOMAIN Kitchen)"),
        ("(:action wash", "(:Action WASH"),
        ("?d", "?D"),
        ("(clean ?d)", "( clean ; a comment with a ) in it\n ?d )"),
        ("(:constants sink - object)", "(:constants sink)"),
    ],
)
def test_what_says_the_same_in_other_letters_reads_the_same(
    domain_of: ReadDomain, old: str, new: str
) -> None:
    assert old in DOMAIN
    expected = domain_of(DOMAIN)
    found = domain_of(DOMAIN.replace(old, new))
    assert found.actions == expected.actions
    assert found.predicates == expected.predicates


def test_the_sections_of_a_domain_come_in_any_order(domain_of: ReadDomain) -> None:
    head, action = DOMAIN.split("  (:action", maxsplit=1)
    name, rest = head.split("\n", maxsplit=1)
    end = action.rindex(")")
    moved = f"{name}\n  (:action{action[:end]}\n{rest})"
    assert domain_of(moved) == domain_of(DOMAIN)


def test_the_sections_of_a_problem_come_in_any_order(problem_of: ReadProblem) -> None:
    start, objects, init, goal = (
        PROBLEM.index(word) for word in ("(:domain", "(:objects", "(:init", "(:goal")
    )
    end = PROBLEM.rindex(")")
    moved = (
        PROBLEM[:start] + PROBLEM[goal:end] + PROBLEM[init:goal] + PROBLEM[objects:init]
    ) + PROBLEM[start:objects]
    assert problem_of(DOMAIN, moved + ")") == problem_of(DOMAIN, PROBLEM)


def test_a_missing_requirement_for_oneof_is_a_warning(
    domain_of: ReadDomain, caplog: pytest.LogCaptureFixture
) -> None:
    domain_of(DOMAIN)
    assert caplog.messages == []
    domain_of(DOMAIN.replace(" :non-deterministic", ""))
    assert caplog.messages[0].endswith(
        "domain.pddl: oneof without the requirement :non-deterministic"
    )


def test_an_action_without_parameters_is_a_warning_with_its_line(
    domain_of: ReadDomain, caplog: pytest.LogCaptureFixture
) -> None:
    domain = domain_of(DOMAIN.rstrip().removesuffix(")") + "(:action rest :effect (done)))")
    assert domain.actions[1].parameters == ()
    assert caplog.messages[0].endswith("domain.pddl:13: action rest has no :parameters")


def test_a_problem_of_another_domain_is_a_warning(
    problem_of: ReadProblem, caplog: pytest.LogCaptureFixture
) -> None:
    problem_of(DOMAIN, PROBLEM.replace("(:domain kitchen)", "(:domain cellar)"))
    problem_of(DOMAIN, PROBLEM.replace("(:domain kitchen)", ""))
    assert [message.split(": ", 1)[1] for message in caplog.messages] == [
        "the problem is for cellar, planning with kitchen",
        "the problem is for no domain, planning with kitchen",
    ]


def test_an_object_of_a_type_that_does_not_fit_is_a_warning_with_its_line(
    problem_of: ReadProblem, caplog: pytest.LogCaptureFixture
) -> None:
    problem_of(DOMAIN, PROBLEM.replace("(on red sink)", "(on sink red)"))
    assert caplog.record_tuples == [
        (
            "plainspoken.world.schema",
            logging.WARNING,
            caplog.messages[0],
        )
    ]
    assert caplog.messages[0].endswith("problem.pddl:6: sink is a object, where on takes a dish")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("  (:goal (and (clean red)\n    (clean blue)))\n", ""),
        ("(and (clean red)\n    (clean blue))", ""),
        ("(and (clean red)\n    (clean blue))", "()"),
    ],
)
def test_a_problem_without_a_goal_has_one_that_always_holds(
    problem_of: ReadProblem, old: str, new: str
) -> None:
    assert old in PROBLEM
    assert problem_of(DOMAIN, PROBLEM.replace(old, new)).goal == AllOf()


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("(:init", "(:metric minimize (total-cost)) (:init"),
        ("(:init", "(:requirements :strips) (:init"),
        ("(on red sink)", "(on red sink) (not (clean red)) (on red sink)"),
        ("(:objects", "(:objects sink - object"),
        ("blue - plate)", "blue - plate red - cup)"),
    ],
)
def test_what_changes_nothing_in_a_problem_is_read_over(
    problem_of: ReadProblem, old: str, new: str
) -> None:
    assert problem_of(DOMAIN, PROBLEM.replace(old, new, 1)) == problem_of(DOMAIN, PROBLEM)


def test_a_predicate_may_name_two_places_alike_or_be_called_like_an_unsupported_word(
    problem_of: ReadProblem,
) -> None:
    domain = DOMAIN.replace("(done)", "(done) (near ?x ?x) (assign ?d - dish) (increase)", 1)
    problem = problem_of(domain, PROBLEM.replace("(:init", "(:init (assign red) (increase)"))
    assert {"assign red", "increase"} < problem.initial
    assert len(list(problem.bindings(problem.domain.predicates["near"]))) == 9


def test_two_schemas_of_one_name_are_both_kept(domain_of: ReadDomain) -> None:
    second = "(:action wash :parameters (?d - cup) :precondition (done) :effect (clean ?d)))"
    domain = domain_of(DOMAIN.rstrip().removesuffix(")") + second)
    assert [action.name for action in domain.actions] == ["wash", "wash"]


# Refused

BROKEN_DOMAINS = [
    ("(define (domain kitchen)", "(define (problem kitchen)", 1, "expected a domain"),
    ("(define (domain kitchen)", "(define (domain)", 1, "expected (define (domain NAME) ...)"),
    ("(define", "(defun", 1, "expected (define (domain NAME) ...)"),
    ("(:types cup", "(:type cup", 3, "unknown section :type"),
    ("(:types", "types (:types", 1, "expected a section"),
    ("(:types", "() (:types", 1, "expected a section"),
    ("(:types", "((:types) a) (:types", 3, "unknown section"),
    ("(:constants", "(:types a)\n(:constants", 4, "a second :types section"),
    ("dish - object)", "dish - object cup - object)", 3, "cup is a dish and a object"),
    ("dish - object)", "dish - cup)", 3, "is below itself"),
    ("dish - object)", "dish - dish)", 3, "the type 'dish' is below itself"),
    ("dish - object)", "dish - (either a b))", 3, "needs one type"),
    ("sink - object", "sink - tub", 4, "sink has the unknown type 'tub'"),
    ("sink - object", "?sink - object", 4, "without a question mark"),
    ("?d - dish)\n    (on", "?d - dash)\n    (on", 6, "?d has the unknown type 'dash'"),
    ("(clean ?d - dish)", "(clean d - dish)", 6, "expected a variable"),
    ("(clean ?d - dish)", "clean", 5, "expected a predicate"),
    ("(clean ?d - dish)", "(clean ?d - dish) (clean)", 6, "a second, different predicate clean"),
    ("(:action wash", "(:action", 9, "expected (:action NAME ...)"),
    (":parameters (?d - dish)", ":parameters ?d", 9, "expected :parameters"),
    (":parameters (?d - dish)", ":parameters (?d - dash)", 9, "unknown type 'dash'"),
    (":parameters (?d - dish)", ":parameters (?d ?d)", 9, "the variable ?d stands twice"),
    (":parameters (?d - dish)", ":parameters (d)", 9, "expected a variable"),
    (":parameters (?d - dish)", ":parameters (?d - dish) (done)", 9, "expected a part"),
    (":precondition", ":observe", 9, "the action wash has an unknown part :observe"),
    (":precondition", ":effect (done)\n :precondition", 9, "wash has a second :effect"),
    (":effect (oneof (clean ?d) (and))", ":effect", 9, "expected a part of an action"),
    ("(oneof (clean ?d) (and))", "done", 9, "expected an effect in parentheses, got done"),
    ("(oneof (clean ?d) (and))", "(oneof)", 12, "oneof has the wrong number of parts"),
    ("(oneof (clean ?d) (and))", "(when (done))", 12, "when has the wrong number of parts"),
    ("(oneof (clean ?d) (and))", "(not done)", 12, "not has the wrong number of parts"),
    ("(oneof (clean ?d) (and))", "(not (not (done)))", 12, "there is no predicate 'not'"),
    ("(oneof (clean ?d) (and))", "(forall ?d (done))", 12, "expected (forall (?x - type) ...)"),
    ("(oneof (clean ?d) (and))", "(forall (?e - t) (done))", 12, "unknown type 't'"),
    ("(oneof (clean ?d) (and))", "(increase (cost) 1)", 12, "not supported: numeric effects"),
    ("(oneof (clean ?d) (and))", "(probabilistic 1 (done))", 12, "not supported: probabilities"),
    ("(on ?d sink)", "(at ?d sink)", 11, "there is no predicate 'at'"),
    ("(on ?d sink)", "(on ?d)", 11, "on takes 2 arguments, got 1"),
    ("(on ?d sink)", "(on ?d sink sink)", 11, "on takes 2 arguments, got 3"),
    ("(on ?d sink)", "(on ?e sink)", 11, "the variable ?e is not bound"),
    ("(on ?d sink)", "(on ?d table)", 11, "there is no object 'table'"),
    ("(on ?d sink)", "(on ?d (sink))", 11, "expected a name or variable"),
    ("(on ?d sink)", "((on) ?d sink)", 11, "expected an atom"),
    ("(on ?d sink)", "done", 11, "expected a condition in parentheses, got done"),
    ("(on ?d sink)", "(not)", 11, "not has the wrong number of parts"),
    ("(on ?d sink)", "(= ?d)", 11, "= has the wrong number of parts"),
    ("(on ?d sink)", "(imply (done))", 11, "imply has the wrong number of parts"),
    ("(on ?d sink)", "(>= (level) 3)", 11, "not supported: numeric conditions (>=)"),
    ("(on ?d sink)", "(exists (?e) (clean ?f))", 11, "the variable ?f is not bound"),
    ("(and (on ?d sink)", "(and (exists (?e) (done)) (clean ?e)", 11, "?e is not bound"),
    ("(:constants", "(:functions (cost))\n(:constants", 4, "not supported: numeric fluents"),
    ("(:action wash", "(:durative-action wash", 9, "not supported: durative actions"),
    ("(:action wash", "(:derived (done) (and))\n(:action w", 9, "not supported: derived"),
    (")))\n)", "))\n)", 1, "a '(' is never closed"),
    (")))\n)", "))))\n)", 13, "a ')' too many"),
]


@pytest.mark.parametrize(("old", "new", "line", "what"), BROKEN_DOMAINS)
def test_a_broken_domain_is_refused_with_the_line(
    domain_of: ReadDomain, old: str, new: str, line: int, what: str
) -> None:
    assert old in DOMAIN
    with pytest.raises(InputFileError) as caught:
        domain_of(DOMAIN.replace(old, new, 1))
    assert what in caught.value.what
    assert caught.value.line == line
    assert str(caught.value.path).endswith("domain.pddl")


BROKEN_PROBLEMS = [
    ("(problem evening)", "(domain evening)", 1, "this is a domain file, expected a problem"),
    ("(:domain", "(:predicates", 2, "unknown section :predicates"),
    ("red - cup", "red - mug", 3, "red has the unknown type 'mug'"),
    ("red - cup", "red - (either cup plate)", 3, "red needs one type"),
    ("red - cup", "red - cup red - plate", 3, "red is a cup and a plate"),
    ("red - cup", "red - cup sink - cup", 3, "sink is a cup here and a object in the domain"),
    ("red - cup", "red -cup", 3, "expected a name, got -cup"),
    ("red - cup", "(red) - cup", 3, "expected a name"),
    ("red - cup\n    blue - plate", "red blue -", 3, "expected a type after '-', got nothing"),
    ("(:init", "(:initial", 5, "unknown section :initial"),
    ("(:goal", "(:init)\n (:goal", 8, "a second :init section"),
    ("(on red sink)", "(under red sink)", 6, "there is no predicate 'under'"),
    ("(on red sink)", "(on red)", 6, "on takes 2 arguments, got 1"),
    ("(on red sink)", "(on green sink)", 6, "there is no object 'green'"),
    ("(on red sink)", "(on ?x sink)", 6, "the variable ?x is not bound"),
    ("(on red sink)", "done", 5, "expected an atom such as"),
    ("(on red sink)", "()", 5, "expected an atom such as"),
    ("(on red sink)", "(= (cost) 3)", 6, "not supported: numeric fluents"),
    ("(on red sink)", "(not (under red))", 6, "there is no predicate 'under'"),
    ("(on red sink)", "(oneof (done) (under red))", 6, "there is no predicate 'under'"),
    ("(on red sink)", "(oneof (done))", 6, "expected two atoms or more, of which one is true"),
    ("(on red sink)", "(unknown (done) (done))", 6, "expected one atom"),
    ("(on red sink)", "(unknown (not (done)))", 6, "expected an atom such as"),
    ("(on red sink)", "(unknown red)", 6, "there is no predicate 'unknown'"),
    ("(clean blue)", "(clean green)", 9, "there is no object 'green'"),
    ("(clean blue)", "(preference p (done))", 9, "not supported: preferences"),
    ("(:goal (and", "(:goal (done) (and", 8, "expected one condition as the goal"),
    ("(:goal", "(:constraints (always (done)))\n (:goal", 8, "not supported: trajectory"),
    ("sink))\n  (:goal", "sink)\n  (:goal", 5, "a '(' is never closed"),
]


@pytest.mark.parametrize(("old", "new", "line", "what"), BROKEN_PROBLEMS)
def test_a_broken_problem_is_refused_with_the_line(
    problem_of: ReadProblem, old: str, new: str, line: int, what: str
) -> None:
    assert old in PROBLEM
    with pytest.raises(InputFileError) as caught:
        problem_of(DOMAIN, PROBLEM.replace(old, new, 1))
    assert what in caught.value.what
    assert caught.value.line == line
    assert str(caught.value.path).endswith("problem.pddl")


def test_a_problem_without_an_initial_state_is_refused(problem_of: ReadProblem) -> None:
    start, end = PROBLEM.index("(:init"), PROBLEM.index("(:goal")
    with pytest.raises(InputFileError, match="a problem needs an"):
        problem_of(DOMAIN, PROBLEM[:start] + PROBLEM[end:])


def test_a_text_is_read_as_a_file_of_its_name_would_be(problem_of: ReadProblem) -> None:
    domain = parse_domain(DOMAIN, "kitchen.pddl")
    problem = parse_problem(PROBLEM, domain, "evening.pddl")
    assert problem == problem_of(DOMAIN, PROBLEM)
    assert problem.source == "evening.pddl"
    with pytest.raises(InputFileError) as caught:
        parse_domain("(define\n(domain d) (:action))", "kitchen.pddl")
    assert caught.value.where == "kitchen.pddl:2"


def test_swapped_files_are_recognised(problem_of: ReadProblem) -> None:
    with pytest.raises(InputFileError) as caught:
        problem_of(PROBLEM, DOMAIN)
    assert caught.value.what == "this is a problem file, expected a domain"
    assert caught.value.hint == "are domain and problem swapped?"


@pytest.mark.parametrize("read", [read_domain, lambda path: read_problem(path, EMPTY)])
def test_what_is_no_file_of_text_is_refused(tmp_path: Path, read: Callable[[Path], object]) -> None:
    empty, binary = tmp_path / "empty.pddl", tmp_path / "binary.pddl"
    empty.write_bytes(b"")
    binary.write_bytes(bytes(range(256)))
    for path in (empty, binary, tmp_path, tmp_path / "missing.pddl"):
        with pytest.raises(InputFileError) as caught:
            read(path)
        assert str(path) in str(caught.value)


EMPTY = Domain("empty", {}, {}, {}, ())


def test_deep_conditions_are_read_or_refused_and_never_crash(domain_of: ReadDomain) -> None:
    def read(depth: int) -> Domain:
        deep = "(exists (?x) " * depth + "(done)" + ")" * depth
        return domain_of(DOMAIN.replace("(on ?d sink)", deep))

    assert len(str(read(190))) > 190
    with pytest.raises(InputFileError, match="nested deeper") as caught:
        read(250)
    assert caught.value.line == 11


def test_capitals_inside_names_are_remembered_where_words_end() -> None:
    domain = parse_domain(
        """(define (domain wards) ; aComment tells nothing
          (:predicates (doorOpen ?d) (hasAGVKey) (LOADED) (is-clean ?w))
          (:action openDoor :parameters (?d) :precondition () :effect (doorOpen ?d)))""",
        "text",
    )
    assert domain.humps == {
        "dooropen": "door-open", "hasagvkey": "has-agv-key", "opendoor": "open-door"
    }  # fmt: skip
