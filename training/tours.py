"""Tours told leg by leg: orders, counts and rounds of up to six places, in words drawn anew.

Sentences by hand are short. What grows with the number of places, and whose wording the writers
could only sample, is composed here: each leg of an order with its own guard, counts, rounds.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from pathlib import Path

from training.examples import Example, example_of, vocabulary_of
from training.wording import (
    ANYHOW,
    AWAY,
    EVER,
    FIRST,
    GO,
    JUST,
    LAST,
    LEAST,
    MOST,
    MUST,
    NOT,
    ONCE,
    ONLY_AFTER,
    ORDERLY,
    RETURNING,
    SEPARATE,
    SHUN,
    THEN,
    TIMES,
    Speaker,
)

from plainspoken.language.notation import NotationError, written
from plainspoken.logic.formula import Atom, Formula, conjunction
from plainspoken.logic.pattern import (
    AtLeast,
    AtMost,
    BoundDelay,
    Exactly,
    FairVisit,
    FutureAvoidance,
    GlobalAvoidance,
    GuardedVisit,
    OrderedVisit,
    PastAvoidance,
    Patrolling,
    Pattern,
    PromptReaction,
    SequencedVisit,
    StrictOrderedVisit,
    Visit,
    Wait,
)
from plainspoken.world.landmark import LandmarkType
from plainspoken.world.symbol import SymbolId

Words = str
Said = tuple[Words, tuple[Pattern, ...]]
Tour = Callable[[Speaker, Sequence[SymbolId]], Said]


def _formulas(symbols: Sequence[SymbolId]) -> tuple[Formula, ...]:
    return tuple(Atom(each) for each in symbols)


def _guarded_legs(say: Speaker, places: Sequence[SymbolId]) -> Said:
    """Each leg with what is not to be visited yet."""
    strict, all_of_them = say.draw.random() < 0.5, say.draw.random() < 0.4
    once = say.any(ONCE) if strict else ""
    away, parts = say.any(AWAY), []
    for index, place in enumerate(places[:-1]):
        rest = places[index + 1 :] if all_of_them else places[index + 1 : index + 2]
        start = say.any(FIRST) if index == 0 else say.any(THEN)
        parts.append(f"{start} {say.any(GO)} {say(place)} {once} {away} {say.list(rest, 'and')}")
    parts.append(f"{say.any(LAST)} {say.any(GO)} {say(places[-1])}")
    joint = say.any((" ", " , ", " , "))
    order = StrictOrderedVisit if strict else OrderedVisit
    return joint.join(parts), (order(_formulas(places)),)


def _until_legs(say: Speaker, places: Sequence[SymbolId]) -> Said:
    """Each place forbidden until the one before it, one sentence each."""
    strict = say.draw.random() < 0.45
    no, before = say.any(NOT), say.any(("until", "before", "until after", "unless and until"))
    done = say.any(("you have visited", "you have been to", "you visit", "you visited"))
    visit = say.any(GO)
    parts = [
        f"{no} {visit} {say(later)} {before} {done} {say(earlier)}"
        + (f" , {say.any(GO)} {say(earlier)} {say.any(ONCE)}" if strict else "")
        for earlier, later in pairwise(places)
    ]
    if say.draw.random() < 0.3:
        parts.reverse()
    demand = f"{say.any(MUST)} {visit} {say(places[-1])}"
    whole = f"{visit} {say.list(places)}"
    said = [demand, *parts] if say.draw.random() < 0.2 else [*parts, demand]
    if say.draw.random() < 0.35:
        said = [whole, *parts]
    order = StrictOrderedVisit if strict else OrderedVisit
    return say.any((" , ", " . ", " ; ", " and ", " ")).join(said), (order(_formulas(places)),)


def _only_after(say: Speaker, places: Sequence[SymbolId]) -> Said:
    """A chain of "only after"."""
    only = say.any(
        (
            "only after",
            "but only after",
            "only once you have been to",
            "no sooner than after",
            "only when you are done with",
        )
    )
    if say.draw.random() < 0.5:
        chain = [f"{say.any(GO)} {say(places[0])}"] + [
            f"{say.any(GO)} {say(later)} {only} {say(earlier)}"
            + say.any(("", "", " is visited", " has been visited"))
            for earlier, later in pairwise(places)
        ]
        return say.any((" , and ", " , ", " and then ", " ; ")).join(chain), (
            OrderedVisit(_formulas(places)),
        )
    chain = [
        f"{say.any(ONLY_AFTER)} {say(earlier)}"
        f" {say.any(('you can go to', 'you may visit', 'go to', 'move on to'))} {say(later)}"
        for earlier, later in pairwise(places)
    ]
    return " , ".join(chain), (OrderedVisit(_formulas(places)),)


def _listed_order(say: Speaker, places: Sequence[SymbolId]) -> Said:
    """A list, and that its order counts."""
    strict = say.draw.random() < 0.45
    no_return = (
        say.any(
            (
                "and do not go back to any of them before the next one is reached",
                "each of them only once before the next",
                "without returning to one before the next is reached",
                "never going back to an earlier one on the way to the next",
                "visiting each just once before moving on",
                "and no repeats along the way",
                "do not revisit one before completing the remaining ones",
            )
        )
        if strict
        else ""
    )
    listed = say.list(places, say.any(("and", "and then", "then")))
    said = f"{say.any(MUST)} {say.any(GO)} {listed} {say.any(ORDERLY)} {no_return}"
    # Of two places, and with no word of exactness, an order is an order; of more it is one, too.
    order = StrictOrderedVisit if strict else OrderedVisit
    return said, (order(_formulas(places)),)


def _strict_legs(say: Speaker, places: Sequence[SymbolId]) -> Said:
    """Each place before the next one, and not again before it."""
    again = say.any(("again", "a second time", "any more", "once more"))
    parts = [f"{say.any(FIRST)} {say.any(GO)} {say(places[0])}"]
    style = say.draw.random()
    for earlier, later in pairwise(places):
        if style < 0.5:
            parts.append(
                f"only then {say.any(GO)} {say(later)} and "
                f"{say.any(NOT)} {say.any(GO)} {say(earlier)} {again} before that"
            )
        else:
            parts.append(
                f"{say.any(THEN)} {say.any(GO)} {say(later)} , not before {say(earlier)} and "
                f"without {say.any(RETURNING)} {say(earlier)} first"
            )
    return " , ".join(parts), (StrictOrderedVisit(_formulas(places)),)


def _sequence(say: Speaker, places: Sequence[SymbolId]) -> Said:
    parts = [f"{say.any(FIRST)} {say.any(MUST)} {say.any(GO)} {say(places[0])}"]
    parts += [
        f"{say.any(THEN)} {say.any((*GO[:6], '', 'to'))} {say(each)}" for each in places[1:-1]
    ]
    parts.append(f"{say.any(LAST)} {say.any((*GO[:6], ''))} {say(places[-1])}")
    return say.any((" ", " , ")).join(parts), (SequencedVisit(_formulas(places)),)


def _visits(say: Speaker, places: Sequence[SymbolId]) -> Said:
    if len(places) == 2 and say.draw.random() < 0.35:
        one, other, go = say(places[0]), say(places[1]), say.any(GO)
        ways = (
            f"{go} {one} then {go} {other} or {go} {other} then {go} {one}",
            f"either {one} then {other} or {other} then {one}",
            f"{go} both {one} and {other} , whichever first",
            f"{go} {one} and also {other}",
        )
        return say.any(ways), (Visit(_formulas(places)),)
    each = say.any(("", "", "all of", "each of", "every one of"))
    said = f"{say.any(MUST)} {say.any(GO)} {each} {say.list(places)} {say.any(ANYHOW)}"
    return said, (Visit(_formulas(places)),)


def _fair(say: Speaker, places: Sequence[SymbolId]) -> Said:
    how = say.any(
        (
            "equally often",
            "the same number of times",
            "fairly",
            "taking turns",
            "in fair turns",
            "as often as each other",
            "in a fair manner",
            "with no one of them more often than another",
        )
    )
    return f"{say.any(MUST)} {say.any(GO)} {say.list(places)} {how}", (
        FairVisit(_formulas(places)),
    )


def _rounds(say: Speaker, places: Sequence[SymbolId]) -> Said:
    return f"{say.any(EVER)} {say.list(places)} {say.any(ANYHOW)}", (Patrolling(_formulas(places)),)


def _shunned(say: Speaker, places: Sequence[SymbolId]) -> Said:
    each = say.any(("", "", "any of", "either of" if len(places) == 2 else "all of"))
    said = f"{say.any(SHUN)} {each} {say.list(places, say.any(('and', 'or', 'or')))}"
    return said, (GlobalAvoidance(_formulas(places)),)


def _times(say: Speaker, times: int) -> str:
    """A count, as words or a number, perhaps of separate times."""
    kind = say.any(SEPARATE)
    said = say.any(TIMES[times])
    return said.replace(" times", f" {kind} times") if kind else said


def _at_least(say: Speaker, places: Sequence[SymbolId]) -> Said:
    times, place, go = say.draw.randint(2, 5), say(places[0]), say.any(GO)
    many, least = _times(say, times), say.any(LEAST)
    ways = (
        f"{say.any(MUST)} {go} {place} {least} {many}",
        f"{least} {many} you have to {go} {place}",
        f"{go} {place} {many} or more",
        f"make sure that you {go} {place} {least} {many} , more is fine",
        f"{place} needs to be visited {least} {many}",
        f"{go} {place} {many} at the least",
    )
    return say.any(ways), (AtLeast(Atom(places[0]), times),)


def _at_most(say: Speaker, places: Sequence[SymbolId]) -> Said:
    times, place, go = say.draw.randint(1, 5), say(places[0]), say.any(GO)
    many, most = _times(say, times), say.any(MOST)
    if times > 1 and say.draw.random() < 0.2:
        fewer = f"{go} {place} {say.any(('less than', 'fewer than'))} {many}"
        return fewer, (AtMost(Atom(places[0]), times - 1),)
    ways = (
        f"{say.any(MUST)} {go} {place} {most} {many}",
        f"{say.any(NOT)} {go} {place} more than {many}",
        f"never {go} {place} more often than {many}",
        f"{say.any(('limit your visits to', 'keep visits to'))} {place} to {most} {many}",
        f"{place} can be visited {most} {many}",
        f"you are allowed to {go} {place} {most} {many}",
        f"{go} {place} no more than {many}",
    )
    return say.any(ways), (AtMost(Atom(places[0]), times),)


def _exactly(say: Speaker, places: Sequence[SymbolId]) -> Said:
    times, place, go = say.draw.randint(1, 5), say(places[0]), say.any(GO)
    many, just = _times(say, times), say.any(JUST)
    ways = (
        f"{say.any(MUST)} {go} {place} {just} {many}",
        f"{just} {many} {go} {place}",
        f"{go} {place} {many} , no more , no less",
        f"{place} is to be visited {just} {many}",
    )
    return say.any(ways), (Exactly(Atom(places[0]), times),)


def _paired(say: Speaker, places: Sequence[SymbolId]) -> Said:
    one, other = places[:2]
    a, b = Atom(one), Atom(other)
    first, second, go = say(one), say(other), say.any(GO)
    again = say.any(("again", "any more", ""))
    at_once = say.any(("right after", "immediately after", "next", "at once"))
    ways: tuple[tuple[str, Pattern], ...] = (
        (
            f"once you have been to {first} {say.any(SHUN)} {second} {again}",
            FutureAvoidance(a, b),
        ),
        (f"after {first} you can never {go} {second}", FutureAvoidance(a, b)),
        (f"{say.any(SHUN)} {second} after you {go} {first}", FutureAvoidance(a, b)),
        (
            f"{say.any(NOT)} {go} {first} {say.any(('until', 'before'))} you have been to {second}",
            PastAvoidance(a, b),
        ),
        (f"{say.any(SHUN)} {first} until {second} is reached", PastAvoidance(a, b)),
        (
            f"{say.any(('wait', 'stay', 'remain', 'hold'))} at {first} until you are at {second}",
            Wait(a, b),
        ),
        (
            f"immediately after {first} {go} {second} , and {say.any(NOT)} at any other time",
            BoundDelay(a, b),
        ),
        (f"{go} {second} if and only if you were at {first} right before", BoundDelay(a, b)),
        (
            f"whenever you are at {first} , {go} {second} {at_once}",
            PromptReaction(a, b),
        ),
        (f"{go} {first} , but not before {second}", GuardedVisit(a, b)),
        (
            f"{go} {first} , and keep away from {second} until then",
            PastAvoidance(b, a, demanded=True),
        ),
        (f"{go} {first} without passing {second} on the way", PastAvoidance(b, a, demanded=True)),
    )
    said, pattern = say.draw.choice(ways)
    return said, (pattern,)


TOURS: tuple[tuple[Tour, int, int, float], ...] = (
    (_guarded_legs, 2, 5, 3),
    (_until_legs, 2, 5, 3),
    (_only_after, 2, 5, 2),
    (_listed_order, 2, 6, 2),
    (_strict_legs, 2, 5, 2),
    (_sequence, 2, 6, 2),
    (_visits, 2, 6, 2),
    (_fair, 2, 5, 1.5),
    (_rounds, 1, 5, 2),
    (_shunned, 1, 6, 2),
    (_at_least, 1, 1, 1),
    (_at_most, 1, 1, 1.5),
    (_exactly, 1, 1, 0.8),
    (_paired, 2, 2, 1.5),
)
"""Each with the fewest and the most places, and how often it is told."""


def toured(paths: Sequence[Path], count: int, seed: int) -> Iterator[Example]:
    """Tours of the places of some sites."""
    draw = random.Random(seed)
    vocabularies = [vocabulary_of(path) for path in paths]
    made = 0
    while made < count:
        vocabulary = draw.choice(vocabularies)
        names = {
            name: (mark.description, mark.description, *mark.names)
            for name, mark in vocabulary.landmarks.items()
            if mark.type is LandmarkType.LOCATION
        }
        tell, least, most, _ = draw.choices(TOURS, [each[-1] for each in TOURS])[0]
        if len(names) < most:
            continue
        places = draw.sample(sorted(names), draw.randint(least, most))
        utterance, patterns = tell(Speaker(names, draw), places)
        try:
            tokens = written(
                conjunction(*(each.literal for each in patterns)),
                conjunction(*(each.executable for each in patterns)),
            )
        except NotationError:
            continue
        example = example_of(_spelled(utterance, draw), tokens, vocabulary, "tour")
        if example.is_reachable:
            made += 1
            yield example


def _spelled(utterance: str, draw: random.Random) -> str:
    """The words with one space between, commas where they belong or nowhere."""
    text = " ".join(utterance.split())
    for sign in (",", ".", ";"):
        text = text.replace(f" {sign}", sign)
    for twice in (",,", ",.", ".,", ", ,"):
        text = text.replace(twice, twice[0])
    chance = draw.random()
    if chance < 0.3:
        return text.replace(",", "").replace(";", "")
    return text[0].upper() + text[1:] + "." if chance < 0.7 else text
