"""A result becomes a state: by the domain's outcomes, by what is told, by what is seen."""

import pytest
from tests.mission.small_vineyard import PROBLEM

from plainspoken.mission.activity import Condition, Literal, Retry
from plainspoken.mission.repertoire import Outcome, amended, arguments_of, landed
from plainspoken.mission.robot import Failed, Succeeded
from plainspoken.mission.service import Fields
from plainspoken.world.scene import successors

AT_LINE = amended(
    PROBLEM.initial, [Literal("robot-at rob wh", wanted=False), Literal("robot-at rob l0")]
)
CHECK = "check-grape rob g0 l0"
CHECKED = tuple(
    Outcome({"grape": kind}, (Literal(f"{kind} g0"),)) for kind in ("ripe", "unripe", "unknown")
)


def literals(*texts: str) -> tuple[Literal, ...]:
    return tuple(map(Literal.of, texts))


def test_an_action_with_one_outcome_needs_no_result() -> None:
    after = landed(PROBLEM, PROBLEM.initial, "move rob wh l0", outcomes=(), result={})
    assert after == Succeeded(AT_LINE)


@pytest.mark.parametrize("kind", ["ripe", "unripe", "unknown"])
def test_a_result_picks_the_outcome_of_the_domain(kind: str) -> None:
    after = landed(PROBLEM, AT_LINE, CHECK, outcomes=CHECKED, result={"grape": kind})
    assert isinstance(after, Succeeded)
    assert f"{kind} g0" in after.state
    assert "unchecked g0" not in after.state, "the rest of the outcome comes with it"
    assert after.state in successors(PROBLEM, AT_LINE, CHECK)


@pytest.mark.parametrize("result", [{"grape": "blue"}, {}])
def test_a_result_that_is_none_of_the_outcomes_is_a_failure_that_shows_it(result: Fields) -> None:
    after = landed(PROBLEM, AT_LINE, CHECK, outcomes=CHECKED, result=result)
    assert isinstance(after, Failed)
    assert str(result) in after.reason
    assert after.state == AT_LINE


def test_without_a_word_of_the_outcome_none_is_made_up() -> None:
    after = landed(PROBLEM, AT_LINE, CHECK, outcomes=(), result={})
    assert isinstance(after, Failed)
    assert "ripe g0" in after.reason
    assert after.state == AT_LINE


def test_what_is_seen_tells_outcomes_apart() -> None:
    seen = literals("ripe g0", "not unripe g0", "not unknown g0")
    after = landed(PROBLEM, AT_LINE, CHECK, outcomes=(), result={}, seen=seen)
    assert isinstance(after, Succeeded)
    assert after.state in successors(PROBLEM, AT_LINE, CHECK)
    assert "ripe g0" in after.state


def test_what_somebody_else_changed_meanwhile_is_seen_and_the_action_still_counts() -> None:
    seen = literals("full b")
    after = landed(PROBLEM, PROBLEM.initial, "move rob wh l0", outcomes=(), result={}, seen=seen)
    assert after == Succeeded(AT_LINE | {"full b"})


def test_an_outcome_that_the_domain_does_not_have_is_taken_as_it_is_told() -> None:
    strange = (Outcome({}, literals("robot-at rob wh")),)
    after = landed(PROBLEM, PROBLEM.initial, "move rob wh l0", outcomes=strange, result={})
    assert after == Succeeded(PROBLEM.initial)


def test_arguments_have_the_names_of_the_domain_without_question_marks() -> None:
    assert arguments_of(PROBLEM, CHECK) == {"h": "rob", "g": "g0", "l": "l0"}


def test_pauses_grow_up_to_the_longest() -> None:
    retry = Retry(Condition(()), 5, pause=1.0, growth=3.0, longest=10.0)
    assert [retry.pause_after(n) for n in (1, 2, 3, 4)] == [1.0, 3.0, 9.0, 10.0]
