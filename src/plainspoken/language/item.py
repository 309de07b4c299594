"""An utterance as items: its references, and the general words that shape a mission."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from plainspoken.language.grounding import Shape
from plainspoken.language.lexicon import MARKS, PHRASES, Kind
from plainspoken.language.reference import Form, Reference
from plainspoken.language.word import ORDINALS, Word

_TIMES = {"once": 1, "twice": 2, "thrice": 3}
_LIMITS = {"minimum": ">=", "least": ">=", "maximum": "<=", "most": "<=", "limit": "<="}
_COUNTED = frozenset(("trip", "trips", "entry", "entries")) | frozenset(
    ["time", "times", "occasion", "occasions", "visit", "visits", "instance", "instances"]
)
_SEPARATE_WORDS = """
    separate different distinct individual single on at in of and total for
"""
_SEPARATE = frozenset(_SEPARATE_WORDS.split())
BOUNDS = {
    ">=": """at least; no fewer than; no less than; not fewer than; not less than; a minimum of;
        minimum; equal or more than; equal to or more than""",
    "<=": """must not exceed; may not exceed; should not exceed; cannot exceed; not exceed; is
        limited to; are limited to; limited to; is capped at; at most; no more than;
        not more than; up to; a maximum of; maximum; not exceeding; not over; equal or
        less than; equal or fewer than; a total of at most""",
    "=": """exactly; only; just; precisely; a total of; strictly; no more and no less than;
        no fewer or greater than; no fewer or more than; no more or less than;
        no more or fewer than; no less or more than; no more nor less than""",
    ">": "more than; over; any more than; greater than; in excess of; any greater than",
    "<": "fewer than; less than; any fewer than; any less than; under",
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
    """How often. bound: ">=", "<=", "=", ">", "<", "!=", or "" where only a number is said."""

    bound: str
    times: int


@dataclass(frozen=True, slots=True)
class Item:
    """A reference or a phrase of the lexicon.

    first, last: its words
    start:       character of a reference, which the members of "every site" share
    filled:      whether a reference stands for a pronoun
    """

    kind: Kind
    first: int
    last: int
    text: str
    form: Form | None = None
    reference: Reference | None = None
    count: Count | None = None
    start: int = 0
    filled: bool = False


def items(said: Sequence[Word], found: Sequence[Reference]) -> tuple[Item, ...]:
    """Cut an utterance into items; words that neither table nor domain knows are UNKNOWN."""
    starts = {each.first: each for each in found}
    made: list[Item] = []
    index = 0
    while index < len(said):
        if index in starts:
            reference = starts[index]
            text = " ".join(word.text for word in said[index : reference.last])
            made.append(
                Item(
                    Kind.REFERENCE,
                    index,
                    reference.last,
                    text,
                    reference.form,
                    reference,
                    start=said[index].start,
                    filled=_is_filled(said, reference),
                )
            )
            index = reference.last
            continue
        end = min((first for first in starts if first > index), default=len(said))
        item = _between(said, index, starts, made) or _next(said, index, end)
        if item is not None and item.kind is Kind.UNKNOWN:
            item = _limited(said, index) or item
        if item is not None:
            made.append(item)
        index = item.last if item is not None else index + 1
    return tuple(_without_idioms(made))


def _without_idioms(made: Sequence[Item]) -> Iterator[Item]:
    """Pass over what is set in a place that is not to be entered: "do not set a boot in site 2"."""
    for index, item in enumerate(made):
        before = [each for each in made[max(index - 3, 0) : index] if each.text not in ("a", "any")]
        set_down = [each.text for each in before[-1:]] == ["set"]
        denied = any(each.kind in (Kind.NOT, Kind.NEVER) for each in before[-2:])
        after = [each for each in made[index + 1 : index + 4] if each.text not in ("the", "a")]
        enters = (
            len(after) > 1
            and after[0].text in ("in", "into", "inside", "on", "onto")
            and after[1].reference is not None
            and after[1].reference.shape is Shape.PLACE
        )
        if item.kind is Kind.UNKNOWN and set_down and denied and enters:
            yield replace(item, kind=Kind.FILLER)
        else:
            yield item


def _is_filled(said: Sequence[Word], reference: Reference) -> bool:
    """Whether the words of a reference were put in for a pronoun: all stand where it stood."""
    first, last = said[reference.first], said[reference.last - 1]
    near = [*said[max(reference.first - 1, 0) : reference.first],
            *said[reference.last : reference.last + 1]]  # fmt: skip
    return (
        (first.start, first.end) == (last.start, last.end)
        and len(first.text) > first.end - first.start
        and all(word.start != first.start for word in near)
    )


def _between(
    said: Sequence[Word], index: int, starts: Mapping[int, Reference], made: Sequence[Item]
) -> Item | None:
    """Read the "to" of "from a to b" as "then", and "with the lid open" as "while"."""
    before = next((each for each in reversed(made) if each.kind is not Kind.COMMA), None)
    after_place = before is not None and before.form is Form.NOUN
    if after_place and said[index].text == "to" and _skips_articles(said, index + 1) in starts:
        return Item(Kind.THEN, index, index + 1, "to")
    following = starts.get(index + 1) or starts.get(_skips_articles(said, index + 1))
    causes = said[index].text in ("get", "bring", "put", "have")
    if causes and following is not None and following.shape is Shape.STATE:
        return Item(Kind.ENSURE, index, index + 1, said[index].text)
    if said[index].text == "with" and following is not None:
        if following.shape is Shape.STATE:
            return Item(Kind.WHILE, index, index + 1, "with")
        if following.shape is Shape.PLACE and _told_of(said, following.last):
            return Item(Kind.BUT, index, index + 1, "with")
    return None


def _told_of(said: Sequence[Word], index: int) -> bool:
    """Whether a participle follows: "with site 2 avoided"."""
    return index < len(said) and said[index].text.endswith("ed") and len(said[index].stems) > 1


def _skips_articles(said: Sequence[Word], index: int) -> int:
    while index < len(said) and said[index].text in ("the", "a", "an"):
        index += 1
    return index


def _limited(said: Sequence[Word], index: int) -> Item | None:
    """Read the number of "the minimum number of visits is three" as "at least three"."""
    if index and said[index].text in ("number", "allowable", "allowed", *_SEPARATE):
        return Item(Kind.FILLER, index, index + 1, said[index].text)
    if said[index].text in _LIMITS:
        return Item(Kind.FILLER, index, index + 1, said[index].text)
    bound = _limit(said, index)
    if bound is None or not said[index].number.isdigit():
        return None
    count = Count(bound, int(said[index].number))
    return Item(Kind.COUNT, index, index + 1, said[index].text, count=count)


def _next(said: Sequence[Word], index: int, end: int) -> Item | None:
    word = said[index]
    if word.is_mark:
        kind = MARKS.get(word.text) or (Kind.AND if word.text in "&/+" else None)
        return Item(kind, index, index + 1, word.text) if kind else None
    following = said[index + 1].text if index + 1 < len(said) else "."
    if word.text == "otherwise" and following in ".;!":
        return Item(Kind.NO_OTHER, index, index + 1, word.text)  # "b is never done otherwise"
    count = _nth(said, index, end) or _count(said, index, end)
    phrase = _pointing(_phrase(said, index, end), said)
    if count and (phrase is None or count.last >= phrase.last):
        return count
    return phrase or Item(Kind.UNKNOWN, index, index + 1, word.text)


_ENDING = {Kind.WHENEVER: Kind.ALWAYS, Kind.WHILE: Kind.ALWAYS}
"""What a phrase does with nothing behind it: "... every time.", "... the whole time"."""
_POINTING = {
    Kind.PROMPTLY: Kind.RIGHT_AFTER_THAT,
    Kind.RIGHT_BEFORE: Kind.RIGHT_BEFORE_THAT,
    Kind.AFTER: Kind.AFTER_THAT,
    Kind.BEFORE: Kind.BEFORE_THAT,
}


def _pointing(phrase: Item | None, said: Sequence[Word]) -> Item | None:
    """Read "right after" with nothing behind it as "right after that"."""
    if phrase is None:
        return None
    following = said[phrase.last].text if phrase.last < len(said) else "."
    if following in MARKS and phrase.kind in _ENDING:
        return replace(phrase, kind=_ENDING[phrase.kind])
    if following in MARKS and phrase.kind is Kind.ONLY_AFTER and phrase.text.endswith("before"):
        return replace(phrase, kind=Kind.IN_ORDER)  # "b after a, never before"
    if following in ".;!" and phrase.kind is Kind.ONLY_THEN:
        return replace(phrase, kind=Kind.NO_OTHER)  # "b when a, and only then"
    if following == "to" and phrase.kind is Kind.NO_RETURN and phrase.text == "no returning":
        return Item(Kind.NOT, phrase.first, phrase.first + 1, "no")  # "no returning to a until b"
    if phrase.kind is Kind.NOT and phrase.text.endswith("forbidden to") and (
        following in ("the", "you", "it", "them", "us")
    ):  # fmt: skip
        return replace(phrase, kind=Kind.FORBIDDEN)
    if phrase.kind not in _POINTING:
        return phrase
    if following in MARKS or following in ("and", "or", "but", "then"):
        return replace(phrase, kind=_POINTING[phrase.kind])
    return phrase


def _phrase(said: Sequence[Word], index: int, end: int) -> Item | None:
    word = said[index]
    best: tuple[int, bool, Kind] | None = None
    after = index
    for stem in word.stems | {word.text}:
        for pattern, kind in PHRASES.get(stem, ()):
            length = len(pattern)
            if best and length < best[0]:
                break
            reach = _reach(pattern, kind, said, index, end)
            if reach is not None and not _goes_on(kind, said, index, reach - index):
                exact = not pattern[0].startswith("~")
                if best is None or (length, exact) > best[:2]:
                    best, after = (length, exact, kind), reach
                break
    if best is None:
        return None
    length, _, kind = best
    if length == 1 and index + 1 < len(said) and word.stems & {"stop", "cease", "quit"}:
        following = said[index + 1]
        if following.text.endswith("ing") and len(following.stems) > 1:
            kind = Kind.CEASE
    text = " ".join(each.text for each in said[index:after] if each.text != ",")
    return Item(kind, index, after, text, _form(said, index))


def _reach(
    pattern: Sequence[str], kind: Kind, said: Sequence[Word], index: int, end: int
) -> int | None:
    """The word after a phrase that begins here; "if, and only if," is one phrase."""
    position = index
    for each in pattern:
        if kind is Kind.IFF and position < end and said[position].text == ",":
            position += 1
        if position >= end or not _fits(each, said[position]):
            return None
        position += 1
    if kind is Kind.IFF and position < end and said[position].text == ",":
        position += 1
    return position


_THAT = frozenset(
    (Kind.BEFORE_THAT, Kind.AFTER_THAT, Kind.RIGHT_AFTER_THAT, Kind.RIGHT_BEFORE_THAT)
)
_AUXILIARIES = frozenset(("is", "has", "was", "does", "happens", "have", "are", "been"))


def _goes_on(kind: Kind, said: Sequence[Word], index: int, length: int) -> bool:
    """Whether a phrase that would stand by itself begins a clause: "you have been there"."""
    if index + length >= len(said):
        return False
    following = said[index + length]
    if kind in _THAT:
        return length > 1 and following.text in _AUXILIARIES
    if kind is not Kind.IT_HAPPENS or said[index].text not in ("you", "they"):
        return False
    return not following.is_mark and following.text not in ("and", "or", "but", "then")


def _fits(pattern: str, word: Word) -> bool:
    if pattern.startswith("~"):
        return pattern[1:] in word.stems
    return pattern == word.text


def _form(said: Sequence[Word], index: int) -> Form:
    word = said[index]
    if word.text.endswith("ing") and len(word.stems) > 1:
        return Form.GERUND
    return Form.BASE if word.stems == {word.number} else Form.FINITE


def _count(said: Sequence[Word], index: int, end: int) -> Item | None:
    """Read "at least three separate times", "twice or more", "no more than once"."""
    position, bound = index, ""
    for sign, phrase in _BEFORE_A_NUMBER:
        if index + len(phrase) > position and _says(said, index, end, phrase):
            position, bound = index + len(phrase), sign
    if not bound and _says(said, position + 1, end, ("or", "more", "than")):
        position, bound = position + 4, ">="  # "four or more than four times"
    times, after = _times(said, position, end)
    if times is None:
        return None
    lone = said[position].text == "once" and (not bound or said[index].text == "only")
    if bound in ("", "="):
        for sign, phrase in _BEHIND_A_NUMBER:
            tail = after + (after < end and said[after].text == "," and sign == "=")
            if _says(said, tail, end, phrase):
                after = tail + len(phrase)
                bound, lone = sign, False
                while after < end and said[after].text in (*_COUNTED, *_SEPARATE, "occasions"):
                    after += 1
                break
    answers = index > 0 and said[index - 1].text in ("is", "are")
    if lone and not answers and not _ends(said, after, end):
        return None
    text = " ".join(word.text for word in said[index:after])
    return Item(
        Kind.COUNT, index, after, text, count=Count(bound or _limit(said, index) or "", times)
    )


def _limit(said: Sequence[Word], index: int) -> str | None:
    """The bound that a word like "minimum" before sets."""
    return next((_LIMITS[word.text] for word in said[:index] if word.text in _LIMITS), None)


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
        said[after].text in _COUNTED
        or said[after].text in _SEPARATE
        or _says(said, after, end, ("or", "more", "times"))
        or _says(said, after, end, ("or", "fewer", "times"))
    ):
        if said[after].text in _COUNTED:
            counted = True
            after += 1
            break
        if said[after].text == "or":
            return int(word.number), after
        after += 1
    return (int(word.number), after) if counted else (None, position)


def _limited_behind(said: Sequence[Word], after: int, end: int) -> bool:
    """Whether "or more separate visits" follows a number."""
    if not (_says(said, after, end, ("or", "more")) or _says(said, after, end, ("or", "fewer"))):
        return False
    after += 2
    while after < end and said[after].text in _SEPARATE:
        after += 1
    return after < end and said[after].text in _COUNTED


def _nth(said: Sequence[Word], index: int, end: int) -> Item | None:
    """Read "a third visit" as three or more, which is said to be forbidden."""
    if said[index].text not in ("a", "any", "no") or index + 2 >= end:
        return None
    number, noun = ORDINALS.get(said[index + 1].text), said[index + 2].text
    if number is None or number == "1" or noun not in _COUNTED or (number, noun) == ("2", "time"):
        return None
    text = " ".join(word.text for word in said[index : index + 3])
    return Item(Kind.COUNT, index, index + 3, text, count=Count(">=", int(number)))


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
