"""How likely a reading is right is said, and what is too unlikely is asked about."""

import pytest
from tests.language.domains import DOMAINS

from plainspoken.language.confidence import WEIGHTS, confidence, features, is_senseless, reads_back
from plainspoken.language.extraction import Status, extract
from plainspoken.language.sentence import Sentence, reading_of
from plainspoken.logic.formula import Atom
from plainspoken.logic.pattern import DelayedReaction, PastAvoidance, Visit

HOSPITAL = DOMAINS["hospital"]
A, B = Atom("w1"), Atom("w2")


def test_an_accepted_sentence_says_how_sure_it_is() -> None:
    extraction = extract("Visit ward 1.", HOSPITAL)
    assert extraction.confidence is not None
    assert 0.5 < extraction.confidence <= 1
    assert extraction.to_json()["confidence"] == extraction.confidence


def test_a_roundabout_sentence_is_less_sure_than_a_plain_one() -> None:
    plain = extract("Visit ward 1, then ward 2.", HOSPITAL)
    roundabout = extract(
        "Well, please do be so kind and head over to ward 1, and when the floor is wet and the "
        "battery is low it should then call a nurse unless the fire alarm is on, before ward 2.",
        HOSPITAL,
    )
    assert plain.confidence is not None
    assert roundabout.confidence is None or roundabout.confidence < plain.confidence


def test_every_feature_has_a_weight() -> None:
    sentence = Sentence.of("Visit ward 1.", HOSPITAL).parsed()
    meaning = sentence.meaning()
    found = features(sentence, meaning, reading_of(meaning.patterns, HOSPITAL, 1.0))
    assert set(found) == set(WEIGHTS)
    assert 0 <= confidence(found) <= 1


@pytest.mark.parametrize(
    ("pattern", "senseless"),
    [
        (PastAvoidance(A, A), True),
        (PastAvoidance(A, B), False),
        (DelayedReaction(A, A), True),
        (Visit((A,)), False),
    ],
)
def test_a_pattern_that_relates_a_thing_to_itself_makes_no_sense(
    pattern: PastAvoidance | DelayedReaction | Visit, *, senseless: bool
) -> None:
    assert is_senseless(pattern) is senseless


def test_a_verb_passed_over_for_a_place_is_confirmed() -> None:
    extraction = extract("Juggle in the lobby.", HOSPITAL)
    assert extraction.status is Status.CLARIFY
    assert extraction.question == 'Do you mean: "Visit the lobby."?'
    assert [each.answer for each in extraction.alternatives] == ["yes"]


def test_english_that_is_read_in_again_as_something_else_is_noticed() -> None:
    sentence = Sentence.of("Visit ward 1.", HOSPITAL).parsed()
    right = reading_of(sentence.meaning().patterns, HOSPITAL, 1.0)
    assert reads_back(right, sentence)
    wrong = reading_of((Visit((B,)),), HOSPITAL, 1.0, english="Visit ward 1.")
    assert not reads_back(wrong, sentence)
