"""Reports in words against the facts that they state, and against nonsense."""

from __future__ import annotations

from pathlib import Path

import pytest
from benchmarks.reports import FOLDER, Sentence, is_right, lexicon_for, sentences, state_for
from hypothesis import given, settings
from hypothesis import strategies as st

from plainspoken.language.extracted import Status
from plainspoken.questions.report import Report, settled_on, understood

DOMAINS = ("vineyard", "warehouse", "kitchen", "clinic")
ALL = [sentence for name in DOMAINS for sentence in sentences(name)]


def report(name: str, text: str, *also: str) -> Report:
    return understood(text, lexicon_for(name), state_for(name, also))


def facts(found: Report) -> set[str]:
    return {atom if holds else f"not {atom}" for atom, holds in found.said}


def test_nine_of_ten_reports_are_understood() -> None:
    right = [is_right(each) for each in ALL]
    assert sum(right) / len(right) >= 0.9, [e.text for e in ALL if not is_right(e)]


@pytest.mark.parametrize("sentence", ALL, ids=lambda each: each.id)
def test_what_is_taken_for_certain_is_what_was_said(sentence: Sentence) -> None:
    found = report(sentence.domain, sentence.text, *sentence.state)
    if found.status is Status.OK:
        assert sentence.facts is not None
        assert facts(found) == set(sentence.facts)


def test_what_is_said_of_a_thing_says_what_else_it_is_not() -> None:
    found = report("warehouse", "the crate is on the cart")
    assert found.added == {"on-cart crate"}
    assert "on-shelf crate aisle-1" in found.deleted


def test_a_person_who_harvests_a_grape_does_not_fill_the_robots_hand() -> None:
    found = report("vineyard", "I harvested grape 1")
    assert found.added == {"picked g1", "ripe g1"}
    assert "hand-empty rob" not in found.deleted


def test_a_cleared_line_says_nothing_of_its_grapes() -> None:
    found = report("vineyard", "I cleared line 2 myself")
    assert found.english == "line 2 is cleared"
    assert (found.added, found.deleted) == ({"cleared l2"}, set())


def test_nothing_is_made_up_where_several_things_may_be_so_instead() -> None:
    found = report("kitchen", "I chopped the onion")
    assert "in-pot onion" not in found.added
    assert "kept-in onion pantry" not in found.deleted


def test_a_deed_that_may_turn_out_in_several_ways_is_asked_about() -> None:
    found = report("vineyard", "I checked grape 1")
    assert found.status is Status.CLARIFY
    assert [each.answer for each in found.choices] == [
        "grape 1 is ripe",
        "grape 1 is unripe",
        "the state of grape 1 is unknown",
    ]
    answered = settled_on(found, found.choices[1], lexicon_for("vineyard"))
    assert answered.status is Status.OK
    assert answered.added == {"unripe g1"}
    assert answered.deleted >= {"unchecked g1", "ripe g1", "unknown g1"}


def test_what_is_no_more_so_is_asked_about_where_something_takes_its_place() -> None:
    found = report("vineyard", "You are not at line 0")
    assert found.status is Status.CLARIFY
    assert "I'm at line 1" in [each.answer for each in found.choices]


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("Grape 1 is ripe and unripe", "never so together"),
        ("Is line 2 cleared?", "question"),
        ("Clear line 2", "asks for something"),
        ("Maybe line 2 is cleared", "not seem sure"),
        ("I will clear line 2", "yet to come"),
        ("the box was full", "say what is so now"),
        ("The weather is lovely", "nothing that I keep track of"),
        ("line 9 is cleared", "nothing that I keep track of"),
        ("", "Nothing is said"),
        ("x" * 100_000, "too long"),
    ],
)
def test_what_is_no_report_is_refused_with_a_reason(text: str, reason: str) -> None:
    found = report("vineyard", text)
    assert found.status is Status.REJECT
    assert reason in str(found.reason)
    assert (found.added, found.deleted) == (set(), set())


SAID = (
    "line 2|grape 1|all lines|the box|it|is|isn't|I|you|cleared|harvested|ripe|unripe|full|and|but"
    "|,|.|not|both|myself|the robot|put|in|at|DROP TABLE entry|(cleared l2)|\u202e|🍇|<g1>"
)
WORDS = st.sampled_from(SAID.split("|"))


@settings(max_examples=60, deadline=None)
@given(st.lists(WORDS, max_size=9).map(" ".join) | st.text(max_size=60))
def test_whatever_is_said_nothing_comes_of_it_but_facts_that_can_change(text: str) -> None:
    lexicon = lexicon_for("vineyard")
    found = report("vineyard", text)
    for atom in found.added | found.deleted:
        predicate, *arguments = atom.split()
        assert predicate in lexicon.problem.changing_predicates
        assert set(arguments) <= set(lexicon.problem.objects)
    assert not found.added & found.deleted
    assert (found.status is Status.OK) == (found.facts is not None)


def test_the_corpus_names_each_sentence_once() -> None:
    assert len({each.id for each in ALL}) == len(ALL) >= 60
    assert Path(FOLDER).is_dir()
