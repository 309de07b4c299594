"""What the symbols of a domain do in an errand: who is picked up, put down, delivered, recorded.

The roles are found by the verbs of the symbols' own words. The verbs are those of general English
for handling a thing, the nouns those for what a record is; no word of any domain stands here.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum, auto
from functools import cached_property

from plainspoken.language.frame import ARTICLES
from plainspoken.language.kinship import nouns_of
from plainspoken.language.word import Word, stems, words
from plainspoken.world.landmark import Landmark, Landmarks, LandmarkType
from plainspoken.world.symbol import SymbolId


class Manner(StrEnum):
    """How a verb handles a thing."""

    LIFT = auto()  # it is picked up
    CARRY = auto()  # it gets from one place to another
    LAY = auto()  # it is put down


_VERBS = {
    Manner.LIFT: """
        pick up; pickup; pick; collect; get; fetch; grab; retrieve; take; obtain; gather; acquire;
        lift; lift up; load; grasp; seize; snatch; scoop up; get hold of; take hold of; remove;
        recover; go get; go fetch; take out; pull; receive; claim; secure; take up; grip
    """,
    Manner.CARRY: """
        carry; transport; deliver; bring; take; move; haul; transfer; convey; ferry; ship; relocate;
        shift; lug; tote; cart; drag; run; return; get; fetch; hand over; drop off; pass on; cart
        off; bring over; take over; carry over; bring along; shuttle; hoist; transit; forward;
        bring back; take back; supply; courier; send; hand; give
    """,
    Manner.LAY: """
        put; place; set; lay; deposit; drop; drop off; leave; put down; set down; lay down; hand
        over; unload; release; hand in; offload; dump; stow; let go of; let go; rest; position;
        put away; discharge; dispose of; throw; toss; relinquish; unhand; get rid of
    """,
}
PARTICLES = frozenset(("up", "down", "off", "over", "out", "away", "in", "along", "back", "on"))
Phrase = tuple[str, ...]


def _phrases(text: str) -> tuple[Phrase, ...]:
    found = (tuple(part.split()) for part in text.split(";"))
    return tuple(sorted(found, key=lambda each: -len(each)))


VERBS: Mapping[Manner, tuple[Phrase, ...]] = {
    manner: _phrases(text) for manner, text in _VERBS.items()
}
_ITEM_WORDS = """
    item object thing load cargo payload something anything it them whatever possession burden
    items objects things loads stuff goods holding
"""
ITEMS = frozenset(_ITEM_WORDS.split())
"""What any thing may be called."""
SOURCES = frozenset(("from", "at", "in", "on", "off", "inside", "within", "near", "by"))
GOALS = frozenset(
    ("to", "into", "onto", "in", "on", "at", "inside", "towards", "over", "within", "by", "near")
)
_LIGHT_WORDS = """
    take capture get snap shoot make record do perform grab acquire obtain collect gather carry
    conduct produce have execute complete snatch run
