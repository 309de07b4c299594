"""Reachability in the delete relaxation, one fact more at a time, with undo."""

from __future__ import annotations

from collections.abc import Sequence

FactIndex = int
OperatorIndex = int


class Closure:
    """The facts reached so far, closed under the operators, without any that is refused.

    adds:    what each operator adds, with its supporters
    waiting: the operators that each fact is a condition of
    counts:  the number of conditions of each operator
    """

    def __init__(
        self,
        adds: Sequence[Sequence[tuple[FactIndex, int]]],
        waiting: Sequence[Sequence[OperatorIndex]],
        counts: Sequence[int],
    ) -> None:
        self._adds = adds
        self._waiting = waiting
        self._counts = list(counts)
        self._reached = bytearray(len(waiting))
        self._refused = bytearray(len(waiting))

    def refuse(self, fact: FactIndex) -> None:
        self._refused[fact] = 1

    def reaches(self, fact: FactIndex) -> bool:
        return self._reached[fact] == 1

    def admit(self, facts: list[FactIndex], fired: Sequence[OperatorIndex] = ()) -> bool:
        """Reach some facts more, and what follows; nothing, where a refused one would follow."""
        todo = list(facts)
        counted: list[OperatorIndex] = []
        for fact in todo:
            self._reached[fact] = 1
        place = 0
        while self._add_all(fired, todo):
            if place == len(todo):
                return True
            fired = self._count(todo[place], counted)
            place += 1
        for operator in counted:
            self._counts[operator] += 1
        for fact in todo:
            self._reached[fact] = 0
        return False

    def _add_all(self, fired: Sequence[OperatorIndex], todo: list[FactIndex]) -> bool:
        """Reach what the operators add; no where that is refused."""
        reached, refused = self._reached, self._refused
        for operator in fired:
            for fact, _ in self._adds[operator]:
                if not reached[fact]:
                    if refused[fact]:
                        return False
                    reached[fact] = 1
                    todo.append(fact)
        return True

    def _count(self, fact: FactIndex, counted: list[OperatorIndex]) -> list[OperatorIndex]:
        """The operators whose last condition a fact is."""
        counts = self._counts
        operators = self._waiting[fact]
        fired = []
        for operator in operators:
            counts[operator] -= 1
            if not counts[operator]:
                fired.append(operator)
        counted += operators
        return fired
