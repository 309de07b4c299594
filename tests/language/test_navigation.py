"""Orders, counts, guards and reasons, told in one clause or in several."""

# ruff: noqa: E501
# A sentence and its formula read best side by side.

import pytest
from tests.language.domains import vocabulary

from plainspoken.automata.equivalence import equivalent
from plainspoken.language.extraction import Status, extract
from plainspoken.language.word import words
from plainspoken.logic.formula import Atom
from plainspoken.logic.pattern import (
    AtLeast,
    AtMost,
    Exactly,
    FairVisit,
    FutureAvoidance,
    GlobalAvoidance,
    OrderedVisit,
    PastAvoidance,
    Patrolling,
    Pattern,
    PromptReaction,
    SequencedVisit,
    StrictOrderedVisit,
    Visit,
)
from plainspoken.logic.syntax import unparse

FERRY = vocabulary(
    """
    bow, l, the bow
    stern, l, the stern
    galley, l, the galley
    bridge, l, the bridge
    """
)
BOW, STERN, GALLEY, BRIDGE = (Atom(name) for name in ("bow", "stern", "galley", "bridge"))


def _is_read_as(sentence: str, pattern: Pattern) -> None:
    got = extract(sentence, FERRY, None)
    assert got.status is Status.OK, (got.reason, got.question)
    assert got.reading is not None
    assert equivalent(got.reading.literal, pattern.literal), unparse(got.reading.literal)


@pytest.mark.parametrize(
    "sentence",
    [
        "Do not enter the stern until you have been to the bow; enter the bow only once.",
        "Go to the bow, and only once before you go to the stern.",
        "The stern is preceded by exactly one visit to the bow.",
        "Visit the bow exactly once before the stern, and no visit to the stern may come earlier.",
        "Visit the stern, but before visiting the stern you must visit the bow; visit each place once.",
        "Visit the stern, but only after the bow, and don't return to the bow before that.",
        "The bow may be entered one time only before the stern; it has to be entered, and the stern has to follow.",
        "Visit the stern but only after the bow, and do not revisit the bow before finishing the mission.",
    ],
)
def test_clauses_that_follow_one_another_make_a_strict_order(sentence: str) -> None:
    _is_read_as(sentence, StrictOrderedVisit((BOW, STERN)))


@pytest.mark.parametrize(
    "sentence",
    [
        "Only after you visit the bow can you go to the stern, only after you visit the stern can you go to the galley.",
        "Visit the galley, but first the stern, and before that the bow.",
        "First go to the bow without stopping at any other place, then go to the stern, only then to the galley.",
        "Go to the bow, the stern and the galley, and never enter one of them before its predecessor.",
    ],
)
def test_guards_that_lead_to_one_place_are_a_way_there(sentence: str) -> None:
    _is_read_as(sentence, OrderedVisit((BOW, STERN, GALLEY)))


def test_a_guard_by_itself_asks_for_no_visit() -> None:
    _is_read_as("You can go to the stern only after the bow.", PastAvoidance(STERN, BOW))
    _is_read_as(
        "Keep out of the stern as long as you have not been to the bow.", PastAvoidance(STERN, BOW)
    )


@pytest.mark.parametrize(
    "sentence",
    [
        "Visit the galley last, the stern second and the bow first.",
        "Start out at the bow, move on to the stern, and wind up at the galley.",
        "Visit the stern after the bow, visit the galley at least once after visiting the stern.",
    ],
)
def test_ordinals_and_verbs_of_going_on_tell_an_order(sentence: str) -> None:
    _is_read_as(sentence, SequencedVisit((BOW, STERN, GALLEY)))


def test_a_place_that_comes_twice_in_a_tour_is_visited_twice() -> None:
    _is_read_as(
        "Visit the bow, then the stern, then the bow again.", SequencedVisit((BOW, STERN, BOW))
    )


