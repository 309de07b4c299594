"""What is asked of a policy: formulas, the problem's own goal, and what their atoms denote.

An atom of a formula is an id as in `world.symbol`. The problem's own goal may hold atoms that
have no id of their own (two atoms may flatten to one id, or to a word of the grammar); such an
atom stands in the formula as the ground atom itself, with its spaces and hyphens.
"""

from __future__ import annotations

from plainspoken.errors import UnknownSymbolError
from plainspoken.logic.formula import (
    FALSE,
    TRUE,
    Atom,
    Constant,
    Eventually,
    Formula,
    Not,
    atoms,
    conjunction,
    disjunction,
    substituted,
)
from plainspoken.logic.syntax import is_proposition
from plainspoken.planning.schema import Every, Literal, Row, Same, Some, Test, goal_test
from plainspoken.world.domain import GroundAtom, Problem
from plainspoken.world.symbol import AtomSymbol, Symbol, SymbolId, flat, resolve


def problem_goal(problem: Problem) -> Formula:
    """The problem's own `:goal` as a formula: eventually, its condition.

    Quantifiers are expanded over the objects.
    """
    test, row = goal_test(problem.goal, problem)
    return Eventually(_formula(test, row, problem))


def denoted(name: SymbolId, problem: Problem) -> Symbol:
    """What an atom of a formula denotes: a ground atom itself, or what its id resolves to.

    raises UnknownSymbolError: when nothing in the problem has this id
    """
    if not is_proposition(name):
        predicate, *arguments = name.split()
        parameters = problem.domain.predicates.get(predicate)
        if parameters is None or len(parameters) != len(arguments):
            raise UnknownSymbolError(name, problem.domain.predicates)
        return AtomSymbol(name, name)
    return resolve(name, problem)


def denotations(formula: Formula, problem: Problem) -> dict[SymbolId, Symbol]:
    """What each atom of a formula denotes, in sorted order.

    raises UnknownSymbolError: when nothing in the problem has an id
    """
    return {name: denoted(name, problem) for name in sorted(atoms(formula))}


def simplified(formula: Formula, constants: dict[SymbolId, bool]) -> Formula:
    """The formula with some atoms replaced by `true` or `false`."""
    if not constants:
        return formula
    return substituted(
        formula, lambda name: Constant(constants[name]) if name in constants else Atom(name)
    )


def _id_of(atom: GroundAtom, problem: Problem) -> SymbolId:
    """The id of a ground atom where it has one of its own, else the atom itself."""
    id = flat(atom)
    if not is_proposition(id):
        return atom
    try:
        symbol = resolve(id, problem)
    except UnknownSymbolError:
        return atom
    return id if isinstance(symbol, AtomSymbol) and symbol.atom == atom else atom


def _formula(test: Test, row: Row, problem: Problem) -> Formula:
    match test:
        case Literal():
            atom = Atom(_id_of(" ".join(test.fact(row)), problem))
            return atom if test.positive else Not(atom)
        case Same(left, right, positive):
            return TRUE if (row[left] == row[right]) == positive else FALSE
        case Every(parts):
            return conjunction(*(_formula(part, row, problem) for part in parts))
        case Some(parts):
            return disjunction(*(_formula(part, row, problem) for part in parts))
