"""What a verb of handling handles, where from and where to, as it is said."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from plainspoken.language.frame import ARTICLES
from plainspoken.language.handling import (
    GOALS,
    ITEMS,
    SOURCES,
    Handling,
    Manner,
    Thing,
)
from plainspoken.language.kind import Kind
from plainspoken.language.lexicon import PHRASES, is_general
from plainspoken.language.step import Name, Place
from plainspoken.language.word import Word, stems

DETERMINERS = ARTICLES | frozenset(("your", "its", "some", "any", "this", "that", "more", "one"))
_PRONOUNS = frozenset(("it", "them", "that", "this", "those", "these"))
_RELEASED_WORDS = """
    any every all the a an whatever whichever what your other currently current held carried that
    which you is are being have had hold holding carry carrying might may be still everything
    possess have's got happen just now
"""
_RELEASED = frozenset(_RELEASED_WORDS.split())
_WHOLE = frozenset(("whatever", "everything", "anything", "something", "what"))
_HANDS = frozenset(("hand", "hands", "gripper", "grip", "possession", "arms", "arm"))
LYING = frozenset(
    ["located", "lying", "sitting", "waiting", "stored", "kept", "found", "placed", "situated"]
)
ALONG = frozenset(("over", "back", "straight", "directly", "safely", "all", "the", "way", "down",
    "right", "along", "quickly", "carefully", "up", "off"))  # fmt: skip
AMBIGUOUS = frozenset(("in", "on", "at", "near", "by", "within", "inside"))
_DROPPING = frozenset(("drop", "release", "unload", "deposit"))


@dataclass(frozen=True, slots=True)
class Where:
    """Where a thing comes from and goes to."""

    last: int
    source: Place | None = None
    goal: Place | None = None
    there: bool = False


@dataclass(frozen=True, slots=True)
class Handled:
    """What a verb handles. pronoun: whether it only points back."""

    last: int
    things: tuple[Thing, ...]
    names: tuple[Name, ...] = ()
    pronoun: bool = False
    released: bool = False


class HandledReader:
    """Reads things and places from the words of an utterance."""

    def __init__(self, said: Sequence[Word], handling: Handling, places: Sequence[Place]) -> None:
        self._said = said
        self._handling = handling
        self._places = {each.first: each for each in places}
        for index in range(len(said)):
            for goal in handling.goals if index not in self._places else ():
                if self._says(index, goal):
                    # Something that is no place may hold things: "put it in the case".
                    self._places[index] = Place("", index, index + len(goal), goal)

    def place_at(self, index: int, *, holds_things: bool = False) -> Place | None:
        """The place that is named from a word on, after an article.

        holds_things: or what is no place, but may have things in it
        """
        while index < len(self._said) and self._said[index].text in ARTICLES:
            if index in self._places:
                break
            index += 1
        place = self._places.get(index)
        return place if place is not None and (place.symbol or holds_things) else None

    def _text(self, index: int) -> str:
        return self._said[index].text if 0 <= index < len(self._said) else "."

    def _form(self, index: int) -> str:
        word = self._said[index]
        if word.text.endswith("ing") and len(word.stems) > 1:
            return "gerund"
        return "base" if word.text in word.stems and len(word.stems) == 1 else "finite"

    def _motion(self, index: int) -> int | None:
        for stem in sorted(self._said[index].stems):
            for pattern, kind in PHRASES.get(stem, ()):
                if kind is not Kind.GO or not pattern[0].startswith("~"):
                    continue
                rest = tuple(word.text for word in self._said[index + 1 : index + len(pattern)])
                if rest == pattern[1:]:
                    return index + len(pattern)
        return None

    def _object(self, index: int, verb: int, manner: Manner, *, holding: bool) -> Handled | None:
        listed = self._listed(index)
        if listed is not None:
            return listed
        text = self._text(index)
        if text in _PRONOUNS and self._text(index + 1) not in LYING:
            if holding:
                return Handled(index + 1, (), pronoun=True)
            topic = self._topic(verb)
            drops = verb + 1 < index or self._text(index + 1) in ("down", "off") or (
                not self._said[verb].stems.isdisjoint(_DROPPING)
            )  # fmt: skip
            if topic is None and manner is Manner.LAY and drops and () in self._handling.laid:
                return Handled(index + 1, (), pronoun=True, released=True)
            return topic and replace(topic, last=index + 1, pronoun=True)
        if manner is Manner.LAY or holding:
            released = self._released(index)
            if released is not None:
                return Handled(released, (), released=not holding)
        if holding and (text in GOALS or text in ALONG) and self._motion(verb) is None:
            return Handled(index, ())
        return None

    def _topic(self, before: int) -> Handled | None:
        """The thing that was named last."""
        for index in range(before - 1, -1, -1):
            found = self._thing(index)
            before = index - 1
            while self._text(before) in ARTICLES:
                before -= 1
            if found is not None and self._text(before) not in GOALS | SOURCES:
                thing, first, last = found
                return Handled(last, (thing,), self._named(thing, first, last))
        return None

    def _listed(self, index: int) -> Handled | None:
        """One thing or several: "x and y"."""
        things: list[Thing] = []
        names: list[Name] = []
        position, last = index, index
        while True:
            while self._text(position) in DETERMINERS or self._text(position) == "both":
                position += 1
            found = self._thing(position)
            if found is None:
                break
            thing, first, last = found
            things.append(thing)
            names += self._named(thing, first, last)
            position = last
            while self._text(position) in (",", "and", "also"):
                position += 1
            if position == last:
                break
        return Handled(last, tuple(things), tuple(names)) if things else None

    def _thing(self, index: int) -> tuple[Thing, int, int] | None:
        """The thing named from a word on; a word that only says more of it may stand before."""
        for more in (0, 1):
            if more and not self._may_tell_more(index):
                return None
            first = index + more
            if first >= len(self._said):
                return None
            for key in self._handling.things_from(self._said[first]):
                behind = self._said[first + len(key) :][:1]
                numbered = any(word.number.isdigit() for word in behind)
                if len(key) > more and not numbered and self._says(first, key):
                    return key, first, first + len(key)
        return None

    def _named(self, thing: Thing, first: int, last: int) -> tuple[Name, ...]:
        return tuple((symbol, first, last) for symbol in self._handling.symbols(thing))

    def _may_tell_more(self, index: int) -> bool:
        """Whether a word may only tell more of the thing named behind it: "the heavy x"."""
        return (
            index + 1 < len(self._said)
            and self._text(index).isalpha()
            and index not in self._places
            and self._text(index) not in GOALS | SOURCES
            and not is_general(self._said[index])
        )

    def _says(self, index: int, key: Thing) -> bool:
        return index + len(key) <= len(self._said) and all(
            word.number == text or bool(word.stems & stems(text))
            for word, text in zip(self._said[index:], key, strict=False)
        )

    def _released(self, index: int) -> int | None:
        """The word after "whatever you hold", "any item that you have in your hand"."""
        position, whole = index, False
        while self._text(position) in _RELEASED | ITEMS:
            if position > index and self._text(position) == "it":
                break
            whole |= self._text(position) in ITEMS | _WHOLE
            position += 1
        if self._text(position) in ("in", "with") and self._text(position + 1) in (
            "your", "the", "its", *_HANDS,
        ):  # fmt: skip
            hand = position + 1 + (self._text(position + 1) not in _HANDS)
            if self._text(hand) in _HANDS:
                position = hand + 1
        return position if whole else None

    def _where(self, index: int, *, carried: bool, lifted: bool) -> Where:
        """Read "from a to b", "to b from a", "in b", "there".

        carried: "in b" is where it goes to; else where it comes from
        lifted:  the verb may tell of picking up only, so "in a" is where it is
        """
        found = Where(index)
        position = index
        told = False  # a clause tells where it is: ", which is at a,"
        while True:
            start = position
            lying = False
            while self._text(position) in (",", "that", "which", "is", "are") or (
                self._text(position) in LYING
            ):
                lying |= self._text(position) in LYING | {"that", "which"}
                position += 1
            if position > start and not (lying or told):
                position = start
            told = False
            into = self._text(position) == "and" and found.source and not found.goal
            if into and self._text(position + 1) in ("to", "into", "onto"):
                position += 1
            while self._text(position) in ALONG and position not in self._places:
                position += 1
            text = self._text(position)
            if text == "there":
                return replace(found, last=position + 1, there=True)
            goes = text in GOALS and not lying
            comes = text in SOURCES or (text == "out" and self._text(position + 1) == "of")
            if text in AMBIGUOUS:
                goes &= carried and (not lifted or found.source is not None)
                comes &= not goes
            elif text == "from":
                goes = False
            if not (goes or comes):
                return found
            behind = position + 1
            while self._text(behind) in ("of", "to", "at", "in", "on", "inside", "into"):
                if behind in self._places:
                    break
                behind += 1
            place = self.place_at(behind, holds_things=goes)
            if place is None:
                return found
            if goes and found.goal is None:
                found = replace(found, last=place.last, goal=place)
            elif comes and found.source is None:
                found = replace(found, last=place.last, source=place)
                told = lying
            else:
                return found
            position = place.last
