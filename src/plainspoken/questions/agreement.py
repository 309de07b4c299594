"""Two readers of one question, rules and a listener that has learned: the surer one wins.

They go wrong in different places. What each is worth was fitted on missions that neither had seen:
`python -m training.questions --held-out`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from plainspoken.questions.kind import Kind

RULES = 0.5
"""What the word of the rules adds to the log of a chance."""
UNSURE = 0.3
"""Below this chance a reading is wrong more often than right, and the person is asked."""
_LEAST = 1e-6


@dataclass(frozen=True, slots=True)
class Settled:
    """What both readers make of a question.

    chance: that it is of this kind
    other:  the likeliest other kind
    """

    kind: Kind
    chance: float
    other: Kind

    @property
    def unsure(self) -> bool:
        return self.chance < UNSURE


def settled(ruled: Kind, heard: Mapping[Kind, float]) -> Settled:
    """Weigh the kind that the rules say against the chances that the listener gives."""
    scores = {
        kind: math.log(max(chance, _LEAST)) + RULES * (kind is ruled)
        for kind, chance in heard.items()
    }
    first, second = sorted(scores, key=lambda kind: -scores[kind])[:2]
    total = sum(math.exp(score) for score in scores.values())
    return Settled(first, math.exp(scores[first]) / total, second)
