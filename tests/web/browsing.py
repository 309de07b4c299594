"""A browser for tests, and the page as a stranger would start it: from the command line."""

import os
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from urllib.error import HTTPError, URLError
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


SERVING = Path(__file__).with_name("serving.py")


class Served:
    """A server of the page, which can be killed and started again with the same store."""

    def __init__(self, folder: Path, *options: str) -> None:
        """Start it; its store, and what its robots may do, are kept in the folder."""
        self._folder = folder
        self._options = options
        self.port = free_port()
        self.url = f"http://127.0.0.1:{self.port}"
        self.start()

    def may_end(self, actions: int) -> None:
        """Let robots end so many actions of each mission, and wait before the end of the next."""
        written = self._folder / "allowed.new"
        written.write_text(str(actions))
        written.replace(self._folder / "allowed")

    def start(self) -> None:
        arguments = (str(self.port), self._folder / "missions.db", self._folder / "allowed")
        # What NiceGUI makes of itself inside of tests is not what we want to see.
        environment = {k: v for k, v in os.environ.items() if not k.startswith("PYTEST")}
        self._process = subprocess.Popen(
            [sys.executable, SERVING, *arguments, *self._options], env=environment
        )
        wait_for(self.url, self._process)

    def kill(self) -> None:
        """End it as a power cut would."""
        self._process.kill()
        self._process.wait()

    def stop(self) -> None:
        stop(self._process)


def wait_for(url: str, process: subprocess.Popen[bytes]) -> None:
    """Wait until a server answers."""
    for _ in range(600):
        assert process.poll() is None, "the server ended"
        try:
            urlopen(f"{url}/missions", timeout=20).close()  # noqa: S310 - it is our own server
        except HTTPError:
            return  # it lives, and asks for a token
        except (URLError, OSError):
            time.sleep(0.1)
        else:
            return
    raise AssertionError("the server does not answer")


def stop(process: subprocess.Popen[bytes]) -> None:
    """End a server as Ctrl-C does."""
    process.send_signal(signal.SIGINT)
    try:
        process.wait(30)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def free_port() -> int:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        port: int = taken.getsockname()[1]
        return port


@contextmanager
def browser(folder: Path, *flags: str, **options: object) -> Iterator[BrowserContext]:
    """A browser of its own, with nothing in it; flags: more of Chromium's."""
    with browsers([folder], *flags, **options) as (found,):
        yield found


@contextmanager
def browsers(
    folders: Sequence[Path], *flags: str, **options: object
) -> Iterator[list[BrowserContext]]:
    """Browsers that know nothing of each other, one in each folder."""
    with sync_playwright() as playwright, ExitStack() as opened:
        found = []
        for folder in folders:
            context = playwright.chromium.launch_persistent_context(
                str(folder),
                executable_path=CHROMIUM,
                args=[*FLAGS, *flags],
                **{"reduced_motion": "reduce", **options},
            )
            opened.callback(context.close)
            context.set_default_timeout(PATIENCE)
            context.set_default_navigation_timeout(PATIENCE)
            found.append(context)
        yield found


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
    answers = page.locator(".turns > li.robot > p")
    before = answers.count()
    page.get_by_label("Ask, or tell me something").fill(question)
    page.get_by_role("button", name="Ask", exact=True).click()
    answers.nth(before).wait_for()
    return answers.nth(before).inner_text()


def status(page: Page, word: str) -> None:
    """Wait until the mission stands so."""
    page.locator(".status", has_text=word).wait_for()
