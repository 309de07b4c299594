"""What an action is called: "unload a package from truck 1" for `unload-truck ?p ?t ?l`.

The name of an action has a verb, perhaps its particle, and perhaps a noun: of what it is done to,
or of something that no argument stands for (`make-bed`). Effects tell how other things belong in.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import islice

from plainspoken.world.domain import Action, Parameter, changed_atoms
from plainspoken.world.inflection import (
    PARTICLES,
    RELATIONS,
    is_state,
    some,
    the,
    third_person,
    whereabouts,
)
from plainspoken.world.object_name import ObjectNames
from plainspoken.world.reachability import required
from plainspoken.world.role import Roles
from plainspoken.world.wording import Wording

_INTO = {"in": "into", "on": "onto", "inside": "into", "at": "to"}
_ROBOTS = frozenset(("robot", "machine", "bot", "agent"))
Filling = Mapping[str, str]
"""The words for some arguments of an action, by the name of the parameter."""


@dataclass(frozen=True)
class ActionPhrases:
    """The ways to say what the actions of a problem do, without "to"."""

    roles: Roles
    wording: Wording
    names: ObjectNames

    def general(self, schema: Action) -> tuple[str, ...]:
        """Any instance of an action, the best way first: "harvest a grape"."""
        words = self.wording.verbal(schema.name).split()
        ways = dict.fromkeys((self.filled(schema, {}), *self._with_others(schema)))
        plain = " ".join(words[:-1] if self._leads_on(schema, words) else words)
        if plain not in map(_bare, ways):
            ways.setdefault(plain)
        return (*ways, *self._with_parent(schema))

    def by(self, schema: Action, robot: str, filling: Filling) -> tuple[str, ...]:
        """An action as it is told of a robot: "cart 1 drives", "drive with cart 1"."""
        plain = self.filled(schema, filling, but=robot)
        called = self.names[robot]
        ways = [plain]
        short = self._short(schema)
        if short is not None and not filling:
            ways.append(short)
        told = tuple(
            f"{name} {third_person(verb)} {rest}".strip()
            for verb, _, rest in (way.partition(" ") for way in ways)
            for name in called
        )
        bare = (f"to {ways[-1]} {called[0]}",) if set(ways[-1].split()[1:]) <= PARTICLES else ()
        return (f"to {plain} with {called[0]}", *told, *bare)

    def at(self, schema: Action, parameter: Parameter, called: str) -> Iterator[str]:
        """An action with one argument that is known; where it is done, without what to, as well."""
        yield self.filled(schema, {parameter.name: called})
        short = self._short(schema)
        setting = self.roles.is_setting(schema, parameter)
        if short is not None and " " not in short and setting and self._object(schema, []):
            yield f"{short} {whereabouts('at', called)} {called}"

    def _short(self, schema: Action) -> str | None:
        """The verb alone, where the name of an action has no noun: "photograph", "fly"."""
        words = self.wording.verbal(schema.name).split()
        verb, rest = _verb(words[:-1] if self._leads_on(schema, words) else words)
        return None if rest else " ".join(verb)

    def filled(self, schema: Action, filling: Filling, but: str | None = None) -> str:
        """An action's words with what is known of its arguments.

        but: a robot that is not to be named again
        """
        words = self.wording.verbal(schema.name).split()
        leads_on = self._leads_on(schema, words)
        said, rest = _verb(words[:-1] if leads_on else words)
        used: list[Parameter] = []
        if (named := self._named(schema, rest)) is not None:
            noun, used = self._noun(schema, named, rest, filling)
            own = but is not None and but in self.roles.possible.fitting(schema, named)
            said = said if own else [*said, *noun]
        elif rest:
            said = [*said, " ".join(rest) if leads_on else the(" ".join(rest))]
        if leads_on or not rest:
            last = self._object(schema, used) or (None if leads_on else self._changed(schema))
            joint = words[-1:] if leads_on else []
            if last is not None:
                used.append(last)
                said = [*said, *joint, self._filling(schema, last, filling)]
            elif not leads_on:
                said = [*said, *islice(self._subject_changed(schema), 1)]
            elif not any(p.name in filling for p in schema.parameters):
                said = [*said, "somewhere"]
        return " ".join((*said, *self._also(schema, used, filling)))

    def _noun(
        self, schema: Action, named: Parameter, rest: list[str], filling: Filling
    ) -> tuple[list[str], list[Parameter]]:
        """The noun of a name that stands for an argument, and the arguments that it tells."""
        noun = [self._filling(schema, named, filling), *self._beside(schema, named, rest)]
        held = self._held(schema, named, filling)
        if held is None:
            return noun, [named]
        joint = self._relation(schema, named, [held], noun[0])
        return [filling[held.name], joint, *noun], [named, held]

    def _also(self, schema: Action, used: list[Parameter], filling: Filling) -> Iterator[str]:
        """What is known of the arguments that are not in the words yet: "at the gate"."""
        for parameter in schema.parameters:
            if parameter.name in filling and parameter not in used:
                words = filling[parameter.name]
                yield f"{self._relation(schema, parameter, used, words)} {words}"

    def _relation(
        self, schema: Action, parameter: Parameter, used: list[Parameter], words: str
    ) -> str:
        if all(o in self.roles.places for o in self.roles.possible.fitting(schema, parameter)):
            return whereabouts("at", words)
        for atom, added in changed_atoms(schema.effect):
            relation = self.wording.spaced(atom.predicate).split()[-1]
            pair = [other for other in used if other.name in atom.terms]
            if len(atom.terms) == 2 and parameter.name in atom.terms and pair:
                if relation in RELATIONS:
                    return _INTO.get(relation, relation) if added else "from"
                return "with" if added else "from"
        if self.roles.is_setting(schema, parameter):
            return whereabouts("at", words)
        for needed in required(schema.precondition):
            relations = [
                word for word in self.wording.spaced(needed.predicate).split() if word in RELATIONS
            ]
            if needed.terms[1:] == (parameter.name,) and relations:
                return relations[-1]
        return "of" if not used else "with"

    def _held(self, schema: Action, named: Parameter, filling: Filling) -> Parameter | None:
        """What goes into or out of what a name speaks of: the package of `load-truck`."""
        return next(
            (
                parameter
                for parameter in schema.parameters
                for atom, _ in changed_atoms(schema.effect)
                if parameter.name in filling
                and atom.terms == (parameter.name, named.name)
                and set(self.wording.spaced(atom.predicate).split()) & RELATIONS
            ),
            None,
        )

    def _leads_on(self, schema: Action, words: list[str]) -> bool:
        """Whether a name ends in a preposition to which something belongs: `fly-to`."""
        if len(words) < 2 or words[-1] not in RELATIONS:
            return False
        return words[-1] not in PARTICLES or self.roles.moves(schema)

    def _named(self, schema: Action, rest: list[str]) -> Parameter | None:
        """The parameter that a name's noun speaks of: `?p - parcel` in `deliver-parcel`."""
        return next(
            (
                parameter
                for parameter in schema.parameters
                if any(set(self._own(kind)) & set(rest) for kind in self._kinds(schema, parameter))
            ),
            None,
        )

    def _kinds(self, schema: Action, parameter: Parameter) -> tuple[str, ...]:
        own = self.names.kinds_for(schema, parameter)
        types = self.roles.problem.domain
        return tuple(dict.fromkeys(a for kind in own for a in types.ancestors(kind) if a in
                                   (*types.types, *own)))  # fmt: skip

    def _own(self, kind: str) -> tuple[str, ...]:
        return tuple(self.wording.spaced(kind).split())

    def _beside(self, schema: Action, named: Parameter, rest: list[str]) -> Iterator[str]:
        """The other words of a name's noun phrase."""
        known = {word for kind in self._kinds(schema, named) for word in self._own(kind)}
        others = [word for word in rest if word not in known]
        if others:
            yield " ".join(others)

    def _filling(self, schema: Action, parameter: Parameter, filling: Filling) -> str:
        if parameter.name in filling:
            return filling[parameter.name]
        fitting = tuple(self.roles.possible.fitting(schema, parameter))
        kinds = self.names.kinds_for(schema, parameter)
        if len(fitting) == 1:
            return self.names[fitting[0]][0]
        if kinds:
            return self.names.any_of(kinds[0])
        return some(self.names.only_noun) if self.names.only_noun else "something"

    def things(self, schema: Action) -> list[Parameter]:
        """What an action is done to: no robots, and no places to go to."""
        return [p for p in schema.parameters if not self.roles.is_setting(schema, p)]

    def _object(self, schema: Action, used: list[Parameter]) -> Parameter | None:
        left = [p for p in self.things(schema) if p not in used]
        kinds = [p for p in left if self._kinds(schema, p)]
        return next(iter(kinds or left), None)

    def _changed(self, schema: Action) -> Parameter | None:
        """What something becomes so of, or not so, that is said of it alone; no robot."""
        changed = {
            atom.terms
            for atom, _ in changed_atoms(schema.effect)
            if atom.predicate not in self.roles.motions
        }
        return next(
            (
                p
                for p in schema.parameters
                if (p.name,) in changed
                and not any(o in self.roles.mobile for o in self.roles.possible.fitting(schema, p))
            ),
            None,
        )

    def _subject_changed(self, schema: Action) -> Iterator[str]:
        """What an action changes and nothing else: `floor-wet` of `mop` is "the floor"."""
        changed = {atom.predicate for atom, _ in changed_atoms(schema.effect)}
        for predicate in changed if len(changed) == 1 else ():
            parameters = self.roles.problem.domain.predicates[predicate]
            words = self.wording.spaced(predicate).split()
            own = all(name in self.roles.mobile for p in parameters for name in
                      self.roles.problem.objects_for(p))  # fmt: skip
            if not own or len(words) != 2 or set(words) & RELATIONS:
                continue
            noun = [word for word in words if not is_state(word)] or words[:1]
            yield the(noun[0])

    def _with_others(self, schema: Action) -> Iterator[str]:
        """The same words with one more thing: "load a package into a truck"."""
        plain = {p.name: self._filling(schema, p, {}) for p in self.things(schema)}
        if len(plain) > 1:
            for name, words in islice(plain.items(), 2):
                longer = self.filled(schema, {name: words})
                if longer != self.filled(schema, {}):
                    yield longer
        for parameter in schema.parameters:
            fitting = tuple(self.roles.possible.fitting(schema, parameter))
            if len(fitting) == 1 and parameter in self.things(schema):
                for called in self.names[fitting[0]][1:2]:
                    yield self.filled(schema, {parameter.name: called})

    def _with_parent(self, schema: Action) -> Iterator[str]:
        """The same words with a type's parent behind the type: "call the support robot"."""
        types = self.roles.problem.domain.types
        words = self.filled(schema, {})
        for kind in self.wording.spaced(schema.name).split():
            above = types.get(kind, "object")
            if above in _ROBOTS and kind in words.split():
                said = (
                    f"{word} {self.wording.noun(above)}" if word == kind else word
                    for word in words.split()
                )
                yield " ".join(said)


def _verb(words: list[str]) -> tuple[list[str], list[str]]:
    """The verb with its particles, and what follows."""
    end = 1
    while end < len(words) and words[end] in PARTICLES | RELATIONS:
        end += 1
    return words[:end], words[end:]


def _bare(words: str) -> str:
    return " ".join(word for word in words.split() if word not in ("a", "an", "the"))
