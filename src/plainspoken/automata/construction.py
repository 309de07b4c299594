"""Deterministic automata of LTLf formulas, built by progression and only where they are asked.

A state is a residual in a normal form: a set of clauses, each a set of obligations (temporal
subformulas), read as "all obligations of some clause". Formulas in negation normal form progress
to monotone combinations of obligations, whose least such set is unique; so equal residuals are
one state, and there are finitely many. Obligations and clauses that plainly follow from others
are dropped (`progression.entails`).

Conjuncts are kept apart as automata of their own (`automata_for`): their product is explored
only where a planner goes.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property, reduce
from typing import Generic, TypeVar

from plainspoken.automata.progression import (
    NO_INSTANT_LEFT,
    SOME_INSTANT_LEFT,
    Entailments,
    all_of,
    any_of,
    entails,
    satisfied_at_end,
)
from plainspoken.errors import FormulaTooLargeError
from plainspoken.logic.formula import (
    Always,
    And,
    Atom,
    Constant,
    Eventually,
    Formula,
    Next,
    Not,
    Or,
    Release,
    Until,
    WeakNext,
    atoms,
    conjuncts,
    negation_normal_form,
)
from plainspoken.logic.syntax import unparse
from plainspoken.logic.trace import Letter

StateId = int
Clause = frozenset[int]
"""Obligations, by their number in the automaton that they belong to."""
Residual = frozenset[Clause]
"""Some clause has all its obligations met. No clause: false. The empty clause: true."""

MOST_GUARDS = 100_000
"""An automaton with more guards is not explored to the end (see `can_accept`)."""
MOST_GUARDS_OF_A_STATE = 10_000

_FALSE: Residual = frozenset()
_TRUE: Residual = frozenset({frozenset()})


@dataclass(frozen=True, slots=True)
class Guard:
    """The letters with all of `positive` and none of `negative` lead to `target`."""

    positive: frozenset[str]
    negative: frozenset[str]
    target: StateId

    def admits(self, letter: Letter) -> bool:
        return self.positive <= letter and not (self.negative & letter)


class Automaton:
    """The automaton of one formula. `initial` has read nothing, not even s0.

    atoms: the propositions it reads, sorted
    """

    initial: StateId = 0

    def __init__(self, formula: Formula) -> None:
        self.formula = formula
        normal = negation_normal_form(formula)
        self.atoms: tuple[str, ...] = tuple(sorted(atoms(normal)))
        self._reads = frozenset(self.atoms)
        self._residuals = _Residuals()
        self._states: list[Residual] = []
        self._numbers: dict[Residual, StateId] = {}
        self._steps: dict[tuple[StateId, Letter], StateId] = {}
        self._guards: dict[StateId, tuple[Guard, ...]] = {}
        self._cubes: dict[Formula, _Cubes] = {}
        self._number(self._residuals.of(normal))

    def __len__(self) -> int:
        """How many states have been met so far."""
        return len(self._states)

    def _number(self, residual: Residual) -> StateId:
        number = self._numbers.setdefault(residual, len(self._states))
        if number == len(self._states):
            self._states.append(residual)
        return number

    def step(self, state: StateId, letter: Letter) -> StateId:
        """The state after one more instant; propositions it does not read are ignored."""
        seen = letter & self._reads
        key = (state, seen)
        target = self._steps.get(key)
        if target is None:
            algebra = _Algebra(
                literal=lambda name, positive: _TRUE if (name in seen) == positive else _FALSE,
                residual=lambda residual: residual,
                meet=self._residuals.meet,
                join=self._residuals.join,
            )
            after = _unfolded(self.residual(state), algebra, self._residuals)
            target = self._steps[key] = self._number(after)
        return target

    def accepts(self, state: StateId) -> bool:
        """Whether the trace may end here."""
        return satisfied_at_end(self.residual(state))

    def residual(self, state: StateId) -> Formula:
        """What the state still asks of the instants that are left."""
        return self._residuals.formula(self._states[state])

    def guards(self, state: StateId) -> tuple[Guard, ...]:
        """Where each letter leads, as cubes that are disjoint and cover all letters.

        raises FormulaTooLargeError: when there are more than MOST_GUARDS_OF_A_STATE
        """
        if state not in self._guards:
            algebra = _Algebra(
                literal=_cubes_of_literal,
                residual=lambda residual: ((frozenset(), frozenset(), residual),),
                meet=lambda a, b: _product(a, b, _FALSE, self._residuals.meet),
                join=lambda a, b: _product(a, b, _TRUE, self._residuals.join),
            )
            try:
                cubes = _unfolded(self.residual(state), algebra, self._residuals, self._cubes)
            except _TooManyCubes:
                raise FormulaTooLargeError(unparse(self.formula)) from None
            self._guards[state] = tuple(
                Guard(positive, negative, self._number(residual))
                for positive, negative, residual in cubes
            )
        return self._guards[state]

    def can_accept(self, state: StateId) -> bool:
        """Whether some way to go on (stopping here is one) satisfies the formula.

        True as well where the automaton is too large to know: a planner may then search in
        vain, but loses nothing.
        """
        accepting = self._fates[0]
        return accepting is None or state in accepting

    def must_accept(self, state: StateId) -> bool:
        """Whether every way to go on satisfies the formula. False where that is not known."""
        rejecting = self._fates[1]
        return rejecting is not None and state not in rejecting

    @cached_property
    def _fates(self) -> tuple[frozenset[StateId] | None, frozenset[StateId] | None]:
        """The states from which an accepting, and from which a rejecting state is reachable."""
        predecessors: dict[StateId, set[StateId]] = {}
        state = met = 0
        # Guards number new states as they meet them; the loop ends when there are none.
        while state < len(self._states):
            try:
                guards = self.guards(state)
            except FormulaTooLargeError:
                return None, None
            met += len(guards)
            if met > MOST_GUARDS:
                return None, None
            for guard in guards:
                predecessors.setdefault(guard.target, set()).add(state)
            state += 1
        accepting = {s for s in range(len(self)) if self.accepts(s)}
        rejecting = set(range(len(self))) - accepting
        return _reaching(accepting, predecessors), _reaching(rejecting, predecessors)


def automata_for(formula: Formula) -> tuple[Automaton, ...]:
    """One automaton for each conjunct; a trace satisfies the formula iff all of them accept."""
    return tuple(map(Automaton, dict.fromkeys(conjuncts(negation_normal_form(formula)))))


def _reaching(
    targets: Iterable[StateId], predecessors: dict[StateId, set[StateId]]
) -> frozenset[StateId]:
    found = set(targets)
    todo = list(found)
    while todo:
        for state in predecessors.get(todo.pop(), ()):
            if state not in found:
                found.add(state)
                todo.append(state)
    return frozenset(found)


class _Residuals:
    """Residuals of one automaton in normal form, with its obligations numbered as they come."""

    def __init__(self) -> None:
        self._obligations: list[Formula] = []
        self._numbers: dict[Formula, int] = {}
        self._entailed: dict[tuple[int, int], bool] = {}
        self._known: Entailments = {}
        self._met: dict[tuple[Residual, Residual], Residual] = {}
        self._joined: dict[tuple[Residual, Residual], Residual] = {}

    def of(self, formula: Formula) -> Residual:
        """A formula about the instants left as clauses of obligations."""
        match formula:
            case Constant(value):
                return _TRUE if value else _FALSE
            case And(operands):
                return reduce(self.meet, map(self.of, operands))
            case Or(operands):
                return reduce(self.join, map(self.of, operands))
            case _:
                number = self._numbers.setdefault(formula, len(self._obligations))
                if number == len(self._obligations):
                    self._obligations.append(formula)
                return frozenset({frozenset({number})})

    def formula(self, residual: Residual) -> Formula:
        """The clauses as a formula again."""
        return any_of(
            *(
                all_of(*(self._obligations[number] for number in sorted(clause)))
                for clause in sorted(residual, key=sorted)
            )
        )

    def meet(self, left: Residual, right: Residual) -> Residual:
        """Both hold."""
        if left == _TRUE or right == _FALSE:
            return right
        if right == _TRUE or left == _FALSE:
            return left
        key = (left, right)
        if key not in self._met:
            self._met[key] = self._least(self._tight(a | b) for a in left for b in right)
        return self._met[key]

    def join(self, left: Residual, right: Residual) -> Residual:
        """One of them holds."""
        if left == _FALSE or right == _TRUE:
            return right
        if right == _FALSE or left == _TRUE:
            return left
        key = (left, right)
        if key not in self._joined:
            self._joined[key] = self._least(left | right)
        return self._joined[key]

    def _entails(self, stronger: int, weaker: int) -> bool:
        key = (stronger, weaker)
        if key not in self._entailed:
            self._entailed[key] = entails(
                self._obligations[stronger], self._obligations[weaker], self._known
            )
        return self._entailed[key]

    def _tight(self, clause: Clause) -> Clause:
        """Without the obligations that follow from others; of equals the first is kept."""
        kept: list[int] = []
        for obligation in sorted(clause):
            if not any(self._entails(other, obligation) for other in kept):
                kept = [other for other in kept if not self._entails(obligation, other)]
                kept.append(obligation)
        return frozenset(kept)

    def _least(self, clauses: Iterable[Clause]) -> Residual:
        """Without the clauses that entail others; of equals the first is kept."""
        kept: list[Clause] = []
        for clause in sorted(set(clauses), key=lambda c: (len(c), sorted(c))):
            if not any(self._clause_entails(clause, other) for other in kept):
                kept = [other for other in kept if not self._clause_entails(other, clause)]
                kept.append(clause)
        return frozenset(kept)

    def _clause_entails(self, stronger: Clause, weaker: Clause) -> bool:
        return all(any(self._entails(f, g) for f in stronger) for g in weaker)


class _TooManyCubes(Exception):
    pass


V = TypeVar("V")


@dataclass(frozen=True, slots=True)
class _Algebra(Generic[V]):
    """What the parts of an unfolded formula are worth: a residual, or one for each letter."""

    literal: Callable[[str, bool], V]
    residual: Callable[[Residual], V]
    meet: Callable[[V, V], V]
    join: Callable[[V, V], V]


def _unfolded(
    formula: Formula,
    algebra: _Algebra[V],
    residuals: _Residuals,
    known: dict[Formula, V] | None = None,
) -> V:
    """One instant of progression: literals are about now, the rest is left for later.

    known: values of subformulas, where they can be kept from call to call
    """
    if known is None:
        known = {}
    if formula in known:
        return known[formula]
    meet, join = algebra.meet, algebra.join

    def now(part: Formula) -> V:
        return _unfolded(part, algebra, residuals, known)

    def later(part: Formula) -> V:
        return algebra.residual(residuals.of(part))

    match formula:
        case Constant():
            value = later(formula)
        case Atom(name):
            value = algebra.literal(name, True)
        case Not(Atom(name)):
            value = algebra.literal(name, False)
        case And(operands):
            value = reduce(meet, map(now, operands))
        case Or(operands):
            value = reduce(join, map(now, operands))
        case Next(f):
            value = meet(later(f), later(SOME_INSTANT_LEFT))
        case WeakNext(f):
            value = join(later(f), later(NO_INSTANT_LEFT))
        case Eventually(f):
            value = join(now(f), later(formula))
        case Always(f):
            value = meet(now(f), later(formula))
        case Until(hold, goal):
            value = join(now(goal), meet(now(hold), later(formula)))
        case Release(release, hold):
            value = meet(now(hold), join(now(release), later(formula)))
        case _:
            raise AssertionError(f"not in negation normal form: {formula}")
    known[formula] = value
    return value


_Cube = tuple[frozenset[str], frozenset[str], Residual]
_Cubes = tuple[_Cube, ...]
"""What is left after each letter: disjoint cubes that cover all letters."""


def _cubes_of_literal(name: str, positive: bool) -> _Cubes:  # noqa: FBT001 - an _Algebra's literal is called by position
    one, none = frozenset({name}), frozenset[str]()
    return (
        (one, none, _TRUE if positive else _FALSE),
        (none, one, _FALSE if positive else _TRUE),
    )


def _product(
    left: _Cubes,
    right: _Cubes,
    absorbing: Residual,
    combine: Callable[[Residual, Residual], Residual],
) -> _Cubes:
    """The letters common to a cube of each side; none is split where one side decides alone."""
    found: list[_Cube] = []
    for positive, negative, residual in left:
        if residual == absorbing:
            found.append((positive, negative, residual))
            continue
        for also_positive, also_negative, other in right:
            if not (positive & also_negative or negative & also_positive):
                joined = combine(residual, other)
                found.append((positive | also_positive, negative | also_negative, joined))
        if len(found) > MOST_GUARDS_OF_A_STATE:
            raise _TooManyCubes
    return _merged(found)


def _merged(cubes: Sequence[_Cube]) -> _Cubes:
    """The same letters in fewer cubes: two that differ in one sign only become one."""
    often = Counter(residual for _, _, residual in cubes)
    found: dict[tuple[frozenset[str], frozenset[str]], Residual] = {}
    todo = [*reversed(cubes)]
    while todo:
        positive, negative, residual = todo.pop()
        for name in sorted(positive | negative) if often[residual] > 1 else ():
            other = (positive ^ {name}, negative ^ {name})
            if found.get(other) == residual:
                del found[other]
                todo.append((positive - {name}, negative - {name}, residual))
                break
        else:
            found[positive, negative] = residual
    return tuple((positive, negative, residual) for (positive, negative), residual in found.items())
