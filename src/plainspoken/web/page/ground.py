"""What there is to draw of a site: places, the ways between them, and where everything is.

Read from the planning problem alone, whatever the domain. Static facts about two places are ways;
what moves by itself is a robot; anything else is somewhere as its facts say, the changing ones
before those that never change: a grape in a box hangs no longer on its line.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property

from plainspoken.questions.lexicon import Lexicon
from plainspoken.web.page.layout import Layout
from plainspoken.world.domain import GroundAtom, Problem, State
from plainspoken.world.role import Roles

Thing = str
Place = str


@dataclass(frozen=True, slots=True)
class Whereabouts:
    """Where one thing is, and what is true of it alone.

    holder: the place, or the other thing, that it is at, in or on; None where nothing says so
    marks:  the predicates that are true of it and of nothing else
    """

    thing: Thing
    holder: str | None
    marks: tuple[str, ...]


class Ground:
    """The parts that the objects of a problem have on a map."""

    def __init__(self, lexicon: Lexicon, layout: Layout) -> None:
        self.lexicon = lexicon
        self.layout = layout
        self.problem: Problem = lexicon.problem
        self._roles = Roles(self.problem)

    @cached_property
    def robots(self) -> tuple[Thing, ...]:
        """What moves by itself, and what else the domain lets act."""
        acting = {*self._roles.agents, *self.lexicon.actors}
        # What others move is a robot where it is of a kind with one: a tractor that is called.
        kinds = {kind for one in acting for kind in self.lexicon.types_of(one)} - {"object"}
        acting |= {one for one in self._roles.mobile if kinds & set(self.lexicon.types_of(one))}
        return tuple(name for name in self.problem.objects if name in acting)

    @cached_property
    def places(self) -> tuple[Place, ...]:
        """Where something may be, in the order of the problem."""
        found = self._roles.places | set(self.layout.places)
        found |= {end for way in self._static_pairs(found) for end in way}
        return tuple(name for name in self.problem.objects if name in found)

    @cached_property
    def ways(self) -> tuple[tuple[Place, Place], ...]:
        """The pairs of places that a fact which never changes relates, each once."""
        known = set(self.places)
        pairs = [pair for pair in self._static_pairs(known) if known.issuperset(pair)]
        return tuple(dict.fromkeys(tuple(sorted(pair)) for pair in pairs))  # type: ignore[misc]

    def _static_pairs(self, places: Iterable[str]) -> list[tuple[str, str]]:
        """Static facts about two objects, of which one is a place and the other of its kind."""
        places = set(places)
        kinds = {self.problem.objects[name] for name in places if name in self.problem.objects}
        found = []
        for atom in sorted(self.problem.initial):
            predicate, *arguments = atom.split()
            if len(arguments) != 2 or predicate in self.problem.changing_predicates:
                continue
            first, second = arguments
            if (
                first != second
                and {first, second} & places
                and kinds.issuperset(self.problem.objects[each] for each in arguments)
            ):
                found.append((first, second))
        return found

    @cached_property
    def things(self) -> tuple[Thing, ...]:
        """Whatever else there is."""
        other = {*self.places, *self.robots}
        return tuple(name for name in self.problem.objects if name not in other)

    def whereabouts(self, state: State) -> Mapping[str, Whereabouts]:
        """Where robots, things and places are in a state, static facts included."""
        marks: dict[str, list[str]] = {}
        holders: dict[str, list[str]] = {}
        for atom in sorted(state, key=self._changing_first):
            predicate, *arguments = atom.split()
            changes = predicate in self.problem.changing_predicates
            if len(arguments) == 1 and changes:
                marks.setdefault(arguments[0], []).append(predicate)
                kept = self.layout.keeps.get(predicate)
                if kept is not None:
                    holders.setdefault(arguments[0], []).insert(0, self._keeper(kept))
            elif len(arguments) == 2:
                held, holder = self._held(*arguments)
                holders.setdefault(held, []).append(holder)
        return {
            name: Whereabouts(
                name,
                None if name in self.places else self._first_holder(name, holders.get(name, ())),
                tuple(marks.get(name, ())),
            )
            for name in self.problem.objects
        }

    def _changing_first(self, atom: GroundAtom) -> tuple[bool, str]:
        return atom.split(" ", 1)[0] not in self.problem.changing_predicates, atom

    def _held(self, first: str, second: str) -> tuple[str, str]:
        """Which of two related objects has the other: a place or a robot has a thing."""
        if second in self.places:
            return first, second
        if first in self.places or (first in self.robots and second not in self.robots):
            return second, first
        return first, second

    def _keeper(self, kept: str) -> str:
        return (self.lexicon.me or self.robots[0]) if kept == "robot" and self.robots else kept

    def _first_holder(self, name: str, holders: Iterable[str]) -> str | None:
        return next((each for each in holders if each != name), None)

    def doing(self, atoms: Iterable[GroundAtom]) -> frozenset[str]:
        """The objects that some atoms or actions speak of."""
        return frozenset(
            word for atom in atoms for word in atom.split()[1:] if word in self.problem.objects
        )
