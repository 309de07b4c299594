"""From a non-deterministic domain and a formula to a policy, or to the reason why there is none.

    from plainspoken.planning import Solved, solve, validate

    ending = solve(problem, parse("F cleared_l2 & G !robot_at_rob_l3"))
    if isinstance(ending, Solved):
        assert isinstance(validate(problem, goal, ending.policy), Valid)

These names are looked up on demand: whoever only reads a policy need not load the search.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plainspoken.planning.goal import problem_goal
    from plainspoken.planning.policy import Policy
    from plainspoken.planning.solver import OutOfTime, Solved, Unsolvable, solve
    from plainspoken.planning.validation import Invalid, Valid, validate

_HOMES = {
    "Invalid": "validation",
    "OutOfTime": "solver",
    "Policy": "policy",
    "Solved": "solver",
    "Unsolvable": "solver",
    "Valid": "validation",
    "problem_goal": "goal",
    "solve": "solver",
    "validate": "validation",
}

__all__ = [
    "Invalid",
    "OutOfTime",
    "Policy",
    "Solved",
    "Unsolvable",
    "Valid",
    "problem_goal",
    "solve",
    "validate",
]


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module 'plainspoken.planning' has no attribute {name!r}")
    return getattr(import_module(f"plainspoken.planning.{_HOMES[name]}"), name)
