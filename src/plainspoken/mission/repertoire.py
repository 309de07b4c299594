"""All that a robot can do and see, in the words of a planning domain.

Robots speak of poses and result codes, domains of facts. `landed` is where a result becomes a
state: what was believed before, the outcomes of the domain, and what the result says of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from plainspoken.mission.activity import Activity, Literal
from plainspoken.mission.robot import Failed, Seconds, Succeeded
from plainspoken.mission.service import Fields
from plainspoken.mission.template import Table, filled, meets
from plainspoken.world.domain import GroundAction, GroundAtom, Parameter, Problem, State
from plainspoken.world.scene import is_applicable, successors


@dataclass(frozen=True, slots=True)
class Outcome:
    """A result that looks like this means that these facts came about.

    Both are templates over the action's arguments, until they are bound.
    """

    when: Fields
    facts: tuple[Literal, ...]

    def bound(self, arguments: Mapping[str, str], objects: Table) -> Outcome:
        when = filled(self.when, arguments, objects)
        return Outcome(when, tuple(fact.bound(arguments) for fact in self.facts))


@dataclass(frozen=True, slots=True)
class Conduct:
    """How an action is carried out. outcomes: the first that fits the result counts."""

    activity: Activity
    outcomes: tuple[Outcome, ...] = ()


@dataclass(frozen=True, slots=True)
class Sensor:
    """A service that tells of a fact, for every object that fits its parameters.

    atom, fields and when are templates over the parameters
    """

    atom: str
    parameters: tuple[Parameter, ...]
    service: str
    fields: Fields
    when: Fields


@dataclass(frozen=True, slots=True)
class Offer:
    """What is said of a service beside how it is reached.

    succeeds: what a result has to be, for the call to count as done
    reason:   how to read, from such a result, why it was not; a template
    progress: where feedback says how far it is, from 0 to 1; doing: in words; templates
    limit:    seconds that a call may take to answer where the robot's eyes are asked
    """

    succeeds: Fields = field(default_factory=dict)
    reason: str | None = None
    progress: str = "{progress}"
    doing: str = "{doing}"
    limit: Seconds = 5.0


@dataclass(frozen=True)
class Repertoire:
    """What a robot can do and see, checked against one domain.

    offers:   by the names of the services
    scene:    the service that gives all atoms that are true, and where its result has them
    """

    actions: Mapping[str, Conduct]
    offers: Mapping[str, Offer]
    sensors: tuple[Sensor, ...] = ()
    scene: tuple[str, str] | None = None
    objects: Table = field(default_factory=dict)


def arguments_of(problem: Problem, action: GroundAction) -> dict[str, str]:
    """An action's arguments by the names of its parameters, without question marks."""
    name, *arguments = action.split()
    schemas = problem.action(name)
    names = [parameter.name.removeprefix("?") for parameter in schemas[0].parameters]
    return dict(zip(names, arguments, strict=True))


def landed(
    problem: Problem,
    before: State,
    action: GroundAction,
    *,
    outcomes: Iterable[Outcome],
    result: Fields,
    seen: Iterable[Literal] = (),
) -> Succeeded | Failed:
    """The state after an action came to its end with such a result.

    before: what was believed; seen: what was sensed since, which counts for more
    """
    outcomes, seen = tuple(outcomes), tuple(seen)
    fitting = next((outcome for outcome in outcomes if meets(result, outcome.when)), None)
    if outcomes and fitting is None:
        return Failed(f"its result is none of the outcomes: {dict(result)}", amended(before, seen))
    facts = fitting.facts if fitting is not None else ()
    applicable = is_applicable(problem, before, action)
    possible = [
        state
        for state in (successors(problem, before, action) if applicable else ())
        if all(fact.holds_in(state) for fact in facts)
    ]
    open_atoms = frozenset[GroundAtom]()
    if len(possible) > 1:
        # What is sensed tells outcomes apart; what somebody else changed meanwhile does not.
        open_atoms = frozenset.union(*possible) - frozenset.intersection(*possible)
        telling = [fact for fact in seen if fact.atom in open_atoms]
        possible = [state for state in possible if all(fact.holds_in(state) for fact in telling)]
    if len(possible) > 1:
        unclear = f"done, but nothing says how it turned out: {', '.join(sorted(open_atoms))}?"
        return Failed(unclear, amended(before, (*facts, *seen)))
    # Where the domain has no such outcome, what was told and seen is all that is known.
    return Succeeded(amended(possible[0], seen) if possible else amended(before, (*facts, *seen)))


def amended(state: State, facts: Iterable[Literal]) -> State:
    """A state in which these facts hold; where two clash, the later one counts."""
    atoms = set(state)
    for fact in facts:
        if fact.wanted:
            atoms.add(fact.atom)
        else:
            atoms.discard(fact.atom)
    return frozenset(atoms)
