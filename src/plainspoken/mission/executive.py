"""The task manager: what to do next, decided without doing it.

`advance` takes one observation, and gives the events to store, the commands to obey once they
are stored, and the mission after that. The observed state, not the expected one, picks the next
node of the policy, among the successors of the current one. A state that is none of them is a
deviation: the mission goes on from another node where that is sound, asks for another plan where
it is not, and stops safely, with a reason, where there is none.

Source: Argenziano et al., Defining and Monitoring Complex Robot Activities via LLMs and Symbolic
Reasoning, 2025, "task manager"; theirs follows one determinised plan.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import takewhile
from typing import assert_never

from plainspoken.automata.verdict import Verdict
from plainspoken.mission.beside import Rearranged, begun_beside, ended_early, goes_on, masked
from plainspoken.mission.command import (
    Attach,
    CancelAction,
    Command,
    Look,
    Plan,
    Reconnect,
    Send,
    Sense,
)
from plainspoken.mission.coverage import sound_nodes
from plainspoken.mission.judgement import broken, reached
from plainspoken.mission.mission import (
    ActionInFlight,
    Change,
    Limits,
    Mission,
    after,
    begun,
    changed,
    left_of,
)
from plainspoken.mission.observation import (
    ActionDone,
    ActionNotDone,
    CancelAsked,
    ChangeAsked,
    FactsTold,
    Found,
    LookAsked,
    Lost,
    NeverHeard,
    NotPlanned,
    Observation,
    Overdue,
    PauseAsked,
    Planned,
    Progressed,
    ResumeAsked,
    Sensed,
    Stuck,
    TakeUpAsked,
    Told,
)
from plainspoken.mission.request import clauses_to_json
from plainspoken.mission.sensing import in_vain, is_verdict_open, needed, seen_state, told
from plainspoken.mission.surprise import difference, surprise
from plainspoken.planning.policy import NodeId, Policy
from plainspoken.world.domain import State
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
    Event,
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


@dataclass(frozen=True, slots=True)
class Advance:
    """What one observation leads to.

    commands: to be obeyed after the events are stored; none where the mission waits
    events:   all with the instant `mission.instant`; none where nothing new was learned
    """

    mission: Mission
    commands: tuple[Command, ...]
    events: tuple[Event, ...]


def accept(accepted: MissionAccepted, policy: Policy, limits: Limits | None = None) -> Advance:
    """Begin a mission with the policy that was found for it.

    A policy that does not lead from s0 to the goal is refused: the mission stops at once.
    raises PlainspokenError: when the texts in the event are no domain, problem and goal
    """
    start = begun(accepted, limits or Limits())
    first = advance(start, Planned(policy))
    return Advance(first.mission, first.commands, (accepted, *first.events))


def queued(accepted: MissionAccepted, policy: Policy) -> tuple[Event, ...]:
    """The first events of a mission that some worker is to begin: all before its first action.

    raises PlainspokenError: as `accept` does
    """
    events = accept(accepted, policy).events
    return tuple(takewhile(lambda event: not isinstance(event, ActionStarted), events))


def advance(mission: Mission, observation: Observation, stale: State = frozenset()) -> Advance:
    """Take in one observation and decide how to go on.

    stale: atoms that were seen too long ago to rest a decision on
    """
    events: list[Event] = []
    if not mission.is_over:
        for learned in _learned(mission, observation):
            mission = after(mission, learned)
            events.append(learned)
        event = _decision(mission, stale) if events else None
        while event is not None:
            mission = after(mission, event)
            events.append(event)
            event = _decision(mission, stale)
        acted = any(isinstance(each, ActionStarted | ActionFinished) for each in events)
        beside = begun_beside(mission, stale) if acted and not needed(mission, stale) else None
        if beside is not None:
            mission = after(mission, beside)
            events.append(beside)
    commands = tuple(_commands(mission, observation, events, stale))
    return Advance(mission, commands, tuple(events))


def _learned(mission: Mission, observation: Observation) -> tuple[Event, ...]:
    """The events that record an observation; none where it says nothing new."""
    match observation:
        case ActionDone() | ActionNotDone() | NeverHeard() | Progressed() | Overdue() | Stuck():
            # Robots may tell twice; only an action under way can come to an end.
            for goal in mission.under_way:
                if goal.goal_id == observation.goal_id:
                    return _heard(mission, goal, observation)
            return ()
        case Sensed() | FactsTold() | LookAsked() | Told() | Lost() | Found():
            event = _seen(mission, observation)
        case Planned(policy):
            return _chosen(mission, policy)
        case NotPlanned():
            return _unplanned(mission, observation)
        case ChangeAsked():
            return _reconsidered(mission, observation)
        case PauseAsked(by):
            event = Paused(by) if mission.paused_by is None else None
        case ResumeAsked(by):
            event = Resumed(by)
        case TakeUpAsked(by):
            event = TakenUp(by)
        case CancelAsked(by):
            event = Cancelled(by) if mission.cancelled_by is None else None
        case _:
            assert_never(observation)
    return () if event is None else (event,)


def _heard(
    mission: Mission,
    goal: ActionInFlight,
    observation: ActionDone | ActionNotDone | NeverHeard | Progressed | Overdue | Stuck,
) -> tuple[Event, ...]:
    """What is told of an action under way."""
    action, id, static = goal.action, goal.goal_id, mission.brief.static
    match observation:
        case ActionDone(_, seen, claimed):
            state = masked(mission, seen - static, action)
            told = state if claimed is None else masked(mission, claimed - static, action)
            return _done(mission, goal, state, tuple(sorted(told ^ state)))
        case ActionNotDone(_, reason, seen):
            return (ActionFailed(action, id, reason, masked(mission, seen - static, action)),)
        case NeverHeard():
            if goal.sendings <= mission.limits.resends:
                return (ActionResent(action, id),)
            return (_stopped(mission, f"the robot forgot {action} {goal.sendings} times"),)
        case Progressed(_, progress, doing):
            return (ActionProgressed(id, progress, doing),)
        case Overdue(_, seconds):
            return () if goal.overdue else (ActionOverdue(action, id, seconds),)
        case Stuck(_, seconds):
            never = (
                f"{action} did not come to an end {seconds:.0f} s after it was given up; "
                "it may still be under way"
            )
            others = [each.action for each in mission.under_way if each != goal]
            return (_stopped(mission, "; ".join([never, *(f"so may {each}" for each in others)])),)
        case _:
            assert_never(observation)


def _done(
    mission: Mission, goal: ActionInFlight, state: State, misreported: tuple[str, ...]
) -> tuple[Event, ...]:
    """An action that ended; one that ended before its turn has the policy rearranged."""
    early = ended_early(mission, goal.action, state) if goal == mission.beside else None
    node = early if isinstance(early, int) else _successor(mission, goal, state)
    finished = ActionFinished(goal.action, goal.goal_id, state, node, misreported)
    if isinstance(early, Rearranged):
        why = f"{goal.action} was done before its turn"
        repeats = {str(new): old for new, old in early.repeats.items()}
        return (finished, PolicyChosen(early.policy.to_json(), why, repeats))
    return (finished,)


def _seen(
    mission: Mission, observation: Sensed | FactsTold | LookAsked | Told | Lost | Found
) -> Event | None:
    """What is learned of the world, or of the connection to it."""
    static = mission.brief.static
    match observation:
        case Sensed(source, seen):
            state = seen - static
            if state == mission.state and not mission.looking:
                return None
            return ObservationMade(source, *difference(mission.state, state), state)
        case FactsTold(tellings):
            tellings = told(mission, tellings)
            state = seen_state(mission, tellings)
            source = ", ".join(dict.fromkeys(each.by for each in tellings))
            sensed = tuple(each.to_json() for each in tellings)
            return ObservationMade(source, *difference(mission.state, state), state, sensed)
        case LookAsked(by, atoms):
            wanted = filter(mission.lookout.senses.can_tell, atoms - mission.lookout.wanted)
            asked = tuple(sorted(wanted))
            return LookRequested(by, asked) if asked else None
        case Told(reporter, text, added, deleted):
            state = (mission.state - deleted) | (added - static)
            facts = tuple(
                {"atom": atom, "holds": atom in added} for atom in sorted(added | deleted)
            )
            return ReportReceived(reporter, text, *difference(mission.state, state), state, facts)
        case Lost(reason, for_good):
            if for_good:
                return _stopped(mission, f"the robot cannot be reached: {reason}")
            return RobotLost(reason) if mission.lost is None else None
        case Found():
            return None if mission.lost is None else RobotFound()
        case _:
            assert_never(observation)


def _decision(mission: Mission, stale: State) -> Event | None:
    """The next event that the mission itself brings about; None where it has to wait."""
    if mission.is_over:
        return None
    certain = None if is_verdict_open(mission) else reached(mission)
    if certain is not None:
        return certain
    if mission.in_flight is not None or (mission.beside is not None and not goes_on(mission)):
        return None
    if mission.cancelled_by is not None:
        return MissionEnded("cancelled", mission.satisfied, f"cancelled by {mission.cancelled_by}")
    if mission.lost is not None or mission.looking:
        return None
    if mission.change is not None and mission.paused_by is None:
        return None
    if mission.paused_by is None and (doubts := in_vain(mission, stale)):
        return _stopped(mission, f"nothing could tell whether {' and '.join(sorted(doubts))}")
    if needed(mission, stale):
        return None
    lost = broken(mission)
    if lost:
        what = f"{lost[0]} is violated" if len(lost) == 1 else f"not all of {', '.join(lost)}"
        return _stopped(mission, f"the request can no longer be met: {what}")
    if mission.node is None:
        return _decision_adrift(mission)
    if mission.paused_by is not None:
        return None
    decided = _decision_at(mission, mission.node)
    if mission.beside is not None and isinstance(decided, MissionEnded):
        return None  # not while a robot is at something
    return decided


def _decision_adrift(mission: Mission) -> Event | None:
    """What to do where the policy does not say how to go on."""
    if not mission.noticed:
        return _deviation(mission)
    if mission.policy is None or mission.paused_by is not None:
        return None
    if mission.satisfied:
        return MissionEnded("finished", satisfied=True)
    if mission.replans >= mission.limits.replans:
        return _stopped(mission, f"planned anew {mission.replans} times, and went astray again")
    return None


def _decision_at(mission: Mission, id: NodeId) -> Event:
    """What the policy says at a node, unless it was tried too often."""
    limits = mission.limits
    if mission.policy is None:
        raise AssertionError("a mission at a node has a policy")
    node = mission.policy.node(id)
    if node.action is None:
        if mission.satisfied:
            return MissionEnded("finished", satisfied=True)
        return _stopped(mission, "the policy ends here, and the request is not met")
    if mission.failures > limits.failures:
        return _stopped(
            mission, f"the robot failed {mission.failures} times in a row, last at {node.action}"
        )
    if mission.visits.get(id, 0) > limits.revisits + 1:
        return _stopped(
            mission,
            f"no luck with {node.action}: came back to where it is tried {limits.revisits + 1}"
            " times",
        )
    return ActionStarted(node.action, id, f"{mission.id}/{mission.sent + 1}")


def _commands(
    mission: Mission, observation: Observation, events: list[Event], stale: State
) -> Iterator[Command]:
    if mission.is_over:
        return
    doubts = needed(mission, stale)
    if doubts:
        yield Sense(f"{mission.id}/look-{mission.lookout.looks + 1}", tuple(sorted(doubts)))
    if mission.lost is not None:
        yield Reconnect()
    elif mission.under_way:
        told = {e.goal_id for e in events if isinstance(e, ActionStarted | ActionResent)}
        for goal in mission.under_way:
            if isinstance(observation, ResumeAsked | TakeUpAsked | Found):
                yield Attach(goal.goal_id)
            elif goal.goal_id in told:
                yield Send(goal.goal_id, goal.action)
            if mission.cancelled_by is not None or goal.overdue:
                yield CancelAction(goal.goal_id)
    elif mission.looking:
        yield Look()
    elif mission.change is not None and mission.paused_by is None:
        yield Plan(mission.world, left_of(mission.change.monitor))
    elif mission.paused_by is None and mission.node is None and not doubts:
        yield Plan(mission.world, mission.remaining)


def _successor(mission: Mission, goal: ActionInFlight, state: State) -> NodeId | None:
    """The node that the policy foresees for the state after an action, if any.

    None as well if something else changed meanwhile: then the goal's memory may differ.
    """
    if mission.policy is None or mission.node != goal.node or goal == mission.beside:
        return None
    world = state | mission.brief.static
    for id in mission.policy.node(goal.node).successors:
        node = mission.policy.node(id)
        if node.state | mission.policy.static == world:
            return id
    return None


def _chosen(mission: Mission, policy: Policy) -> tuple[Event, ...]:
    """Take a policy, if following it from here leads to what is left of the goal."""
    first = mission.policy is None
    events: tuple[Event, ...] = ()
    change = mission.change
    if change is not None:
        clauses = clauses_to_json(change.brief.clauses)
        taken = RequestChanged(change.by, change.text, clauses, change.english)
        mission, events = after(mission, taken), (taken,)
    sound = sound_nodes(policy, mission.world, mission.monitor, mission.brief.symbols)
    if policy.initial not in sound:
        reason = "the policy does not lead from the current state to the goal"
        if change is not None:
            return (ChangeRefused(change.by, change.text, reason),)
        return (_stopped(mission, reason),)
    why = "the policy did not fit the state" if change is None else "the request was changed"
    return (*events, PolicyChosen(policy.to_json(), None if first else why))


def _unplanned(mission: Mission, told: NotPlanned) -> tuple[Event, ...]:
    """Without a policy a change is not made; what was asked before is given up only without one."""
    if mission.change is not None:
        return (ChangeRefused(mission.change.by, mission.change.text, told.reason),)
    stopped = _stopped(mission, told.reason)
    if not told.hopeless or mission.settled:
        return (stopped,)
    return (VerdictReached(Verdict.VIOLATED, reason=told.reason), stopped)


def _reconsidered(mission: Mission, asked: ChangeAsked) -> tuple[Event, ...]:
    """Note what somebody wants instead; refuse at once what the past has broken already.

    raises PlainspokenError: when the clauses name what the domain has not, or are yet to begin
    """
    clauses = clauses_to_json(asked.clauses)
    requested = ChangeRequested(asked.by, asked.text, clauses, asked.english)
    change: Change = changed(mission, requested)
    if change.monitor.verdict is Verdict.VIOLATED:
        broken = "what happened so far has broken it already"
        return (requested, ChangeRefused(asked.by, asked.text, broken))
    return (requested,)


def _deviation(mission: Mission) -> DeviationNoticed:
    """Say what is not as expected, and whether the policy can be followed all the same."""
    nodes: tuple[NodeId, ...] = ()
    if mission.policy is not None:
        nodes = sound_nodes(mission.policy, mission.world, mission.monitor, mission.brief.symbols)
    return DeviationNoticed(
        mission.led_by,
        surprise(mission),
        covered=bool(nodes) or mission.satisfied,
        node=nodes[0] if nodes else None,
    )


def _stopped(mission: Mission, reason: str) -> MissionEnded:
    return MissionEnded("stopped", mission.satisfied, reason)
