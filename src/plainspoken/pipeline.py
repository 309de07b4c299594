"""The whole story on one page: hear, plan, carry out, answer.

    site = open_site("domain.pddl", "problem.pddl", "landmarks.json")
    extraction = understand("Clear line 2, then call the support robot", site)
    ending = find_policy(site, extraction.formula)
    for entry in carry_out(site, request, ending.policy, robot, record):
        print(entry.kind)

`questions.answer` then answers from the entries alone. Robots, stores and clocks arrive as
arguments; nothing here knows a vendor.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Generator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from functools import cached_property
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

from plainspoken.errors import PlainspokenError
from plainspoken.logic.formula import Formula
from plainspoken.planning.policy import Policy
from plainspoken.planning.reason import Words, is_hopeless
from plainspoken.planning.solver import Ending, OutOfTime, Solved, Unsolvable, solve
from plainspoken.planning.validation import Invalid, validate
from plainspoken.planning.watch import Progress
from plainspoken.world.document import read_text
from plainspoken.world.domain import GroundAction, Problem, State
from plainspoken.world.event import Entry, Event, Instant, MissionAccepted
from plainspoken.world.landmark import (
    Landmarks,
    landmarks_from_json,
    landmarks_to_json,
    read_landmarks,
)
from plainspoken.world.pddl import parse_domain, parse_problem
from plainspoken.world.symbol import ActionSymbol

# What a stage needs is imported in it: planning for a formula does not pay for the language.
if TYPE_CHECKING:
    from plainspoken.language.extraction import Extraction
    from plainspoken.language.grounding import Vocabulary
    from plainspoken.language.transcription import Transcriber, Transcript
    from plainspoken.mission.mission import Mission, MissionId
    from plainspoken.mission.robot import Robot
    from plainspoken.mission.run import Heed, Patience, Record, Replanner, Requests, Stale


@dataclass(frozen=True)
class Site:
    """Where missions take place: a planning problem, its texts, and the words for its symbols."""

    problem: Problem
    domain_text: str
    problem_text: str
    given_landmarks: Landmarks | None = None

    @cached_property
    def landmarks(self) -> Landmarks:
        """Those of the landmarks file, or else derived from the names in the problem."""
        from plainspoken.world.derivation import derived_landmarks

        if self.given_landmarks is not None:
            return self.given_landmarks
        return derived_landmarks(self.problem)

    @cached_property
    def vocabulary(self) -> Vocabulary:
        from plainspoken.language.grounding import Vocabulary

        return Vocabulary.of(self.landmarks)

    def in_words(self, formula: Formula) -> str:
        """A formula said in the site's words."""
        from plainspoken.logic.english import say

        return say(formula, self.landmarks)


@dataclass(frozen=True, slots=True)
class Request:
    """What is asked of a robot.

    sentence: None where the goal came as a formula
    robot:    which robot, and how it is set, for the record
    unknown:  atoms that nobody knows at s0, beside those that the problem names
    """

    mission: MissionId
    goal: Formula
    sentence: str | None = None
    robot: Mapping[str, Any] = field(default_factory=dict)
    unknown: State = frozenset()

    def knowing(self, robot: Robot) -> Request:
        """The request with what the robot says of how facts come to be known, for the record."""
        from plainspoken.mission.sensing import Senser
        from plainspoken.world.sense import senses_to_json

        if not isinstance(robot, Senser) or not robot.senses:
            return self
        set_up = {**self.robot, "senses": senses_to_json(robot.senses)}
        return replace(self, robot=set_up, unknown=robot.unknown_at_first())


def bundled(name: str) -> Path:
    """The folder of an example that comes with the package, such as `vineyard`."""
    packaged = Path(str(files("plainspoken") / "_examples"))
    examples = packaged if packaged.is_dir() else Path(__file__).parents[2] / "examples"
    return examples / name


