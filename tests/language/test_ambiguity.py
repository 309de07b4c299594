"""Where English leaves the structure of a sentence open, a question with its answers."""

import pytest
from tests.language.domains import DOMAINS

from plainspoken.automata.equivalence import equivalent, satisfiable
from plainspoken.language.extraction import Status, extract
from plainspoken.logic.syntax import parse

HOSPITAL = DOMAINS["hospital"]


@pytest.mark.parametrize(
    ("sentence", "question", "answers"),
    [
        (
            "Go to ward 1, then immediately to ward 2.",
            "Should ward 2 come right after ward 1, or just later?",
            {"just later": "F(w1 & F w2)", "right after": "F(w1 & X w2)"},
        ),
        (
            "Visit the lobby and call a nurse if the floor is wet.",
            'Does "if the floor is wet" go with both parts, or only with "call a nurse"?',
            {
                "only call a nurse": "F lobby & G(spill -> F nurse)",
                "both": "G(spill -> F lobby) & G(spill -> F nurse)",
            },
        ),
        (
            "Visit ward 1 or ward 2 and ward 3.",
            (
                "Which do you mean: ward 1, or else ward 2 and ward 3, "
                "or either ward 1 or ward 2, and ward 3?"
            ),
            {
                "ward 1, or else ward 2 and ward 3": "F w1 | (F w2 & F w3)",
                "either ward 1 or ward 2, and ward 3": "F(w1 | w2) & F w3",
            },
        ),
        (
            "Do not visit all wards.",
            "Do you mean none of them, or only not all of them?",
            {
                "none of them": "G !w1 & G !w2 & G !w3",
                "not all of them": "G !w1 | G !w2 | G !w3",
            },
        ),
        (
            "When the battery is low, call a nurse soon.",
            'By "soon", do you mean in the very next step, or some time later?',
            {"some time later": "G(low -> F nurse)", "in the next step": "G(low -> X nurse)"},
        ),
        (
            "Visit ward 1 once ward 2.",
            'By "once", do you mean one time, or as soon as?',
            None,
        ),
    ],
)
def test_a_doubtful_structure_is_asked_about(
    sentence: str, question: str, answers: dict[str, str] | None
) -> None:
    extraction = extract(sentence, HOSPITAL, None)
    assert extraction.status is Status.CLARIFY
    assert extraction.formula is None
    assert extraction.question == question
    assert all(each.answer and each.english for each in extraction.alternatives)
    if answers is not None:
        assert [each.answer for each in extraction.alternatives] == list(answers)
        for each in extraction.alternatives:
            assert equivalent(each.literal, parse(answers[each.answer]))


@pytest.mark.parametrize(
    "sentence",
    [
        "Go to ward 1, then to ward 2.",
        "Visit the lobby and ward 1, then call a nurse.",
        "Call a nurse if the floor is wet.",
        "If the floor is wet, visit the lobby and call a nurse.",
        "Visit the lobby, and call a nurse if the floor is wet.",
        "Visit ward 1 or ward 2.",
        "Do not visit any ward.",
        "Avoid all wards.",
        "Never visit ward 1 or ward 2.",
        "When the battery is low, call a nurse immediately.",
        "As soon as the battery is low, call a nurse.",
        "Visit ward 1 once.",
        "Call a nurse once the floor is wet.",
        "When the battery is low, call a nurse sooner or later.",
    ],
)
def test_what_english_settles_is_not_asked(sentence: str) -> None:
    extraction = extract(sentence, HOSPITAL, None)
    assert extraction.status is Status.OK, extraction.question or extraction.reason


def test_the_answers_to_a_question_can_all_be_met_and_differ() -> None:
    for sentence in ("Do not visit all wards.", "Visit ward 1 or ward 2 and ward 3."):
        one, other = extract(sentence, HOSPITAL, None).alternatives
        assert satisfiable(one.formula)
        assert satisfiable(other.formula)
        assert not equivalent(one.formula, other.formula)
        assert one.english != other.english
