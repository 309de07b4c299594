"""What hypothesis draws: formulas, traces, and small planning problems with their formulas."""

from __future__ import annotations

from random import Random

from hypothesis import strategies as st

from plainspoken.errors import UnknownSymbolError
from plainspoken.logic.formula import (
    FALSE,
    TRUE,
    Always,
    And,
    Atom,
    Eventually,
    Formula,
    Iff,
    Implies,
    Next,
    Not,
    Or,
    Release,
    Until,
    WeakNext,
    WeakUntil,
)
from plainspoken.world.domain import (
    Action,
    Add,
    AllOf,
    AnyOf,
    AtomCondition,
    Condition,
    Delete,
    Domain,
    Effect,
    Equal,
    Exists,
    ForAll,
    ForEach,
    NotCondition,
    OneOf,
    Parameter,
    Problem,
    Together,
    When,
)
from plainspoken.world.symbol import resolve

PROPOSITIONS = ("a", "b", "c")

_UNARY = (Not, Next, WeakNext, Eventually, Always)
_BINARY = (Implies, Iff, Until, WeakUntil, Release)


def formulas(names: tuple[str, ...] = PROPOSITIONS, most: int = 8) -> st.SearchStrategy[Formula]:
    """Formulas over some propositions, with at most so many leaves; all operators occur."""
    atoms = st.sampled_from(names).map(Atom)
    leaves = st.one_of(atoms, atoms, st.sampled_from((TRUE, FALSE)))

    def larger(part: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
        some = st.lists(part, min_size=2, max_size=3).map(tuple)
        return st.one_of(
            st.builds(lambda kind, operand: kind(operand), st.sampled_from(_UNARY), part),
            st.builds(
                lambda kind, left, right: kind(left, right), st.sampled_from(_BINARY), part, part
            ),
            some.map(And),
            some.map(Or),
        )

    return st.recursive(leaves, larger, max_leaves=most)


def letters(names: tuple[str, ...] = PROPOSITIONS) -> st.SearchStrategy[frozenset[str]]:
    """What is true at one instant."""
    return st.frozensets(st.sampled_from(names))


def traces(
    names: tuple[str, ...] = PROPOSITIONS, longest: int = 6
) -> st.SearchStrategy[tuple[frozenset[str], ...]]:
    """Traces of one instant or more."""
    return st.lists(letters(names), min_size=1, max_size=longest).map(tuple)


# Small problems: two rooms and a hall of one type and its parent, so that types matter; `link`
# is static. They are built from a drawn seed: drawing every part takes thirty times as long, and
# problems this small are read as they are when one of them fails.

TYPES = {"room": "place", "hall": "place", "place": "object"}
OBJECTS = {"r1": "room", "r2": "room", "h": "hall"}
PREDICATES: dict[str, tuple[Parameter, ...]] = {
    "in": (Parameter("?x", ("place",)),),
    "lit": (Parameter("?x", ("room",)),),
    "done": (),
    "link": (Parameter("?x", ("place",)), Parameter("?y", ("place",))),
}
ATOMS = ("in r1", "in r2", "in h", "lit r1", "lit r2", "done")
SYMBOLS = (
    *("in_r1", "in_h", "lit_r1", "lit_r2", "done", "in_r2", "link_r1_h"),
    *("a_executed", "b_executed", "a_r1_executed", "r2_executes_a"),
)
Bound = tuple[Parameter, ...]


def problems() -> st.SearchStrategy[Problem]:
    """Problems of at most 64 states, with all of ADL; two schemas may have one name."""
    return st.integers(0, 2**32).map(lambda seed: Builder(Random(seed)).problem())


def problems_with_goals() -> st.SearchStrategy[tuple[Problem, Formula]]:
    """A problem and a formula over its atoms and action symbols."""
    return st.integers(0, 2**32).map(problem_with_goal)


def problem_with_goal(seed: int) -> tuple[Problem, Formula]:
    """The problem and the formula of a seed."""
    builder = Builder(Random(seed))
    problem = builder.problem()
    return problem, builder.goal(tuple(s for s in SYMBOLS if _exists(s, problem)))


def _exists(symbol: str, problem: Problem) -> bool:
    try:
        resolve(symbol, problem)
    except UnknownSymbolError:
        return False
    return True


class Builder:
    """Builds a small problem and a formula by chance."""

    def __init__(self, random: Random) -> None:
        self.random = random
        self.choose = random.choice

    def some(self, least: int, most: int) -> range:
        return range(self.random.randint(least, most))

    def problem(self) -> Problem:
        names = self.choose((("a",), ("a", "b"), ("a", "b", "c"), ("a", "b", "b")))
        actions = tuple(self.action(name) for name in names)
        domain = Domain("drawn", TYPES, {}, PREDICATES, actions)
        links = [f"link {x} {y}" for x in OBJECTS for y in OBJECTS]
        initial = frozenset(
            [a for a in ATOMS if self.random.random() < 0.3]
            + [a for a in links if self.random.random() < 0.6]
        )
        return Problem("drawn", domain, OBJECTS, initial, self.condition((), 2))

    def action(self, name: str) -> Action:
        room, place = Parameter("?x", ("room",)), Parameter("?y", ("place",))
        parameters = self.choose(((), (room,), (room,), (room, place)))
        condition = AllOf() if self.random.random() < 0.3 else self.condition(parameters, 2)
        effect = Together(tuple(self.effect(parameters, 3) for _ in self.some(1, 3)))
        return Action(name, parameters, condition, effect)

    def atom(self, bound: Bound, predicates: tuple[str, ...]) -> AtomCondition:
        predicate = self.choose(predicates)
        return AtomCondition(predicate, tuple(self.term(bound, p) for p in PREDICATES[predicate]))

    def term(self, bound: Bound, parameter: Parameter) -> str:
        """A variable or object that may stand where the parameter does."""
        fitting = ("room",) if parameter.types == ("room",) else ("room", "place")
        variables = [each.name for each in bound if each.types[0] in fitting]
        objects = [o for o, own in OBJECTS.items() if own == "room" or fitting[1:]]
        return self.choose(variables * 3 + objects)

    def condition(self, bound: Bound, depth: int) -> Condition:
        kinds = ("atom", "atom", "not", "all", "all", "any", "any", "forall", "exists", "equal")
        kind = self.choose(kinds if depth else kinds[:3])
        match kind:
            case "atom":
                return self.atom(bound, tuple(PREDICATES))
            case "not":
                return NotCondition(self.condition(bound, max(depth - 1, 0)))
            case "all":
                return AllOf(tuple(self.condition(bound, depth - 1) for _ in self.some(0, 2)))
            case "any":
                return AnyOf(tuple(self.condition(bound, depth - 1) for _ in self.some(1, 3)))
            case "equal":
                names = [*(p.name for p in bound), "r1"]
                return Equal(self.choose(names), self.choose(names))
            case _:
                parameter = Parameter(f"?q{depth}", (self.choose(("room", "place")),))
                body = self.condition((*bound, parameter), depth - 1)
                quantifier = ForAll if kind == "forall" else Exists
                return quantifier((parameter,), body)

    def effect(self, bound: Bound, depth: int) -> Effect:
        kinds = ("add", "add", "delete", "oneof", "oneof", "together", "when", "foreach", "nothing")
        kind = self.choose(kinds if depth else kinds[:3])
        match kind:
            case "add":
                return Add(self.atom(bound, ("in", "lit", "done")))
            case "delete":
                return Delete(self.atom(bound, ("in", "lit", "done")))
            case "nothing":
                return Together()
            case "together":
                return Together(tuple(self.effect(bound, depth - 1) for _ in self.some(0, 3)))
            case "oneof":
                return OneOf(tuple(self.effect(bound, depth - 1) for _ in self.some(1, 2)))
            case "when":
                return When(self.condition(bound, 1), self.effect(bound, depth - 1))
            case _:
                parameter = Parameter(f"?e{depth}", ("room",))
                return ForEach((parameter,), self.effect((*bound, parameter), depth - 1))

    def formula(self, names: tuple[str, ...], depth: int) -> Formula:
        """Leaves are likelier than in `formulas`, so that more goals can be reached."""
        if not depth or self.random.random() < 0.3:
            return Atom(self.choose(names))
        match self.choose(("unary", "binary", "many")):
            case "unary":
                return self.choose(_UNARY)(self.formula(names, depth - 1))
            case "binary":
                left, right = self.formula(names, depth - 1), self.formula(names, depth - 1)
                return self.choose(_BINARY)(left, right)
            case _:
                parts = tuple(self.formula(names, depth - 1) for _ in range(2))
                return self.choose((And, Or))(parts)

    def goal(self, names: tuple[str, ...]) -> Formula:
        match self.choose(("reach", "reach", "both", "keep", "safe", "any", "then")):
            case "reach":
                return Eventually(self.formula(names, 1))
            case "both":
                return And(tuple(Eventually(self.formula(names, 1)) for _ in range(2)))
            case "keep":
                return And((Eventually(self.formula(names, 0)), Always(self.formula(names, 2))))
            case "safe":
                return And(tuple(Always(self.formula(names, 1)) for _ in range(2)))
            case "then":
                after = Next(Eventually(self.formula(names, 0)))
                return Eventually(And((self.formula(names, 0), after)))
            case _:
                return self.formula(names, 3)
