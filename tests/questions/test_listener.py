"""What the listener adds up, and that a question is never read by what its things are called."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.questions.missions import TWO_LINES, accepted

from plainspoken.language.network import network
from plainspoken.questions.agreement import UNSURE, settled
from plainspoken.questions.answer import answer_at
from plainspoken.questions.kind import Kind
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.listener import KINDS, ROWS, Listener, listener, meaning_of, rows_of
from plainspoken.questions.moment import Moment, lexicon_of
from plainspoken.questions.question import Question, grammar_of, question_of
from plainspoken.questions.spoken import Role, Spoken, spoken
from plainspoken.world.event import Entry


@pytest.fixture(scope="module")
def words() -> Lexicon:
    return lexicon_of(accepted(TWO_LINES))


def test_names_are_heard_as_things_and_places(words: Lexicon) -> None:
    said = spoken("Have you picked grape 2 at line 1, Rob?", words)
    assert [each.word for each in said] == [
        "have", "you", "picked", "the", "thing", "at", "the", "place", ",", "robot", "?",
    ]  # fmt: skip
    assert Role.DEED in said[2].roles
    assert said[4].roles == said[7].roles == {Role.NAMED}


def test_a_number_that_there_is_not_is_heard_as_a_thing(words: Lexicon) -> None:
    assert [each.word for each in spoken("Is line 9 cleared?", words)][1:3] == ["the", "thing"]
    assert question_of("Is line 9 cleared?", words).referents.objects == ()


def test_what_a_thing_is_called_changes_no_chance(words: Lexicon) -> None:
    one, other = (
        listener().hear(spoken(text, words), grammar_of(text, words)[1])
        for text in ("Why isn't grape 1 picked?", "Why isn't grape 3 picked?")
    )
    assert one == other


def test_scores_are_the_rows_and_the_meaning_added_up(words: Lexicon) -> None:
    draw = np.random.default_rng(0)
    text = "When will you be at line 1?"
    said, shape = spoken(text, words), grammar_of(text, words)[1]
    meaning = meaning_of(said)
    own = Listener(
        draw.normal(0, 0.1, (ROWS, len(KINDS))).astype(np.float32),
        draw.normal(0, 0.01, (len(meaning), len(KINDS))).astype(np.float32),
        draw.normal(0, 1, len(KINDS)).astype(np.float32),
    )
    scores = [
        float(own.bias[k])
        + sum(float(own.table[row, k]) for row in rows_of(said, shape))
        + sum(float(number) * float(own.meaning[i, k]) for i, number in enumerate(meaning))
        for k in range(len(KINDS))
    ]
    total = sum(math.exp(score) for score in scores)
    heard = own.hear(said, shape)
    for k, kind in enumerate(KINDS):
        assert heard[kind] == pytest.approx(math.exp(scores[k]) / total, rel=1e-3)


def test_the_meaning_is_the_mean_and_the_maximum_of_each_layer() -> None:
    layers = network().states(["where", "are", "you"])
    found = meaning_of([Spoken("where"), Spoken("are"), Spoken("you")])
    columns = [
        value
        for rows in layers
        for value in (
            *[sum(row[c] for row in rows) / len(rows) for c in range(rows.shape[1])],
            *[max(row[c] for row in rows) for c in range(rows.shape[1])],
        )
    ]
    assert found == pytest.approx(columns, rel=1e-4, abs=1e-5)


@settings(deadline=None, max_examples=60)
@given(st.text(max_size=200))
def test_any_text_is_of_some_kind(text: str) -> None:
    found = question_of(text, lexicon_of(accepted(TWO_LINES)))
    assert found.kind in Kind


def test_a_text_of_a_thousand_words_is_read(words: Lexicon) -> None:
    assert question_of("why " * 1000, words).kind in Kind


@given(
    st.lists(st.floats(0.001, 1), min_size=len(KINDS), max_size=len(KINDS)),
    st.sampled_from(KINDS),
)
def test_the_word_of_the_rules_never_makes_their_kind_less_likely(
    weights: list[float], ruled: Kind
) -> None:
    chances = {kind: weight / sum(weights) for kind, weight in zip(KINDS, weights, strict=True)}
    found = settled(ruled, chances)
    assert found.other is not found.kind
    assert found.chance <= 1.000001
    if max(chances, key=chances.__getitem__) is ruled:
        assert found.kind is ruled
    else:
        assert found.kind is ruled or chances[found.kind] > chances[ruled]


def test_what_is_not_clear_is_asked_back() -> None:
    even = dict.fromkeys(KINDS, 1 / len(KINDS))
    assert settled(Kind.WHEN, even).chance < UNSURE
    moment = Moment([Entry(0, "", 0, accepted(TWO_LINES))])
    question = question_of("Why?", moment.lexicon)
    doubted = Question(Kind.WHEN, "hm", question.referents, other=Kind.COMMAND)
    found = answer_at(doubted, moment)
    assert found.text == (
        "I'm not sure what you mean. Do you want to ask when something is or was or have me do "
        "something?"
    )
    assert not found.claims
