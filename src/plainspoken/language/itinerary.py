"""The patterns that an utterance has asked for so far: tours, guards and the rest."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from plainspoken.language.item import Count
from plainspoken.logic.formula import Formula
from plainspoken.logic.pattern import (
    AtLeast,
    AtMost,
    BoundDelay,
    BoundReaction,
    DelayedReaction,
    Exactly,
    GlobalAvoidance,
    InstantaneousReaction,
    OrderedVisit,
    PastAvoidance,
    Pattern,
    PromptPrecedence,
    PromptReaction,
    SequencedVisit,
    StrictOrderedVisit,
    Visit,
)  # fmt: skip


@dataclass(slots=True)
class Chain:
    """Places visited one after another, while they are read."""

    places: list[Formula] = field(default_factory=list)
    ordered: bool = False
    strict: bool = False

    def pattern(self, guards: Sequence[tuple[Formula, Formula]]) -> Pattern:
        places = tuple(self.places)
        if len(places) == 1:
            return Exactly(places[0], 1) if self.strict else Visit(places)
        guarded = all((later, earlier) in guards for earlier, later in pairwise(places))
        if self.strict:
            return StrictOrderedVisit(places)
        return OrderedVisit(places) if self.ordered or guarded else SequencedVisit(places)


@dataclass(slots=True)
class Itinerary:
    """What has been asked for, in the order in which it was said.

    chain:  the places that "then" would go on from
    guards: what stays out, until what; of no matter where it is not on the way at all
    """

    patterns: list[Pattern | Chain] = field(default_factory=list)
    chain: Chain | None = None
    guards: list[tuple[Formula, Formula]] = field(default_factory=list)

    def add(self, pattern: Pattern | Chain) -> None:
        self.patterns.append(pattern)

    def begin(self, chain: Chain) -> None:
        """Add a chain, which may grow."""
        self.chain = chain
        self.patterns.append(chain)

    @property
    def last(self) -> Pattern | Chain | None:
        return self.patterns[-1] if self.patterns else None

    def bind(self, responses: list[Formula] | None) -> bool:
        """Bind the reaction before: "... and at no other time". Returns whether there was one."""
        last = self.last
        if responses is not None and [getattr(last, "response", None)] != responses:
            return False
        match last:
            case PromptReaction(a, b, persists):
                self.patterns[-1] = BoundDelay(a, b, persists)
            case DelayedReaction(a, b) | InstantaneousReaction(a, b):
                self.patterns[-1] = BoundReaction(a, b)
            case _:
                return False
        return True

    def enter_once(self, here: Formula, there: Formula) -> bool:
        """Make an order strict: "do not go to a again before b". Returns whether it has both."""
        for each in self.patterns:
            if isinstance(each, Chain) and (here, there) in pairwise(each.places):
                each.strict = True
                return True
        return False

    def merged(self) -> tuple[Pattern, ...]:
        """All patterns, with what two of them say together said by one."""
        places = {
            place for each in self.patterns if isinstance(each, Chain) for place in each.places
        }
        guards = [(a, b) for a, b in self.guards if a in places] + [
            (each.avoided, each.until) for each in self.patterns if isinstance(each, PastAvoidance)
        ]
        found = [
            each.pattern(guards) if isinstance(each, Chain) else each for each in self.patterns
        ]
        found += [
            PastAvoidance(avoided, until, demanded=True)
            if avoided in places and avoided != until
            else GlobalAvoidance((avoided,))
            for avoided, until in self.guards
        ]
        return tuple(_without_repeats(_bound(found)))


def _bound(found: Sequence[Pattern]) -> list[Pattern]:
    """Say "b right after a" and "no b but right after a" as one bound delay."""
    kept = list(found)
    for each in found:
        if isinstance(each, PromptReaction):
            other = PromptPrecedence(each.trigger, each.response, each.persists)
            if other in kept:
                kept[kept.index(each)] = BoundDelay(each.trigger, each.response, each.persists)
                kept.remove(other)
    return kept


def _without_repeats(found: Sequence[Pattern]) -> list[Pattern]:
    """Drop guards that an ordered visit already says."""
    told: set[Pattern] = set()
    for each in found:
        if isinstance(each, (OrderedVisit, StrictOrderedVisit)):
            told |= {
                PastAvoidance(later, earlier, demanded)
                for i, earlier in enumerate(each.places)
                for later in each.places[i + 1 :]
                for demanded in (True, False)
            }
    return [each for each in dict.fromkeys(found) if each not in told]


def count_pattern(place: Formula, count: Count, *, forbidden: bool) -> Pattern:
    """What a count asks for; "not more than" and the like turn it round."""
    times, bound = count.times, count.bound
    if forbidden:
        opposite = {">": "<=", "<": ">=", "!=": "=", "<=": ">", ">=": "<", "": "<", "=": "<"}
        bound = opposite[bound]
    match bound:
        case ">=":
            return AtLeast(place, times)
        case ">":
            return AtLeast(place, times + 1)
        case "<=":
            return AtMost(place, times) if times else GlobalAvoidance((place,))
        case "<":
            return AtMost(place, times - 1) if times > 1 else GlobalAvoidance((place,))
        case _:
            return Exactly(place, times) if times else GlobalAvoidance((place,))
