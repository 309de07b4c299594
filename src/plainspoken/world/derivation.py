"""Landmarks made from the names in a domain and problem, where no file gives them.

Words come from predicate, action, object and type names: `robot-at rob l0` with `l0 - line` is
"line 0", `full b` with one box is "the box is full", `harvest-grape ... g1` is "to harvest
grape 1".
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from plainspoken.logic.syntax import is_proposition
from plainspoken.world.domain import Action, Parameter, Problem, changed_atoms
from plainspoken.world.landmark import Landmark, Landmarks, LandmarkType
from plainspoken.world.object_name import ObjectNames
from plainspoken.world.reachability import PossibleAtoms
from plainspoken.world.symbol import flat
from plainspoken.world.wording import Wording, is_quality, is_word

MOST_DERIVED = 2000
"""More landmarks than this are not derived from a problem: nobody would read them."""
MOST_OF_A_KIND = 500
"""Nor more than this of one predicate or action."""

_RELATIONS = frozenset(
    ("at", "in", "on", "inside", "into", "under", "near", "by", "behind", "above", "below",
     "beside", "within", "outside", "from", "to", "with")
)  # fmt: skip
_PARTICLES = _RELATIONS | frozenset(("up", "down", "off", "out", "over", "away"))
_VERBS = frozenset(("has", "have", "is", "can", "needs", "was", "contains", "wants"))


def derived_landmarks(problem: Problem) -> Landmarks:
    """Landmarks for what an action can change, and for what can be done.

    Places come first, then actions, then conditions, so that a cap drops what is said least.
    """
    found: dict[str, Landmark] = {}
    naming = _Naming(problem)
    for landmark in (*naming.places(), *naming.actions(), *naming.conditions()):
        if len(found) >= MOST_DERIVED:
            break
        if is_proposition(landmark.id):
            found.setdefault(landmark.id, landmark)
    return found


class _Naming:
    """The words of one problem."""

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        self._possible = PossibleAtoms(problem)

    # Who moves, and where.

    @cached_property
    def _motions(self) -> dict[str, tuple[str, ...]]:
        """Predicates that tell where something is, and the actions' first parameters that move.

        Such a predicate is deleted for one last argument and added for another by one action.
        """
        found: dict[str, set[str]] = {}
        for action in self._problem.domain.actions:
            gone = [a for a, added in changed_atoms(action.effect) if not added]
            come = [a for a, added in changed_atoms(action.effect) if added]
            for old in gone:
                for new in come:
                    if (
                        old.predicate == new.predicate
                        and old.terms
                        and len(old.terms) <= 2
                        and old.terms[:-1] == new.terms[:-1]
                        and old.terms[-1] != new.terms[-1]
                    ):
                        movers = found.setdefault(old.predicate, set())
                        first = action.parameters[0] if action.parameters else None
                        if first is not None and first.name in old.terms[:-1]:
                            movers |= set(self._problem.objects_for(first))
        return {
            predicate: tuple(o for o in self._problem.objects if o in movers)
            for predicate, movers in found.items()
            if movers or len(self._problem.domain.predicates[predicate]) == 1
        }

    @cached_property
    def _agents(self) -> tuple[str, ...]:
        """The objects that move by actions of their own: the robots."""
        found = {mover for movers in self._motions.values() for mover in movers}
        return tuple(name for name in self._problem.objects if name in found)

    @cached_property
    def _place_objects(self) -> frozenset[str]:
        return frozenset(
            atom[-1] for predicate in self._motions for atom in self._possible.of(predicate)
        )

    # Words.

    @cached_property
    def _wording(self) -> Wording:
        domain = self._problem.domain
        actions = (action.name for action in domain.actions)
        return Wording((*domain.types, *domain.predicates, *actions, *self._problem.objects))

    @cached_property
    def _objects(self) -> ObjectNames:
        return ObjectNames(self._problem, self._wording, self._agents)

    def _name(self, name: str) -> str:
        return self._objects[name][0]

    def _kind_words(self, name: str) -> frozenset[str]:
        kinds = self._objects.kinds(name)
        return frozenset(word for kind in kinds for word in self._wording.spaced(kind).split())

    # Places.

    def places(self) -> Iterator[Landmark]:
        for predicate, movers in self._motions.items():
            for arguments in self._possible.of(predicate):
                *movings, place = arguments
                if movings and movings[0] not in movers:
                    continue
                id = flat(" ".join([predicate, *arguments]))
                called = self._objects[place]
                if len(self._agents) < 2 or not movings:
                    yield Landmark(id, called[0], LandmarkType.LOCATION, called[1:])
                    continue
                # Of several robots the bare name of a place may mean any: it stays askable.
                robot, *others = self._objects[movings[0]]
                more = (f"{each} is at {called[0]}" for each in (robot, *others))
                yield Landmark(
                    id, f"{robot} at {called[0]}", LandmarkType.LOCATION, (*more, *called)
                )

    # Actions.

    def actions(self) -> Iterator[Landmark]:
        for schema in self._problem.domain.actions:
            plain = self._wording.verbal(schema.name)
            full = self._with_article(schema)
            longer = tuple(self._with_objects(schema, full))
            said = (full, *longer, plain) if " the " in full else (*longer, full, plain)
            ways = dict.fromkeys(f"to {way}" for way in (*said, *self._with_parent(schema, full)))
            description, *names = ways
            yield Landmark(
                f"{flat(schema.name)}_executed", description, LandmarkType.ACTION, tuple(names)
            )
        for schema in self._problem.domain.actions:
            yield from self._by_robot(schema)
            yield from self._instances(schema)

    def _with_article(self, schema: Action) -> str:
        """An action's words with articles: "check a grape", "empty the box", "call the worker"."""
        words = self._wording.verbal(schema.name).split()
        types = self._problem.domain.types
        for place, word in enumerate(words[1:], start=1):
            if word in types:
                words[place] = self._objects.any_of(word)
        if len(words) == 2 and words[1] not in _PARTICLES and is_word(words[1]):
            return f"{words[0]} the {words[1]}"
        return " ".join(words)

    def _with_objects(self, schema: Action, words: str) -> Iterator[str]:
        """The same words with what the action is done to, where its name leaves that out."""
        verb, *rest = self._wording.verbal(schema.name).split()
        things = [p for p in schema.parameters if not self._is_setting(schema, p)]
        named = [p for p in schema.parameters if set(_type_words(p)) & set(rest)]
        if named:
            for parameter in things:
                fitting = tuple(self._possible.fitting(schema, parameter))
                if parameter not in named and len(fitting) == 1:
                    yield f"{words} in {self._name(fitting[0])}"
            return
        direct = not rest or rest[-1] in _PARTICLES
        if not things:
            yield from (f"{words} the {noun}" for noun in self._subjects_changed(schema) if direct)
            things = [p for p in schema.parameters if self._is_changed(schema, p)]
        for parameter in things[:1]:
            fitting = tuple(self._possible.fitting(schema, parameter))
            if any(name in self._mobile for name in fitting):
                continue
            called = self._objects[fitting[0]][:2] if len(fitting) == 1 else ()
            kinds = [self._objects.any_of(each) for each in parameter.types if each != "object"]
            for each in (*called, *kinds):
                yield f"{words} {each}" if direct else f"{words} of {each}"
                if not direct and self._is_setting(schema, parameter):
                    yield f"{verb} {each}"

    def _subjects_changed(self, schema: Action) -> Iterator[str]:
        """What an action changes and nothing else: (floor-wet) of `mop` is "the floor"."""
        changed = {atom.predicate for atom, _ in changed_atoms(schema.effect)}
        for predicate in changed if len(changed) == 1 else ():
            parameters = self._problem.domain.predicates[predicate]
            words = self._wording.spaced(predicate).split()
            own = all(name in self._mobile for p in parameters for name in
                      self._problem.objects_for(p))  # fmt: skip
            if own and len(words) == 2 and words[0] not in _RELATIONS | _VERBS | {"not"}:
                noun, _ = _noun_first(words)
                yield noun

    @cached_property
    def _mobile(self) -> frozenset[str]:
        """Whatever moves, by itself or with another's doing."""
        return frozenset(self._agents) | {
            atom[0]
            for predicate in self._motions
            for atom in self._possible.of(predicate)
            if len(atom) == 2
        }

    def _is_changed(self, schema: Action, parameter: Parameter) -> bool:
        """Whether something that is said of one thing alone becomes so, or not so, of it."""
        return any(atom.terms == (parameter.name,) for atom, _ in changed_atoms(schema.effect))

    def _with_parent(self, schema: Action, words: str) -> Iterator[str]:
        """The same words with a type's parent behind the type: "call the support robot"."""
        types = self._problem.domain.types
        for word in self._wording.spaced(schema.name).split():
            above = types.get(word, "object")
            if above != "object":
                yield re.sub(rf"\b{word}\b", f"{word} {self._wording.spaced(above)}", words)

    def _by_robot(self, schema: Action) -> Iterator[Landmark]:
        able = [
            name
            for parameter in schema.parameters[:1]
            for name in self._problem.objects_for(parameter)
            if name in self._agents
        ]
        if len(able) < 2:
            return
        words = self._wording.verbal(schema.name)
        verb, _, rest = words.partition(" ")
        for name in able:
            names = (f"{robot} {_third(verb)} {rest}".strip() for robot in self._objects[name])
            yield Landmark(
                f"{flat(name)}_executes_{flat(schema.name)}",
                f"to {words} with {self._name(name)}",
                LandmarkType.ACTION,
                (*names, f"to {words} {self._name(name)}"),
            )

    def _instances(self, schema: Action) -> Iterator[Landmark]:
        moves = any(
            atom.predicate in self._motions and atom.terms[-1] in _names(schema)
            for atom, added in changed_atoms(schema.effect)
            if added
        )
        made = 0
        objects = [p for p in schema.parameters if not self._is_setting(schema, p)]
        for parameter in schema.parameters:
            fitting = tuple(self._possible.fitting(schema, parameter))
            if len(fitting) < 2:
                continue  # the one object that fits is meant anyway
            for name in fitting:
                if name in self._agents or (moves and name in self._place_objects):
                    continue
                made += 1
                if made > MOST_OF_A_KIND:
                    return
                at = "at " if objects and self._is_setting(schema, parameter) else ""
                ways = dict.fromkeys(
                    f"to {self._completed(schema, at, name, way)}" for way in self._objects[name]
                )
                description, *names = ways
                yield Landmark(
                    f"{flat(schema.name)}_{flat(name)}_executed",
                    description,
                    LandmarkType.ACTION,
                    tuple(names),
                )

    def _completed(self, schema: Action, at: str, name: str, called: str) -> str:
        """An action's words with its object, whose type the action may already name."""
        words = self._wording.verbal(schema.name).split()
        kinds = [] if at else [kind for kind in self._objects.kinds(name) if kind in words[1:]]
        if kinds:
            place = words.index(kinds[0])
            return " ".join([*words[:place], called, *words[place + 1 :]])
        joint = "for " if len(words) > 1 and words[-1] not in _PARTICLES and not at else ""
        return f"{' '.join(words)} {at or joint}{called}"

    def _is_setting(self, schema: Action, parameter: Parameter) -> bool:
        """Whether a parameter is a place or a robot, and not what the action is done to."""
        fitting = tuple(self._possible.fitting(schema, parameter))
        return bool(fitting) and all(
            name in self._place_objects or name in self._agents for name in fitting
        )

    # Conditions.

    def conditions(self) -> Iterator[Landmark]:
        for predicate in sorted(self._problem.changing_predicates):
            for made, arguments in enumerate(self._possible.of(predicate)):
                if made >= MOST_OF_A_KIND:
                    break
                ways = dict.fromkeys(self._condition(predicate, arguments))
                description, *names = ways
                id = flat(" ".join([predicate, *arguments]))
                yield Landmark(id, description, LandmarkType.CONDITION, tuple(names))

    def _condition(self, predicate: str, arguments: tuple[str, ...]) -> Iterator[str]:
        words = self._wording.spaced(predicate).split()
        match arguments:
            case ():
                yield from _of_none(words)
            case (one,):
                plain = words[0] not in _RELATIONS | _VERBS | {"not"} and words[1:]
                if plain and len(self._possible.of(predicate)) == 1:
                    yield from _of_none(words)
                for called in self._objects[one][:3]:
                    yield self._of_one(words, one, called)
            case (one, other):
                if words[-1] not in _RELATIONS and self._is_only(predicate, arguments):
                    for called in self._objects[one][:2]:
                        yield self._of_one(words, one, called)
                for called in self._objects[one][:2]:
                    for second in self._objects[other][:2]:
                        yield self._of_two(words, (one, other), called, second)
            case _:
                yield " ".join([*words, *map(self._name, arguments)])

    def _is_only(self, predicate: str, arguments: tuple[str, ...]) -> bool:
        """Whether a predicate holds of the first argument with no other place but this one."""
        own = [each for each in self._possible.of(predicate) if each[0] == arguments[0]]
        return len(own) == 1 and arguments[1] in self._place_objects

    def _of_one(self, words: list[str], one: str, called: str) -> str:
        head, tail = words[0], words[-1]
        if head in _VERBS:
            return f"{called} {' '.join(words)}"
        if tail.endswith("ing") and one not in self._agents:
            return f"the robot is {' '.join(words)} {called}"
        if len(words) == 1 or head in _RELATIONS or head == "not":
            return f"{called} is {' '.join(_with_the(words))}"
        if head in self._kind_words(one):
            return f"{called} is {' '.join(words[1:])}"
        return f"the {' '.join(words[:-1])} of {called} is {tail}"

    def _of_two(self, words: list[str], both: tuple[str, str], called: str, second: str) -> str:
        one, other = both
        kinds = self._kind_words(one)
        rest = [word for word in words[:-1] if word not in kinds and word not in ("obj", "object")]
        tail = words[-1]
        if other in self._place_objects and tail not in _RELATIONS:
            return f"{called} is {' '.join(_with_the(words))} at {second}"
        if tail in _RELATIONS:
            return f"{called} is {' '.join([*rest, tail])} {second}"
        if tail.endswith(("ing", "ed")):
            joint = " with " if tail.endswith("ed") else " "
            return f"{called} is {' '.join(words)}{joint}{second}"
        return f"{called} {' '.join(words)} {second}"


