"""The page where people log in: what a viewer may not do, and two operators who command at once."""

from collections.abc import Iterator
from pathlib import Path

import pytest

pytest.importorskip("nicegui", reason="the page is an extra: pip install 'plainspoken[web]'")
pytest.importorskip("playwright", reason="tests drive the browser by playwright: make web")

from playwright.sync_api import Page, expect
from tests.web.browsing import (
    LONG,
    PATIENCE,
    Served,
    ask,
    browsers,
    needs_browser,
    started,
    status,
)

from plainspoken.web.access import Role, Token, append_grant, new_grant

pytestmark = [needs_browser, pytest.mark.timeout(LONG)]
expect.set_options(timeout=PATIENCE)
SENTENCE = "Visit line 3"
PEOPLE = {"ada": Role.OPERATOR, "bob": Role.OPERATOR, "vera": Role.VIEWER}


@pytest.fixture(scope="module")
def tokens() -> dict[str, Token]:
    return {}


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory, tokens: dict[str, Token]) -> Iterator[Served]:
    """A server whose robots wait before the end of their second action."""
    folder = tmp_path_factory.mktemp("guarded")
    for name, role in PEOPLE.items():
        tokens[name], grant = new_grant(role, name)
        append_grant(folder / "tokens", grant)
    found = Served(folder, "--tokens", str(folder / "tokens"))
    found.may_end(1)
    yield found
    found.stop()


@pytest.fixture
def pages(server: Served, tokens: dict[str, Token], tmp_path: Path) -> Iterator[dict[str, Page]]:
    """A page for each of them, in a browser of their own."""
    with browsers([tmp_path / name for name in PEOPLE]) as windows:
        found = {}
        for name, window in zip(PEOPLE, windows, strict=True):
            page = found[name] = window.new_page()
            page.goto(server.url)
            page.get_by_label("Your token").fill(tokens[name])
            page.get_by_role("button", name="Log in").click()
            page.get_by_label("Say it in your own words").wait_for()
        yield found


def test_a_viewer_looks_and_asks_and_is_refused_every_command_in_words(
    server: Served, pages: dict[str, Page]
) -> None:
    address = started(pages["ada"], server.url, SENTENCE)
    vera = pages["vera"]
    vera.goto(address)
    status(vera, "running")
    expect(vera.locator(".visitor")).to_have_text("vera (may look and ask)")
    assert "line" in ask(vera, "What are you doing now?")
    for name in ("Pause", "Go on", "Change …", "Cancel …", "Speak"):
        expect(vera.get_by_role("button", name=name)).to_have_count(0)
    assert "an operator commands" in ask(vera, "pause")
    # Who knows how to press what is hidden, and who goes past the page, gets no further.
    vera.locator(".controls button", has_text="Pause").evaluate("button => button.click()")
    vera.locator(".controls button", has_text="Cancel").evaluate("button => button.click()")
    mission = address.rpartition("/")[2]
    refused = vera.evaluate(
        """async (mission) => {
            const answer = await fetch(`/api/v1/missions/${mission}/pause`, {
                method: "POST", headers: {"Content-Type": "application/json"}, body: '{"seen": 0}',
            });
            return [answer.status, (await answer.json()).what];
        }""",
        mission,
    )
    assert refused == [403, "vera may look and ask, not command"]
    # What was sent after all that is answered, so all that has been heard.
    ask(vera, "Are you paused?")
    for page in (vera, pages["ada"]):
        status(page, "running")
        expect(page.locator(".timeline")).not_to_contain_text("paused by")
        expect(page.locator(".timeline")).not_to_contain_text("cancelled")


def test_a_viewer_starts_nothing(pages: dict[str, Page]) -> None:
    vera = pages["vera"]
    vera.get_by_label("Say it in your own words").fill(SENTENCE)
    vera.get_by_role("button", name="Understand").click()
    expect(vera.locator(".understood .note")).to_contain_text("an operator starts missions")
    expect(vera.get_by_role("button", name="Yes, make a plan")).to_have_count(0)


def test_who_confirms_what_they_asked_before_another_commanded_is_told_and_nothing_is_done(
    server: Served, pages: dict[str, Page]
) -> None:
    ada, bob = pages["ada"], pages["bob"]
    address = started(ada, server.url, SENTENCE)
    bob.goto(address)
    status(bob, "running")
    bob.get_by_role("button", name="Cancel …").click()
    yes = bob.get_by_role("button", name="Yes, cancel it")
    expect(yes).to_be_visible()
    ada.get_by_role("button", name="Pause").click()
    status(ada, "paused")
    status(bob, "paused")
    yes.click()
    told = bob.get_by_text("Nothing was done: meanwhile ada")
    expect(told).to_contain_text("ask again if you still want it")
    status(ada, "paused")
    bob.get_by_role("button", name="Cancel …").click()
    bob.get_by_role("button", name="Yes, cancel it").click()
    status(ada, "cancelled")
