"""How likely a reading is right is said, and what is too unlikely is asked about."""

import pytest
from tests.language.domains import DOMAINS

from plainspoken.language.confidence import WEIGHTS, confidence, features, is_senseless
from plainspoken.language.extraction import Status, extract
from plainspoken.language.sentence import Sentence
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
    found = features(sentence, meaning)
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


@pytest.mark.parametrize("place", ["in the lobby", "at the lobby", "on ward 1", "near the lobby"])
def test_a_verb_that_nobody_knows_leads_to_no_place_where_it_is_done(place: str) -> None:
    extraction = extract(f"Juggle {place}.", HOSPITAL)
    assert extraction.status is Status.REJECT
    assert "Juggle" in (extraction.reason or "")


def test_a_verb_that_nobody_knows_may_lead_to_a_place() -> None:
    assert extract("Amble over to the lobby.", HOSPITAL).status is Status.OK
