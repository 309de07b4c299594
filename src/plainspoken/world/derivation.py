"""Landmarks made from the names in a domain and problem, where no file gives them.

Words come from predicate, action, object and type names: `robot-at rob l0` with `l0 - line` is
"line 0", `full b` with one box is "the box is full", `harvest-grape ... g1` is "to harvest
grape 1".
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice, permutations, product

from plainspoken.logic.syntax import is_proposition
from plainspoken.world.action_phrase import ActionPhrases
from plainspoken.world.condition_phrase import ConditionPhrases
from plainspoken.world.domain import Action, Parameter, Problem
from plainspoken.world.landmark import Landmark, Landmarks, LandmarkType
from plainspoken.world.object_name import ObjectNames
from plainspoken.world.role import Roles
from plainspoken.world.symbol import flat
from plainspoken.world.wording import Wording

MOST_DERIVED = 2000
"""More landmarks than this are not derived from a problem: nobody would read them."""
MOST_OF_A_KIND = 500
"""Nor more than this of one predicate or action."""
MOST_UNREACHED = 60
"""Nor more than this of one predicate that no execution is seen to make true."""
MOST_JOINT = 60
"""Nor more than this of one action with two of its arguments."""


def derived_landmarks(problem: Problem) -> Landmarks:
    """Landmarks for what an action can change, and for what can be done.

    Places come first, then actions, then conditions, so that a cap drops what is said least:
    last of all what no execution is seen to make true, and actions with two arguments named.
    """
    found: dict[str, Landmark] = {}
    naming = _Naming(problem)
    for landmark in (
        *naming.places(),
        *naming.actions(),
        *naming.conditions(),
        *naming.unreached(),
        *naming.joint_actions(),
    ):
        if len(found) >= MOST_DERIVED:
            break
        if is_proposition(landmark.id):
            found.setdefault(landmark.id, landmark)
    return found


class _Naming:
    """The words of one problem."""

    def __init__(self, problem: Problem) -> None:
        domain = problem.domain
        actions = (action.name for action in domain.actions)
        names = (*domain.types, *domain.predicates, *actions, *problem.objects)
        wording = Wording(names, problem.humps)
        self._problem = problem
        self._roles = Roles(problem)
        self._names = ObjectNames(self._roles, wording)
        self._conditions = ConditionPhrases(self._roles, wording, self._names)
        self._acts = ActionPhrases(self._roles, wording, self._names)

    # Places.

    def places(self) -> Iterator[Landmark]:
        for predicate, movers in self._roles.motions.items():
            for arguments in self._roles.possible.of(predicate):
                if len(arguments) == 1 or arguments[0] in movers:
                    yield self._place(predicate, arguments)

    def _place(self, predicate: str, arguments: tuple[str, ...]) -> Landmark:
        *movings, place = arguments
        id = flat(" ".join([predicate, *arguments]))
        called = self._names[place]
        if len(self._roles.agents) < 2 or not movings:
            return Landmark(id, called[0], LandmarkType.LOCATION, called[1:])
        # Of several robots the bare name of a place may mean any: it stays askable.
        robot, *others = self._names[movings[0]]
        more = (f"{each} is at {called[0]}" for each in (robot, *others))
        return Landmark(id, f"{robot} at {called[0]}", LandmarkType.LOCATION, (*more, *called))

    # Actions.

    def actions(self) -> Iterator[Landmark]:
        for schema in self._problem.domain.actions:
            ways = (f"to {way}" for way in self._acts.general(schema))
            yield _landmark(f"{schema.name}_executed", ways, LandmarkType.ACTION)
        for schema in self._problem.domain.actions:
            for robot in self._able(schema):
                id = f"{robot}_executes_{schema.name}"
                yield _landmark(id, self._acts.by(schema, robot, {}), LandmarkType.ACTION)
            yield from islice(self._instances(schema), MOST_OF_A_KIND)

    def _able(self, schema: Action) -> tuple[str, ...]:
        """The robots that may do an action, where there are several."""
        able = tuple(
            name
            for parameter in schema.parameters[:1]
            for name in self._problem.objects_for(parameter)
            if name in self._roles.agents
        )
        return able if len(able) > 1 else ()

    def _named(self, schema: Action) -> Iterator[tuple[Parameter, str]]:
        """The arguments that tell one execution of an action from another."""
        moves = self._roles.moves(schema)
        for parameter in schema.parameters:
            fitting = tuple(self._roles.possible.fitting(schema, parameter))
            for name in fitting if len(fitting) > 1 else ():  # the only one is meant anyway
                if name not in self._roles.agents and not (moves and name in self._roles.places):
                    yield parameter, name

    def _instances(self, schema: Action) -> Iterator[Landmark]:
        for parameter, name in self._named(schema):
            ways = (
                f"to {way}"
                for called in self._names[name]
                if called != "A"  # which would be in every "to pick up a block"
                for way in self._acts.at(schema, parameter, called)
            )
            yield _landmark(f"{schema.name}_{name}_executed", ways, LandmarkType.ACTION)

    def joint_actions(self) -> Iterator[Landmark]:
        """What one robot of several does to one thing, and what is done with two things."""
        for schema in self._problem.domain.actions:
            yield from islice(self._with_two(schema), MOST_JOINT)

    def _with_two(self, schema: Action) -> Iterator[Landmark]:
        things = self._acts.things(schema)
        named = [(p, name) for p, name in self._named(schema) if p in things]
        for robot, (parameter, name) in product(self._able(schema), named):
            ways = self._acts.by(schema, robot, {parameter.name: self._names[name][0]})
            id = f"{schema.name}_{robot}_{name}_executed"
            yield _landmark(id, ways, LandmarkType.ACTION)
        for (one, name), (other, second) in permutations(named, 2):
            if schema.parameters.index(one) < schema.parameters.index(other) and name != second:
                filling = {one.name: self._names[name][0], other.name: self._names[second][0]}
                ways = (f"to {self._acts.filled(schema, filling)}",)
                id = f"{schema.name}_{name}_{second}_executed"
                yield _landmark(id, ways, LandmarkType.ACTION)

    # Conditions.

    def conditions(self) -> Iterator[Landmark]:
        for predicate in sorted(self._problem.changing_predicates):
            for arguments in islice(self._roles.possible.of(predicate), MOST_OF_A_KIND):
                yield self._condition(predicate, arguments)

    def _condition(self, predicate: str, arguments: tuple[str, ...]) -> Landmark:
        id = " ".join([predicate, *arguments])
        return _landmark(id, self._conditions.of(predicate, arguments), LandmarkType.CONDITION)

    def unreached(self) -> Iterator[Landmark]:
        """What may be said and is seen never to change, as that a sound sensor is broken.

        A formula about it is true or false from the start, which is for the planner to explain.
        Only where types tell what may stand where: without them most of it would be nonsense.
        """
        for predicate, parameters in sorted(self._problem.domain.predicates.items()):
            changes = predicate in self._problem.changing_predicates
            if any("object" in each.types for each in parameters) or (parameters and not changes):
                continue
            reached = set(self._roles.possible.of(predicate))
            movers = self._roles.motions.get(predicate, ())
            rest = (
                arguments
                for binding in self._problem.bindings(parameters)
                if (arguments := tuple(binding.values())) not in reached
                and len(set(arguments)) == len(arguments)
            )
            for arguments in islice(rest, MOST_UNREACHED):
                placed = len(arguments) == 1 or (arguments and arguments[0] in movers)
                if predicate in self._roles.motions and placed:
                    yield self._place(predicate, arguments)
                else:
                    yield self._condition(predicate, arguments)


def _landmark(id: str, ways: Iterator[str] | tuple[str, ...], type: LandmarkType) -> Landmark:
    description, *names = dict.fromkeys(ways)
    return Landmark(flat(id), description, type, tuple(names))
