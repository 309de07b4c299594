"""The symbols that a formula may use of a planning problem, and what each one denotes.

An id is a ground atom flattened with underscores (`robot_at_rob_l0`), or an action symbol:

    <action>_executed                any instance of the action
    <robot>_executes_<action>        any instance that has the robot among its arguments
    <action>_<arg>_..._executed      the instances with these arguments, in this order
                                     (all of them for one instance; fewer for several)

An action symbol is true at the instant that an execution leads to, and never at s0.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from plainspoken.errors import UnknownSymbolError
from plainspoken.world.domain import GroundAction, GroundAtom, Problem, State

SymbolId = str


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

    A ground atom goes before an action symbol of the same id.
    raises UnknownSymbolError: when nothing in the problem has this id
    """
    wanted = symbol.lower()
    for predicate, parameters in problem.domain.predicates.items():
        fitting = [problem.objects_for(parameter) for parameter in parameters]
        for arguments in _split(_rest(wanted, flat(predicate)), fitting):
            return AtomSymbol(symbol, " ".join([predicate, *arguments]))
    action = _action_symbol(symbol, wanted, problem)
    if action is None:
        raise UnknownSymbolError(symbol, _some_ids(problem))
    return action


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


def _rest(text: str, head: str) -> str | None:
    """What follows the head: '' for nothing, None when the text does not start with it."""
    if text == head:
        return ""
    return text[len(head) + 1 :] if text.startswith(head + "_") else None


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


def _subsequence(text: str, places: Sequence[Sequence[str]]) -> tuple[str, ...] | None:
    """Read a flattened text as objects for some of the places, in order."""
    if not text:
        return ()
    for skipped in range(len(places)):
        for candidate in places[skipped]:
            rest = _rest(text, flat(candidate))
            if rest is not None:
                others = _subsequence(rest, places[skipped + 1 :])
                if others is not None:
                    return (candidate, *others)
    return None


def _action_symbol(symbol: SymbolId, wanted: str, problem: Problem) -> ActionSymbol | None:
    for schema in problem.domain.actions:
        places = [problem.objects_for(parameter) for parameter in schema.parameters]
        if wanted.endswith("_executed"):
            rest = _rest(wanted.removesuffix("_executed"), flat(schema.name))
            if rest is not None:
                arguments = _subsequence(rest, places)
                if arguments is not None:
                    return ActionSymbol(symbol, schema.name, arguments)
        robot, separator, name = wanted.partition("_executes_")
        if separator and name == flat(schema.name):
            for candidate in dict.fromkeys(o for place in places for o in place):
                if flat(candidate) == robot:
                    return ActionSymbol(symbol, schema.name, (candidate,))
    return None


def _some_ids(problem: Problem) -> Iterator[SymbolId]:
    """Ids to suggest from: the initial state's, the actions', and all atoms of one place."""
    yield from map(flat, problem.initial)
    for predicate, parameters in problem.domain.predicates.items():
        if len(parameters) <= 2:
            for binding in problem.bindings(parameters):
                yield flat(" ".join([predicate, *binding.values()]))
    for schema in problem.domain.actions:
        yield f"{flat(schema.name)}_executed"
