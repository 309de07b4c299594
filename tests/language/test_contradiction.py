"""A mission that cannot be met is refused with the smallest part of it that clashes."""

import pytest
from tests.language.domains import DOMAINS

from plainspoken.language.contradiction import core
from plainspoken.language.extraction import Status, extract
from plainspoken.language.grounding import Vocabulary
from plainspoken.world.landmark import Landmark, LandmarkType

HOSPITAL = DOMAINS["hospital"]
YARD = Vocabulary.of(
    {
        f"robot_at_rob_{place}": Landmark(
            f"robot_at_rob_{place}", f"the {place}", LandmarkType.LOCATION
        )
        for place in ("shed", "well", "barn")
    }
)


@pytest.mark.parametrize(
    ("sentence", "reason"),
    [
        (
            "Visit ward 1, call a nurse, and never enter ward 1.",
            (
                'These two cannot both be: "Visit ward 1." and "never enter ward 1" '
                "(Never visit ward 1.)"
            ),
        ),
        (
            "If the floor is wet, call a nurse. Make sure the floor is wet. Never call a nurse.",
            (
                'These cannot all be: "If the floor is wet, call a nurse" '
                "(Whenever the floor is wet, eventually call a nurse.), "
                '"Make sure the floor is wet" (Make sure that the floor is wet at some point.) '
                'and "Never call a nurse."'
            ),
        ),
        (
            "Visit the lab exactly once and at least twice.",
            (
                'These two cannot both be: "Visit the laboratory exactly once." and "Visit the '
                'laboratory at least twice."'
            ),
        ),
    ],
)
def test_the_clauses_that_clash_are_named(sentence: str, reason: str) -> None:
    extraction = extract(sentence, HOSPITAL)
    assert extraction.status is Status.REJECT
    assert extraction.reason == reason


def test_a_round_of_orders_clashes_where_a_robot_is_at_one_place_at_a_time() -> None:
    extraction = extract(
        "Visit the shed before the well. Visit the well before the barn. "
        "Visit the barn before the shed.",
        YARD,
    )
    assert extraction.status is Status.REJECT
    assert (extraction.reason or "").startswith("These cannot all be")


def test_to_patrol_two_places_is_a_mission_with_a_note() -> None:
    extraction = extract("Patrol the shed and the well.", YARD)
    assert extraction.status is Status.OK
    assert "two places" in (extraction.note or "")


def test_a_core_has_nothing_to_spare() -> None:
    clashing = {1, 3, 4}
    assert core(6, lambda some: not clashing <= set(some)) == (1, 3, 4)
