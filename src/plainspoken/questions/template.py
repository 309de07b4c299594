"""How an action of a domain is said: a verb, words, and the arguments that matter.

From a landmark (`to wash a mug`) the indefinite thing becomes the argument of its type. From
a PDDL name (`put-down`) the verb is the first word. In both cases the effects tell which further
arguments matter: where the robot goes, what lands where. What is plain from where the robot
stands is left out.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from plainspoken.questions.morphology import participle
from plainspoken.world.domain import (
    Action,
    AllOf,
    AtomCondition,
    Condition,
    changed_atoms,
)
from plainspoken.world.wording import spelled_out

if TYPE_CHECKING:
    from plainspoken.questions.lexicon import Lexicon

_SPEAKING = frozenset(
    [
        "alert",
        "ask",
        "call",
        "consult",
        "inform",
        "message",
        "notify",
        "phone",
        "query",
        "tell",
        "warn",
    ]
)
_PARTICLES = frozenset(
    [
        "about",
        "across",
        "after",
        "against",
        "along",
        "apart",
        "around",
        "aside",
        "at",
        "away",
        "back",
        "by",
        "down",
        "for",
        "forward",
        "from",
        "in",
        "into",
        "off",
        "on",
        "onto",
        "out",
        "over",
        "through",
        "to",
        "together",
        "under",
        "up",
        "upon",
        "with",
    ]
)
_PLACE = frozenset({"at", "in", "inside", "on", "onto", "into", "to", "near", "under"})


@dataclass(frozen=True, slots=True)
class Template:
    """`check` and then words and places of arguments, from 0."""

    verb: str
    parts: tuple[str | int, ...]


@dataclass(frozen=True, slots=True)
class _Shape:
    """What a schema needs, adds and deletes, over its own parameters."""

    needed: tuple[AtomCondition, ...]
    added: tuple[AtomCondition, ...]
    deleted: tuple[AtomCondition, ...]


def template_of(lexicon: Lexicon, name: str, said: str | None) -> Template:
    """How an action is said; `said` is its landmark's description, if it has one."""
    schemas = lexicon.problem.action(name)
    words = re.sub(r"^to ", "", said).split() if said else re.split(r"[-_]+", name)
    verb, rest = words[0].lower(), " ".join(words[1:])
    if not schemas:
        return Template(verb, (rest,) if rest else ())
    return _Writer(lexicon, schemas[0], verb, rest, from_landmark=said is not None).template()


