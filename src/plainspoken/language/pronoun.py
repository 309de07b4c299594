"""Words that stand for a place or a visit named before, read as what they stand for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from plainspoken.language.expression import Shape
from plainspoken.language.item import Item
from plainspoken.language.lexicon import Kind
from plainspoken.language.reference import Form

_MARKS = frozenset((Kind.COMMA, Kind.STOP))
_AWAY = frozenset((("out", "of"), ("away", "from"), ("clear", "of")))
_VISITED = frozenset(("seen", "visited", "entered", "reached", "explored", "toured", "approached"))
_TELLING = frozenset((Kind.MUST, Kind.MAY, Kind.NOT, Kind.NEVER, Kind.BE, Kind.FORBIDDEN))
_VERBS = frozenset((Kind.GO, Kind.STAY, Kind.LEAVE, Kind.AVOID, Kind.PATROL))
_TIMING = frozenset(
    (Kind.BEFORE_THAT, Kind.AFTER_THAT, Kind.BEFORE, Kind.AFTER, Kind.UNTIL, Kind.FIRST,
     Kind.LATER, Kind.LATER_ON, Kind.ONLY_AFTER, *_MARKS)
)  # fmt: skip


def with_pronouns(found: Sequence[Item]) -> tuple[Item, ...]:
    """The items with relative pronouns, and visits told as events, in plain words."""
    made = list(found)
    index = 0
    while index < len(made):
        item = made[index]
        following = made[index + 1] if index + 1 < len(made) else None
        if item.kind is Kind.RELATIVE and item.text in ("which", "that", "who"):
            _related(made, index)
        elif item.kind is Kind.AND and index + 2 < len(made) and (
            (made[index + 1].text, made[index + 2].text) in _AWAY
        ) and any(each.kind is Kind.AVOID for each in made[:index]):  # fmt: skip
            made[index + 1] = replace(made[index + 1], kind=Kind.AVOID)
        elif item.text.startswith("un") and _is_visiting(item.text[2:]) and index and (
            item.kind is Kind.UNKNOWN
        ):  # fmt: skip
            # "while a is still unvisited"
            made[index : index + 1] = [
                replace(item, kind=Kind.NOT, text="not"),
                replace(item, kind=Kind.GO, text=item.text[2:], form=Form.FINITE),
            ]
            index += 1
        elif item.kind is Kind.UNKNOWN and item.text in ("use", "uses", "using", "used") and (
            _nearest_is_place(made, index)
        ):  # fmt: skip
            form = {"using": Form.GERUND, "use": Form.BASE}.get(item.text, Form.FINITE)
            made[index] = replace(item, kind=Kind.GO, form=form)
        elif item.kind is Kind.GO and item.text in ("come", "comes", "be made", "occur") and (
            following is None or following.kind in _TIMING
        ) and any(each.reference for each in made[:index]):  # fmt: skip
            made[index] = replace(item, kind=Kind.OCCUR)  # "no visit to a may come earlier"
        elif item.text in ("follow", "follows", "come next", "comes next", "be next") and (
            following is None or following.kind in _MARKS
        ):
            # "and b has to follow"
            made[index : index + 1] = [
                replace(item, kind=Kind.AFTER_THAT), replace(item, kind=Kind.OCCUR)
            ]  # fmt: skip
            index += 1
        index += 1
    return tuple(made)


def _is_visiting(text: str) -> bool:
    """Whether a participle says that a place has been gone to."""
    return text in _VISITED


def _nearest_is_place(made: Sequence[Item], index: int) -> bool:
    """Whether what a verb is said of is a place: "using a", "a may be used"."""
    behind = next((each for each in made[index + 1 :] if each.kind is not Kind.FILLER), None)
    if behind is None or behind.reference is None:
        behind = next((each for each in reversed(made[:index]) if each.reference), None)
    return (
        behind is not None
        and behind.reference is not None
        and behind.reference.shape is Shape.PLACE
    )


def _related(made: list[Item], index: int) -> None:
    """Say "a, which must not be first" as "a, a must not be first"."""
    before = next(
        (each for each in reversed(made[:index]) if each.kind not in (*_MARKS, Kind.FILLER)), None
    )
    if before is None or before.reference is None or index + 1 >= len(made):
        return
    stands = replace(before, first=made[index].first, last=made[index].last, filled=True)
    if any(each.text.endswith("followed by") for each in made[index + 1 : index + 5]):
        return  # "a, followed by b, which is to be followed by c"
    if made[index + 1].kind in _TELLING and made[index - 1].kind is Kind.COMMA:
        made[index - 1] = replace(made[index - 1], kind=Kind.STOP)
        made[index] = stands
        return
    if made[index + 1].kind is not Kind.SUBJECT:
        return
    end = next((i for i in range(index, len(made)) if made[i].kind in _MARKS), len(made))
    verb = next((i for i in range(end - 1, index, -1) if made[i].kind in _VERBS), None)
    rest = made[index:end]
    if verb is None or any(each.reference for each in rest) or not any(
        each.kind in _TELLING for each in rest
    ):  # fmt: skip
        return
    made.insert(verb + 1, stands)  # "a, which you must never enter"
