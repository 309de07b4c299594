import pytest

from plainspoken.questions.morphology import (
    a,
    counted,
    listed,
    participle,
    past,
    plural,
    progressive,
    sentence,
    third_person,
    times,
)


@pytest.mark.parametrize(
    ("verb", "was", "been", "doing", "does"),
    [
        ("pick", "picked", "picked", "picking", "picks"),
        ("drop", "dropped", "dropped", "dropping", "drops"),
        ("drive", "drove", "driven", "driving", "drives"),
        ("carry", "carried", "carried", "carrying", "carries"),
        ("empty", "emptied", "emptied", "emptying", "empties"),
        ("put", "put", "put", "putting", "puts"),
        ("go", "went", "gone", "going", "goes"),
        ("harvest", "harvested", "harvested", "harvesting", "harvests"),
        ("unload", "unloaded", "unloaded", "unloading", "unloads"),
        ("refill", "refilled", "refilled", "refilling", "refills"),
        ("rewind", "rewound", "rewound", "rewinding", "rewinds"),
        ("unplug", "unplugged", "unplugged", "unplugging", "unplugs"),
        ("open", "opened", "opened", "opening", "opens"),
        ("label", "labelled", "labelled", "labelling", "labels"),
        ("visit", "visited", "visited", "visiting", "visits"),
        ("tie", "tied", "tied", "tying", "ties"),
        ("wash", "washed", "washed", "washing", "washes"),
        ("mix", "mixed", "mixed", "mixing", "mixes"),
        ("panic", "panicked", "panicked", "panicking", "panics"),
        ("better", "bettered", "bettered", "bettering", "betters"),
        ("equip", "equipped", "equipped", "equipping", "equips"),
        ("see", "saw", "seen", "seeing", "sees"),
        ("play", "played", "played", "playing", "plays"),
    ],
)
def test_a_verb_has_its_forms(verb: str, was: str, been: str, doing: str, does: str) -> None:
    forms = (past(verb), participle(verb), progressive(verb), third_person(verb))
    assert forms == (was, been, doing, does)


@pytest.mark.parametrize(
    ("one", "many"),
    [
        ("grape", "grapes"),
        ("box", "boxes"),
        ("shelf", "shelves"),
        ("berry", "berries"),
        ("key", "keys"),
        ("tomato", "tomatoes"),
        ("person", "people"),
        ("support robot", "support robots"),
        ("workman", "workmen"),
    ],
)
def test_a_noun_has_its_plural(one: str, many: str) -> None:
    assert plural(one) == many


def test_words_are_counted_listed_and_made_a_sentence() -> None:
    assert listed(["a"]) == "a"
    assert listed(["a", "b", "c"]) == "a, b and c"
    assert listed(["a", "b"], "or") == "a or b"
    assert counted(1, "grape") == "one grape"
    assert counted(17, "box") == "17 boxes"
    assert [times(n) for n in (0, 1, 2, 3)] == ["never", "once", "twice", "three times"]
    assert (a("apple"), a("user"), a("box")) == ("an apple", "a user", "a box")
    assert sentence("the box is full") == "The box is full."
