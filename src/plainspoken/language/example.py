"""A formula shown by example: short traces that satisfy it, and near misses that do not.

The near misses are made from a trace that satisfies the formula by the smallest changes that turn
the verdict: two instants the other way round, one left out, one more.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice

from plainspoken.automata.construction import Automaton, StateId
from plainspoken.errors import FormulaTooLargeError
from plainspoken.language.whereabouts import Apart, customary, fits, places_of_robots
from plainspoken.logic.formula import Atom, Formula, subformulas
from plainspoken.logic.trace import Letter
from plainspoken.world.landmark import Landmarks, LandmarkType
from plainspoken.world.symbol import SymbolId

MOST = 2
"""Examples of each kind."""
MOST_ATOMS = 8
"""A formula that speaks of more is not shown by example: nobody would read it."""
LONGEST = 14
"""Instants of an example."""
MOST_EXPANSIONS = 4000
MOST_CHANGES = 1000

NOTHING: Letter = frozenset()
Run = tuple[Letter, ...]


@dataclass(frozen=True, slots=True)
class Example:
    """A trace, and what happens in it in English."""

    trace: Run
    english: str

    def to_json(self) -> dict[str, object]:
        return {"english": self.english, "trace": [sorted(letter) for letter in self.trace]}


@dataclass(frozen=True, slots=True)
class Examples:
    """Traces that satisfy a formula and traces that do not, at most two of each."""

    accepted: tuple[Example, ...] = ()
    rejected: tuple[Example, ...] = ()

    @property
    def english(self) -> str:
        """All of it as it is shown to a person; empty where there is nothing to show."""
        shown = [
            f"{start}: {'; or: '.join(each.english for each in some)}."
            for start, some in (("For example", self.accepted), ("Not", self.rejected))
            if some
        ]
        return " ".join(shown)

    def to_json(self) -> dict[str, object]:
        return {
            "accepted": [each.to_json() for each in self.accepted],
            "rejected": [each.to_json() for each in self.rejected],
        }


def examples(formula: Formula, landmarks: Landmarks) -> Examples:
    """Show a formula by example; without any where it speaks of too much."""
    names = tuple(
        dict.fromkeys(part.name for part in subformulas(formula) if isinstance(part, Atom))
    )
    if not names or len(names) > MOST_ATOMS:
        return Examples()
    hard = places_of_robots(landmarks, names)
    for apart in ((*hard, *customary(landmarks, names)), hard):
        try:
            found = _Illustrator(formula, landmarks, names, apart).examples()
        except FormulaTooLargeError:
            return Examples()
        if found.accepted:
            return found
    return Examples()


class _Illustrator:
    def __init__(
        self,
        formula: Formula,
        landmarks: Landmarks,
        names: tuple[SymbolId, ...],
        apart: Apart,
    ) -> None:
        self._automaton = Automaton(formula)
        self._landmarks = landmarks
        self._names = names
        self._apart = apart
        self._acts = frozenset(
            name
            for name in names
            if name in landmarks and landmarks[name].type is LandmarkType.ACTION
        )

    def examples(self) -> Examples:
        first = self._typical()
        if first is None:
            return Examples()
        accepted, rejected = {self.said(first): first}, dict[str, Run]()
        # Changes of changes only where one change does not turn the verdict.
        for runs in (
            _changed(first, self._names),
            (far for near in _changed(first, self._names) for far in _changed(near, self._names)),
        ):
            for run in islice(runs, MOST_CHANGES):
                if not self._is_plausible(run):
                    continue
                kind = accepted if self._satisfies(run) else rejected
                text = self.said(run)
                if len(kind) < MOST and text not in accepted and text not in rejected:
                    kind[text] = run
                if len(accepted) == len(rejected) == MOST:
                    break
            if rejected and len(accepted) == MOST:
                break
        return Examples(
            tuple(Example(run, text) for text, run in accepted.items()),
            tuple(Example(run, text) for text, run in rejected.items()),
        )

    def _satisfies(self, run: Run) -> bool:
        state = self._automaton.initial
        for letter in run:
            state = self._automaton.step(state, letter)
        return self._automaton.accepts(state)

    def _is_plausible(self, run: Run) -> bool:
        # No action leads to the first instant.
        return (
            0 < len(run) <= LONGEST
            and not run[0] & self._acts
            and all(fits(letter, self._apart) for letter in run)
        )

    def _typical(self) -> Run | None:
        """A short trace that satisfies the formula and shows as many of its symbols as can be."""
        one_by_one = tuple(frozenset((name,)) for name in self._names)
        best: tuple[int, Run] | None = None
        for joined in (False, True):
            found = self._shortest(one_by_one, joined=joined)
            if found is not None and (best is None or found[0] > best[0]):
                best = found
            if best is not None and best[0] == len(self._names):
                break
        return best[1] if best else None

    def _shortest(self, letters: Sequence[Letter], *, joined: bool) -> tuple[int, Run] | None:
        """How many symbols the best of the shortest traces shows, and the trace.

        joined: whether symbols may hold together, as the formula asks for it
        """
        level: list[tuple[tuple[StateId, Letter], Run]]
        level = [((self._automaton.initial, NOTHING), ())]
        seen: set[tuple[StateId, Letter]] = set()
        best: tuple[int, Run] | None = None
        expansions = 0
        while level and expansions < MOST_EXPANSIONS:
            following: list[tuple[tuple[StateId, Letter], Run]] = []
            for (state, shown), run in level:
                for letter in self._letters(state, letters, joined=joined):
                    expansions += 1
                    longer = (*run, letter)
                    place = (self._automaton.step(state, letter), shown | letter)
                    if place in seen or not self._is_plausible(longer):
                        continue
                    seen.add(place)
                    following.append((place, longer))
                    if self._automaton.accepts(place[0]) and (
                        best is None or len(place[1]) > best[0]
                    ):
                        best = (len(place[1]), longer)
                        if best[0] == len(self._names):
                            return best
            level = following
        return best

    def _letters(
        self, state: StateId, letters: Sequence[Letter], *, joined: bool
    ) -> Iterator[Letter]:
        yield from letters
        if joined:
            for guard in self._automaton.guards(state):
                if len(guard.positive) > 1:
                    yield guard.positive
        yield NOTHING

    def said(self, run: Run) -> str:
        """What happens in a trace: "the quay, then the dock"."""
        shown = list(run)
        while len(shown) > 1 and not shown[0]:
            shown.pop(0)  # how it is before anything happens
        return ", then ".join(
            _instant(letter, before, self._landmarks, idle=self._idle)
            for before, letter in zip((NOTHING, *shown), shown, strict=False)
        )

    @property
    def _idle(self) -> str:
        places = any(
            name in self._landmarks and self._landmarks[name].type is LandmarkType.LOCATION
            for name in self._names
        )
        return "elsewhere" if places else "nothing"


def _changed(run: Run, names: Sequence[SymbolId]) -> Iterator[Run]:
    """Traces that differ by one change, those that show most first."""
    places = range(len(run))
    for i in places[1:]:
        if run[i] != run[i - 1]:
            yield (*run[: i - 1], run[i], run[i - 1], *run[i + 1 :])
    for i in places:
        for name in sorted(run[i]):
            if len(run[i]) > 1:
                yield (*run[:i], run[i] - {name}, *run[i + 1 :])
    for i in places[1:]:
        yield (*run[:i], NOTHING, *run[i:])
    for i in reversed(places):
        yield (*run[:i], *run[i + 1 :])
    for name in names:
        yield (*run, frozenset((name,)))
    for name in names:
        for i in places:
            yield (*run[:i], frozenset((name,)), *run[i:])
            yield (*run[:i], run[i] | {name}, *run[i + 1 :])
    yield (*run, NOTHING)


def _instant(letter: Letter, before: Letter, landmarks: Landmarks, *, idle: str) -> str:
    """What is so at an instant: "refuel at the quay while the tank is full"."""
    words: Mapping[LandmarkType, list[str]] = {kind: [] for kind in LandmarkType}
    for name in sorted(letter):
        known = landmarks.get(name)
        kind = known.type if known else LandmarkType.CONDITION
        text = known.description.removeprefix("to ") if known else f"{name} is true"
        words[kind].append(text)
    acts = " and ".join(words[LandmarkType.ACTION])
    places = " and ".join(words[LandmarkType.LOCATION])
    facts = " and ".join(words[LandmarkType.CONDITION])
    where = f"{acts} at {places}" if acts and places else acts or places
    if letter and letter == before and not acts:
        return f"still {where}" if where and not facts else "the same as before"
    if where and facts:
        return f"{where} while {facts}"
    return where or facts or idle
