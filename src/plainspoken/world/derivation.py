"""Landmarks made from the names in a domain and problem, where no file gives them.

Words come from predicate, action, object and type names: `robot-at rob l0` with `l0 - line` is
"line 0", `full b` with one box is "the box is full", `harvest-grape ... g1` is "to harvest
grape 1".
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import cached_property
from itertools import pairwise

from plainspoken.logic.syntax import is_proposition
from plainspoken.world.domain import (
    Action,
    AllOf,
    AtomCondition,
    Condition,
    Parameter,
    Problem,
    changed_atoms,
)
from plainspoken.world.landmark import Landmark, Landmarks, LandmarkType
from plainspoken.world.symbol import flat

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
            atom[-1] for predicate in self._motions for atom in self._groundings(predicate)
        )

    # Objects.

    @cached_property
    def _objects(self) -> Mapping[str, tuple[str, ...]]:
        """Each object's ways to be called, the best first."""
        return {name: tuple(dict.fromkeys(self._called(name))) for name in self._problem.objects}

    def _called(self, name: str) -> Iterator[str]:
        plain = spaced(name)
        kinds = self._kinds(name)
        number = re.fullmatch(r"([a-z]+)[-_]?(\d+)", name)
        for kind in kinds:
            alone = len(self._of_kind(kind)) == 1
            if number and _abbreviates(number[1], kind):
                yield f"{spaced(kind)} {number[2]}"
            elif name.startswith(kind) and len(name) == len(kind) + 1:
                yield f"{spaced(kind)} {name[-1]}"
            elif alone and _abbreviates(name.rstrip("0123456789") or name, kind):
                yield f"the {spaced(kind)}"
        for kind, above in pairwise(kinds):
            if len(self._of_kind(kind)) == 1:
                yield f"the {spaced(kind)} {spaced(above)}"
        yield plain
        for kind in kinds[:1]:
            if spaced(kind) not in plain:
                yield f"{spaced(kind)} {plain}"
                if len(self._of_kind(kind)) == 1:
                    yield f"the {spaced(kind)}"

    def _kinds(self, name: str) -> list[str]:
        """The types of an object, nearest first, and static predicates that stand for types."""
        found = []
        own = self._problem.objects[name]
        while own != "object" and own not in found:
            found.append(own)
            own = self._problem.domain.types.get(own, "object")
        for predicate, parameters in self._problem.domain.predicates.items():
            static = predicate not in self._problem.changing_predicates
            if static and len(parameters) == 1 and f"{predicate} {name}" in self._problem.initial:
                found.append(predicate)
        return found

    def _of_kind(self, kind: str) -> tuple[str, ...]:
        return self._problem.objects_for(Parameter("?", (kind,))) or tuple(
            name for name in self._problem.objects if f"{kind} {name}" in self._problem.initial
        )

    def _name(self, name: str) -> str:
        return self._objects[name][0]

    # Places.

    def places(self) -> Iterator[Landmark]:
        for predicate, movers in self._motions.items():
            for arguments in self._groundings(predicate):
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
                ways = tuple(
                    f"{robot} {verb} {called[0]}"
                    for verb in ("to", "in", "visits", "visit", "goes to", "go to", "is at")
                )
                more = tuple(f"{other} at {called[0]}" for other in others)
                yield Landmark(
                    id, f"{robot} at {called[0]}", LandmarkType.LOCATION, (*ways, *more, *called)
                )

    # Actions.

    def actions(self) -> Iterator[Landmark]:
        for schema in self._problem.domain.actions:
            plain = f"to {spaced(schema.name)}"
            full = f"to {self._with_article(schema)}"
            ways = dict.fromkeys((full, plain, *self._with_parent(schema, full)))
            description, *names = ways
            yield Landmark(
                f"{flat(schema.name)}_executed", description, LandmarkType.ACTION, tuple(names)
            )
        for schema in self._problem.domain.actions:
            yield from self._by_robot(schema)
            yield from self._instances(schema)

    def _with_article(self, schema: Action) -> str:
        """An action's words, with an article before a type: "check a grape", "empty the box"."""
        words = spaced(schema.name).split()
        for place, word in enumerate(words[1:], start=1):
            if word in self._problem.domain.types:
                alone = len(self._of_kind(word)) == 1
                article = "the" if alone else "an" if word[0] in "aeiou" else "a"
                words[place] = f"{article} {word}"
        return " ".join(words)

    def _with_parent(self, schema: Action, words: str) -> Iterator[str]:
        """The same words with a type's parent behind the type: "call the support robot"."""
        types = self._problem.domain.types
        for word in spaced(schema.name).split():
            above = types.get(word, "object")
            if above != "object":
                yield re.sub(rf"\b{word}\b", f"{word} {spaced(above)}", words)

    def _by_robot(self, schema: Action) -> Iterator[Landmark]:
        able = [
            name
            for parameter in schema.parameters[:1]
            for name in self._problem.objects_for(parameter)
            if name in self._agents
        ]
        if len(able) < 2:
            return
        words = spaced(schema.name)
        for name in able:
            robot = self._name(name)
            yield Landmark(
                f"{flat(name)}_executes_{flat(schema.name)}",
                f"to {words} with {robot}",
                LandmarkType.ACTION,
                (f"{robot} {words}",),
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
            fitting = tuple(self._fitting(schema, parameter))
            if len(fitting) < 2:
                continue  # the one object that fits is meant anyway
            for name in fitting:
                if name in self._agents or (moves and name in self._place_objects):
                    continue
                made += 1
                if made > MOST_OF_A_KIND:
                    return
                at = "at " if objects and self._is_setting(schema, parameter) else ""
                called = self._objects[name]
                ways = tuple(f"to {_completed(schema, at, way)}" for way in called)
                yield Landmark(
                    f"{flat(schema.name)}_{flat(name)}_executed",
                    ways[0],
                    LandmarkType.ACTION,
                    ways[1:],
                )

    def _is_setting(self, schema: Action, parameter: Parameter) -> bool:
        """Whether a parameter is a place or a robot, and not what the action is done to."""
        fitting = tuple(self._fitting(schema, parameter))
        return bool(fitting) and all(
            name in self._place_objects or name in self._agents for name in fitting
        )

    # Conditions.

    def conditions(self) -> Iterator[Landmark]:
        for predicate in sorted(self._problem.changing_predicates):
            for made, arguments in enumerate(self._groundings(predicate)):
                if made >= MOST_OF_A_KIND:
                    break
                ways = dict.fromkeys(self._condition(predicate, arguments))
                description, *names = ways
                id = flat(" ".join([predicate, *arguments]))
                yield Landmark(id, description, LandmarkType.CONDITION, tuple(names))

    def _condition(self, predicate: str, arguments: tuple[str, ...]) -> Iterator[str]:
        words = spaced(predicate).split()
        match arguments:
            case ():
                yield f"the {' '.join(words[:-1])} is {words[-1]}" if words[1:] else words[0]
            case (one,):
                for called in self._objects[one][:3]:
                    yield self._of_one(words, one, called)
            case (one, other):
                for called in self._objects[one][:2]:
                    for second in self._objects[other][:2]:
                        yield self._of_two(words, (one, other), called, second)
            case _:
                yield " ".join([*words, *map(self._name, arguments)])

    def _of_one(self, words: list[str], one: str, called: str) -> str:
        head, tail = words[0], words[-1]
        if head in _VERBS:
            return f"{called} {' '.join(words)}"
        if tail.endswith("ing") and one not in self._agents:
            return f"the robot is {' '.join(words)} {called}"
        if len(words) == 1 or head in _RELATIONS or head == "not":
            return f"{called} is {' '.join(words)}"
        if head in {word for kind in self._kinds(one) for word in spaced(kind).split()}:
            return f"{called} is {' '.join(words[1:])}"
        return f"the {' '.join(words[:-1])} of {called} is {tail}"

    def _of_two(self, words: list[str], both: tuple[str, str], called: str, second: str) -> str:
        one, other = both
        kinds = {word for kind in self._kinds(one) for word in spaced(kind).split()}
        rest = [word for word in words[:-1] if word not in kinds and word not in ("obj", "object")]
        tail = words[-1]
        if other in self._place_objects and tail not in _RELATIONS:
            article = ["the"] if words[0] in _RELATIONS else []
            joined = " ".join([words[0], *article, *words[1:]] if article else words)
            return f"{called} is {joined} at {second}"
        if tail in _RELATIONS:
            return f"{called} is {' '.join([*rest, tail])} {second}"
        if tail.endswith(("ing", "ed")):
            joint = " with " if tail.endswith("ed") else " "
            return f"{called} is {' '.join(words)}{joint}{second}"
        return f"{called} {' '.join(words)} {second}"

    # What can be true at all.

    def _groundings(self, predicate: str) -> Iterator[tuple[str, ...]]:
        """The ground atoms of a predicate whose objects some action, or the start, allows."""
        parameters = self._problem.domain.predicates[predicate]
        for binding in self._problem.bindings(parameters):
            arguments = tuple(binding.values())
            atom = " ".join([predicate, *arguments])
            if atom in self._problem.initial or any(
                all(
                    f"{kind} {name}" in self._problem.initial
                    for name, kinds in zip(arguments, way, strict=True)
                    for kind in kinds
                )
                for way in self._ways.get(predicate, ())
            ):
                yield arguments

    @cached_property
    def _ways(self) -> dict[str, set[tuple[frozenset[str], ...]]]:
        """For each predicate that is added: the static predicates each argument must satisfy."""
        found: dict[str, set[tuple[frozenset[str], ...]]] = {}
        for action in self._problem.domain.actions:
            needed = self._needed(action)
            for atom, added in changed_atoms(action.effect):
                if added:
                    way = tuple(needed.get(term, frozenset()) for term in atom.terms)
                    found.setdefault(atom.predicate, set()).add(way)
        return found

    def _needed(self, action: Action) -> dict[str, frozenset[str]]:
        found: dict[str, frozenset[str]] = {}
        for atom in _required(action.precondition):
            if len(atom.terms) == 1 and atom.predicate not in self._problem.changing_predicates:
                term = atom.terms[0]
                found[term] = found.get(term, frozenset()) | {atom.predicate}
        return found

    def _fitting(self, schema: Action, parameter: Parameter) -> Iterator[str]:
        kinds = self._needed(schema).get(parameter.name, frozenset())
        for name in self._problem.objects_for(parameter):
            if all(f"{kind} {name}" in self._problem.initial for kind in kinds):
                yield name


def spaced(name: str) -> str:
    """A PDDL name as words: `robot-at` is "robot at", `line3` is "line 3", `l3` stays."""
    words = re.sub(r"[-_]+", " ", name).strip()
    return re.sub(r"\b([a-z]{3,})(\d+)\b", r"\1 \2", words)


def _abbreviates(short: str, kind: str) -> bool:
    """Whether a name is short for a type: its first letters, or some of them in order."""
    short, kind = short.replace("-", "").replace("_", ""), kind.replace("-", "").replace("_", "")
    if not short or len(short) > len(kind) or short[0] != kind[0]:
        return False
    rest = iter(kind)
    return all(letter in rest for letter in short)


def _completed(schema: Action, at: str, called: str) -> str:
    """An action's words with its object, whose type the action may already name."""
    words = spaced(schema.name).split()
    kind = called.removeprefix("the ").split()[0]
    if not at and kind in words:
        place = words.index(kind)
        return " ".join([*words[:place], called, *words[place + 1 :]])
    joint = "for " if len(words) > 1 and words[-1] not in _PARTICLES and not at else ""
    return f"{' '.join(words)} {at or joint}{called}"


def _names(schema: Action) -> frozenset[str]:
    return frozenset(parameter.name for parameter in schema.parameters)


def _required(condition: Condition) -> Iterator[AtomCondition]:
    """The atoms that a condition plainly needs."""
    match condition:
        case AtomCondition():
            yield condition
        case AllOf(conditions):
            for part in conditions:
                yield from _required(part)
        case _:
            return
