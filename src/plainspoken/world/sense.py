"""How facts come to be known: which service tells of one, and for how long a look is good.

The log of a mission keeps it, in its first entry: whoever reads the log knows as much as whoever
wrote it. Robots' files and landmarks say it first; `docs/knowledge.md` shows how.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from plainspoken.world.domain import GroundAtom, Parameter, Problem, State
from plainspoken.world.event import (
    ActionFinished,
    MissionAccepted,
    ObservationMade,
    ReportReceived,
    Stated,
)
from plainspoken.world.scene import settled_by
from plainspoken.world.symbol import flat

Seconds = float


@dataclass(frozen=True, slots=True)
class Sense:
    """How the facts that fit a pattern come to be known.

    atom:   a ground atom in which `{g}` stands for any object: `ripe {g}`
    by:     the services that can be asked, in this order; none where nothing can
    lasts:  how long a look is good, in seconds; None for as long as nothing changes the fact
    needed: whether it is looked at only when somebody needs it; else every look at the world tells
    """

    atom: str
    by: tuple[str, ...] = ()
    lasts: Seconds | None = None
    needed: bool = False

    def fits(self, atom: GroundAtom) -> bool:
        wanted, found = self.atom.split(), atom.split()
        if len(wanted) != len(found):
            return False
        bound: dict[str, str] = {}
        return all(
            bound.setdefault(term, word) == word if term.startswith("{") else term == word
            for term, word in zip(wanted, found, strict=True)
        )

    def to_json(self) -> dict[str, Any]:
        """An item of the field `senses` of a robot in the log."""
        return {"atom": self.atom, "by": list(self.by), "lasts": self.lasts, "needed": self.needed}

    @classmethod
    def of(cls, document: Mapping[str, Any]) -> Sense:
        """Read what `to_json` wrote."""
        by = tuple(document.get("by", ()))
        return cls(document["atom"], by, document.get("lasts"), document.get("needed", False))


@dataclass(frozen=True)
class Senses:
    """All that is said of how facts come to be known; of rules for one atom the first counts.

    lasting: by the ids of landmarks, for how long a look is good where no rule says
    """

    rules: tuple[Sense, ...] = ()
    lasting: Mapping[str, Seconds] = field(default_factory=dict)
    _found: dict[GroundAtom, Sense | None] = field(default_factory=dict, compare=False, repr=False)

    @classmethod
    def of(cls, accepted: MissionAccepted) -> Senses:
        """What the first entry of a log says."""
        lasting = {
            id: float(entry["lasts"])
            for id, entry in accepted.landmarks.items()
            if isinstance(entry, Mapping) and entry.get("lasts") is not None
        }
        return cls(tuple(map(Sense.of, accepted.robot.get("senses", ()))), lasting)

    def __bool__(self) -> bool:
        return bool(self.rules or self.lasting)

    def sense(self, atom: GroundAtom) -> Sense | None:
        """The rule for an atom."""
        if atom not in self._found:
            self._found[atom] = next((rule for rule in self.rules if rule.fits(atom)), None)
        return self._found[atom]

    def lasts(self, atom: GroundAtom) -> Seconds | None:
        """For how long a look at a fact is good."""
        rule = self.sense(atom)
        if rule is not None and rule.lasts is not None:
            return rule.lasts
        return self.lasting.get(flat(atom)) if self.lasting else None

    def is_needed_only(self, atom: GroundAtom) -> bool:
        """Whether a look at the world in general says nothing of a fact."""
        rule = self.sense(atom)
        return rule is not None and rule.needed

    def can_tell(self, atom: GroundAtom) -> bool:
        """Whether there is a service that can be asked about a fact."""
        rule = self.sense(atom)
        return rule is not None and bool(rule.by)


def senses_to_json(senses: Iterable[Sense]) -> list[dict[str, Any]]:
    """The field `senses` of a robot in the log."""
    return [each.to_json() for each in senses]


def atoms_of(pattern: str, problem: Problem) -> Iterator[GroundAtom]:
    """Every ground atom of a problem that fits a pattern."""
    predicate, *terms = pattern.split()
    places = problem.domain.predicates[predicate]
    free: dict[str, Parameter] = {
        term: Parameter(term, place.types)
        for term, place in zip(terms, places, strict=True)
        if term.startswith("{")
    }
    for binding in problem.bindings(tuple(free.values())):
        yield " ".join([predicate, *(binding.get(term, term) for term in terms)])


def told_by(
    event: Stated, before: State, unknown: State, senses: Senses, problem: Problem
) -> dict[GroundAtom, bool]:
    """What an event says of unknown atoms: it changed them, settled them, or was a look at them.

    before: the state before it, with all that is true
    """
    if isinstance(event, MissionAccepted) or not unknown:
        return {}
    found = (event.state ^ before) & unknown
    match event:
        case ActionFinished(action):
            found |= settled_by(problem, before, action) & unknown
        case ObservationMade(sensed=each) | ReportReceived(told=each) if each:
            return {
                **{atom: atom in event.state for atom in found},
                **{one["atom"]: one["holds"] for one in each if one["holds"] is not None},
            }
    if not isinstance(event, ReportReceived):
        rules = ((atom, senses.sense(atom)) for atom in unknown)
        found |= {atom for atom, rule in rules if rule is not None and not rule.needed}
    return {atom: atom in event.state for atom in found}


def implied(
    told: Mapping[GroundAtom, bool], groups: Iterable[tuple[GroundAtom, ...]]
) -> dict[GroundAtom, bool]:
    """What follows from what was told, where exactly one of each group is true."""
    found: dict[GroundAtom, bool] = {}
    for group in groups:
        others = [atom for atom in group if atom not in told]
        if any(told.get(atom) for atom in group):
            found.update(dict.fromkeys(others, False))
        elif len(others) == 1 and len(group) > 1:
            found[others[0]] = True
    return found


def left_open(
    groups: Iterable[tuple[GroundAtom, ...]],
    told: Mapping[GroundAtom, bool],
    settled: Iterable[GroundAtom] = (),
) -> tuple[tuple[GroundAtom, ...], ...]:
    """The groups of which exactly one untold atom is still true.

    settled: atoms that became known in another way: whether they were true before nobody knows
    """
    settled = frozenset(settled)
    remaining = (
        tuple(atom for atom in group if atom not in told)
        for group in groups
        if settled.isdisjoint(group) and not any(told.get(atom) for atom in group)
    )
    return tuple(group for group in remaining if group)
