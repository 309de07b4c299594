"""Words that speak of all, any or none of a kind, spread over the things of that kind.

"Every jar", "none of the jars", "at least one jar", "everything but the jar": what is said of them
is said of each thing by its own name.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from plainspoken.language.expression import Shape
from plainspoken.language.frame import ARTICLES, Thing
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.lexicon import is_general
from plainspoken.language.reference import Form, references
from plainspoken.language.repetition import of_each
from plainspoken.language.word import Word, stems

_EACH = frozenset(("every", "each", "all", "any", "both", "none", "no", "either", "neither"))
_SOME = frozenset(("one", "a", "an", "some"))
_WHOLE = frozenset(("everything", "anything", "nothing", "everyone", "anyone"))
_THINGS = frozenset(("thing", "things", "item", "items", "object", "objects", "them", "those"))
_EXCEPT_WORDS = """
    except; but; save; except for; but for; save for; apart from; aside from; other than;
    excluding; excepting; besides; bar; barring; with the exception of; not counting
"""
_EXCEPT = tuple(tuple(each.split()) for each in _EXCEPT_WORDS.split(";"))
_OPENING_WORDS = """
    except for; apart from; aside from; with the exception of; save for; but for
"""
_OPENING = tuple(tuple(each.split()) for each in _OPENING_WORDS.split(";"))
_DENIALS = frozenset(("never", "not", "no", "avoid", "without", "none", "neither", "nor"))
_BOUNDS_WORDS = """
    if when whenever while once until till unless before after that which where . ; ! ?
    :
"""
_BOUNDS = frozenset(_BOUNDS_WORDS.split())
_ABSTRACT_WORDS = """
    circumstances cases conditions times ways means moments steps instants occasions situations
    events others accounts costs points orders visits
