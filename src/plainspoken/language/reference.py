"""Referring expressions: where an utterance speaks of a symbol, and how."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace
from enum import StrEnum, auto

from plainspoken.language.errand import Errand
from plainspoken.language.expression import COPULAS, Expression, Shape
from plainspoken.language.frame import ARTICLES
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.lexicon import is_general
from plainspoken.language.verbal import is_idle, is_motion, is_noun
from plainspoken.language.voice import (
    DOERS,
    LASTING,
    NEGATIONS,
    OBLIGING,
    WITHIN,
    is_eventful,
    is_participle,
    is_relative,
)
from plainspoken.language.word import Word
from plainspoken.world.symbol import SymbolId

LEAST_SHARE = 0.5
"""An expression of which less than this is said is not meant."""
LEAST_SCORE = 0.6
"""Below this, what is said is too little of an expression to stand for it."""
BARE_VERB = 0.75
"""What the verb of an act is worth by itself: "sweep" for "to sweep the yard"."""
CLOSE = 0.12
"""Two readings nearer to each other than this are both put to the person."""

_ATTRIBUTIVE = ARTICLES | frozenset(
    ("of", "its", "their", "your", "any", "some", "up", "out", "off", "on", "in", "down", "hold")
)
"""What may stand between a state and its subject where the state comes first."""
_MORE = frozenset(("more", "further", "another", "additional"))
_STAYING = frozenset(("keep", "stay", "steer", "remain"))
_ANYTHING = frozenset(("anything", "something", "anyone", "someone", "one"))
_NUMBERING = frozenset(("number", "no", "nr", "#"))


class Form(StrEnum):
    """How a symbol is spoken of."""

    NOUN = auto()  # "site 1"
    BASE = auto()  # "use a tool", "clear site 2"
    GERUND = auto()  # "using a tool"
    FINITE = auto()  # "the tank is full", "a tool has been used"


@dataclass(frozen=True, slots=True)
class Reference:
    """A place in an utterance that speaks of a symbol.

    first, last: its first word and the one after its last
    score:       1 for the landmark's own words
    negated:     "the tank is not full", "the tank is empty"
    lasting:     a "stay" within: "the tank must stay full"
    eventful:    told as what is done: "the tank must not be opened", "the tank gets opened"
    obliged:     a "must" within: "site 2 must be cleared"
    rivals:      other symbols that it may mean just as well
    errand:      what is done at several stops, of which the symbol is the last
    """

    symbol: SymbolId
    first: int
    last: int
    score: float
    form: Form
    shape: Shape
    negated: bool = False
    never: bool = False
    obliged: bool = False
    lasting: bool = False
    eventful: bool = False
    parts: int = 1
    rivals: tuple[SymbolId, ...] = ()
    errand: Errand | None = None


def references(said: Sequence[Word], vocabulary: Vocabulary) -> tuple[Reference, ...]:
    """The referring expressions of an utterance, left to right, none overlapping another."""
    errands = [_of_errand(index, word.errand) for index, word in enumerate(said) if word.errand]
    taken = frozenset(each.first for each in errands)
    whole = [*errands, *_chosen(_candidates(said, vocabulary, 1.0, taken), said)]
    covered = {index for each in whole for index in range(each.first, each.last)}
    whole = _with_acts_on_places(whole, said, vocabulary, covered)
    covered = {index for each in whole for index in range(each.first, each.last)}
    general = {i for i, word in enumerate(said) if i not in covered and is_general(word)}
    rest = [
        each
        for each in (
            *_candidates(said, vocabulary, LEAST_SHARE, covered),
            *(
                each
                for each in _candidates(said, vocabulary, LEAST_SHARE, covered, general)
                if each.shape is Shape.ACT and _takes_object(each, said)
            ),
        )
        if each.score >= LEAST_SCORE or each.shape is not Shape.STATE
    ]
    ordered = sorted((*whole, *_chosen(rest, said)), key=lambda each: each.first)
    return tuple(_in_list(each, said) for each in ordered)


def _with_acts_on_places(
    whole: list[Reference], said: Sequence[Word], vocabulary: Vocabulary, covered: AbstractSet[int]
) -> list[Reference]:
    """Let "open gate 1" for "to open the door of gate 1" go before the bare place in it."""
    places = {each.first: each for each in whole if each.shape is Shape.PLACE}
    free = covered - {i for each in places.values() for i in range(each.first, each.last)}
    starts = {
        index
        for index in range(len(said))
        if index not in covered and any(index < first <= index + 3 for first in places)
    }
    found = [
        each
        for each in _candidates(said, vocabulary, LEAST_SHARE, free, starts)
        if each.shape is Shape.ACT
        and each.score >= LEAST_SCORE
        and any(
            each.first < first and each.last >= place.last and each.parts > place.parts
            for first, place in places.items()
        )
    ]
    acts = _chosen(found, said)
    inside = {index for each in acts for index in range(each.first, each.last)}
    return [*(each for each in whole if each.first not in inside), *acts]


def _takes_object(each: Reference, said: Sequence[Word]) -> bool:
    """Whether a general verb is an act by what it is done to: "start the pump"."""
    behind = each.first + 1
    return (
        each.parts > 1
        and each.score >= LEAST_SCORE
        and (said[behind].text in ARTICLES or each.last - each.first == each.parts)
    )


def _of_errand(index: int, errand: Errand) -> Reference:
    symbol = errand.stops[-1][-1]
    return Reference(symbol, index, index + 1, 1.0, Form(errand.form), Shape.ACT, errand=errand)


def _in_list(each: Reference, said: Sequence[Word]) -> Reference:
    """Take what is said of one more thing for a further member of a list, not a clause."""
    if not said[each.first].joined or each.shape is Shape.PLACE:
        return each
    return replace(each, form=Form.NOUN, never=False, obliged=False)


def _candidates(
    said: Sequence[Word],
    vocabulary: Vocabulary,
    share: float,
    covered: AbstractSet[int] = frozenset(),
    starts: AbstractSet[int] | None = None,
) -> Iterator[Reference]:
    known = vocabulary.by_stem
    if share == 1.0:
        known = vocabulary.within(frozenset(stem for word in said for stem in word.stems))
    for start in range(len(said)) if starts is None else sorted(starts):
        if start in covered or (share < 1 and starts is None and is_general(said[start])):
            continue
        tried: set[int] = set()
        for stem in said[start].stems:
            for expression in known.get(stem, ()):
                if id(expression) not in tried:
                    tried.add(id(expression))
                    found = _matched(expression, start, said, share=share, covered=covered)
                    if found is not None:
                        yield found


def _matched(
    expression: Expression,
    start: int,
    said: Sequence[Word],
    *,
    share: float,
    covered: AbstractSet[int],
) -> Reference | None:
    """Read an expression from a word on; None where less than `share` of its parts is there."""
    place = expression.shape is Shape.PLACE
    at: dict[int, int] = {}
    quality = 0.0
    for index in range(start, min(len(said), start + 3 * len(expression.parts) + 8)):
        word = said[index]
        if index in covered:
            break
        part, fit = _best_part(
            expression, at, word.stems, in_order=place and (share == 1 or bool(at))
        )
        if part is not None:
            at[part] = index
            quality += fit
            if len(at) == len(expression.parts):
                break
        elif 0 not in at and expression.shape is Shape.ACT and word.text in DOERS:
            continue
        elif not _passes(word, expression.shape) or _is_kept_from(said, index, expression.shape):
            break
    if not at or min(at.values()) != start:
        return None
    verbal = expression.shape is Shape.ACT and set(at) == {0}
    bare = share < 1 and verbal and quality > 0.9
    if share < 1 and verbal and not bare:
        return None
    heads = share < 1 and expression.head and set(at) == {expression.head_part}
    if len(at) < share * len(expression.parts) and not (bare or heads):
        return None
    single = expression.shape is Shape.ACT and len(expression.parts) == 1
    if not _is_well_formed(expression, at, said) or ((bare or single) and is_idle(said, start)):
        return None
    if single and quality < 0.9 and is_general(said[start]) and not any(
        is_general(Word(stem, 0, 0)) for stem in expression.parts[0].stems
    ):  # fmt: skip
        return None  # "get to the gate" is no fetching, though "drive" is "move"
    return _reference(expression, at, said, quality)


def _best_part(
    expression: Expression, at: dict[int, int], found: frozenset[str], *, in_order: bool
) -> tuple[int | None, float]:
    """The part that a word fits best; in order, only the one after the last that was found."""
    if in_order:
        part = max(at) + 1 if at else 0
        if part >= len(expression.parts):
            return None, 0.0
        quality = expression.parts[part].quality(found)
        return (part, quality) if quality else (None, 0.0)
    best, fit = None, 0.0
    for part, each in enumerate(expression.parts):
        quality = each.quality(found) if part not in at else 0.0
        if quality > fit:
            best, fit = part, quality
    return best, fit


def _passes(word: Word, shape: Shape) -> bool:
    """Whether a word may stand between the parts of an expression."""
    if shape is Shape.PLACE:
        return (
            word.text in ARTICLES or word.text in _NUMBERING or (word.is_mark and word.text != ";")
        )
    if shape is Shape.STATE and word.text in LASTING:
        return True
    if shape is Shape.ACT and word.text in _MORE:
        return True
    return word.text in WITHIN


def _is_kept_from(said: Sequence[Word], index: int, shape: Shape) -> bool:
    """Whether a state is denied by "from": "keep the one from being the other"."""
    behind = said[index + 1].text if index + 1 < len(said) else ""
    return shape is Shape.STATE and said[index].text == "from" and behind.endswith("ing")


def _is_well_formed(
    expression: Expression,
    at: dict[int, int],
    said: Sequence[Word],
) -> bool:
    parts = len(expression.parts)
    if any(part and part - 1 not in at and expression.parts[part].is_number for part in at):
        return False  # "sweep one" is not "sweep yard 1"
    if any(part and expression.parts[part].is_number and at[part] < at[part - 1] for part in at):
        return False  # "one yard" is not "yard 1"
    if expression.shape is Shape.PLACE:
        return 0 in at or not all(said[index].number.isdigit() for index in at.values())
    if expression.shape is Shape.ACT:
        if 0 not in at:
            return False
        behind = [part for part in at if part and at[part] < at[0]]
        if not behind or is_participle(said[at[0]]) or is_relative(said, at[0]):
            return True
        # "every meal delivery"
        compound = at[0] == max(at.values()) and at[0] - min(at.values()) == len(at) - 1
        return compound and not expression.parts[0].stems & said[at[0]].stems
    if not expression.subject:
        first, last = min(at.values()), max(at.values())
        between = {said[index].text for index in range(first, last)}
        denied = between & (NEGATIONS - {"neither", "no"})
        ordered = not expression.agentless or (at.get(0) == first and not denied)
        return len(at) == parts and ordered
    if any(
        said[index].text == "out" and said[index + 1].text == "of"
        for index in range(min(at.values()), max(at.values()))
    ):
        return False  # out of it is not in it
    subject = [at[part] for part in range(expression.subject) if part in at]
    predicate = [at[part] for part in range(expression.subject, parts) if part in at]
    if not subject or not predicate:
        return False
    owned = any(said[index].text == "'s" for index in range(min(subject), max(subject)))
    if subject != sorted(subject) and not owned:
        return False
    if max(subject) < min(predicate):
        return True
    # The predicate first: "clear site 2", "a full tank", "is site 2 cleared".
    between = {said[index].text for index in range(max(predicate) + 1, min(subject))}
    staying = min(predicate) and said[min(predicate) - 1].stems & _STAYING and "of" in between
    return max(predicate) < min(subject) and between <= _ATTRIBUTIVE and not staying


def _reference(
    expression: Expression, at: dict[int, int], said: Sequence[Word], quality: float
) -> Reference:
    first, last = min(at.values()), max(at.values()) + 1
    named = expression.shape is Shape.PLACE  # "the office one time"
    if not named and set(at) == {0} and last < len(said) and said[last].text in _ANYTHING:
        last += 1
    between = [said[i].text for i in range(first, last) if i not in at.values()]
    never = "never" in between
    score = expression.weight * quality / len(expression.parts)
    if expression.shape is Shape.ACT and set(at) == {0} and len(expression.parts) > 1:
        score = expression.weight * quality * BARE_VERB * (0.8 if expression.instance else 1.0)
    heads = expression.head and set(at) == {expression.head_part} and len(expression.parts) > 1
    if heads and first and said[first - 1].text == "the":
        score = BARE_VERB  # "the store" where there is no other
    turned = expression.shape is Shape.STATE and first == min(
        (at[part] for part in range(expression.subject, len(expression.parts)) if part in at),
        default=-1,
    )
    if turned and first and not _is_told(said, first):
        score *= 0.97  # "(the tank is) full, the tank ..." is not "a full tank"
    negations = sum(1 for text in between if text in NEGATIONS and text != "never")
    return Reference(
        symbol=expression.symbol,
        first=first,
        last=last,
        score=round(score, 3),
        form=_form(expression, at, said),
        shape=expression.shape,
        negated=expression.negated != (negations % 2 == 1),
        never=never,
        obliged=any(text in OBLIGING for text in between),
        lasting=any(text in LASTING for text in between),
        eventful=is_eventful(expression, at, said),
        parts=len(at),
    )


def _is_told(said: Sequence[Word], index: int) -> bool:
    """Whether a word stands where an adjective or a verb may: after "a", "not", "to", a mark."""
    before = said[index - 1]
    return before.is_mark or before.stems.isdisjoint(COPULAS)


def _form(expression: Expression, at: dict[int, int], said: Sequence[Word]) -> Form:
    if expression.shape is Shape.PLACE:
        return Form.NOUN
    subject = [at[part] for part in range(expression.subject) if part in at]
    told = min(subject) <= min(at.values()) if subject else not expression.agentless
    if expression.shape is Shape.STATE and told:
        return Form.FINITE
    place = at[0] if expression.shape is Shape.ACT else min(at.values())
    verb = said[place]
    if (verb.text.endswith("ing") and len(verb.stems) > 1) or is_noun(said, place):
        return Form.GERUND
    if expression.shape is Shape.ACT and at[0] != min(at.values()):
        return Form.FINITE
    if expression.shape is Shape.ACT:
        return Form.FINITE if verb.stems != {verb.text} else Form.BASE
    # "clear site 2" asks for what "site 2 is cleared" says; "a full tank" only says it.
    part = next(p for p, index in at.items() if index == min(at.values()))
    inflected = expression.parts[part].stems != {verb.text} or (
        said[place + 1].text in ARTICLES  # "open the jar", not "the open jar"
        or len(said[place + 1].text) > said[place + 1].end - said[place + 1].start  # "open it"
    )
    return Form.BASE if inflected and verb.stems == {verb.text} else Form.FINITE


def _chosen(
    candidates: Iterator[Reference] | list[Reference], said: Sequence[Word]
) -> list[Reference]:
    """The best candidates that do not overlap; equals on one span become rivals."""
    ranked = sorted(
        candidates,
        key=lambda each: (
            -each.parts * each.score, _strain(each), -each.score, each.last - each.first,
            each.first, each.symbol,
        ),
    )  # fmt: skip
    kept: list[Reference] = []
    for each in ranked:
        clash = [
            i for i, other in enumerate(kept) if each.first < other.last and other.first < each.last
        ]
        if not clash:
            if each.shape is Shape.PLACE or not is_motion(
                said, (each.first, each.last), each.parts
            ):
                kept.append(each)
        elif len(clash) == 1:
            other = kept[clash[0]]
            close = (
                other.parts == each.parts
                and other.score - each.score < CLOSE
                and each.symbol not in (other.symbol, *other.rivals)
                and (other.score < 1.0 or each.score == other.score)
                and _strain(other) == _strain(each)
                and (other.first, other.last) == (each.first, each.last)
            )
            if close:
                kept[clash[0]] = replace(other, rivals=(*other.rivals, each.symbol))
    return kept


def _strain(each: Reference) -> bool:
    """Whether words that fit an act and a state are better read as the other of the two."""
    asked = each.form in (Form.BASE, Form.GERUND) or each.eventful
    return (each.shape is Shape.STATE and asked) or (each.shape is Shape.ACT and not asked)