def open_site(domain: Path, problem: Path, landmarks: Path | None = None) -> Site:
    """Read a planning problem, and its landmarks; they are derived where no file is given.

    raises InputFileError: with the file and place that is wrong
    """
    domain_text, problem_text = read_text(domain), read_text(problem)
    read = parse_problem(problem_text, parse_domain(domain_text, str(domain)), str(problem))
    words = None if landmarks is None else read_landmarks(landmarks, read)
    return Site(read, domain_text, problem_text, words)


def transcribe_upload(
    content: bytes,
    content_type: str,
    site: Site,
    transcriber: Transcriber,
    *,
    patience: float | None = None,
) -> Transcript:
    """What is said in a recording that somebody sent, for them to confirm before it is acted on.

    content: a WAV file; whoever receives it need not read more than `recording.MOST_BYTES`
    raises UnreadableRecordingError: when it is not one, or too long
    raises SilentAudio: when nobody speaks in it
    raises TranscriptionError: when the recogniser breaks down or takes too long
    """
    from plainspoken.language.hint import hints
    from plainspoken.language.recording import read_upload
    from plainspoken.language.transcription import PATIENCE, transcribed

    samples = read_upload(content, content_type)
    return transcribed(samples, transcriber, hints(site.vocabulary), patience or PATIENCE)


def understand(utterance: str, site: Site) -> Extraction:
    """Turn a sentence into a formula, a question back, or a reason to refuse it."""
    from plainspoken.language.extraction import extract

    return extract(utterance, site.vocabulary)


def find_policy(
    problem: Problem,
    goal: Formula,
    *,
    strong: bool = False,
    lucky: bool = False,
    timeout: float | None = None,
    on_progress: Callable[[Progress], None] | None = None,
) -> Ending:
    """Find a policy, and have it validated by code that shares nothing with the search.

    lucky: where there is none, one that works only with luck (its kind is `weak`)
    raises UnknownSymbolError: when the goal names what the problem does not have
    """
    ending = solve(
        problem, goal, strong=strong, lucky=lucky, timeout=timeout, on_progress=on_progress
    )
    if isinstance(ending, Solved):
        verdict = validate(problem, goal, ending.policy)
        if isinstance(verdict, Invalid):
            raise PlainspokenError(
                f"the planner made a policy that is not valid: {verdict.reason}",
                hint="this is a bug of plainspoken: please report domain, problem and goal",
            )
    return ending


def carry_out(
    site: Site,
    request: Request,
    policy: Policy,
    robot: Robot,
    record: Record,
    *,
    requests: Requests = lambda: None,
    patience: Patience | None = None,
) -> Generator[Entry, None, Mission]:
    """Carry a mission out; gives each entry of its log once it is stored."""
    from plainspoken.mission.executive import accept
    from plainspoken.mission.run import run_mission

    start = accept(accepted_as(site, request), policy)
    record, stale = _kept_fresh((), record, accepted_as(site, request))
    return run_mission(
        start, robot, record, replanner(site), requests=requests, patience=patience, stale=stale
    )


def accepted_as(site: Site, request: Request) -> MissionAccepted:
    """What the log of a mission begins with."""
    from plainspoken.mission.request import acceptance

    return acceptance(
        request.mission,
        site.problem,
        request.goal,
        domain_text=site.domain_text,
        problem_text=site.problem_text,
        sentence=request.sentence,
        english=site.in_words(request.goal),
        landmarks=landmarks_to_json(site.landmarks),
        robot=request.robot,
        unknown=request.unknown,
    )


def go_on(
    site: Site,
    entries: Sequence[Entry],
    robot: Robot,
    record: Record,
    *,
    by: str,
    requests: Requests = lambda: None,
    patience: Patience | None = None,
) -> Generator[Entry, None, Mission]:
    """Go on with a mission that was paused or killed, from its log alone."""
    from plainspoken.mission.executive import advance
    from plainspoken.mission.mission import mission_from
    from plainspoken.mission.observation import ResumeAsked
    from plainspoken.mission.run import run_mission

    record, stale = _kept_fresh(entries, record)
    start = advance(mission_from(entries), ResumeAsked(by), stale())
    return run_mission(
        start, robot, record, replanner(site), requests=requests, patience=patience, stale=stale
    )


