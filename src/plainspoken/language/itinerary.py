"""The patterns that an utterance has asked for so far: tours, guards and the rest."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from plainspoken.language.counting import Count
from plainspoken.logic.formula import Atom, Formula, WeakNext, WeakUntil
from plainspoken.logic.pattern import (
    AtLeast,
    AtMost,
    BoundDelay,
    BoundReaction,
    DelayedReaction,
    Exactly,
    FairVisit,
    GlobalAvoidance,
    GuardedVisit,
    InstantaneousReaction,
    OrderedVisit,
    PastAvoidance,
    Pattern,
    PromptPrecedence,
    PromptReaction,
    SequencedVisit,
    StrictOrderedVisit,
    Visit,
    negated,
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

    chain:     the places that "then" would go on from
    guards:    what stays out, until what; of no matter where it is not on the way at all
    permitted: what may be visited, only after what: "once you have been to a, b is allowed"
    limits:    where to go not again, before what: "not twice to a before b"
    no_return: whether no place is to be visited again: "visit each of them once"
    """

    patterns: list[Pattern | Chain] = field(default_factory=list)
    chain: Chain | None = None
    guards: list[tuple[Formula, Formula]] = field(default_factory=list)
    permitted: list[tuple[Formula, Formula]] = field(default_factory=list)
    limits: list[tuple[Formula, Formula]] = field(default_factory=list)
    no_return: bool = False

    def add(self, pattern: Pattern | Chain) -> None:
        self.patterns.append(pattern)

    def begin(self, chain: Chain) -> None:
        """Add a chain, which may grow."""
        self.chain = chain
        self.patterns.append(chain)

    def drop_chain(self) -> None:
        """Take back the chain that is being read."""
        self.patterns = [each for each in self.patterns if each is not self.chain]
        self.chain = None

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

    def guards_against(self, place: Formula) -> bool:
        """Whether a place was already said to come after another one."""
        return any(
            (isinstance(each, GuardedVisit) and each.place == place)
            or (isinstance(each, PastAvoidance) and each.avoided == place)
            or (isinstance(each, Chain) and place in each.places[1:])
            for each in self.patterns
        )

    def is_guard(self, place: Formula) -> bool:
        """Whether another place was said to come after this one."""
        return any(
            (isinstance(each, GuardedVisit) and each.guard == place)
            or (isinstance(each, PastAvoidance) and each.until == place)
            for each in self.patterns
        )

    def enter_once(self, here: Formula, there: Formula) -> None:
        """Make an order strict: "do not go to a again before b"."""
        for each in self.patterns:
            if isinstance(each, Chain) and (here, there) in pairwise(each.places):
                each.strict = True
                return
        self.limits.append((here, there))

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
        return tuple(_without_repeats(self._joined(_bound(found))))

    def _joined(self, found: Sequence[Pattern]) -> list[Pattern]:
        """Say guards that follow one another, and how often each place is visited, as one order.

        "Not b until a, and a only once; not c until b, and b only once" is a way from a to c. So
        is "only after a you can go to b, only after b you can go to c": nobody would go on
        about the way to a place that is not to be reached.
        """
        path = _path(_steps(found, sequels=self.no_return))
        wanted = {place for each in found for place in _places(each)}
        if not path and self.limits:
            path = _path([*_steps(found, sequels=True), *self.limits])
            path = path if wanted.issuperset(path) else []
        turns = _round(self.limits)
        if turns:
            # "not a again before b, nor b again before a"
            kept = [rest for each in found for rest in _besides(each, turns, once=False)]
            return [*kept, FairVisit(tuple(turns))]
        counted = {each.place for each in found if isinstance(each, Exactly) and each.times == 1}
        limited = all(a in counted or (a, b) in self.limits for a, b in pairwise(path))
        once = self.no_return or (bool(path) and limited)
        goal = len(path) > 2 and all((b, a) in self.permitted for a, b in pairwise(path))
        if not path and self.no_return:
            return [one for each in found for one in _once(each)]
        told = bool(counted or self.limits) or len(path) > 2 or set(path[-1:]) <= wanted
        if not path or not (goal or (once and told)):
            strict = [
                step for each in found if isinstance(each, StrictOrderedVisit)
                for step in pairwise(each.places)
            ]  # fmt: skip
            left = [limit for limit in self.limits if limit not in strict]
            return [*found, *(_waiting(here, there) for here, there in left)]
        whole = (StrictOrderedVisit if once else OrderedVisit)(tuple(path))
        kept = [rest for each in found for rest in _besides(each, path, once=once)]
        return [whole, *kept]


def _waiting(here: Formula, there: Formula) -> Pattern:
    """Say "not here again before there" of places that no order joins."""
    return InstantaneousReaction(here, WeakNext(WeakUntil(negated(here), there)))


def _round(limits: Sequence[tuple[Formula, Formula]]) -> list[Formula]:
    """The places that limits lead round from one to the next and back to the first, or none."""
    following = dict(limits)
    if len(following) < 2 or len(following) < len(set(limits)):
        return []
    turns = [next(iter(following))]
    while (after := following.get(turns[-1])) is not None and after not in turns:
        turns.append(after)
    return turns if after == turns[0] and len(turns) == len(following) else []


def _places(pattern: Pattern) -> tuple[Formula, ...]:
    """The places that a pattern asks to be visited."""
    match pattern:
        case Visit(places) | SequencedVisit(places) | OrderedVisit(places):
            return places
        case GuardedVisit(place, _) | Exactly(place, _) | AtLeast(place, _):
            return (place,)
        case _:
            return ()


def _once(pattern: Pattern) -> list[Pattern]:
    """Each place of a visit only once."""
    if isinstance(pattern, Visit):
        return [Exactly(place, 1) for place in pattern.places]
    return [pattern]


def _steps(found: Sequence[Pattern], *, sequels: bool) -> list[tuple[Formula, Formula]]:
    """Which place comes before which, as the patterns say; "a, then b" only where asked for."""
    steps: list[tuple[Formula, Formula]] = []
    for each in found:
        match each:
            case PastAvoidance(later, earlier) | GuardedVisit(later, earlier):
                steps.append((earlier, later))
            case OrderedVisit(places):
                steps += pairwise(places)
            case SequencedVisit(places) if sequels:
                steps += pairwise(places)
    return [(a, b) for a, b in steps if isinstance(a, Atom) and isinstance(b, Atom) and a != b]


def _path(steps: Sequence[tuple[Formula, Formula]]) -> list[Formula]:
    """The places in the one order that the steps leave open, or none."""
    left = list(dict.fromkeys(place for step in steps for place in step))
    path: list[Formula] = []
    while left:
        first = [b for b in left if not any(y == b and x in left for x, y in steps)]
        if len(first) != 1 or (path and (path[-1], first[0]) not in steps):
            return []
        path += first
        left.remove(first[0])
    return path


def _besides(pattern: Pattern, path: Sequence[Formula], *, once: bool) -> list[Pattern]:
    """What a pattern says besides an order of places."""
    match pattern:
        case PastAvoidance(later, earlier) | GuardedVisit(later, earlier) if (
            later in path and earlier in path
        ):  # fmt: skip
            return []
        case OrderedVisit(places) | SequencedVisit(places) if [
            place for place in path if place in places
        ] == list(places):  # fmt: skip
            return []
        case Visit(places):
            left = tuple(place for place in places if place not in path)
            return [Visit(left)] if left else []
        case Exactly(place, 1) if once and place in path:
            return []
        case _:
            return [pattern]


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
