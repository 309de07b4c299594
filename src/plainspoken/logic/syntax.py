"""LTLf formulas as text, in and out.

    ! & | -> <-> X WX F G U W R true false, parentheses, and propositions such as full_b

`X` is strong next (there is a next instant and it satisfies the formula), `WX` is weak next (true
at the last instant). Unary operators bind tightest, then `U W R` (right-associative), `&`, `|`,
`->` (right-associative), `<->`. Spellings of other tools are read too (see `SPELLINGS`), and
prefix operators may be run together, as in `GF a`.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import NamedTuple, assert_never

from plainspoken.errors import FormulaSyntaxError
from plainspoken.logic.formula import (
    FALSE,
    TRUE,
    Always,
    And,
    Atom,
    Constant,
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
)

OPERATORS = "! & | -> <-> X (strong next) WX (weak next) F G U W R true false"
DEEPEST = 150
"""Operators nested deeper than this are refused: no mission needs them, and recursion ends."""

SPELLINGS = {
    "&&": "&",
    "∧": "&",
    "||": "|",
    "∨": "|",
    "~": "!",
    "¬": "!",
    "=>": "->",
    "→": "->",
    "<=>": "<->",
    "↔": "<->",
}

_PREFIX: dict[str, Callable[[Formula], Formula]] = {
    "!": Not,
    "X": Next,
    "WX": WeakNext,
    "F": Eventually,
    "G": Always,
}
_TEMPORAL: dict[str, Callable[[Formula, Formula], Formula]] = {
    "U": Until,
    "W": WeakUntil,
    "R": Release,
}
_UNARY_SYMBOL = {Not: "!", Next: "X ", WeakNext: "WX ", Eventually: "F ", Always: "G "}
_BINARY_SYMBOL = {Implies: "->", Iff: "<->", Until: "U", WeakUntil: "W", Release: "R"}

_TOKEN = re.compile(
    r"\s*(?:(?P<word>[A-Za-z_][A-Za-z0-9_]*)"
    r"|(?P<mark><->|<=>|->|=>|&&|\|\||[!&|()~∧∨¬→↔])"
    r"|(?P<other>\S))"
)
_PREFIX_RUN = re.compile(r"[FGX]{2,}$")


class _Token(NamedTuple):
    text: str
    column: int


def parse(text: str) -> Formula:
    """Read an LTLf formula.

    raises FormulaSyntaxError: with the column that broke it
    """
    return _Parser(text).formula()


def is_proposition(name: str) -> bool:
    """Whether a name can stand for a proposition in a formula."""
    return (
        re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", name) is not None
        and name not in _PREFIX
        and name not in _TEMPORAL
        and name not in ("true", "false")
        and not _PREFIX_RUN.match(name)
    )


class _Parser:
    """Precedence climbing over the tokens of one text."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._tokens = self._split()
        self._index = 0
        self._depth = 0

    def _split(self) -> list[_Token]:
        tokens = []
        for match in _TOKEN.finditer(self._text):
            column = match.start(match.lastgroup or 0)
            if match["other"]:
                raise self._error(column, f"{match['other']!r} is no part of a formula")
            word = match["word"]
            if word and _PREFIX_RUN.match(word):
                tokens += [_Token(letter, column + i) for i, letter in enumerate(word)]
            else:
                mark = match["mark"]
                tokens.append(_Token(word or SPELLINGS.get(mark, mark), column))
        tokens.append(_Token("", len(self._text)))
        return tokens

    def _error(self, column: int, expected: str) -> FormulaSyntaxError:
        return FormulaSyntaxError(self._text, column, expected, hint=f"operators: {OPERATORS}")

    def _take(self, *texts: str) -> bool:
        if self._tokens[self._index].text in texts:
            self._index += 1
            return True
        return False

    def formula(self) -> Formula:
        if len(self._tokens) == 1:
            raise self._error(0, "the formula is empty")
        formula = self._iff()
        token = self._tokens[self._index]
        if token.text:
            raise self._error(token.column, "expected an operator or the end")
        return formula

    def _nested(self, rule: Callable[[], Formula]) -> Formula:
        self._depth += 1
        if self._depth > DEEPEST:
            column = self._tokens[self._index].column
            raise self._error(column, f"operators are nested deeper than {DEEPEST}")
        formula = rule()
        self._depth -= 1
        return formula

    def _iff(self) -> Formula:
        left = self._implies()
        count = 0
        while self._take("<->"):
            count += 1
            if count > DEEPEST:
                raise self._error(self._tokens[self._index].column, "too long a chain of '<->'")
            left = Iff(left, self._implies())
        return left

    def _implies(self) -> Formula:
        left = self._or()
        if self._take("->"):
            return Implies(left, self._nested(self._implies))
        return left

    def _or(self) -> Formula:
        operands = [self._and()]
        while self._take("|"):
            operands.append(self._and())
        return operands[0] if len(operands) == 1 else Or(tuple(operands))

    def _and(self) -> Formula:
        operands = [self._temporal()]
        while self._take("&"):
            operands.append(self._temporal())
        return operands[0] if len(operands) == 1 else And(tuple(operands))

    def _temporal(self) -> Formula:
        left = self._unary()
        operator = _TEMPORAL.get(self._tokens[self._index].text)
        if operator is None:
            return left
        self._index += 1
        return operator(left, self._nested(self._temporal))

    def _unary(self) -> Formula:
        token = self._tokens[self._index]
        operator = _PREFIX.get(token.text)
        if operator is not None:
            self._index += 1
            return operator(self._nested(self._unary))
        if self._take("("):
            inner = self._nested(self._iff)
            if not self._take(")"):
                raise self._error(self._tokens[self._index].column, "expected an operator or ')'")
            return inner
        if self._take("true"):
            return TRUE
        if self._take("false"):
            return FALSE
        if is_proposition(token.text):
            self._index += 1
            return Atom(token.text)
        raise self._error(token.column, "expected a proposition, a prefix operator or '('")


def unparse(formula: Formula) -> str:
    """Write a formula so that `parse` reads the same value back."""
    match formula:
        case Constant(value):
            return "true" if value else "false"
        case Atom(name):
            return name
        case Not(f) | Next(f) | WeakNext(f) | Eventually(f) | Always(f):
            operand = _operand(f)
            symbol = _UNARY_SYMBOL[type(formula)]
            return (symbol.rstrip() if operand.startswith("(") else symbol) + operand
        case And(operands):
            return " & ".join(_operand(f, Until, WeakUntil, Release) for f in operands)
        case Or(operands):
            return " | ".join(_operand(f, Until, WeakUntil, Release, And) for f in operands)
        case (
            Implies(left, right)
            | Iff(left, right)
            | Until(left, right)
            | WeakUntil(left, right)
            | Release(left, right)
        ):
            return f"{_operand(left)} {_BINARY_SYMBOL[type(formula)]} {_operand(right)}"
        case _:
            assert_never(formula)


def _operand(formula: Formula, *bare: type[Formula]) -> str:
    """An operand, in parentheses unless it is unary, a leaf, or of a kind that binds tighter.

    More parentheses than the grammar needs, on purpose: few readers know that U binds
    tighter than &.
    """
    text = unparse(formula)
    leaf = isinstance(formula, (Constant, Atom, Not, Next, WeakNext, Eventually, Always))
    return text if leaf or isinstance(formula, bare) else f"({text})"
