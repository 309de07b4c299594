"""Questions to learn from: what people ask of missions of invented domains, each with its kind.

A folder of `missions/` holds a domain, a problem, perhaps landmarks, and `questions.txt` with lines
`kind | things named | words`.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from tests.questions.asked import asked_in, lexicon
from tests.questions.test_question import TABLE

from plainspoken.questions.grammar import Shape
from plainspoken.questions.kind import Kind
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.question import grammar_of
from plainspoken.questions.spoken import Spoken, spoken
from plainspoken.world.landmark import landmarks_from_json
from plainspoken.world.pddl import parse_domain, parse_problem

ROOT = Path(__file__).parents[1]
MISSIONS = ROOT / "training/missions"
JUDGED = ("asked", "people", "people_again")
"""Files of tests/questions/ whose questions the rules were made for."""


@dataclass(frozen=True, slots=True)
class Asked:
    """A question. mission: where it was asked; said: as the network hears it."""

    mission: str
    kind: Kind
    things: frozenset[str]
    text: str
    said: tuple[Spoken, ...]
    shape: Shape
    lexicon: Lexicon


def lexicon_of(folder: Path) -> Lexicon:
    """The words of a mission in a folder."""
    domain = parse_domain((folder / "domain.pddl").read_text(encoding="utf-8"), "domain")
    problem = parse_problem(
        (folder / "problem.pddl").read_text(encoding="utf-8"), domain, "problem"
    )
    path = folder / "landmarks.json"
    given = json.loads(path.read_text(encoding="utf-8")) if path.exists() else None
    return Lexicon(problem, landmarks_from_json(given, str(path)) if given else {})


def written() -> Iterator[Asked]:
    """The questions of the missions, in order."""
    for folder in sorted(MISSIONS.iterdir()):
        own = lexicon_of(folder)
        for line in (folder / "questions.txt").read_text(encoding="utf-8").splitlines():
            if line and not line.startswith("#"):
                kind, things, text = (part.strip() for part in line.split("|"))
                named = frozenset(things.split())
                yield Asked(
                    folder.name,
                    Kind(kind),
                    named,
                    text,
                    spoken(text, own),
                    grammar_of(text, own)[1],
                    own,
                )


def judged() -> Iterator[Asked]:
    """Questions that others wrote, over the missions of the tests."""
    for setting, text, kind, things, _ in TABLE:
        own = lexicon(setting)
        shape = grammar_of(text, own)[1]
        named = frozenset(things.split())
        yield Asked("table", Kind(kind), named, text, spoken(text, own), shape, own)
    for name in JUDGED:
        for each in asked_in(ROOT / f"tests/questions/{name}.txt"):
            own = lexicon(each.setting)
            yield Asked(
                name,
                Kind(each.kind),
                each.objects,
                each.text,
                spoken(each.text, own),
                grammar_of(each.text, own)[1],
                own,
            )
