"""What kind of word stands in a name."""

import pytest

from plainspoken.world.inflection import (
    gerund,
    is_adjective,
    is_gerund,
    is_participle,
    is_third_person,
    related,
    some,
    third_person,
    whereabouts,
)


@pytest.mark.parametrize("word", ["plugged", "broken", "lit", "put", "stuck", "unmade", "found"])
def test_past_forms_are_participles(word: str) -> None:
    assert is_participle(word)


@pytest.mark.parametrize("word", ["bed", "seed", "tank", "data", "lies", "holding", "aspirin"])
def test_other_words_are_none(word: str) -> None:
    assert not is_participle(word)


def test_verbs_are_told_by_their_endings() -> None:
    assert all(map(is_third_person, ("lies", "carries", "needs")))
    assert not any(map(is_third_person, ("glass", "bus", "locked", "carry")))
    assert all(map(is_gerund, ("holding", "lying", "waiting")))
    assert not any(map(is_gerund, ("thing", "king", "held")))


def test_adjectives_are_told_by_their_nouns_or_endings() -> None:
    assert all(map(is_adjective, ("empty", "low", "free", "active", "left")))
    assert not any(map(is_adjective, ("battery", "library", "gate")))


@pytest.mark.parametrize(
    ("verb", "ending", "told"),
    [("hold", "holding", "holds"), ("carry", "carrying", "carries"), ("lie", "lying", "lies"),
     ("drive", "driving", "drives"), ("put", "putting", "puts"), ("have", "having", "has")],
)  # fmt: skip
def test_verbs_are_inflected(verb: str, ending: str, told: str) -> None:
    assert (gerund(verb), third_person(verb)) == (ending, told)


def test_articles_follow_the_noun() -> None:
    assert [some("engine"), some("unit"), some("towels"), some("AGV")] == [
        "an engine", "a unit", "towels", "an AGV"
    ]  # fmt: skip
    assert [related("in", "hand"), related("on", "fire"), related("in", "stock")] == [
        "in the hand", "on fire", "in stock"
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("relation", "place", "said"),
    [("in", "the balcony", "on"), ("at", "room 2", "in"), ("at", "the gate", "at"),
     ("under", "the table", "under")],
)  # fmt: skip
def test_the_preposition_fits_the_kind_of_place(relation: str, place: str, said: str) -> None:
    assert whereabouts(relation, place) == said
