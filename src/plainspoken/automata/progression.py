"""Progression: what a formula still asks for after one instant has been seen.

A *residual* is a formula about the instants that are left, of which there may be none.
`progress` turns a formula and a letter into a residual; `satisfied_at_end` says whether the
residual holds when nothing is left. Over no instants, literals, `X`, `F` and `U` are false and
`WX`, `G`, `W` and `R` are true; so "there is a next instant" is `F true`, and "there is none" is
`G false`.

Source: Bacchus and Kabanza, Planning for temporally extended goals, AMAI 1998, section 3, for
the rules; finite traces after De Giacomo and Vardi, IJCAI 2013.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import reduce

from plainspoken.logic.formula import (
    FALSE,
    TRUE,
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
    conjunction,
    disjunction,
    negation_normal_form,
)
from plainspoken.logic.trace import Letter

SOME_INSTANT_LEFT = Eventually(TRUE)
NO_INSTANT_LEFT = Always(FALSE)


def progress(residual: Formula, letter: Letter) -> Formula:
    """The residual after one more instant, in negation normal form."""
    return _progress(negation_normal_form(residual), letter)


def _progress(formula: Formula, letter: Letter) -> Formula:
    match formula:
        case Constant():
            return formula
        case Atom(name):
            return Constant(name in letter)
        case Not(Atom(name)):
            return Constant(name not in letter)
        case And(operands):
            return all_of(*(_progress(f, letter) for f in operands))
        case Or(operands):
            return any_of(*(_progress(f, letter) for f in operands))
        case Next(f):
            return all_of(f, SOME_INSTANT_LEFT)
        case WeakNext(f):
            return any_of(f, NO_INSTANT_LEFT)
        case Eventually(f):
            return any_of(_progress(f, letter), formula)
        case Always(f):
            return all_of(_progress(f, letter), formula)
        case Until(hold, goal):
            return any_of(_progress(goal, letter), all_of(_progress(hold, letter), formula))
        case Release(release, hold):
            return all_of(_progress(hold, letter), any_of(_progress(release, letter), formula))
        case _:
            raise AssertionError(f"not in negation normal form: {formula}")


def satisfied_at_end(residual: Formula) -> bool:
    """Whether the residual holds when no instant is left."""
    return _at_end(negation_normal_form(residual))


def _at_end(formula: Formula) -> bool:
    match formula:
        case Constant(value):
            return value
        case And(operands):
            return all(map(_at_end, operands))
        case Or(operands):
            return any(map(_at_end, operands))
        case WeakNext() | Always() | Release():
            return True
        case _:
            return False


def remaining(formula: Formula, letters: Iterable[Letter]) -> Formula:
    """What is left of a formula to plan for, after the instants seen so far.

    The result is about a trace that starts at the *last* instant seen, the current one, whose
    action symbols have been spent: it speaks of the instants after it only.
    """
    residual = reduce(progress, letters, negation_normal_form(formula))
    if isinstance(residual, Constant):
        return residual
    return WeakNext(residual) if satisfied_at_end(residual) else Next(residual)


def all_of(*residuals: Formula) -> Formula:
    """Conjunction of residuals, simplified; each operand once."""
    joined = conjunction(*residuals)
    if not isinstance(joined, And):
        return joined
    operands = tuple(dict.fromkeys(joined.operands))
    return FALSE if FALSE in operands else conjunction(*operands)


def any_of(*residuals: Formula) -> Formula:
    """Disjunction of residuals, simplified; each operand once."""
    joined = disjunction(*residuals)
    if not isinstance(joined, Or):
        return joined
    operands = tuple(dict.fromkeys(joined.operands))
    return TRUE if TRUE in operands else disjunction(*operands)


Entailments = dict[tuple[int, int], bool]
"""What `entails` found, by the `id` of two formulas that somebody else keeps alive."""


def entails(stronger: Formula, weaker: Formula, known: Entailments | None = None) -> bool:
    """Whether one residual plainly entails another, over any number of instants left, none too.

    Sound and far from complete: a few rules that keep the automata of nested `F`, `U` and `G`
    small. Both in negation normal form.
    known: earlier answers about the same objects; without them the rules may try a pair of
           subformulas exponentially often
    """
    if known is None:
        known = {}
    key = (id(stronger), id(weaker))
    if key not in known:
        known[key] = _entails(stronger, weaker, known)
    return known[key]


def _entails(stronger: Formula, weaker: Formula, known: Entailments) -> bool:
    def follows(left: Formula, right: Formula) -> bool:
        return entails(left, right, known)

    if stronger in (weaker, FALSE) or weaker == TRUE:
        return True
    match stronger, weaker:
        case Or(operands), _:
            return all(follows(f, weaker) for f in operands)
        case _, And(operands):
            return all(follows(stronger, f) for f in operands)
        case And(operands), _ if any(follows(f, weaker) for f in operands):
            return True
        case _, Or(operands) if any(follows(stronger, f) for f in operands):
            return True
        # A goal that is met at once; over no instants `F` and `U` are false, whatever the goal.
        case _, Eventually(goal) | Until(_, goal) if not _at_end(stronger) and follows(
            stronger, goal
        ):
            return True
        # What holds throughout holds at once; over no instants `G` and `R` are true.
        case Always(hold) | Release(_, hold), _ if _at_end(weaker) and follows(hold, weaker):
            return True
        case Eventually(goal) | Until(_, goal), Eventually():
            return follows(goal, weaker)
        case Until(hold, goal), Until(weaker_hold, weaker_goal):
            return follows(hold, weaker_hold) and follows(goal, weaker_goal)
        case Always(f), Always(hold) | Release(_, hold):
            return follows(f, hold) or follows(stronger, hold)
        case Release(release, hold), Release(weaker_release, weaker_hold):
            return follows(release, weaker_release) and follows(hold, weaker_hold)
        case _:
            return False
