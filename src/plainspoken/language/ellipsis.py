"""What an utterance leaves out or points at, filled in before it is read."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from plainspoken.language.acted_on import with_objects
from plainspoken.language.agency import told_apart
from plainspoken.language.coordination import spread
from plainspoken.language.frame import ARTICLES, Mention, Thing
from plainspoken.language.grounding import COPULAS, Shape, Vocabulary
from plainspoken.language.lexicon import PHRASES, Kind
from plainspoken.language.reference import Reference, references
from plainspoken.language.repetition import of_each
from plainspoken.language.word import Word

_LINKS = frozenset((",", "and", "or", "then", "&", "nor", "finally"))
_SEQUELS_WORDS = """
    followed by before after until till once likewise also not never next later and only
    but afterwards same with for too first last unless while
"""
_SEQUELS = _LINKS | frozenset(_SEQUELS_WORDS.split())
"""What may stand between what is said of one thing and another thing, of which it is said too."""
_ENDINGS = frozenset((".", ",", ";", "!", "?", "and", "or", "but", "then", "too"))
_BARE_COPULAS = frozenset(("is", "are", "was", "has", "does", "be", "been"))
_MODALS = frozenset(("not", "never", "must", "should", "to", "be", "shall", "will", "may", "can"))
_SINGULAR = frozenset(("it", "that", "this"))
_PLURAL = frozenset(("them", "they", "both", "these", "those"))
_POSSESSIVE = frozenset(("its", "their"))
_FARTHEST = 4
"""A pronoun is tried with no more things named before it than this."""

Resolved = tuple[tuple[Word, ...], tuple[Reference, ...]]


def resolved(said: tuple[Word, ...], vocabulary: Vocabulary) -> Resolved:
    """The references of an utterance after what is left out or pointed at has been filled in.

    "every site" is read as "site 0, site 1 and site 2", "sites 1 and 2" as "sites 1 and site 2",
    "go to site 2 and clear it" as "... clear site 2", "clear site 1, then site 2" as "... then
    clear site 2". Words filled in carry the place of the word that they stand for.
    """
    said = spread(said, vocabulary)
    found = references(said, vocabulary)
    index = 0
    while index < len(said):
        longer = _filled(said, found, index, vocabulary)
        if longer is not None:
            said, found, index = longer
        index += 1
    said, found = _repeated(said, found, vocabulary)
    return told_apart(said, with_objects(said, found, vocabulary), vocabulary.frames)


def _filled(
    said: tuple[Word, ...], found: tuple[Reference, ...], index: int, vocabulary: Vocabulary
) -> tuple[tuple[Word, ...], tuple[Reference, ...], int] | None:
    """The utterance with the thing that a word points at in place of the word."""
    word = said[index]
    if any(each.first <= index < each.last and each.score > 0.9 for each in found):
        return None
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
    if word.text in ("that", "this") and follows not in COPULAS | _MODALS | _ENDINGS:
        return
    if word.text in _SINGULAR | _POSSESSIVE:
        for thing in _named_before(said, index, vocabulary)[:_FARTHEST]:
            owner = ("'s",) if word.text in _POSSESSIVE else ()
            yield tuple(Word(text, word.start, word.end) for text in (*thing, *owner))
        return
    if not word.number.isdigit() or not index:
        return
    before = [each for each in found if each.last <= index and each.score > 0.9]
    if before and said[index - 1].text in (",", "and", "or", "then", "&", "to"):
        own = said[before[-1].first : before[-1].last]
        ends = index + 1 == len(said) or not said[index + 1].text.isalpha() or (
            word.text.isdigit() or said[index + 1].text in _SEQUELS
        )  # fmt: skip
        if own[-1].number.isdigit() and before[-1].last >= index - 2 and ends:
            yield tuple(Word(other.text, word.start, word.end) for other in (*own[:-1], word))


def _mentions(said: Sequence[Word], end: int, vocabulary: Vocabulary) -> list[Mention]:
    """The things that are named before a word, in order."""
    found: list[Mention] = []
    index = 0
    while index < end:
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


def _is_entered(said: Sequence[Word], index: int) -> bool:
    """Whether a word says where: a verb of going there, or "away from", stands before it."""
    if index and said[index - 1].text in ("from", "to", "into", "at"):
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
            index = inside.last
            continue
        mention = vocabulary.frames.mentioned(said, index)
        if mention is None:
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
    if answers:
        last += 2 if behind[1:2] == ["been"] else 1
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
            *(word for word in own[other.last :] if word.text not in _MODALS),
        )
        return tuple(Word(word.text, here.start, noun[-1].end) for word in kept), (
            last if answers else mention.last
        )
    return None
