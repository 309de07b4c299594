"""What is not as a mission expected it."""

from __future__ import annotations

from plainspoken.mission.mission import Mission
from plainspoken.world.domain import State
from plainspoken.world.scene import is_applicable, successors


def surprise(mission: Mission) -> str:
    """What differs from the outcome that comes nearest to the observed state."""
    static, action = mission.brief.static, mission.led_by
    expected: tuple[State, ...] = (mission.previous | static,)
    if action is not None and is_applicable(mission.brief.problem, expected[0], action):
        expected = successors(mission.brief.problem, expected[0], action)
    nearest = min(expected, key=lambda state: len(state ^ mission.world))
    appeared, gone = difference(nearest, mission.world)
    changes = [
        *(f"{atom} is true and should be false" for atom in appeared),
        *(f"{atom} is false and should be true" for atom in gone),
    ]
    where = f"after {action}" if action is not None else "with no action"
    return f"{where}: {'; '.join(changes) or 'a state that the policy does not foresee'}"


def difference(before: State, now: State) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The atoms that became true, and those that became false."""
    return tuple(sorted(now - before)), tuple(sorted(before - now))
