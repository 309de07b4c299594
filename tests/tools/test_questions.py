"""The page of questions and answers shows what is answered."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def test_the_page_of_answers_is_what_the_robot_says() -> None:
    done = subprocess.run(
        [sys.executable, str(ROOT / "tools" / "questions.py"), "--check"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr or "python tools/questions.py writes it anew"
    assert (ROOT / "docs" / "questions.md").read_text().count("\n**") >= 30
