"""A robot that is a repertoire of activities over services, as the task manager sees it.

What it believes of the world is what was true at first, changed by the outcomes of the actions
that it carried out and by what it hears of; what it can sense counts for more.
"""

from __future__ import annotations

import hashlib
import json
import time
import uuid
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from plainspoken.backends.activities.journal import Journal
from plainspoken.backends.activities.looking import Looking
from plainspoken.backends.activities.tree import Stage, doing, planted, progress
from plainspoken.errors import PlainspokenError
from plainspoken.mission.activity import Literal
from plainspoken.mission.mission import GoalId
from plainspoken.mission.repertoire import (
    Conduct,
    Outcome,
    Repertoire,
    amended,
    arguments_of,
    landed,
    undecided,
)
from plainspoken.mission.robot import (
    Failed,
    GoalStatus,
    Seconds,
    Succeeded,
    UnderWay,
    Unheard,
    Unreachable,
)
from plainspoken.mission.sensing import LookId, Telling
from plainspoken.mission.service import CallStatus, Done, Fields, Going, NotDone, Service
from plainspoken.mission.template import filled, meets
from plainspoken.world.domain import GroundAction, GroundAtom, Problem, State
from plainspoken.world.sense import Sense, atoms_of

POLL: Seconds = 0.05
"""How often a call under way is asked about."""


@dataclass
class _Goal:
    action: GroundAction
    stage: Stage
    tree: Behaviour
    ended: Succeeded | Failed | None = None