class _Writer:
    """Fills one template; `mentioned` are the parameters it speaks of so far."""

    def __init__(
        self, lexicon: Lexicon, schema: Action, verb: str, rest: str, *, from_landmark: bool
    ) -> None:
        self._lexicon = lexicon
        self._names = [parameter.name for parameter in schema.parameters]
        self._schema = schema
        self._verb = verb
        # Where it goes is said by the arguments.
        rest = re.sub(r"(?:^| )(?:somewhere|around|about)$", "", rest)
        particle = not rest or rest.split(maxsplit=1)[0] in _PARTICLES
        self._rest = rest if from_landmark or particle else f"the {rest}"
        self._parts: list[str | int] = [self._rest] if rest else []
        self._from_landmark = from_landmark
        self._me = self._actor()
        self._shape = _Shape(
            tuple(_needed(schema.precondition)),
            tuple(atom for atom, added in changed_atoms(schema.effect) if added),
            tuple(atom for atom, added in changed_atoms(schema.effect) if not added),
        )
        self._context = {
            atom.terms[1]
            for atom in self._shape.needed
            if len(atom.terms) == 2
            and atom.terms[0] == self._me
            and atom not in self._shape.deleted
        }

    def _actor(self) -> str | None:
        """The parameter that is the robot that speaks."""
        for parameter in self._schema.parameters[:1]:
            fitting = self._lexicon.problem.objects_for(parameter)
            if self._lexicon.me in fitting or set(fitting) & set(self._lexicon.actors):
                return parameter.name
        return None

    @property
    def _mentioned(self) -> list[str]:
        return [self._names[part] for part in self._parts if isinstance(part, int)]

    def template(self) -> Template:
        for index, name in enumerate(self._names):
            if name != self._me:
                self._slot(index)
        moved = self._motion(self._me) if self._me else self._own_motion()
        # "To pick up" names nothing yet, "to ask a human" does.
        says_whom = not set(self._rest.split()) <= _PARTICLES
        spoken_to = says_whom and (self._from_landmark or self._verb in _SPEAKING)
        if not self._mentioned and not spoken_to:
            self._direct_object(moved)
        if moved and moved[1] not in self._mentioned:
            self._append("to", moved[1])
        for name in self._mentioned:
            self._placed(name, skip={self._me, *(moved or ())})
        if spoken_to and not self._mentioned and " to " not in self._rest:
            self._topic(moved)
        return Template(self._verb, tuple(self._parts))

    def _slot(self, index: int) -> None:
        """Put an argument where the words speak of one thing of its kind."""
        parameter = self._schema.parameters[index]
        objects = self._lexicon.problem.objects_for(parameter)
        literal = sorted({self._lexicon.object_words(o) for o in objects}, key=len, reverse=True)
        kinds = [
            " ".join(map(spelled_out, re.split(r"[-_]+", each)))
            for own in parameter.types
            for each in self._lexicon.type_chain(own)
        ]
        nouns = [rf"(?:(?:a|an|the|some|one) )?{re.escape(kind)}" for kind in kinds]
        if len(kinds) > 1:
            nouns.insert(0, rf"(?:(?:a|an|the|some) )?{re.escape(kinds[0])} {re.escape(kinds[1])}")
        for pattern in (*map(re.escape, literal), *nouns):
            for place, part in enumerate(self._parts):
                if not isinstance(part, str):
                    continue
                found = re.search(rf"(?<!\w){pattern}(?!\w)", part)
                if found:
                    before, after = part[: found.start()].strip(), part[found.end() :].strip()
                    new: list[str | int] = [before, index, after]
                    self._parts[place : place + 1] = [each for each in new if each != ""]
                    return

    def _motion(self, mover: str | None) -> tuple[str, str] | None:
        """From where to where something goes: one atom of it deleted, its twin added."""
        for gone in self._shape.deleted:
            for come in self._shape.added:
                if (
                    gone.predicate == come.predicate
                    and len(gone.terms) == len(come.terms) == 2
                    and gone.terms[0] == come.terms[0] == mover
                    and gone.terms[1] != come.terms[1]
                ):
                    return gone.terms[1], come.terms[1]
        return None

    def _own_motion(self) -> tuple[str, str] | None:
        """The same of a robot that is no object of the problem: `robot-in ?room`."""
        for gone in self._shape.deleted:
            for come in self._shape.added:
                same = gone.predicate == come.predicate and gone.terms != come.terms
                where = re.split(r"[-_]+", gone.predicate)[-1] in _PLACE
                if same and where and len(gone.terms) == len(come.terms) == 1:
                    return gone.terms[0], come.terms[0]
        return None

    def _direct_object(self, moved: tuple[str, str] | None) -> None:
        changed = [
            term
            for atom in (*self._shape.added, *self._shape.deleted)
            for term in atom.terms
            if term in self._names
        ]
        skipped = {self._me, *(moved or ())}
        if moved is None:
            for name in (*(n for n in self._names if n in changed), *self._names):
                if name not in skipped and (name in changed or name not in self._context):
                    self._parts.append(self._names.index(name))
                    return

    def _append(self, word: str, name: str) -> None:
        if name not in self._names:
            return  # A constant of the domain: the same every time, so it need not be said.
        last = self._parts[-1] if self._parts else ""
        if not (isinstance(last, str) and last.split()[-1:] == [word]):
            self._parts.append(word)
        self._parts.append(self._names.index(name))

    def _placed(self, name: str, skip: set[str | None]) -> None:
        """Say where a thing lands: `on the table`, `in box 2`."""
        moved = self._motion(name)
        for atom in self._shape.added:
            if len(atom.terms) != 2 or atom.terms[0] != name:
                continue
            where = atom.terms[1]
            word = re.split(r"[-_]+", atom.predicate)[-1]
            if where in skip or where in self._mentioned or where in self._context:
                continue
            if word in _PLACE:
                self._append("to" if moved and word == "at" else word, where)
            elif atom.predicate == participle(self._verb):
                self._append("to", where)  # `given ?medicine ?patient`, by giving it.

    def _topic(self, moved: tuple[str, str] | None) -> None:
        """Name the one thing that changes, where the landmark's words name none."""
        changed = [t for atom in (*self._shape.added, *self._shape.deleted) for t in atom.terms]
        for index, name in enumerate(self._names):
            parameter = self._schema.parameters[index]
            several = len(self._lexicon.problem.objects_for(parameter)) > 1
            if name in changed and several and name not in {self._me, *(moved or ())}:
                self._append("about" if self._verb in _SPEAKING else "for", name)
                return


def _needed(condition: Condition) -> Iterator[AtomCondition]:
    match condition:
        case AtomCondition():
            yield condition
        case AllOf(parts):
            for part in parts:
                yield from _needed(part)
        case _:
            return
