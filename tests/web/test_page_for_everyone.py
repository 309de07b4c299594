"""The page on a phone, in the dark, by keyboard alone, and as axe-core sees it."""

from collections.abc import Iterator
from pathlib import Path

import pytest

pytest.importorskip("nicegui", reason="the page is an extra: pip install 'plainspoken[web]'")
pytest.importorskip("axe_playwright_python", reason="axe-core comes with the dev dependencies")

from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Page, expect
from tests.web.browsing import LONG, PATIENCE, Served, ask, browser, needs_browser, say, started

pytestmark = [needs_browser, pytest.mark.timeout(2 * LONG)]
expect.set_options(timeout=PATIENCE)
PHONE, DESK = {"width": 390, "height": 844}, {"width": 1280, "height": 900}
SENTENCE = "Clear line 2, but never enter line 3 while the bin is full"


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    found = Served(tmp_path_factory.mktemp("served"))
    found.may_end(2)
    yield found
    found.stop()


def serious(page: Page) -> dict[str, list[str]]:
    """What axe-core finds that keeps somebody from using the page."""
    found = Axe().run(page).response["violations"]
    return {
        each["id"]: [node["html"][:160] for node in each["nodes"]]
        for each in found
        if each["impact"] in ("serious", "critical")
    }


def is_too_wide(page: Page) -> bool:
    """Whether one has to scroll sideways."""
    wide: bool = page.evaluate("document.documentElement.scrollWidth > innerWidth")
    return wide


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", [PHONE, DESK], ids=["phone", "desk"])
def test_no_view_keeps_anybody_out(
    server: Served, tmp_path: Path, size: dict[str, int], scheme: str
) -> None:
    with browser(
        tmp_path / "profile", viewport=size, color_scheme=scheme, reduced_motion="reduce"
    ) as window:
        page = window.new_page()
        page.goto(server.url)
        page.get_by_label("Say it in your own words").wait_for()
        views = {"empty": serious(page)}
        say(page, server.url, "Go to the line")
        page.locator(".question").wait_for()
        views["asked back"] = serious(page)
        say(page, server.url, SENTENCE)
        page.locator("ul.examples").wait_for()
        views["understood"] = serious(page)
        assert not is_too_wide(page)
        started(page, server.url, SENTENCE)
        if size is PHONE:
            page.get_by_role("tab", name="Talk").click()
        ask(page, "What are you doing now?")
        assert not is_too_wide(page)
        for name in ("Map", "Talk", "Plan", "Events", "Known"):
            tab = page.get_by_role("tab", name=name)
            if tab.is_visible():
                tab.click()
                views[name] = serious(page)
                assert not is_too_wide(page)
        page.goto(f"{server.url}/missions")
        page.locator(".missions").wait_for()
        views["missions"] = serious(page)
    assert {name: found for name, found in views.items() if found} == {}


def test_a_mission_is_said_started_and_paused_by_keyboard_alone(
    server: Served, tmp_path: Path
) -> None:
    server.may_end(1)
    with browser(tmp_path / "profile", viewport=DESK, reduced_motion="reduce") as window:
        page = window.new_page()
        page.goto(server.url)
        page.get_by_label("Say it in your own words").wait_for()
        press_to(page, "Say it in your own words")
        page.keyboard.type("Visit line 3")
        page.keyboard.press("Enter")
        page.get_by_role("button", name="Yes, make a plan").wait_for()
        press_to(page, "Yes, make a plan")
        assert outlined(page)
        page.keyboard.press("Enter")
        page.get_by_role("button", name="Yes, start").wait_for()
        press_to(page, "Yes, start")
        page.keyboard.press("Enter")
        page.wait_for_url("**/missions/*")
        page.get_by_role("button", name="Pause").wait_for()
        press_to(page, "Pause")
        page.keyboard.press("Space")
        page.locator(".status.paused").wait_for()
        press_to(page, "Events")
        page.keyboard.press("ArrowRight")
        expect(page.locator(".panel.known")).to_be_visible()
        press_to(page, "Cancel …")
        page.keyboard.press("Enter")
        page.get_by_role("dialog").wait_for()
        page.keyboard.press("Escape")
        expect(page.get_by_role("dialog")).to_be_hidden()


def press_to(page: Page, name: str) -> None:
    """Press Tab until something of that name has the focus."""
    for _ in range(80):
        page.keyboard.press("Tab")
        own: str = page.evaluate(
            "() => { const e = document.activeElement;"
            " return (e.getAttribute('aria-label') || e.innerText || '').trim() }"
        )
        if own == name:
            return
    raise AssertionError(f"nobody gets to {name} by keyboard")


def outlined(page: Page) -> bool:
    """Whether one sees what has the focus."""
    width: str = page.evaluate("getComputedStyle(document.activeElement).outlineWidth")
    return width not in ("", "0px")
