"""Judges a reason for there being no policy by exhaustive fixpoints over the plain scene."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from tests.planning.brute import Node, is_solvable, space

from plainspoken.automata.construction import Automaton
from plainspoken.logic.formula import TRUE, Formula, conjunction
from plainspoken.planning.fixpoint import Space, strong_cyclic_choice
from plainspoken.planning.reason import (
    Contradiction,
    LuckyWay,
    NeverFalse,
    NeverTrue,
    NoGuarantee,
    OnlyByRetrying,
    Reason,
    ViolatedAtStart,
)
from plainspoken.world.domain import GroundAction, Problem


def fault(problem: Problem, goal: Formula, reason: Reason, *, strong: bool) -> str | None:
    """What is wrong with a reason why a goal has no policy; None where it is right."""

    def impossible(parts: Sequence[Formula]) -> bool:
        return not is_solvable(problem, _all(parts), strong=strong)

    match reason:
        case Contradiction(parts, minimal):
            return _fault(parts, minimal, lambda some: not _satisfiable(_all(some)))
        case ViolatedAtStart(part) | NeverTrue(_, part) | NeverFalse(_, part):
            return None if impossible([part]) else "the part is possible"
        case OnlyByRetrying(parts, minimal):
            if not is_solvable(problem, goal, strong=False):
                return "retrying does not help"
            return _fault(parts, minimal, impossible)
        case NoGuarantee(parts, minimal, _, lucky, way):
            wrong = _fault(parts, minimal, impossible)
            found = space(problem, _all(parts))
            if lucky is not None and lucky != (found.initial in with_luck(found)):
                return "wrong about luck"
            return wrong or (None if way is None else _fault_of_way(space(problem, goal), way))


def _all(parts: Sequence[Formula]) -> Formula:
    return conjunction(*parts) if parts else TRUE


def _satisfiable(formula: Formula) -> bool:
    automaton = Automaton(formula)
    # A trace has one instant at least, so the first state does not count.
    return any(automaton.can_accept(g.target) for g in automaton.guards(automaton.initial))


def _fault(
    parts: tuple[Formula, ...],
    minimal: bool,  # noqa: FBT001 - as the reason has it
    impossible: Callable[[Sequence[Formula]], bool],
) -> str | None:
    if not impossible(parts):
        return "the parts are possible together"
    for part in parts if minimal else ():
        if impossible([other for other in parts if other is not part]):
            return "a part is not needed"
    return None


def with_luck(space: Space[Node, GroundAction]) -> set[Node]:
    """The nodes from which a goal is reached if outcomes could be chosen."""
    found = set(space.goals)
    while True:
        more = {
            node
            for node, actions in space.choices.items()
            if node not in found and any(found & set(after) for after in actions.values())
        }
        if not more:
            return found
        found |= more


def _fault_of_way(space: Space[Node, GroundAction], way: LuckyWay) -> str | None:
    """Whether the actions can reach a goal, and one outcome of the breach has no policy."""
    live = set(strong_cyclic_choice(space)) | space.goals
    nodes = {space.initial}
    breached = False
    for action in way.actions:
        after = {each for node in nodes for each in space.choices[node].get(action, ())}
        if way.breach is not None and action == way.breach.action:
            breached |= any(
                node not in live and node[0].issuperset(way.breach.added) for node in after
            )
        nodes = after
    if not nodes & space.goals:
        return "the lucky way does not lead to a goal"
    if way.breach is None:
        return "the lucky way is said to be safe"
    return None if breached else "the outcome does not break it"
