"""How many reports in words are understood: `python -m benchmarks.reports`."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from plainspoken.language.extracted import Status
from plainspoken.pipeline import Site, bundled, open_site
from plainspoken.questions.consequence import exclusions_of
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.report import Report, understood
from plainspoken.world.domain import State

FOLDER = Path(__file__).parent / "corpora" / "reports"


@dataclass(frozen=True, slots=True)
class Sentence:
    """A report and what is to become of it.

    facts: what it says, "not" before what is denied; None where it is to be asked about or refused
    state: what is so besides the initial state
    """

    domain: str
    id: str
    text: str
    status: Status
    facts: tuple[str, ...] | None
    state: tuple[str, ...]


@cache
def lexicon_for(domain: str) -> Lexicon:
    """The words of an example, or of a domain that only the corpus has."""
    site: Site
    own = FOLDER / f"{domain}-domain.pddl"
    if own.exists():
        site = open_site(own, FOLDER / f"{domain}-problem.pddl")
    else:
        names = ("domain.pddl", "problem.pddl", "landmarks.json")
        site = open_site(*(bundled(domain) / name for name in names))
    return Lexicon(site.problem, site.landmarks)


def state_for(domain: str, also: Iterable[str] = ()) -> State:
    """The initial state with some facts besides, and without what they exclude."""
    problem = lexicon_for(domain).problem
    state = set(problem.initial)
    for atom in also:
        state.add(atom)
        for other, holds in exclusions_of(problem).implied((atom, True)):
            (state.add if holds else state.discard)(other)
    return frozenset(state)


def sentences(domain: str) -> list[Sentence]:
    """The reports about a domain."""
    found = []
    for line in (FOLDER / f"{domain}.jsonl").read_text(encoding="utf-8").splitlines():
        row = json.loads(line)
        facts = tuple(row["facts"]) if "facts" in row else None
        state = tuple(row.get("state", ()))
        found.append(Sentence(domain, row["id"], row["text"], Status(row["status"]), facts, state))
    return found


def reported(sentence: Sentence) -> Report:
    """What is made of a report."""
    state = state_for(sentence.domain, sentence.state)
    return understood(sentence.text, lexicon_for(sentence.domain), state)


def is_right(sentence: Sentence) -> bool:
    """Whether a report ends as it should, with the facts that it states and no others."""
    found = reported(sentence)
    said = {atom if holds else f"not {atom}" for atom, holds in found.said}
    return found.status is sentence.status and said == set(sentence.facts or ())


def main() -> None:
    """Print the share of each domain, and what went wrong."""
    rows = {name: sentences(name) for name in ("vineyard", "warehouse", "kitchen", "clinic")}
    for name, asked in rows.items():
        right = sum(map(is_right, asked))
        print(f"{name:10} {right:3} of {len(asked):3}  {right / len(asked):.3f}")
    everything = [each for asked in rows.values() for each in asked]
    right = sum(map(is_right, everything))
    print(f"{'all':10} {right:3} of {len(everything):3}  {right / len(everything):.3f}")
    for each in everything:
        if not is_right(each):
            found = reported(each)
            print(f"  {each.text!r}: {found.status}, {found.english or found.question}")


if __name__ == "__main__":
    main()
