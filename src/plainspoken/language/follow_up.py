"""What is said of a mission that stands: the frame around the words that name something.

"actually, site 3 first" puts something first, "skip site 3" leaves it out, "and don't forget the
store" adds to it. Only the frame is read here; what it holds is read like any utterance.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import StrEnum, auto


class Wish(StrEnum):
    """What a follow-up does to the mission."""

    RESTART = auto()
    REPLACE = auto()
    SKIP = auto()
    FIRST = auto()
    LAST = auto()
    REPEAT = auto()
    ADD = auto()
    ANEW = auto()


@dataclass(frozen=True, slots=True)
class FollowUp:
    """A wish, and the words of what it is about.

    what: the new thing, or a whole sentence
    old:  what it takes the place of, where that was said
    bare: whether `what` is a name and not a sentence
    """

    wish: Wish
    what: str = ""
    old: str = ""
    bare: bool = True


_OPENING = re.compile(
    r"^(?:(?P<no>no(?! need)|nope|not that)|oh|ah|um|uh|well|ok|okay|wait|sorry|hmm|please|"
    r"actually|and|but|also|now|additionally|in addition|plus|besides|moreover|furthermore|"
    r"one more thing|hang on|hold on|yes|great|fine|good|thanks|by the way)\b"
    r"(?:[\s,:;.!–—-]+|$)",
    re.IGNORECASE,
)
_THAT = (
    r"(?:that|it|this|everything|all(?: of)?(?: that| this| it)?|the (?:whole )?(?:mission|plan))"
)
_FRAMES: tuple[tuple[Wish, str], ...] = (
    (Wish.RESTART, (rf"(?:forget|scrap|cancel|drop|undo|delete) (?:about )?{_THAT}"
                   r"(?:[\s,]*(?:and )?(?:let's |let us )?start (?:over|again|afresh))?")),
    (Wish.RESTART, (r"(?:let's |let us )?(?:start|begin) (?:over|again|afresh|anew|from scratch)"
                   r"(?: again)?|never ?mind|cancel|reset")),
    (Wish.REPEAT, r"(?:make|do) (?:that|it|this) (?P<what>.+)"),
    (Wish.REPEAT, r"(?P<what>(?:(?:at (?:least|most)|exactly|only) )?(?:once|twice|\w+ times))"),
    (Wish.REPLACE, r"(?P<what>.+?),? (?:instead of|rather than|in place of) (?P<old>.+)"),
    (Wish.REPLACE, r"(?:replace|swap|exchange) (?P<old>.+?) (?:with|by|for) (?P<what>.+)"),
    (Wish.REPLACE, r"change (?P<old>.+?) (?:to|into) (?P<what>.+)"),
    (Wish.REPLACE, r"not (?P<old>.+?),? but (?P<what>.+)"),
    (Wish.REPLACE, (r"(?:i (?:mean|meant|said)|make (?:that|it)|rather|(?:it|that) should be)"
                   r" (?P<what>.+?)(?:,? not (?P<old>.+))?")),
    (Wish.REPLACE, r"(?P<what>.+?),? instead"),
    (Wish.ANEW, r"instead,? (?P<what>.+)"),
    (Wish.SKIP, r"leave (?P<what>.+?) out"),
    (Wish.SKIP, (r"(?:never ?mind|(?:do not|don't|don’t) worry about)(?: about)? (?P<what>.+?)"
                   r"(?: after all| any ?more| this time)?")),
    (Wish.SKIP, (r"(?:skip|leave out|drop|omit|forget|ignore|remove|leave off|without|not)"
                   r"(?: about)? (?!to )(?P<what>.+?)(?: after all| any ?more| this time)?")),
    (Wish.SKIP, r"(?:there is |there's )?no need (?:to (?:visit|go to|do)|for) (?P<what>.+)"),
    (Wish.SKIP, (r"(?:do not|don't|don’t|you need not|no need to) bother"
                   r" (?:with|about|visiting|going to|to visit|to go to) (?P<what>.+)")),
    (Wish.FIRST, (r"(?:but )?(?:before that|first|first of all|start with|begin with|start at),?"
                   r" (?P<what>.+)")),
    (Wish.FIRST, r"(?:go to |visit |do )?(?P<what>.+?),? (?:first|beforehand|before that)"),
    (Wish.LAST, (r"(?:then|and then|after that|afterwards|finally|end with|last|at the end),?"
                   r" (?P<what>.+)")),
    (Wish.LAST, (r"(?:go to |visit |do )?(?P<what>.+?),?"
                   r" (?:last|at the end|after that|afterwards|in the end|at last)")),
    (Wish.ADD, r"(?:do not|don't|don’t) forget(?: about| to visit| to go to)? (?P<what>.+)"),
    (Wish.ADD, r"(?:remember|include|add)(?: about| to visit| to go to)? (?P<what>.+)"),
    (Wish.ADD, r"(?P<what>.+?),? (?:too|as well|also)"),
)  # fmt: skip


def follow_ups(text: str) -> tuple[FollowUp, ...]:
    """What a follow-up may wish, the likeliest first; the last takes it for a whole sentence."""
    rest, denied = text.strip(), False
    while match := _OPENING.match(rest):
        denied |= bool(match["no"])
        rest = rest[match.end() :]
    rest = rest.strip().rstrip(".!")
    found = []
    for wish, frame in _FRAMES:
        match = re.fullmatch(frame, rest, re.IGNORECASE)
        if match:
            parts = match.groupdict()
            found.append(FollowUp(wish, parts.get("what") or "", parts.get("old") or ""))
    if denied:
        found.append(FollowUp(Wish.REPLACE, rest))
    found.append(FollowUp(Wish.ADD, rest, bare=False))
    return tuple(found)
