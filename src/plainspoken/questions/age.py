"""Since when a fact is as it is, and how it is known."""

from __future__ import annotations

from bisect import bisect_left

from plainspoken.questions.claim import Draft
from plainspoken.questions.doubt import as_heard
from plainspoken.questions.narration import ago
from plainspoken.world.domain import GroundAtom
from plainspoken.world.event import ActionFinished, ObservationMade, ReportReceived


def lasting(draft: Draft, atom: GroundAtom) -> str:
    """`The sink has been full since I rinsed mug 1 two actions ago`, of what is so."""
    moment = draft.moment
    clause = moment.lexicon.clause(atom)
    if atom in moment.static:
        return clause.said()
    since = moment.since(atom)
    if since == 0 and not as_heard(moment, atom):
        draft.evidence.add(moment.steps[0])
        return f"{clause.said('has')} from the start"
    told = since_when(draft, atom)
    return f"{clause.said('now' if told.startswith(',') else 'has')}{told}"


def since_when(draft: Draft, atom: GroundAtom) -> str:
    """` since I checked it two actions ago`, or `, as Ann reported two actions ago`."""
    moment = draft.moment
    since = moment.since(atom)
    step = moment.steps[since]
    draft.evidence.add(step)
    heard = as_heard(moment, atom)
    if heard:
        return heard
    index = bisect_left(moment.entries, step, key=lambda entry: entry.step)
    when = ago(moment.now - since)
    match moment.entries[index].event:
        case ActionFinished(action=action):
            deed = moment.lexicon.deed(action)
            return f" since {deed.subject} {deed.did} {when}"
        case ReportReceived(reporter=reporter):
            return f", as {reporter} reported {when}"
        case ObservationMade():
            return f", as I saw {when}"
        case _:
            return f", since {when}"
