import pytest

from plainspoken.language.extraction import Status, extract
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.own_name import own_name
from plainspoken.logic.syntax import unparse
from plainspoken.world.landmark import Landmark, Landmarks, LandmarkType


def places(*ids: str) -> Landmarks:
    """Places called by the last word of their ids."""
    return {id: Landmark(id, f"the {id.split('_')[-1]}", LandmarkType.LOCATION) for id in ids}


STUDIO = places("at_zora_foyer", "at_zora_attic", "at_zora_lift")


@pytest.mark.parametrize(
    ("ids", "name"),
    [
        (("at_zora_foyer", "at_zora_attic"), "zora"),
        (("robot_at_zora_foyer", "robot_at_zora_side_door"), "zora"),
        (("robot_at_flora_foyer", "robot_at_flora_attic"), "flora"),  # whose place it is
        (("robot_at_ann_foyer", "robot_at_bob_attic"), None),
        (("foyer", "attic"), None),
        (("room_foyer", "room_attic"), None),  # an English word is no name
        (("at_r2_foyer", "at_r2_attic"), None),
        (("at_zora_foyer",), None),  # nothing to compare it with
    ],
)
def test_a_name_is_what_the_ids_of_all_places_have_before_the_place(
    ids: tuple[str, ...], name: str | None
) -> None:
    assert own_name(places(*ids)) == name


@pytest.mark.parametrize(
    ("sentence", "formula"),
    [
        ("Zora should drop by the foyer.", "F at_zora_foyer"),
        ("hey zora, go to the attic, then the lift", "F(at_zora_attic & F at_zora_lift)"),
        ("Zora must never be in the lift.", "G !at_zora_lift"),
        ("Have Zora visit the attic.", "F at_zora_attic"),
    ],
)
def test_a_robot_is_spoken_to_and_of_by_its_name(sentence: str, formula: str) -> None:
    extraction = extract(sentence, Vocabulary.of(STUDIO), None)
    assert extraction.status is Status.OK
    assert extraction.formula is not None
    assert unparse(extraction.formula) == formula


@pytest.mark.parametrize("sentence", ["Visit the foyer and", "Go to the attic and then"])
def test_a_sentence_that_is_broken_off_is_refused(sentence: str) -> None:
    extraction = extract(sentence, Vocabulary.of(STUDIO), None)
    assert extraction.status is Status.REJECT
    assert "what comes after" in (extraction.reason or "")
