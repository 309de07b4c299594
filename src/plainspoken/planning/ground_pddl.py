"""Ground actions over bits, written as PDDL without parameters and objects."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from plainspoken.planning.cube import Cube
from plainspoken.planning.task import Bits, ones
from plainspoken.world.domain import GroundAction

NAME = "compiled"
REQUIREMENTS = (
    ":strips",
    ":negative-preconditions",
    ":conditional-effects",
    ":non-deterministic",
)


@dataclass(frozen=True, slots=True)
class Effect:
    """Under a condition on the state before, bits are set and cleared."""

    condition: Cube
    add: Bits
    delete: Bits


Outcome = tuple[Effect, ...]


@dataclass(frozen=True, slots=True)
class CompiledAction:
    """A compiled action. number: 1 for the first of those that stand for one ground action."""

    original: GroundAction
    number: int
    precondition: Cube
    outcomes: tuple[Outcome, ...]


def distinct_names(prefix: str, texts: Iterable[str]) -> list[str]:
    """A name of letters, digits, '-' and '_' for each text, all different.

    The prefix keeps them from being words of PDDL, and `--` marks what was added to tell two
    names apart.
    """
    used: set[str] = set()
    found = []
    for text in texts:
        base = f"{prefix}-{re.sub('[^a-z0-9_-]', '_', text.replace(' ', '_'))}".replace("--", "-_")
        name, count = base, 1
        while name in used:
            count += 1
            name = f"{base}-_{count}"
        used.add(name)
        found.append(name)
    return found


class Text:
    """Writes PDDL."""

    def __init__(self, names: Mapping[int, str]) -> None:
        self._names = names

    def domain(self, actions: Mapping[str, CompiledAction]) -> str:
        lines = [
            f"(define (domain {NAME})",
            f"  (:requirements {' '.join(REQUIREMENTS)})",
            "  (:predicates",
            *(f"    ({self._names[bit]})" for bit in sorted(self._names)),
            "  )",
        ]
        for name, action in actions.items():
            outcomes = [self._outcome(outcome) for outcome in action.outcomes]
            effect = outcomes[0]
            if len(outcomes) > 1:
                effect = "\n      ".join(["(oneof", *outcomes]) + ")"
            condition = " ".join(self._condition(action.precondition))
            lines += [
                f"  (:action {name}  ; {action.original}",
                "    :parameters ()",
                f"    :precondition (and{' ' if condition else ''}{condition})",
                f"    :effect {effect})",
            ]
        return "\n".join([*lines, ")"]) + "\n"

    def problem(self, initial: Bits, goal: Bits) -> str:
        true = [f"    ({self._names[bit]})" for bit in ones(initial)]
        wanted = " ".join(f"({self._names[bit]})" for bit in ones(goal))
        return "\n".join(
            [
                f"(define (problem {NAME})",
                f"  (:domain {NAME})",
                "  (:init",
                *true,
                "  )",
                f"  (:goal (and {wanted}))",
                ")\n",
            ]
        )

    def _literal(self, bit: int, *, positive: bool) -> str:
        return f"({self._names[bit]})" if positive else f"(not ({self._names[bit]}))"

    def _condition(self, cube: Cube) -> list[str]:
        return [self._literal(bit, positive=value) for bit, value in cube.literals()]

    def _outcome(self, outcome: Outcome) -> str:
        parts: list[str] = []
        for effect in outcome:
            changes = [self._literal(bit, positive=False) for bit in ones(effect.delete)]
            changes += [self._literal(bit, positive=True) for bit in ones(effect.add)]
            condition = self._condition(effect.condition)
            if condition:
                change = changes[0] if len(changes) == 1 else f"(and {' '.join(changes)})"
                when = condition[0] if len(condition) == 1 else f"(and {' '.join(condition)})"
                parts.append(f"(when {when} {change})")
            else:
                parts += changes
        return f"(and {' '.join(parts)})" if parts else "(and)"
