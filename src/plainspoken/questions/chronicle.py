"""A log as a person would tell it: a line for each thing that happened."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal

from plainspoken.logic.english import say
from plainspoken.logic.syntax import parse
from plainspoken.mission.mission import GoalId
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.morphology import listed
from plainspoken.world.domain import GroundAction, State
from plainspoken.world.event import (
    ActionFailed,
    ActionFinished,
    ActionOverdue,
    ActionProgressed,
    ActionResent,
    ActionStarted,
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
    Step,
    TakenUp,
    VerdictReached,
)

Sort = Literal["action", "seen", "trouble", "person", "plan", "end"]


@dataclass(frozen=True, slots=True)
class Line:
    """One thing that happened.

    step:    the entry that tells of it; of an action that is over, the one that ends it
    steps:   all entries that it is about
    came_of: what was seen then, or what became of it
    going:   whether it is an action under way
    """

    step: Step
    steps: tuple[Step, ...]
    time: str
    instant: Instant
    sort: Sort
    text: str
    came_of: str = ""
    going: bool = False


class Chronicle:
    """The lines of a log, as its entries come."""

    def __init__(self, lexicon: Lexicon) -> None:
        self._lexicon = lexicon
        self._state: State = frozenset()
        self._going: dict[GoalId, Line] = {}
        self._lines: list[Line] = []
        self._reached: VerdictReached | None = None

    def add(self, entry: Entry) -> None:
        """Take in one entry."""
        event = entry.event
        state = getattr(event, "state", None)
        before, self._state = self._state, self._state if state is None else state
        match event:
            case ActionStarted(action, _, goal_id):
                doing = self._doing(action)
                self._going[goal_id] = self._line(entry, "action", doing, going=True)
            case ActionProgressed(goal_id, _, part) if part is not None and goal_id in self._going:
                self._going[goal_id] = replace(self._going[goal_id], came_of=part)
            case ActionFinished(action, goal_id, misreported=misreported):
                came_of = news(before, self._state, self._lexicon)
                if misreported:
                    came_of += " (the robot said otherwise)"
                self._settle(goal_id, self._line(entry, "action", self._doing(action), came_of))
            case ActionFailed(action, goal_id, reason):
                doing = self._doing(action)
                self._settle(goal_id, self._line(entry, "trouble", doing, f"failed: {reason}"))
            case ObservationMade(source=source, sensed=sensed) if sensed:
                came_of = "; ".join(_sensed(each, self._lexicon) for each in sensed)
                self._lines.append(self._line(entry, "seen", f"looked ({source})", came_of))
            case LookRequested(by, atoms):
                asked = listed([self._lexicon.clause(atom).said() for atom in atoms], "or")
                text = f"{by} wants to know whether {asked}"
                self._lines.append(self._line(entry, "person", text))
            case VerdictReached(verdict="violated"):
                text = "what was asked for cannot hold any more"
                self._reached = event
                reason = _broken(event, self._lexicon)
                self._lines.append(self._line(entry, "trouble", text, reason))
            case MissionEnded(outcome, satisfied):
                verdict = "everything asked for is satisfied" if satisfied else "not satisfied"
                why = ended_because(event, self._reached, self._lexicon)
                came_of = f"{verdict}: {why}" if why else verdict
                self._lines.append(self._line(entry, "end", outcome, came_of))
            case _:
                found = _told(event, news(before, self._state, self._lexicon))
                if found is not None:
                    self._lines.append(self._line(entry, *found))

    def _doing(self, action: GroundAction) -> str:
        """What is done, and by which robot where it is not the one that speaks."""
        deed = self._lexicon.deed(action)
        return deed.doing if deed.subject == "I" else f"{deed.subject}: {deed.doing}"

    @property
    def lines(self) -> tuple[Line, ...]:
        """Everything so far, the actions under way last."""
        return (*self._lines, *self._going.values())

    def _line(
        self, entry: Entry, sort: Sort, text: str, came_of: str = "", *, going: bool = False
    ) -> Line:
        steps = (entry.step,)
        return Line(entry.step, steps, entry.time, entry.instant, sort, text, came_of, going)

    def _settle(self, goal_id: GoalId, line: Line) -> None:
        """What became of an action under way, which is over."""
        begun = self._going.pop(goal_id, None)
        if begun is not None:
            line = replace(line, steps=(*begun.steps, *line.steps))
        self._lines.append(line)


def chronicle(entries: Iterable[Entry], lexicon: Lexicon) -> tuple[Line, ...]:
    """The lines of some entries, from the first of a log on."""
    found = Chronicle(lexicon)
    for entry in entries:
        found.add(entry)
    return found.lines


def news(before: State, after: State, lexicon: Lexicon) -> str:
    """What has become true, in words; what stopped being true, where that is all."""
    added, deleted = after - before, before - after
    told = _facts(added, lexicon, true=True) or _facts(deleted, lexicon, true=False)
    return ", ".join(told) or "nothing has changed"


def _facts(atoms: State, lexicon: Lexicon, *, true: bool) -> list[str]:
    return [lexicon.clause(atom).said(negative=not true) for atom in sorted(atoms)]


def _sensed(told: Mapping[str, Any], lexicon: Lexicon) -> str:
    """What one service told of one fact; that it could not tell, where it could not."""
    atom, holds = str(told["atom"]), told["holds"]
    if holds is None:
        return f"cannot tell whether {lexicon.clause(atom).said()}"
    return lexicon.clause(atom).said(negative=not holds)


def _broken(reached: VerdictReached, lexicon: Lexicon) -> str:
    """What cannot be met any more, or cannot be met together, or why nothing helps."""
    if reached.reason is not None:
        return reached.reason
    texts = reached.together or ((reached.clause,) if reached.clause else ())
    said = [say(parse(text), lexicon.landmarks) for text in texts]
    return f"not all of these: {' '.join(said)}" if reached.together else " ".join(said)


def ended_because(
    ended: MissionEnded, reached: VerdictReached | None, lexicon: Lexicon
) -> str | None:
    """Why a mission ended, the parts of the request in it in words.

    reached: what had become certain of the request by then
    """
    reason = ended.reason
    if reason is not None and reached is not None:
        for text in filter(None, (reached.clause, *reached.together)):
            words = say(parse(text), lexicon.landmarks).rstrip(".")
            reason = reason.replace(text, f"“{words}”")
    return reason


def _told(event: Event, news: str) -> tuple[Sort, str, str] | None:
    """Sort, text and what came of it, of an event that is no action."""
    match event:
        case MissionAccepted(sentence=sentence, english=english):
            return "person", f'asked for: "{sentence}"' if sentence else "asked for", english
        case PolicyChosen(repeats=repeats) if repeats:
            return None  # the same plan, in the order in which things turned out
        case PolicyChosen(reason=None):
            return "plan", "found a plan", ""
        case PolicyChosen(reason=str(reason)):
            return "plan", "planned again", reason
        case ObservationMade(source=source):
            return "seen", f"looked ({source})", news
        case ReportReceived():
            return "person", remark(event) or "", news
        case VerdictReached():
            return "end", "everything asked for holds, whatever happens now", ""
        case _:
            said = remark(event)
            if said is None:
                return None
            trouble = isinstance(event, DeviationNoticed | ActionOverdue | RobotLost)
            by_person = isinstance(event, ChangeRequested | Paused | Resumed)
            return "trouble" if trouble else "person" if by_person else "plan", said, ""


def remark(event: Event) -> str | None:
    """What there is to say of an event that is no action; None where there is nothing."""
    match event:
        case DeviationNoticed(description=description):
            return f"not as expected: {description}"
        case ActionOverdue(seconds=seconds):
            return f"no end after {seconds:.0f} s: giving it up"
        case ActionResent():
            return "the robot never began it: told once more"
        case RobotLost(reason):
            return f"the robot cannot be reached: {reason}"
        case RobotFound():
            return "the robot can be reached again"
        case ChangeRequested(by, text):
            return f'{by} asks for a change: "{text}"'
        case RequestChanged(text=text, english=english):
            return f"from now on: {english or text}"
        case ChangeRefused(reason=reason):
            return f"nothing is changed: {reason}"
        case ReportReceived(reporter, text):
            return f'{reporter} reports: "{text}"'
        case Paused(by):
            return f"paused by {by}"
        case Resumed(by):
            return f"resumed by {by}"
        case TakenUp(by):
            return f"carried out by {by} from here on"
        case _:
            return None