"""
_ABSTRACT = frozenset(_ABSTRACT_WORDS.split())
"""Nouns that name no things: "in no circumstances", "at all times"."""
_FAR = 10
"""Words to either side in which what is said of "all of them" is looked for."""
_SMALL = ARTICLES | frozenset(("of", "these", "those", "my", "our", "your", "its", "their"))


def quantified(said: tuple[Word, ...], vocabulary: Vocabulary) -> tuple[Word, ...]:
    """Say of each thing what is said of all, any or none of its kind."""
    said = _brought_back(said, vocabulary)
    index = 0
    while index < len(said):
        found = _quantifier(said, index, vocabulary)
        wider = _over(said, found, vocabulary) if found is not None else None
        if wider is not None:
            said, index = wider
            continue
        span = _range(said, index, vocabulary)
        if span is not None:
            listed = _as_list(said[index], span, "and")
            said = (*said[:index], *listed, *said[index + 4 :])
            index += len(listed)
            continue
        index += 1
    return said


@dataclass(frozen=True, slots=True)
class _Quantifier:
    """Words such as "none of the": where they begin, the noun behind them, how to join.

    only: where something has to be said of each, and a list of names is not enough
    """

    first: int
    noun: int
    joint: str
    denied: bool = False
    only: bool = False


def _quantifier(said: Sequence[Word], index: int, vocabulary: Vocabulary) -> _Quantifier | None:
    text = said[index].text
    if text in _WHOLE:
        if _is_general_act(said, index, vocabulary):
            return None
        return _Quantifier(index, index, _either(said, index), text == "nothing")
    if index + 1 >= len(said):
        return None
    if text in _SOME:
        return _some(said, index, vocabulary)
    noun = _noun_of(said, index)
    if text not in _EACH and not _are_all(said, index, vocabulary):
        return None
    form = _said_as(said, index, vocabulary)
    if form not in (None, Form.FINITE) and not _stands_except(said, noun + 1):
        return None
    denied = text in ("no", "none", "neither")
    if form is Form.FINITE and _is_whichever(said, index, vocabulary):
        return None
    if form is Form.FINITE and (denied or text == "any") and not _stands_except(said, noun + 1):
        return None  # "no jar may be opened" forbids the act itself, done to whichever
    return _Quantifier(index, noun, _either(said, index), denied, only=form is not None)


def _is_whichever(said: Sequence[Word], index: int, vocabulary: Vocabulary) -> bool:
    """Whether "each jar that you open" is the act itself, done to whichever."""
    return any(
        each.first <= index + 1 < each.last
        and any(word.text in ("you", "we", "i") for word in said[each.first : each.last])
        for each in references(said, vocabulary)
    )


def _some(said: Sequence[Word], index: int, vocabulary: Vocabulary) -> _Quantifier | None:
    """Read "at least one site", "one of the sites", and "a site" in "if a site is clear"."""
    least = [word.text for word in said[max(index - 2, 0) : index]] == ["at", "least"]
    noun = _noun_of(said, index)
    first = index - 2 if least else index
    before = said[first - 1].text if first else ""
    if before in ("not", "only", "exactly", "just") or said[noun].text in _THINGS:
        return None
    if _said_as(said, noun - 1, vocabulary) is Form.FINITE:
        return None  # "at least one jar has to be opened" asks for the act itself
    several = noun > index + 1 and said[index + 1].text == "of" and said[noun].text.endswith("s")
    if several or least:
        return _Quantifier(first, noun, _either(said, index))
    unclear = next(
        (
            each for each in references(said, vocabulary)
            if each.first == index + 1 and each.rivals and each.form is Form.FINITE
        ),
        None,
    )  # fmt: skip
    if unclear is None or unclear.shape is not Shape.STATE:
        return None
    return _Quantifier(index, noun, _either(said, index), only=True)


def _are_all(said: Sequence[Word], index: int, vocabulary: Vocabulary) -> bool:
    """Whether "the sites" is all of them: a noun of several, in the plural, and no list of them."""
    if said[index].text not in ("the", "these", "those") or index + 1 >= len(said):
        return False
    noun, before = said[index + 1], said[index - 1].text if index else ""
    behind = said[index + 2].text if index + 2 < len(said) else "."
    return (
        noun.text.endswith("s")
        and noun.stems != {noun.text}
        and not behind.isdigit()
        and before not in _EACH | {"of", "one"}
        and len(vocabulary.members(noun)) > 1
    )


def _is_general_act(said: Sequence[Word], index: int, vocabulary: Vocabulary) -> bool:
    """Whether "sweep anything" is the act itself, done to whatever."""
    return said[index].text in ("anything", "anyone") and any(
        each.last in (index, index + 1) and each.shape is Shape.ACT and each.parts == 1
        for each in references(said, vocabulary)
    )


def _noun_of(said: Sequence[Word], index: int) -> int:
    """The noun behind "each", "none of the three", "any of"."""
    start = index + 1
    while start < len(said) - 1 and (
        said[start].text in _SMALL or said[start].text in _EACH or _is_number_of(said, start)
    ):
        start += 1
    return start


def _is_number_of(said: Sequence[Word], index: int) -> bool:
    """Whether a number counts what follows: the "three" of "all three sites"."""
    return said[index].number.isdigit() and said[index + 1].text.endswith("s")


def _over(
    said: tuple[Word, ...], found: _Quantifier, vocabulary: Vocabulary
) -> tuple[tuple[Word, ...], int] | None:
    """The things in place of "every site"."""
    members = members_of(said, found.first, found.noun, vocabulary)
    if len(members) < 2:
        return None
    after, left_out = _exceptions(said, found.noun, members)
    chosen = [each for each in members if each not in left_out]
    noun, first, joint = said[found.noun], found.first, found.joint
    few = first > 0 and said[first - 1].text == "not" and said[first].text in ("all", "every")
    denial = (replace(noun, text="not"),) if few else ()
    own = [(*(Word(text, noun.start, noun.end) for text in member), *denial) for member in chosen]
    if few:
        # "If not all are sealed": the one is not, or the other is not.
        said, first, after, joint = (*said[: first - 1], *said[first:]), first - 1, after - 1, "or"
    if found.denied:
        # The denial stays in front of what it denies.
        said = (*said[:first], replace(said[first], text="no"), *said[first + 1 :])
        first, joint = first + 1, "or"
    longer = of_each(said, (first, after), own, joint, vocabulary)
    if longer is not None:
        return longer.said, longer.after
    if found.only or not all(
        each in vocabulary.frames.places or each[-1].isdigit() for each in chosen
    ):
        return None
    listed = _as_list(noun, chosen, joint)
    return (*said[:first], *listed, *said[after:]), first + len(listed)


def members_of(
    said: Sequence[Word], index: int, start: int, vocabulary: Vocabulary
) -> tuple[Thing, ...]:
    """The things that a noun is a name for: those called so, or those of what is said of it."""
    if start >= len(said) or vocabulary.frames.mentioned(said, start) is not None:
        return ()
    if said[start].text in _ABSTRACT:
        return ()
    noun = said[start]
    named = vocabulary.members(noun)
    if len(named) > 1:
        return named
    frames = vocabulary.frames
    general = noun.text in _WHOLE | _THINGS or bool(noun.stems & frames.classes)
    if not general and (not noun.text.endswith("s") or is_general(noun)):
        return ()
    around = _clause_around(said, index, start)
    wanted = frozenset(stem for place in around for stem in said[place].stems)
    best = max(frames.said_of(wanted), key=lambda each: (each[0], len(each[1])), default=None)
    return best[1] if best is not None else ()


def _clause_around(said: Sequence[Word], index: int, start: int) -> Iterator[int]:
    for place in range(index - 1, max(index - _FAR, -1), -1):
        if said[place].text in _BOUNDS:
            break
        yield place
    for place in range(start + 1, min(start + _FAR, len(said))):
        if said[place].text in _BOUNDS - {"that", "which"}:
            break
        yield place


def _either(said: Sequence[Word], index: int) -> str:
    """The word that joins the members: "any" is any one of them, unless it is denied."""
    if said[index].text not in _SOME | {"any", "either", "anything", "anyone"}:
        return "and"
    begin = max((i + 1 for i in range(index) if said[i].text in _BOUNDS), default=0)
    before = {word.text for word in said[begin:index]}
    return "and" if before & _DENIALS else "or"


def _said_as(said: Sequence[Word], index: int, vocabulary: Vocabulary) -> Form | None:
    """How the words as they are name something: "any tool" of "use any tool".

    What is said of every tool ("every tool has to be cleaned", FINITE) may be so of each.
    """
    for each in references(said, vocabulary):
        if each.first <= index + 1 < each.last and each.score == 1.0 and not each.rivals:
            return each.form if each.shape is Shape.ACT else Form.BASE
    return None


def _exceptions(
    said: Sequence[Word], start: int, members: Sequence[Thing]
) -> tuple[int, frozenset[Thing]]:
    """Where "every site except site 2" ends, and which ones it leaves out."""
    after = start + 1
    place = after + (after < len(said) and said[after].text == ",")
    link = _stands_except(said, place)
    if not link:
        return after, frozenset()
    paused = place > after
    place, left_out = _left_out(said, place + link, members)
    place += paused and place < len(said) and said[place].text == ","
    return (place, left_out) if left_out else (after, frozenset())


def _stands_except(said: Sequence[Word], place: int) -> int:
    """How many words say that an exception follows."""
    return max((len(each) for each in _EXCEPT if _stands(said, place, each)), default=0)


def _stands(said: Sequence[Word], place: int, phrase: Sequence[str]) -> bool:
    return [word.text for word in said[place : place + len(phrase)]] == list(phrase)


def _left_out(
    said: Sequence[Word], place: int, members: Sequence[Thing]
) -> tuple[int, frozenset[Thing]]:
    """The members that are listed from a word on, and where their list ends."""
    left_out: set[Thing] = set()
    end = place
    while place < len(said):
        found = next((each for each in members if _is_named(said, place, each)), None)
        number = said[place].number
        if found is None and left_out and number.isdigit():
            found = next((each for each in members if each[-1] == number), None)
            place -= len(found) - 1 if found is not None else 0
        if found is not None:
            left_out.add(found)
            place = end = place + len(found)
        elif said[place].text in ("for", "and", "or", "the", ",", "&"):
            place += 1
        else:
            break
    return end, frozenset(left_out)


def _is_named(said: Sequence[Word], place: int, member: Thing) -> bool:
    return all(
        place + i < len(said) and said[place + i].stems & stems(word)
        for i, word in enumerate(member)
    )


def _brought_back(said: tuple[Word, ...], vocabulary: Vocabulary) -> tuple[Word, ...]:
    """Put "apart from site 2, every site ..." behind the noun that it takes something out of."""
    for index in range(len(said)):
        opening = next((each for each in _OPENING if _stands(said, index, each)), None)
        if opening is None or (index and not said[index - 1].is_mark):
            continue
        close = next((i for i in range(index, len(said)) if said[i].text == ","), len(said))
        for place in range(close + 1, min(close + _FAR, len(said))):
            if said[place].text in _EACH | _WHOLE:
                whole = said[place].text in _WHOLE
                noun = place if whole else _noun_of(said, place)
                members = members_of(said, place, noun, vocabulary)
                end, left_out = _left_out(said, index + len(opening), members)
                if left_out and end >= close - 1:
                    moved = said[index:end]
                    return (
                        *said[:index], *said[close + 1 : noun + 1], *moved, *said[noun + 1 :]
                    )  # fmt: skip
    return said


def _range(said: Sequence[Word], index: int, vocabulary: Vocabulary) -> list[Thing] | None:
    """The things of "sites 1 to 3"."""
    if index + 3 >= len(said) or said[index + 2].text not in ("to", "through", "\u2013", "-"):
        return None
    first, last = said[index + 1].number, said[index + 3].number
    if not (first.isdigit() and last.isdigit() and said[index].text.endswith("s")):
        return None
    members = [each for each in vocabulary.members(said[index]) if each[-1].isdigit()]
    span = [each for each in members if int(first) <= int(each[-1]) <= int(last)]
    return span if {first, last} <= {each[-1] for each in span} else None


def _as_list(noun: Word, members: Sequence[Thing], joint: str) -> tuple[Word, ...]:
    found: list[Word] = []
    for place, member in enumerate(members):
        if place:
            found.append(Word(joint, noun.start, noun.end))
        found += [Word(text, noun.start, noun.end) for text in member]
    return tuple(found)
