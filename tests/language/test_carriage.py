"""Carrying something somewhere, doing something at a place: errands with several stops."""

import pytest
from tests.language.domains import vocabulary

from plainspoken.automata.equivalence import equivalent
from plainspoken.language.extraction import Status, extract
from plainspoken.language.grounding import Vocabulary
from plainspoken.logic.syntax import parse, unparse

_PLACES = """quay, l, the quay
    depot, l, the depot
    gate2, l, gate 2
    gate3, l, gate 3
    tower, l, the tower"""
ACTS = vocabulary(
    f"""
    {_PLACES}
    crate7, a, to pick up crate 7
    drum1, a, to grab drum 1
    down, a, to put down the load
    photo, a, to take a photo
    """
)
STATES = vocabulary(
    f"""
    {_PLACES}
    crate7, c, crate 7 is picked up
    drum1, c, drum 1 is lifted
    down, c, the load is put down
    photo, c, a photo is taken
    """
)
BARE = vocabulary(
    f"""
    {_PLACES}
    crate7, a, lift crate 7
    drum1, a, collect drum 1
    down, a, put down
    photo, a, photo
    """
)
SPLIT = vocabulary(
    f"""
    {_PLACES}
    crate7, a, to pick crate 7 up
    drum1, a, to lift drum 1
    down, a, to put it down
    photo, a, to take a photo
    """
)
CARRYING = vocabulary(
    f"""
    {_PLACES}
    crate7, a, to pick up crate 7
    drum1, a, to pick up drum 1
    down, a, to set down what is carried
    photo, a, to make a photo
    """
)
STORED = vocabulary(
    f"""
    {_PLACES}
    held, c, the robot is holding the flask
    stored, c, the flask is in the depot
    boxed, c, the flask is in the case
    """
)

IN_EVERY_DOMAIN = pytest.mark.parametrize(
    "domain",
    [ACTS, STATES, BARE, SPLIT, CARRYING],
    ids=["acts", "states", "bare", "split", "carrying"],
)
CARRIED = "F(quay & F(crate7 & F(depot & down)))"


def literal(utterance: str, domain: Vocabulary) -> str:
    found = extract(utterance, domain, None)
    assert found.reading is not None, (utterance, found.reason or found.question)
    assert found.status is Status.OK, (utterance, found.question)
    return unparse(found.reading.literal)


def check(utterance: str, formula: str, domain: Vocabulary) -> None:
    found = literal(utterance, domain)
    assert equivalent(parse(found), parse(formula)), (utterance, found)


@IN_EVERY_DOMAIN
@pytest.mark.parametrize(
    "utterance",
    [
        "Haul crate 7 from the quay to the depot.",
        "Bring crate 7 to the depot from the quay.",
        "From the quay, take crate 7 to the depot.",
        "Fetch crate 7 from the quay and drop it off at the depot.",
        "Pick crate 7 up at the quay, then hand it over in the depot.",
        "Go to the quay, grab crate 7, and leave it at the depot.",
        "Drive to the quay to get crate 7 and deliver it to the depot.",
        "Collect crate 7 at the quay, go to the depot, and put it down there.",
        "Crate 7 must be taken from the quay to the depot.",
        "Crate 7 is lying at the quay. Take it to the depot.",
        "After picking up crate 7 at the quay, carry it to the depot.",
        "Take crate 7 to the depot after collecting it from the quay.",
        "At the quay, pick up crate 7 and bring it to the depot.",
        "Move crate 7, which is at the quay, to the depot.",
        "Make a delivery of crate 7 from the quay to the depot.",
    ],
)
def test_to_carry_is_to_be_there_pick_up_and_put_down(utterance: str, domain: Vocabulary) -> None:
    check(utterance, CARRIED, domain)


@pytest.mark.parametrize(
    ("utterance", "formula"),
    [
        ("While hauling crate 7 from the quay to the depot, never enter gate 2.", "G !gate2"),
        ("Take crate 7 from the quay to the depot, avoiding gate 2.", "G !gate2"),
        ("Avoid gate 2 as you bring crate 7 from the quay to the depot.", "G !gate2"),
        ("Stay in the tower while moving crate 7 from the quay to the depot.", "G tower"),
        ("Without leaving the tower, take crate 7 from the quay to the depot.", "G tower"),
        (
            "Stay in the tower until gate 2 while taking crate 7 from the quay to the depot.",
            "tower U gate2",
        ),
        (
            "Do not enter gate 3 until gate 2 as you take crate 7 from the quay to the depot.",
            "!gate3 U gate2",
        ),
        (
            "Bring crate 7 from the quay to the depot and drum 1 from gate 2 to gate 3.",
            "F(gate2 & F(drum1 & F(gate3 & down)))",
        ),
    ],
)
def test_what_is_asked_beside_carrying_is_a_demand_of_its_own(utterance: str, formula: str) -> None:
    check(utterance, f"{CARRIED} & {formula}", ACTS)


