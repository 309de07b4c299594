"""What the objects of a problem are called, from their names and their types."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise

from plainspoken.world.domain import Action, Parameter
from plainspoken.world.inflection import doing, is_adjective, is_word, lemma, some, the
from plainspoken.world.role import Roles
from plainspoken.world.wording import Wording, abbreviates

_ORDINALS = (
    "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth",
)  # fmt: skip
_TITLES = frozenset(("mr", "mrs", "ms", "miss", "dr", "prof", "sir", "lady", "captain", "saint"))
_VOWELS = frozenset("aeiouy")
_PERSONS = frozenset(
    ("person", "human", "people", "visitor", "passenger", "customer", "worker", "operator", "user",
     "doctor", "player", "actor", "maid", "man", "woman", "child", "guest", "nurse", "patient",
     "employee", "student", "colleague", "clerk", "cook", "guide", "chef", "resident", "boss",
     "friend")
)  # fmt: skip
_ROLES = ("er", "or", "man", "lady", "woman", "ist", "ian", "ant", "ent", "ee", "boy", "girl")
"""How nouns end that tell what somebody does, and are no names: "the driver", not "driver"."""
_ANYTHING = frozenset(("obj", "object", "item", "thing", "o", "x"))
"""What any numbered thing is called where nobody cared for a name: `obj11` of type `package`."""


@dataclass(frozen=True)
class ObjectNames:
    """The ways to call each object of a problem."""

    roles: Roles
    wording: Wording
    _made: dict[str, tuple[str, ...]] = field(default_factory=dict, repr=False)

    def __getitem__(self, name: str) -> tuple[str, ...]:
        """An object's ways to be called, the best first."""
        if name not in self._made:
            self._made[name] = tuple(dict.fromkeys(self._called(name)))
        return self._made[name]

    def short(self, name: str) -> tuple[str, ...]:
        """At most two of them, as they are said beside other things: no type behind a name."""
        first, *others = self[name]
        own = set(first.split()) - {"the"}
        return (first, *(each for each in others if not own <= set(each.split())))[:2]

    def kinds(self, name: str) -> list[str]:
        """The types of an object, nearest first, and static predicates that stand for types."""
        problem = self.roles.problem
        found = []
        own = problem.objects[name]
        while own != "object" and own not in found:
            found.append(own)
            own = problem.domain.types.get(own, "object")
        return found + [each for each in self._static if f"{each} {name}" in problem.initial]

    def kind_words(self, name: str) -> frozenset[str]:
        """The words for the types of an object, as they stand in the names of predicates."""
        return frozenset(
            word
            for kind in self.kinds(name)
            for text in (self.wording.spaced(kind), self.wording.noun(kind))
            for word in text.lower().split()
        )

    @cached_property
    def _static(self) -> tuple[str, ...]:
        problem = self.roles.problem
        changing = problem.changing_predicates
        return tuple(
            predicate
            for predicate, parameters in problem.domain.predicates.items()
            if len(parameters) == 1 and predicate not in changing
        )

    def of_kind(self, kind: str) -> tuple[str, ...]:
        """The objects of a type, or of a static predicate that stands for one."""
        problem = self.roles.problem
        return problem.objects_for(Parameter("?", (kind,))) or tuple(
            name for name in problem.objects if f"{kind} {name}" in problem.initial
        )

    def any_of(self, kind: str) -> str:
        """One of a type, whichever: "a line", "the box" where there is one only."""
        word = self.wording.noun(kind)
        return the(word) if len(self.of_kind(kind)) == 1 else some(word)

    def kinds_for(self, schema: Action, parameter: Parameter) -> tuple[str, ...]:
        """The types that a parameter takes; in a domain without, what all that fit are called."""
        typed = tuple(each for each in parameter.types if each != "object")
        if typed:
            return typed
        shared = [self.kinds(name) for name in self.roles.possible.fitting(schema, parameter)]
        first = shared[0] if shared else []
        return tuple(kind for kind in first if all(kind in each for each in shared))[:1]

    def _called(self, name: str) -> Iterator[str]:
        kinds = self.kinds(name)
        coded = tuple(self._coded(name, kinds))
        yield from coded
        plain = self._proper(name)
        common = self._is_common(plain, name)
        if coded and not common and len(name) > 3:
            plain = ""  # nobody says "tru1" for truck 1
        with_kind = self._with_kind(name, plain, kinds, common=common)
        if common and is_adjective(plain.split()[-1]):
            yield from with_kind  # "the left gripper"
        if common:
            yield from self._turned(plain, kinds)
            yield the(plain)
        if name in self.roles.agents:
            yield from self._agent(kinds)
        if plain and not common:
            yield plain
        yield from with_kind
        yield from (the(self.wording.noun(kind)) for kind in kinds[:1] if self._is_alone(kind))
        yield from self._counted(name, kinds)

    def _with_kind(
        self, name: str, plain: str, kinds: list[str], *, common: bool
    ) -> tuple[str, ...]:
        """A name beside its type: "the tomato plant", "nurse Joy"."""
        if not plain or any(letter.isdigit() for letter in name) or (
            common and self._is_person(kinds)
        ):  # fmt: skip
            return ()
        own = {lemma(word) for word in plain.lower().split()}
        return tuple(
            f"the {plain} {word}" if common else f"{word} {plain}"
            for word in map(self.wording.noun, kinds[:1])
            if is_word(word.split()[-1]) and not set(word.split()) & own
        )

    def _turned(self, plain: str, kinds: list[str]) -> Iterator[str]:
        """Say "the east ward" of what is written as a ward, east."""
        noun, _, quality = plain.partition(" ")
        if is_adjective(quality) and any(noun == self.wording.noun(kind) for kind in kinds):
            yield f"the {quality} {noun}"
            yield plain

    def _proper(self, name: str) -> str:
        """An object's name as one writes it: "Mr Smith", "gate A", "AGV 2", "front door"."""
        words = [self.wording.noun(word) for word in self.wording.spaced(name).split()]
        own = name in self.roles.agents or self._is_person(self.kinds(name))
        if own and not (len(words) > 1 and words[-1].endswith(_ROLES)):
            # "Gusteau" is not run together
            words = self.wording.marked(name).split()
            words = [
                word.upper()
                if word.isalpha() and word not in _TITLES and not set(word) & _VOWELS
                else word
                for word in words
            ]
        numbered = any(letter.isdigit() for letter in name)
        named = all(len(word) > 1 for word in words) and not self._is_common(" ".join(words), name)
        return " ".join(words if numbered else (_capital(word, named=named) for word in words))

    def _coded(self, name: str, kinds: list[str]) -> Iterator[str]:
        """A type with a number or a letter: "line 3" of `l3`, "room A" of `rooma`."""
        number = re.fullmatch(r"([a-z]*?)[-_]?(\d+)", name)
        for kind in kinds:
            word = self.wording.noun(kind)
            short = re.sub(r"[-_]?\d+$", "", name) or name
            letter = re.fullmatch(rf"(?:{re.escape(kind)}[-_]?)?([a-z])", name)
            if number and (not number[1] or abbreviates(number[1], kind) or number[1] in _ANYTHING):
                if kind != kinds[0] and not is_word(word.split()[-1]):
                    continue
                if self._is_alone(kind):
                    yield f"the {word}"
                yield f"{word} {number[2]}"
            elif self._is_alone(kind) and abbreviates(short, kind):
                yield f"the {word}"
            elif letter:
                yield f"{word} {letter[1].upper()}"
        if not kinds and re.fullmatch("[a-z]", name) and self.only_noun:
            yield f"{self.only_noun} {name.upper()}"

    @cached_property
    def only_noun(self) -> str | None:
        """In a domain without types, what all its things are: blocks, in a world of blocks."""
        problem = self.roles.problem
        words = self.wording.spaced(problem.domain.name).split()
        numbered = [re.match(r"[a-z]{3,}(?=[-_]?\d+$)", name) for name in problem.objects]
        nouns = [found[0] for found in numbered if found] + [lemma(word) for word in words[:1]]
        return next((noun for noun in nouns if is_word(noun)), None)

    def _agent(self, kinds: list[str]) -> Iterator[str]:
        """The only one of its kind by that kind: "the support robot", "the lifting robot"."""
        for kind, above in pairwise(kinds):
            if self._is_alone(kind):
                own, robot = self.wording.noun(kind), self.wording.noun(above)
                yield f"the {own} {robot}"
                if (gerund := doing(own)) is not None:
                    yield f"the {gerund} {robot}"

    def _counted(self, name: str, kinds: list[str]) -> Iterator[str]:
        """Say "the second aisle" where counting begins with one."""
        number = re.fullmatch(r"([a-z]+)([-_]?)(\d+)", name)
        objects = self.roles.problem.objects
        if not number or f"{number[1]}{number[2]}0" in objects:
            return
        for kind in kinds[:1]:
            word, value = self.wording.noun(kind), int(number[3])
            alike = [each for each in self.of_kind(kind) if re.search(rf"\D{value}$", each)]
            if alike != [name] or self._is_alone(kind):
                continue
            stem = self.wording.noun(number[1])
            ordinal = _ORDINALS[value - 1] if 1 <= value <= len(_ORDINALS) else None
            if ordinal:
                yield f"the {ordinal} {word}"
            if not abbreviates(number[1], kind) and is_word(stem):
                if ordinal:
                    yield f"the {ordinal} {stem}"
                yield f"{word} {value}"

    def _is_alone(self, kind: str) -> bool:
        return len(self.of_kind(kind)) == 1

    def _is_person(self, kinds: list[str]) -> bool:
        words = {word for kind in kinds for word in self.wording.noun(kind).split()}
        return bool(words & _PERSONS)

    def _is_common(self, plain: str, name: str) -> bool:
        """Whether a name is a common noun, which takes an article: "the pantry"."""
        words = plain.lower().split()
        if not all(word.isalpha() and len(word) > 1 and is_word(word) for word in words):
            return False
        if words[0] in _TITLES or any(not lemma(word)[0].islower() for word in words):
            return False
        kinds = self.kinds(name)
        if name not in self.roles.agents and not self._is_person(kinds):
            return len(plain) > 2
        # Robots and people are called by names of their own, dictionary words or not.
        own = {word for kind in kinds for word in self.wording.noun(kind).split()}
        return words[-1] in own or (words[-1].endswith(_ROLES) and len(words[-1]) > 3)


def _capital(word: str, *, named: bool) -> str:
    """A word of a name as one writes it: initials and names of their own in capitals."""
    if len(word) == 1 and word.isalpha():
        return word.upper()
    return word.capitalize() if named and word.islower() else word
