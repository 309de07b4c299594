import json

import pytest

from plainspoken.errors import PlainspokenError
from plainspoken.logic.syntax import parse
from plainspoken.mission.mailbox import Asked, from_message, to_message
from plainspoken.mission.observation import (
    CancelAsked,
    ChangeAsked,
    PauseAsked,
    ResumeAsked,
    Told,
)
from plainspoken.mission.request import Clause

CHANGE = ChangeAsked("ada", "skip line 3", (Clause(parse("F a & G !b"), 2),), "in words")


@pytest.mark.parametrize(
    "asked",
    [
        PauseAsked("ada"),
        ResumeAsked("bob \u2028 ü"),
        CancelAsked(""),
        Told("ada", "I did it", frozenset({"cleared l0", "at sup l0"}), frozenset({"full b"})),
        CHANGE,
    ],
)
def test_what_is_asked_comes_out_of_the_mailbox_as_it_went_in(asked: Asked) -> None:
    assert from_message(to_message(asked)) == asked


@pytest.mark.parametrize(
    "text",
    [
        "no json",
        "[]",
        json.dumps({"ask": "pause"}),
        json.dumps({"ask": "dance", "by": "ada"}),
        json.dumps({"ask": "change", "by": "a", "text": "", "clauses": [{}], "english": ""}),
    ],
)
def test_what_is_no_request_is_refused(text: str) -> None:
    with pytest.raises(PlainspokenError):
        from_message(text)
