"""Make the pictures of the page that the documentation shows: phone and desktop, light and dark.

usage: screenshots.py [FOLDER]    docs/page by default; needs Debian's Chromium and the dev tools
"""

import shutil
import socket
import subprocess
import sys
import tempfile
import time
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


def main(arguments: list[str]) -> int:
    """Start a server and go through its views; return the exit code."""
    chromium = shutil.which("chromium")
    if chromium is None:
        print("screenshots: there is no Chromium; try: apt-get install chromium", file=sys.stderr)
        return 2
    folder = Path(arguments[0]) if arguments else ROOT / "docs" / "page"
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch, socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = str(free.getsockname()[1])
        free.close()
        command = [sys.executable, "-m", "plainspoken", "serve", "--demo", "--port", port]
        options = ["--store", f"{scratch}/missions.db", "--pace", "1.2", "--steer", "ripe g2"]
        server = subprocess.Popen([*command, *options])
        try:
            url = f"http://127.0.0.1:{port}"
            wait_for(url)
            with sync_playwright() as playwright:
                for name, size in SIZES.items():
                    for scheme in ("light", "dark"):
                        context = playwright.chromium.launch_persistent_context(
                            f"{scratch}/{name}-{scheme}",
                            executable_path=chromium,
                            args=list(FLAGS),
                            viewport={"width": size[0], "height": size[1]},
                            color_scheme=scheme,
                            reduced_motion="reduce",
                        )
                        context.set_default_timeout(PATIENCE)
                        views(context.new_page(), url, folder, f"{name}-{scheme}")
                        context.close()
        finally:
            server.terminate()
            server.wait()
    return 0


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


def views(page: Page, url: str, folder: Path, kind: str) -> None:
    """Take each view once."""

    def taken(name: str, *, whole: bool = False) -> None:
        page.screenshot(path=folder / f"{name}-{kind}.png", full_page=whole)
        print(f"{name}-{kind}")

    page.goto(url)
    page.get_by_label("Say it in your own words").fill(SENTENCE)
    page.get_by_role("button", name="Understand").click()
    page.get_by_role("button", name="Yes, make a plan").click()
    page.get_by_role("button", name="Yes, start").wait_for()
    taken("say", whole=True)
    page.get_by_role("button", name="Yes, start").click()
    page.wait_for_url("**/missions/*")
    page.locator(".timeline", has_text="grape 2 is ripe").wait_for(state="attached")
    page.get_by_role("button", name="Pause").click()
    page.locator(".status.paused").wait_for()
    page.locator(".doing", has_text="wait until").wait_for()
    if "phone" in kind:
        page.get_by_role("tab", name="Talk").click()
    for question in ("Why did you check grape 2?", "What will you do next?"):
        answers = page.locator(".turns > li.robot")
        before = answers.count()
        page.get_by_label("Ask, or tell me something").fill(question)
        page.get_by_role("button", name="Ask", exact=True).click()
        answers.nth(before).wait_for()
    if "phone" in kind:
        taken("talk")
        page.get_by_role("tab", name="Map").click()
    else:
        page.get_by_role("tab", name="Events").click()
        page.locator("button.evidence").last.hover()
    taken("mission")
    for name in ("Plan", "Events", "Known"):
        page.get_by_role("tab", name=name).click()
        page.wait_for_timeout(1500)  # Cytoscape draws when it likes, and says nothing of it
        if "desktop" in kind:
            page.get_by_role("tab", name=name).scroll_into_view_if_needed()
        taken(name.lower(), whole="desktop" in kind)
    page.goto(url)
    page.get_by_label("Say it in your own words").fill("Clear line 3 and never enter line 3")
    page.get_by_role("button", name="Understand").click()
    page.get_by_role("button", name="Yes, make a plan").click()
    page.get_by_role("heading", name="What could be changed").wait_for()
    taken("impossible", whole=True)
    page.goto(f"{url}/missions")
    page.locator(".missions").wait_for()
    taken("missions")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
