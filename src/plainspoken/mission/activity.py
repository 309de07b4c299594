"""What an action of the domain is on a robot: one call of a service, or a whole activity.

A frozen value, read from a configuration and checked there; `backends.activities` has it carried
out. The words for the kinds of nodes are those of behaviour trees.

Source: Colledanchise and Ögren, Behavior Trees in Robotics and AI, 2018, section 1.3.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from plainspoken.mission.robot import Seconds
from plainspoken.mission.service import Fields
from plainspoken.mission.template import filled
from plainspoken.world.domain import GroundAtom, State


@dataclass(frozen=True, slots=True)
class Literal:
    """A fact that is, or is not, to be true; a template while an action's arguments are open."""

    atom: GroundAtom
    wanted: bool = True

    @classmethod
    def of(cls, text: str) -> Literal:
        """Read `full b` or `not full b`."""
        words = text.lower().split()
        negated = words[:1] == ["not"]
        return cls(" ".join(words[1:] if negated else words), not negated)

    def bound(self, arguments: Mapping[str, str]) -> Literal:
        return Literal(filled(self.atom, arguments), self.wanted)

    def holds_in(self, state: State) -> bool:
        return (self.atom in state) == self.wanted

    def __str__(self) -> str:
        return self.atom if self.wanted else f"not {self.atom}"


@dataclass(frozen=True, slots=True)
class Call:
    """One call of a service.

    fields:   templates over the action's arguments
    words:    what it is, in words, for people who ask; a template
    expected: what the result has to be for the call to succeed, beside what the service says
    """

    service: str
    fields: Fields = field(default_factory=dict)
    words: str | None = None
    expected: Fields = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Condition:
    """Whether facts hold at this moment."""

    facts: tuple[Literal, ...]


@dataclass(frozen=True, slots=True)
class Sequence:
    """One part after the other; fails with the first that does."""

    parts: tuple[Activity, ...]


@dataclass(frozen=True, slots=True)
class Selection:
    """One part after the other until one succeeds; fails with the last."""

    parts: tuple[Activity, ...]


@dataclass(frozen=True, slots=True)
class Parallel:
    """All parts at once; fails with the first that does, and has the others given up.

    one: whether one part's success is enough; otherwise all have to succeed
    """

    parts: tuple[Activity, ...]
    one: bool = False


@dataclass(frozen=True, slots=True)
class Retry:
    """A part once more after each failure, with a longer pause each time.

    times:   how often in all
    pause:   before the second time; growth: how much longer each next one is; longest: at most
    """

    part: Activity
    times: int
    pause: Seconds = 0.0
    growth: float = 2.0
    longest: Seconds = 60.0

    def pause_after(self, failures: int) -> Seconds:
        """How long to wait after so many failures, at least one."""
        return float(min(self.pause * self.growth ** (failures - 1), self.longest))


@dataclass(frozen=True, slots=True)
class Within:
    """A part that fails, and is given up, when it takes longer than so many seconds."""

    part: Activity
    seconds: Seconds


Activity = Call | Condition | Sequence | Selection | Parallel | Retry | Within


def parts_of(activity: Activity) -> tuple[Activity, ...]:
    """What an activity consists of, one level down."""
    match activity:
        case Sequence(parts) | Selection(parts) | Parallel(parts):
            return parts
        case Retry(part) | Within(part):
            return (part,)
        case Call() | Condition():
            return ()


def calls_in(activity: Activity) -> Iterator[Call]:
    """Every call of an activity, in its order."""
    if isinstance(activity, Call):
        yield activity
    for part in parts_of(activity):
        yield from calls_in(part)
