"""What is said of the places of a list without naming them again: in order, once, by turns.

"Never enter one of them before its predecessor" is "in that order", "never go back to any before
the next" is "without going back", "neither again before the other" is "by turns".
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from plainspoken.language.item import Item
from plainspoken.language.lexicon import Kind
from plainspoken.language.word import ORDINALS

_EARLIER = frozenset(
    ("predecessor", "predecessors", "turn", "previous", "preceding", "prior", "earlier", "skip",
     "skipping", "ahead")
)  # fmt: skip
_LATER = frozenset(("successor", "next", "following", "subsequent"))
_OTHER = frozenset(("other", "others", "else"))
_LISTED_WORDS = """
    listed named mentioned given stated said one ones each any either them both none it its room
    place places
"""
_LISTED = frozenset(_LISTED_WORDS.split())
_REPEATED = frozenset(("row", "succession", "consecutively", "running", "successively"))
_DENIALS = frozenset(
    (Kind.NOT, Kind.NEVER, Kind.ONLY, Kind.ONLY_AFTER, Kind.AVOID, Kind.FORBIDDEN, Kind.WITHOUT)
)
_GUARDS = frozenset(
    (Kind.BEFORE, Kind.BEFORE_THAT, Kind.UNTIL, Kind.UNLESS, Kind.WITHOUT, Kind.ONLY_AFTER,
     Kind.AFTER, Kind.ONLY_IF, Kind.AFTER_THAT)
)  # fmt: skip
_MARKS = frozenset((Kind.COMMA, Kind.STOP))


def with_orders(found: Sequence[Item]) -> tuple[Item, ...]:
    """The items with what is said of a list as a whole as the one word that it comes to."""
    made: list[Item] = []
    index = 0
    found = _numbered(found)
    while index < len(found):
        end = _span(found, index) if any(item.reference for item in made) else None
        if end is None:
            made.append(found[index])
            index += 1
            continue
        kind = _meant(found[index:end])
        if kind is None:
            made.append(found[index])
            index += 1
            continue
        first, last = found[index], found[end - 1]
        made.append(Item(kind, first.first, last.last, first.text))
        index = end
    return tuple(made)


def _numbered(found: Sequence[Item]) -> list[Item]:
    """Bring "a last, b second and c first" into the order that it tells."""
    made = list(found)
    places = [i for i, item in enumerate(made) if item.reference is not None]
    numbers = [_number(made[i + 1]) if i + 1 < len(made) else None for i in places]
    known = [number for number in numbers if number is not None]
    if len(places) < 2 or len(known) < len(places) or len(set(known)) < len(known):
        return made
    order = sorted(range(len(places)), key=lambda each: known[each])
    moved = [made[places[each]] for each in order]
    for place, item in zip(places, moved, strict=True):
        number = made[place + 1]
        made[place] = item
        made[place + 1] = replace(number, kind=Kind.THEN if place != places[-1] else Kind.FILLER)
    return made


def _number(item: Item) -> int | None:
    if item.text in ("last", "finally", "lastly"):
        return len(ORDINALS) + 1
    return int(ORDINALS[item.text]) if item.text in ORDINALS else None


def _span(found: Sequence[Item], index: int) -> int | None:
    """Where a remark that begins here, behind a mark or link, ends, if it names nothing."""
    before = found[index - 1].kind if index else Kind.STOP
    if before not in (*_MARKS, Kind.AND, Kind.BUT, Kind.THEN):
        return None
    end = index
    while end < len(found):
        item = found[end]
        if item.kind is Kind.STOP or (item.kind is Kind.COMMA and _joins(found, end)):
            break
        if item.reference is not None and not item.reference.rivals:
            return None  # "a room" may be any of them
        end += 1
    return end if end > index else None


def _joins(found: Sequence[Item], index: int) -> bool:
    """Whether a mark parts a remark from the next one, and does not stand within it."""
    following = [item for item in found[index + 1 : index + 3] if item.kind is not Kind.FILLER]
    return bool(following) and following[0].kind in (Kind.AND, Kind.BUT, Kind.THEN, *_DENIALS)


def _meant(remark: Sequence[Item]) -> Kind | None:
    words = {word for item in remark for word in item.text.split()}
    kinds = {item.kind for item in remark}
    denied = bool(kinds & _DENIALS)
    guarded = bool(kinds & _GUARDS)
    again = Kind.AGAIN in kinds or bool(
        words & {"twice", "back", "revisit", "revisiting", "return", "returning", "repeat"}
    )
    if again and words & _OTHER and Kind.BEFORE in kinds:
        return Kind.ALTERNATE
    if not denied and not (guarded and words & {"closed", "open", "opens"}):
        return None
    if words & _OTHER and guarded and (again or words & {"until", "unless"}):
        return Kind.ALTERNATE
    if again and words & _REPEATED and words & _LISTED:
        return Kind.ALTERNATE
    if again and guarded and words & _LATER:
        return Kind.NO_RETURN
    listed = bool(words & {"listed", "named", "mentioned"}) and Kind.AGAIN not in kinds
    before = bool(kinds & {Kind.BEFORE, Kind.BEFORE_THAT, Kind.UNTIL, Kind.AFTER, Kind.ONLY_AFTER})
    if (words & _EARLIER or listed) and before and words & (_LISTED | {"a"}) and not again:
        return Kind.IN_ORDER
    return None
