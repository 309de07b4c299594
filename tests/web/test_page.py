"""The page in a browser, from saying what should be done to looking at how it was."""

from collections.abc import Iterator
from pathlib import Path

import pytest

pytest.importorskip("nicegui", reason="the page is an extra: pip install 'plainspoken[web]'")
pytest.importorskip("playwright", reason="tests drive the browser by playwright: make web")

from playwright.sync_api import BrowserContext, expect
from tests.web.browsing import (
    LONG,
    PATIENCE,
    Served,
    ask,
    browser,
    needs_browser,
    say,
    started,
    status,
)

pytestmark = [needs_browser, pytest.mark.timeout(LONG)]
expect.set_options(timeout=PATIENCE)
SENTENCE = "Clear line 2, but never enter line 3 while the bin is full"


EVERYTHING = 1000


@pytest.fixture(scope="module")
def shared(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    found = Served(tmp_path_factory.mktemp("served"))
    yield found
    found.stop()


@pytest.fixture
def server(shared: Served) -> Served:
    """A server whose robots wait before the end of their second action, until they may end it."""
    shared.may_end(1)
    return shared


@pytest.fixture
def window(tmp_path: Path) -> Iterator[BrowserContext]:
    with browser(tmp_path / "profile") as found:
        yield found


def test_from_a_sentence_to_a_mission_that_answers_and_is_looked_back_at(
    server: Served, window: BrowserContext
) -> None:
    page = window.new_page()
    failures: list[str] = []
    page.on("pageerror", lambda error: failures.append(str(error)))
    say(page, server.url, SENTENCE)
    expect(page.locator("button.reference")).to_have_count(3)
    expect(page.locator(".english")).to_contain_text("Never visit line 3 while the box is full")
    expect(page.locator("ul.examples svg.trace")).not_to_have_count(0)
    started(page, server.url, SENTENCE)
    assert "line 2" in ask(page, "Why?")
    page.locator("button.evidence").first.hover()
    expect(page.locator("svg.site .lit")).not_to_have_count(0)
    page.get_by_role("button", name="Pause").click()
    status(page, "paused")
    server.may_end(EVERYTHING)
    expect(page.locator(".doing")).to_contain_text("wait until I'm told")
    page.get_by_label("Ask, or tell me something").fill("the support robot is at line 1")
    page.keyboard.press("Enter")
    page.get_by_role("button", name="Yes, that is right").click()
    expect(page.locator(".timeline")).to_contain_text("operator reports")
    page.get_by_role("button", name="Go on").click()
    status(page, "finished")
    page.get_by_role("tab", name="Events").click()
    expect(page.locator(".timeline")).to_contain_text("line 2 is cleared")
    page.locator("button.moment").first.click()
    expect(page.locator(".when")).to_contain_text("step 0 of")
    expect(page.locator(".timeline li")).to_have_count(1)
    page.get_by_role("button", name="Live").click()
    expect(page.locator(".timeline")).to_contain_text("finished")
    assert failures == []


def test_an_impossible_request_says_why_and_what_could_be_left_out(
    server: Served, window: BrowserContext
) -> None:
    page = window.new_page()
    say(page, server.url, "Clear line 3 and never enter line 3")
    page.get_by_role("button", name="Yes, make a plan").click()
    expect(page.locator(".planning .refusal")).to_contain_text("I can't both")
    page.get_by_role("button", name="Leave out: Never visit line 3").click()
    expect(page.get_by_role("heading", name="Start this mission?")).to_be_visible()
    expect(page.locator(".planning .english")).to_have_text(
        "Make sure that line 3 is cleared at some point."
    )


def test_an_ambiguous_request_is_settled_by_a_button(
    server: Served, window: BrowserContext
) -> None:
    page = window.new_page()
    say(page, server.url, "Go to the line")
    expect(page.locator(".question")).to_contain_text("What do you mean")
    page.get_by_role("button", name="line 1: Visit line 1.").click()
    expect(page.locator(".english")).to_have_text("Visit line 1.")
    expect(page.get_by_role("button", name="Yes, make a plan")).to_be_visible()


def test_a_piece_that_was_understood_as_something_else_is_corrected(
    server: Served, window: BrowserContext
) -> None:
    page = window.new_page()
    say(page, server.url, "Visit line 1")
    page.locator("button.reference").click()
    page.get_by_label("It means").click()
    page.get_by_role("option", name="the warehouse", exact=True).click()
    page.get_by_role("button", name="Use this").click()
    expect(page.locator(".english")).to_have_text("Visit the warehouse.")
    expect(page.locator(".meant")).to_have_text("the warehouse")


def test_what_a_person_says_is_shown_and_never_run(server: Served, window: BrowserContext) -> None:
    page = window.new_page()
    hostile = "<img src=x onerror=alert(1)><script>alert(2)</script>"
    dialogs: list[str] = []
    page.on("dialog", lambda dialog: (dialogs.append(dialog.message), dialog.dismiss()))
    say(page, server.url, f"Visit line 1 {hostile}")
    expect(page.locator(".understood .card")).to_be_visible()
    started(page, server.url, "Visit line 2 and line 3")
    ask(page, f"What is {hostile}?")
    expect(page.locator(".turns > li.person").last).to_contain_text("<script>")
    assert page.locator("main img, main script").count() == 0
    assert dialogs == []


def test_a_request_is_changed_once_that_is_confirmed(
    server: Served, window: BrowserContext
) -> None:
    page = window.new_page()
    started(page, server.url, "Visit line 3 and then line 0")
    page.get_by_role("button", name="Change …").click()
    page.get_by_label("What should be different?").fill("Forget all that and visit line 1")
    page.get_by_role("dialog").get_by_role("button", name="Understand").click()
    page.get_by_role("button", name="Yes, from now on").click()
    expect(page.locator(".timeline")).to_contain_text("operator asks for a change")
    server.may_end(EVERYTHING)
    status(page, "finished")
    expect(page.locator(".clauses")).to_have_text("Visit line 1.✓ done")


def test_two_browsers_see_the_same_and_one_is_told_when_the_other_commands(
    server: Served, window: BrowserContext
) -> None:
    first = window.new_page()
    address = started(first, server.url, SENTENCE)
    second = window.new_page()
    second.goto(address)
    status(second, "running")
    first.get_by_role("button", name="Pause").click()
    status(first, "paused")
    status(second, "paused")
    ask(second, "What did you do last?")
    expect(first.locator(".turns")).to_contain_text("What did you do last?")
    first.get_by_role("button", name="Cancel …").click()
    first.get_by_role("button", name="No, leave it").click()
    first.get_by_role("button", name="Cancel …").click()
    first.get_by_role("button", name="Yes, cancel it").click()
    status(first, "cancelled")
    status(second, "cancelled")
    expect(second.get_by_role("button", name="Pause")).to_be_hidden()


def test_a_page_that_is_loaded_again_in_the_middle_shows_all_that_was(
    server: Served, window: BrowserContext
) -> None:
    page = window.new_page()
    started(page, server.url, SENTENCE)
    page.get_by_role("tab", name="Events").click()
    expect(page.locator(".timeline")).to_contain_text("moving to line 1")
    page.reload()
    page.get_by_role("tab", name="Events").click()
    expect(page.locator(".timeline")).to_contain_text("moving to line 1")
    expect(page.locator(".timeline")).to_contain_text(SENTENCE)
    server.may_end(EVERYTHING)
    status(page, "finished")


def test_a_killed_server_goes_on_where_it_was_and_the_page_finds_it(
    server: Served, window: BrowserContext
) -> None:
    page = window.new_page()
    started(page, server.url, SENTENCE)
    page.get_by_role("tab", name="Events").click()
    lines = page.locator(".timeline")
    expect(lines).to_contain_text("moving to line 2")
    server.kill()
    server.may_end(EVERYTHING)
    server.start()
    status(page, "finished")
    expect(lines).to_contain_text("carried out by")
    told = lines.inner_text()
    assert [told.count(f"moving to line {n}") for n in (1, 2)] == [1, 1]
    assert SENTENCE in told
    expect(page.locator(".verdict.good")).not_to_have_count(0)
