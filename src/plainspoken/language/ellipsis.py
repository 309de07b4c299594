"""What an utterance leaves out or points at, filled in before it is read."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from plainspoken.language.grounding import ARTICLES, COPULAS, Shape, Vocabulary
from plainspoken.language.reference import Form, Reference, references
from plainspoken.language.word import Word, stems

_LINKS = frozenset((",", "and", "or", "then", "&", "nor", "finally"))
_EACH = frozenset(("every", "each", "all", "any", "both", "none", "no"))
_EXCEPT = frozenset(("except", "but", "save"))


def resolved(
    said: tuple[Word, ...], vocabulary: Vocabulary
) -> tuple[tuple[Word, ...], tuple[Reference, ...]]:
    """The references of an utterance after what is left out or pointed at has been filled in.

    "every site" is read as "site 0, site 1 and site 2", "sites 1 and 2" as "sites 1 and site 2",
    "go to site 2 and clear it" as "... clear site 2", "clear site 1, then site 2" as "... then
    clear site 2". Words filled in carry the place of the word that they stand for.
    """
    said = _spread(said, vocabulary)
    found = references(said, vocabulary)
    index = 0
    while index < len(said):
        for filling in _fillings(said, found, index):
            longer = (*said[:index], *filling, *said[index + 1 :])
            again = references(longer, vocabulary)
            if any(
                each.score > 0.85
                and each.first <= index
                and each.last >= index + len(filling)
                and (
                    said[index].number.isdigit()
                    or (each.shape is not Shape.PLACE and each.last - each.first > len(filling))
                )
                for each in again
            ):
                said, found = longer, again
                index += len(filling) - 1
                break
        index += 1
    return _repeated(said, found, vocabulary)


def _repeated(
    said: tuple[Word, ...], found: tuple[Reference, ...], vocabulary: Vocabulary
) -> tuple[tuple[Word, ...], tuple[Reference, ...]]:
    """Repeat an act or state for a further place: "clear site 1, then site 2"."""
    for number, each in enumerate(found[1:], start=1):
        before = found[number - 1]
        between = said[before.last : each.first]
        if (
            each.form is not Form.NOUN
            or before.form is Form.NOUN
            or not between
            or not all(word.text in _LINKS or word.text in ARTICLES for word in between)
        ):
            continue
        own, noun = said[before.first : before.last], said[each.first : each.last]
        here = noun[0]
        for place in range(len(own) - len(noun) + 1):
            if own[place].stems & here.stems:
                filling = tuple(
                    Word(word.text, here.start, noun[-1].end)
                    for word in (*own[:place], *noun, *own[place + len(noun) :])
                )
                again = references(filling, vocabulary)
                if len(again) == 1 and again[0].score == before.score:
                    longer = (*said[: each.first], *filling, *said[each.last :])
                    return _repeated(longer, references(longer, vocabulary), vocabulary)
    return said, found


def _spread(said: tuple[Word, ...], vocabulary: Vocabulary) -> tuple[Word, ...]:
    """Spread "every site" and "sites 1 to 3" over the things of that name."""
    index = 0
    while index < len(said) - 1:
        word = said[index]
        if word.text in _EACH and not _is_said(said, index, vocabulary):
            start = index + 1
            while start < len(said) - 1 and said[start].text in ("of", "the", *_EACH):
                start += 1
            members = vocabulary.members(said[start])
            if len(members) > 1:
                after, left_out = _exceptions(said, start, members)
                chosen = [each for each in members if each not in left_out]
                joint = _either(said, index)
                wider = _of_each(said, (index, after), chosen, joint, vocabulary)
                if wider is not None:
                    said, index = wider
                    continue
                spread = _as_list(said[start], chosen, joint)
                said = (*said[:index], *spread, *said[after:])
                index += len(spread)
                continue
        span = _range(said, index, vocabulary)
        if span is not None:
            spread = _as_list(word, span, "and")
            said = (*said[:index], *spread, *said[index + 4 :])
            index += len(spread)
            continue
        index += 1
    return said


def _of_each(
    said: tuple[Word, ...],
    span: tuple[int, int],
    members: Sequence[tuple[str, ...]],
    joint: str,
    vocabulary: Vocabulary,
) -> tuple[tuple[Word, ...], int] | None:
    """Repeat a state or an act for each member that has it: "all sites are cleared"."""
    first, after = span
    noun = said[first + 1]
    found: list[tuple[Word, ...]] = []
    reach = (first, after)
    for member in members:
        words = tuple(Word(text, noun.start, noun.end) for text in member)
        trial = (*said[:first], *words, *said[after:])
        for each in references(trial, vocabulary):
            holds = each.first <= first and each.last >= first + len(words)
            if holds and each.shape is not Shape.PLACE and each.score == 1.0:
                found.append(trial[each.first : each.last])
                reach = (each.first, each.last - len(words) + after - first)
    if len(found) < 2:
        return None
    spread: list[Word] = []
    for place, part in enumerate(found):
        if place:
            spread.append(Word(joint, noun.start, noun.end))
        spread += part
    return (*said[: reach[0]], *spread, *said[reach[1] :]), reach[0] + len(spread)


def _either(said: Sequence[Word], index: int) -> str:
    """The word that joins the members: "any" is any one of them, unless it is denied."""
    if said[index].text != "any":
        return "and"
    before = {word.text for word in said[:index]}
    return "and" if before & {"never", "not", "no", "avoid", "without"} else "or"


def _is_said(said: Sequence[Word], index: int, vocabulary: Vocabulary) -> bool:
    """Whether the words as they are name something: "any tool" of "use any tool"."""
    return any(
        each.first <= index + 1 < each.last and each.score == 1.0 and not each.rivals
        for each in references(said, vocabulary)
    )


def _exceptions(
    said: Sequence[Word], start: int, members: Sequence[tuple[str, ...]]
) -> tuple[int, frozenset[tuple[str, ...]]]:
    """Where "every site except site 2" ends, and which ones it leaves out."""
    after = start + 1
    if after >= len(said) or said[after].text not in _EXCEPT:
        return after, frozenset()
    left_out: set[tuple[str, ...]] = set()
    place = after + 1
    while place < len(said):
        found = next(
            (
                each
                for each in members
                if all(
                    place + i < len(said) and said[place + i].stems & stems(word)
                    for i, word in enumerate(each)
                )
            ),
            None,
        )
        if found is not None:
            left_out.add(found)
            place += len(found)
        elif said[place].text in ("for", "and", "or", "the"):
            place += 1
        else:
            break
    return (place, frozenset(left_out)) if left_out else (after, frozenset())


def _range(
    said: Sequence[Word], index: int, vocabulary: Vocabulary
) -> list[tuple[str, ...]] | None:
    """The things of "sites 1 to 3"."""
    if index + 3 >= len(said) or said[index + 2].text not in ("to", "through", "\u2013", "-"):
        return None
    first, last = said[index + 1].number, said[index + 3].number
    if not (first.isdigit() and last.isdigit() and said[index].text.endswith("s")):
        return None
    members = [each for each in vocabulary.members(said[index]) if each[-1].isdigit()]
    span = [each for each in members if int(first) <= int(each[-1]) <= int(last)]
    return span if {first, last} <= {each[-1] for each in span} else None


def _as_list(noun: Word, members: Sequence[tuple[str, ...]], joint: str) -> tuple[Word, ...]:
    found: list[Word] = []
    for place, member in enumerate(members):
        if place:
            found.append(Word(joint, noun.start, noun.end))
        found += [Word(text, noun.start, noun.end) for text in member]
    return tuple(found)


def _fillings(
    said: Sequence[Word], found: Sequence[Reference], index: int
) -> Iterator[tuple[Word, ...]]:
    """What a pronoun, or a number without its noun, may stand for."""
    word = said[index]
    if any(each.first <= index < each.last and each.score > 0.9 for each in found):
        return
    before = [each for each in found if each.last <= index and each.score > 0.9]
    if word.text in ("it", "them", "there", "that"):
        for each in reversed(before):
            yield tuple(
                Word(other.text, word.start, word.end) for other in _noun(each, said) if other.text
            )
    elif (
        word.number.isdigit()
        and before
        and said[index - 1].text in (",", "and", "or", "then", "&", "to")
    ):
        own = said[before[-1].first : before[-1].last]
        if own[-1].number.isdigit() and before[-1].last >= index - 2:
            yield tuple(Word(other.text, word.start, word.end) for other in (*own[:-1], word))


def _noun(reference: Reference, said: Sequence[Word]) -> Sequence[Word]:
    """The noun that a reference holds: a place, the subject of a state, the object of an act."""
    own = said[reference.first : reference.last]
    if reference.form is Form.NOUN:
        return own
    if reference.form is Form.FINITE:
        cut = next((i for i, word in enumerate(own) if word.text in COPULAS), len(own))
        return own[:cut]
    return own[1:]
