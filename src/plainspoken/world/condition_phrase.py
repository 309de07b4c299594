"""What is said when a predicate holds: "bin 2 is stored in shelf A" for `stored-in bin2 shelf-a`.

Which word is the subject, which the verb, and what the arguments are to each other follow from the
kind of each word and its place in the name.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from plainspoken.world.inflection import (
    COPULAS,
    PARTICLES,
    RELATIONS,
    gerund,
    is_adjective,
    is_gerund,
    is_holding,
    is_idiom,
    is_participle,
    is_plural,
    is_state,
    is_stative,
    is_third_person,
    is_verb,
    lemma,
    related,
    some,
    the,
    third_person,
    whereabouts,
)
from plainspoken.world.object_name import ObjectNames
from plainspoken.world.role import ATTRIBUTES, Roles
from plainspoken.world.wording import Wording

_AUXILIARIES = frozenset(("can", "must", "may", "should"))
_HAVING = frozenset(("has", "have", "had"))
_FILLERS = frozenset(("obj", "object"))
_JOINED_BY_TO = frozenset(
    ("connected", "attached", "linked", "assigned", "tied", "joined", "delivered", "sent", "moved",
     "given", "addressed", "mapped", "docked", "allocated", "promised", "reported", "shown")
)  # fmt: skip
"""Participles with "to" behind; the others are "with" something, "at" a place, "by" a robot."""
_DONE_BY = frozenset(
    ("inspected", "seen", "visited", "owned", "guarded", "carried", "held", "used")
)


@dataclass(frozen=True, slots=True)
class Clause:
    """A small sentence: "bin 2", "is", "full"."""

    subject: str
    verb: str
    rest: str = ""

    def said(self) -> str:
        several = " of " not in self.subject and is_plural(self.subject.split()[-1])
        verb = {"is": "are", "has": "have"}.get(self.verb, self.verb) if several else self.verb
        return " ".join(filter(None, (self.subject, verb, self.rest)))

    def denied(self) -> str:
        if self.verb in (*COPULAS, "can"):
            return " ".join(filter(None, (self.subject, self.verb, "not", self.rest)))
        plain = "have" if self.verb in _HAVING else lemma(self.verb)
        return " ".join(filter(None, (self.subject, "does not", plain, self.rest)))


@dataclass(frozen=True)
class ConditionPhrases:
    """The ways to say the atoms of a problem."""

    roles: Roles
    wording: Wording
    names: ObjectNames

    def of(self, predicate: str, arguments: Sequence[str]) -> tuple[str, ...]:
        """The ways to say that an atom is true, the best first."""
        words = self.wording.spaced(predicate).split()
        denied = words[:1] == ["not"] and len(words) > 1
        words = words[1:] if denied else words
        if words[0] in COPULAS and len(words) > 1:
            words = words[1:]
            if len(words) > 1 and len(arguments) == 1 and not any(map(is_state, words)):
                words = some(" ".join(words)).split()  # `is-focal-point`
        clauses = dict.fromkeys(
            (*self._clauses(words, predicate, arguments), *self._in_hand(words, arguments))
        )
        ways = (each.denied() if denied else each.said() for each in clauses)
        return tuple(dict.fromkeys(ways))

    def _clauses(
        self, words: list[str], predicate: str, arguments: Sequence[str]
    ) -> Iterator[Clause]:
        if not arguments:
            yield from _of_none(words)
            return
        one, *others = arguments
        plain = all(word not in RELATIONS | _HAVING for word in words) and len(words) > 1
        plain = plain and not _is_predicate(words, frozenset())
        if not others and plain and len(self.roles.possible.of(predicate)) == 1:
            yield from _of_none(words)
        for called in self._called(one, others):
            if not others:
                yield from self._of_one(words, one, called)
            elif len(others) == 1:
                yield from self._of_two(words, predicate, (one, others[0]), called)
            else:
                yield self._of_several(words, one, others, called)

    def _called(self, one: str, others: Sequence[str]) -> tuple[str, ...]:
        """What the first argument is called; the only robot is "the robot" as well."""
        found = self.names[one][: 2 if others else 4]
        return (*found[:2], "the robot") if one == self.roles.only_agent else found

    def _in_hand(self, words: list[str], arguments: Sequence[str]) -> Iterator[Clause]:
        """What the only robot has is "in the hand" as well."""
        match arguments:
            case (robot, thing) if robot == self.roles.only_agent and thing in self.roles.carried:
                holds = len(words) == 1 and (is_holding(words[0]) or words[0] in _HAVING)
                # Where a gripper has a state of its own, "hand" would be another word for it.
                if holds and "gripper" not in self.wording.spoken:
                    yield Clause(self.names[thing][0], "is", "in the hand")

    # One argument.

    def _of_one(self, words: list[str], one: str, called: str) -> Iterator[Clause]:
        first, last = words[0], words[-1]
        kinds = self.names.kind_words(one)
        rest = " ".join(words[1:])
        own = self._without_kind(words, kinds)
        if first in ("a", "an"):
            yield Clause(called, "is", " ".join(words))
        elif words in (["position"], ["location"]):
            yield Clause("the robot", "is", f"{whereabouts('at', called)} {called}")
        elif first in _HAVING:
            yield _having(called, words[1:]) if rest else Clause("the robot", "has", called)
        elif first in _AUXILIARIES:
            yield Clause(called, first, rest)
        elif first in RELATIONS and len(words) > 1:
            yield self._related(words, one, called)
        elif last in ("at", "in") and len(words) > 1 and not is_participle(words[-2]):
            yield Clause(the(" ".join(words[:-1])), "is", f"{last} {called}")  # `spare-in n1`
        elif _is_predicate(words, kinds):
            yield Clause(called, first, rest)
            if not is_stative(first) and (ending := gerund(lemma(first))):
                yield Clause(called, "is", f"{ending} {rest}".strip())
        elif len(words) == 1 and is_holding(first) and one not in self.roles.agents:
            yield Clause("the robot", "is", f"{gerund(lemma(first)) or first} {called}")
        elif own != words and own:
            yield Clause(called, "is", " ".join(own))
        elif (
            len(words) == 1
            or (is_participle(first) and all(word in PARTICLES for word in words[1:]))
            or (is_state(first) and any(word in RELATIONS for word in words[1:]))
        ):
            yield Clause(called, "is", " ".join(words))
        else:
            noun, state = _noun_and_state(words)
            verb = "are" if is_plural(noun.split()[-1]) else "is"
            yield Clause(f"the {noun} of {called}", verb, state)
            if last == noun.split()[-1] and is_adjective(state):
                yield Clause(called, "has", some(f"{state} {noun}"))

    def _related(self, words: list[str], one: str, called: str) -> Clause:
        """Say "the sample is at waypoint 1" of a place, "the pan is on fire" of anything else."""
        noun = " ".join(words[1:])
        if one in self.roles.places and not is_idiom(words[0], noun):
            return Clause(the(noun), "is", f"{words[0]} {called}")
        return Clause(called, "is", related(words[0], noun))

    @staticmethod
    def _without_kind(words: list[str], kinds: frozenset[str]) -> list[str]:
        """The words of `vial-broken vial1` that the name of the argument does not say."""
        if len(words) > 1 and words[0] in kinds:
            return [word for word in words if word not in kinds]
        return words[:-1] if len(words) > 1 and words[-1] in kinds and is_state(words[0]) else words

    # Two.

    def _of_two(
        self, words: list[str], predicate: str, both: tuple[str, str], called: str
    ) -> Iterator[Clause]:
        one, other = both
        if words[-1] not in RELATIONS and self._is_only(predicate, both):
            yield from self._of_one(words, one, called)
            if other in self.roles.places and is_participle(words[-1]):
                return
        for second in self._objects_called(other):
            yield from self._between(words, both, called, second)

    def _objects_called(self, other: str) -> tuple[str, ...]:
        found = self.names.short(other)
        return (*found, "you") if other == self.roles.only_agent else found

    def _is_only(self, predicate: str, both: tuple[str, str]) -> bool:
        """Whether a predicate holds of the first argument with no other but this one."""
        own = [each for each in self.roles.possible.of(predicate) if each[0] == both[0]]
        return len(own) == 1 and both[1] in (*self.roles.places, *self.roles.agents)

    def _between(
        self, words: list[str], both: tuple[str, str], called: str, second: str
    ) -> Iterator[Clause]:
        one, other = both
        kinds, others = self.names.kind_words(one), self.names.kind_words(other)
        said = [word for word in words if word not in _FILLERS] or words
        said = [word for word in said if word not in kinds] or said
        first, last = said[0], said[-1]
        if first in _HAVING:
            if not set(said[1:]) - others and one in self.roles.agents and (
                other in self.roles.carried
            ):  # fmt: skip
                yield Clause(called, "has", second)
                yield Clause(called, "is", f"holding {second}")
                return
            yield from self._possession(said[1:], called, second, others)
        elif first in _AUXILIARIES:
            yield Clause(called, first, " ".join([*said[1:], second]))
        elif last in RELATIONS:
            yield from self._placed(said, called, second)
        elif first in RELATIONS:
            noun = " ".join(word for word in said[1:] if word not in others)
            where = whereabouts(first, second)
            yield Clause(called, "is", f"{first} the {noun} of {second}" if noun
                         else f"{where} {second}")  # fmt: skip
        elif last.endswith(ATTRIBUTES):
            yield Clause(f"the {' '.join(said)} of {called}", "is", second)
        elif is_gerund(first):
            yield Clause(called, "is", " ".join([*said, second]))
        elif is_third_person(first) or is_verb(first):
            yield from self._verb(said, both, called, second)
        elif is_participle(last) or is_adjective(last):
            noun = " ".join(said[:-1])
            subject = f"the {noun} of {called}" if noun else called
            yield Clause(subject, "is", f"{last} {self._joint(last, other, second)} {second}")
        elif is_participle(first):
            noun = " ".join(said[1:])
            verb = "are" if is_plural(said[-1]) else "is"
            yield Clause(f"the {_bare(second)} {noun} of {called}", verb, first)
            yield Clause(f"the {noun} of {called}", verb, f"{first} in {second}")
        else:
            noun = " ".join(said)
            yield Clause(f"the {noun} of {called}", "is", second)

    def _joint(self, participle: str, other: str, second: str) -> str:
        if participle in _JOINED_BY_TO:
            return "to"
        if other in self.roles.agents and participle in _DONE_BY:
            return "by"
        return whereabouts("at", second) if other in self.roles.places else "with"

    def _possession(
        self, words: list[str], called: str, second: str, others: frozenset[str]
    ) -> Iterator[Clause]:
        """`has c p`, `has-seen v p`, `has-medicine r m`, `have-soil-analysis r w`."""
        if not words or set(words) <= others:
            yield Clause(called, "has", second)
        elif is_participle(words[0]):
            yield Clause(called, "has", " ".join([*words, second]))
        else:
            yield Clause(called, "has", f"{the(' '.join(words))} of {second}")

    def _placed(self, words: list[str], called: str, second: str) -> Iterator[Clause]:
        """`at b l`, `stored-in b s`, `stands-at c s`, `knows-name-of g v`."""
        *rest, relation = words
        if not rest:
            yield Clause(called, "is", f"{whereabouts(relation, second)} {second}")
        elif is_third_person(rest[0]):
            noun = f" the {' '.join(rest[1:])}" if rest[1:] and relation == "of" else ""
            more = noun or "".join(f" {word}" for word in rest[1:])
            yield Clause(called, rest[0], f"{more.strip()} {relation} {second}".strip())
            if not noun and not is_stative(rest[0]) and (ending := gerund(lemma(rest[0]))):
                yield Clause(called, "is", f"{ending}{more} {relation} {second}")
            if not noun and relation in ("at", "in", "on"):
                yield Clause(called, "is", f"{relation} {second}")
        else:
            yield Clause(called, "is", " ".join([*rest, relation, second]))
            if relation in ("at", "in", "on") and is_gerund(rest[0]):
                yield Clause(called, "is", f"{relation} {second}")

    def _verb(
        self, words: list[str], both: tuple[str, str], called: str, second: str
    ) -> Iterator[Clause]:
        """`carries v b`, `follows v g`; of `carry ball gripper` it is the second that carries."""
        one, other = both
        base, rest = lemma(words[0]), " ".join(words[1:])
        if is_holding(base) and one in self.roles.carried and other not in self.roles.carried:
            yield Clause(second, "is", f"{gerund(base) or base} {called}")
            yield Clause(called, "is", f"in {second}")
            return
        if other in self.roles.places and not rest:
            # `lies parcel hangar`: the place is where, not what
            yield from self._placed([third_person(base), whereabouts("at", second)], called, second)
            return
        yield Clause(called, third_person(base), f"{rest} {second}".strip())
        if not is_stative(base) and (ending := gerund(base)):
            yield Clause(called, "is", f"{ending} {rest} {second}".replace("  ", " "))

    # More.

    def _of_several(self, words: list[str], one: str, others: Sequence[str], called: str) -> Clause:
        named = [self.names[other][0] for other in others]
        kinds = self.names.kind_words(one)
        words = [word for word in words if word not in kinds] or words
        tail = " and ".join(named)
        if words[0] in _HAVING:
            first, *more = named
            noun = " ".join([*map(_bare, more), *words[1:]])
            return Clause(called, "has", f"the {noun} of {first}" if words[1:] else tail)
        verb = third_person(lemma(words[0]))
        if is_third_person(words[0]) or is_verb(words[0]):
            return Clause(called, verb, " ".join([*words[1:], tail]))
        if one in self.roles.agents and is_gerund(words[0]):
            return Clause(called, "is", " ".join([*words, tail]))
        return replace(Clause(called, "is"), rest=" ".join([*words, tail]))


def _is_predicate(words: list[str], kinds: frozenset[str]) -> bool:
    """Whether a name begins with a verb: "needs cleaning", and not "lights off"."""
    first, *rest = words
    if first in kinds or not is_third_person(first):
        return False
    return is_stative(first) or not rest or not is_state(rest[0])


def _having(called: str, words: list[str]) -> Clause:
    """`has-flat-tyre`, `has-finished`."""
    if is_participle(words[0]) and not is_adjective(words[0]):
        return Clause(called, "has", " ".join(words))
    return Clause(called, "has", some(" ".join(words)))


def _of_none(words: list[str]) -> Iterator[Clause]:
    """What is said without naming of what: `stove-on` is "the stove is on"."""
    verb = next((place for place, word in enumerate(words) if place and word in COPULAS), None)
    if verb is not None:
        yield Clause(the(" ".join(words[:verb])), words[verb], " ".join(words[verb + 1 :]))
    elif words[0] in _HAVING and words[1:]:
        yield _having("the robot", words[1:])
    elif words[0] in _AUXILIARIES:
        yield Clause("the robot", words[0], " ".join(words[1:]))
    elif is_holding(words[0]) and words[1:]:
        held = the(" ".join(words[1:]))
        yield Clause("the robot", "is", f"{gerund(lemma(words[0])) or words[0]} {held}")
    elif words[0] in RELATIONS and words[1:]:
        yield Clause("the robot", "is", related(words[0], " ".join(words[1:])))
    elif len(words) == 1 and not (is_state(words[0]) or words[0].endswith("y")):
        yield Clause("there", "is", some(words[0]))
    elif len(words) == 1 or (is_state(words[0]) and set(words[1:]) <= PARTICLES):
        yield Clause("it", "is", " ".join(words))
    else:
        noun, state = _noun_and_state(words)
        yield Clause(the(noun), "are" if is_plural(noun.split()[-1]) else "is", state)


def _noun_and_state(words: list[str]) -> tuple[str, str]:
    """Who or what, and how it is: of "hand empty" as well as of "empty hand"."""
    first, last = words[0], words[-1]
    state = is_adjective(first) or is_participle(first)
    if state and not (is_state(last) and not is_plural(last)):
        return " ".join(words[1:]), first
    for place in range(1, len(words) - 1):  # "engine out of fuel"
        if words[place] in RELATIONS | PARTICLES:
            return " ".join(words[:place]), " ".join(words[place:])
    return " ".join(words[:-1]), last


def _bare(words: str) -> str:
    return words.removeprefix("the ")
