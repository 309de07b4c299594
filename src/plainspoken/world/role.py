"""Who acts in a planning problem, and which of its objects are places or are moved."""

from __future__ import annotations

from functools import cached_property

from plainspoken.world.domain import Action, AtomCondition, Parameter, Problem, changed_atoms
from plainspoken.world.reachability import PossibleAtoms

ATTRIBUTES = ("status", "state", "level", "mode", "phase", "color", "colour", "count", "value")
"""How predicates end whose last argument is no place: `victim-status`, `fuel-level`."""


class Roles:
    """The parts that the objects of a problem play, as far as its actions tell."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self.possible = PossibleAtoms(problem)

    @cached_property
    def motions(self) -> dict[str, tuple[str, ...]]:
        """Predicates that tell where something is, and the actions' first parameters that move.

        Such a predicate is deleted for one last argument and added for another by one action.
        """
        found: dict[str, set[str]] = {}
        for action in self.problem.domain.actions:
            for old in _replaced(action):
                if len(old.terms) == 1 and not self._is_one_place(old.predicate):
                    continue
                if old.predicate.endswith(ATTRIBUTES):
                    continue
                movers = found.setdefault(old.predicate, set())
                first = action.parameters[0] if action.parameters else None
                if first is not None and first.name in old.terms[:-1]:
                    movers |= set(self.problem.objects_for(first))
        return {
            predicate: tuple(o for o in self.problem.objects if o in movers)
            for predicate, movers in found.items()
            if movers or len(self.problem.domain.predicates[predicate]) == 1
        }

    def _is_one_place(self, predicate: str) -> bool:
        """Whether a predicate is always true of one thing: where the only robot is.

        What is on top of a pile also comes and goes, but several things may be.
        """
        if sum(1 for atom in self.problem.initial if atom.split()[0] == predicate) > 1:
            return False
        for action in self.problem.domain.actions:
            changes = [b for a, b in changed_atoms(action.effect) if a.predicate == predicate]
            if changes and sorted(changes) != [False, True]:
                return False
        return True

    @cached_property
    def agents(self) -> tuple[str, ...]:
        """The objects that move by actions of their own: the robots."""
        found = {mover for movers in self.motions.values() for mover in movers}
        return tuple(name for name in self.problem.objects if name in found)

    @cached_property
    def only_agent(self) -> str | None:
        """The one robot, which is spoken to and needs no name."""
        return self.agents[0] if len(self.agents) == 1 else None

    @cached_property
    def places(self) -> frozenset[str]:
        """Where the robots may be."""
        return frozenset(
            atom[-1] for predicate in self.motions for atom in self.possible.of(predicate)
        )

    @cached_property
    def mobile(self) -> frozenset[str]:
        """Whatever moves, by itself or with another's doing."""
        return frozenset(self.agents) | {
            atom[0]
            for predicate in self.motions
            for atom in self.possible.of(predicate)
            if len(atom) == 2
        }

    @cached_property
    def carried(self) -> frozenset[str]:
        """What is somewhere until an action takes it away: no robot, and no place."""
        taken = {
            atom.terms[0]: action
            for action in self.problem.domain.actions
            for atom, added in changed_atoms(action.effect)
            if not added and len(atom.terms) == 2
        }
        found = {
            name
            for term, action in taken.items()
            for parameter in action.parameters
            if parameter.name == term
            for name in self.possible.fitting(action, parameter)
        }
        return frozenset(found) - {*self.agents, *self.places}

    def is_setting(self, schema: Action, parameter: Parameter) -> bool:
        """Whether a parameter is a place or a robot, and not what the action is done to."""
        fitting = tuple(self.possible.fitting(schema, parameter))
        return bool(fitting) and all(name in self.places or name in self.agents for name in fitting)

    def moves(self, schema: Action) -> bool:
        """Whether an action brings something to a place of its own choice."""
        own = {parameter.name for parameter in schema.parameters}
        return any(
            atom.predicate in self.motions and atom.terms[-1] in own
            for atom, added in changed_atoms(schema.effect)
            if added
        )


def _replaced(action: Action) -> list[AtomCondition]:
    """What an action takes back to say it again of another last argument."""
    gone = [atom for atom, added in changed_atoms(action.effect) if not added]
    come = [atom for atom, added in changed_atoms(action.effect) if added]
    return [
        old
        for old in gone
        if any(
            old.predicate == new.predicate
            and 0 < len(old.terms) <= 2
            and old.terms[:-1] == new.terms[:-1]
            and old.terms[-1] != new.terms[-1]
            for new in come
        )
    ]
