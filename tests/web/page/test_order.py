import pytest

pytest.importorskip("nicegui", reason="the page is an extra: pip install 'plainspoken[web]'")

from plainspoken.web.page.order import Order, order_in


@pytest.mark.parametrize(
    ("text", "order"),
    [
        ("pause", "pause"), ("Stop!", "pause"), ("please wait", "pause"), ("hold on", "pause"),
        ("go on", "resume"), ("Please continue", "resume"), ("resume the mission", "resume"),
        ("cancel the mission", "cancel"), ("abort", "cancel"),
    ],
)  # fmt: skip
def test_a_plain_order_is_known(text: str, order: Order) -> None:
    assert order_in(text) == order


@pytest.mark.parametrize(
    "text",
    ["Stop at line 2", "Wait until the box is full", "Go on to line 3", "Why did you stop?", ""],
)
def test_what_says_more_is_left_to_whoever_understands_it(text: str) -> None:
    assert order_in(text) is None
