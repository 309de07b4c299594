"""What broke the request: since when a part of it cannot be met any more, and what did that."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Sequence

from plainspoken.automata.verdict import Verdict
from plainspoken.logic.syntax import parse
from plainspoken.questions.claim import ActionClaim, Draft
from plainspoken.questions.demand import Demand
from plainspoken.questions.moment import Moment
from plainspoken.questions.morphology import listed
from plainspoken.questions.wish import standing, wish_of
from plainspoken.world.domain import GroundAtom
from plainspoken.world.event import Instant, ObservationMade, ReportReceived, Step


def broken_at(moment: Moment, demand: Demand) -> Instant | None:
    """The first instant after which a part of the request was violated for good, if it is now."""
    if demand.verdict is not Verdict.VIOLATED:
        return None
    own = {part.formula for part in demand.parts}

    def is_broken(instant: Instant) -> bool:
        upto = instant + 1
        return any(
            part.formula in own and part.verdict is Verdict.VIOLATED
            for part in moment.letters.parts_after(moment.states[:upto], moment.actions[:upto])
        )

    # What is violated for good stays so: halving finds where it begins.
    return bisect_left(range(moment.now), True, key=is_broken)


def tell_breach(draft: Draft, lost: Sequence[Demand]) -> None:
    """Say when parts of the request were broken, and what did it; the first of them is enough."""
    moment = draft.moment
    instants = [at for demand in lost if (at := broken_at(moment, demand)) is not None]
    if instants:
        draft.say(f"It was broken at instant {min(instants)}, {_cause(draft, min(instants))}")


def tell_hopeless(draft: Draft) -> None:
    """Say why the whole cannot be met any more where each part of it could be."""
    certain = draft.moment.certain
    if certain is None or certain[1].verdict != Verdict.VIOLATED:
        return
    step, reached = certain
    if reached.together:
        lexicon = draft.moment.lexicon
        wishes = [wish_of(parse(text), lexicon) for text in reached.together]
        together = "; ".join(standing(wish, lexicon) for wish in wishes)
        draft.say(f"These can no longer all be met: {together}")
    elif reached.reason is not None:
        draft.say(f"Nothing that I know of would still meet it. {reached.reason}")
    else:
        return
    draft.evidence.add(step)


def _cause(draft: Draft, at: Instant) -> str:
    """`when I moved to line 1`, with the entry that says so as evidence."""
    moment = draft.moment
    draft.evidence.add(moment.steps[at])
    found = _found_out(moment, at)
    if found is not None:
        step, event = found
        draft.evidence.add(step)
        if isinstance(event, ReportReceived):
            return f"when {event.reporter} reported “{event.text}”"
        return f"when it was seen that {_in_words(moment, event.added, event.deleted)}"
    if at == 0:
        return "as things were at the start"
    action = moment.actions[at]
    if action is not None:
        draft.actions.add(ActionClaim(action, at, "was"))
        deed = moment.lexicon.deed(action)
        return f"when {deed.subject} {deed.did}"
    report = next((r for step, r in moment.reports if step == moment.steps[at]), None)
    if report is not None:
        return f"when {report.reporter} reported “{report.text}”"
    before, after = moment.states[at - 1], moment.states[at]
    return f"when it was seen that {_in_words(moment, after - before, before - after)}"


def _found_out(moment: Moment, at: Instant) -> tuple[Step, ObservationMade | ReportReceived] | None:
    """The last entry by which an instant turned out to be other than it was taken to be."""
    for entry in reversed(moment.entries):
        event = entry.event
        if (
            entry.instant == at
            and entry.step > moment.steps[at]
            and isinstance(event, ObservationMade | ReportReceived)
            and (event.added or event.deleted)
        ):
            return entry.step, event
    return None


def _in_words(moment: Moment, added: Iterable[GroundAtom], deleted: Iterable[GroundAtom]) -> str:
    lexicon = moment.lexicon
    changed = [lexicon.clause(atom).said() for atom in sorted(added)]
    changed += [lexicon.clause(atom).said(negative=True) for atom in sorted(deleted)]
    return listed(changed)
