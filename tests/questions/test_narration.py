"""Words for facts and deeds, in domains with landmarks and without."""

import pytest
from tests.questions.missions import SETTINGS, accepted

from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.moment import lexicon_of
from plainspoken.questions.narration import deeds_together, facts_together, past_deeds


def lexicon(name: str) -> Lexicon:
    return lexicon_of(accepted(SETTINGS[name]))


@pytest.mark.parametrize(
    ("name", "action", "did"),
    [
        ("vineyard", "move rob l0 l1", "moved to line 1"),
        ("vineyard", "check-grape rob g1 l1", "checked grape 1"),
        ("vineyard", "harvest-grape rob g1 l1", "harvested grape 1"),
        ("vineyard", "drop-grape rob g1 b", "dropped grape 1 in the box"),
        ("vineyard", "call-support rob sup wh l1", "called the support robot"),
        ("vineyard", "empty-box rob sup b l1 wh", "emptied the box"),
        ("vineyard", "ask-human rob g1 l1", "asked a human about grape 1"),
        ("vineyard", "sign-off rob l1", "signed off line 1"),
        ("warehouse", "drive robo dock shelf1", "drove to shelf 1"),
        ("warehouse", "pick-up robo p2 shelf2", "picked up package 2"),
        ("warehouse", "open-door robo", "opened the door"),
        ("kitchen", "wash red-mug", "washed the red mug"),
        ("kitchen", "heat-water", "heated the water"),
        ("kitchen", "put-away plate1 top-cupboard", "put away plate 1 in the top cupboard"),
    ],
)
def test_an_action_is_said_with_what_matters(name: str, action: str, did: str) -> None:
    assert lexicon(name).deed(action).did == did


@pytest.mark.parametrize(
    ("name", "atom", "said", "denied"),
    [
        ("vineyard", "robot-at rob l1", "I'm at line 1", "I'm not at line 1"),
        ("vineyard", "hand-empty rob", "my hand is empty", "my hand isn't empty"),
        ("vineyard", "full b", "the box is full", "the box isn't full"),
        ("vineyard", "carries rob b", "I carry the box", "I don't carry the box"),
        ("vineyard", "stored g1", "grape 1 is in the warehouse", "grape 1 isn't in the warehouse"),
        (
            "vineyard",
            "robot-at sup wh",
            "the support robot is at the warehouse",
            "the support robot isn't at the warehouse",
        ),
        ("warehouse", "hands-free robo", "my hands are free", "my hands aren't free"),
        ("warehouse", "holding robo p1", "I'm holding package 1", "I'm not holding package 1"),
        ("warehouse", "lies-in p1 dock", "package 1 lies in the dock", None),
        ("warehouse", "door-open", "the door is open", "the door isn't open"),
        ("kitchen", "on-table red-mug", "the red mug is on the table", None),
        ("kitchen", "water-hot", "the water is hot", "the water isn't hot"),
    ],
)
def test_a_fact_is_a_sentence(name: str, atom: str, said: str, denied: str | None) -> None:
    clause = lexicon(name).clause(atom)
    assert clause.said() == said
    if denied is not None:
        assert clause.said(negative=True) == denied


def test_a_fact_has_its_tenses() -> None:
    clause = lexicon("vineyard").clause("robot-at rob l1")
    assert clause.said("was") == "I was at line 1"
    assert clause.said("will") == "I'll be at line 1"
    assert clause.said("may", negative=True) == "I may not be at line 1"


def test_facts_with_one_predicate_are_said_together() -> None:
    words = lexicon("vineyard")
    (saying,) = facts_together(words, ["ripe g2", "ripe g0", "ripe g1"])
    assert saying.text == "grapes 0, 1 and 2 are ripe"
    assert set(saying.atoms) == {"ripe g0", "ripe g1", "ripe g2"}


def test_deeds_of_a_kind_are_said_together_and_repeated_ones_counted() -> None:
    actions = ["check-grape rob g0 l0", "call-support rob sup wh l1", "check-grape rob g1 l1"]
    told = past_deeds(deeds_together(lexicon("vineyard"), [*actions, actions[1]]))
    assert told == "I checked grapes 0 and 1 and called the support robot twice"
