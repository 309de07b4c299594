"""The outer form of every PDDL file: parenthesised expressions with their lines, typed lists."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NoReturn

from plainspoken.errors import InputFileError
from plainspoken.world.document import read_text
from plainspoken.world.domain import Parameter

UNSUPPORTED = {
    ":functions": "numeric fluents",
    ":derived": "derived predicates",
    ":axiom": "axioms",
    ":durative-action": "durative actions",
    ":process": "processes",
    ":event": "events",
    ":constraints": "trajectory constraints: say them as an LTLf goal",
    "probabilistic": "probabilities: say `oneof`",
    "preference": "preferences",
    "increase": "numeric effects",
    "decrease": "numeric effects",
    "assign": "numeric effects",
    "scale-up": "numeric effects",
    "scale-down": "numeric effects",
    "<": "numeric conditions",
    ">": "numeric conditions",
    "<=": "numeric conditions",
    ">=": "numeric conditions",
}

SUPPORTED_HINT = "plainspoken plans with types, ADL conditions, conditional effects and oneof"

DEEPEST = 200
"""Lists nested deeper than this are refused."""
_HUMP = re.compile(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])")
_TOKEN = re.compile(r"\n|[()]|;[^\n]*|[^\s();]+")


class Expression(list["Expression | str"]):
    """A parenthesised list of names and lists, and the line it starts on, from 1."""

    line = 0

    def __str__(self) -> str:
        return "(" + " ".join(map(str, self)) + ")"


def parse_expression(text: str, path: str | Path) -> Expression:
    """The one parenthesised expression that a file holds."""
    root = Expression()
    stack = [root]
    line = 1
    ended = 0  # the line that closes the first expression
    unclosed: Expression | None = None  # a section that another one begins in
    for match in _TOKEN.finditer(text.lower()):
        token = match.group()
        if token == "\n":
            line += 1
        elif token == "(":
            inner = Expression()
            inner.line = line
            stack[-1].append(inner)
            stack.append(inner)
            if len(stack) > DEEPEST:
                raise InputFileError(f"nested deeper than {DEEPEST}", path, line=line)
        elif token == ")":
            if len(stack) == 1:
                raise _one_too_many(path, line if len(root) == 1 else ended or line)
            stack.pop()
            if len(stack) == 1:
                ended = ended or line
        elif token[0] != ";":
            if token[0] == ":" and not stack[-1] and len(stack) > 3 and unclosed is None:
                unclosed = stack[2]
            stack[-1].append(token)
    if len(stack) > 1:
        raise InputFileError(
            "a '(' is never closed",
            path,
            line=(unclosed or stack[-1]).line,
            hint="count the parentheses of what begins on this line",
        )
    match root:
        case [Expression() as only]:
            return only
        case [["define", *_], ["define", *_], *_]:
            raise InputFileError(
                "more than one (define ...)",
                path,
                line=root[1].line if isinstance(root[1], Expression) else None,
                hint="domain and problem are two files",
            )
        case [["define", *_], _, *_]:
            raise _one_too_many(path, ended)
        case _:
            raise InputFileError(
                "not a PDDL file: expected one (define ...)", path, hint="is it the right file?"
            )


def _one_too_many(path: str | Path, line: int) -> InputFileError:
    return InputFileError(
        "a ')' too many", path, line=line, hint="the first (...) of the file ends before it should"
    )


def humps(text: str) -> dict[str, str]:
    """The names that a file writes with capitals inside, parted there: `robotat`, "robot-at".

    PDDL does not tell case apart, but a reader of `robotAt` does.
    """
    found: dict[str, str] = {}
    for name in re.findall(r"[A-Za-z][\w-]*", re.sub(r";.*", "", text)):
        parted = _HUMP.sub("-", name).lower()
        if parted != name.lower():
            found.setdefault(name.lower(), parted)
    return found


class PddlFile:
    """One file as an expression; its methods read lists and raise errors that name the line."""

    def __init__(self, path: str | Path, text: str | None = None) -> None:
        """Read a file; with a text, that one, and path is for the errors only."""
        self.path = path
        text = read_text(path) if text is None else text
        self.root = parse_expression(text, path)
        self.humps = humps(text)

    def fail(self, what: str, at: Expression, hint: str | None = None) -> NoReturn:
        raise InputFileError(what, self.path, line=at.line or None, hint=hint)

    def expected(self, syntax: str, got: Expression | str, at: Expression) -> NoReturn:
        shown = str(got)
        self.fail(f"expected {syntax}, got {shown if len(shown) < 80 else shown[:77] + '...'}", at)

    def not_supported(self, word: str, at: Expression) -> NoReturn:
        self.fail(f"not supported: {UNSUPPORTED[word]} ({word})", at, SUPPORTED_HINT)

    def typed(
        self, words: list[Expression | str], at: Expression
    ) -> Iterator[tuple[str, tuple[str, ...]]]:
        """Names and their types from a list such as `a b - t1 c - (either t1 t2) d`."""
        waiting: list[str] = []
        rest = iter(words)
        for word in rest:
            if isinstance(word, Expression) or (word[0] == "-" and word != "-"):
                self.expected("a name", word, at)
            if word != "-":
                waiting.append(word)
                continue
            kind = next(rest, None)
            if isinstance(kind, Expression) and kind[:1] == ["either"]:
                types = tuple(str(each) for each in kind[1:])
            elif isinstance(kind, str):
                types = (kind,)
            else:
                self.expected("a type after '-'", "nothing" if kind is None else kind, at)
            yield from ((name, types) for name in waiting)
            waiting = []
        yield from ((name, ("object",)) for name in waiting)

    def parameters(self, words: list[Expression | str], at: Expression) -> tuple[Parameter, ...]:
        found = tuple(Parameter(name, types) for name, types in self.typed(words, at))
        for parameter in found:
            if not parameter.name.startswith("?"):
                self.expected("a variable such as ?x", parameter.name, at)
        return found
