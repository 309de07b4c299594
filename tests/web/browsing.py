"""A browser for tests, and the page as a stranger would start it: from the command line."""

import os
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from urllib.error import URLError
from urllib.request import urlopen

import pytest
from playwright.sync_api import BrowserContext, Page, sync_playwright

CHROMIUM = shutil.which("chromium")
FLAGS = (
    *("--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"),
    *("--disable-background-networking", "--disable-component-update", "--disable-sync"),
)
PATIENCE = 60_000
"""Milliseconds: nothing here is about time, and both cores may be busy."""
LONG = 240

needs_browser = pytest.mark.skipif(
    CHROMIUM is None, reason="there is no Chromium: apt-get install chromium"
)


class Served:
    """A server of the page, which can be killed and started again with the same store."""

    def __init__(self, store: Path, options: Sequence[str] = ()) -> None:
        self.store = store
        self.options = tuple(options)
        self.port = free_port()
        self.url = f"http://127.0.0.1:{self.port}"
        self._process: subprocess.Popen[bytes] | None = None
        self.start()

    def start(self) -> None:
        command = [sys.executable, "-m", "plainspoken", "serve", "--port", str(self.port)]
        environment = {k: v for k, v in os.environ.items() if not k.startswith(("PYTEST", "NICEGUI"))}
        self._process = subprocess.Popen(
            [*command, "--store", str(self.store), *self.options], env=environment
        )
        for _ in range(600):
            assert self._process.poll() is None, "the server ended"
            try:
                urlopen(f"{self.url}/missions", timeout=5).close()
            except (URLError, OSError):
                time.sleep(0.1)
            else:
                return
        raise AssertionError("the server does not answer")

    def kill(self) -> None:
        """End it as a power cut would."""
        assert self._process is not None
        self._process.kill()
        self._process.wait()

    def stop(self) -> None:
        assert self._process is not None
        self._process.send_signal(signal.SIGINT)
        try:
            self._process.wait(30)
        except subprocess.TimeoutExpired:
            self.kill()


def free_port() -> int:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        port: int = taken.getsockname()[1]
        return port


@contextmanager
def served(store: Path, *options: str) -> Iterator[Served]:
    server = Served(store, options)
    try:
        yield server
    finally:
        server.stop()


@contextmanager
def browser(folder: Path, **options: object) -> Iterator[BrowserContext]:
    """A browser of its own, with nothing in it."""
    with sync_playwright() as playwright:
        context = playwright.chromium.launch_persistent_context(
            str(folder), executable_path=CHROMIUM, args=list(FLAGS), **options
        )
        context.set_default_timeout(PATIENCE)
        context.set_default_navigation_timeout(PATIENCE)
        try:
            yield context
        finally:
            context.close()


def say(page: Page, url: str, sentence: str) -> None:
    """Say what should be done, on the page where missions begin."""
    page.goto(url)
    page.get_by_label("Say it in your own words").fill(sentence)
    page.get_by_role("button", name="Understand").click()


def started(page: Page, url: str, sentence: str) -> str:
    """Say, confirm, and watch: the address of the mission."""
    say(page, url, sentence)
    page.get_by_role("button", name="Yes, make a plan").click()
    page.get_by_role("button", name="Yes, start").click()
    page.wait_for_url("**/missions/*")
    page.get_by_role("heading", name="What was asked for").wait_for()
    return page.url


def ask(page: Page, question: str) -> str:
    """Ask, and give the answer."""
    answers = page.locator(".talk > li.robot > p")
    before = answers.count()
    page.get_by_label("Ask, or tell me something").fill(question)
    page.get_by_role("button", name="Ask", exact=True).click()
    answers.nth(before).wait_for()
    return answers.nth(before).inner_text()


def status(page: Page, word: str) -> None:
    """Wait until the mission stands so."""
    page.locator(".status", has_text=word).wait_for()
