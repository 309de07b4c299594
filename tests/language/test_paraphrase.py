"""What the domain calls otherwise is asked about, never taken silently."""

import pytest
from tests.language.domains import vocabulary

from plainspoken.language.extraction import Status, extract
from plainspoken.language.paraphrase import inflected
from plainspoken.language.thesaurus import Thesaurus, thesaurus
from plainspoken.language.word import words
from plainspoken.logic.syntax import parse, unparse

HOUSE = vocabulary(
    """
    basement, l, the basement
    sofa, l, the sofa
    garden, l, the garden
    track_1, l, track 1
    track_2, l, track 2
    lamp, c, the lamp is lit
    repair, a, to repair the mower
    vacuum, a, to vacuum the carpet
    """
)


@pytest.mark.parametrize(
    ("sentence", "question", "meant"),
    [
        ("Go to the couch.", 'By "couch", do you mean "sofa"?', "F sofa"),
        ("Never enter the cellar.", 'By "cellar", do you mean "basement"?', "G !basement"),
        ("Visit the big garden.", 'By "big garden", do you mean "garden"?', "F garden"),
        ("Repair the lawnmower.", 'By "lawnmower", do you mean "mower"?', "F repair"),
        (
            "Go to the couch and then to the cellar.",
            'By "couch" and "cellar", do you mean "sofa" and "basement"?',
            "F(sofa & F basement)",
        ),
    ],
)
def test_a_word_for_what_is_called_otherwise_is_asked_about(
    sentence: str, question: str, meant: str
) -> None:
    asked = extract(sentence, HOUSE, None)
    assert asked.status is Status.CLARIFY
    assert asked.formula is None
    assert asked.question == question
    assert [each.answer for each in asked.alternatives] == ["yes"]
    assert asked.reading is not None
    assert unparse(asked.reading.literal) == unparse(parse(meant))


@pytest.mark.parametrize(
    "sentence",
    [
        "Go to the attic.",  # the opposite of one place is no name for it
        "Never enter the bedroom.",
        "Paint the mower.",
        "Visit the bicycle and the garden.",
        "Sing to the cat.",
    ],
)
def test_a_word_for_something_else_is_refused(sentence: str) -> None:
    assert extract(sentence, HOUSE, None).status is Status.REJECT


def test_an_opposite_is_never_near() -> None:
    for word, opposite in (("full", "empty"), ("open", "closed"), ("ripe", "unripe")):
        assert opposite not in thesaurus().near(word)
        assert word not in thesaurus().near(opposite)


def test_a_word_is_near_in_its_usual_senses_first() -> None:
    table = Thesaurus(["n seat:0", "n bench:0 form:4 0", "n form:0 shape:0"])
    assert table.ranked("form", ["shape", "bench", "seat"]) == [
        (1.0, "shape"),
        (0.84, "bench"),
        (0.64, "seat"),
    ]
    assert table.near("bench")["seat"] > table.near("seat")["form"]
    assert table.near("unheard") == {}


@pytest.mark.parametrize(
    ("name", "like", "meant"),
    [
        ("sofa", "couches", "sofas"),
        ("box", "bins", "boxes"),
        ("repair", "mending", "repairing"),
        ("store", "stashed", "stored"),
        ("sofa", "couch", "sofa"),
    ],
)
def test_a_word_takes_the_ending_of_the_one_it_stands_for(name: str, like: str, meant: str) -> None:
    assert inflected(name, words(like)[0]) == meant
