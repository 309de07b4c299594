"""Clauses: the small typed form between an utterance and its formula.

A clause is a main one ("never enter site 3") or belongs to a main one by a connector ("while the
tank is full"). It holds what is done, to which operands, joined and ordered how, and how often.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import StrEnum, auto

from plainspoken.language.item import Count
from plainspoken.language.lexicon import Kind
from plainspoken.language.reference import Reference


class Act(StrEnum):
    """What a clause asks for, of its operands."""

    DO = auto()
    AVOID = auto()
    STAY = auto()
    PATROL = auto()


@dataclass(frozen=True, slots=True)
class Operand:
    """What a clause speaks of. link: how it is joined to the one before (AND, OR, THEN)."""

    reference: Reference
    negated: bool = False
    link: Kind | None = None


@dataclass(frozen=True, slots=True)
class Clause:
    """One clause.

    connector: what makes it subordinate, or None for a main clause
    link:      how it is joined to what stands before it
    modality:  MUST, MAY or None, as an imperative has
    flags:     what is said of time and order (NEXT, LATER, IN_ORDER, AFTER_THAT, ...)
    """

    connector: Kind | None
    link: Kind | None
    act: Act
    operands: tuple[Operand, ...]
    modality: Kind | None
    flags: frozenset[Kind]
    counts: tuple[Count, ...]
    subject: bool
    assured: bool = False  # "make sure that ..."
    wished: bool = False  # "please", "I want", "make sure"
    pause: bool = False  # a mark stands before it
    told: bool = False  # a copula tells how things are
    pointed: bool = False  # it only points back to what was spoken of
    denied: bool = False  # its connector has a "not" or "never" of its own


@dataclass(frozen=True, slots=True)
class Statement:
    """A main clause and what belongs to it."""

    main: Clause
    subordinates: tuple[Clause, ...] = ()


CONNECTORS = frozenset(
    (
        Kind.WHEN, Kind.WHENEVER, Kind.AFTER, Kind.PROMPTLY, Kind.BEFORE, Kind.RIGHT_BEFORE,
        Kind.UNTIL, Kind.UNLESS, Kind.WHILE, Kind.WITHOUT, Kind.ONLY_IF, Kind.ONLY_AFTER,
        Kind.ONLY_RIGHT_AFTER, Kind.IFF, Kind.ELSEWHERE,
    )
)  # fmt: skip


def statements(found: Sequence[Clause]) -> tuple[Statement, ...]:
    """Attach each subordinate clause to the main clause that it stands beside."""
    made: list[Statement] = []
    waiting: list[Clause] = []
    preposed = False
    for index, said in enumerate(found):
        forbids = _forbids(said, made, found[index + 1 :])
        clause = replace(said, connector=None, act=Act.AVOID) if forbids else said
        if clause.connector is None:
            if preposed and not waiting and _shares(clause, made[-1], found[index + 1 :]):
                waiting = list(made[-1].subordinates)
            preposed = bool(waiting)
            made.append(Statement(clause, tuple(waiting)))
            waiting = []
        elif (
            made
            and not waiting
            and _follows(clause, made[-1], found[index + 1 :], preposed=preposed)
        ):
            made[-1] = Statement(made[-1].main, (*made[-1].subordinates, clause))
        else:
            waiting.append(clause)
    if waiting and made:
        made[-1] = Statement(made[-1].main, (*made[-1].subordinates, *waiting))
    return tuple(map(_restricted, made))


def _forbids(clause: Clause, made: Sequence[Statement], rest: Sequence[Clause]) -> bool:
    """Whether "..., without doing a before b" forbids a until b."""
    return (
        clause.connector is Kind.WITHOUT
        and clause.act is Act.DO
        and clause.link in (Kind.COMMA, Kind.AND)
        and bool(clause.operands)
        and bool(made)
        and (made[-1].main.act is Act.DO or Kind.BEFORE in _connectors(made[-1]))
        and bool(rest)
        and rest[0].connector in (Kind.BEFORE, Kind.UNTIL)
        and rest[0].link is None
        and bool(rest[0].operands)
    )


def _connectors(statement: Statement) -> frozenset[Kind | None]:
    return frozenset(each.connector for each in statement.subordinates)


def _shares(clause: Clause, statement: Statement, rest: Sequence[Clause]) -> bool:
    """Whether "when a, b and c" asks for c, too, when a."""
    own = bool(rest) and rest[0].connector is not None and not rest[0].pause
    return (
        clause.link is Kind.AND
        and not clause.pause
        and not own
        and Kind.NO_OTHER not in clause.flags
        and all(
            each.connector in (Kind.WHEN, Kind.WHENEVER, Kind.PROMPTLY, Kind.AFTER, Kind.WHILE)
            for each in statement.subordinates
        )
    )


_ONLY = {
    Kind.WHEN: Kind.ONLY_IF,
    Kind.WHENEVER: Kind.ONLY_IF,
    Kind.WHILE: Kind.ONLY_IF,
    Kind.AFTER: Kind.ONLY_AFTER,
    Kind.PROMPTLY: Kind.ONLY_RIGHT_AFTER,
}


def _restricted(statement: Statement) -> Statement:
    """Move an "only" to its connector: "only visit a if b" is "visit a only if b"."""
    if Kind.ONLY not in statement.main.flags:
        return statement
    return replace(
        statement,
        subordinates=tuple(
            replace(each, connector=_ONLY.get(each.connector, each.connector))
            if each.connector is not None else each
            for each in statement.subordinates
        ),
    )  # fmt: skip


def _follows(
    clause: Clause, statement: Statement, rest: Sequence[Clause], *, preposed: bool
) -> bool:
    """Whether a subordinate clause belongs to the main clause before it."""
    if clause.link in (Kind.AND, Kind.OR):
        # "... after a and before b": two connectors of one main clause
        return bool(statement.subordinates) and clause.connector in (
            Kind.BEFORE, Kind.UNTIL, Kind.UNLESS,
        )  # fmt: skip
    if clause.link not in (None, Kind.COMMA, Kind.BUT):
        return False
    another = bool(rest) and rest[0].connector is None and rest[0].link in (None, Kind.COMMA)
    turned = clause.link is Kind.BUT and clause.connector in (
        Kind.BEFORE, Kind.AFTER, Kind.WHEN, Kind.WHENEVER, Kind.PROMPTLY,
    )  # fmt: skip
    return not (another and (preposed or turned))