"""
LIGHT = frozenset(_LIGHT_WORDS.split())
"""Verbs that only say that what their object names is done: "take a look"."""
_RECORDS = """photo photograph picture image snapshot shot snap photography pic;
    video film footage movie videotape; recording record; scan scanning;
    sample sampling; measurement measure measuring; reading; inspection inspect survey;
    look"""
RECORDS = tuple(frozenset(entry.split()) for entry in _RECORDS.split(";"))
_RECORDING = """photograph snap shoot picture image; film videotape video; record;
    scan; sample; measure; read; inspect survey examine; observe"""
RECORDING = tuple(frozenset(entry.split()) for entry in _RECORDING.split(";"))
"""The verbs that say in one word what taking a record of the same entry says."""

Thing = tuple[str, ...]


@dataclass(frozen=True)
class Handling:
    """The symbols of a domain by the part that they have in an errand.

    lifted:    by the words of a thing, the symbol for its being picked up
    laid:      by the words of a thing, the symbol for its being put down; () for any thing
    delivered: by a thing and where it is, the condition that it is there
    records:   by the entry of `RECORDS`, the symbol for taking such a record
    held:      by the words of a thing, the condition that it is in the hand
    movers:    things that may be somewhere, and so perhaps go there by themselves
    stands_in: whether the lifted are only names, because no symbol says that anything is picked up
    """

    lifted: Mapping[Thing, SymbolId] = field(default_factory=dict)
    laid: Mapping[Thing, SymbolId] = field(default_factory=dict)
    delivered: Mapping[tuple[Thing, Thing], SymbolId] = field(default_factory=dict)
    records: Mapping[int, SymbolId] = field(default_factory=dict)
    held: Mapping[Thing, SymbolId] = field(default_factory=dict)
    stands_in: bool = False
    movers: frozenset[Thing] = frozenset()

    @classmethod
    def of(cls, landmarks: Landmarks, movers: frozenset[Thing] = frozenset()) -> Handling:
        """The roles of the symbols of a domain."""
        lifted: dict[Thing, SymbolId] = {}
        laid: dict[Thing, SymbolId] = {}
        records: dict[int, SymbolId] = {}
        delivered: dict[tuple[Thing, Thing], SymbolId] = {}
        held: dict[Thing, SymbolId] = {}
        for landmark in landmarks.values():
            for phrase in landmark.phrases:
                said = tuple(word for word in words(phrase) if not word.is_mark)
                for thing in _lifted(landmark, said):
                    lifted.setdefault(thing, landmark.id)
                for thing in _laid(landmark, said):
                    laid.setdefault(thing, landmark.id)
                for pair in _delivered(landmark, said):
                    delivered.setdefault(pair, landmark.id)
                for thing in _held(landmark, said):
                    held.setdefault(thing, landmark.id)
                number = _record(said)
                if number is not None:
                    records.setdefault(number, landmark.id)
        roles = {*lifted.values(), *laid.values(), *records.values()}
        delivered = _by_every_name(delivered, landmarks)
        stands_in = not (lifted or held or delivered)
        if stands_in:
            # Where no act picks anything up, what bears the name of a thing stands for it.
            lifted = {
                _thing(words(landmark.description)): landmark.id
                for landmark in landmarks.values()
                if landmark.type is LandmarkType.LOCATION and landmark.id not in roles
            }
        return cls(lifted, laid, delivered, records, held, stands_in, movers)

    @property
    def is_told(self) -> bool:
        """Whether there is an errand to tell of in the domain at all."""
        return bool(self.things or self.laid or self.records)

    @cached_property
    def things(self) -> tuple[Thing, ...]:
        """The things that may be handled, the longest names first."""
        known = {*self.lifted, *self.held, *(thing for thing, _ in self.delivered)}
        return tuple(sorted(known, key=lambda each: (-len(each), each)))

    @cached_property
    def _things_by_stem(self) -> Mapping[str, tuple[Thing, ...]]:
        found: dict[str, list[Thing]] = {}
        for thing in filter(None, self.things):
            for stem in stems(thing[0]) | {thing[0]}:
                found.setdefault(stem, []).append(thing)
        return {stem: tuple(each) for stem, each in found.items()}

    def things_from(self, word: Word) -> tuple[Thing, ...]:
        """The things whose names may begin with a word, the longest names first."""
        found = [self._things_by_stem[stem] for stem in word.stems if stem in self._things_by_stem]
        if len(found) < 2:
            return found[0] if found else ()
        several = {each for things in found for each in things}
        return tuple(sorted(several, key=lambda each: (-len(each), each)))

    @cached_property
    def goals(self) -> tuple[Thing, ...]:
        """Where things may be that are there by a condition."""
        return tuple(dict.fromkeys(place for _, place in self.delivered))

    def lifts(self, thing: Thing) -> SymbolId | None:
        """The symbol for picking a thing up, or for having it."""
        return self.lifted.get(thing) or self.held.get(thing)

    def symbols(self, thing: Thing) -> tuple[SymbolId, ...]:
        """The symbols that a thing may stand for in an errand."""
        there = (symbol for (known, _), symbol in self.delivered.items() if known == thing)
        return tuple(dict.fromkeys(filter(None, (self.lifts(thing), *there))))

    @property
    def roles(self) -> frozenset[SymbolId]:
        """Symbols that are no places, whatever their type."""
        return frozenset((*self.laid.values(), *self.records.values()))

    def lays(self, thing: Thing) -> SymbolId | None:
        """The symbol for putting a thing down."""
        return self.laid.get(thing) or self.laid.get(())


def verb_at(said: Sequence[Word], index: int, manner: Manner) -> tuple[int, str] | None:
    """The end of the longest verb of a manner from a word on, and the particle it still needs."""
    own = said[index].stems
    begun = [phrase for phrase in VERBS[manner] if phrase[0] in own]
    for phrase in begun:
        rest = phrase[1:]
        if tuple(word.text for word in said[index + 1 : index + len(phrase)]) == rest:
            return index + len(phrase), ""
    for phrase in begun:
        if len(phrase) == 2 and phrase[1] in PARTICLES:
            return index + 1, phrase[1]
    return None


def noun_at(said: Sequence[Word], index: int, manner: Manner) -> int | None:
    """The word behind a noun of doing what a verb of a manner says: "delivery of"."""
    if index + 1 >= len(said) or said[index + 1].text != "of":
        return None
    own = said[index].text
    known = {phrase[0] for phrase in VERBS[manner] if len(phrase) == 1}
    made = own in known or any(own in nouns_of(verb) for verb in known)
    return index + 2 if made or (manner is Manner.LIFT and own == "pickup") else None


def _thing(said: Sequence[Word]) -> Thing:
    return tuple(word.number for word in said if word.text not in ARTICLES and not word.is_mark)


def _passive(said: Sequence[Word]) -> tuple[Sequence[Word], Sequence[Word]] | None:
    """The subject and what is said of it: "the item" and "put down" of "the item is put down"."""
    cut = next((i for i, word in enumerate(said) if i and word.text in ("is", "are", "was")), None)
    if cut is None:
        return None
    rest = said[cut + 1 :]
    return said[:cut], rest[1:] if rest and rest[0].text == "being" else rest


def _handled(landmark: Landmark, said: Sequence[Word], manner: Manner) -> Iterator[Thing]:
    """The object of a phrase whose verb is of a manner; () for none and for any thing."""
    passive = None if said and said[0].text == "to" else _passive(said)
    if passive is not None:
        subject, rest = passive
        verb = verb_at(rest, 0, manner) if rest else None
        if verb is not None and verb[0] == len(rest) and rest[0].text not in ("get", "take"):
            yield _object(subject)
        return
    if landmark.type is LandmarkType.CONDITION:
        return
    if said and said[0].text == "to":
        said = said[1:]
    verb = verb_at(said, 0, manner) if said else None
    if verb is None or said[0].stems != {said[0].text}:
        return
    rest = said[verb[0] :]
    if rest and (said[0].text, rest[-1].text) in VERBS[manner]:
        rest = rest[:-1]  # "put it down"
    if not any(word.text in SOURCES | GOALS for word in rest):
        yield _object(rest)


_OF_ANY = frozenset(("carried", "held", "loaded", "current", "carry", "hold", "own"))


def _object(said: Sequence[Word]) -> Thing:
    """A thing; () for any: "it", "the item", "the carried item", "what the robot carries"."""
    thing = _thing(said)
    if thing and (thing[0] in ("what", "whatever") or _OF_ANY.issuperset(thing[:-1])):
        return () if thing[0] in ("what", "whatever") or thing[-1] in ITEMS else thing
    return thing


def _lifted(landmark: Landmark, said: Sequence[Word]) -> Iterator[Thing]:
    for thing in _handled(landmark, said, Manner.LIFT):
        if thing and _noun(thing) is None:
            yield thing


def _laid(landmark: Landmark, said: Sequence[Word]) -> Iterator[Thing]:
    yield from _handled(landmark, said, Manner.LAY)


_THERE = frozenset(("in", "at", "on", "inside", "into", "to", "onto"))


def _delivered(landmark: Landmark, said: Sequence[Word]) -> Iterator[tuple[Thing, Thing]]:
    passive = _passive(said)
    if landmark.type is not LandmarkType.CONDITION or passive is None:
        return
    subject, rest = passive
    told = len(rest) > 1 and rest[0].text in _THERE and rest[-1].text not in _HANDS
    if told and not any(w.text == "not" for w in rest):
        yield _thing(subject), _thing(rest[1:])


_HANDS = frozenset(("hand", "hands", "gripper", "grip", "arm", "arms"))


def _held(landmark: Landmark, said: Sequence[Word]) -> Iterator[Thing]:
    """Read "the robot holds x", "x is in the hand"."""
    if landmark.type is not LandmarkType.CONDITION or any(w.text == "not" for w in said):
        return
    verb = next((i for i, w in enumerate(said) if i and w.stems & {"hold", "carry", "grip"}), None)
    if verb is not None and said[verb].text not in ("held", "carried"):
        before = [w.text for w in said[:verb] if w.text not in ARTICLES]
        thing = _thing(said[verb + 1 :])
        if before[:1] == ["robot"] and len(before) < 3 and thing and thing != ("nothing",):
            yield thing
        return
    passive = _passive(said)
    if passive is not None:
        subject, rest = passive
        in_hand = rest and rest[0].text in _THERE and rest[-1].text in _HANDS
        if in_hand or [w.text for w in rest] in (["held"], ["carried"]):
            yield _thing(subject)


def _by_every_name(
    delivered: Mapping[tuple[Thing, Thing], SymbolId], landmarks: Landmarks
) -> dict[tuple[Thing, Thing], SymbolId]:
    """The same, with a place under each of its names."""
    found = dict(delivered)
    for landmark in landmarks.values():
        if landmark.type is LandmarkType.LOCATION:
            names = [_thing(words(phrase)) for phrase in landmark.phrases]
            for (thing, place), symbol in delivered.items():
                if place in names:
                    for name in names:
                        found.setdefault((thing, name), symbol)
    return found


def _noun(thing: Thing) -> int | None:
    """The entry of `RECORDS` that a single noun is of."""
    if len(thing) != 1:
        return None
    return next((i for i, entry in enumerate(RECORDS) if thing[0] in entry), None)


def _record(said: Sequence[Word]) -> int | None:
    """Whether a phrase says that a record is taken: "take a photo", "a photo is taken", "photo"."""
    passive = _passive(said)
    if passive is not None:
        subject, rest = passive
        light = bool(rest) and bool(rest[0].stems & LIGHT) and len(rest) == 1
        return _noun(_thing(subject)) if light else None
    if said and said[0].text == "to":
        said = said[1:]
    if not said:
        return None
    own = _noun(_thing(said))
    if own is None and len(said) == 1:
        own = next((i for i, entry in enumerate(RECORDING) if said[0].text in entry), None)
    if own is None and said[0].stems & LIGHT:
        own = _noun(_thing(said[1:]))
    return own
