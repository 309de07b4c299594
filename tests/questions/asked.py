"""Questions with their expected kind and referents, and how many of them are understood.

    python -m tests.questions.asked tests/questions/people.txt

prints the figure for each kind and every question that is misunderstood.
"""

import sys
from collections import Counter
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from tests.questions.missions import FURTHER, SETTINGS, accepted

from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.moment import lexicon_of
from plainspoken.questions.question import question_of


@dataclass(frozen=True)
class Asked:
    """A question as a person put it, and how it is meant."""

    setting: str
    kind: str
    objects: frozenset[str]
    text: str

    @property
    def taken_for(self) -> tuple[str, frozenset[str]]:
        question = question_of(self.text, lexicon(self.setting))
        return str(question.kind), frozenset(question.referents.objects)

    @property
    def understood(self) -> bool:
        return self.taken_for == (self.kind, self.objects)


@cache
def lexicon(setting: str) -> Lexicon:
    return lexicon_of(accepted({**SETTINGS, **FURTHER}[setting]))


def asked_in(path: Path) -> tuple[Asked, ...]:
    """The questions of a file: setting | kind | things named | words."""
    rows = [
        [part.strip() for part in line.split("|")]
        for line in path.read_text().splitlines()
        if line and not line.startswith("#")
    ]
    return tuple(Asked(row[0], row[1], frozenset(row[2].split()), row[3]) for row in rows)


def report(questions: tuple[Asked, ...]) -> str:
    right = Counter(each.kind for each in questions if each.understood)
    lines = [
        f"{each.setting} | {each.kind} | taken for {each.taken_for[0]} "
        f"{' '.join(sorted(each.taken_for[1]))} | {each.text}"
        for each in questions
        if not each.understood
    ]
    counts = Counter(each.kind for each in questions)
    lines += [f"{kind:14}{right[kind]:4} of {number}" for kind, number in counts.items()]
    lines.append(f"{'all':14}{right.total():4} of {counts.total()}")
    return "\n".join(lines)


if __name__ == "__main__":
    for name in sys.argv[1:]:
        print(report(asked_in(Path(name))))  # noqa: T201 - a tool that prints what it measured
