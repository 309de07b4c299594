"""A mission in several turns: the answer to a question, and what is said further."""

import pytest
from tests.language.domains import DOMAINS, vocabulary

from plainspoken.automata.equivalence import equivalent
from plainspoken.language.answer import Declined, chosen
from plainspoken.language.dialogue import Dialogue, Turn
from plainspoken.language.extraction import Status, extract
from plainspoken.logic.syntax import parse

HOSPITAL = DOMAINS["hospital"]
ROOMS = vocabulary(
    """
    r, l, the red room
    b, l, the blue room
    """
)


def talk(*said: str) -> Turn:
    dialogue, turn = Dialogue(HOSPITAL), None
    for text in said:
        turn = dialogue.say(text)
        dialogue = turn.dialogue
    assert turn is not None
    return turn


def mission_of(turn: Turn) -> str:
    mission = turn.dialogue.mission
    assert mission is not None
    assert mission.reading is not None
    return mission.reading.english


@pytest.mark.parametrize(
    ("question", "answer", "formula"),
    [
        ("Go to the ward.", "the first", "F w1"),
        ("Go to the ward.", "the second one, please", "F w2"),
        ("Go to the ward.", "ward 3", "F w3"),
        ("Go to the ward.", "3", "F w3"),
        ("Go to the ward.", "I mean number two", "F w2"),
        ("Go to the ward.", "the last one", "F w3"),
        ("Go to the ward.", "b", "F w2"),
        ("Go to word 2.", "yes", "F w2"),
        ("Go to word 2.", "Yes, that's right.", "F w2"),
        ("Go to ward 1, then immediately to ward 2.", "right after", "F(w1 & X w2)"),
        ("Go to ward 1, then immediately to ward 2.", "later", "F(w1 & F w2)"),
        (
            "Visit the lobby and call a nurse if the floor is wet.",
            "with both",
            "G(spill -> F lobby) & G(spill -> F nurse)",
        ),
        (
            "When the battery is low, call a nurse soon.",
            "the next step",
            "(low -> X nurse) & G((!low & X low) -> X X nurse)",
        ),
    ],
)
def test_the_answer_to_a_question_completes_the_sentence(
    question: str, answer: str, formula: str
) -> None:
    assert talk(question).extraction.status is Status.CLARIFY
    turn = talk(question, answer)
    assert turn.extraction.status is Status.OK
    assert turn.extraction.formula is not None
    assert equivalent(turn.extraction.formula, parse(formula))
    assert turn.dialogue.mission == turn.extraction
    assert turn.dialogue.asked is None
    assert turn.said


def test_a_word_of_one_option_chooses_it() -> None:
    red, blue = (
        extract(sentence, ROOMS).reading
        for sentence in ("Visit the red room.", "Visit the blue room.")
    )
    assert red is not None
    assert blue is not None
    assert chosen("the red one", (red, blue)) == red
    assert chosen("blue", (red, blue)) == blue
    assert chosen("the green one", (red, blue)) is None
    assert chosen("the room", (red, blue)) is None
    assert chosen("neither of them", (red, blue)) == Declined()


def test_no_closes_the_question_and_keeps_the_mission() -> None:
    turn = talk("Visit the lobby.", "and go to word 2", "no")
    assert turn.extraction.status is Status.REJECT
    assert turn.dialogue.asked is None
    assert mission_of(turn) == "Visit the lobby."


def test_what_is_no_answer_is_asked_again() -> None:
    turn = talk("Go to the ward.", "banana")
    assert turn.extraction.status is Status.REJECT
    assert turn.dialogue.asked is not None
    assert turn.said.startswith("I cannot tell which you mean.")
    assert talk("Go to the ward.", "banana", "ward 1").said == "Visit ward 1."


def test_a_new_sentence_takes_the_place_of_an_open_question() -> None:
    assert mission_of(talk("Go to the ward.", "Visit the lobby.")) == "Visit the lobby."


