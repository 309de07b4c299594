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
    children,
)

OPERATORS = "! & | -> <-> X (strong next) WX (weak next) F G U W R true false"
DEEPEST = 150
"""Operators nested deeper than this are refused: no mission needs them, and recursion ends."""
MOST_DOUBLINGS = 10
"""More `<->` and `W` inside each other are refused: the normal form doubles with each of them."""

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
_BINARY: dict[str, Callable[[Formula, Formula], Formula]] = {
    "<->": Iff,
    "->": Implies,
    "U": Until,
    "W": WeakUntil,
    "R": Release,
}
_BINDING = {"<->": 0, "->": 1, "|": 2, "&": 3, "U": 4, "W": 4, "R": 4}
"""How tightly each binds."""
_UNARY_SYMBOL = {Not: "!", Next: "X ", WeakNext: "WX ", Eventually: "F ", Always: "G "}
_BINARY_SYMBOL = {Implies: "->", Iff: "<->", Until: "U", WeakUntil: "W", Release: "R"}

_TOKEN = re.compile(
    r"\s*(?:(?P<word>[A-Za-z_][A-Za-z0-9_]*)"
    r"|(?P<mark><->|<=>|->|=>|&&|\|\||[!&|()~∧∨¬→↔])"
    r"|(?P<other>\S))"
)
_PREFIX_RUN = re.compile(r"[FGX]{2,}$")
_TOO_DEEP = f"operators are nested deeper than {DEEPEST}"


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
        and name not in _BINARY
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
        formula = self._expression()
        token = self._tokens[self._index]
        if token.text:
            raise self._error(token.column, "expected an operator or the end")
        self._refuse_deep(formula)
        return formula

    def _expression(self, weakest: int = 0) -> Formula:
        """A formula whose operators outside parentheses bind at least as tightly as `weakest`."""
        self._depth += 1
        if self._depth > 2 * DEEPEST + 1:  # an operator may cost a '(' as well
            raise self._error(self._tokens[self._index].column, _TOO_DEEP)
        left = self._prefixed()
        mark = self._tokens[self._index].text
        while (binding := _BINDING.get(mark, -1)) >= weakest:
            self._index += 1
            if mark in ("&", "|"):
                operands = [left, self._expression(binding + 1)]
                while self._take(mark):
                    operands.append(self._expression(binding + 1))
                left = And(tuple(operands)) if mark == "&" else Or(tuple(operands))
            elif mark == "<->":
                left = Iff(left, self._expression(binding + 1))
            else:  # to the right: a U b U c is a U (b U c)
                left = _BINARY[mark](left, self._expression(binding))
            mark = self._tokens[self._index].text
        self._depth -= 1
        return left

    def _prefixed(self) -> Formula:
        prefixes = []
        while (prefix := _PREFIX.get(self._tokens[self._index].text)) is not None:
            prefixes.append(prefix)
            self._index += 1
        formula = self._primary()
        for prefix in reversed(prefixes):
            formula = prefix(formula)
        return formula

    def _primary(self) -> Formula:
        token = self._tokens[self._index]
        if self._take("("):
            inner = self._expression()
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

    def _refuse_deep(self, formula: Formula) -> None:
        # Without recursion: chains such as a <-> b <-> c nest deeper than the parser went.
        todo = [(formula, 0, 0)]
        while todo:
            part, depth, doublings = todo.pop()
            doublings += isinstance(part, (Iff, WeakUntil))
            if depth > DEEPEST:
                raise self._error(0, _TOO_DEEP)
            if doublings > MOST_DOUBLINGS:
                raise self._error(0, f"more than {MOST_DOUBLINGS} '<->' or 'W' inside each other")
            todo += [(child, depth + 1, doublings) for child in children(part)]


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
