"""Keep what the documents show true: rerun the commands in them, and draw the pictures.

    python tools/documents.py            rewrite README.md and docs/*.svg
    python tools/documents.py --check    say whether README.md shows what the commands print

A block is marked `<!-- made by: COMMAND -->` and ended by `<!-- end -->`.
"""

import contextlib
import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
README = ROOT / "README.md"
WIDTH = 88
BLOCK = re.compile(
    r"<!-- made by: (?P<command>plainspoken .*?) -->\n(?P<shown>.*?)<!-- end -->", re.DOTALL
)
SECONDS = re.compile(r"\d+\.\d+ s\b|\d+ ms\b")


def _environment(home: str) -> dict[str, str]:
    return {**os.environ, "COLUMNS": str(WIDTH), "PLAINSPOKEN_HOME": home, "NO_COLOR": "1"}


def printed(command: str, home: str) -> str:
    """What a command prints, standard error included, as a terminal would show it."""
    return subprocess.run(
        [sys.executable, "-m", *shlex.split(command)],
        env=_environment(home),
        check=False,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    ).stdout


def rewritten(text: str) -> str:
    """The document with every block made anew."""
    with tempfile.TemporaryDirectory() as home:

        def made(block: re.Match[str]) -> str:
            command = block["command"]
            lines = [line.rstrip() for line in printed(command, home).splitlines()]
            shown = "\n".join([f"$ {command}", *lines])
            return f"<!-- made by: {command} -->\n```text\n{shown}\n```\n<!-- end -->"

        return BLOCK.sub(made, text)


def is_true(text: str) -> bool:
    """Whether a document shows what its commands print; times may differ."""
    return SECONDS.sub("", rewritten(text)) == SECONDS.sub("", text)


def draw(folder: Path) -> None:
    """The terminal of the demo, and the policy of its mission."""
    from rich.console import Console  # noqa: PLC0415 - checking needs no pictures

    from plainspoken.cli.demo import SENTENCE, play_demo  # noqa: PLC0415 - as above

    with tempfile.TemporaryDirectory() as home:
        with Path(os.devnull).open("w") as nowhere:
            # A file is no terminal, so that a live table is printed once and not at each change.
            console = Console(record=True, width=100, file=nowhere, color_system="truecolor")
            with contextlib.chdir(home):  # so that the picture shows no folder of this machine
                play_demo(console, pace=0.0, store="missions.sqlite")
        console.save_svg(str(folder / "demo.svg"), title="make demo")
        policy = Path(home, "policy.json")
        printed(f"plainspoken plan --say {shlex.quote(SENTENCE)} --out {policy}", home)
        dot = printed(f"plainspoken export dot {policy} --words", home)
    drawn = subprocess.run(
        ["dot", "-Tsvg"], input=dot, capture_output=True, text=True, check=True
    ).stdout
    (folder / "policy.svg").write_text(drawn)


def main() -> None:
    """Rewrite, or with --check compare."""
    text = README.read_text()
    if "--check" in sys.argv:
        sys.exit(0 if is_true(text) else "README.md is stale: python tools/documents.py")
    README.write_text(rewritten(text))
    draw(ROOT / "docs")


if __name__ == "__main__":
    main()