@pytest.mark.parametrize(
    ("mission", "further", "formula"),
    [
        ("Visit ward 1, then ward 2.", "Actually, ward 3 first.", "F(w3 & F(w1 & F w2))"),
        ("Visit ward 1, then ward 2.", "start with ward 2", "F(w2 & F w1)"),
        ("Visit ward 1 and ward 2.", "ward 3 first", "F(w3 & F w1) & F(w3 & F w2)"),
        ("Visit ward 1.", "then ward 2", "F(w1 & F w2)"),
        ("Visit ward 1.", "and the lab at the end", "F(w1 & F lab)"),
        ("Visit ward 1.", "And don't forget the lobby.", "F w1 & F lobby"),
        ("Visit ward 1.", "the lobby as well", "F w1 & F lobby"),
        ("Visit ward 1.", "No, ward 2 instead.", "F w2"),
        ("Visit ward 1.", "I meant ward 2", "F w2"),
        ("Visit ward 1, then ward 2.", "ward 3 instead of ward 1", "F(w3 & F w2)"),
        ("Visit ward 1, then ward 2.", "replace ward 2 with the lab", "F(w1 & F lab)"),
        ("Visit ward 1, then ward 2, then ward 3.", "Skip ward 2.", "F(w1 & F w3)"),
        ("Visit ward 1 and ward 2.", "leave ward 1 out", "F w2"),
        ("Visit ward 1 and ward 2.", "no need to visit ward 1", "F w2"),
        ("Visit ward 1.", "Also never enter ward 2.", "F w1 & G !w2"),
        ("Visit ward 1.", "if the floor is wet, call a nurse", "F w1 & G(spill -> F nurse)"),
        (
            "Visit ward 1.",
            "Make that twice.",
            (
                "F(w1 & (w1 U (!w1 & (!w1 U F w1)))) & "
                "!F(w1 & (w1 U (!w1 & (!w1 U F(w1 & (w1 U (!w1 & (!w1 U F w1))))))))"
            ),
        ),
        ("Visit ward 1.", "Instead, call a nurse.", "F nurse"),
        ("Visit ward 1 and never enter ward 2.", "make it ward 3", "F w3 & G !w2"),
    ],
)
def test_what_is_said_further_refines_the_mission(mission: str, further: str, formula: str) -> None:
    turn = talk(mission, further)
    assert turn.extraction.status is Status.OK, turn.said
    assert turn.extraction.formula is not None
    assert equivalent(turn.extraction.formula, parse(formula)), turn.said
    assert turn.dialogue.mission == turn.extraction


def test_the_english_is_of_the_whole() -> None:
    turn = talk("Visit ward 1.", "also never enter ward 2", "then the lobby")
    assert turn.said == "Visit ward 1, then visit the lobby. Never visit ward 2."


def test_a_question_in_what_is_said_further_is_about_that() -> None:
    turn = talk("Visit the lobby.", "and don't forget the ward", "the third")
    assert mission_of(turn) == "Visit the lobby and ward 3, in any order."


def test_a_refinement_that_contradicts_names_the_two_that_clash() -> None:
    turn = talk("Visit ward 1, then ward 2.", "call a nurse", "never enter ward 2")
    assert turn.extraction.status is Status.REJECT
    assert turn.said == (
        'These two cannot both be: "Visit ward 1, then visit ward 2." and "Never visit ward 2." '
        "The mission stays as it was."
    )
    assert "Call a nurse" in mission_of(turn)


@pytest.mark.parametrize(
    "further",
    [
        "",
        "  ",
        "🍇",
        "banana",
        "what a lovely day",
        "Vai alla corsia 2",
        "skip ward 3",
        "no",
        "why?",
    ],
)
def test_senseless_further_words_are_refused_and_the_mission_kept(further: str) -> None:
    turn = talk("Visit ward 1.", further)
    assert turn.extraction.status is Status.REJECT
    assert turn.said
    assert mission_of(turn) == "Visit ward 1."


@pytest.mark.parametrize(
    "said", ["Forget that.", "Start over.", "cancel that", "Let's start again"]
)
def test_a_conversation_may_begin_anew(said: str) -> None:
    turn = talk("Visit ward 1.", said)
    assert turn.dialogue.mission is None
    assert mission_of(talk("Visit ward 1.", said, "Visit ward 2.")) == "Visit ward 2."


def test_nothing_is_left_of_a_mission_of_one() -> None:
    turn = talk("Visit ward 1.", "skip ward 1")
    assert turn.extraction.status is Status.REJECT
    assert mission_of(turn) == "Visit ward 1."


def test_a_dialogue_is_a_value_and_a_turn_leaves_it_as_it_was() -> None:
    dialogue = Dialogue(HOSPITAL)
    first = dialogue.say("Visit ward 1.").dialogue
    assert dialogue.mission is None
    assert first.say("skip ward 1").dialogue == first
    assert first.say("then ward 2").dialogue.mission != first.mission


def test_the_expressions_of_the_whole_stand_in_its_utterance() -> None:
    extraction = talk("Visit ward 1.", "and don't forget the lobby").extraction
    for each in extraction.referring_expressions:
        assert extraction.utterance[each.start : each.end] == each.text
