"""What the objects of a problem are called, from their names and their types."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise

from plainspoken.world.domain import Parameter, Problem
from plainspoken.world.wording import Wording, abbreviates, doing, is_word

_ORDINALS = (
    "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth",
)  # fmt: skip
_SHORTEST_OF_AN_AGENT = 4
"""Shorter names of agents are people's ("rob", "ann"), dictionary words or not."""


@dataclass(frozen=True)
class ObjectNames:
    """The ways to call each object of a problem. agents: those that move by themselves."""

    problem: Problem
    wording: Wording
    agents: Collection[str] = ()
    _made: dict[str, tuple[str, ...]] = field(default_factory=dict, repr=False)

    def __getitem__(self, name: str) -> tuple[str, ...]:
        """An object's ways to be called, the best first."""
        if name not in self._made:
            self._made[name] = tuple(dict.fromkeys(self._called(name)))
        return self._made[name]

    def kinds(self, name: str) -> list[str]:
        """The types of an object, nearest first, and static predicates that stand for types."""
        found = []
        own = self.problem.objects[name]
        while own != "object" and own not in found:
            found.append(own)
            own = self.problem.domain.types.get(own, "object")
        return found + [each for each in self._static if f"{each} {name}" in self.problem.initial]

    @cached_property
    def _static(self) -> tuple[str, ...]:
        changing = self.problem.changing_predicates
        return tuple(
            predicate
            for predicate, parameters in self.problem.domain.predicates.items()
            if len(parameters) == 1 and predicate not in changing
        )

    def of_kind(self, kind: str) -> tuple[str, ...]:
        """The objects of a type, or of a static predicate that stands for one."""
        return self.problem.objects_for(Parameter("?", (kind,))) or tuple(
            name for name in self.problem.objects if f"{kind} {name}" in self.problem.initial
        )

    def any_of(self, kind: str) -> str:
        """One of a type, whichever: "a line", "the box" where there is one only."""
        word = self.wording.spaced(kind)
        if len(self.of_kind(kind)) == 1:
            return f"the {word}"
        return f"{'an' if word[0] in 'aeiou' else 'a'} {word}"

    def _called(self, name: str) -> Iterator[str]:
        plain = self.wording.spaced(name)
        kinds = self.kinds(name)
        number = re.fullmatch(r"([a-z]+)[-_]?(\d+)", name)
        for kind in kinds:
            short = name.rstrip("0123456789") or name
            if number and abbreviates(number[1], kind):
                yield f"{self.wording.spaced(kind)} {number[2]}"
            elif name.startswith(kind) and len(name) == len(kind) + 1:
                yield f"{self.wording.spaced(kind)} {name[-1]}"
            elif self._is_alone(kind) and abbreviates(short, kind):
                yield f"the {self.wording.spaced(kind)}"
        common = self._is_common(plain, name)
        if common:
            yield f"the {plain}"
            yield from (
                f"the {plain} {word}"
                for word in map(self.wording.spaced, kinds[:1])
                if word not in plain
            )
        if name in self.agents:
            yield from self._agent(kinds)
        if not common:
            yield plain
        for kind in kinds[:1]:
            word = self.wording.spaced(kind)
            if word not in plain and not common:
                yield f"{word} {plain}"
            if word not in plain and self._is_alone(kind):
                yield f"the {word}"
        if number and number[2].isdigit() and 1 <= int(number[2]) <= len(_ORDINALS):
            yield from self._counted(number[1], int(number[2]), kinds[:1])

    def _agent(self, kinds: list[str]) -> Iterator[str]:
        """The only one of its kind by that kind: "the support robot", "the lifting robot"."""
        for kind, above in pairwise(kinds):
            if self._is_alone(kind):
                own, robot = self.wording.spaced(kind), self.wording.spaced(above)
                yield f"the {own} {robot}"
                if (gerund := doing(own)) is not None:
                    yield f"the {gerund} {robot}"

    def _counted(self, stem: str, number: int, kinds: list[str]) -> Iterator[str]:
        """Say "the second aisle" where counting begins with one."""
        if f"{stem}0" in self.problem.objects or f"{stem}-0" in self.problem.objects:
            return
        for kind in kinds:
            if abbreviates(stem, kind):
                yield f"the {_ORDINALS[number - 1]} {self.wording.spaced(kind)}"

    def _is_alone(self, kind: str) -> bool:
        return len(self.of_kind(kind)) == 1

    def _is_common(self, plain: str, name: str) -> bool:
        """Whether a name is a common noun, which takes an article: "the pantry"."""
        least = _SHORTEST_OF_AN_AGENT if name in self.agents else 3
        words = plain.split()
        return all(word.isalpha() and is_word(word) for word in words) and len(plain) >= least