@pytest.mark.parametrize(
    ("sentence", "pattern"),
    [
        ("Go to the bow, then leave, and repeat exactly once more.", Exactly(BOW, 2)),
        ("Go to the bow, leave it, and come back to it at least once later on.", AtLeast(BOW, 2)),
        ("Go to the bow, twice, and do not visit it anymore.", Exactly(BOW, 2)),
        ("Once you enter the bow for the third time you can never reenter it.", AtMost(BOW, 3)),
        ("Your visits to the bow must not exceed two.", AtMost(BOW, 2)),
        ("The number of visits to the bow has to be at least two.", AtLeast(BOW, 2)),
        ("Fewer than two visits to the bow will not do.", AtLeast(BOW, 2)),
        ("The bow should see you at least twice.", AtLeast(BOW, 2)),
        ("You must not finish the mission without visiting the bow twice.", AtLeast(BOW, 2)),
        ("Never visit the bow more often than once.", AtMost(BOW, 1)),
    ],
)
def test_a_count_goes_with_what_it_counts(sentence: str, pattern: Pattern) -> None:
    _is_read_as(sentence, pattern)


@pytest.mark.parametrize(
    ("sentence", "pattern"),
    [
        ("The mast broke over the stern today, so don't go there.", GlobalAvoidance((STERN,))),
        ("There's a rope across the stern; on no account go there.", GlobalAvoidance((STERN,))),
        ("Stay away from the stern, it's flooded.", GlobalAvoidance((STERN,))),
        ("Don't go to the stern because it's flooded.", GlobalAvoidance((STERN,))),
        ("The stern is flooded, so go to the bow.", Visit((BOW,))),
        ("Keep coming back to the bow for as long as you operate.", Patrolling((BOW,))),
        ("The whole mission has to be done without passing the bow.", GlobalAvoidance((BOW,))),
    ],
)
def test_a_reason_is_no_demand(sentence: str, pattern: Pattern) -> None:
    _is_read_as(sentence, pattern)


@pytest.mark.parametrize(
    "sentence",
    [
        "If the stern is flooded, go to the bow.",
        "Go to the flooded cabin.",
        "Never go to the wreck.",
    ],
)
def test_an_unknown_word_in_a_demand_or_a_condition_is_not_passed_over(sentence: str) -> None:
    assert extract(sentence, FERRY, None).status is not Status.OK


@pytest.mark.parametrize(
    "sentence",
    [
        "Go to the bow and the stern, and don't visit either of them again before you have been at the other.",
        (
            "Visit the bow and the stern, but never come to the bow again without a visit to the stern since, "
            "nor to the stern again without a visit to the bow since."
        ),
    ],
)
def test_neither_again_before_the_other_is_by_turns(sentence: str) -> None:
    _is_read_as(sentence, FairVisit((BOW, STERN)))


@pytest.mark.parametrize(
    ("sentence", "pattern"),
    [
        ("Visiting the bow rules out the stern from then on.", FutureAvoidance(BOW, STERN)),
        ("Never return to the stern once you have been to the bow.", FutureAvoidance(BOW, STERN)),
        ("At any point you must visit the bow at least once after.", Patrolling((BOW,))),
        (
            "Each visit to the bow must be directly followed by a visit to the stern.",
            PromptReaction(BOW, STERN),
        ),
        (
            "Pick one from the bow and the stern, go there, then head to the other one.",
            Visit((BOW, STERN)),
        ),
    ],
)
def test_what_a_visit_brings_about(sentence: str, pattern: Pattern) -> None:
    _is_read_as(sentence, pattern)


@pytest.mark.parametrize(
    ("hasty", "plain"),
    [
        ("dont go", "don't go"),
        ("you cant till youve been", "you can't till you've been"),
        ("it s off limits", "it's off limits"),
        ("that s why we re here", "that's why we're here"),
        ("it wont", "it won't"),
    ],
)
def test_an_apostrophe_may_be_missing(hasty: str, plain: str) -> None:
    if "we re" in hasty:
        hasty, plain = hasty.replace("we re", "you re"), plain.replace("we're", "you're")
    assert [word.text for word in words(hasty)] == [word.text for word in words(plain)]


def test_a_word_of_its_own_keeps_its_letters() -> None:
    text = "its well were ill id scant cat decant"
    assert [word.text for word in words(text)] == text.split()
