"""How often: "at least three separate times", "twice or more", "a third visit"."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from plainspoken.language.lexicon import MARKS
from plainspoken.language.word import ORDINALS, Word

_TIMES = {"once": 1, "twice": 2, "thrice": 3}
_LIMITS = {"minimum": ">=", "least": ">=", "maximum": "<=", "most": "<=", "limit": "<="}
_COUNTED = frozenset(("trip", "trips", "entry", "entries")) | frozenset(
    ["time", "times", "occasion", "occasions", "visit", "visits", "instance", "instances"]
)
_CALLS = frozenset(
    ["stop", "stops", "passes", "calls", "appearance", "appearances", "stopover", "stopovers"]
)
"""What only a bound makes a count: "exactly one stop at a", but not "one stop at a"."""
_SEPARATE_WORDS = """
    separate different distinct individual single on at in of and total for
"""
_SEPARATE = frozenset(_SEPARATE_WORDS.split())
_MORE = frozenset(("more", "further", "additional", "extra"))
BOUNDS = {
    ">=": """at least; no fewer than; no less than; not fewer than; not less than; a minimum of;
        minimum; equal or more than; equal to or more than""",
    "<=": """must not exceed; may not exceed; should not exceed; cannot exceed; not exceed; is
        limited to; are limited to; limited to; is capped at; at most; no more than;
        not more than; up to; a maximum of; maximum; not exceeding; not over; equal or
        less than; equal or fewer than; a total of at most""",
    "=": """add up to; adds up to; amount to; amounts to; equal; equals; be equal to; exactly;
        only; just; precisely; a total of; strictly; no more and no less than;
        no fewer or greater than; no fewer or more than; no more or less than;
        no more or fewer than; no less or more than; no more nor less than""",
    ">": """more often than; any more often than; exceed; exceeds; exceeding; above; more than;
        over; any more than; greater than; in excess of; any greater than""",
    "<": "less often than; below; fewer than; less than; any fewer than; any less than; under",
    "!=": """any greater or fewer than; more or less than; more or fewer than;
        fewer or more than; any more or any fewer than; any more or fewer than;
        any more or less than; less or more than""",
}
"""What is said before a number, by what it means."""
_AFTERWARDS = {
    ">=": """or more than one times; or more; at least; or more often; at the least;
        at the very least; if not more; minimum; or more separate""",
    "<=": """or fewer; or less; at most; or less often; at the most; at the very most; maximum;
        tops; if at all; at the outside""",
    "=": """only; and only once; and once only; and one time only; and only one time; no more;
        and no more; and no more than that; no more and no less; no more and no fewer;
        no more no less; neither more nor less; neither more nor fewer; not twice; not two;
        and not twice; just the one; exactly; precisely; no less; and that is it;
        and only that once""",
}


def _phrases(table: Mapping[str, str]) -> tuple[tuple[str, tuple[str, ...]], ...]:
    return tuple(
        (sign, tuple(phrase.split())) for sign, text in table.items() for phrase in text.split(";")
    )


_BEFORE_A_NUMBER = _phrases(BOUNDS)
_BEHIND_A_NUMBER = tuple(sorted(_phrases(_AFTERWARDS), key=lambda entry: -len(entry[1])))


@dataclass(frozen=True, slots=True)
class Count:
    """How often. bound: ">=", "<=", "=", ">", "<", "!=", or "" where only a number is said.

    more: whether it is on top of what was asked for before: "twice more"
    """

    bound: str
    times: int
    more: bool = False


def limit_at(said: Sequence[Word], index: int) -> Count | None:
    """The count in the number of "the minimum number of visits is three"."""
    bound = _limit(said, index)
    if bound is None or not said[index].number.isdigit():
        return None
    return Count(bound, int(said[index].number))


def tells_of_limit(said: Sequence[Word], index: int) -> bool:
    """Whether a word only leads to such a number: "the maximum number of separate visits"."""
    text = said[index].text
    return text in _LIMITS or (index > 0 and text in ("number", "allowable", "allowed", *_SEPARATE))


def count_at(said: Sequence[Word], index: int, end: int) -> tuple[Count, int] | None:
    """Read "at least three separate times", "twice or more", "no more than once"."""
    position, bound = index, ""
    for sign, phrase in _BEFORE_A_NUMBER:
        if index + len(phrase) > position and _says(said, index, end, phrase):
            position, bound = index + len(phrase), sign
    if not bound and _says(said, position + 1, end, ("or", "more", "than")):
        position, bound = position + 4, ">="  # "four or more than four times"
    times, after = _times(said, position, end)
    if times is None or (not bound and said[after - 1].text in _CALLS):
        return None
    lone = said[position].text == "once" and (not bound or said[index].text == "only")
    more = any(word.text in _MORE for word in said[position:after])
    if after < end and said[after].text == "more" and not _says(said, after, end, ("more", "than")):
        after, more = after + 1, True
    if bound in ("", "="):
        for sign, phrase in _BEHIND_A_NUMBER:
            tail = after + (after < end and said[after].text == "," and sign == "=")
            if _says(said, tail, end, phrase):
                after = tail + len(phrase)
                bound, lone = sign, False
                while after < end and said[after].text in (
                    *_COUNTED,
                    *_CALLS,
                    *_SEPARATE,
                    "occasions",
                ):
                    after += 1
                break
    answers = index > 0 and said[index - 1].text in ("is", "are")
    if lone and not answers and not _ends(said, after, end):
        return None
    sign = bound or _limit(said, index) or _limit_behind(said, after) or ""
    return Count(sign, times, more), after


def _limit(said: Sequence[Word], index: int) -> str | None:
    """The bound that a word like "minimum" before sets."""
    return next((_LIMITS[word.text] for word in said[:index] if word.text in _LIMITS), None)


def _limit_behind(said: Sequence[Word], after: int) -> str | None:
    """The bound set by what a number is told to be: "twice is the limit"."""
    if after >= len(said) or said[after].text not in ("is", "being", "as", "'s"):
        return None
    return next((_LIMITS[w.text] for w in said[after : after + 4] if w.text in _LIMITS), None)


def _times(said: Sequence[Word], position: int, end: int) -> tuple[int | None, int]:
    if position >= end:
        return None, position
    word = said[position]
    if word.text in _TIMES:
        return _TIMES[word.text], position + 1
    if word.text == "a" and _says(said, position, end, ("a", "couple", "of", "times")):
        return 2, position + 4
    if word.text == "a" and position + 1 < end and said[position + 1].text == "single":
        after = position + 2
        return 1, after + (after < end and said[after].text in _COUNTED)
    if not word.number.isdigit() or len(word.number) > 2:
        return None, position
    after = position + 1
    counted = False
    if _limited_behind(said, after, end):
        return int(word.number), after
    while after < end and (
        said[after].text in (*_COUNTED, *_CALLS)
        or said[after].text in (*_SEPARATE, *_MORE)
        or _says(said, after, end, ("or", "more", "times"))
        or _says(said, after, end, ("or", "fewer", "times"))
    ):
        if said[after].text in (*_COUNTED, *_CALLS):
            counted = True
            after += 1
            break
        if said[after].text == "or":
            return int(word.number), after
        after += 1
    counted |= _numbers(said[:position]) and (after >= end or _closes(said[after]))
    return (int(word.number), after) if counted else (None, position)


def _numbers(said: Sequence[Word]) -> bool:
    """Whether a number told behind these words is one of visits: "your visits must not exceed"."""
    return any(word.text in ("number", "visits", "trips", "entries", "times") for word in said)


def _closes(word: Word) -> bool:
    return word.is_mark or word.text in ("and", "but", "then", "or", "in")


def _limited_behind(said: Sequence[Word], after: int, end: int) -> bool:
    """Whether "or more separate visits" follows a number."""
    if not (_says(said, after, end, ("or", "more")) or _says(said, after, end, ("or", "fewer"))):
        return False
    after += 2
    while after < end and said[after].text in _SEPARATE:
        after += 1
    return after < end and said[after].text in _COUNTED


def nth_at(said: Sequence[Word], index: int, end: int) -> tuple[Count, int] | None:
    """Read "a third visit" as three or more, and "for the third time" as three."""
    first = index + (said[index].text == "for")
    if first + 2 >= end or said[first].text not in ("a", "any", "no", "the", "your", "its"):
        return None
    number, noun = ORDINALS.get(said[first + 1].text), said[first + 2].text
    if number is None or number == "1" or noun not in _COUNTED or (
        (number, noun) == ("2", "time") and first == index
    ):  # fmt: skip
        return None
    bound = {"a": ">=", "any": ">=", "no": "<"}.get(said[first].text, "")
    return Count(bound, int(number)), first + 3


def _says(said: Sequence[Word], index: int, end: int, phrase: Sequence[str]) -> bool:
    return index + len(phrase) <= end and all(
        said[index + i].text == each for i, each in enumerate(phrase)
    )


def _ends(said: Sequence[Word], after: int, end: int) -> bool:
    """Whether "once" ends a clause and so counts; before a clause it means "after"."""
    if after >= len(said):
        return True
    following = said[after].text
    if after == end:
        return False
    return following in ("and", "but", "then", "more", "again", "or", "before", "while", "do",
        "without", "never", "after") or following in MARKS  # fmt: skip