class ActivityRobot:
    """Carries actions out as a repertoire says."""

    def __init__(
        self,
        problem: Problem,
        repertoire: Repertoire,
        services: Mapping[str, Service],
        journal: Journal,
        *,
        state: State | None = None,
        clock: Callable[[], Seconds] = time.monotonic,
        sleep: Callable[[Seconds], None] = time.sleep,
    ) -> None:
        """Set a robot up. state: what is believed at first, None for the problem's s0."""
        self._problem = problem
        self._repertoire = repertoire
        self._services = services
        self._journal = journal
        self._belief = problem.initial if state is None else state
        self._clock = clock
        self._sleep = sleep
        self._goals: dict[GoalId, _Goal] = {}
        self._missing: list[Service] = []
        self._always = tuple(each for each in repertoire.sensors if not each.needed)
        self._looking = Looking(
            [each for each in repertoire.sensors if each.needed],
            services,
            repertoire.offers,
            repertoire.objects,
            clock=clock,
            sleep=sleep,
        )

    def send(self, goal_id: GoalId, action: GroundAction) -> None:
        """Begin an action; what it is stands in the journal before anything is called."""
        if self._journal.get(goal_id, "begun") is None:
            self._journal.note(goal_id, "begun", [action, self._fingerprint(action)])
            self._ticked(goal_id, self._goal(goal_id, action))

    def wait(self, goal_id: GoalId, timeout: Seconds) -> GoalStatus:
        goal = self._known(goal_id)
        if goal is None:
            return Unheard()
        until = self._clock() + timeout
        while True:
            status = self._ticked(goal_id, goal)
            left = until - self._clock()
            if not isinstance(status, UnderWay) or left <= 0:
                return status
            self._sleep(min(POLL, left))

    def cancel(self, goal_id: GoalId) -> None:
        goal = self._known(goal_id)
        if goal is not None and goal.ended is None and not goal.stage.stopping:
            self._journal.note(goal_id, "cancelled", value=True)
            goal.stage.stopping = True
            self._ticked(goal_id, goal)

    def state(self) -> State:
        """What is believed, after a look at what can be sensed.

        A service that could not be reached when it was needed has to be reached first.
        """
        while self._missing:
            self._missing[-1].reach()
            self._missing.pop()
        self._belief = amended(self._belief, self._seen())
        return self._belief

    def believe(self, added: Iterable[GroundAtom] = (), deleted: Iterable[GroundAtom] = ()) -> None:
        """Take in what a person reports."""
        self._belief = (self._belief - frozenset(deleted)) | frozenset(added)

    @property
    def senses(self) -> Sequence[Sense]:
        return tuple(sensor.sense for sensor in self._repertoire.sensors)

    def unknown_at_first(self) -> State:
        """The atoms of which the robots' file says that nobody knows them at first."""
        return frozenset(
            atom
            for sensor in self._repertoire.sensors
            if sensor.unknown
            for atom in atoms_of(sensor.atom, self._problem)
        )

    def sense(
        self, look: LookId, atoms: Sequence[GroundAtom], timeout: Seconds
    ) -> tuple[Telling, ...] | None:
        """What services and people tell of facts; what they tell is believed."""
        told = self._looking.sense(look, atoms, timeout)
        if told is not None:
            self._belief = amended(self._belief, _literals(told))
        return told

    def dismiss(self, look: LookId) -> None:
        self._looking.dismiss(look)

    def _known(self, goal_id: GoalId) -> _Goal | None:
        """A goal that this process or one before it has begun."""
        begun = self._journal.get(goal_id, "begun")
        if begun is None:
            return None
        action, fingerprint = begun
        known = goal_id in self._goals
        goal = self._goal(goal_id, action)
        if not known and fingerprint != self._fingerprint(action):
            # The calls in the journal are those of another tree: nothing can be told from them.
            goal.ended = Failed(
                f"the robots' file says something else of {action.split()[0]} than when it was "
                "begun: it is not known what was done",
                amended(self._belief, self._seen()),
            )
        return goal

    def _fingerprint(self, action: GroundAction) -> str:
        """What an action is on this robot, in short."""
        activity = repr(self._conduct(action).activity)
        return hashlib.sha256(activity.encode()).hexdigest()[:16]

    def _conduct(self, action: GroundAction) -> Conduct:
        conduct = self._repertoire.actions.get(action.split()[0])
        if conduct is None:
            raise PlainspokenError(f"the robots' file does not say how to {action!r}")
        return conduct

    def _goal(self, goal_id: GoalId, action: GroundAction) -> _Goal:
        """A goal with its tree; that of a process before this one is grown again."""
        if goal_id not in self._goals:
            conduct = self._conduct(action)
            arguments = arguments_of(self._problem, action)
            stage = Stage(
                goal_id,
                {**arguments, "action": action, "goal": goal_id},
                self._services,
                self._repertoire.offers,
                self._repertoire.objects,
                self._journal,
                self._clock,
                self.state,
                stopping=self._journal.get(goal_id, "cancelled") is not None,
            )
            self._goals[goal_id] = _Goal(action, stage, planted(conduct.activity, stage))
        return self._goals[goal_id]

    def _ticked(self, goal_id: GoalId, goal: _Goal) -> GoalStatus:
        """Have an activity go on as far as it can at this moment."""
        if goal.ended is not None:
            return goal.ended
        stage, tree = goal.stage, goal.tree
        stage.lost = None
        self._end_what_was_given_up(stage)
        if not stage.ending and tree.status in (Status.INVALID, Status.RUNNING):
            tree.tick_once()
            self._end_what_was_given_up(stage)
        self._missing += stage.missing
        stage.missing.clear()
        if stage.lost is not None:
            raise stage.lost
        if stage.ending or tree.status is Status.RUNNING:
            return UnderWay(progress(tree), doing(tree))
        if tree.status is Status.SUCCESS:
            result = {**stage.results, **stage.last}
            outcomes = [
                one.bound(stage.arguments, self._repertoire.objects)
                for one in self._conduct(goal.action).outcomes
            ]
            told = self._told_of_outcome(goal_id, goal, outcomes, result)
            if told is None:
                return UnderWay(1.0, "looking at what came of it")
            goal.ended = landed(
                self._problem,
                self._belief,
                goal.action,
                outcomes=outcomes,
                result=result,
                seen=(*self._seen(), *told),
            )
        else:
            goal.ended = Failed(stage.reason, amended(self._belief, self._seen()))
        self._belief = goal.ended.state
        return goal.ended

    def _told_of_outcome(
        self, goal_id: GoalId, goal: _Goal, outcomes: Sequence[Outcome], result: Fields
    ) -> tuple[Literal, ...] | None:
        """What tells outcomes apart that is only looked at when needed; None while it is asked."""
        look = f"{goal_id}/outcome"
        atoms = undecided(self._problem, self._belief, goal.action, outcomes, result)
        needed = [each.sense for each in self._repertoire.sensors if each.needed]
        wanted = sorted(atom for atom in atoms if any(sense.fits(atom) for sense in needed))
        if goal.stage.stopping or not wanted:
            self._looking.dismiss(look)
            return ()
        told = self._looking.sense(look, wanted, 0.0)
        return None if told is None else _literals(told)

    def _end_what_was_given_up(self, stage: Stage) -> None:
        """Wait for calls that were told to end: two must not move one robot."""
        for call, service in list(stage.ending.items()):
            try:
                if isinstance(service.status(call), Going):
                    continue
            except Unreachable as error:
                stage.loses(service, error)
                continue
            self._journal.note(call, "ended", "given up")
            del stage.ending[call]

    def _seen(self) -> tuple[Literal, ...]:
        """Every fact that can be sensed, as it is now."""
        seen: list[Literal] = []
        answers: dict[str, Fields] = {}

        def answer(service: str, fields: Fields) -> Fields:
            question = json.dumps([service, fields], sort_keys=True)
            if question not in answers:
                answers[question] = self._answer(service, fields)
            return answers[question]

        if self._repertoire.scene is not None:
            service, field = self._repertoire.scene
            atoms = frozenset(map(str, filled("{" + field + "}", answer(service, {}))))
            seen += [Literal(atom) for atom in sorted(atoms)]
            seen += [Literal(atom, wanted=False) for atom in sorted(self._changing() - atoms)]
        for sensor in self._always:
            (ask,) = sensor.ways
            for binding in self._problem.bindings(sensor.parameters):
                values = {name.removeprefix("?"): value for name, value in binding.items()}
                table = self._repertoire.objects
                result = answer(ask.service, filled(ask.fields, values, table))
                holds = ask.told(result, values, table, self._repertoire.offers[ask.service])
                if holds is not None:
                    seen.append(Literal(filled(sensor.atom, values), holds))
        return tuple(seen)

    def _changing(self) -> State:
        """What is believed of what can change."""
        predicates = self._problem.changing_predicates
        return frozenset(atom for atom in self._belief if atom.split()[0] in predicates)

    def _answer(self, name: str, fields: Fields) -> Fields:
        """Ask a service that tells of the world; without an answer, the robot is out of sight."""
        service, offer = self._services[name], self._repertoire.offers[name]
        for status in self._heard(service, fields, offer.limit):
            match status:
                case Done(result) if meets(result, offer.succeeds):
                    return result
                case Done() | NotDone():
                    told = status.reason if isinstance(status, NotDone) else dict(status.result)
                    raise Unreachable(f"{name} does not tell what is so: {told}")
                case Going() | Unheard():
                    self._sleep(POLL / 10)
        self._missing.append(service)
        raise Unreachable(f"no answer from {name} in {offer.limit:g} s")

    def _heard(self, service: Service, fields: Fields, limit: Seconds) -> Iterator[CallStatus]:
        """What becomes of one question, for as long as it may take."""
        call = f"look:{uuid.uuid4().hex}"
        until = self._clock() + limit
        service.begin(call, fields)
        yield service.status(call)
        while self._clock() < until:
            yield service.status(call)


def _literals(told: Iterable[Telling]) -> tuple[Literal, ...]:
    """The facts that were told, without those that nobody could tell."""
    return tuple(Literal(each.atom, each.holds) for each in told if each.holds is not None)
