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
from typing import assert_never

from plainspoken.automata.verdict import Verdict
from plainspoken.logic.syntax import unparse
from plainspoken.mission.command import Attach, CancelAction, Command, Look, Plan, Send
from plainspoken.mission.coverage import sound_nodes
from plainspoken.mission.mission import ActionInFlight, Limits, Mission, after, begun
from plainspoken.mission.observation import (
    ActionDone,
    ActionNotDone,
    CancelAsked,
    NeverHeard,
    NotPlanned,
    Observation,
    PauseAsked,
    Planned,
    ResumeAsked,
    Sensed,
    Told,
)
from plainspoken.planning.policy import NodeId, Policy
from plainspoken.world.domain import State
from plainspoken.world.event import (
    ActionFailed,
    ActionFinished,
    ActionStarted,
    Cancelled,
    DeviationNoticed,
    Event,
    MissionAccepted,
    MissionEnded,
    ObservationMade,
    Paused,
    PolicyChosen,
    ReportReceived,
    Resumed,
    VerdictReached,
)
from plainspoken.world.scene import is_applicable, successors


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


def advance(mission: Mission, observation: Observation) -> Advance:
    """Take in one observation and decide how to go on."""
    events: list[Event] = []
    if not mission.is_over:
        event = _learned(mission, observation)
        while event is not None:
            mission = after(mission, event)
            events.append(event)
            event = _decision(mission)
    return Advance(mission, tuple(_commands(mission, observation, events)), tuple(events))


def _learned(mission: Mission, observation: Observation) -> Event | None:
    """The event that records an observation; None where it says nothing new."""
    goal, static = mission.in_flight, mission.brief.static
    match observation:
        # Robots may tell twice; only the action under way can come to an end.
        case ActionDone(goal_id, seen) if goal is not None and goal.goal_id == goal_id:
            node = _successor(mission, goal, seen - static)
            return ActionFinished(goal.action, goal_id, seen - static, node)
        case ActionNotDone(goal_id, reason, seen) if goal is not None and goal.goal_id == goal_id:
            return ActionFailed(goal.action, goal_id, reason, seen - static)
        case ActionDone() | ActionNotDone() | NeverHeard():
            return None
        case Sensed(source, seen):
            state = seen - static
            if state == mission.state and not mission.looking:
                return None
            return ObservationMade(source, *_difference(mission.state, state), state)
        case Told(reporter, text, added, deleted):
            state = (mission.state - deleted) | (added - static)
            return ReportReceived(reporter, text, *_difference(mission.state, state), state)
        case Planned(policy):
            return _chosen(mission, policy)
        case NotPlanned(reason):
            return _stopped(mission, reason)
        case PauseAsked(by):
            return Paused(by) if mission.paused_by is None else None
        case ResumeAsked(by):
            return Resumed(by)
        case CancelAsked(by):
            return Cancelled(by) if mission.cancelled_by is None else None
        case _:
            assert_never(observation)


def _decision(mission: Mission) -> Event | None:
    """The next event that the mission itself brings about; None where it has to wait."""
    verdict = mission.monitor.verdict
    if mission.is_over:
        return None
    if not mission.settled and verdict in (Verdict.SATISFIED, Verdict.VIOLATED):
        return VerdictReached(verdict, _violated_clause(mission))
    if mission.in_flight is not None:
        return None
    if mission.cancelled_by is not None:
        return MissionEnded("cancelled", mission.satisfied, f"cancelled by {mission.cancelled_by}")
    if mission.looking:
        return None
    if verdict is Verdict.VIOLATED:
        return _stopped(
            mission, f"the request can no longer be met: {_violated_clause(mission)} is violated"
        )
    if mission.node is None:
        return _decision_adrift(mission)
    if mission.paused_by is not None:
        return None
    return _decision_at(mission, mission.node)


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


def _commands(mission: Mission, observation: Observation, events: list[Event]) -> Iterator[Command]:
    if mission.is_over:
        return
    goal = mission.in_flight
    if goal is not None:
        if isinstance(observation, ResumeAsked):
            yield Attach(goal.goal_id)
        elif isinstance(observation, NeverHeard) or any(
            isinstance(event, ActionStarted) for event in events
        ):
            yield Send(goal.goal_id, goal.action)
        if mission.cancelled_by is not None:
            yield CancelAction(goal.goal_id)
    elif mission.looking:
        yield Look()
    elif mission.paused_by is None and mission.node is None:
        yield Plan(mission.world, mission.remaining)


def _successor(mission: Mission, goal: ActionInFlight, state: State) -> NodeId | None:
    """The node that the policy foresees for the state after an action, if any.

    None as well if something else changed meanwhile: then the goal's memory may differ.
    """
    if mission.policy is None or mission.node != goal.node:
        return None
    world = state | mission.brief.static
    for id in mission.policy.node(goal.node).successors:
        node = mission.policy.node(id)
        if node.state | mission.policy.static == world:
            return id
    return None


def _chosen(mission: Mission, policy: Policy) -> Event:
    """Take a policy, if following it from here leads to what is left of the goal."""
    first = mission.policy is None
    sound = sound_nodes(policy, mission.world, mission.monitor, mission.brief.symbols)
    if policy.initial not in sound:
        return _stopped(mission, "the policy does not lead from the current state to the goal")
    return PolicyChosen(policy.to_json(), None if first else "the policy did not fit the state")


def _deviation(mission: Mission) -> DeviationNoticed:
    """Say what is not as expected, and whether the policy can be followed all the same."""
    nodes: tuple[NodeId, ...] = ()
    if mission.policy is not None:
        nodes = sound_nodes(mission.policy, mission.world, mission.monitor, mission.brief.symbols)
    return DeviationNoticed(
        mission.led_by,
        _surprise(mission),
        covered=bool(nodes) or mission.satisfied,
        node=nodes[0] if nodes else None,
    )


def _surprise(mission: Mission) -> str:
    """What differs from the outcome that comes nearest to the observed state."""
    static, action = mission.brief.static, mission.led_by
    expected: tuple[State, ...] = (mission.previous | static,)
    if action is not None and is_applicable(mission.brief.problem, expected[0], action):
        expected = successors(mission.brief.problem, expected[0], action)
    nearest = min(expected, key=lambda state: len(state ^ mission.world))
    appeared, gone = _difference(nearest, mission.world)
    changes = [
        *(f"{atom} is true and should be false" for atom in appeared),
        *(f"{atom} is false and should be true" for atom in gone),
    ]
    where = f"after {action}" if action is not None else "with no action"
    return f"{where}: {'; '.join(changes) or 'a state that the policy does not foresee'}"


def _difference(before: State, now: State) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The atoms that became true, and those that became false."""
    return tuple(sorted(now - before)), tuple(sorted(before - now))


def _violated_clause(mission: Mission) -> str | None:
    for part in mission.monitor.parts:
        if part.verdict is Verdict.VIOLATED:
            return unparse(part.formula)
    return None


def _stopped(mission: Mission, reason: str) -> MissionEnded:
    return MissionEnded("stopped", mission.satisfied, reason)
