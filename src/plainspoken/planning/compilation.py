"""A problem and a formula compiled to plain PDDL, whose `:goal` is equivalent for any FOND planner.

The compiled problem is ground: one predicate without arguments for each atom that changes, one
action without parameters for each instance of an action. What it adds to the task:

- for each automaton (one for each conjunct of the formula) a predicate `at-I-S` for each state
  S, of which at most one is true, and `ok-I` where more than one state accepts. The first state
  has read s0. A step of an automaton stands in the outcome that causes it, as conditional
  effects: its guard, which is about the state afterwards, is regressed through the outcome to
  one about the state before. There are no turns: a policy has as many steps as ours.
  From a state that can never accept there is no way on: no `at-I-S` is true then.
- a disjunction in a precondition is split into an action for each way, `do-...--2`; where that
  would be more than `MOST_WAYS` actions, its truth is kept up in a predicate `or-K` instead.

Conditions are conjunctions of literals: `:negative-preconditions` and `:conditional-effects` are
all that is asked of a planner beside `oneof`, and that what an outcome both adds and deletes is
true. Actions that never change anything are left out; no policy needs one.

The size is that of the ground task times the guards that each outcome can meet; guards that
cannot apply, because the letter that led to an automaton's state rules them out, are left out.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import combinations
from math import prod

from plainspoken.errors import FormulaTooLargeError
from plainspoken.logic.formula import Formula
from plainspoken.logic.syntax import unparse
from plainspoken.planning.cube import (
    Cube,
    Cubes,
    Reader,
    Regression,
    TooManyCubes,
    all_of,
    any_of,
    literal,
    negated,
)
from plainspoken.planning.ground_pddl import (
    CompiledAction,
    Effect,
    Outcome,
    Text,
    distinct_names,
)
from plainspoken.planning.policy import Policy, PolicyNode
from plainspoken.planning.product import Product, product_of
from plainspoken.planning.task import Bits, Choice, Requirement, TaskAction, Variant, ones
from plainspoken.world.domain import GroundAction, GroundAtom, Problem, State
from plainspoken.world.pddl import parse_domain, parse_problem

MOST_WAYS = 8
"""An action is split into at most so many; a disjunction beyond that gets a predicate."""
MOST_EFFECTS = 1_000_000
"""A compiled problem with more conditional effects than this is refused."""


@dataclass(frozen=True)
class Compiled:
    """A compiled problem, and what its names stand for.

    domain, problem: PDDL
    actions: the ground action of the original problem that each compiled action is
    atoms:   the ground atom that each compiled predicate is; automata's are not in it
    """

    domain: str
    problem: str
    actions: Mapping[str, GroundAction]
    atoms: Mapping[str, GroundAtom]
    goal: Formula
    always: State
    static: State

    def read(self) -> Problem:
        """The compiled problem, as this package reads it."""
        return parse_problem(
            self.problem, parse_domain(self.domain, "compiled domain"), "compiled problem"
        )

    def original(self, policy: Policy) -> Policy:
        """A policy of the compiled problem as one of the original problem and its formula."""
        nodes = tuple(
            PolicyNode(
                node.id,
                self.always.union(
                    self.atoms[atom] for atom in (*node.state, *policy.static) if atom in self.atoms
                ),
                None if node.action is None else self.actions[node.action],
                node.successors,
            )
            for node in policy.nodes
        )
        return replace(policy, goal=unparse(self.goal), static=self.static, nodes=nodes)


def compiled(problem: Problem, goal: Formula) -> Compiled:
    """Compile a problem and a formula over it.

    raises UnknownSymbolError: when the formula names what the problem does not have
    raises FormulaTooLargeError: when the formula, or a condition of the domain, has too many cases
    """
    product = product_of(problem, goal)
    if not all(product.explored):
        raise FormulaTooLargeError(unparse(goal))
    try:
        return _Compilation(product, goal).compiled()
    except TooManyCubes:
        raise FormulaTooLargeError(unparse(goal)) from None


class _Compilation:
    """Bits are those of the product, and above them one for each disjunction kept up."""

    def __init__(self, product: Product, goal: Formula) -> None:
        self._product = product
        self._task = product.task
        self._goal = goal
        self._reader = Reader(product.task)
        self._first_symbol = product.task.world.bit_length()
        self._automata = _Automata(product)
        self._kept_up: dict[Choice, tuple[int, Cubes]] = {}
        self._effects = 0

    def compiled(self) -> Compiled:
        # First all preconditions: then it is known which disjunctions have to be kept up.
        ways = [self._ways(action) for action in self._task.actions]
        actions = []
        for action, found in zip(self._task.actions, ways, strict=True):
            number = 0
            for condition, variants in found:
                outcomes = self._outcomes(action, condition, variants)
                if any(outcomes):
                    number += 1
                    actions.append(CompiledAction(action.name, number, condition, outcomes))
        return self._written(actions)

    # -- preconditions --------------------------------------------------------------------

    def _ways(self, action: TaskAction) -> list[tuple[Cube, tuple[Variant, ...]]]:
        """The conjunctions under which an action is applicable, with the variants that then are.

        The robot does not choose among variants of one name: whatever holds may happen.
        """
        conditions = {v: self._condition(v.requirement) for v in action.variants}
        found = []
        for size in range(1, len(action.variants) + 1):
            for chosen in combinations(action.variants, size):
                others = [v for v in action.variants if v not in chosen]
                cubes = all_of(
                    *(conditions[v] for v in chosen), *(negated(conditions[v]) for v in others)
                )
                found += [(cube, chosen) for cube in cubes]
        return found

    def _condition(self, requirement: Requirement) -> Cubes:
        choices = {choice: self._reader.choice(choice) for choice in requirement.choices}
        many = sorted(choices, key=lambda choice: len(choices[choice]))
        split = len(many)
        while prod(len(choices[choice]) for choice in many[:split]) > MOST_WAYS:
            split -= 1
        return all_of(
            (self._reader.mask(requirement.mask),),
            *(choices[choice] for choice in many[:split]),
            *(self._kept(choice, choices[choice]) for choice in many[split:]),
        )

    def _kept(self, choice: Choice, cubes: Cubes) -> Cubes:
        """A disjunction as one literal, whose truth the outcomes keep up."""
        bit, _ = self._kept_up.setdefault(choice, (self._next_bit, cubes))
        return literal(bit, positive=True)

    @property
    def _next_bit(self) -> int:
        return self._automata.width + len(self._kept_up)

    # -- outcomes -------------------------------------------------------------------------

    def _outcomes(
        self, action: TaskAction, condition: Cube, variants: Iterable[Variant]
    ) -> tuple[Outcome, ...]:
        found = {
            self._outcome(
                Regression(o, self._reader, action.symbols, self._first_symbol), condition
            )
            for variant in variants
            for o in variant.outcomes
        }
        self._effects += sum(map(len, found))
        if self._effects > MOST_EFFECTS:
            raise FormulaTooLargeError(unparse(self._goal))
        return tuple(sorted(found, key=_effect_order))

    def _outcome(self, regression: Regression, precondition: Cube) -> Outcome:
        merged: dict[Cube, tuple[Bits, Bits]] = {}
        for effect in (
            *self._world_effects(regression),
            *self._automata.effects(regression),
            *self._kept_up_effects(regression),
        ):
            if effect.condition.meet(precondition) is None:
                continue
            condition = effect.condition.without(precondition)
            add, delete = merged.get(condition, (0, 0))
            merged[condition] = (add | effect.add, delete | effect.delete)
        return tuple(
            Effect(condition, add, delete & ~add) for condition, (add, delete) in merged.items()
        )

    def _world_effects(self, regression: Regression) -> Iterator[Effect]:
        for cubes, add, delete in regression.effects():
            if add | delete:
                yield from (Effect(cube, add, delete) for cube in cubes)

    def _kept_up_effects(self, regression: Regression) -> Iterator[Effect]:
        for bit, cubes in self._kept_up.values():
            read = 0
            for cube in cubes:
                read |= cube.positive | cube.negative
            if not read & regression.touched:
                continue
            false = negated(cubes)
            for now, was, add, delete in ((cubes, cubes, 1, 0), (false, false, 0, 1)):
                for cube in any_of(*map(regression.cube, now)):
                    if not any(cube.implies(before) for before in was):
                        yield Effect(cube, add << bit, delete << bit)

    # -- names and text -------------------------------------------------------------------

    def _written(self, actions: list[CompiledAction]) -> Compiled:
        atoms = distinct_names("is", self._task.atoms)
        names = dict(enumerate(atoms)) | self._automata.names
        names |= {bit: f"or-{i}" for i, (bit, _) in enumerate(self._kept_up.values(), start=1)}
        bases = dict(
            zip(
                (a.name for a in self._task.actions),
                distinct_names("do", [a.name for a in self._task.actions]),
                strict=True,
            )
        )
        named = {bases[a.original] + (f"--{a.number}" if a.number > 1 else ""): a for a in actions}
        text = Text(names)
        initial = self._task.initial & self._reader.atoms | self._automata.initial
        for bit, cubes in self._kept_up.values():
            if any(_holds(cube, initial) for cube in cubes):
                initial |= 1 << bit
        return Compiled(
            text.domain(named),
            text.problem(initial, self._automata.goal),
            {name: action.original for name, action in named.items()},
            dict(zip(atoms, self._task.atoms, strict=True)),
            self._goal,
            self._task.always,
            self._task.static,
        )


class _Automata:
    """The product's automata: names and bits of their states, and their steps as effects.

    goal: a literal for each automaton
    """

    def __init__(self, product: Product) -> None:
        self._product = product
        self._world = product.task.world
        self.names: dict[int, str] = {}
        self.width = product.width
        self.initial: Bits = 0
        self.goal: Bits = 0
        self._accepted: dict[int, Bits] = {}
        self._steps: list[tuple[int, Cube, int]] = []
        self._known_by: dict[int, list[Cube]] = {}
        memory = ones(product.initial >> product.task.width << product.task.width)
        for index, first in enumerate(memory):
            self._add(index, first)

    def _add(self, index: int, first: int) -> None:
        """One automaton, from the state that has read s0."""
        product = self._product
        letters = self._letters(first)
        start = product.initial & letters
        self._known_by[first] = [Cube(start, letters & ~start)]
        order = [first]
        for bit in order:
            for step in product.transitions(bit):
                cube = Cube(step.positive, step.negative)
                self._steps.append((bit, cube, step.target))
                if step.target not in self._known_by:
                    self._known_by[step.target] = []
                    order.append(step.target)
                # What was executed says nothing of the state any more.
                known = Cube(cube.positive & self._world, cube.negative & self._world)
                self._known_by[step.target].append(known)
        live = [bit for bit in order if not self._is_dead(bit)]
        self.names |= {bit: f"at-{index + 1}-{i}" for i, bit in enumerate(live)}
        accepting = [bit for bit in live if product.accepting[index] >> bit & 1]
        if len(accepting) == 1:
            ok = accepting[0]
        else:
            ok = self.width
            self.width += 1
            self.names[ok] = f"ok-{index + 1}"
            self._accepted |= dict.fromkeys(accepting, 1 << ok)
        self.goal |= 1 << ok
        if not self._is_dead(first):
            self.initial |= 1 << first | self._accepted.get(first, 0)

    def _is_dead(self, bit: int) -> bool:
        return self._product.rejecting >> bit & 1 == 1

    def _letters(self, first: int) -> Bits:
        """The atoms that the guards of an automaton read, from some state on."""
        seen, order, read = {first}, [first], 0
        for bit in order:
            for step in self._product.transitions(bit):
                read |= step.positive | step.negative
                if step.target not in seen:
                    seen.add(step.target)
                    order.append(step.target)
        return read & self._world

    def effects(self, regression: Regression) -> Iterator[Effect]:
        """The steps that an outcome may cause."""
        for source, guard, target in self._steps:
            if source == target or self._is_dead(source):
                continue
            delete = 1 << source | self._accepted.get(source, 0)
            add = 0 if self._is_dead(target) else 1 << target | self._accepted.get(target, 0)
            for cube in regression.cube(guard):
                shorter = _shortened(cube, self._known_by[source])
                if shorter is not None:
                    condition = Cube(shorter.positive | 1 << source, shorter.negative)
                    yield Effect(condition, add, delete & ~add)


def _shortened(cube: Cube, known: list[Cube]) -> Cube | None:
    """The cube without what follows from the rest of it, where one of the known cubes holds.

    None where the cube cannot hold then.
    """
    possible = [each for each in known if each.meet(cube) is not None]
    if not possible:
        return None
    for bit, value in cube.literals():
        one = literal(bit, positive=value)[0]
        rest = cube.without(one)
        if all(each.implies(one) for each in known if each.meet(rest) is not None):
            cube = rest
    return cube


def _holds(cube: Cube, state: Bits) -> bool:
    return state & cube.positive == cube.positive and not state & cube.negative


def _effect_order(outcome: Outcome) -> list[tuple[int, int, int, int]]:
    return [(e.condition.positive, e.condition.negative, e.add, e.delete) for e in outcome]
