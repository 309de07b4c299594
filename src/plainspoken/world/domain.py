"""Planning domains and problems as frozen values: PDDL, typed, with `oneof`.

Names are lower case, as PDDL does not tell case apart. A ground atom is the text that CONTRACT
files use: predicate and arguments with single spaces, `robot-at rob l0`.

Source: PDDL 1.2 with ADL (McDermott et al. 1998), `oneof` as in the uncertainty tracks of the
planning competitions (Bryce and Buffet, 6th IPC, 2008).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from itertools import product

GroundAtom = str
"""`predicate argument ...`, lower case, single spaces: `robot-at rob l0`."""
GroundAction = str
"""`action argument ...`, in the same form: `move rob l0 l1`."""
State = frozenset[GroundAtom]
"""All ground atoms that are true at one instant."""


@dataclass(frozen=True, slots=True)
class Parameter:
    """A typed variable. An object fits if its type is, or is below, any of `types`."""

    name: str
    types: tuple[str, ...] = ("object",)


# Conditions. Terms are object names, or variables with their question mark.


@dataclass(frozen=True, slots=True)
class AtomCondition:
    predicate: str
    terms: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Equal:
    left: str
    right: str


@dataclass(frozen=True, slots=True)
class NotCondition:
    condition: Condition


@dataclass(frozen=True, slots=True)
class AllOf:
    conditions: tuple[Condition, ...] = ()


@dataclass(frozen=True, slots=True)
class AnyOf:
    conditions: tuple[Condition, ...] = ()


@dataclass(frozen=True, slots=True)
class ForAll:
    parameters: tuple[Parameter, ...]
    condition: Condition


@dataclass(frozen=True, slots=True)
class Exists:
    parameters: tuple[Parameter, ...]
    condition: Condition


Condition = AtomCondition | Equal | NotCondition | AllOf | AnyOf | ForAll | Exists


# Effects. All conditions of an effect are read in the state before the action; where one outcome
# both deletes and adds an atom, the atom is true afterwards.


@dataclass(frozen=True, slots=True)
class Add:
    atom: AtomCondition


@dataclass(frozen=True, slots=True)
class Delete:
    atom: AtomCondition


@dataclass(frozen=True, slots=True)
class Together:
    effects: tuple[Effect, ...] = ()


@dataclass(frozen=True, slots=True)
class When:
    condition: Condition
    effect: Effect


@dataclass(frozen=True, slots=True)
class ForEach:
    parameters: tuple[Parameter, ...]
    effect: Effect


@dataclass(frozen=True, slots=True)
class OneOf:
    """Exactly one of the effects happens; which one is not up to the robot."""

    effects: tuple[Effect, ...]


Effect = Add | Delete | Together | When | ForEach | OneOf


@dataclass(frozen=True, slots=True)
class Action:
    """An action schema. `line` is where the domain file defines it, from 1."""

    name: str
    parameters: tuple[Parameter, ...]
    precondition: Condition
    effect: Effect
    line: int = field(default=0, compare=False)


@dataclass(frozen=True)
class Domain:
    """A planning domain.

    types:      each type and its parent; `object` is the root and has none
    constants:  objects of every problem, with their type
    predicates: each predicate and its parameters
    humps:      names written with capitals inside, parted there: `robotat`, `robot-at`
    """

    name: str
    types: Mapping[str, str]
    constants: Mapping[str, str]
    predicates: Mapping[str, tuple[Parameter, ...]]
    actions: tuple[Action, ...]
    humps: Mapping[str, str] = field(default_factory=dict, compare=False)

    def ancestors(self, type: str) -> Iterator[str]:
        """The type itself, its parent and so on up to `object`."""
        while type != "object":
            yield type
            type = self.types.get(type, "object")
        yield type


@dataclass(frozen=True)
class Problem:
    """A planning problem together with its domain.

    objects: every object, constants of the domain included, and its type
    initial: the ground atoms true at s0
    goal:    the problem's own `:goal`
    humps:   names written with capitals inside, those of the domain included
    unknown: ground atoms of which nobody knows at s0 whether they are true; `initial` has those
             that are assumed to be
    oneofs:  groups of unknown atoms, exactly one of each is true
    """

    name: str
    domain: Domain
    objects: Mapping[str, str]
    initial: State
    goal: Condition
    source: str = field(default="", compare=False)
    humps: Mapping[str, str] = field(default_factory=dict, compare=False)
    unknown: State = frozenset()
    oneofs: tuple[tuple[GroundAtom, ...], ...] = ()

    @cached_property
    def _objects_by_type(self) -> dict[str, tuple[str, ...]]:
        found: dict[str, list[str]] = {}
        for name, own in self.objects.items():
            for each in self.domain.ancestors(own):
                found.setdefault(each, []).append(name)
        return {each: tuple(names) for each, names in found.items()}

    def objects_for(self, parameter: Parameter) -> tuple[str, ...]:
        """The objects that fit a parameter, in the order of the problem file."""
        if len(parameter.types) == 1:
            return self._objects_by_type.get(parameter.types[0], ())
        fits = {o for each in parameter.types for o in self._objects_by_type.get(each, ())}
        return tuple(o for o in self.objects if o in fits)

    def bindings(self, parameters: tuple[Parameter, ...]) -> Iterator[dict[str, str]]:
        """Every way to bind the parameters to objects that fit them."""
        names = [parameter.name for parameter in parameters]
        for chosen in product(*map(self.objects_for, parameters)):
            yield dict(zip(names, chosen, strict=True))

    @cached_property
    def changing_predicates(self) -> frozenset[str]:
        """The predicates that some action adds or deletes; the others are static."""
        return frozenset(
            atom.predicate
            for action in self.domain.actions
            for atom, _ in changed_atoms(action.effect)
        )

    def action(self, name: str) -> tuple[Action, ...]:
        """The schemas of a name. Domains with two of one name exist."""
        return tuple(action for action in self.domain.actions if action.name == name)


def ground(atom: AtomCondition, binding: Mapping[str, str]) -> GroundAtom:
    """The ground atom that an atom stands for under a binding of its variables."""
    return " ".join([atom.predicate, *(binding.get(term, term) for term in atom.terms)])


def changed_atoms(effect: Effect) -> Iterator[tuple[AtomCondition, bool]]:
    """The atoms that an effect may add (True) or delete (False), wherever they stand in it."""
    match effect:
        case Add(atom):
            yield atom, True
        case Delete(atom):
            yield atom, False
        case Together(effects) | OneOf(effects):
            for part in effects:
                yield from changed_atoms(part)
        case When(_, part) | ForEach(_, part):
            yield from changed_atoms(part)
