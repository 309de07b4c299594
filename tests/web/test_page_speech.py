"""Speaking to the page: Chromium's microphone plays a file, and the page sends what it hears."""

import re
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

import pytest

pytest.importorskip("nicegui", reason="the page is an extra: pip install 'plainspoken[web]'")
pytest.importorskip("playwright", reason="tests drive the browser by playwright: make web")

import numpy as np
from playwright.sync_api import Page, expect
from tests.language.recordings import pcm16, tone, wav
from tests.web.browsing import LONG, PATIENCE, Served, browser, needs_browser, started

from plainspoken.backends import espeak, whisper

pytestmark = [needs_browser, pytest.mark.timeout(LONG)]
expect.set_options(timeout=PATIENCE)
FLAGS = ("--use-fake-device-for-media-stream", "--use-fake-ui-for-media-stream")


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    """A server that hears a tone of 300 Hz as "never visit line 3"."""
    found = Served(tmp_path_factory.mktemp("served"))
    found.may_end(1)
    yield found
    found.stop()


def microphone(file: Path, content: bytes) -> tuple[str, ...]:
    """The flags that have a recording played into the microphone, again and again."""
    file.write_bytes(content)
    return (*FLAGS, f"--use-file-for-fake-audio-capture={file}")


@pytest.fixture
def page(tmp_path: Path) -> Iterator[Page]:
    flags = microphone(tmp_path / "tone.wav", wav(pcm16(tone(300, 4))))
    with browser(tmp_path / "profile", *flags) as window:
        yield window.new_page()


def field(page: Page, url: str) -> None:
    page.goto(url)
    page.get_by_label("Say it in your own words").wait_for()


def listened(page: Page, seconds: int) -> None:
    """Wait until the page has heard so much, however long that takes it."""
    expect(page.locator(".microphone .seconds")).to_have_text(
        re.compile(rf"^({'|'.join(map(str, range(seconds, 56)))}) s$")
    )


def test_what_is_said_stands_in_the_field_with_its_weighty_words_and_nothing_is_made_of_it(
    server: Served, page: Page
) -> None:
    field(page, server.url)
    page.get_by_role("button", name="Speak").click()
    listened(page, 1)
    expect(page.get_by_label("how loud you are")).to_be_visible()
    page.get_by_role("button", name="End").click()
    said = page.get_by_label("Say it in your own words")
    expect(said).to_have_value("Never visit line 3")
    weighty = page.locator(".weight")
    expect(weighty).to_have_text(["Nevernegation", "3number"])
    expect(page.locator(".understood .card")).to_have_count(0)
    said.fill("Visit line 2 and line 1")
    expect(weighty).to_have_text(["2number", "1number"])
    page.get_by_role("button", name="Understand").click()
    expect(page.locator(".english")).to_contain_text("line 2")


def test_a_button_that_is_held_ends_with_being_let_go(server: Served, page: Page) -> None:
    field(page, server.url)
    page.get_by_role("button", name="Speak").hover()
    page.mouse.down()
    listened(page, 1)
    page.mouse.up()
    expect(page.get_by_label("Say it in your own words")).to_have_value("Never visit line 3")


def test_by_keyboard_one_begins_ends_and_gives_up(server: Served, page: Page) -> None:
    field(page, server.url)
    button = page.locator(".microphone button")
    button.press("Enter")
    listened(page, 1)
    button.press("Escape")
    expect(button).to_have_text("Speak")
    expect(page.get_by_label("Say it in your own words")).to_have_value("")
    button.press("Space")
    listened(page, 1)
    button.press("Space")
    expect(page.get_by_label("Say it in your own words")).to_have_value("Never visit line 3")


def test_a_question_is_spoken_and_its_answer_read_aloud_once_that_is_switched_on(
    server: Served, page: Page
) -> None:
    page.add_init_script(
        "window.said = []; speechSynthesis.speak = (words) => window.said.push(words.text);"
    )
    started(page, server.url, "Visit line 3")
    asked = page.get_by_label("Ask, or tell me something")
    page.get_by_role("button", name="Speak").click()
    listened(page, 1)
    page.get_by_role("button", name="End").click()
    expect(asked).to_have_value("Never visit line 3")
    answers = page.locator(".turns > li.robot > p")
    asked.fill("Where are you?")
    asked.press("Enter")
    expect(answers).to_have_count(1)
    assert page.evaluate("window.said") == []
    aloud = page.get_by_role("button", name="Read answers aloud")
    expect(aloud).to_have_attribute("aria-pressed", "false")
    aloud.click()
    expect(aloud).to_have_attribute("aria-pressed", "true")
    asked.fill("What are you doing now?")
    asked.press("Enter")
    expect(answers).to_have_count(2)
    page.wait_for_function("window.said.length > 0")
    assert page.evaluate("window.said") == [answers.nth(1).inner_text()]


def test_silence_is_told_and_the_field_stays_as_it_was(server: Served, tmp_path: Path) -> None:
    flags = microphone(tmp_path / "silence.wav", wav(pcm16(np.zeros(64_000, np.float32))))
    with browser(tmp_path / "profile", *flags) as window:
        page = window.new_page()
        field(page, server.url)
        page.get_by_label("Say it in your own words").fill("Visit line 1")
        page.get_by_role("button", name="Speak").click()
        listened(page, 1)
        page.get_by_role("button", name="End").click()
        expect(page.locator(".microphone [role=status]")).to_contain_text("no speech was heard")
        expect(page.get_by_label("Say it in your own words")).to_have_value("Visit line 1")


def test_where_nobody_can_be_heard_the_button_says_what_to_install(tmp_path: Path) -> None:
    server = Served(tmp_path, "--deaf")
    try:
        with browser(tmp_path / "profile") as window:
            page = window.new_page()
            field(page, server.url)
            page.get_by_role("button", name="Speak").click()
            expect(page.locator(".microphone [role=status]")).to_have_text("pip install ears")
    finally:
        server.stop()


@pytest.mark.timeout(3 * LONG)
@pytest.mark.skipif(not espeak.is_installed(), reason="espeak-ng says the sentence: install it")
@pytest.mark.skipif(
    not (find_spec("faster_whisper") and whisper.packaged_weights()),
    reason="Whisper listens: make speech",
)
def test_whisper_hears_what_is_said_into_the_microphone(tmp_path: Path) -> None:
    spoken = espeak.Espeak("en-us", 150).recorded("Clear line 2, but never enter line 3.")
    server = Served(tmp_path, "--whisper")
    flags = microphone(tmp_path / "spoken.wav", spoken)
    try:
        with browser(tmp_path / "profile", *flags) as window:
            page = window.new_page()
            field(page, server.url)
            page.get_by_role("button", name="Speak").click()
            listened(page, 4)
            page.get_by_role("button", name="End").click()
            said = page.get_by_label("Say it in your own words")
            expect(said).to_have_value(
                re.compile(r"line 2.*never.*line 3", re.IGNORECASE), timeout=180_000
            )
            expect(page.locator(".weight.negation mark")).to_have_text(["never"])
    finally:
        server.stop()
