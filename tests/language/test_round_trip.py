"""What is said back can be read again: English of a formula, extracted, is the formula."""

from collections.abc import Callable
from dataclasses import fields
from itertools import combinations

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from tests.language.domains import DOMAINS

from plainspoken.automata.equivalence import equivalent, satisfiable
from plainspoken.language.extraction import Status, extract
from plainspoken.logic.english import say
from plainspoken.logic.formula import (
    Atom,
    Constant,
    Formula,
    Not,
    conjunction,
    disjunction,
)
from plainspoken.logic.formula import atoms as names_of
from plainspoken.logic.pattern import (
    AtLeast,
    AtMost,
    BoundDelay,
    BoundReaction,
    DelayedReaction,
    Exactly,
    FairVisit,
    FutureAvoidance,
    GlobalAvoidance,
    InstantaneousReaction,
    Maintenance,
    OrderedVisit,
    PastAvoidance,
    Patrolling,
    Pattern,
    PromptPrecedence,
    PromptReaction,
    Remaining,
    SequencedVisit,
    StrictOrderedVisit,
    Visit,
    Wait,
)
from plainspoken.logic.syntax import unparse

VOCABULARY = DOMAINS["vineyard"]
NAMES = sorted(VOCABULARY.landmarks)
ACTIONS = frozenset(name for name in NAMES if not VOCABULARY.persists(name))

atoms = st.sampled_from([name for name in NAMES if name != "unripe0"]).map(Atom)
literals = st.one_of(atoms, atoms, atoms.map(Not))
situations = st.one_of(
    literals,
    literals,
    st.tuples(literals, literals)
    .filter(lambda pair: not names_of(pair[0]) & names_of(pair[1]))
    .map(lambda pair: conjunction(*pair)),
    st.tuples(literals, literals)
    .filter(lambda pair: not names_of(pair[0]) & names_of(pair[1]))
    .map(lambda pair: disjunction(*pair)),
)
places = st.sampled_from(["l0", "l1", "l2", "l3", "wh"]).map(Atom)


def persists(trigger: Formula) -> bool:
    match trigger:
        case Atom(name):
            return name not in ACTIONS
        case _:
            return all(
                not (isinstance(part, Atom) and part.name in ACTIONS)
                for part in getattr(trigger, "operands", ())
            )


def operands_of(pattern: Pattern) -> list[Formula]:
    """The operands of a pattern that speaks of two things; its places, where they are a list."""
    values = [getattr(pattern, each.name) for each in fields(pattern)]
    flat = [part for value in values for part in (value if isinstance(value, tuple) else (value,))]
    return [part for part in flat if not isinstance(part, (bool, int, Constant))]


def pair_of(
    kind: Callable[..., Pattern], first: st.SearchStrategy[Formula] = situations
) -> st.SearchStrategy[Pattern]:
    return st.builds(kind, first, atoms)


def prompt(kind: Callable[..., Pattern]) -> st.SearchStrategy[Pattern]:
    return st.builds(lambda a, b: kind(a, b, persists(a)), situations, atoms)


several = st.lists(places, min_size=2, max_size=4, unique=True).map(tuple)
alone = situations.map(lambda one: (one,))
PATTERNS: dict[str, st.SearchStrategy[Pattern]] = {
    "visit": st.one_of(alone, several).map(Visit),
    "sequenced visit": st.lists(atoms, min_size=2, max_size=4, unique=True).map(
        lambda found: SequencedVisit(tuple(found))
    ),
    "ordered visit": several.map(OrderedVisit),
    "strict ordered visit": several.map(StrictOrderedVisit),
    "fair visit": several.map(FairVisit),
    "global avoidance": atoms.map(lambda one: GlobalAvoidance((one,))),
    "maintenance": alone.map(Maintenance),
    "remaining": alone.map(Remaining),
    "patrolling": atoms.map(lambda one: Patrolling((one,))),
    "past avoidance": st.builds(PastAvoidance, atoms, situations, st.booleans()),
    "future avoidance": pair_of(FutureAvoidance),
    "wait": st.builds(Wait, atoms, situations),
    "at least": st.builds(AtLeast, places, st.integers(2, 4)),
    "at most": st.builds(AtMost, places, st.integers(1, 4)),
    "exactly": st.builds(Exactly, places, st.integers(1, 4)),
    "instantaneous reaction": st.builds(InstantaneousReaction, situations, literals),
    "delayed reaction": pair_of(DelayedReaction),
    "prompt reaction": prompt(PromptReaction),
    "prompt precedence": prompt(PromptPrecedence),
    "bound reaction": pair_of(BoundReaction),
    "bound delay": prompt(BoundDelay),
}


@pytest.mark.parametrize("name", PATTERNS)
@settings(max_examples=40)
@given(data=st.data())
def test_a_pattern_said_in_english_reads_back_as_itself(name: str, data: st.DataObject) -> None:
    pattern = data.draw(PATTERNS[name])
    formula = pattern.executable
    assume(all(not names_of(a) & names_of(b) for a, b in combinations(operands_of(pattern), 2)))
    if not satisfiable(formula):
        return
    english = say(formula, VOCABULARY.landmarks)
    extraction = extract(english, VOCABULARY)
    assert extraction.status is Status.OK, (english, extraction.reason or extraction.question)
    assert extraction.formula is not None
    assert equivalent(extraction.formula, formula), (english, unparse(extraction.formula))
