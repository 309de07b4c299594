"""What a network gets to read: marks for what is spoken of, and what else may be meant."""

from tests.language.domains import DOMAINS

from plainspoken.language.marking import MOST_COVERED, MOST_OFFERED, Mark, marked
from plainspoken.language.sentence import Sentence

HOSPITAL = DOMAINS["hospital"]


def read(utterance: str) -> tuple[str | Mark, ...]:
    return marked(Sentence.of(utterance, HOSPITAL))


def said(utterance: str) -> list[str]:
    """The words and marks, those of the offers left out."""
    found = []
    for each in read(utterance):
        if isinstance(each, Mark):
            if each.form is None:
                break
            found.append("#")
        else:
            found.append(each)
    return found


def test_a_mark_stands_for_the_words_of_its_symbol() -> None:
    assert said("Visit ward 1, then the lobby.") == ["visit", "#", ",", "then", "the", "#", "."]


def test_words_that_turn_what_is_said_stay_behind_the_mark() -> None:
    assert "not" in said("Go to ward 1 while the floor is not wet.")


def test_a_symbol_spoken_of_twice_is_marked_twice() -> None:
    marks = [each for each in read("Go to ward 1, the lobby, ward 1.") if isinstance(each, Mark)]
    spoken = [each.symbol for each in marks if each.form is not None]
    assert spoken[0] == spoken[2] != spoken[1]


def test_symbols_that_share_a_word_are_offered_with_their_description() -> None:
    found = read("Go to the wards.")
    offers = [each for each in found if isinstance(each, Mark) and each.form is None]
    assert len(offers) <= MOST_OFFERED
    for index, each in enumerate(found):
        if isinstance(each, Mark) and each.form is None:
            described = found[index + 1 : index + 1 + each.length]
            assert all(isinstance(word, str) for word in described)


def test_few_are_offered_that_share_only_what_is_spoken_of_already() -> None:
    found = read("Visit ward 1.")
    offers = [each for each in found if isinstance(each, Mark) and each.form is None]
    assert len(offers) <= MOST_COVERED
