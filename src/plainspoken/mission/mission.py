"""The state of a mission as a frozen value, and how each event changes it.

A mission is the fold of its log: `after` says what one event makes of it, and nothing else does.
So one that was paused or killed comes back from its entries alone.
"""

from __future__ import annotations

import secrets
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from datetime import datetime
from enum import StrEnum
from typing import assert_never

from plainspoken.automata.progression import all_of, satisfied_at_end
from plainspoken.automata.verdict import Monitor, Verdict
from plainspoken.errors import PlainspokenError
from plainspoken.logic.formula import Constant, Formula, Next, WeakNext
from plainspoken.logic.syntax import parse
from plainspoken.mission.lookout import Lookout
from plainspoken.mission.request import (
    Clause,
    Past,
    clauses_from_json,
    monitor_of,
    symbols_of,
)
from plainspoken.planning.policy import NodeId, Policy, policy_from_json
from plainspoken.world.domain import GroundAction, Problem, State
from plainspoken.world.event import (
    ActionFailed,
    ActionFinished,
    ActionOverdue,
    ActionProgressed,
    ActionResent,
    ActionStarted,
    Cancelled,
    ChangeRefused,
    ChangeRequested,
    DeviationNoticed,
    Entry,
    Event,
    Instant,
    LookRequested,
    MissionAccepted,
    MissionEnded,
    ObservationMade,
    Paused,
    PolicyChosen,
    ReportReceived,
    RequestChanged,
    Resumed,
    RobotFound,
    RobotLost,
    TakenUp,
    VerdictReached,
)
from plainspoken.world.pddl import parse_domain, parse_problem
from plainspoken.world.symbol import Symbol, letter

MissionId = str
GoalId = str
"""Names one command to a robot: `<mission>/<how many commands, this one included>`."""


def new_mission_id(now: Callable[[], datetime]) -> MissionId:
    """Readable, in the order of time, and not given twice: `1122-093005-7f3a`."""
    return f"{now():%m%d-%H%M%S}-{secrets.token_hex(2)}"


class Status(StrEnum):
    """Where a mission stands."""

    PLANNING = "planning"
    """It has no policy that fits the state."""
    RUNNING = "running"
    PAUSED = "paused"
    """No further action is started; one may still be under way."""
    FINISHED = "finished"
    CANCELLED = "cancelled"
    STOPPED = "stopped"
    """Safely, for a reason."""


@dataclass(frozen=True, slots=True)
class Limits:
    """When to stop trying.

    revisits: how often the mission may come back to one node of a policy, without progress
    failures: how many actions in a row the robot may fail to carry out
    replans:  how many further policies the mission may ask for
    resends:  how often a robot may have forgotten the command that it was given
    """

    revisits: int = 1000
    failures: int = 3
    replans: int = 20
    resends: int = 3


@dataclass(frozen=True)
class Brief:
    """What was asked for, which only a change of mind changes; symbols are those of the clauses.

    side_by_side: whether independent actions of different robots may go on at once
    """

    mission: MissionId
    problem: Problem
    clauses: tuple[Clause, ...]
    symbols: tuple[Symbol, ...]
    static: State
    side_by_side: bool = False


@dataclass(frozen=True)
class Change:
    """What somebody wants to hold instead, until it is planned; monitor: up to now."""

    by: str
    text: str
    brief: Brief
    monitor: Monitor
    english: str = ""


@dataclass(frozen=True, slots=True)
class ActionInFlight:
    """An action that the robot was, or is about to be, told to do."""

    goal_id: GoalId
    action: GroundAction
    node: NodeId
    overdue: bool = False
    sendings: int = 1