def take_up(
    site: Site,
    entries: Sequence[Entry],
    robot: Robot,
    record: Record,
    *,
    by: str,
    requests: Requests,
    patience: Patience | None = None,
) -> Generator[Entry, None, Mission]:
    """Go on with a mission as it stands: a paused one stays paused until a request resumes it."""
    from plainspoken.mission.executive import Advance, advance
    from plainspoken.mission.mission import mission_from
    from plainspoken.mission.observation import TakeUpAsked
    from plainspoken.mission.run import run_mission

    mission = mission_from(entries)
    first = requests() if mission.is_at_rest else TakeUpAsked(by)
    record, stale = _kept_fresh(entries, record)
    start = Advance(mission, (), ()) if first is None else advance(mission, first, stale())
    return run_mission(
        start, robot, record, replanner(site), requests=requests, patience=patience, stale=stale
    )


def _kept_fresh(
    entries: Sequence[Entry], record: Record, accepted: MissionAccepted | None = None
) -> tuple[Record, Stale]:
    """What tells which facts were seen too long ago, by the entries so far and those to come."""
    from plainspoken.knowledge.facts import Folding
    from plainspoken.world.sense import Senses

    if not Senses.of(accepted or accepted_of(entries)):
        return record, frozenset
    folding = Folding()
    for entry in entries:
        folding.take(entry)

    def recorded(instant: Instant, events: Sequence[Event]) -> Sequence[Entry]:
        stored = record(instant, events)
        for entry in stored:
            folding.take(entry)
        return stored

    return recorded, lambda: folding.facts().stale(datetime.now(UTC))


def accepted_of(entries: Sequence[Entry]) -> MissionAccepted:
    """What a mission's log begins with.

    raises PlainspokenError: when it begins with something else, or is empty
    """
    first = entries[0].event if entries else None
    if not isinstance(first, MissionAccepted):
        raise PlainspokenError("a log begins with mission_accepted")
    return first


def site_of(accepted: MissionAccepted) -> Site:
    """The site that a mission's log tells of."""
    source = f"mission {accepted.mission}"
    domain = parse_domain(accepted.domain, f"{source}, domain")
    problem = parse_problem(accepted.problem, domain, f"{source}, problem")
    words = (
        landmarks_from_json(accepted.landmarks, f"{source}, landmarks", problem)
        if accepted.landmarks
        else None
    )
    return Site(problem, accepted.domain, accepted.problem, words)


def why_not(ending: Unsolvable | OutOfTime, site: Site) -> str:
    """Why there is no policy, in the site's words."""
    return ending.sentence if isinstance(ending, OutOfTime) else ending.reason.said(words_of(site))


def words_of(site: Site) -> Words:
    """How a site says formulas, facts and actions, with the robot as `I`."""
    from plainspoken.questions.lexicon import Lexicon
    from plainspoken.questions.wish import action_words

    lexicon = Lexicon(site.problem, site.landmarks)

    def said(formula: Formula) -> str:
        text = re.sub(r"\b[Yy]ou are\b", "I am", site.in_words(formula))
        return re.sub(r"\byour\b", "my", re.sub(r"\b[Yy]ou\b", "I", text))

    def deed(action: GroundAction) -> str:
        name, *arguments = action.split()
        if len(arguments) < len(site.problem.action(name)[0].parameters):
            return action_words(ActionSymbol(action, name, tuple(arguments)), lexicon)
        return lexicon.deed(action).bare

    return Words(said, lambda atom: lexicon.clause(atom).said(), deed)


def replanner(site: Site) -> Replanner:
    """Plans again from wherever a mission is, for what is left of its goal."""
    from plainspoken.mission.observation import NotPlanned

    def plan(state: State, remaining: Formula, heed: Heed) -> Policy | NotPlanned:
        here = replace(site.problem, initial=state)
        ending = find_policy(here, remaining, on_progress=lambda _: heed())
        if isinstance(ending, Solved):
            return ending.policy
        hopeless = isinstance(ending, Unsolvable) and is_hopeless(ending.reason)
        return NotPlanned(why_not(ending, site), hopeless)

    return plan
