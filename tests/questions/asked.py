"""Questions with their expected kind and referents, and how many of them are understood.

A line holds `mission | kind | things | words`: the mission is one of `missions.py` or a folder with
`domain.pddl`, `problem.pddl` and, where wanted, `landmarks.json` and `goal.txt`; turns before the
last are in front of it, with ` >> ` between. `python benchmarks/answers.py --questions FILE` prints
what is understood.
"""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from tests.questions.missions import FURTHER, SETTINGS, Setting, accepted, run_of

from plainspoken.questions.dialogue import Dialogue
from plainspoken.questions.kind import Kind
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.listener import listener
from plainspoken.questions.moment import Moment, lexicon_of
from plainspoken.questions.question import Question, grammar_of, question_of, ruled_kind
from plainspoken.questions.spoken import spoken

Taken = tuple[str, frozenset[str]]


@dataclass(frozen=True)
class Asked:
    """A question as a person put it, and how it is meant."""

    setting: str
    kind: str
    objects: frozenset[str]
    text: str

    @property
    def question(self) -> Question:
        *before, last = self.text.split(" >> ")
        if not before:
            return question_of(last, lexicon(self.setting))
        dialogue, moment = Dialogue(), half_way(self.setting)
        for each in (*before, last):
            _, dialogue = dialogue.ask(each, moment)
        assert dialogue.turn is not None
        return dialogue.turn.question

    @property
    def taken_for(self) -> Taken:
        return str(self.question.kind), frozenset(self.question.referents.objects)

    @property
    def understood(self) -> bool:
        return self.taken_for == (self.kind, self.objects)


def setting_of(name: str) -> Setting:
    """A mission of the tests, or one in a folder."""
    known = {**SETTINGS, **FURTHER}
    if name in known:
        return known[name]
    folder = Path(name)
    texts = [(folder / f"{each}.pddl").read_text() for each in ("domain", "problem")]
    goal, landmarks = folder / "goal.txt", folder / "landmarks.json"
    return Setting(
        folder.name,
        *texts,
        goal.read_text().strip() if goal.exists() else "true",
        landmarks.read_text() if landmarks.exists() else "{}",
    )


@cache
def lexicon(setting: str) -> Lexicon:
    return lexicon_of(accepted(setting_of(setting)))


@cache
def half_way(setting: str) -> Moment:
    """The moment in the middle of one run of a mission."""
    entries = run_of(setting_of(setting), seed=0, most=60)
    return Moment(entries, len(entries) // 2)


def asked_in(path: Path) -> tuple[Asked, ...]:
    """The questions of a file. raises ValueError: at a line that has not four parts"""
    found = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        if not line.strip() or line.startswith("#"):
            continue
        row = [part.strip() for part in line.split("|")]
        if len(row) != 4 or row[1] not in set(Kind):
            raise ValueError(f"{path}:{number}: expected mission | kind | things | words: {line}")
        own = path.parent / row[0]
        setting = str(own) if (own / "domain.pddl").exists() else row[0]
        found.append(Asked(setting, row[1], frozenset(row[2].split()), row[3]))
    return tuple(found)


def by_rules(asked: Asked) -> Taken:
    """What the rules alone make of a question."""
    last = asked.text.rsplit(" >> ", 1)[-1]
    return str(ruled_kind(last, lexicon(asked.setting))), asked.taken_for[1]


def by_listener(asked: Asked) -> Taken:
    """What the listener alone makes of it."""
    words, last = lexicon(asked.setting), asked.text.rsplit(" >> ", 1)[-1]
    chances = listener().hear(spoken(last, words), grammar_of(last, words)[1])
    return str(max(chances, key=lambda kind: chances[kind])), asked.taken_for[1]


READERS: dict[str, Callable[[Asked], Taken]] = {
    "rules": by_rules,
    "listener": by_listener,
    "both": lambda asked: asked.taken_for,
}


def report(questions: tuple[Asked, ...]) -> str:
    """Every question that is misunderstood, and a table by kind and reader."""
    lines = [
        f"{Path(each.setting).name} | {each.kind} | taken for {each.taken_for[0]} "
        f"{' '.join(sorted(each.taken_for[1]))} | {each.text}"
        for each in questions
        if not each.understood
    ]
    counts = Counter(each.kind for each in questions)
    right = {
        name: Counter(each.kind for each in questions if reader(each) == (each.kind, each.objects))
        for name, reader in READERS.items()
    }
    asked_back = sum(each.question.other is not None for each in questions)
    lines += [
        "",
        f"| kind | of | {' | '.join(READERS)} |",
        "| --- |" + " ---: |" * (1 + len(READERS)),
    ]
    for kind, number in counts.items():
        lines.append(f"| {kind} | {number} | {' | '.join(str(right[n][kind]) for n in READERS)} |")
    totals = [f"{100 * right[name].total() / max(1, len(questions)):.1f}%" for name in READERS]
    lines.append(f"| all | {len(questions)} | {' | '.join(totals)} |")
    return "\n".join([*lines, "", f"asked back: {asked_back} of {len(questions)}"])
