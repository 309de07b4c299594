"""What a deed that somebody tells of has made so, by the actions of the domain.

A person who fetches a mug has moved it, but has not filled the robot's hand. So what an action
does to robots that nobody named is left out, and so is what hangs on it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice, product

from plainspoken.planning.exclusion import Exclusions, Literal
from plainspoken.questions.lexicon import Lexicon
from plainspoken.world.domain import Action, AllOf, AtomCondition, GroundAtom, State
from plainspoken.world.scene import outcomes, satisfies

MOST_TRIED = 2000
"""Instances of an action that are looked at; of more, the objects have to be named."""

Outcomes = tuple[tuple[Literal, ...], ...]
"""What a deed may have made so, each way once."""


@dataclass(frozen=True, slots=True)
class Deed:
    """Something done: an action of the domain and the objects that were named with it."""

    action: str
    objects: tuple[str, ...]


def accomplished(
    deed: Deed, named: frozenset[str], state: State, lexicon: Lexicon, exclusions: Exclusions
) -> tuple[Outcomes, ...]:
    """The outcomes of a deed; several where it is not known to what it was done.

    named: the objects of the whole report: what happened to a robot among them is told
    """
    best = -1
    found: dict[Outcomes, None] = {}
    for schema in lexicon.problem.action(deed.action):
        for binding in islice(_bindings(schema, deed.objects, lexicon), MOST_TRIED):
            score = _met(schema, binding, state, lexicon)
            if score is None or score < best:
                continue
            if score > best:
                best, found = score, {}
            action = " ".join([schema.name, *binding.values()])
            found[_outcomes(action, named, state, lexicon, exclusions)] = None
    return tuple(each for each in found if any(each))


def is_robot(name: str, lexicon: Lexicon) -> bool:
    """Whether an object acts by itself, or is of a kind with those that do."""
    kinds = set(lexicon.types_of(name))
    return any(kinds & set(lexicon.types_of(actor)) - {"object"} for actor in lexicon.actors)


def _bindings(
    schema: Action, objects: Sequence[str], lexicon: Lexicon
) -> Iterator[Mapping[str, str]]:
    """The ways to fill in an action in which every object has a place."""
    fitting = []
    for index, parameter in enumerate(schema.parameters):
        able = lexicon.problem.objects_for(parameter)
        here = [each for each in able if each in objects]
        if index == 0 and not here and lexicon.me in able:
            able = (str(lexicon.me),)
        fitting.append((*here, *(each for each in able if each not in here)))
    names = [parameter.name for parameter in schema.parameters]
    for chosen in islice(product(*fitting), MOST_TRIED):
        if set(objects) <= set(chosen):
            yield dict(zip(names, chosen, strict=True))


def _met(schema: Action, binding: Mapping[str, str], state: State, lexicon: Lexicon) -> int | None:
    """How much of what an action needs is so; None where it can never be."""
    condition = schema.precondition
    parts = condition.conditions if isinstance(condition, AllOf) else (condition,)
    score = 0
    for part in parts:
        holds = satisfies(state, part, lexicon.problem, binding)
        static = (
            isinstance(part, AtomCondition)
            and part.predicate not in lexicon.problem.changing_predicates
        )
        if static and not holds:
            return None
        # Where the robot is says nothing of what a person did elsewhere.
        terms = part.terms if isinstance(part, AtomCondition) else ()
        of_robot = any(is_robot(binding.get(term, term), lexicon) for term in terms)
        score += holds and not of_robot
    return score


def _outcomes(
    action: str, named: frozenset[str], state: State, lexicon: Lexicon, exclusions: Exclusions
) -> Outcomes:
    every = [_literals(*change) for change in outcomes(lexicon.problem, state, action)]
    kept = tuple(tuple(_own(each, named, state, lexicon, exclusions)) for each in every)
    # What is only ever done to a robot was done to it: "I charged the battery".
    return tuple(dict.fromkeys(kept if any(kept) else map(tuple, every)))


def _literals(added: frozenset[GroundAtom], deleted: frozenset[GroundAtom]) -> list[Literal]:
    return [
        *((atom, False) for atom in sorted(deleted - added)),
        *((atom, True) for atom in sorted(added)),
    ]


def _own(
    literals: Iterable[Literal],
    named: frozenset[str],
    state: State,
    lexicon: Lexicon,
    exclusions: Exclusions,
) -> Iterator[Literal]:
    """What a deed did by itself, not through the robot's being there or having its hand free."""
    literals = list(literals)
    robots: list[Literal] = []
    alone: list[Literal] = []
    for each in literals:
        names = each[0].split()[1:]
        strange = [is_robot(name, lexicon) and name not in named for name in names]
        if any(strange):
            robots.append(each)
        if names and all(strange):
            alone.append(each)
    for each in literals:
        # In its hand is what makes the robot's hand not empty any more.
        hangs = any(exclusions.exclude(each, (atom, not holds)) for atom, holds in alone)
        if each not in robots and not (each[1] and hangs):
            yield each
    for atom, holds in alone:
        # Whoever takes the mug out of its hand leaves the hand empty.
        group = exclusions.group(atom) if holds else ()
        if any((each, False) in literals and each in state for each in group):
            yield atom, True
