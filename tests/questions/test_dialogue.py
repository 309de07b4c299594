"""Questions in a row, and the parts of a request as they are spoken of."""

import pytest
from tests.questions.judge import Judge
from tests.questions.missions import FURTHER, accepted, run, written_run

from plainspoken.automata.verdict import Verdict
from plainspoken.logic.pattern import PromptReaction
from plainspoken.questions.answer import answer_at
from plainspoken.questions.dialogue import Dialogue
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.moment import Moment, lexicon_of
from plainspoken.questions.wish import standing, wanted, wish_of


def talk(moment: Moment, *texts: str) -> list[str]:
    judge = Judge(moment.entries, moment.entries[-1].step)
    dialogue, answers = Dialogue(), []
    for text in texts:
        found, dialogue = dialogue.ask(text, moment)
        assert judge.failures(found.to_json(0, text, 0.0)) == [], text
        answers.append(found.text)
    return answers


FULL = Moment(written_run("ripe g0", "full b", "ripe g1", "in-hand g1"))


@pytest.mark.parametrize(
    ("texts", "last"),
    [
        (
            ("What did you do last?", "Why?"),
            (
                "I harvested grape 1 so that I could drop it in the box, since you want line 1 "
                "cleared."
            ),
        ),
        (
            ("Is the box full?", "Why?"),
            (
                "The box is full: it came of dropping grape 0 in the box four actions ago; whether "
                "it does is up to chance."
            ),
        ),
        (("Is grape 1 ripe?", "And grape 0?"), None),
        (("Did you check grape 1?", "Did you harvest it?"), "Yes, I harvested grape 1, just now."),
        (
            ("Will you empty the box?", "And after that?"),
            "After emptying the box, I'll drop grape 1 in the box.",
        ),
    ],
)
def test_a_short_question_speaks_of_what_went_before(
    texts: tuple[str, ...], last: str | None
) -> None:
    found = talk(FULL, *texts)[-1]
    assert found == last or (last is None and found.startswith("Yes, grape 0 has been ripe"))


def test_without_a_turn_before_a_question_stands_alone() -> None:
    assert talk(FULL, "Why?") == [answer_at("Why?", FULL).text]


def moment_of(name: str, seed: int, at: int) -> Moment:
    return Moment(run(name, seed), at)


def lexicon(name: str) -> Lexicon:
    return lexicon_of(accepted(FURTHER[name]))


def test_a_pattern_of_two_conjuncts_is_one_part_with_one_verdict() -> None:
    moment = moment_of("reacting", 1, 2)
    last = moment.demands[-1]
    assert isinstance(last.said, PromptReaction)
    assert len(last.parts) == 2
    assert last.verdict is Verdict.HOLDS_SO_FAR
    assert len(moment.demands) == 3


@pytest.mark.parametrize(
    ("name", "wants", "stands"),
    [
        (
            "reacting",
            [
                "line 2 to be cleared",
                "me to keep out of line 3 while the box is full",
                "me to call the support robot as soon as the box is full",
            ],
            "I call the support robot as soon as the box is full",
        ),
        (
            "depot",
            [
                "the crate to be delivered",
                "the drum to be delivered",
                (
                    "me to see to it that, whenever the battery is low, sooner or later the "
                    "battery isn't low"
                ),
                "me to keep out of the charging point until the crate is delivered",
            ],
            "I keep out of the charging point until the crate is delivered",
        ),
    ],
)
def test_each_part_has_words_that_a_person_would_use(
    name: str, wants: list[str], stands: str
) -> None:
    words = lexicon(name)
    wishes = [wish_of(each.said, words) for each in moment_of(name, 0, 1).demands]
    assert [wanted(each, words) for each in wishes] == wants
    assert standing(wishes[-1], words) == stands


def test_at_the_end_each_part_is_told_once() -> None:
    entries = run("reacting", 3)
    assert answer_at("How far are you?", Moment(entries)).text == (
        "I'm finished: everything you asked for is done. Done: line 2 is cleared. Kept to the end: "
        "I keep out of line 3 while the box is full and I call the support robot as soon as the "
        "box is full."
    )
    assert answer_at("Did you enter line 3?", Moment(entries)).text == (
        "No, I've never been to line 3."
    )
