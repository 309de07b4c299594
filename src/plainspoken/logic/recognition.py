"""Mission patterns found in a formula by its structure, in either reading."""

from __future__ import annotations

from collections.abc import Iterator

from plainspoken.logic.formula import (
    Always,
    And,
    Atom,
    Constant,
    Eventually,
    Formula,
    Iff,
    Implies,
    Next,
    Not,
    Or,
    Until,
    WeakNext,
    WeakUntil,
    conjunction,
    conjuncts,
)
from plainspoken.logic.pattern import (
    AtLeast,
    AtMost,
    BoundDelay,
    BoundReaction,
    DelayedReaction,
    Exactly,
    FairVisit,
    FutureAvoidance,
    GlobalAvoidance,
    InstantaneousReaction,
    Maintenance,
    OrderedVisit,
    PastAvoidance,
    Patrolling,
    Pattern,
    PromptPrecedence,
    PromptReaction,
    Remaining,
    SequencedVisit,
    StrictOrderedVisit,
    Visit,
    Wait,
    negated,
)

MOST_TIMES = 12
"""Counts beyond this are not looked for."""


def is_boolean(formula: Formula) -> bool:
    """Whether a formula speaks of one instant only."""
    match formula:
        case Atom() | Constant():
            return True
        case Not(operand):
            return is_boolean(operand)
        case And(operands) | Or(operands):
            return all(map(is_boolean, operands))
        case _:
            return False


def is_sequel(formula: Formula) -> bool:
    """Whether a formula says one thing and what comes after it: `a & F(b & F c)`."""
    return _chain(formula) is not None


def sequel(formula: Formula) -> tuple[Formula, ...]:
    """What `a & F(b & F c)` says one after another; the formula alone where it is boolean."""
    return _chain(formula) or (formula,)


def is_errand(formula: Formula) -> bool:
    """Whether a formula says one thing after another, and at the end two at once: `a & F(b & c)`.

    So it is where something is carried to a place and put down there.
    """
    stops = _chain(formula)
    return stops is not None and len(stops) > 1 and isinstance(stops[-1], And)


def recognised(formula: Formula) -> tuple[Pattern | Formula, ...]:
    """The patterns whose conjunction the formula is, and the conjuncts that belong to none.

    A pattern stands where its first conjunct stood; `executable` or `literal` of it are conjuncts
    of the formula.
    """
    left = list(dict.fromkeys(conjuncts(formula)))
    found: list[Pattern | Formula] = []
    turns = _turns(left)
    while left:
        head = left[0]
        pattern = next((each for each in (*turns, *_candidates(head)) if _within(each, left)), None)
        if pattern is None:
            found.append(left.pop(0))
            continue
        for part in _parts(pattern, left):
            left.remove(part)
        found.append(pattern)
    return tuple(found)


def _turns(left: list[Formula]) -> tuple[FairVisit, ...]:
    """The fair visits whose rounds are closed: none of the places again before the next one."""
    waits: dict[Formula, Formula] = {}
    for each in left:
        match each:
            case Always(
                Implies(here, WeakNext(WeakUntil(Not(again), there)))
                | Implies(here, Next(WeakUntil(Not(again), there)))
            ) if here == again:
                waits[here] = there
    found: list[FairVisit] = []
    for each in left:
        if not isinstance(each, Eventually) or each.operand not in waits:
            continue
        places = [each.operand]
        while waits.get(places[-1]) not in (None, *places):
            places.append(waits[places[-1]])
        if len(places) > 1 and waits.get(places[-1]) == places[0]:
            found.append(FairVisit(tuple(places)))
    return tuple(found)


def _parts(pattern: Pattern, left: list[Formula]) -> tuple[Formula, ...]:
    executable = tuple(dict.fromkeys(conjuncts(pattern.executable)))
    if all(part in left for part in executable):
        return executable
    return tuple(dict.fromkeys(conjuncts(pattern.literal)))


def _within(pattern: Pattern, left: list[Formula]) -> bool:
    return all(part in left for part in _parts(pattern, left))


