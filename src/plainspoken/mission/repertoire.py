"""All that a robot can do and see, in the words of a planning domain.

Robots speak of poses and result codes, domains of facts. `landed` is where a result becomes a
state: what was believed before, the outcomes of the domain, and what the result says of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from plainspoken.mission.activity import Activity, Literal
from plainspoken.mission.robot import Failed, Seconds, Succeeded
from plainspoken.mission.service import Fields
from plainspoken.mission.template import Table, filled, meets
from plainspoken.world.domain import GroundAction, GroundAtom, Parameter, Problem, State
from plainspoken.world.scene import is_applicable, successors
from plainspoken.world.sense import Sense

TRIES = 3
"""How often a service that cannot be reached is asked about a fact, where nobody says."""


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


@dataclass(frozen=True, slots=True)
class Ask:
    """One service that tells of a fact; everything is a template over the sensor's parameters.

    when:   what its result is where the fact holds
    unless: what it is where the fact does not hold; None is whenever it is anything else
    """

    service: str
    fields: Fields
    when: Fields
    unless: Fields | None = None

    def told(
        self, result: Fields, values: Mapping[str, str], objects: Table, offer: Offer
    ) -> bool | None:
        """Whether the fact holds, by such a result; None where it cannot tell."""
        if not meets(result, offer.succeeds):
            return None
        if meets(result, filled(self.when, values, objects)):
            return True
        if self.unless is None or meets(result, filled(self.unless, values, objects)):
            return False
        return None


@dataclass(frozen=True, slots=True)
class Sensor:
    """How a fact is sensed, for every object that fits its parameters.

    atom:   a template over the parameters
    ways:   who is asked, in this order, until somebody can tell
    needed: whether only when a decision or an answer needs it; else with every look at the world
    lasts:  seconds for which a look is good; None for as long as nothing changes the fact
    tries:  how often a service that cannot be reached is asked
    unknown: whether nobody knows at s0
    """

    atom: str
    parameters: tuple[Parameter, ...]
    ways: tuple[Ask, ...]
    needed: bool = False
    lasts: Seconds | None = None
    tries: int = TRIES
    unknown: bool = False

    @property
    def sense(self) -> Sense:
        """What the log says of it."""
        by = tuple(each.service for each in self.ways) if self.needed else ()
        return Sense(self.atom, by, self.lasts, self.needed)

    def values(self, atom: GroundAtom) -> dict[str, str] | None:
        """What the parameters are for an atom; None where it does not fit."""
        if not self.sense.fits(atom):
            return None
        pairs = zip(self.atom.split(), atom.split(), strict=True)
        return {term.strip("{}"): word for term, word in pairs if term.startswith("{")}


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
    possible = _possible(problem, before, action, facts)
    open_atoms = _open_atoms(possible)
    if len(possible) > 1:
        # What is sensed tells outcomes apart; what somebody else changed meanwhile does not.
        telling = [fact for fact in seen if fact.atom in open_atoms]
        possible = [state for state in possible if all(fact.holds_in(state) for fact in telling)]
    if len(possible) > 1:
        unclear = f"done, but nothing says how it turned out: {', '.join(sorted(open_atoms))}?"
        return Failed(unclear, amended(before, (*facts, *seen)))
    # Where the domain has no such outcome, what was told and seen is all that is known.
    return Succeeded(amended(possible[0], seen) if possible else amended(before, (*facts, *seen)))


def undecided(
    problem: Problem,
    before: State,
    action: GroundAction,
    outcomes: Iterable[Outcome],
    result: Fields,
) -> State:
    """The atoms that tell apart how an action may have turned out, by what its result says."""
    outcomes = tuple(outcomes)
    fitting = next((outcome for outcome in outcomes if meets(result, outcome.when)), None)
    if outcomes and fitting is None:
        return frozenset()
    facts = fitting.facts if fitting is not None else ()
    return _open_atoms(_possible(problem, before, action, facts))


def _possible(
    problem: Problem, before: State, action: GroundAction, facts: Iterable[Literal]
) -> list[State]:
    """The states that an action may have led to, if these facts came about."""
    applicable = is_applicable(problem, before, action)
    return [
        state
        for state in (successors(problem, before, action) if applicable else ())
        if all(fact.holds_in(state) for fact in facts)
    ]


def _open_atoms(states: Sequence[State]) -> State:
    if len(states) < 2:
        return frozenset()
    return frozenset.union(*states) - frozenset.intersection(*states)


def amended(state: State, facts: Iterable[Literal]) -> State:
    """A state in which these facts hold; where two clash, the later one counts."""
    atoms = set(state)
    for fact in facts:
        if fact.wanted:
            atoms.add(fact.atom)
        else:
            atoms.discard(fact.atom)
    return frozenset(atoms)
