"""The symbols that a formula may use of a planning problem, and what each one denotes.

An id is a ground atom flattened with underscores (`robot_at_rob_l0`), or an action symbol:

    <action>_executed                any instance of the action
    <robot>_executes_<action>        any instance that has the robot among its arguments
    <action>_<arg>_..._executed      the instances with these arguments, in this order
                                     (all of them for one instance; fewer for several)

An action symbol is true at the instant that an execution leads to, and never at s0. Where an id
can be read in several of these forms, the first one counts; where one form gives several
readings, as `at_a_b_c` does with objects `a`, `a-b`, `b-c` and `c`, the id is refused.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice

from plainspoken.errors import AmbiguousSymbolError, UnknownSymbolError
from plainspoken.world.domain import GroundAction, GroundAtom, Parameter, Problem, State

SymbolId = str

MOST_SUGGESTED = 5000
"""An unknown id is compared with no more ids than this, which takes a tenth of a second."""


@dataclass(frozen=True, slots=True)
class AtomSymbol:
    """True at the instants where the ground atom is."""

    id: SymbolId
    atom: GroundAtom


@dataclass(frozen=True, slots=True)
class ActionSymbol:
    """True at the instants that a matching action leads to.

    arguments: what the action's arguments have to contain, in this order
    """

    id: SymbolId
    action: str
    arguments: tuple[str, ...] = ()

    def matches(self, action: GroundAction) -> bool:
        """Whether executing the action makes this symbol true."""
        name, *arguments = action.split()
        if name != self.action:
            return False
        rest = iter(arguments)
        return all(argument in rest for argument in self.arguments)


Symbol = AtomSymbol | ActionSymbol


def flat(text: str) -> str:
    """A PDDL name, ground atom or ground action as it stands in an id."""
    return text.replace("-", "_").replace(" ", "_")


def resolve(symbol: SymbolId, problem: Problem) -> Symbol:
    """What an id denotes in a problem.

    raises UnknownSymbolError: when nothing in the problem has this id
    raises AmbiguousSymbolError: when several ground atoms, or several sets of actions, have it
    """
    wanted = symbol.lower()
    for form in (_atoms, _actions, _actions_of_a_robot, _actions_with_arguments):
        readings = tuple(dict.fromkeys(form(symbol, wanted, problem)))
        if len(readings) > 1:
            raise AmbiguousSymbolError(symbol, map(_in_pddl, readings))
        if readings:
            return readings[0]
    raise UnknownSymbolError(symbol, islice(_some_ids(problem), MOST_SUGGESTED))


def resolve_all(symbols: Iterable[SymbolId], problem: Problem) -> tuple[Symbol, ...]:
    """What each id denotes, in sorted order of the ids."""
    return tuple(resolve(symbol, problem) for symbol in sorted(symbols))


def letter(
    symbols: Iterable[Symbol], state: State, action: GroundAction | None
) -> frozenset[SymbolId]:
    """The symbols true at an instant: its state, and the action that led to it (None at s0)."""
    return frozenset(
        symbol.id
        for symbol in symbols
        if (
            symbol.atom in state
            if isinstance(symbol, AtomSymbol)
            else action is not None and symbol.matches(action)
        )
    )


def _in_pddl(symbol: Symbol) -> str:
    if isinstance(symbol, AtomSymbol):
        return f"({symbol.atom})"
    return f"({' '.join([symbol.action, *symbol.arguments])})"


def _rest(text: str, head: str) -> str | None:
    """What follows the head: '' for nothing, None when the text does not start with it."""
    if text == head:
        return ""
    return text[len(head) + 1 :] or None if text.startswith(head + "_") else None


def _split(text: str | None, fitting: Sequence[Sequence[str]]) -> Iterator[tuple[str, ...]]:
    """Every way to read a flattened text as one object for each place."""
    if text is None:
        return
    if not fitting:
        if not text:
            yield ()
        return
    for candidate in fitting[0]:
        for others in _split(_rest(text, flat(candidate)), fitting[1:]):
            yield (candidate, *others)


def _subsequences(text: str, places: Sequence[Sequence[str]]) -> Iterator[tuple[str, ...]]:
    """Every way to read a flattened text as objects for some of the places, in order."""
    if not text:
        yield ()
        return
    for place, candidates in enumerate(places, start=1):
        for candidate in candidates:
            rest = _rest(text, flat(candidate))
            if rest is not None:
                for others in _subsequences(rest, places[place:]):
                    yield (candidate, *others)


def _places(parameters: Iterable[Parameter], problem: Problem) -> list[tuple[str, ...]]:
    return [problem.objects_for(parameter) for parameter in parameters]


def _atoms(symbol: SymbolId, wanted: str, problem: Problem) -> Iterator[Symbol]:
    for predicate, parameters in problem.domain.predicates.items():
        for arguments in _split(_rest(wanted, flat(predicate)), _places(parameters, problem)):
            yield AtomSymbol(symbol, " ".join([predicate, *arguments]))


def _actions(symbol: SymbolId, wanted: str, problem: Problem) -> Iterator[Symbol]:
    for schema in problem.domain.actions:
        if wanted == f"{flat(schema.name)}_executed":
            yield ActionSymbol(symbol, schema.name)


def _actions_of_a_robot(symbol: SymbolId, wanted: str, problem: Problem) -> Iterator[Symbol]:
    robot, _, name = wanted.partition("_executes_")
    for schema in problem.domain.actions:
        if name == flat(schema.name):
            for place in _places(schema.parameters, problem):
                for candidate in place:
                    if flat(candidate) == robot:
                        yield ActionSymbol(symbol, schema.name, (candidate,))


def _actions_with_arguments(symbol: SymbolId, wanted: str, problem: Problem) -> Iterator[Symbol]:
    if not wanted.endswith("_executed"):
        return
    for schema in problem.domain.actions:
        text = _rest(wanted.removesuffix("_executed"), flat(schema.name))
        if text:
            for arguments in _subsequences(text, _places(schema.parameters, problem)):
                yield ActionSymbol(symbol, schema.name, arguments)


def _some_ids(problem: Problem) -> Iterator[SymbolId]:
    """Ids to suggest from: the actions', the initial state's, and atoms of up to two places."""
    for schema in problem.domain.actions:
        yield f"{flat(schema.name)}_executed"
    yield from sorted(map(flat, problem.initial))
    for predicate, parameters in problem.domain.predicates.items():
        if len(parameters) <= 2:
            for binding in problem.bindings(parameters):
                yield flat(" ".join([predicate, *binding.values()]))