def _candidates(head: Formula) -> Iterator[Pattern]:
    """Patterns that may begin with a conjunct, those with more conjuncts first."""
    match head:
        case Eventually(inner):
            yield from _visits(inner)
        case Not(Eventually()):
            yield from _at_most(head)
        case Always(Implies(left_side, right_side)):
            yield from _reactions(left_side, right_side)
        case Always(Iff(a, Next(b))):
            yield BoundDelay(a, b, persists=False)
        case Always(Iff(a, b)) if is_boolean(a) and is_boolean(b):
            yield BoundReaction(a, b)
        case Always(Eventually(place)) if is_boolean(place):
            yield Patrolling((place,))
        case Always(kept) if is_boolean(kept):
            yield GlobalAvoidance((negated(kept),)) if _is_negative(kept) else Maintenance((kept,))
        case Until(kept, goal) if is_boolean(kept) and is_sequel(goal) and not is_boolean(goal):
            if not _is_negative(kept):
                yield Wait(kept, goal)
        case Until(kept, goal) if is_boolean(kept) and is_boolean(goal):
            yield (
                PastAvoidance(negated(kept), goal, demanded=True)
                if _is_negative(kept)
                else Wait(kept, goal)
            )
        case Until(kept, goal) if _is_negative(kept) and is_errand(goal):
            yield PastAvoidance(negated(kept), goal, demanded=True)
        case WeakUntil(kept, goal) if is_boolean(kept) and (is_boolean(goal) or is_errand(goal)):
            yield PastAvoidance(negated(kept), goal)
        case Implies(a, Next(b)) if is_sequel(b):
            yield PromptReaction(a, b)
        case Implies(Next(b), a):
            yield PromptPrecedence(a, b)
        case Iff(a, Next(b)):
            yield BoundDelay(a, b)
        case _:
            return


def _is_negative(formula: Formula) -> bool:
    match formula:
        case Not():
            return True
        case And(operands) | Or(operands):
            return all(map(_is_negative, operands))
        case _:
            return False


def _visits(inner: Formula) -> Iterator[Pattern]:
    if isinstance(inner, Always) and is_boolean(inner.operand):
        yield Remaining((inner.operand,))
    for place in _first_operands(inner):
        for times in range(MOST_TIMES, 0, -1):
            yield Exactly(place, times)
        for times in range(MOST_TIMES, 1, -1):
            yield AtLeast(place, times)
    places = _chain(inner)
    if places and len(places) > 1:
        yield StrictOrderedVisit(places)
        yield OrderedVisit(places)
        yield SequencedVisit(places)
    elif places:
        yield Visit(places)


def _first_operands(inner: Formula) -> Iterator[Formula]:
    """What a count may be of: the boolean part of the first conjunction."""
    if is_boolean(inner):
        yield inner
    elif isinstance(inner, And):
        yield conjunction(*(part for part in inner.operands if is_boolean(part)))


def _at_most(head: Not) -> Iterator[Pattern]:
    inner = head.operand.operand if isinstance(head.operand, Eventually) else head.operand
    for place in _first_operands(inner):
        for times in range(1, MOST_TIMES + 1):
            yield AtMost(place, times)


def _chain(inner: Formula) -> tuple[Formula, ...] | None:
    """The places of `a & F(b & F c)`; None for another shape."""
    if is_boolean(inner):
        return (inner,)
    if not isinstance(inner, And):
        return None
    here = [part for part in inner.operands if is_boolean(part)]
    later = [part for part in inner.operands if not is_boolean(part)]
    if not here or len(later) != 1 or not isinstance(later[0], Eventually):
        return None
    rest = _chain(later[0].operand)
    return (conjunction(*here), *rest) if rest else None


def _reactions(trigger: Formula, response: Formula) -> Iterator[Pattern]:
    match response:
        case WeakNext(Always(kept)) | Next(Always(kept)) if is_boolean(kept):
            yield FutureAvoidance(trigger, negated(kept))
        case Next(b) if is_sequel(b) and is_boolean(trigger):
            yield PromptReaction(trigger, b, persists=False)
        case Eventually(b) if is_sequel(b) and is_boolean(trigger):
            yield DelayedReaction(trigger, b)
        case _:
            if isinstance(trigger, Next) and is_boolean(response):
                yield PromptPrecedence(response, trigger.operand, persists=False)
            elif is_boolean(response) and is_boolean(trigger):
                yield InstantaneousReaction(trigger, response)
