"""Patterns are written as tokens and read back without loss."""

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from tests.strategies import formulas

from plainspoken.automata.equivalence import equivalent
from plainspoken.language.notation import (
    TOKENS,
    NotationError,
    executable,
    literal,
    read,
    written,
)
from plainspoken.logic.formula import (
    Atom,
    Formula,
    WeakNext,
    WeakUntil,
    conjunction,
    subformulas,
)
from plainspoken.logic.pattern import (
    AtMost,
    Choice,
    DelayedReaction,
    FairVisit,
    OrderedVisit,
    PastAvoidance,
    Pattern,
    PromptReaction,
    Visit,
)
from plainspoken.logic.syntax import parse

A, B, C = map(Atom, "abc")
PATTERNS = (
    Visit((A, B)),
    OrderedVisit((A, B, C)),
    FairVisit((A, B)),
    PastAvoidance(A, B),
    PastAvoidance(A, B, demanded=True),
    DelayedReaction(A, parse("b | c")),
    PromptReaction(A, B),
    PromptReaction(A, B, persists=False),
    AtMost(A, 2),
    Choice(((Visit((A,)),), (Visit((B,)), DelayedReaction(A, C)))),
)


@pytest.mark.parametrize("pattern", PATTERNS, ids=str)
def test_a_pattern_comes_back_in_both_readings(pattern: Pattern) -> None:
    tokens = written(pattern.literal, pattern.executable)
    persists = getattr(pattern, "persists", True)
    back = read(tokens, lambda _: persists)
    assert equivalent(conjunction(*map(literal, back)), pattern.literal)
    assert equivalent(conjunction(*map(executable, back)), pattern.executable)


@given(formulas())
def test_any_formula_comes_back_as_what_it_says(formula: Formula) -> None:
    # The weak operators tell an executable reading, and what is written is the literal one.
    assume(not any(isinstance(each, (WeakUntil, WeakNext)) for each in subformulas(formula)))
    try:
        tokens = written(formula, formula)
    except NotationError:
        return  # constants have no notation: nobody asks for "true"
    back = read(tokens, lambda _: True)
    assert equivalent(conjunction(*map(literal, back)), formula)


@given(st.lists(st.sampled_from((*TOKENS, "a", "b")), max_size=12))
def test_any_row_of_tokens_is_read_or_refused(tokens: list[str]) -> None:
    try:
        read(tokens, lambda _: True)
    except NotationError:
        return


def test_it_is_written_as_the_page_says() -> None:
    text = "(!b U a) & F a"
    assert written(parse(text), parse(text)) == (
        "past_avoidance", "demanded", "b", "a", ")", "visit", "a", ")",
    )  # fmt: skip