@dataclass(frozen=True)
class Mission:
    """A mission at one moment.

    state:     as last observed, static atoms left out; `world` has them
    previous:  the state of the instant before, `state` itself at s0
    led_by:    the action that led to the current instant
    monitor:   the goal's parts after the instants so far
    node:      where in the policy the mission is, None where the policy does not say how to go on
    noticed:   whether the log says so too
    in_flight: the policy's action; beside: one of another robot, begun before its turn
    sent:      how many commands there were
    visits:    how often each node of the policy was come to
    failures:  actions in a row that could not be carried out
    paused_by, cancelled_by: who asked
    looking:   the world may have changed: it is observed before anything else is started
    lost:      why the robot cannot be reached
    change:    what somebody wants instead, to be planned as soon as nothing is under way
    settled:   whether the log says that the verdict is certain
    lookout:   what is not known, and what is to be looked at
    """

    brief: Brief
    state: State
    previous: State
    monitor: Monitor = field(compare=False)
    past: Past = field(compare=False, repr=False)
    instant: Instant = 0
    led_by: GroundAction | None = None
    policy: Policy | None = field(default=None, repr=False)
    node: NodeId | None = None
    noticed: bool = True
    in_flight: ActionInFlight | None = None
    beside: ActionInFlight | None = None
    sent: int = 0
    visits: Mapping[NodeId, int] = field(default_factory=dict)
    failures: int = 0
    replans: int = 0
    paused_by: str | None = None
    cancelled_by: str | None = None
    looking: bool = False
    lost: str | None = None
    change: Change | None = field(default=None, compare=False, repr=False)
    settled: bool = False
    ended: MissionEnded | None = None
    limits: Limits = field(default_factory=Limits)
    lookout: Lookout = field(default_factory=Lookout)

    @property
    def id(self) -> MissionId:
        return self.brief.mission

    @property
    def world(self) -> State:
        """Every atom that is true now."""
        return self.state | self.brief.static

    @property
    def satisfied(self) -> bool:
        """Whether the trace so far satisfies the goal."""
        return self.monitor.verdict in (Verdict.SATISFIED, Verdict.HOLDS_SO_FAR)

    @property
    def under_way(self) -> tuple[ActionInFlight, ...]:
        """The actions that robots are at, the policy's first."""
        return tuple(goal for goal in (self.in_flight, self.beside) if goal is not None)

    @property
    def status(self) -> Status:
        if self.ended is not None:
            return Status(self.ended.outcome)
        if self.paused_by is not None:
            return Status.PAUSED
        return Status.PLANNING if self.node is None else Status.RUNNING

    @property
    def is_over(self) -> bool:
        return self.ended is not None

    @property
    def is_at_rest(self) -> bool:
        """Whether nothing goes on and nothing will until somebody asks for it."""
        return self.is_over or (
            self.paused_by is not None
            and not self.under_way
            and self.cancelled_by is None
            and not self.lookout.wanted
        )

    @property
    def remaining(self) -> Formula:
        """What is left to plan for, as a goal for a trace that begins at the current instant.

        `X` or `WX` in front: the action that led to the current instant has been counted.
        """
        return left_of(self.monitor)


def left_of(monitor: Monitor) -> Formula:
    """What is left to plan for; see `Mission.remaining`."""
    residual = all_of(*(part.automaton.residual(part.state) for part in monitor.parts))
    if isinstance(residual, Constant):
        return residual
    return WeakNext(residual) if satisfied_at_end(residual) else Next(residual)


def begun(accepted: MissionAccepted, limits: Limits) -> Mission:
    """The mission at s0.

    raises PlainspokenError: when the texts in the event are no domain, problem and goal
    """
    source = f"mission {accepted.mission}"
    domain = parse_domain(accepted.domain, f"{source}, domain")
    problem = parse_problem(accepted.problem, domain, f"{source}, problem")
    clauses = (Clause(parse(accepted.goal)),)
    symbols, static = symbols_of(clauses, problem), frozenset(accepted.static)
    together = bool(accepted.robot.get("side_by_side"))
    brief = Brief(accepted.mission, problem, clauses, symbols, static, together)
    past = Past(accepted.state | static, None)
    monitor = monitor_of(clauses, symbols, past)
    lookout = Lookout.of(accepted, problem)
    return Mission(
        brief, accepted.state, accepted.state, monitor, past, limits=limits, lookout=lookout
    )


