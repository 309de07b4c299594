"""Who said so: where a fact is known from, what people reported, and what they had changed."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterable, Sequence

from plainspoken.logic.formula import atoms
from plainspoken.logic.syntax import parse
from plainspoken.questions.claim import Draft
from plainspoken.questions.kind import Kind
from plainspoken.questions.moment import Moment
from plainspoken.questions.morphology import listed
from plainspoken.questions.question import Question
from plainspoken.questions.referent import referents_of
from plainspoken.questions.spelling import normal
from plainspoken.world.domain import GroundAtom
from plainspoken.world.event import (
    ActionFinished,
    Entry,
    MissionAccepted,
    ObservationMade,
    ReportReceived,
    RequestChanged,
    Step,
)
from plainspoken.world.symbol import ActionSymbol, AtomSymbol, resolve

_HOW_KNOWN = re.compile(
    r"\bhow (?:do|did|can|could) you (?:\w+ )?know\b|\bhow (?:sure|certain) are you\b"
    r"|\bwho (?:\w+ )?(?:says|said|told|tells|reported|claims|claimed)\b"
    r"|\b(?:where|whom) do you know\b|\bfrom whom\b"
    r"|\b(?:did|has|have) (?:anyone|anybody|someone|somebody|a person)\b.*\b(?:tell|told|say|said"
    r"|reported?)\b"
)
_WHO_DID = re.compile(r"^(?:and |but |so )?who (?:has |have )?\w+(?:ed|en|t|n|k|g)\b")
_REPORTS = re.compile(
    r"^(?:and |but |so )?(?:what|which)\b.*\b(?:report|reported|reports|(?:tell|told) you)\b"
    r"|^(?:did|has) (?:anyone|anybody|someone|somebody)\b.*\breport(?:ed)?\b"
)


def tell_source(draft: Draft, question: Question) -> bool:
    """Answer who did or said something, or how it is known; False where that is not asked."""
    plain = normal(question.text)
    about = question.referents
    if _HOW_KNOWN.search(plain) and about.atoms:
        _tell_how_known(draft, about.atoms[0])
        return True
    if re.search(r"\bwho (?:told|asked) you to\b", plain) and about.objects:
        return _tell_change(draft, about.objects)
    if _REPORTS.search(plain):
        return _tell_reports(draft, plain)
    if _WHO_DID.search(plain) and question.kind in (Kind.STATE, Kind.PAST, Kind.WHY_HAPPENED):
        return _tell_who(draft, question)
    return False


def tell_change(draft: Draft, question: Question) -> bool:
    """Answer why something is not done that somebody asked to be left out; False if nobody did."""
    if question.kind not in (Kind.WHY_NOT, Kind.WHY_HAPPENED, Kind.WHY_ACTION):
        return False
    if question.kind is not Kind.WHY_NOT and not re.search(
        r"\b(?:not|never|skip\w*|leav\w*|left|drop\w*|omit\w*)\b", normal(question.text)
    ):
        return False
    return bool(question.referents.objects) and _tell_change(draft, question.referents.objects)


def at_time(entry: Entry) -> str:
    """`at 09:14`; nothing for a log without times."""
    clock = entry.time[11:16]
    return f" at {clock}" if re.fullmatch(r"\d\d:\d\d", clock) else ""


def _entry(moment: Moment, step: Step) -> Entry:
    return moment.entries[bisect_left(moment.entries, step, key=lambda entry: entry.step)]


def _tell_how_known(draft: Draft, atom: GroundAtom) -> None:
    """The event that a fact is known from."""
    moment = draft.moment
    so = atom in moment.state or atom in moment.static
    clause = moment.lexicon.clause(atom).said(negative=not so)
    draft.now([atom])
    reports = [step for step, each in moment.reports if _speaks_of(each, atom, holds=so)]
    entry = _entry(moment, moment.steps[moment.since(atom)])
    if reports and (reports[-1] >= entry.step):
        _say_report(draft, _entry(moment, reports[-1]))
        return
    draft.evidence.add(entry.step)
    when = at_time(entry)
    match entry.event:
        case ActionFinished(action=action):
            deed = moment.lexicon.deed(action)
            draft.say(f"I saw that {clause} after {deed.subject} {deed.did}{when}")
        case ObservationMade(source=source):
            draft.say(f"It was observed{when} by {source}: {clause}")
        case MissionAccepted():
            draft.say(f"From the start it is taken to be so that {clause}; nobody reported it")
        case _:
            draft.say(f"I saw{when} that {clause}")


def _speaks_of(report: ReportReceived, atom: GroundAtom, *, holds: bool) -> bool:
    return atom in (report.added if holds else report.deleted)


def _say_report(draft: Draft, entry: Entry) -> None:
    """`Anna reported it at 09:14: "I cleared line 2 myself"`."""
    if isinstance(entry.event, ReportReceived):
        draft.evidence.add(entry.step)
        draft.say(f'{entry.event.reporter} reported it{at_time(entry)}: "{entry.event.text}"')


def _tell_reports(draft: Draft, plain: str) -> bool:
    """What people reported; of one person, where the name is said."""
    moment = draft.moment
    draft.evidence.add(moment.entries[-1].step)
    named = [each for each in moment.reports if normal(each[1].reporter) in plain]
    found = named or moment.reports
    if not found:
        draft.say("Nobody has reported anything so far")
        return True
    told = []
    for step, report in found:
        draft.evidence.add(step)
        told.append(f'{report.reporter}{at_time(_entry(moment, step))}: "{report.text}"')
    draft.say(f"So far I was told by {listed(told)}")
    return True


def _tell_who(draft: Draft, question: Question) -> bool:
    """Who did it: I, as the log says, or somebody who reported it."""
    moment = draft.moment
    about = question.referents
    done = [each for each in moment.happenings if about.actions and about.concerns(each.action)]
    reported = [
        step
        for step, each in moment.reports
        if _is_about(each, about.atoms or (), about.objects, moment)
    ]
    if done and (not reported or done[-1].step > reported[-1]):
        last = done[-1]
        draft.did(last)
        deed = moment.lexicon.deed(last.action)
        draft.say(f"{deed.subject} {deed.did}{at_time(_entry(moment, last.step))}")
        return True
    if reported:
        draft.now(about.atoms[:1])
        _say_report(draft, _entry(moment, reported[-1]))
        return True
    if about.atoms and about.atoms[0] in moment.state:
        _tell_how_known(draft, about.atoms[0])
        return True
    return False


def _is_about(
    report: ReportReceived, facts: Sequence[GroundAtom], objects: Sequence[str], moment: Moment
) -> bool:
    """Whether a report made one of some facts so, or speaks of doing something to the objects."""
    if any(atom in report.added for atom in facts):
        return True
    spoken = referents_of(normal(report.text), moment.lexicon)
    return not facts and bool(objects) and set(objects) <= set(spoken.objects)


# -- what was changed --------------------------------------------------------------------------


def _tell_change(draft: Draft, objects: Sequence[str]) -> bool:
    """Name the change of mind since which nothing is asked of some things."""
    moment = draft.moment
    before = _asked_of([moment.mission.goal], moment)
    found: Entry | None = None
    for entry in moment.entries:
        if isinstance(entry.event, RequestChanged):
            after = _asked_of([str(each["goal"]) for each in entry.event.clauses], moment)
            if any(name in before and name not in after for name in objects):
                found = entry
            elif all(name in after for name in objects):
                found = None
            before = after
    if found is None or not isinstance(found.event, RequestChanged):
        return False
    draft.evidence.add(found.step)
    draft.say(f'Because {found.event.by} told me{at_time(found)}: "{found.event.text}"')
    return True


def _asked_of(goals: Iterable[str], moment: Moment) -> frozenset[str]:
    """The objects that formulas speak of."""
    found: set[str] = set()
    for goal in goals:
        for name in atoms(parse(goal)):
            match resolve(name, moment.problem):
                case AtomSymbol(atom=atom):
                    found.update(atom.split()[1:])
                case ActionSymbol(arguments=arguments):
                    found.update(arguments)
    return frozenset(found)
