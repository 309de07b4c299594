"""What an utterance says by pointing at its own words, said in full before it is read.

"The jar" after "jar 2", "jar 1, which must be sealed", "not opened without having been washed",
"the same goes for jar 3", "give the jar a wash". Words put in carry the place of what they
stand for.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from plainspoken.language.expression import Shape
from plainspoken.language.frame import Mention, Thing
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.reference import references
from plainspoken.language.word import Word

_STOPS = frozenset((".", ";", "!", "?", ":"))
_ENDS = _STOPS | {",", "and", "but", "or"}
_DEFINITE = frozenset(("the", "this", "that"))
_MODALS = frozenset(
    ("must", "should", "has", "may", "shall", "will", "can", "cannot", "needs", "is", "was")
)
_SHORTENED = frozenset(("that", "it", "there", "he", "she", "what", "who", "this", "here"))
_PREVENTING = frozenset(("prevent", "keep", "stop", "hinder", "block"))
_BEING = frozenset(("being", "getting", "becoming"))
_NOTICING = frozenset(
    ("find", "notice", "discover", "detect", "see", "learn", "realize", "realise", "observe",
     "hear", "spot", "establish")
)  # fmt: skip
_WHEN = frozenset(("if", "when", "whenever", "once"))
_SPOKEN_TO = frozenset(("you", "we", "i"))
_ALIKE = (
    ("the", "same", "goes", "for"), ("the", "same", "applies", "to"), ("the", "same", "for"),
    ("same", "for"), ("same", "goes", "for"), ("likewise", "for"), ("ditto", "for"),
    ("the", "same", "holds", "for"), ("the", "same", "with"), ("same", "with"),
    ("do", "the", "same", "for"), ("do", "the", "same", "with"), ("do", "the", "same", "to"),
    ("and", "likewise", "for"), ("the", "same", "is", "true", "of"), ("so", "too", "for"),
)  # fmt: skip
_TOPIC = (
    ("as", "for"), ("as", "to"), ("as", "regards"), ("regarding",), ("concerning",),
    ("when", "it", "comes", "to"), ("with", "regard", "to"), ("with", "respect", "to"),
    ("in", "the", "case", "of"),
)  # fmt: skip


def said_in_full(said: tuple[Word, ...], vocabulary: Vocabulary) -> tuple[Word, ...]:
    """The utterance with the things that it points at named."""
    said = _without_leave(_prevented(_spelled_out(said)))
    for step in (
        _done_alike, _without_light_verbs, _with_conditions, _with_antecedents, _with_subjects,
        _numbered,
    ):  # fmt: skip
        said = step(said, vocabulary)
    return said


def without_topic(said: tuple[Word, ...], vocabulary: Vocabulary) -> tuple[Word, ...]:
    """The utterance without "as for the jar", where all that is said of it names it."""
    for index in range(len(said)):
        opening = next((each for each in _TOPIC if _stands(said, index, each)), None)
        if opening is None or (index and said[index - 1].text not in _STOPS):
            continue
        place = index + len(opening)
        place += place < len(said) and said[place].text in _DEFINITE
        topic = vocabulary.frames.mentioned(said, place) if place < len(said) else None
        if topic is not None and topic.last < len(said) and said[topic.last].text == ",":
            return (*said[:index], *said[topic.last + 1 :])
    return said


def _stands(said: Sequence[Word], index: int, phrase: Sequence[str]) -> bool:
    return [word.text for word in said[index : index + len(phrase)]] == list(phrase)


def _last_named(
    said: Sequence[Word], end: int, vocabulary: Vocabulary, begin: int = 0
) -> Mention | None:
    """The last thing that is named before a word."""
    found: Mention | None = None
    index = begin
    while index < end:
        each = vocabulary.frames.mentioned(said, index)
        if each is not None and each.last <= end:
            found, index = each, each.last
        else:
            index += 1
    return found


def _named(thing: Thing, here: Word) -> tuple[Word, ...]:
    return tuple(Word(text, here.start, here.end) for text in thing)


def _done_alike(said: tuple[Word, ...], vocabulary: Vocabulary) -> tuple[Word, ...]:
    """Say again of another thing what was said of one: "...; the same goes for jar 3"."""
    for index in range(1, len(said)):
        phrase = next((each for each in _ALIKE if _stands(said, index, each)), None)
        if phrase is None or said[index - 1].text not in _ENDS:
            continue
        place = index + len(phrase)
        place += place < len(said) and said[place].text in _DEFINITE
        other = vocabulary.frames.mentioned(said, place) if place < len(said) else None
        close = index - 1
        begin = max((i + 1 for i in range(close) if said[i].text in _STOPS), default=0)
        if other is None or (other.last < len(said) and said[other.last].text not in _ENDS):
            continue
        again = _swapped(said[begin:close], other.thing, vocabulary)
        if again is not None:
            mark = replace(said[index], text=".")
            return (*said[:close], mark, *again, *said[other.last :])
    return said


def _swapped(
    told: tuple[Word, ...], other: Thing, vocabulary: Vocabulary
) -> tuple[Word, ...] | None:
    """What was told of one thing of the same kind, told of another."""
    found: list[Word] = []
    index, swapped = 0, False
    while index < len(told):
        each = vocabulary.frames.mentioned(told, index)
        if each is not None and _is_of_kind(each.thing, other, vocabulary):
            found += _named(other, told[index])
            index, swapped = each.last, True
        else:
            found.append(told[index])
            index += 1
    return tuple(found) if swapped else None


def _is_of_kind(one: Thing, other: Thing, vocabulary: Vocabulary) -> bool:
    if one == other:
        return False
    numbered = one[:-1] == other[:-1] and one[-1].isdigit() and other[-1].isdigit()
    return numbered or any(
        one in fillings and other in fillings for fillings in vocabulary.frames.fillings.values()
    )


def _spelled_out(said: tuple[Word, ...]) -> tuple[Word, ...]:
    """Read the "'s" of "that's been done" as "has", of "he's ready" as "is"."""
    found = list(said)
    for index in range(1, len(said) - 1):
        if said[index].text == "'s" and said[index - 1].text in _SHORTENED:
            has = said[index + 1].text in ("been", "got", "had")
            found[index] = replace(said[index], text="has" if has else "is")
    return tuple(found)


def _prevented(said: tuple[Word, ...]) -> tuple[Word, ...]:
    """Read "prevent the jar from being opened" as "never let the jar be opened"."""
    for index, word in enumerate(said):
        if word.stems.isdisjoint(_PREVENTING) or (index and said[index - 1].text in ("not", "to")):
            continue
        for place in range(index + 2, min(index + 8, len(said) - 2)):
            if said[place].text == "from" and said[place + 1].text in _BEING:
                never = (replace(word, text="never"), replace(word, text="let"))
                be = replace(said[place + 1], text="be")
                return (*said[:index], *never, *said[index + 1 : place], be, *said[place + 2 :])
    return said


def _without_leave(said: tuple[Word, ...]) -> tuple[Word, ...]:
    """Read "must never be allowed to be open" as "must never be open"."""
    for index in range(1, len(said) - 2):
        if not (_stands(said, index, ("be", "allowed", "to")) or _stands(
            said, index, ("be", "permitted", "to")
        )):  # fmt: skip
            continue
        if any(word.text in ("not", "never") for word in said[max(index - 3, 0) : index]):
            return (*said[:index], *said[index + 3 :])
    return said


def _with_conditions(said: tuple[Word, ...], vocabulary: Vocabulary) -> tuple[Word, ...]:
    """Read "were the jar to be open", "on finding the jar open", "if you notice that" as "if"."""
    for index in range(len(said) - 3):
        opens = not index or said[index - 1].is_mark or said[index - 1].text in ("and", "but")
        word, behind = said[index], said[index + 1]
        where = replace(word, text="if")
        if opens and word.text in ("were", "had") and behind.text not in ("to", "better"):
            return (*said[:index], where, *said[index + 1 :])
        if word.text in ("on", "upon") and behind.text.endswith("ing") and (
            behind.stems & _NOTICING
        ):  # fmt: skip
            rest = index + 2 + (said[index + 2].text == "that")
            return (*said[:index], where, *said[rest:])
        if word.text in _WHEN and behind.text in _SPOKEN_TO and said[index + 2].stems & _NOTICING:
            rest = index + 3
            rest += said[rest].text == "out"
            rest += said[rest].text == "that"
            place = rest + (said[rest].text in _DEFINITE)
            named = vocabulary.frames.mentioned(said, place) if place < len(said) else None
            told = said[rest - 1].text == "that" or (
                named is not None and named.thing not in vocabulary.frames.places
            )
            if told:
                return (*said[: index + 1], *said[rest:])
    return said


def _without_light_verbs(said: tuple[Word, ...], vocabulary: Vocabulary) -> tuple[Word, ...]:
    """Read "give the jar a wash" as "wash the jar"."""
    for index, word in enumerate(said):
        if "give" not in word.stems:
            continue
        for place in range(index + 2, min(index + 7, len(said) - 1)):
            if said[place].text not in ("a", "another"):
                continue
            act = said[place + 1]
            verbs = (
                each
                for stem in act.stems
                for each in vocabulary.by_stem.get(stem, ())
                if each.shape is Shape.ACT and each.parts[0].stems & act.stems
            )
            if next(verbs, None) is not None:
                verb = replace(word, text=act.text)
                return (*said[:index], verb, *said[index + 1 : place], *said[place + 2 :])
    return said


def _with_antecedents(said: tuple[Word, ...], vocabulary: Vocabulary) -> tuple[Word, ...]:
    """Read "jar 1, which must be sealed" as "..., and jar 1 must be sealed"."""
    for index in range(2, len(said) - 2):
        if said[index].text != "which" or said[index - 1].text != ",":
            continue
        named = _last_named(said, index - 1, vocabulary)
        if named is None or named.last != index - 1 or named.thing in vocabulary.frames.places:
            continue
        own, joint = _named(named.thing, said[index]), replace(said[index], text="and")
        if said[index + 1].text in _MODALS and _asks(said, index):
            close = next((i for i in range(index, len(said)) if said[i].text in _ENDS), len(said))
            if close + 1 < len(said) and said[close + 1].text in _MODALS:
                # "jar 1, which is to be sealed, must ...": both are said of it
                rest = (*said[index + 1 : close], joint, *own, *said[close + 1 :])
                return (*said[: index - 1], *rest)
            return (*said[:index], joint, *own, *said[index + 1 :])
        if said[index + 1].text in _SPOKEN_TO and said[index + 2].text in _MODALS:
            close = next((i for i in range(index, len(said)) if said[i].text in _ENDS), len(said))
            return (*said[:index], *said[index + 1 : close], *own, *said[close:])
    return said


def _asks(said: Sequence[Word], index: int) -> bool:
    """Whether a relative clause asks for something and does not only describe."""
    behind = [word.text for word in said[index + 1 : index + 4]]
    return behind[0] not in ("is", "was", "has") or "to" in behind


def _with_subjects(said: tuple[Word, ...], vocabulary: Vocabulary) -> tuple[Word, ...]:
    """Name what "without first having been washed" and "before being washed" speak of."""
    for index in range(1, len(said) - 2):
        been = said[index].text == "having" and said[index + 1].text == "been"
        being = said[index].text == "being"
        before = said[index - 1].text
        if not (been or being) or before not in ("without", "before", "after", "first", "until"):
            continue
        told = said[index + (2 if been else 1)]
        if told.stems == {told.text} or told.text in ("in", "at", "to", "on", "there"):
            continue
        named = _last_named(said, index, vocabulary)
        if named is not None and named.thing not in vocabulary.frames.places:
            return (*said[:index], *_named(named.thing, said[index]), *said[index:])
    return said


def _numbered(said: tuple[Word, ...], vocabulary: Vocabulary) -> tuple[Word, ...]:
    """Read "the jar" as the jar that was named last by its number."""
    index = 0
    while index < len(said) - 1:
        noun = said[index + 1]
        kind = noun.stems
        if said[index].text in _DEFINITE and len(vocabulary.members(noun)) > 1 and (
            not (index + 2 < len(said) and said[index + 2].number.isdigit())
            and noun.stems == {noun.text}
        ):  # fmt: skip
            named = _last_of_kind(said, index, kind, vocabulary)
            if named is not None and not _is_known(said, index, vocabulary):
                own = _named(named.thing, noun)
                said = (*said[:index], *own, *said[index + 2 :])
                index += len(own)
                continue
        index += 1
    return said


def _is_known(said: Sequence[Word], index: int, vocabulary: Vocabulary) -> bool:
    """Whether "the jar" is a name of its own, or part of a longer one."""
    if vocabulary.frames.mentioned(said, index + 1) is not None:
        return True
    return any(
        each.first <= index + 1 < each.last and each.shape is not Shape.ACT and each.score == 1.0
        for each in references(said, vocabulary)
    )


def _last_of_kind(
    said: Sequence[Word], end: int, kind: frozenset[str], vocabulary: Vocabulary
) -> Mention | None:
    found: Mention | None = None
    for index in range(end):
        each = vocabulary.frames.mentioned(said, index)
        if each is not None and each.last <= end and each.thing[0] in kind:
            if found is not None and found.thing != each.thing and index - found.last <= 2:
                return None  # "jars 1 and 2 ... the jar"
            found = each if each.thing[-1].isdigit() else found
    return found
