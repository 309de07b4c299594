"""The exhaustive judge: plain fixpoints over all reachable product states.

Slow and simple on purpose. It proves that there is no policy, and the search is tested against
it.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable
from dataclasses import dataclass
from typing import Generic, TypeVar

S = TypeVar("S", bound=Hashable)
A = TypeVar("A", bound=Hashable)


@dataclass(frozen=True)
class Space(Generic[S, A]):
    """Reachable states with the actions applicable in each, and the states that are goals.

    No actions are listed at goals: a policy stops there.
    """

    initial: S
    choices: dict[S, dict[A, tuple[S, ...]]]
    goals: frozenset[S]


def reachable_space(
    initial: S,
    is_goal: Callable[[S], bool],
    choices: Callable[[S], Iterable[tuple[A, tuple[S, ...]]]],
    most: int | None = None,
    expired: Callable[[], bool] = lambda: False,
) -> Space[S, A] | None:
    """Explore everything reachable; None past `most` states, or out of time."""
    found: dict[S, dict[A, tuple[S, ...]]] = {}
    goals: list[S] = []
    todo = [initial]
    seen = {initial}
    while todo:
        if (most is not None and len(seen) > most) or expired():
            return None
        state = todo.pop()
        if is_goal(state):
            goals.append(state)
            found[state] = {}
            continue
        found[state] = dict(choices(state))
        for after in found[state].values():
            for successor in after:
                if successor not in seen:
                    seen.add(successor)
                    todo.append(successor)
    return Space(initial, found, frozenset(goals))


def strong_choice(space: Space[S, A]) -> dict[S, A]:
    """The states from which a goal is reached within a bound, whatever happens, and how."""
    solved: set[S] = set(space.goals)
    chosen: dict[S, A] = {}
    predecessors = _predecessors(space)
    waiting = {
        (state, action): len(set(after))
        for state, actions in space.choices.items()
        for action, after in actions.items()
    }
    layer = list(space.goals)
    while layer:
        following: list[S] = []
        for state in layer:
            for before, action in predecessors.get(state, ()):
                waiting[before, action] -= 1
                if waiting[before, action] == 0 and before not in solved:
                    solved.add(before)
                    chosen[before] = action
                    following.append(before)
        layer = following
    return chosen


def strong_cyclic_choice(space: Space[S, A]) -> dict[S, A]:
    """The states from which a goal stays reachable whatever happens, and how.

    Greatest fixpoint over states that are not given up, of the least fixpoint of those that can
    reach a goal by actions that leave no state given up.
    """
    kept: set[S] = set(space.choices)
    predecessors = _predecessors(space)
    while True:
        reached: set[S] = set(space.goals)
        chosen: dict[S, A] = {}
        layer = list(space.goals)
        while layer:
            following: list[S] = []
            for state in layer:
                for before, action in predecessors.get(state, ()):
                    if before in reached or before not in kept:
                        continue
                    if all(after in kept for after in space.choices[before][action]):
                        reached.add(before)
                        chosen[before] = action
                        following.append(before)
            layer = following
        if reached == kept:
            return chosen
        kept = reached


def _predecessors(space: Space[S, A]) -> dict[S, list[tuple[S, A]]]:
    found: dict[S, list[tuple[S, A]]] = {}
    for state, actions in space.choices.items():
        for action, after in actions.items():
            for successor in dict.fromkeys(after):
                found.setdefault(successor, []).append((state, action))
    return found
