"""Make the pictures of the page that the documentation shows: phone and desktop, light and dark.

usage: screenshots.py [FOLDER [SCENE ...]]

FOLDER is docs/page by default; it needs Debian's Chromium and the dev tools, and makes the files
smaller where Pillow is there.
"""

import shutil
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from urllib.error import URLError
from urllib.request import urlopen

from playwright.sync_api import Page, sync_playwright

ROOT = Path(__file__).resolve().parents[1]
SENTENCE = (
    "Clear line 2, but never enter line 3 while the bin is full, "
    "and call the support robot as soon as it is."
)
FLAGS = ("--no-sandbox", "--disable-gpu", "--no-first-run", "--hide-scrollbars")
SIZES = {"desktop": (1280, 860), "phone": (390, 844)}
PATIENCE = 120_000
STORE_ROOM = (
    *("--domain", "examples/store-room/domain.pddl"),
    *("--problem", "examples/store-room/problem.pddl"),
)


Views = Callable[[Page, str, Callable[[str], None]], None]


def main(arguments: list[str]) -> int:
    """Start servers and go through their views; return the exit code."""
    chromium = shutil.which("chromium")
    if chromium is None:
        print("screenshots: there is no Chromium; try: apt-get install chromium", file=sys.stderr)
        return 2
    folder = Path(arguments[0]) if arguments else ROOT / "docs" / "page"
    folder.mkdir(parents=True, exist_ok=True)
    scenes: tuple[tuple[Views, tuple[str, ...]], ...] = (
        (vineyard, ("--demo", "--pace", "1.2", "--steer", "ripe g2")),
        (robots, ("--side-by-side", "--pace", "2")),
        (broken, ("--pace", "2")),
        (unknown, (*STORE_ROOM, "--pace", "2")),
    )
    wanted = arguments[1:] or [scene.__name__ for scene, _ in scenes]
    with tempfile.TemporaryDirectory() as scratch, sync_playwright() as playwright:
        for scene, options in scenes:
            if scene.__name__ not in wanted:
                continue
            store = f"{scratch}/{scene.__name__}"
            with served(f"{store}.db", *options) as url:
                for name, size in SIZES.items():
                    for scheme in ("light", "dark"):
                        context = playwright.chromium.launch_persistent_context(
                            f"{store}-{name}-{scheme}",
                            executable_path=chromium,
                            args=list(FLAGS),
                            viewport={"width": size[0], "height": size[1]},
                            color_scheme=scheme,
                            reduced_motion="reduce",
                        )
                        context.set_default_timeout(PATIENCE)
                        page = context.new_page()
                        scene(page, url, partial(taken, page, folder, f"{name}-{scheme}"))
                        context.close()
    return 0


@contextmanager
def served(store: str, *options: str) -> Iterator[str]:
    """A server of the page, and its address."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = str(free.getsockname()[1])
    command = [sys.executable, "-m", "plainspoken", "serve", "--port", port, "--store", store]
    server = subprocess.Popen([*command, *options], cwd=ROOT)
    try:
        url = f"http://127.0.0.1:{port}"
        wait_for(url)
        yield url
    finally:
        server.terminate()
        server.wait()


def taken(page: Page, folder: Path, kind: str, name: str) -> None:
    """Take a picture: of the whole page where it is wide, of what a phone shows where not."""
    file = folder / f"{name}-{kind}.png"
    whole = name not in ("mission", "robots", "talk") and (
        "desktop" in kind or name in ("say", "impossible", "spoken")
    )
    page.screenshot(path=file, full_page=whole)
    if find_spec("PIL") is not None:  # a fourth of the size, and nobody sees it
        image = import_module("PIL.Image")
        found = image.open(file).convert("RGB").quantize(256, image.Quantize.MAXCOVERAGE, kmeans=4)
        found.save(file, optimize=True)
    print(f"{name}-{kind}")


def wait_for(url: str) -> None:
    """Wait until the server answers."""
    for _ in range(1200):
        try:
            urlopen(f"{url}/missions", timeout=20).close()  # noqa: S310 - it is our own server
        except (URLError, OSError):
            time.sleep(0.1)
        else:
            return
    raise SystemExit("screenshots: the server does not answer")


def started(page: Page, url: str, sentence: str) -> None:
    """Say what should be done, and have a plan for it."""
    page.goto(url)
    page.get_by_label("Say it in your own words").fill(sentence)
    page.get_by_role("button", name="Understand").click()
    page.get_by_role("button", name="Yes, make a plan").click()
    page.get_by_role("button", name="Yes, start").wait_for()


def show(page: Page, name: str) -> None:
    """Turn to a part of a mission's page, where it is not shown anyway."""
    tab = page.get_by_role("tab", name=name)
    if tab.is_visible():
        tab.click()


