"""An utterance as items: its references, and the general words that shape a mission."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from plainspoken.language.counting import Count, count_at, limit_at, nth_at, tells_of_limit
from plainspoken.language.expression import Shape
from plainspoken.language.lexicon import MARKS, PHRASES, Kind
from plainspoken.language.reference import Form, Reference
from plainspoken.language.word import Word


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
    ahead = deque((*sorted(starts), len(said)))
    made: list[Item] = []
    index = 0
    while index < len(said):
        while ahead[0] <= index:
            ahead.popleft()
        if index in starts:
            reference = starts[index]
            text = " ".join(word.text for word in said[index : reference.last])
            made += _within(said, reference)
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
        item = _between(said, index, starts, made) or _next(said, index, ahead[0])
        if item is not None and item.kind is Kind.UNKNOWN:
            item = _limited(said, index) or item
        if item is not None:
            made.append(item)
        index = item.last if item is not None else index + 1
    return tuple(_without_idioms(made))


_INSIDE = {
    "only": Kind.ONLY,
    "immediately": Kind.NEXT,
    "promptly": Kind.NEXT,
}


def _within(said: Sequence[Word], reference: Reference) -> Iterator[Item]:
    """What is said within a reference of when and how: "the nurse must immediately be called"."""
    for index in range(reference.first + 1, reference.last - 1):
        kind = _INSIDE.get(said[index].text)
        if kind is not None:
            yield Item(kind, index, index + 1, said[index].text)


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
    if said[index].text == "for" and following is not None and _waits(made) and (
        following.shape is Shape.STATE
    ):  # fmt: skip
        return Item(Kind.UNTIL, index, index + 1, "for")
    if said[index].text == "with" and following is not None:
        if following.shape is Shape.STATE:
            return Item(Kind.WHILE, index, index + 1, "with")
        if following.shape is Shape.PLACE and _told_of(said, following.last):
            return Item(Kind.BUT, index, index + 1, "with")
    return None


def _waits(made: Sequence[Item]) -> bool:
    """Whether the clause that is being read is "wait there", with a place."""
    for each in reversed(made):
        if each.text.split()[0] in ("wait", "waiting", "stay", "remain", "hang", "stand"):
            return any(item.form is Form.NOUN for item in made)
        if each.kind in (Kind.STOP, Kind.COMMA, Kind.AND, Kind.THEN, Kind.BUT):
            return False
    return False


def _told_of(said: Sequence[Word], index: int) -> bool:
    """Whether a participle follows: "with site 2 avoided", "with site 2 off limits"."""
    barred = ("strictly", "forbidden", "off", "out", "barred", "closed", "prohibited", "only")
    if index < len(said) and said[index].text in barred:
        return True
    return index < len(said) and said[index].text.endswith("ed") and len(said[index].stems) > 1


def _skips_articles(said: Sequence[Word], index: int) -> int:
    while index < len(said) and said[index].text in ("the", "a", "an"):
        index += 1
    return index


def _limited(said: Sequence[Word], index: int) -> Item | None:
    """Read the number of "the minimum number of visits is three" as "at least three"."""
    if tells_of_limit(said, index):
        return Item(Kind.FILLER, index, index + 1, said[index].text)
    count = limit_at(said, index)
    return Item(Kind.COUNT, index, index + 1, said[index].text, count=count) if count else None


def _next(said: Sequence[Word], index: int, end: int) -> Item | None:
    word = said[index]
    if word.text == "." and index + 1 < len(said) and said[index + 1].text in ",;:":
        return None  # of an abbreviation
    if word.is_mark:
        kind = MARKS.get(word.text) or (Kind.AND if word.text in "&/+" else None)
        return Item(kind, index, index + 1, word.text) if kind else None
    following = said[index + 1].text if index + 1 < len(said) else "."
    if word.text == "otherwise" and following in ".;!":
        return Item(Kind.NO_OTHER, index, index + 1, word.text)  # "b is never done otherwise"
    found = nth_at(said, index, end) or count_at(said, index, end)
    count = None
    if found is not None:
        text = " ".join(each.text for each in said[index : found[1]])
        count = Item(Kind.COUNT, index, found[1], text, count=found[0])
    phrase = _pointing(_phrase(said, index, end), said)
    if count and (phrase is None or count.last >= phrase.last):
        return count
    return phrase or Item(Kind.UNKNOWN, index, index + 1, word.text)


_ONLY_THEN = frozenset(("after", "once", "until", "when", "if"))
_STOPS = frozenset(("one", "place", "stop", "visit", "is", "comes", "station", "should", "must"))
_SINCE = frozenset(("since", "ever since"))
_ENDING = {Kind.WHENEVER: Kind.ALWAYS, Kind.WHILE: Kind.ALWAYS}
"""What a phrase does with nothing behind it: "... every time.", "... the whole time"."""
_ANY_PLACE = frozenset(
    ("previous", "earlier", "any", "visited", "location", "locations", "place", "places", "one")
)
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
    if phrase.kind in (Kind.LATER, Kind.AFTER_THAT, Kind.LATER_ON) and (
        phrase.text.endswith(" after") and following not in (*MARKS, "and", "or", "but", "then")
    ):
        return replace(phrase, kind=Kind.AFTER)  # "at least once after visiting a"
    if phrase.kind is Kind.AFTER_THAT and phrase.text.endswith(("done", "finished")) and (
        following.endswith("ing") or following in ("with", "at", "in")
    ):  # fmt: skip
        return replace(phrase, kind=Kind.AFTER)  # "when you are done visiting a"
    asked = phrase.kind is Kind.FILLER and phrase.text in ("can you", "could you")
    if asked and any(word.text in _ONLY_THEN for word in said[: phrase.first]):
        return replace(phrase, kind=Kind.MAY)  # "only after a can you go to b"
    if phrase.kind is Kind.PROMPTLY and phrase.text.startswith("the ") and following in _STOPS:
        return replace(phrase, kind=Kind.NTH)  # "the second place is b"
    if phrase.text == "without stopping" and following in ("at", "in", "by", "anywhere"):
        return Item(Kind.WITHOUT, phrase.first, phrase.first + 1, "without")
    if phrase.text in _SINCE and following in (*MARKS, "then"):
        return Item(Kind.FILLER, phrase.first, phrase.last, phrase.text)  # "without b since"
    if following in MARKS and phrase.kind in _ENDING:
        return replace(phrase, kind=_ENDING[phrase.kind])
    if following in MARKS and phrase.kind is Kind.ONLY_AFTER and phrase.text.endswith("before"):
        return replace(phrase, kind=Kind.IN_ORDER)  # "b after a, never before"
    if following in ".;!" and phrase.kind is Kind.ONLY_THEN:
        return replace(phrase, kind=Kind.NO_OTHER)  # "b when a, and only then"
    if following == "to" and phrase.kind is Kind.NO_RETURN and _ANY_PLACE.isdisjoint(
        word.text for word in said[phrase.last : phrase.last + 4]
    ):  # fmt: skip
        # "no returning to a until b", "never return to a once you have been to b"
        first = phrase.text.split()[0]
        if first in ("no", "never", "not"):
            return Item(Kind.NOT, phrase.first, phrase.first + 1, first)
    if phrase.kind is Kind.NOT and phrase.text.endswith("forbidden to") and (
        following in ("the", "you", "it", "them", "us")
    ):  # fmt: skip
        return replace(phrase, kind=Kind.FORBIDDEN)
    if phrase.kind is Kind.FORBIDDEN and following == "to" and phrase.text.split()[-1] in (
        "allowed", "permitted", "forbidden", "prohibited"
    ):  # fmt: skip
        return replace(phrase, kind=Kind.NOT)  # "you are not allowed to do it"
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
_ARRIVING = frozenset(("arrive", "arriving", "go", "going", "get", "getting"))
_TOWARDS = frozenset(("at", "to", "in", "into", "on", "onto", "back"))
_AUXILIARIES = frozenset(("is", "has", "was", "does", "happens", "have", "are", "been"))


def _goes_on(kind: Kind, said: Sequence[Word], index: int, length: int) -> bool:
    """Whether a phrase that would stand by itself begins a clause: "you have been there"."""
    if index + length >= len(said):
        return False
    following = said[index + length]
    if kind in _THAT:
        head = said[index + length - 1].text
        if head in ("it", "them") and not following.is_mark:
            return following.text not in ("and", "or", "but", "then")
        heads = head in _ARRIVING and following.text in _TOWARDS
        return length > 1 and (following.text in _AUXILIARIES or heads)
    if kind is not Kind.IT_HAPPENS:
        return False
    if said[index].text in ("it", "that", "this"):
        return following.text in ("have", "need", "to", "been")  # "it does have to be visited"
    if said[index].text not in ("you", "they"):
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
