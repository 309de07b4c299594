"""Why there is no policy, as values that say themselves in words which the caller supplies.

How a formula, a ground atom and a ground action are worded is not known here: `said` takes three
functions. Their defaults show formulas and PDDL as they are.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from plainspoken.logic.formula import Formula
from plainspoken.logic.syntax import unparse
from plainspoken.world.domain import GroundAction, GroundAtom
from plainspoken.world.symbol import AtomSymbol, Symbol

MOST_STEPS = 8
"""Steps of a lucky way that are told; of a longer one the first of them."""
_OPENERS = frozenset(
    {"after", "again", "as", "at", "both", "each", "either", "every", "eventually", "if"}
    | {"in", "it", "never", "not", "the", "there", "to", "whenever", "you", "i"}
)
"""A clause that begins so, or has a comma, does not fit into a sentence after `I can't`."""


@dataclass(frozen=True, slots=True)
class Words:
    """How to say a formula (as a task or sentence), a ground atom (as a clause) and an action."""

    say: Callable[[Formula], str] = lambda formula: f"satisfy {unparse(formula)}"
    atom: Callable[[GroundAtom], str] = lambda atom: f"{atom} is true"
    action: Callable[[GroundAction], str] = str

    def task(self, formula: Formula) -> str:
        """A formula as a clause without capital and full stop: `never visit line 2`."""
        sentences = [
            f"{each[0].lower()}{each[1:]}"
            for each in self.say(formula).strip().removesuffix(".").split(". ")
        ]
        text = " and ".join(sentences)
        return f"not {text.removeprefix('do not ')}" if text.startswith("do not ") else text

    def symbol(self, symbol: Symbol, *, true: bool) -> str:
        """What would have to become so, and never does."""
        if isinstance(symbol, AtomSymbol):
            never = "it can never be" if true else "it will always be"
            return f"{never} that {self.atom(symbol.atom)}"
        return f"I can never {self.action(' '.join((symbol.action, *symbol.arguments)))}"


PLAIN = Words()


@dataclass(frozen=True, slots=True)
class Contradiction:
    """No trace at all satisfies these parts together. minimal: but all of them but one."""

    parts: tuple[Formula, ...]
    minimal: bool = True

    def said(self, words: Words = PLAIN) -> str:
        if len(self.parts) == 1:
            return f"Nothing that can happen would do this: {words.task(self.parts[0])}."
        return f"{_together(self.parts, words)} That contradicts itself, whatever happens."

    def detail(self) -> dict[str, Any]:
        return {"kind": "contradiction", **_detail(self.parts, minimal=self.minimal)}


@dataclass(frozen=True, slots=True)
class ViolatedAtStart:
    """The initial state alone violates a part for good."""

    part: Formula

    def said(self, words: Words = PLAIN) -> str:
        return f"It is too late for this, as things stand at the start: {words.task(self.part)}."

    def detail(self) -> dict[str, Any]:
        return {"kind": "violated-at-start", **_detail((self.part,))}


@dataclass(frozen=True, slots=True)
class NeverTrue:
    """A part would need something to become true that never can."""

    symbols: tuple[Symbol, ...]
    part: Formula

    def said(self, words: Words = PLAIN) -> str:
        never = ", and ".join(words.symbol(each, true=True) for each in self.symbols)
        return f"{_alone(self.part, words)[:-1]}, for {never}."

    def detail(self) -> dict[str, Any]:
        named = [symbol.id for symbol in self.symbols]
        return {"kind": "never-true", "symbols": named, **_detail((self.part,))}


@dataclass(frozen=True, slots=True)
class NeverFalse:
    """A part would need something to become false that never can."""

    symbols: tuple[Symbol, ...]
    part: Formula

    def said(self, words: Words = PLAIN) -> str:
        always = ", and ".join(words.symbol(each, true=False) for each in self.symbols)
        return f"{_alone(self.part, words)[:-1]}, for {always}."

    def detail(self) -> dict[str, Any]:
        named = [symbol.id for symbol in self.symbols]
        return {"kind": "never-false", "symbols": named, **_detail((self.part,))}


@dataclass(frozen=True, slots=True)
class Breach:
    """An outcome after which nothing helps.

    added, deleted: what it changes and the outcome that was hoped for does not
    """

    action: GroundAction
    added: tuple[GroundAtom, ...]
    deleted: tuple[GroundAtom, ...]


@dataclass(frozen=True, slots=True)
class LuckyWay:
    """Actions that satisfy everything if they turn out well, and where they may not."""

    actions: tuple[GroundAction, ...]
    breach: Breach | None

    def said(self, words: Words = PLAIN) -> str:
        steps = ", ".join(map(words.action, self.actions[:MOST_STEPS]))
        more = len(self.actions) - MOST_STEPS
        text = f"With luck: {steps}" + (f", and {more} more steps." if more > 0 else ".")
        if self.breach is None:
            return text
        changes = [words.atom(atom) for atom in self.breach.added]
        changes = changes or [f"no longer {words.atom(atom)}" for atom in self.breach.deleted]
        outcome = f"it may be that {' and '.join(changes)}" if changes else "nothing may change"
        return (
            f"{text} But when I {words.action(self.breach.action)}, {outcome}, "
            f"and then nothing helps."
        )


@dataclass(frozen=True, slots=True)
class NoGuarantee:
    """The domain lets no policy satisfy these parts together.

    minimal: whether each of them is needed for that; False where it could not be found out
    whole:   whether they are all that was asked
    lucky:   whether they can be satisfied with luck; None where that is not known
    way:     a way that satisfies everything asked, with luck
    never:   whether it is proven that there is no such way
    """

    parts: tuple[Formula, ...]
    minimal: bool = True
    whole: bool = False
    lucky: bool | None = None
    way: LuckyWay | None = None
    never: bool = False

    def said(self, words: Words = PLAIN) -> str:
        if self.whole and not self.minimal:
            text = "I can't promise all of that"
            text += "; I could not find out in time which part is in the way."
        elif self.lucky is False:
            text = _together(self.parts, words)
        else:
            text = _together(self.parts, words, "I can't promise to ", "I can't promise ")
        if not self.whole and not self.minimal:
            text += " Perhaps not all of this is in the way; I could not find out in time."
        return f"{text} {self.way.said(words)}" if self.way else text

    def detail(self) -> dict[str, Any]:
        found: dict[str, Any] = {"kind": "no-guarantee", "lucky": self.lucky}
        found.update(_detail(self.parts, minimal=self.minimal))
        if self.way is not None:
            found["way"] = list(self.way.actions)
            breach = self.way.breach
            found["breach"] = breach and {
                "action": breach.action,
                "added": list(breach.added),
                "deleted": list(breach.deleted),
            }
        return found


@dataclass(frozen=True, slots=True)
class OnlyByRetrying:
    """There is a strong-cyclic policy, and no strong one for these parts."""

    parts: tuple[Formula, ...]
    minimal: bool = True

    def said(self, words: Words = PLAIN) -> str:
        text = _together(self.parts, words, "I can't promise to ", "I can't promise ")
        return f"{text[:-1]} in a fixed number of steps; trying again and again would do it."

    def detail(self) -> dict[str, Any]:
        return {"kind": "only-by-retrying", **_detail(self.parts, minimal=self.minimal)}


Reason = Contradiction | ViolatedAtStart | NeverTrue | NeverFalse | NoGuarantee | OnlyByRetrying


def is_hopeless(reason: Reason) -> bool:
    """Whether nothing that the domain lets happen satisfies what was asked, with any luck."""
    match reason:
        case NoGuarantee():
            return reason.never
        case OnlyByRetrying():
            return False
        case _:
            return True


def _detail(parts: Sequence[Formula], *, minimal: bool = True) -> dict[str, Any]:
    return {"parts": [unparse(part) for part in parts], "minimal": minimal}


def _fits(task: str) -> bool:
    return not _has_stops(task) and task.split(" ", 1)[0] not in _OPENERS


def _has_stops(task: str) -> bool:
    """Whether a clause has stops of its own."""
    return "," in task or " and " in task


def _alone(
    part: Formula, words: Words, opening: str = "I can't ", other: str = "I can't do "
) -> str:
    task = words.task(part)
    return f"{opening}{task}." if _fits(task) else f"{other}this: {task}."


def _together(
    parts: Sequence[Formula],
    words: Words,
    opening: str = "I can't ",
    other: str = "I can't do ",
) -> str:
    """As in `I can't both clear line 2 and never visit line 2`, or as a list."""
    if len(parts) == 1:
        return _alone(parts[0], words, opening, other)
    tasks = [words.task(part) for part in parts]
    if len(tasks) == 2:
        first, second = sorted(tasks, key=lambda task: not _fits(task))
        never = second.startswith("never ") and not _has_stops(second)
        if _fits(first) and (_fits(second) or never):
            return f"{opening}both {first} and {second}."
        return f"{other}both of these: {'; '.join(tasks)}."
    return f"{other}all of these together: {'; '.join(tasks)}."
