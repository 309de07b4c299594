"""Mission patterns as a row of tokens, the notation in which a network writes them.

A pattern is its name and its operands, closed by `)`; a formula is written in prefix form. Several
patterns stand one after another. What belongs to no pattern is written as a formula. Symbols are
written as they are: `past_avoidance b a ) visit a )`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import fields

from plainspoken.logic.formula import (
    Always,
    And,
    Atom,
    Eventually,
    Formula,
    Iff,
    Implies,
    Next,
    Not,
    Or,
    Release,
    Until,
    WeakNext,
    WeakUntil,
    conjunction,
    conjuncts,
    disjunction,
)
from plainspoken.logic.pattern import (
    NAMES,
    AtLeast,
    AtMost,
    BoundDelay,
    BoundReaction,
    Choice,
    DelayedReaction,
    Exactly,
    FairVisit,
    FutureAvoidance,
    GlobalAvoidance,
    GuardedVisit,
    InstantaneousReaction,
    Maintenance,
    OrderedVisit,
    PastAvoidance,
    Patrolling,
    Pattern,
    PromptPrecedence,
    PromptReaction,
    Remaining,
    SequencedVisit,
    StrictOrderedVisit,
    Visit,
    Wait,
)
from plainspoken.logic.recognition import recognised

CLOSE = ")"
OPTION = "option"
DEMANDED = "demanded"
MOST_TIMES = 6
_TIMES = tuple(f"{times}x" for times in range(MOST_TIMES + 1))
_UNARY: dict[type, str] = {Not: "!", Next: "X", WeakNext: "WX", Eventually: "F", Always: "G"}
_BINARY: dict[type, str] = {Implies: "->", Iff: "<->", Until: "U", WeakUntil: "W", Release: "R"}
_NARY: dict[type, str] = {And: "and", Or: "or"}
_PATTERNS = {cls: name.replace(" ", "_") for cls, name in NAMES.items()}
_OF_UNARY = {token: cls for cls, token in _UNARY.items()}
_OF_BINARY = {token: cls for cls, token in _BINARY.items()}
_OF_NARY = {"and": conjunction, "or": disjunction}
_OF_PATTERN = frozenset(_PATTERNS.values())
_CHOICE = _PATTERNS[Choice]
_COUNTED: dict[str, Callable[[Formula, int], Pattern]] = {
    _PATTERNS[cls]: cls for cls in (AtLeast, AtMost, Exactly)
}
_LISTED: dict[str, Callable[[tuple[Formula, ...]], Pattern]] = {
    _PATTERNS[cls]: cls
    for cls in (
        Visit, SequencedVisit, OrderedVisit, StrictOrderedVisit, FairVisit, Patrolling,
        Maintenance, Remaining, GlobalAvoidance,
    )
}  # fmt: skip
_TIMED: dict[str, Callable[[Formula, Formula, bool], Pattern]] = {
    _PATTERNS[cls]: cls for cls in (PromptReaction, PromptPrecedence, BoundDelay)
}
_PAIRED: dict[str, Callable[[Formula, Formula], Pattern]] = {
    _PATTERNS[cls]: cls
    for cls in (
        GuardedVisit, FutureAvoidance, Wait, InstantaneousReaction, DelayedReaction, BoundReaction,
    )
}  # fmt: skip

TOKENS = (
    CLOSE,
    OPTION,
    DEMANDED,
    *_TIMES,
    *_UNARY.values(),
    *_BINARY.values(),
    *_NARY.values(),
    *_PATTERNS.values(),
)
"""Every token but the symbols."""

Stated = Pattern | Formula
"""A pattern, or a formula that belongs to none."""


class NotationError(ValueError):
    """A row of tokens that is no row of patterns."""


def written(literal: Formula, executable: Formula) -> tuple[str, ...]:
    """The tokens for a formula, given in both readings."""
    demanded = frozenset(conjuncts(executable))
    return tuple(token for each in recognised(literal) for token in _stated(each, demanded))


def read(tokens: Sequence[str], persists: Callable[[Formula], bool]) -> tuple[Stated, ...]:
    """The patterns that tokens stand for.

    persists: whether what a formula says stays true until something changes it
    raises NotationError: when they stand for none
    """
    return _Reader(tokens, persists).all()


def _stated(each: Stated, demanded: frozenset[Formula]) -> Iterator[str]:
    match each:
        case Or(operands) if any(not isinstance(part, Eventually) for part in operands):
            yield _PATTERNS[Choice]
            for option in operands:
                yield OPTION
                for part in recognised(option):
                    yield from _stated(part, frozenset())
                yield CLOSE
            yield CLOSE
        case PastAvoidance() if isinstance(each, PastAvoidance):
            yield _PATTERNS[PastAvoidance]
            if each.literal in demanded:
                yield DEMANDED
            yield from _formula(each.avoided)
            yield from _formula(each.until)
            yield CLOSE
        case _ if isinstance(each, Pattern):
            yield _PATTERNS[type(each)]
            for field in fields(each):
                yield from _operand(getattr(each, field.name))
            yield CLOSE
        case _:
            yield from _formula(each)


def _operand(value: object) -> Iterator[str]:
    if isinstance(value, bool):
        return
    if isinstance(value, int):
        yield _TIMES[min(value, MOST_TIMES)]
    elif isinstance(value, tuple):
        for each in value:
            yield from _formula(each)
    else:
        yield from _formula(value)  # type: ignore[arg-type]


def _formula(formula: Formula) -> Iterator[str]:
    match formula:
        case Atom(name):
            yield name
        case And(operands) | Or(operands):
            yield _NARY[type(formula)]
            for each in operands:
                yield from _formula(each)
            yield CLOSE
        case Not() | Next() | WeakNext() | Eventually() | Always():
            yield _UNARY[type(formula)]
            yield from _formula(formula.operand)
        case Implies() | Iff() | Until() | WeakUntil() | Release():
            yield _BINARY[type(formula)]
            yield from _formula(formula.left)
            yield from _formula(formula.right)
        case _:
            raise NotationError(f"{formula} has no notation")


class _Reader:
    def __init__(self, tokens: Sequence[str], persists: Callable[[Formula], bool]) -> None:
        self._tokens = tokens
        self._at = 0
        self._persists = persists

    def all(self) -> tuple[Stated, ...]:
        found = []
        while self._at < len(self._tokens):
            found.append(self._one())
        if not found:
            raise NotationError("nothing is written")
        return tuple(found)

    def _peek(self) -> str:
        if self._at >= len(self._tokens):
            raise NotationError("it breaks off")
        return self._tokens[self._at]

    def _next(self) -> str:
        token = self._peek()
        self._at += 1
        return token

    def _closed(self) -> bool:
        if self._peek() == CLOSE:
            self._at += 1
            return True
        return False

    def _one(self) -> Stated:
        name = self._peek()
        if name not in _OF_PATTERN:
            return self._formula()
        self._at += 1
        if name == _CHOICE:
            return self._choice()
        demanded = self._peek() == DEMANDED
        self._at += demanded
        operands: list[Formula] = []
        times: int | None = None
        while not self._closed():
            if self._peek() in _TIMES:
                times = _TIMES.index(self._next())
            else:
                operands.append(self._formula())
        return self._pattern(name, operands, times, demanded=demanded)

    def _pattern(
        self, name: str, operands: Sequence[Formula], times: int | None, *, demanded: bool
    ) -> Pattern:
        match operands:
            case [place] if name in _COUNTED and times is not None:
                return _COUNTED[name](place, times)
            case [_, *_] if name in _LISTED:
                return _LISTED[name](tuple(operands))
            case [avoided, until] if name == _PATTERNS[PastAvoidance]:
                return PastAvoidance(avoided, until, demanded)
            case [trigger, response] if name in _TIMED:
                return _TIMED[name](trigger, response, self._persists(trigger))
            case [first, second] if name in _PAIRED:
                return _PAIRED[name](first, second)
            case _:
                raise NotationError(f"{name} of {len(operands)} operands")

    def _choice(self) -> Stated:
        options = []
        while not self._closed():
            if self._next() != OPTION:
                raise NotationError("a choice is between options")
            parts = []
            while not self._closed():
                parts.append(self._one())
            options.append(parts)
        if len(options) < 2:
            raise NotationError("a choice is between two or more")
        plain = [[each for each in parts if isinstance(each, Pattern)] for parts in options]
        if all(len(mine) == len(parts) for mine, parts in zip(plain, options, strict=True)):
            return Choice(tuple(map(tuple, plain)))
        return disjunction(*(conjunction(*map(literal, parts)) for parts in options))

    def _formula(self) -> Formula:
        token = self._next()
        if token in _OF_UNARY:
            return _OF_UNARY[token](self._formula())  # type: ignore[no-any-return]
        if token in _OF_BINARY:
            return _OF_BINARY[token](self._formula(), self._formula())  # type: ignore[no-any-return]
        if token in _OF_NARY:
            operands = []
            while not self._closed():
                operands.append(self._formula())
            if len(operands) < 2:
                raise NotationError(f"{token} joins two or more")
            return _OF_NARY[token](*operands)
        if token in TOKENS:
            raise NotationError(f"{token} stands where a formula should")
        return Atom(token)


def literal(each: Stated) -> Formula:
    """The literal reading of a pattern, or the formula itself."""
    return each.literal if isinstance(each, Pattern) else each


def executable(each: Stated) -> Formula:
    """The executable reading of a pattern, or the formula itself."""
    return each.executable if isinstance(each, Pattern) else each