def _of_none(words: list[str]) -> Iterator[str]:
    """What is said without naming of what: `stove-on` is "the stove is on"."""
    if words[0] == "not" and len(words) > 1:
        for way in _of_none(words[1:]):
            yield way.replace(" is ", " is not ", 1) if " is " in way else f"not {way}"
        return
    if len(words) == 1 or words[0] in _VERBS:
        yield " ".join(words) if len(words) == 1 else f"the robot {' '.join(words)}"
        return
    if words[0] in _RELATIONS:
        yield f"the robot is {' '.join(_with_the(words))}"
        return
    noun, state = _noun_first(words)
    yield f"the {noun} is {state}"


def _noun_first(words: list[str]) -> tuple[str, str]:
    """Who or what, and how it is: of "hand empty" as well as of "empty hand"."""
    if len(words) == 2 and is_quality(words[0]) and not is_quality(words[1]):
        return words[1], words[0]
    return " ".join(words[:-1]), words[-1]


def _with_the(words: list[str]) -> list[str]:
    """The words of a relation with its noun's article: "in the hand"."""
    if len(words) < 2 or words[0] not in _RELATIONS or words[1] in _RELATIONS | {"the"}:
        return words
    return [words[0], "the", *words[1:]]


def _third(verb: str) -> str:
    """A verb as it is said of someone: "drives"."""
    if verb.endswith("y") and verb[-2:-1] not in "aeiou":
        return f"{verb[:-1]}ies"
    return f"{verb}es" if verb.endswith(("s", "sh", "ch", "x", "o")) else f"{verb}s"


def _type_words(parameter: Parameter) -> Iterator[str]:
    for type in parameter.types:
        yield from re.split(r"[-_]+", type)


def _names(schema: Action) -> frozenset[str]:
    return frozenset(parameter.name for parameter in schema.parameters)
