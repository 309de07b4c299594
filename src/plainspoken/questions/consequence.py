"""What follows from facts that somebody tells: what else is so then, and what is left open.

Domains keep to rules that nobody writes down: a parcel is in one place, a mug is clean, chipped,
unknown or unchecked. Who says "the crate is on the cart" says as well that it is not on its shelf
any more. The rules are found by `planning.exclusion`, not guessed from words.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache

from plainspoken.planning.exclusion import Exclusions, Literal
from plainspoken.questions.identity import ById
from plainspoken.world.domain import GroundAtom, Problem, State


@dataclass(frozen=True, slots=True)
class Settled:
    """What is so afterwards.

    said:    what was said
    implied: what is different because of it
    whole:   all that is known to be so: the state may change before the report is heard
    """

    said: tuple[Literal, ...]
    implied: tuple[Literal, ...]
    whole: tuple[Literal, ...]


@dataclass(frozen=True, slots=True)
class Clash:
    """Two facts that cannot be together; the same one twice where it can never be so."""

    one: Literal
    other: Literal


@dataclass(frozen=True, slots=True)
class Open:
    """Because `no_more` is not so any more, exactly one of these is so; which is not known."""

    no_more: GroundAtom
    candidates: tuple[GroundAtom, ...]


def settled(
    said: Iterable[Literal], state: State, exclusions: Exclusions
) -> Settled | Clash | Open:
    """Draw the conclusions from what is said of a state, static atoms included."""
    told = tuple(dict.fromkeys(said))
    facts: dict[GroundAtom, bool] = {}
    because: dict[GroundAtom, Literal] = {}
    alone: set[GroundAtom] = set()
    todo = [(literal, literal) for literal in told]
    while True:
        while todo:
            literal, reason = todo.pop(0)
            atom, holds = literal
            if not exclusions.is_possible(literal):
                return Clash(reason, literal)
            if facts.setdefault(atom, holds) != holds:
                return Clash(because[atom], reason)
            because.setdefault(atom, reason)
            for each in _implied(literal, reason, exclusions):
                if facts.get(each[0], each[1]) != each[1]:
                    return Clash(because[each[0]], reason)
                if each[0] not in facts and each[0] not in alone:
                    todo.append((each, reason))
        empty = _emptied(facts, state, exclusions)
        if empty is None:
            break
        gone, candidates = empty
        if len(candidates) == 1:
            todo = [((candidates[0], True), because[gone])]
        elif (gone, False) in told:
            return Open(gone, candidates)
        else:
            del facts[gone]  # Nobody said so, and what would be so instead is not known.
            alone.add(gone)
    implied = tuple(
        (atom, holds)
        for atom, holds in facts.items()
        if (atom, holds) not in told and (atom in state) != holds
    )
    return Settled(told, implied, tuple(facts.items()))


def _implied(literal: Literal, reason: Literal, exclusions: Exclusions) -> list[Literal]:
    """What follows for the things that was spoken of, and for what takes a fact's place.

    A shelf that is cleared had its mugs looked at; but who clears it by hand tells nothing of
    them.
    """
    things = set(reason[0].split()[1:])
    group = exclusions.group(literal[0])
    return [
        each
        for each in exclusions.implied(literal)
        if things & set(each[0].split()[1:]) or each[0] in group
    ]


def _emptied(
    facts: dict[GroundAtom, bool], state: State, exclusions: Exclusions
) -> tuple[GroundAtom, tuple[GroundAtom, ...]] | None:
    """An atom that stops being so and leaves a group without any; with what can take its place."""
    for atom, holds in facts.items():
        if holds or atom not in state:
            continue
        group = exclusions.group(atom)
        if not group or any(facts.get(each, each in state) for each in group):
            continue
        return atom, tuple(each for each in group if each not in facts)
    return None


@lru_cache(maxsize=8)
def _exclusions(problem: ById[Problem], unknown: State) -> Exclusions:
    return Exclusions(problem.value, unknown)


def exclusions_of(problem: Problem, unknown: State = frozenset()) -> Exclusions:
    """The exclusions of a problem; kept, as many reports are about one.

    unknown: what nobody knows at s0, beside what the problem names
    """
    return _exclusions(ById(problem), unknown)
