"""People are asked, and waited for, over the end of the program that asked."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from tests.backends.activities.errands import ARRIVED, PROBLEM
from tests.mission.conformance import ended
from tests.stores import store_in
from tests.work.workshop import queue_up

from plainspoken.backends.activities.configuration import robot_from
from plainspoken.backends.questions import Questions
from plainspoken.errors import InputFileError, PlainspokenError
from plainspoken.knowledge.sqlite import SqliteDatabase
from plainspoken.knowledge.store import Store
from plainspoken.mission.observation import CancelAsked
from plainspoken.mission.robot import Failed, Robot, Succeeded, UnderWay
from plainspoken.work.asking import ask_of
from plainspoken.world.domain import State

FILE = """\
services: {person: {via: human}}
actions:
  go: {do: {call: person, with: {question: "Please go to {to}.", answers: [done]}}}
  grasp:
    do: {call: person, with: {question: "Do you hold {t}?", answers: [Yes, no]}}
    outcomes:
      - {when: {answer: Yes}, facts: ["held {t}"]}
      - {when: {answer: no}, facts: ["not held {t}"]}
"""
GRASP_MUG = "grasp mug kitchen"


@contextmanager
def robot_in(folder: Path, text: str = FILE, state: State = ARRIVED) -> Iterator[Robot]:
    file = folder / "robots.yaml"
    file.write_text(text)
    with store_in(folder) as store, robot_from(file, PROBLEM, store, state=state) as robot:
        yield robot


def questions_in(folder: Path) -> Questions:
    return Questions(SqliteDatabase(folder / "store.sqlite"))


@pytest.mark.parametrize(("said", "held"), [("yes", True), (" NO ", False)])
def test_an_answer_is_an_outcome(said: str, held: object, tmp_path: Path) -> None:
    with robot_in(tmp_path) as robot:
        robot.send("m/1", GRASP_MUG)
        assert robot.wait("m/1", 0.0) == UnderWay(None, "a person is asked: Do you hold mug?")
        (question,) = questions_in(tmp_path).open()
        assert question.text == "Do you hold mug?"
        assert question.answers == ("Yes", "no")
        questions_in(tmp_path).answer(question.call, said, "ada")
        status = ended(robot, "m/1")
    assert isinstance(status, Succeeded)
    assert ("held mug" in status.state) is held
    assert questions_in(tmp_path).open() == ()


def test_a_question_outlives_the_program_that_asked_and_is_put_once(tmp_path: Path) -> None:
    with robot_in(tmp_path) as robot:
        robot.send("m/1", GRASP_MUG)
    questions = questions_in(tmp_path)
    (question,) = questions.open()
    questions.answer(question.call, "no", "ada")
    with robot_in(tmp_path) as again:
        again.send("m/1", GRASP_MUG)
        assert isinstance(ended(again, "m/1"), Succeeded)
    assert questions.open() == ()


def test_who_cannot_do_it_says_so_and_the_action_fails(tmp_path: Path) -> None:
    with robot_in(tmp_path, state=PROBLEM.initial) as robot:
        robot.send("m/1", "go hall kitchen")
        (question,) = questions_in(tmp_path).open()
        questions_in(tmp_path).answer(question.call, "cannot", "ada")
        reason = "ada could not: Please go to kitchen."
        assert ended(robot, "m/1") == Failed(reason, PROBLEM.initial)


def test_a_question_that_is_given_up_is_not_asked_any_longer(tmp_path: Path) -> None:
    with robot_in(tmp_path) as robot:
        robot.send("m/1", GRASP_MUG)
        robot.cancel("m/1")
        assert ended(robot, "m/1") == Failed("cancelled", ARRIVED)
    assert questions_in(tmp_path).open() == ()


def test_of_a_mission_that_is_over_nobody_is_asked_anything(store: Store) -> None:
    queue_up(store, "m", Path("world"))
    queue_up(store, "m2", Path("world"))
    questions = Questions(store.database)
    questions.ask("m/1:0#1", "Is the door shut?", ("yes", "no"))
    questions.ask("m2/1:0#1", "Is the lamp lit?", ("yes", "no"))
    assert len(questions.open()) == 2
    ask_of(store, "m", CancelAsked("ada"), ())
    assert [question.text for question in questions.open()] == ["Is the lamp lit?"]


def test_only_an_answer_that_was_asked_for_is_taken(tmp_path: Path) -> None:
    questions = questions_in(tmp_path)
    questions.ask("m/1:0#1", "Ripe?", ["ripe", "unripe"])
    with pytest.raises(PlainspokenError, match="does not answer: Ripe") as caught:
        questions.answer("m/1:0#1", "perhaps", "ada")
    assert caught.value.hint == "one of: ripe, unripe, cannot"
    with pytest.raises(PlainspokenError, match="no open question 'm/2'"):
        questions.answer("m/2", "ripe", "ada")
    questions.ask("m/2:0#1", "How many?", [])
    questions.answer("m/2:0#1", "about seven", "ada")
    assert [each.call for each in questions.open()] == ["m/1:0#1"]


def test_of_two_who_answer_at_once_one_is_heard(tmp_path: Path) -> None:
    questions = questions_in(tmp_path)
    questions.ask("m/1:0#1", "Ripe?", ["ripe", "unripe"])
    refused: list[PlainspokenError] = []

    def answer(reporter: str) -> None:
        try:
            questions.answer("m/1:0#1", "ripe", reporter)
        except PlainspokenError as error:
            refused.append(error)

    people = [threading.Thread(target=answer, args=(name,)) for name in ("ada", "ben", "eve")]
    for person in people:
        person.start()
    for person in people:
        person.join()
    assert questions.open() == ()
    assert len(refused) == 2


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("question: ", "text: "), "no field 'text'"),
        (("answers: [done]", "answers: done"), "a list of words"),
        (('question: "Please go to {to}.", ', ""), "needs a `question`"),
        (("via: human", "via: human, url: x"), "no key 'url'"),
    ],
)
def test_a_question_that_is_none_is_refused_with_its_line(
    change: tuple[str, str], said: str, tmp_path: Path
) -> None:
    with (
        pytest.raises(InputFileError, match=said) as caught,
        robot_in(tmp_path, FILE.replace(*change)),
    ):
        pass
    assert caught.value.line is not None
