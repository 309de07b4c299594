import pytest

from plainspoken.language.extraction import extract
from plainspoken.language.grounding import Vocabulary
from plainspoken.logic.syntax import unparse
from plainspoken.world.landmark import Landmark, LandmarkType

MUSEUM = Vocabulary.of(
    {
        id: Landmark(id, f"the {id}", LandmarkType.LOCATION)
        for id in ("foyer", "attic", "lift", "shop")
    }
)


@pytest.mark.parametrize(
    ("sentence", "formula"),
    [
        ("Go to the foyer or the attic, then the lift.", "F((foyer | attic) & F lift)"),
        ("First either the foyer or the attic, then the lift.", "F((foyer | attic) & F lift)"),
        ("Visit the shop, then the foyer or the attic.", "F(shop & F(foyer | attic))"),
        (
            "visit the shop then go to the foyer or the attic then go to the lift",
            "F(shop & F((foyer | attic) & F lift))",
        ),
        (
            "The foyer or the attic, then the lift, then the shop.",
            "F((foyer | attic) & F(lift & F shop))",
        ),
        ("Visit the foyer, the attic or the lift.", "F(foyer | attic | lift)"),
    ],
)
def test_a_choice_is_one_stage_of_an_order(sentence: str, formula: str) -> None:
    extraction = extract(sentence, MUSEUM)
    assert extraction.formula is not None, extraction.reason or extraction.question
    assert unparse(extraction.formula) == formula
