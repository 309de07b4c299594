"""What a speech recogniser gets wrong is asked about, and never corrected in silence."""

import pytest
from tests.language.domains import DOMAINS

from plainspoken.language.extraction import Status, extract
from plainspoken.language.slip import likeness, sound

HOSPITAL = DOMAINS["hospital"]
VINEYARD = DOMAINS["vineyard"]


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("rose", "rows"),
        ("word", "ward"),
        ("farmacy", "pharmacy"),
        ("isle", "aisle"),
        ("nite", "night"),
    ],
)
def test_what_is_pronounced_alike_sounds_alike(one: str, other: str) -> None:
    assert sound(one) == sound(other)
    assert likeness(one, other) > 0.8


@pytest.mark.parametrize(("one", "other"), [("moon", "lobby"), ("dance", "ward"), ("fetch", "lab")])
def test_what_is_pronounced_differently_does_not(one: str, other: str) -> None:
    assert likeness(one, other) < 0.6


@pytest.mark.parametrize(
    ("sentence", "question", "english"),
    [
        ("Go to word 2.", 'By "word 2", do you mean "ward 2"?', "Visit ward 2."),
        ("Go to the farmacy.", 'By "farmacy", do you mean "the pharmacy"?', "Visit the pharmacy."),
        ("Go to ward to.", 'By "ward to", do you mean "ward 2"?', "Visit ward 2."),
        (
            "Visit ward won, then the lobby.",
            'By "ward won", do you mean "ward 1"?',
            "Visit ward 1, then visit the lobby.",
        ),
        (
            "Visit word 1 before ward too.",
            'By "word 1" and "ward too", do you mean "ward 1" and "ward 2"?',
            None,
        ),
    ],
)
def test_a_slip_is_confirmed_before_it_is_taken_for_one(
    sentence: str, question: str, english: str | None
) -> None:
    extraction = extract(sentence, HOSPITAL)
    assert extraction.status is Status.CLARIFY
    assert extraction.formula is None
    assert extraction.question == question
    assert [each.answer for each in extraction.alternatives] == ["yes"]
    if english is not None:
        assert extraction.alternatives[0].english == english


def test_the_name_that_is_offered_is_the_one_that_was_nearly_said() -> None:
    assert extract("Go to rose 2.", VINEYARD).question == 'By "rose 2", do you mean "row 2"?'


def test_two_words_may_be_one() -> None:
    extraction = extract("Go to the wear house.", VINEYARD)
    assert extraction.question == 'By "wear house", do you mean "the warehouse"?'


@pytest.mark.parametrize(
    "sentence", ["Go to the moon.", "Go to ward 7.", "Tango in the lobby with a nurse."]
)
def test_what_sounds_like_nothing_is_refused(sentence: str) -> None:
    assert extract(sentence, HOSPITAL).status is Status.REJECT


@pytest.mark.parametrize(
    "sentence",
    ["Go from ward 1 to ward 2.", "Visit ward 2 for good.", "Go to ward 1 to call a nurse."],
)
def test_a_word_that_is_right_is_no_slip(sentence: str) -> None:
    question = extract(sentence, HOSPITAL).question or ""
    assert "do you mean" not in question