def after(mission: Mission, event: Event) -> Mission:
    """The mission after an event of its log."""
    lookout = mission.lookout.after(
        event, mission.state, mission.brief.static, mission.brief.problem
    )
    return replace(_after(mission, event), lookout=lookout)


def _after(mission: Mission, event: Event) -> Mission:
    match event:
        case ActionStarted(action, node, goal_id):
            goal, sent = ActionInFlight(goal_id, action, node), mission.sent + 1
            if mission.in_flight is None:
                return replace(mission, in_flight=goal, sent=sent)
            return replace(mission, beside=goal, sent=sent)
        case ActionFinished(action, goal_id, state, node):
            # What another robot gets done does not mend what this one fails at.
            beside = mission.beside is not None and mission.beside.goal_id == goal_id
            failures = mission.failures if beside else 0
            landed = _over(_next_instant(mission, state, action), goal_id)
            landed = replace(landed, failures=failures)
            return landed if node is None else _at_node(landed, node)
        case ActionFailed(_, goal_id, _, state):
            failed = replace(_over(mission, goal_id), failures=mission.failures + 1)
            return failed if state == mission.state else _next_instant(failed, state, None)
        case ObservationMade(_, _, _, state, sensed):
            return _seen(replace(mission, looking=mission.looking and bool(sensed)), state)
        case ReportReceived(_, _, _, _, state):
            return _seen(mission, state)
        case DeviationNoticed(_, _, _, node):
            noticed = replace(mission, noticed=True)
            return noticed if node is None else _at_node(noticed, node)
        case PolicyChosen(document, reason, repeats):
            policy = policy_from_json(document, f"mission {mission.id}, policy")
            if repeats:
                visits = {int(new): mission.visits.get(old, 0) for new, old in repeats.items()}
                rearranged = replace(mission, policy=policy, visits={**mission.visits, **visits})
                return _at_node(rearranged, policy.initial)
            replans = mission.replans + (reason is not None)
            chosen = replace(mission, policy=policy, replans=replans, visits={})
            return _at_node(chosen, policy.initial)
        case VerdictReached():
            return replace(mission, settled=True)
        case Paused(by):
            return replace(mission, paused_by=by)
        case Resumed():
            return replace(mission, paused_by=None, looking=not mission.under_way)
        case TakenUp():
            return replace(mission, looking=not mission.under_way)
        case Cancelled(by):
            return replace(mission, cancelled_by=by)
        case ActionProgressed() | LookRequested():
            return mission
        case ActionOverdue() | ActionResent():
            return replace(
                mission,
                in_flight=_still_in_flight(mission.in_flight, event),
                beside=_still_in_flight(mission.beside, event),
            )
        case RobotLost(reason):
            return replace(mission, lost=reason)
        case RobotFound():
            return replace(mission, lost=None, looking=not mission.under_way)
        case ChangeRequested() | RequestChanged() | ChangeRefused():
            return _reconsidered(mission, event)
        case MissionEnded():
            return replace(mission, ended=event, in_flight=None, beside=None)
        case MissionAccepted():
            raise PlainspokenError("a mission is accepted once", where=f"mission {mission.id}")
        case _:
            assert_never(event)


def mission_from(entries: Iterable[Entry], limits: Limits | None = None) -> Mission:
    """The mission as its log leaves it.

    To go on, tell the executive `ResumeAsked`, or `TakeUpAsked` where a pause is to stay: it will
    ask the robot about an action that was in flight, or look at the world, before it starts
    anything.
    raises PlainspokenError: when the entries are not the log of one mission
    """
    mission: Mission | None = None
    for entry in entries:
        if mission is None:
            if not isinstance(entry.event, MissionAccepted):
                raise PlainspokenError(
                    "a log begins with mission_accepted", where=f"step {entry.step}"
                )
            mission = begun(entry.event, limits or Limits())
        else:
            mission = after(mission, entry.event)
        if entry.instant != mission.instant:
            raise PlainspokenError(
                f"expected instant {mission.instant}, got {entry.instant}",
                where=f"step {entry.step}, {entry.kind}",
            )
    if mission is None:
        raise PlainspokenError("an empty log: a log begins with mission_accepted")
    return mission


