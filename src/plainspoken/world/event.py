"""What happened: facts in the past tense, only ever appended to a log.

An entry of the log is one event with its step (its place in the log, from 0), the time and the
instant of the trace that was current *after* it. One JSON object a line is the file format of
CONTRACT: `step`, `time`, `kind`, `instant` and the fields of the event.

An instant begins where `instant` is one more than in the entry before; the event then holds the
`state` of that instant. A failed action, an observation or a report begins one only if it found
something changed, and no action led to it.

The first entry holds the domain, the problem and the landmarks as text, so that a log can be
understood alone.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import MISSING, dataclass, field, fields
from typing import Any, ClassVar

from plainspoken.world.domain import GroundAction, GroundAtom, State

Step = int
Instant = int


@dataclass(frozen=True, slots=True)
class MissionAccepted:
    """A mission was accepted; `state` is s0.

    sentence:  what the person said, None where the goal was given as a formula
    english:   the formula said back
    domain, problem: the PDDL texts; landmarks: the landmarks document
    robot: which robot and how it was set: {"name": "simulator", "seed": 7, "steering": [...]};
           under "senses" how facts come to be known (`world.sense`)
    unknown: atoms of which nobody knows at s0; `state` has those that are assumed to be true
    """

    kind: ClassVar[str] = "mission_accepted"
    mission: str
    sentence: str | None
    goal: str
    english: str
    domain: str
    problem: str
    landmarks: Mapping[str, Any]
    static: tuple[GroundAtom, ...]
    state: State
    robot: Mapping[str, Any] = field(default_factory=dict)
    unknown: tuple[GroundAtom, ...] = ()


@dataclass(frozen=True, slots=True)
class PolicyChosen:
    """A policy was found and validated. `policy` is the document that `plan --out` writes.

    reason: None for the first one; why there is another for the next ones
    repeats: where it is the one before, with an action taken out that was done before its turn,
             the nodes that are new, each with the one whose place it has
    """

    kind: ClassVar[str] = "policy_chosen"
    policy: Mapping[str, Any]
    reason: str | None = None
    repeats: Mapping[str, int] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class ActionStarted:
    """The robot was told to do an action; node is the policy node that says so.

    Another one may be under way: then this one is of another robot, and begins before its turn.
    """

    kind: ClassVar[str] = "action_started"
    action: GroundAction
    node: int
    goal_id: str


@dataclass(frozen=True, slots=True)
class ActionFinished:
    """The action came to an end, and the state after it was observed.

    node: the policy node that matches the state, None where none does
    misreported: the atoms of which the robot's result said the opposite of what was seen
    """

    kind: ClassVar[str] = "action_finished"
    action: GroundAction
    goal_id: str
    state: State
    node: int | None
    misreported: tuple[GroundAtom, ...] = ()


@dataclass(frozen=True, slots=True)
class ActionFailed:
    """The robot could not carry the action out; the state is as observed then."""

    kind: ClassVar[str] = "action_failed"
    action: GroundAction
    goal_id: str
    reason: str
    state: State


@dataclass(frozen=True, slots=True)
class ObservationMade:
    """Something was sensed outside an action; state is what is known now.

    sensed: where single facts were asked for, what each service told of each:
            [{"atom": ..., "holds": true, false or null, "by": service, "time": as it says}, ...];
            null is that it could not tell, "why" says why
    """

    kind: ClassVar[str] = "observation_made"
    source: str
    added: tuple[GroundAtom, ...]
    deleted: tuple[GroundAtom, ...]
    state: State
    sensed: tuple[Mapping[str, Any], ...] = ()


@dataclass(frozen=True, slots=True)
class LookRequested:
    """Somebody wants to know of these facts; what is sensed follows."""

    kind: ClassVar[str] = "look_requested"
    by: str
    atoms: tuple[GroundAtom, ...]


@dataclass(frozen=True, slots=True)
class ReportReceived:
    """A person said what they did or saw.

    told: what they said of each fact, [{"atom": ..., "holds": true or false}, ...], also of those
          that were believed to be so already
    """

    kind: ClassVar[str] = "report_received"
    reporter: str
    text: str
    added: tuple[GroundAtom, ...]
    deleted: tuple[GroundAtom, ...]
    state: State
    told: tuple[Mapping[str, Any], ...] = ()


@dataclass(frozen=True, slots=True)
class DeviationNoticed:
    """The observed state is none that the policy expects.

    action:  the one it was noticed after, None between actions
    covered: whether the mission can go on without another plan
    node:    the policy node to go on from; None where there is none, or nothing left to do
    """

    kind: ClassVar[str] = "deviation_noticed"
    action: GroundAction | None
    description: str
    covered: bool
    node: int | None = None


@dataclass(frozen=True, slots=True)
class VerdictReached:
    """From here on it is certain how the request ends, whatever happens next.

    verdict:  satisfied or violated; the instant's first entry is what brought it about
    clause:   the conjunct that was violated, None where all are satisfied, or where no one is
    together: the conjuncts that can each be met, but not together any more
    reason:   why nothing that the domain knows of can meet the request any more, in words; None
              where the verdict holds in whatever world
    """

    kind: ClassVar[str] = "verdict_reached"
    verdict: str
    clause: str | None = None
    together: tuple[str, ...] = ()
    reason: str | None = None


@dataclass(frozen=True, slots=True)
class Paused:
    """No further action is started; one that is under way comes to its end.

    by: a person, or what happened to the program ("keyboard", "closed")
    """

    kind: ClassVar[str] = "paused"
    by: str


@dataclass(frozen=True, slots=True)
class Resumed:
    """The mission goes on, after a pause or a restart of the program.

    by: a person, or "restart"
    """

    kind: ClassVar[str] = "resumed"
    by: str


@dataclass(frozen=True, slots=True)
class TakenUp:
    """The worker `by` goes on with the mission; a pause stays, an action may be under way."""

    kind: ClassVar[str] = "taken_up"
    by: str


@dataclass(frozen=True, slots=True)
class Cancelled:
    """The mission is given up; an action that is under way is cancelled if the robot can.

    by: a person, or what took the place of the mission
    """

    kind: ClassVar[str] = "cancelled"
    by: str


@dataclass(frozen=True, slots=True)
class ActionProgressed:
    """The robot says how far it is with the action under way.

    progress: from 0 to 1, None where it cannot say
    doing:    the part of it that goes on now, in the robot's words
    """

    kind: ClassVar[str] = "action_progressed"
    goal_id: str
    progress: float | None = None
    doing: str | None = None


@dataclass(frozen=True, slots=True)
class ActionResent:
    """The robot is certain that it never began the action, and was told once more."""

    kind: ClassVar[str] = "action_resent"
    action: GroundAction
    goal_id: str


@dataclass(frozen=True, slots=True)
class ActionOverdue:
    """The action took longer than it may, and the robot was told to give it up."""

    kind: ClassVar[str] = "action_overdue"
    action: GroundAction
    goal_id: str
    seconds: float


@dataclass(frozen=True, slots=True)
class RobotLost:
    """The robot cannot be reached; what it does meanwhile is not known."""

    kind: ClassVar[str] = "robot_lost"
    reason: str


@dataclass(frozen=True, slots=True)
class RobotFound:
    """The robot can be reached again."""

    kind: ClassVar[str] = "robot_found"


@dataclass(frozen=True, slots=True)
class ChangeRequested:
    """Somebody wants something else from now on; the mission goes on as before until it is planned.

    clauses: what would have to hold, [{"since": instant, "goal": formula}, ...]: each formula for
             the trace from that instant on
    english: all of it, in words
    """

    kind: ClassVar[str] = "change_requested"
    by: str
    text: str
    clauses: tuple[Mapping[str, Any], ...]
    english: str = ""


@dataclass(frozen=True, slots=True)
class RequestChanged:
    """From here on the mission is about other clauses; a policy for them follows."""

    kind: ClassVar[str] = "request_changed"
    by: str
    text: str
    clauses: tuple[Mapping[str, Any], ...]
    english: str = ""


@dataclass(frozen=True, slots=True)
class ChangeRefused:
    """What somebody wanted changed cannot be done; the mission goes on as before."""

    kind: ClassVar[str] = "change_refused"
    by: str
    text: str
    reason: str


@dataclass(frozen=True, slots=True)
class MissionEnded:
    """The mission is over.

    outcome: finished, cancelled or stopped (safely, for a reason)
    satisfied: whether the trace satisfies the goal
    """

    kind: ClassVar[str] = "mission_ended"
    outcome: str
    satisfied: bool
    reason: str | None = None


Event = (
    MissionAccepted
    | PolicyChosen
    | ActionStarted
    | ActionFinished
    | ActionFailed
    | ObservationMade
    | LookRequested
    | ReportReceived
    | DeviationNoticed
    | VerdictReached
    | Paused
    | Resumed
    | TakenUp
    | Cancelled
    | ActionProgressed
    | ActionResent
    | ActionOverdue
    | RobotLost
    | RobotFound
    | ChangeRequested
    | RequestChanged
    | ChangeRefused
    | MissionEnded
)

Stated = MissionAccepted | ActionFinished | ActionFailed | ObservationMade | ReportReceived
"""The events that hold a state; those of an instant's first entry say how it began."""

