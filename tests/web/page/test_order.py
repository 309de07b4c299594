import pytest

pytest.importorskip("nicegui", reason="the page is an extra: pip install 'plainspoken[web]'")

from plainspoken.questions.kind import Kind
from plainspoken.web.page.order import Order, order_in


@pytest.mark.parametrize(
    ("text", "order"),
    [
        ("pause", "pause"), ("Stop!", "pause"), ("please wait", "pause"), ("hold on", "pause"),
        ("go on", "resume"), ("Please continue", "resume"), ("resume the mission", "resume"),
        ("cancel the mission", "cancel"), ("abort", "cancel"),
    ],
)  # fmt: skip
def test_plain_orders_are_known_whatever_the_reader_of_questions_says(
    text: str, order: Order
) -> None:
    assert order_in(text, Kind.COMMAND) == order
    assert order_in(text, Kind.CHITCHAT) == order


@pytest.mark.parametrize(
    "text", ["Stop at line 2", "Wait until the box is full", "Go on to line 3", "cancel line 2"]
)
def test_an_order_that_says_more_is_a_change_of_what_is_asked_for(text: str) -> None:
    assert order_in(text, Kind.COMMAND) == "change"


def test_a_report_is_one_and_a_question_is_no_order() -> None:
    assert order_in("the box is full", Kind.REPORT) == "report"
    assert order_in("Why did you stop?", Kind.WHY_ACTION) is None
