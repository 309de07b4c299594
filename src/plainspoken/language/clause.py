"""Clauses: the small typed form between an utterance and its formula.

A clause is a main one ("never enter site 3") or belongs to a main one by a connector ("while the
tank is full"). It holds what is done, to which operands, joined and ordered how, and how often.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import StrEnum, auto

from plainspoken.language.counting import Count
from plainspoken.language.expression import Shape
from plainspoken.language.lexicon import Kind
from plainspoken.language.reference import Form, Reference


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

    @property
    def travels(self) -> bool:
        """Whether it tells of an errand with several stops."""
        errands = (operand.reference.errand for operand in self.operands)
        return any(each is not None and each.travels for each in errands)


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
    found = _nested([stage for clause in found for stage in _stages(clause)])
    made: list[Statement] = []
    waiting: list[Clause] = []
    preposed = False
    for index, said in enumerate(found):
        forbids = _forbids(said, made, found[index + 1 :])
        clause = replace(said, connector=None, act=Act.AVOID) if forbids else said
        if made and not waiting and _is_beside(clause, made[-1]):
            made[-1] = replace(made[-1], main=_throughout(made[-1], clause))
            beside_it = made[-1].main
            made.append(Statement(_throughout(Statement(_demand(clause)), beside_it)))
        elif clause.connector is None:
            beside = [each for each in waiting if _is_beside(each, Statement(clause))]
            for each in beside:
                made.append(Statement(_throughout(Statement(_demand(each)), clause)))
                waiting.remove(each)
            if any(each.travels for each in beside):
                clause = replace(clause, flags=_throughout(Statement(clause), clause).flags)
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
    return _otherwise([_restricted(_around(each)) for each in made])


_REACTIVE = (Kind.WHEN, Kind.WHENEVER, Kind.PROMPTLY)


def _stages(clause: Clause) -> tuple[Clause, ...]:
    """Read "a or b, then c" as two clauses: the choice is made before, or after, what follows."""
    links = [operand.link for operand in clause.operands]
    if clause.connector is not None or clause.act is not Act.DO or clause.counts or not (
        Kind.OR in links and Kind.THEN in links[1:]
    ):  # fmt: skip
        return (clause,)
    starts = [0, *(place for place, link in enumerate(links) if place and link is Kind.THEN)]
    first, *rest = (
        replace(clause, operands=clause.operands[start:end])
        for start, end in zip(starts, [*starts[1:], None], strict=True)
    )
    return (
        first,
        *(
            replace(
                each,
                link=Kind.THEN,
                operands=(replace(each.operands[0], link=None), *each.operands[1:]),
            )
            for each in rest
        ),
    )


def _nested(found: Sequence[Clause]) -> Sequence[Clause]:
    """Read "whenever a, if b, ..." and "if a while b, ..." as one condition: a and b."""
    made: list[Clause] = []
    for clause in found:
        before = made[-1] if made else None
        if before is not None and _is_within(clause, before, first=len(made) == 1):
            made[-1] = _both(before, clause)
        else:
            made.append(clause)
    return made


def _both(before: Clause, clause: Clause) -> Clause:
    """Two conditions as one: both of them."""
    operands = [*_as_told(before), *_as_told(clause)]
    operands[len(before.operands)] = replace(operands[len(before.operands)], link=Kind.AND)
    reacts = clause if before.connector is Kind.WHILE else before
    return replace(
        before, connector=reacts.connector, act=Act.DO, operands=tuple(operands),
        flags=before.flags | clause.flags, told=before.told or clause.told,
    )  # fmt: skip


def _otherwise(made: Sequence[Statement]) -> tuple[Statement, ...]:
    """Put "otherwise b" under the denial of the condition before: "if a, b; otherwise c"."""
    found: list[Statement] = []
    condition: Clause | None = None
    for each in made:
        flagged = Kind.OTHERWISE in each.main.flags
        if flagged and condition is not None and not each.subordinates:
            act = Act.AVOID if condition.act is Act.DO else Act.DO
            main = replace(each.main, flags=each.main.flags - {Kind.OTHERWISE}, link=None)
            found.append(Statement(main, (replace(condition, act=act),)))
            continue
        reacts = [c for c in each.subordinates if c.connector in (*_REACTIVE, Kind.WHILE)]
        condition = reacts[0] if len(reacts) == 1 and reacts[0].operands else None
        found.append(each)
    return tuple(found)


def _around(statement: Statement) -> Statement:
    """Read "when a, do b, provided that c" as one condition: a and c."""
    match statement.subordinates:
        case (before, behind) if (
            not behind.pointed
            and before.operands != behind.operands
            and behind.link in (None, Kind.COMMA)
            and _is_within(behind, before, first=True)
        ):
            return replace(statement, subordinates=(_both(before, behind),))
        case _:
            return statement


def _is_within(clause: Clause, before: Clause, *, first: bool) -> bool:
    simple = all(
        each.operands
        and not each.counts
        and each.act in (Act.DO, Act.AVOID)
        and all(operand.link in (None, Kind.AND, Kind.NOW) for operand in each.operands)
        and (each.act is Act.DO or len(each.operands) == 1)
        for each in (clause, before)
    )
    close = clause.link is None or (clause.link in (Kind.COMMA, Kind.THEN) and first)
    inner = (Kind.WHEN, Kind.WHENEVER, Kind.WHILE)
    return simple and close and (
        (before.connector in _REACTIVE and clause.connector in inner)
        or (before.connector is Kind.WHILE and clause.connector in (Kind.WHEN, Kind.WHENEVER))
    )  # fmt: skip


def _as_told(clause: Clause) -> list[Operand]:
    """The operands of a situation, a denial of it put on the one that it denies."""
    denied = clause.act is Act.AVOID
    return [replace(each, negated=each.negated != denied) for each in clause.operands]


def _is_beside(clause: Clause, other: Statement) -> bool:
    """Whether "while (doing) b" asks for b beside a, and is no condition of a.

    Carrying something, coming back again and again, staying away take their time: they are not a
    situation in which something else is to be so.
    """
    carrying = clause.travels and clause.operands[0].reference.form is Form.GERUND
    if not clause.operands or not (
        clause.connector is Kind.WHILE or (carrying and clause.connector is Kind.WHEN)
    ):
        return False
    main = other.main
    if clause.travels or clause.act is Act.PATROL:
        return True
    placed = not clause.told and all(
        each.reference.shape is not Shape.STATE for each in clause.operands
    )
    if not placed:
        return False
    if main.travels and all(each.negated for each in clause.operands):
        return True
    if clause.act is Act.AVOID:
        return main.act is Act.PATROL or main.travels
    if clause.act is Act.STAY and (main.travels or Kind.ALWAYS in clause.flags):
        return True
    done_at = any(
        len(stop) > 1
        for each in clause.operands
        if each.reference.errand is not None
        for stop in each.reference.errand.stops
    )
    elsewhere = all(each.reference.shape is Shape.PLACE for each in main.operands)
    if main.act is Act.AVOID and done_at and elsewhere:
        return True  # nobody is in two places at once
    waits = any(each.connector in (Kind.UNTIL, Kind.BEFORE) for each in other.subordinates)
    errand = any(each.reference.errand for each in clause.operands)
    return main.act is Act.AVOID and waits and (errand or clause.act is Act.STAY)


def _demand(clause: Clause) -> Clause:
    """What a subordinate clause tells as a main one: "while not entering a" forbids a."""
    operands = clause.operands
    act = clause.act
    if act is Act.DO and all(each.negated for each in operands):
        act = Act.AVOID
        operands = tuple(replace(each, negated=False) for each in operands)
    return replace(clause, connector=None, link=clause.link or Kind.AND, act=act, operands=operands)


def _throughout(statement: Statement, beside: Clause) -> Clause:
    """What is asked for beside something else: to stay somewhere is to stay there all the time."""
    main = statement.main
    if main.act is not Act.STAY or statement.subordinates or not beside.operands:
        return main
    return replace(main, flags=main.flags | {Kind.ALWAYS})


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
