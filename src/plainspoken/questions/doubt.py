"""What is not known, said as such; and how what is known came to be known."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from datetime import datetime

from plainspoken.knowledge.facts import Fact, Knowledge, Source
from plainspoken.questions.claim import Draft
from plainspoken.questions.moment import Moment
from plainspoken.questions.morphology import counted, listed
from plainspoken.questions.question import Question
from plainspoken.questions.spelling import normal
from plainspoken.world.domain import GroundAtom

MOST_DOUBTED = 6
"""Facts that are named one by one in what is not known."""
_HOW_KNOWN = re.compile(
    r"\bhow (?:do|did|come) (?:you|we) (?:know|find out|learn|can tell)\b"
    r"|\bhow can you (?:tell|know)\b|\bwho (?:told|says|said)\b"
    r"|\bwhat makes you (?:think|believe|so sure|say)\b"
    r"|\bare you (?:sure|certain)\b|\bhow (?:sure|certain) are you\b|\bwhat tells you\b"
)


def asks_how_known(question: Question) -> bool:
    """Whether it is asked where a fact is known from: `How do you know?`."""
    return _HOW_KNOWN.search(normal(question.text)) is not None


def tell_how_known(draft: Draft, question: Question) -> None:
    """Say where a fact is known from."""
    moment = draft.moment
    atoms = question.referents.atoms if question.referents.objects else ()
    if not atoms and moment.lexicon.me:
        about_me = [each for each in question.referents.atoms if moment.lexicon.me in each.split()]
        if re.search(r"\byou(?:'re| are| have)\b(?! (?:sure|certain))", question.text.lower()):
            atoms = tuple(about_me)
    if not atoms:
        draft.known = False
        draft.say('I don\'t know which fact you mean; ask "How do you know that ...?"')
        return
    atom = atoms[0]
    if moment.is_unsure(atom):
        tell_doubt(draft, atom)
        return
    known = moment.known(atom)
    draft.now([atom])
    draft.evidence.add(known.step)
    holds = atom in moment.state or atom in moment.static
    clause = moment.lexicon.clause(atom).said(negative=not holds)
    draft.say(f"{_source_words(moment, known)}: {clause}")


def tell_doubt(draft: Draft, atom: GroundAtom) -> None:
    """`I don't know; I last saw it empty 12 minutes ago`."""
    moment = draft.moment
    known = moment.known(atom)
    draft.known = False
    draft.wanted.add(atom)
    draft.evidence.add(known.step)
    clause = moment.lexicon.clause(atom)
    looked = "I looked, and couldn't tell" if known.vain is not None else ""
    if known.vain is not None:
        draft.evidence.add(known.vain)
    if known.is_stale:
        fact, age = known.fact, _age(moment, known.seen)
        last = clause.said("was", negative=not fact.holds)
        draft.say(f"I don't know any more; {_last_heard(fact)} {age} that {last}")
        draft.say(looked)
    else:
        reason = looked or "nobody has told me, and I haven't looked"
        draft.say(f"I don't know whether {clause.said()}: {reason}")


def tell_doubts(draft: Draft, atoms: Iterable[GroundAtom]) -> None:
    """Say of which of several facts it is not known whether they are so."""
    moment = draft.moment
    unsure = sorted(atom for atom in atoms if moment.is_unsure(atom))
    if not unsure:
        return
    draft.wanted.update(unsure)
    draft.evidence.update(moment.known(atom).step for atom in unsure)
    if len(unsure) > MOST_DOUBTED:
        draft.say(f"Of {len(unsure)} others I don't know")
        return
    said = [moment.lexicon.clause(atom).said() for atom in unsure]
    draft.say(f"I don't know whether {listed(said, 'or')}")


def as_heard(moment: Moment, atom: GroundAtom) -> str:
    """`, as I saw 3 minutes ago`, of a fact that was not known at first; else nothing."""
    known = moment.known(atom)
    if atom not in moment.mission.unknown or known.fact.source is Source.ACTION:
        return ""
    moments = {Source.REPORT: "I was told", Source.OBSERVATION: "I saw"}
    if known.fact.source not in moments:
        return ""
    return f", as {moments[known.fact.source]} {_age(moment, known.fact.time)}"


def _source_words(moment: Moment, known: Knowledge) -> str:
    """`I looked 3 minutes ago`, `ada told me just now`, `that's how it was from the start`."""
    fact, age = known.fact, _age(moment, known.seen)
    match fact.source:
        case Source.INITIAL:
            return "That's what I was given at the start"
        case Source.REPORT:
            return f"{fact.by} told me {age}"
        case Source.OBSERVATION if fact.by == "model":
            return f"It follows from what I saw {age}"
        case Source.OBSERVATION:
            return f"I saw it {age}, through {fact.by}" if fact.by else f"I saw it {age}"
        case Source.ACTION:
            deed = moment.lexicon.deed(fact.by) if fact.by else None
            return f"{deed.subject} {deed.did} {age}" if deed else f"I did it {age}"


def _last_heard(fact: Fact) -> str:
    if fact.source is Source.REPORT:
        return f"{fact.by} told me"
    if fact.source is Source.INITIAL:
        return "I was told"
    return "I last saw"


def _age(moment: Moment, seen: str) -> str:
    """`just now`, `12 minutes ago`: between a look and the time of the question."""
    try:
        seconds = (moment.asked_at - datetime.fromisoformat(seen)).total_seconds()
    except (TypeError, ValueError):
        return "before"  # a log may be dated by no clock
    for unit, size in (("day", 86400), ("hour", 3600), ("minute", 60), ("second", 1)):
        number = int(seconds // size)
        if number >= 1 and (unit != "second" or number > 2):
            return f"{counted(number, unit)} ago"
    return "just now"


def doubted(moment: Moment, predicate: str, column: int, names: Sequence[str]) -> list[GroundAtom]:
    """The facts of a predicate that are not known, of these things."""
    return sorted(
        atom
        for atom in moment.unsure
        if atom.split()[0] == predicate and atom.split()[column + 1] in names
    )
