"""What an utterance leaves out or points at, filled in before it is read."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from plainspoken.language.acted_on import with_objects
from plainspoken.language.agency import told_apart
from plainspoken.language.anaphora import said_in_full, without_topic
from plainspoken.language.carriage import with_errands
from plainspoken.language.coordination import spread
from plainspoken.language.expression import COPULAS, Shape
from plainspoken.language.frame import ARTICLES, Mention, Thing
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.lexicon import PHRASES, Kind
from plainspoken.language.reference import Form, Reference, references
from plainspoken.language.repetition import of_each
from plainspoken.language.step import Place
from plainspoken.language.word import Word
from plainspoken.world.symbol import SymbolId

_LINKS = frozenset((",", "and", "or", "then", "&", "nor", "finally"))
_SEQUELS_WORDS = """
    followed by before after until till once likewise also not never next later and only
    but afterwards same with for too first last unless while instead of rather than so does
    do must has should is are have does
"""
_SEQUELS = _LINKS | frozenset(_SEQUELS_WORDS.split())
"""What may stand between what is said of one thing and another thing, of which it is said too."""
_ENDINGS = frozenset((".", ",", ";", "!", "?", "and", "or", "but", "then", "too"))
_BARE_COPULAS = frozenset(("is", "are", "was", "has", "does", "be", "been"))
_MODALS = frozenset(("not", "never", "must", "should", "to", "be", "shall", "will", "may", "can"))
_SINGULAR = frozenset(("it", "that", "this", "him", "her", "he", "she"))
_PLURAL = frozenset(("them", "they", "both", "these", "those"))
_POSSESSIVE = frozenset(("its", "their"))
_STILL = frozenset(
    (
        "and",
        "or",
        "but",
        "not",
        "then",
        "also",
        "already",
        "still",
        "yet",
        "nor",
        ",",
        "never",
        "is",
        "no",
        "longer",
        "both",
        "either",
        "has",
        "been",
        "finally",
        "later",
    )
)
"""What may stand between a state of a thing and a further state of it."""
_FARTHEST = 4
"""A pronoun is tried with no more things named before it than this."""

_SURE = 0.7
"""A place of an errand is named at least as well as this."""

Resolved = tuple[tuple[Word, ...], tuple[Reference, ...]]


def resolved(said: tuple[Word, ...], vocabulary: Vocabulary) -> Resolved:
    """The references of an utterance after what is left out or pointed at has been filled in.

    "every site" is read as "site 0, site 1 and site 2", "sites 1 and 2" as "sites 1 and site 2",
    "go to site 2 and clear it" as "... clear site 2", "clear site 1, then site 2" as "... then
    clear site 2". Words filled in carry the place of the word that they stand for.
    """
    said = spread(_with_errands(said_in_full(said, vocabulary), vocabulary), vocabulary)
    found = references(said, vocabulary)
    index = 0
    while index < len(said):
        longer = _filled(said, found, index, vocabulary)
        if longer is not None:
            said, found, index = longer
        index += 1
    shorter = without_topic(said, vocabulary)
    if shorter != said:
        said, found = shorter, references(shorter, vocabulary)
    said, found = _repeated(said, found, vocabulary)
    found = with_objects(said, found, vocabulary)
    return told_apart(said, found, vocabulary.frames, vocabulary.deeds, vocabulary.doers)


def _with_errands(said: tuple[Word, ...], vocabulary: Vocabulary) -> tuple[Word, ...]:
    """The utterance with each errand as one word."""
    if not vocabulary.handling.is_told:
        return said
    named = references(said, vocabulary.places)
    places = [
        Place(each.symbol, each.first, each.last, _name(said[each.first : each.last]))
        for each in named
        if not each.rivals and each.score >= _SURE
    ]

    def told(index: int) -> SymbolId | None:
        sure = (each for each in references(said, vocabulary) if each.score > 0.9)
        own = (each for each in sure if each.shape is not Shape.PLACE)
        return next((each.symbol for each in own if each.first <= index < each.last), None)

    return with_errands(said, vocabulary.handling, places, told)


def _name(said: Sequence[Word]) -> tuple[str, ...]:
    return tuple(word.number for word in said if word.text not in ARTICLES and not word.is_mark)


def _filled(
    said: tuple[Word, ...], found: tuple[Reference, ...], index: int, vocabulary: Vocabulary
) -> tuple[tuple[Word, ...], tuple[Reference, ...], int] | None:
    """The utterance with the thing that a word points at in place of the word."""
    word = said[index]
    if any(each.first <= index < each.last and each.score > 0.9 for each in found):
        return None
    if word.text == "there" or (word.text == "it" and _is_entered(said, index)):
        within = _place_within(said, found, index, vocabulary)
        if within is not None:
            own = tuple(Word(text, word.start, word.end) for text in within)
            longer = (*said[:index], *own, *said[index + 1 :])
            return longer, references(longer, vocabulary), index + len(own) - 1
    if word.text in _PLURAL:
        several = _of_all(said, index, vocabulary)
        if several is not None:
            return several
    for filling in _fillings(said, found, index, vocabulary):
        longer = (*said[:index], *filling, *said[index + 1 :])
        again = references(longer, vocabulary)
        for each in again:
            if (
                each.score > 0.75
                and each.first <= index
                and each.last >= index + len(filling)
                and (
                    word.number.isdigit()
                    or (len(word.text) == 1 and each.shape is Shape.PLACE)
                    or (each.shape is not Shape.PLACE and each.last - each.first > len(filling))
                    or (each.shape is Shape.PLACE and _is_entered(said, index))
                )
            ):
                return longer, again, index + len(filling) - 1
    return None


def _fillings(
    said: Sequence[Word], found: Sequence[Reference], index: int, vocabulary: Vocabulary
) -> Iterator[tuple[Word, ...]]:
    """What a pronoun, or a number without its noun, may stand for."""
    word = said[index]
    follows = said[index + 1].text if index + 1 < len(said) else "."
    if word.text == "it" and follows == "that" and said[max(index - 1, 0)].text in ("to", "so"):
        return  # "see to it that"
    if word.text in ("that", "this") and follows not in COPULAS | _MODALS | _ENDINGS:
        return
    if word.text in ("it", "them", "one"):
        yield from _object_before(said, found, index, vocabulary)
    if word.text in _SINGULAR | _POSSESSIVE:
        for thing in _named_before(said, index, vocabulary)[:_FARTHEST]:
            owner = ("'s",) if word.text in _POSSESSIVE else ()
            yield tuple(Word(text, word.start, word.end) for text in (*thing, *owner))
        return
    letter = len(word.text) == 1 and word.text.isalpha()
    if not (word.number.isdigit() or letter) or not index:
        return
    before = [each for each in found if each.last <= index and each.score > 0.9]
    if before and said[index - 1].text in (",", "and", "or", "then", "&", "to"):
        own = said[before[-1].first : before[-1].last]
        ends = index + 1 == len(said) or not said[index + 1].text.isalpha() or (
            word.text.isdigit() or said[index + 1].text in _SEQUELS
        )  # fmt: skip
        same = own[-1].number.isdigit() if not letter else len(own[-1].text) == 1
        if same and len(own) > 1 and before[-1].last >= index - 2 and ends:
            yield tuple(Word(other.text, word.start, word.end) for other in (*own[:-1], word))


def _object_before(
    said: Sequence[Word], found: Sequence[Reference], index: int, vocabulary: Vocabulary
) -> Iterator[tuple[Word, ...]]:
    """What the act before is done to, any one of a kind: "wash a jar, then put it away"."""
    before = next((each for each in reversed(found) if each.last <= index), None)
    if before is None or before.shape is not Shape.ACT:
        return
    kinds = vocabulary.general.get(before.symbol, frozenset())
    own = {stem for each in said[before.first : before.last] for stem in each.stems}
    numbered = any(each.number.isdigit() for each in said[before.first : before.last])
    for kind in sorted(kinds & own) if not numbered else ():
        yield tuple(Word(text, said[index].start, said[index].end) for text in ("a", kind))


def _mentions(said: Sequence[Word], end: int, vocabulary: Vocabulary) -> list[Mention]:
    """The things that are named before a word, in order."""
    found: list[Mention] = []
    index = 0
    while index < end:
        errand = said[index].errand
        if errand is not None:
            found += (Mention(thing, index, index + 1) for thing in errand.things)
            index += 1
            continue
        each = vocabulary.frames.mentioned(said, index)
        if each is not None and each.last <= end:
            found.append(each)
            index = each.last
        else:
            index += 1
    return found


def _named_before(said: Sequence[Word], end: int, vocabulary: Vocabulary) -> list[Thing]:
    """The things that are named before a word, the last one first."""
    return list(dict.fromkeys(each.thing for each in reversed(_mentions(said, end, vocabulary))))


def _of_all(
    said: tuple[Word, ...], index: int, vocabulary: Vocabulary
) -> tuple[tuple[Word, ...], tuple[Reference, ...], int] | None:
    """What is said of "them", said of each of the last things that it can be said of."""
    word = said[index]
    things = list(reversed(_named_before(said, index, vocabulary)[:_FARTHEST]))
    own = [tuple(Word(text, word.start, word.end) for text in thing) for thing in things]
    longer = of_each(said, (index, index + 1), own, "and", vocabulary) if len(own) > 1 else None
    if longer is None:
        return None
    return longer.said, references(longer.said, vocabulary), longer.after - 1


def _place_within(
    said: Sequence[Word], found: Sequence[Reference], index: int, vocabulary: Vocabulary
) -> Thing | None:
    """The place that "there" points to where it was only named within a state or an act."""
    behind = said[index + 1].text if index + 1 < len(said) else "."
    if behind in COPULAS | _MODALS:
        return None
    places = vocabulary.frames.places
    last = next(
        (each for each in reversed(_mentions(said, index, vocabulary)) if each.thing in places),
        None,
    )
    if last is None:
        return None
    holders = [each for each in found if each.first <= last.first and last.last <= each.last]
    movers = {symbol for there in vocabulary.frames.movers.values() for symbol in there.values()}
    told = any(each.shape is not Shape.PLACE and each.symbol not in movers for each in holders)
    return last.thing if told else None


def _is_entered(said: Sequence[Word], index: int) -> bool:
    """Whether a word says where: a verb of going there, or "away from", stands before it."""
    if index and said[index - 1].text in ("from", "to", "into", "at"):
        return True
    if index > 1 and said[index - 1].text == "of" and said[index - 2].text in ("out", "clear"):
        return True
    return index > 0 and any(
        pattern == ("~" + stem,) and kind in (Kind.GO, Kind.LEAVE, Kind.AVOID)
        for stem in said[index - 1].stems
        for pattern, kind in PHRASES.get(stem, ())
    )


def _repeated(
    said: tuple[Word, ...], found: tuple[Reference, ...], vocabulary: Vocabulary
) -> Resolved:
    """Repeat an act or state for a further thing: "clear site 1, then site 2"."""
    index = 0
    while index < len(said):
        inside = next((each for each in found if each.first <= index < each.last), None)
        if inside is not None and inside.shape is not Shape.PLACE:
            bare = inside.shape is Shape.ACT and inside.parts == 1 and inside.form is Form.FINITE
            if bare:
                said, found = _told_on(said, found, index, vocabulary) or (said, found)
            index = inside.last
            continue
        mention = vocabulary.frames.mentioned(said, index)
        if mention is None:
            said, found = _told_on(said, found, index, vocabulary) or (said, found)
            index += 1
            continue
        filling = _said_again(said, found, mention, vocabulary)
        if filling is not None:
            words, last = filling
            longer = (*said[: mention.first], *words, *said[last:])
            again = references(longer, vocabulary)
            first, end = mention.first, mention.first + len(words)
            if any(each.first <= first and each.last >= end for each in again):
                said, found = longer, again
                index = end
                continue
        index = mention.last
    return said, found


def _told_on(
    said: tuple[Word, ...], found: Sequence[Reference], index: int, vocabulary: Vocabulary
) -> Resolved | None:
    """Repeat the subject for a further state of it: "the jar is sealed but not labelled"."""
    before = next((each for each in reversed(found) if each.last <= index), None)
    if before is None or before.shape is not Shape.STATE or before.rivals:
        return None
    between = [word.text for word in said[before.last : index]]
    if not between or not all(text in _STILL for text in between):
        return None
    subject = vocabulary.frames.mentioned(said, before.first)
    if said[index].text in _STILL | ARTICLES or subject is None or subject.last >= before.last:
        return None
    # "... but not labelled": the subject stands before the "not".
    first = index - next((i + 1 for i, text in enumerate(reversed(between)) if text == "not"), 0)
    here = said[first]
    named = said[before.first : subject.last]
    own = tuple(replace(word, start=here.start, end=here.end) for word in named)
    longer = (*said[:first], *own, *said[first:])
    again = references(longer, vocabulary)
    told = any(
        each.first == first
        and each.last > index + len(own)
        and each.score > 0.85
        and each.shape is Shape.STATE
        and any(
            thing == subject.thing and frame[0] == "_"
            for frame, thing in vocabulary.frames.of_symbol.get(each.symbol, ())
        )
        for each in again
    )
    return (longer, again) if told else None


def _said_again(
    said: Sequence[Word], found: Sequence[Reference], mention: Mention, vocabulary: Vocabulary
) -> tuple[tuple[Word, ...], int] | None:
    """What was said last, said of a thing that stands alone; and where its own words end."""
    before = next(
        (each for each in reversed(found) if each.last <= mention.first and each.score > 0.75), None
    )
    if before is None or before.shape is Shape.PLACE or before.rivals:
        return None
    between = [word.text for word in said[before.last : mention.first]]
    behind = [word.text for word in said[mention.last : mention.last + 3]]
    last = mention.last
    answers = bool(behind) and behind[0] in _BARE_COPULAS
    denied = behind[1:2] == ["not"]
    if answers:
        last += 2 if behind[1:2] == ["been"] or denied else 1
        answers = last >= len(said) or said[last].text in _ENDINGS
    place = mention.thing in vocabulary.frames.places
    links = (_LINKS if place else _SEQUELS) | ARTICLES
    if not between or (not answers and not all(text in links for text in between)):
        return None
    if not answers and (len(between) > 5 or (behind and behind[0] in COPULAS)):
        return None
    own = said[before.first : before.last]
    for offset in range(len(own)):
        other = vocabulary.frames.mentioned(own, offset)
        if other is None or not vocabulary.frames.swapped(
            before.symbol, other.thing, mention.thing
        ):
            continue
        here = said[mention.first]
        noun = said[mention.first : mention.last]
        kept = (
            *(word for word in own[: other.first] if word.text not in _MODALS),
            *noun,
            *((replace(here, text="not"),) if answers and denied else ()),
            *(word for word in own[other.last :] if word.text not in _MODALS),
        )
        return tuple(Word(word.text, here.start, noun[-1].end) for word in kept), (
            last if answers else mention.last
        )
    return None