KINDS: Mapping[str, type[Event]] = {
    event.kind: event
    for event in (
        MissionAccepted,
        PolicyChosen,
        ActionStarted,
        ActionFinished,
        ActionFailed,
        ObservationMade,
        LookRequested,
        ReportReceived,
        DeviationNoticed,
        VerdictReached,
        Paused,
        Resumed,
        TakenUp,
        Cancelled,
        ActionProgressed,
        ActionResent,
        ActionOverdue,
        RobotLost,
        RobotFound,
        ChangeRequested,
        RequestChanged,
        ChangeRefused,
        MissionEnded,
    )
}


@dataclass(frozen=True, slots=True)
class Entry:
    """An event in its place in the log.

    time: ISO 8601, UTC
    instant: the index of the current instant of the trace, after the event
    """

    step: Step
    time: str
    instant: Instant
    event: Event

    @property
    def kind(self) -> str:
        return self.event.kind

    def to_json(self) -> dict[str, Any]:
        document: dict[str, Any] = {
            "step": self.step,
            "time": self.time,
            "kind": self.kind,
            "instant": self.instant,
        }
        for each in fields(self.event):
            value = getattr(self.event, each.name)
            document[each.name] = sorted(value) if isinstance(value, frozenset) else value
        return document


def entry_from_json(document: Mapping[str, Any]) -> Entry:
    """Read one entry; unknown further fields are ignored, as CONTRACT promises.

    raises KeyError, TypeError: when the document is no entry; `knowledge.log` names the line
    """
    kind = KINDS[document["kind"]]
    values: dict[str, Any] = {}
    for each in fields(kind):
        if each.name not in document and not (
            each.default is MISSING and each.default_factory is MISSING
        ):
            continue  # a log written before there was such a field
        value = document[each.name]
        if each.name == "state":
            if not isinstance(value, list):
                raise TypeError(f"a state is a list of ground atoms, got {value!r}")
            value = frozenset(value)
        elif isinstance(value, list):
            value = tuple(value)
        values[each.name] = value
    return Entry(document["step"], document["time"], document["instant"], kind(**values))