@pytest.mark.parametrize(
    ("utterance", "formula"),
    [
        (
            "Do not enter gate 2 until you pick up crate 7 at the quay and put it in the depot.",
            "!gate2 U (quay & F(crate7 & F(depot & down)))",
        ),
        (
            "Take crate 7 from the quay to the depot, then go to the tower.",
            "F(quay & F(crate7 & F(depot & down & F tower)))",
        ),
        ("Grab crate 7 at the quay.", "F(quay & crate7)"),
        ("Go to the quay and pick up crate 7.", "F(quay & crate7)"),
        ("Keep picking up drum 1 at gate 2.", "G F(gate2 & drum1)"),
        ("Put down whatever you hold, then go to gate 2.", "F(down & F gate2)"),
        ("Drop anything you are carrying before heading to gate 2.", "F(down & F gate2)"),
    ],
)
def test_an_errand_goes_together_with_other_clauses_as_any_act(
    utterance: str, formula: str
) -> None:
    check(utterance, formula, ACTS)


@IN_EVERY_DOMAIN
@pytest.mark.parametrize(
    ("utterance", "formula"),
    [
        ("Take a picture of the tower.", "F(tower & photo)"),
        ("Photograph the tower.", "F(tower & photo)"),
        ("Go to the tower and snap a photo there.", "F(tower & photo)"),
        ("A picture of the tower must be taken.", "F(tower & photo)"),
        ("Keep photographing the tower.", "G F(tower & photo)"),
        ("Consistently capture images of the tower.", "G F(tower & photo)"),
        ("Never take a photo of the tower.", "G !(tower & photo)"),
        ("Avoid taking pictures until you reach gate 2.", "!photo U gate2"),
        (
            "Keep returning to gate 3 as you keep photographing the tower.",
            "G F gate3 & G F(tower & photo)",
        ),
        (
            "Avoid gate 2 while periodically taking photos of the tower.",
            "G !gate2 & G F(tower & photo)",
        ),
    ],
)
def test_a_record_of_a_place_is_taken_there(
    utterance: str, formula: str, domain: Vocabulary
) -> None:
    check(utterance, formula, domain)


@pytest.mark.parametrize(
    ("utterance", "formula"),
    [
        ("Haul the flask to the depot.", "F stored"),
        ("Carry the flask to the depot without entering gate 2.", "F stored & G !gate2"),
        (
            "Take the flask from the tower and put it in the case.",
            "F(tower & F(held & F boxed))",
        ),
        ("Get the flask from the tower.", "F(tower & held)"),
    ],
)
def test_where_a_condition_says_that_it_is_there_that_is_asked_for(
    utterance: str, formula: str
) -> None:
    check(utterance, formula, STORED)


@pytest.mark.parametrize(
    "utterance",
    [
        "Carry the flask from the tower to gate 2.",
        "Take the lamp to the depot.",
        "Take a photo of the tower.",
    ],
)
def test_what_a_domain_cannot_say_is_refused(utterance: str) -> None:
    assert extract(utterance, STORED, None).status is Status.REJECT


@IN_EVERY_DOMAIN
@pytest.mark.parametrize(
    "utterance",
    [
        "Haul crate 7 from the quay to the depot and never enter gate 2.",
        "Take crate 7 from the quay to the depot, then go to the tower.",
        "Keep photographing the tower while avoiding gate 2.",
        "Pick up drum 1 at gate 3.",
    ],
)
def test_an_errand_said_back_is_read_as_itself(utterance: str, domain: Vocabulary) -> None:
    once = extract(utterance, domain, None)
    assert once.reading is not None
    again = extract(once.reading.english, domain, None)
    assert again.reading is not None, once.reading.english
    assert equivalent(again.reading.formula, once.reading.formula), once.reading.english


def test_each_symbol_of_an_errand_has_its_own_words() -> None:
    found = extract("Haul crate 7 from the quay to the depot.", ACTS, None)
    texts = {each.symbol: each.text for each in found.referring_expressions}
    assert texts == {"crate7": "crate 7", "quay": "quay", "depot": "depot"}


@pytest.mark.parametrize(
    ("utterance", "formula"),
    [
        ("Visit gate 2, avoiding gate 3.", "F gate2 & G !gate3"),
        ("Persistently return to gate 2.", "G F gate2"),
        ("Periodically visit gate 2.", "G F gate2"),
        ("Continuously stay in the tower.", "G tower"),
        (
            "Remain in the tower permanently, but do not enter the tower until you reach gate 2.",
            "F G tower & (!tower U gate2)",
        ),
    ],
)
def test_general_words_of_lasting_and_coming_back(utterance: str, formula: str) -> None:
    check(utterance, formula, ACTS)
