"""Words in which tours are told, and somebody who draws them."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence

from plainspoken.world.symbol import SymbolId


def _either(words: str) -> tuple[str, ...]:
    """What can be said, divided by bars."""
    return tuple(each.strip() for each in words.split("|"))


GO = _either(
    "go to | visit | move to | head to | navigate to | reach | proceed to | drive to | find | "
    "get to | travel to | make your way to | stop by | swing by | stop at | pass by | see"
)
MUST = _either(" |  |  |  | you must | you have to | you should | please | make sure to")
NOT = _either(
    "do not | don't | never | you can not | you may not | you must not | you should not | be "
    "sure not to"
)
AWAY = _either(
    "while avoiding | while staying away from | avoiding | while keeping away from | without "
    "visiting | without passing | but keep away from | but stay clear of | while keeping "
    "clear of | but avoid | without going to | but do not go to"
)
ONCE = _either(
    "exactly once | only once | just once | one time only | once and only once | a single time"
)
ONLY_AFTER = _either("only after you visit | only after you have been to | only once you reach")
THEN = _either(
    "then | and then | then | after that | next | , then | and after that | followed by that "
    ", | once that is done , | afterwards | . then | . after that | ; then"
)
LAST = _either("finally | and finally | lastly | then | and then | at the end | , and last of all")
FIRST = _either("first | first of all , | to begin with , | at the start |  |  | ")
RETURNING = _either("returning to | going back to | revisiting")
ORDERLY = _either(
    "in that order | in this order | in exactly that order | in the given order | in the "
    "order given | in order | one after the other in that order | keeping to that order | in "
    "that very order"
)
ANYHOW = _either(
    "in any order | in no particular order | in whatever order | in no specific order | the "
    "order does not matter |"
)
TIMES = {
    1: ("once", "one time"),
    2: ("twice", "two times", "2 times"),
    3: ("three times", "3 times", "thrice"),
    4: ("four times", "4 times"),
    5: ("five times", "5 times"),
}
SEPARATE = _either(" |  | separate | different | distinct")
LEAST = _either(
    "at least | no fewer than | no less than | a minimum of | not less than | at minimum"
)
MOST = _either("at most | no more than | not more than | a maximum of | up to | no more often than")
JUST = _either("exactly | precisely | just | only | no more and no less than")
EVER = _either(
    "keep visiting | continuously visit | never stop visiting | do not stop visiting | patrol "
    "| keep patrolling | visit over and over | repeatedly visit | keep going to | always keep "
    "coming back to | infinitely often visit | go round and round between | keep checking on "
    "| make endless rounds of | do not ever stop going to"
)
SHUN = _either(
    "never go to | avoid | stay away from | keep away from | do not go to | never visit | "
    "always avoid | do not enter | keep out of | never pass by | at no point go to | steer "
    "clear of | do not ever go near"
)


class Speaker:
    """Somebody who names places and draws words."""

    def __init__(self, names: Mapping[SymbolId, Sequence[str]], draw: random.Random) -> None:
        self._names = names
        self.draw = draw

    def __call__(self, symbol: SymbolId) -> str:
        return self.draw.choice(self._names[symbol])

    def any(self, words: Sequence[str]) -> str:
        return self.draw.choice(words)

    def list(self, symbols: Sequence[SymbolId], last: str = "and") -> str:
        """Some places in a row."""
        named = [self(each) for each in symbols]
        if len(named) == 1:
            return named[0]
        style = self.draw.random()
        if style < 0.15:
            return f" {last} ".join(named)
        comma = "," if style < 0.55 else ""
        return ", ".join(named[:-1]) + f"{comma} {last} {named[-1]}"