def _still_in_flight(
    goal: ActionInFlight | None, event: ActionOverdue | ActionResent
) -> ActionInFlight | None:
    if goal is None or goal.goal_id != event.goal_id:
        return goal
    if isinstance(event, ActionOverdue):
        return replace(goal, overdue=True)
    return replace(goal, sendings=goal.sendings + 1)


def _reconsidered(
    mission: Mission, event: ChangeRequested | RequestChanged | ChangeRefused
) -> Mission:
    """The mission after what somebody wants was heard, taken up, or refused.

    Once it is taken up, no policy is for it, and the verdict is open anew.
    """
    if isinstance(event, ChangeRefused):
        return replace(mission, change=None)
    change = changed(mission, event)
    if isinstance(event, ChangeRequested):
        return replace(mission, change=change)
    return replace(
        mission,
        brief=change.brief,
        monitor=change.monitor,
        change=None,
        node=None,
        noticed=True,
        settled=False,
        replans=0,
    )


def changed(mission: Mission, asked: ChangeRequested | RequestChanged) -> Change:
    """What a change of mind comes to, after the trace so far.

    raises PlainspokenError: when its clauses cannot be read, or name what the domain has not
    """
    clauses = clauses_from_json(asked.clauses, f"mission {mission.id}, clauses")
    symbols = symbols_of(clauses, mission.brief.problem)
    brief = replace(mission.brief, clauses=clauses, symbols=symbols)
    monitor = monitor_of(clauses, symbols, mission.past)
    return Change(asked.by, asked.text, brief, monitor, asked.english)


def _seen(mission: Mission, state: State) -> Mission:
    """The mission once this is known of the world, with no action.

    What was not known before did not change: the instant itself is as it is seen now.
    """
    if state == mission.state:
        return mission
    if not state ^ mission.state <= mission.lookout.unknown:
        return _next_instant(mission, state, None)
    brief, change = mission.brief, mission.change
    past = replace(mission.past, state=state | brief.static)
    if change is not None:
        monitor = monitor_of(change.brief.clauses, change.brief.symbols, past)
        change = replace(change, monitor=monitor)
    return replace(
        mission,
        past=past,
        change=change,
        state=state,
        previous=mission.state if mission.led_by is None else mission.previous,
        monitor=monitor_of(brief.clauses, brief.symbols, past),
        node=None,
        noticed=False,
    )


def _next_instant(mission: Mission, state: State, action: GroundAction | None) -> Mission:
    """A new instant; whether the policy has a node for it is not known yet."""
    world = state | mission.brief.static
    seen = letter(mission.brief.symbols, world, action)
    change = mission.change
    if change is not None:
        then = change.monitor.after(letter(change.brief.symbols, world, action))
        change = replace(change, monitor=then)
    return replace(
        mission,
        past=Past(world, action, mission.past),
        change=change,
        state=state,
        previous=mission.state,
        led_by=action,
        instant=mission.instant + 1,
        monitor=mission.monitor.after(seen),
        node=None,
        noticed=False,
    )


def _over(mission: Mission, goal_id: GoalId) -> Mission:
    """The mission without an action that has come to its end."""
    in_flight, beside = (
        None if goal is not None and goal.goal_id == goal_id else goal
        for goal in (mission.in_flight, mission.beside)
    )
    return replace(mission, in_flight=in_flight, beside=beside)


def _at_node(mission: Mission, node: NodeId) -> Mission:
    """The mission at a node of its policy; one that is under way already is what comes next."""
    visits = {**mission.visits, node: mission.visits.get(node, 0) + 1}
    in_flight, beside = mission.in_flight, mission.beside
    if in_flight is not None:  # the policy was rearranged around it
        in_flight = replace(in_flight, node=node)
    elif (
        beside is not None
        and mission.policy is not None
        and mission.policy.node(node).action == beside.action
    ):
        in_flight, beside = replace(beside, node=node), None
    return replace(
        mission, node=node, visits=visits, noticed=True, in_flight=in_flight, beside=beside
    )
