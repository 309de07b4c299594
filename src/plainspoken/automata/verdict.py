"""The running verdict of a formula while its trace grows.

Source: Bauer, Leucker, Schallhart, The Good, the Bad, and the Ugly, RV 2007 (four values, here
for finite traces as in Maggi et al., Monitoring Business Constraints, BPM 2011).
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum

from plainspoken.automata.construction import Automaton, Guard, StateId
from plainspoken.logic.formula import Formula, conjuncts
from plainspoken.logic.trace import Letter


class Verdict(StrEnum):
    """What is known of a formula before its trace has ended."""

    SATISFIED = "satisfied"
    """For good: however the trace goes on."""
    HOLDS_SO_FAR = "holds so far"
    """It would hold if the trace ended now; later instants may break it."""
    OPEN = "open"
    """It would not hold if the trace ended now; later instants may make it true."""
    VIOLATED = "violated"
    """For good: however the trace goes on."""


@dataclass(frozen=True, slots=True)
class Part:
    """One conjunct of the formula, and where its automaton is."""

    formula: Formula
    automaton: Automaton
    state: StateId

    @property
    def verdict(self) -> Verdict:
        if self.automaton.accepts(self.state):
            if self.automaton.must_accept(self.state):
                return Verdict.SATISFIED
            return Verdict.HOLDS_SO_FAR
        if self.automaton.can_accept(self.state):
            return Verdict.OPEN
        return Verdict.VIOLATED

    def closing(self) -> tuple[Guard, ...] | None:
        """A shortest way to make this part hold: what each next instant has to be like.

        Empty where it holds already, None where nothing can make it hold.
        """
        if not self.automaton.can_accept(self.state):
            return None
        came: dict[StateId, tuple[StateId, Guard]] = {}
        queue = deque([self.state])
        seen = {self.state}
        while queue:
            state = queue.popleft()
            if self.automaton.accepts(state):
                path: list[Guard] = []
                while state != self.state:
                    state, guard = came[state]
                    path.append(guard)
                return tuple(reversed(path))
            # Few demands first, so that of two shortest ways the one easier to say is taken.
            for guard in sorted(
                self.automaton.guards(state), key=lambda g: (len(g.positive), len(g.negative))
            ):
                if guard.target not in seen:
                    seen.add(guard.target)
                    came[guard.target] = (state, guard)
                    queue.append(guard.target)
        return None


@dataclass(frozen=True, slots=True)
class Monitor:
    """A formula and the part of a trace seen so far; `after` an instant there is a new one."""

    parts: tuple[Part, ...]

    @classmethod
    def of(cls, formula: Formula) -> Monitor:
        """A monitor that has seen nothing; its parts are the conjuncts as they are written."""
        return cls(
            tuple(Part(part, Automaton(part), Automaton.initial) for part in conjuncts(formula))
        )

    def after(self, letter: Letter) -> Monitor:
        """The monitor after one more instant."""
        return Monitor(
            tuple(
                Part(part.formula, part.automaton, part.automaton.step(part.state, letter))
                for part in self.parts
            )
        )

    def after_all(self, letters: Iterable[Letter]) -> Monitor:
        """The monitor after several more instants."""
        monitor = self
        for letter in letters:
            monitor = monitor.after(letter)
        return monitor

    @property
    def verdict(self) -> Verdict:
        """The verdict of the whole.

        It is the worst of the parts, so two parts that can each be met but not together show
        as open until one of them is lost.
        """
        verdicts = {part.verdict for part in self.parts}
        for worst in (Verdict.VIOLATED, Verdict.OPEN, Verdict.HOLDS_SO_FAR):
            if worst in verdicts:
                return worst
        return Verdict.SATISFIED
