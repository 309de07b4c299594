"""What goes in and out, typed; the fields of files and logs keep the names they have there."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field

from plainspoken.automata.verdict import Verdict
from plainspoken.language.emphasis import Weight
from plainspoken.language.extraction import LONGEST
from plainspoken.mission.mission import Status
from plainspoken.planning.policy import PolicyKind
from plainspoken.web.problem import Unseen

MOST_STEPS = 2**53
"""The largest whole number that every reader of JSON keeps whole."""

Sentence = Annotated[str, Field(min_length=1, max_length=LONGEST)]
FormulaText = Annotated[str, Field(min_length=1, max_length=4000, examples=["F cleared_l2"])]
StepNumber = Annotated[int, Field(ge=0, le=MOST_STEPS)]
Atom = Annotated[str, Field(min_length=1, max_length=300, examples=["robot-at rob l2"])]


class Asked(BaseModel):
    """What somebody sends; a field that is not known is an error, not silence."""

    model_config = ConfigDict(extra="forbid")


# -- before a mission --------------------------------------------------------------------------


class Place(BaseModel):
    """Where missions take place."""

    place: str
    landmarks: int = Field(description="How many things it has words for.")


class Saying(Asked):
    """A sentence to be understood."""

    sentence: Sentence = Field(examples=["Clear line 2, then call the support robot"])


class ReferringExpression(BaseModel):
    """A piece of the sentence and the landmark that it speaks of."""

    text: str
    start: int
    end: int
    symbol: str
    score: float


class Alternative(BaseModel):
    """One thing that the sentence may mean; answer: what to say to choose it."""

    formula: str
    literal: str
    english: str
    score: float
    answer: str | None


class Understanding(BaseModel):
    """What became of a sentence, as `plainspoken extract --batch` writes it."""

    utterance: str
    status: Literal["ok", "clarify", "reject"]
    formula: str | None
    literal: str | None
    english: str | None
    pattern: str | None
    lifted: str | None
    referring_expressions: list[ReferringExpression]
    alternatives: list[Alternative]
    question: str | None
    reason: str | None
    note: str | None
    confidence: float | None
    seconds: float


class PlanWanted(Asked):
    """What to find a policy for."""

    formula: FormulaText
    sentence: Sentence | None = Field(default=None, description="What was said, for the record.")
    timeout: float = Field(default=30, gt=0, le=300, description="Seconds.", allow_inf_nan=False)


class Planned(BaseModel):
    """How planning ended; plan: names the policy, for some minutes, where there is one."""

    status: Literal["solved", "unsolvable", "out_of_time"]
    formula: str
    english: str
    plan: str | None = None
    kind: PolicyKind | None = None
    nodes: int | None = None
    first_action: str | None = None
    reason: str | None = None
    seconds: float


# -- missions ----------------------------------------------------------------------------------


class MissionWanted(Asked):
    """A mission to be carried out. Its confirmation is the formula that was said back."""

    plan: str = Field(max_length=100)
    confirm: FormulaText = Field(description="The formula of the plan, once a person has seen it.")


class Clause(BaseModel):
    """A part of the request."""

    formula: str
    english: str
    verdict: Verdict


class UnderWay(BaseModel):
    """The action that the robot is at."""

    action: str
    words: str
    overdue: bool
    progress: float | None
    doing: str | None


class Plan(BaseModel):
    """The policy that is followed, and where the mission is in it."""

    kind: str
    nodes: int
    node: int | None
    next_action: str | None


class MissionSummary(BaseModel):
    """A mission in a list. seen: the last step of its log, which commands carry."""

    mission: str
    status: Status
    over: bool
    satisfied: bool
    sentence: str | None
    english: str
    seen: int
    instant: int
    began: str
    changed: str


class Mission(MissionSummary):
    """A mission: what is asked, how far each part of it is, what is done now, and what follows."""

    formula: str
    clauses: list[Clause]
    now: UnderWay | None
    plan: Plan | None
    state: list[str] = Field(description="The facts that hold now and may change.")
    robots: list[str]
    worker: str | None = Field(description="Who carries it out.")
    trouble: str | None = Field(description="Why a worker could not go on with it.")
    paused_by: str | None
    ended: str | None = Field(description="Why it ended, where that has a reason.")


class Missions(BaseModel):
    """Some missions, newest first; before: where the next page begins."""

    missions: list[MissionSummary]
    before: str | None


# -- commands ----------------------------------------------------------------------------------

_SEEN = Field(description="The last step of the log that you know of.")


class Pausing(Asked):
    """A pause is never refused: what others asked meanwhile is told beside it."""

    seen: StepNumber | None = Field(default=None, description="The last step that you know of.")


class Resuming(Asked):
    seen: Annotated[StepNumber, _SEEN]


class Cancelling(Asked):
    seen: Annotated[StepNumber, _SEEN]
    confirm: Literal[True] = Field(description="That the mission is really to be given up.")


class Reporting(Asked):
    """What somebody did or saw: facts that hold now, and facts that hold no longer."""

    text: str = Field(min_length=1, max_length=2000)
    added: list[Atom] = Field(default=[], max_length=100)
    deleted: list[Atom] = Field(default=[], max_length=100)


class Words(Asked):
    """What somebody says to a mission."""

    text: Sentence


class ReportChoice(BaseModel):
    """One thing that a report may mean."""

    answer: str
    facts: list[str]


class ReportRead(BaseModel):
    """What became of a report in words; added and deleted are what to send to have it recorded."""

    text: str
    status: Literal["ok", "clarify", "reject"]
    facts: list[str]
    implied: list[str]
    english: str | None
    question: str | None
    choices: list[ReportChoice]
    reason: str | None
    added: list[str]
    deleted: list[str]


class Changing(Asked):
    """A change of mind; confirm: the English that it was said back in."""

    text: Sentence
    answer: str | None = Field(
        default=None, max_length=2000, description="Where there is a choice."
    )
    confirm: str = Field(max_length=20_000)
    seen: Annotated[StepNumber, _SEEN]


class ChangeClause(BaseModel):
    """A formula for the trace from an instant on."""

    since: int
    goal: str


class ChangeChoice(BaseModel):
    """One thing that a change may mean."""

    answer: str
    english: str


class ChangeRead(BaseModel):
    """What became of a change of mind in words."""

    text: str
    status: Literal["ok", "clarify", "reject"]
    english: str | None
    clauses: list[ChangeClause]
    question: str | None
    choices: list[ChangeChoice]
    reason: str | None


class Heard(BaseModel):
    """What became of a command.

    heard: whether the log holds what it led to; seen: the last step then
    """

    heard: bool
    seen: int
    status: Status
    meanwhile: list[Unseen] = Field(
        default=[], description="What others asked, which this command did not know of."
    )


# -- events and questions ----------------------------------------------------------------------


class Event(BaseModel):
    """An entry of the log, with the fields of its kind beside these."""

    model_config = ConfigDict(extra="allow")

    step: int
    time: str
    kind: str
    instant: int


class Events(BaseModel):
    """Some entries; since: where the next page begins, null at the end of what there is."""

    events: list[Event]
    since: int | None


class Asking(Asked):
    """A question; at: answer as if asked at that step."""

    question: str = Field(min_length=1, max_length=2000, examples=["What are you doing now?"])
    at: StepNumber | None = None
    full: bool = False


class Answer(BaseModel):
    """An answer, as `plainspoken ask --batch` writes it: every claim with its evidence."""

    question: str
    kind: str
    answer: str
    claims: list[dict[str, Any]]
    evidence: list[int | str]
    denied: list[dict[str, Any]]
    actions: list[dict[str, Any]]
    known: bool
    seconds: float


# -- speech ------------------------------------------------------------------------------------


class HeardWord(BaseModel):
    """One word as it was heard. start and end: seconds; confidence: 0 to 1."""

    text: str
    start: float
    end: float
    confidence: float


class Emphasis(BaseModel):
    """A word to look at again, since it turns the meaning round. start, end: characters."""

    start: int
    end: int
    weight: Weight


class Transcript(BaseModel):
    """What was heard in a recording, before anything is made of it."""

    text: str
    seconds: float
    words: list[HeardWord]
    emphases: list[Emphasis]