def tell(page: Page, text: str) -> None:
    """Ask, or tell the mission something, and wait for what it says."""
    show(page, "Talk")
    answers = page.locator(".turns > li.robot")
    before = answers.count()
    page.get_by_label("Ask, or tell me something").fill(text)
    page.get_by_role("button", name="Ask", exact=True).click()
    answers.nth(before).wait_for()


def vineyard(page: Page, url: str, take: Callable[[str], None]) -> None:
    """Everything about one mission of one robot."""
    started(page, url, SENTENCE)
    take("say")
    page.get_by_role("button", name="Yes, start").click()
    page.wait_for_url("**/missions/*")
    page.locator(".timeline", has_text="grape 2 is ripe").wait_for(state="attached")
    page.get_by_role("button", name="Pause").click()
    page.locator(".status.paused").wait_for()
    page.locator(".doing", has_text="wait until").wait_for()
    for question in ("Why did you check grape 2?", "What will you do next?"):
        tell(page, question)
    take("talk")
    show(page, "Map")
    show(page, "Events")
    if page.locator("button.evidence").last.is_visible():
        page.locator("button.evidence").last.hover()
    else:
        show(page, "Map")
    take("mission")
    for name in ("Plan", "Events", "Known"):
        show(page, name)
        page.wait_for_timeout(1500)  # Cytoscape draws when it likes, and says nothing of it
        take(name.lower())
    page.goto(url)
    page.get_by_label("Say it in your own words").fill("Clear line 3 and never enter line 3")
    page.get_by_role("button", name="Understand").click()
    page.get_by_role("button", name="Yes, make a plan").click()
    page.get_by_role("heading", name="What could be changed").wait_for()
    take("impossible")
    page.goto(f"{url}/missions")
    page.locator(".missions").wait_for()
    take("missions")


def robots(page: Page, url: str, take: Callable[[str], None]) -> None:
    """Two robots at work at the same time, on a map that nobody has laid out."""
    page.goto(url)
    page.get_by_label("Place").click()
    page.get_by_role("option", name="warehouse").click()
    page.get_by_label("Say it in your own words").fill("Deliver the crate and the drum")
    page.get_by_role("button", name="Understand").click()
    page.get_by_role("button", name="Yes, make a plan").click()
    page.get_by_role("button", name="Yes, start").click()
    page.wait_for_url("**/missions/*")
    page.locator(".robot.busy").nth(1).wait_for(state="attached")
    take("robots")
    page.get_by_role("button", name="Pause").click()
    page.locator(".status.paused").wait_for()
    show(page, "Events")
    take("robots-events")


def broken(page: Page, url: str, take: Callable[[str], None]) -> None:
    """A request that can be met no more, with the part that was broken."""
    started(page, url, "Clear line 2, and never visit line 3")
    page.get_by_role("button", name="Yes, start").click()
    page.wait_for_url("**/missions/*")
    page.get_by_role("button", name="Pause").click()
    page.locator(".status.paused").wait_for()
    page.locator(".doing", has_text="wait until").wait_for()
    tell(page, "You are at line 3")
    page.get_by_role("button", name="Yes, that is right").click()
    page.locator(".verdict.bad").wait_for(state="attached")
    show(page, "Events")
    take("broken")


def unknown(page: Page, url: str, take: Callable[[str], None]) -> None:
    """A mission that does not know everything, and looks."""
    started(page, url, "Bring the parcel to the ramp")
    page.get_by_role("button", name="Yes, start").click()
    page.wait_for_url("**/missions/*")
    page.locator(".timeline", has_text="looked").wait_for(state="attached")
    page.get_by_role("button", name="Pause").click()
    page.locator(".status.paused").wait_for()
    show(page, "Known")
    take("unknown")
    show(page, "Events")
    take("looks")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
