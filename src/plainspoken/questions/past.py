"""What was done: in order, condensed, or the part of it that is asked about."""

from __future__ import annotations

import re
from collections.abc import Sequence

from plainspoken.questions.age import lasting
from plainspoken.questions.claim import ActionClaim, Draft
from plainspoken.questions.clause import Deed, enumerated
from plainspoken.questions.moment import Happening, Moment
from plainspoken.questions.morphology import counted, listed, participle, times
from plainspoken.questions.narration import (
    ago,
    deeds_together,
    facts_together,
    often,
    past_deeds,
)
from plainspoken.questions.question import Question, Span
from plainspoken.questions.standing import say_facts, say_only
from plainspoken.questions.wish import action_words
from plainspoken.world.domain import GroundAtom
from plainspoken.world.scene import is_applicable, successors
from plainspoken.world.symbol import ActionSymbol

ROOM_FOR_REST = 15
"""Words that a brief answer keeps for what else has changed."""


def tell_past(draft: Draft, question: Question) -> None:
    """Answer what was done."""
    moment = draft.moment
    happenings = moment.happenings
    asked = question.referents
    if question.yes_no and asked.actions and question.span is not Span.LAST:
        tell_whether(draft, question)
        return
    if question.yes_no and (asked.atoms or asked.visits) and not asked.actions:
        tell_so_far(draft, question)
        return
    if not happenings:
        draft.evidence.add(moment.steps[0])
        draft.say("I haven't done anything yet")
        if moment.started is not None:
            deed = moment.lexicon.deed(moment.started.action)
            draft.actions.add(ActionClaim(moment.started.action, moment.now + 1, "may"))
            draft.evidence.add(moment.started_step)
            draft.say(f"I've only just started {deed.doing}")
        if draft.full:
            _tell_facts(draft)
        return
    if question.yes_no and re.search(
        r"\b(?:fail|error|problem|trouble|wrong)", question.text.lower()
    ):
        _tell_failures(draft)
        return
    if question.span is Span.FIRST:
        first = happenings[0]
        draft.did(first)
        draft.say(f"First {past_deeds([(moment.lexicon.deed(first.action), 1)])}")
        return
    if question.span is Span.BEFORE or (question.span is Span.AFTER and asked.actions):
        happenings = _cut(moment, question)
    if question.span is Span.LAST:
        _tell_last(draft, happenings)
    else:
        chosen = [each for each in happenings if asked.concerns(each.action)]
        if asked.objects and not chosen and question.span is Span.ALL:
            draft.evidence.add(moment.steps[-1])
            no = "No, " if question.yes_no else ""
            draft.say(f"{no}I haven't done anything with {_named(asked.objects, moment)} so far")
            return
        _tell_all(draft, chosen or happenings)
        if draft.full:
            _tell_facts(draft)
        return
    if draft.full:
        _tell_facts(draft)


def _named(objects: Sequence[str], moment: Moment) -> str:
    return enumerated([moment.lexicon.object_words(name) for name in objects])


def _tell_failures(draft: Draft) -> None:
    """Say what could not be carried out, if anything."""
    moment = draft.moment
    draft.evidence.add(moment.entries[-1].step)
    if not moment.failures:
        draft.say("No, nothing has failed so far")
        return
    draft.evidence.update(step for step, _ in moment.failures)
    failed = dict.fromkeys(moment.lexicon.deed(event.action) for _, event in moment.failures)
    draft.say(f"Yes, I couldn't {listed([deed.bare for deed in failed], 'or')} when I tried")


def _cut(moment: Moment, question: Question) -> list[Happening]:
    """The happenings before or after the last one spoken of; `before that`: but the last."""
    happenings = moment.happenings
    asked = question.referents
    if not asked.actions and not asked.objects:
        return happenings[:-1] or happenings
    at = [i for i, each in enumerate(happenings) if asked.concerns(each.action)]
    if not at:
        return happenings
    kept = happenings[: at[-1]] if question.span is Span.BEFORE else happenings[at[-1] + 1 :]
    return kept or happenings


def _tell_last(draft: Draft, happenings: Sequence[Happening]) -> None:
    moment = draft.moment
    last = happenings[-1]
    draft.did(last)
    deed = moment.lexicon.deed(last.action)
    found = listed([each.text for each in facts_together(moment.lexicon, outcome(moment, last))])
    when = "" if last.at == moment.now else f", {ago(moment.now - last.at)}"
    draft.say(f"{past_deeds([(deed, 1)])}{when}" + (f": {found}" if found else ""))
    for atom in outcome(moment, last):
        draft.now([atom])


def outcome(moment: Moment, happening: Happening) -> list[GroundAtom]:
    """What an action turned out to make true and that is so now, where it had a choice."""
    before = moment.whole(moment.states[happening.at - 1])
    after = moment.states[happening.at]
    if not is_applicable(moment.problem, before, happening.action):
        return []  # The world has done something that the model does not foresee.
    possible = successors(moment.problem, before, happening.action)
    if len(possible) < 2:
        return []
    common = frozenset.intersection(*possible)
    done = participle(moment.lexicon.deed(happening.action).verb)
    return sorted(
        atom
        for atom in after - before
        if atom not in common
        and atom in moment.state
        and moment.lexicon.clause(atom).complement != done  # Scanned it, and now it is scanned.
    )


def _tell_all(draft: Draft, happenings: Sequence[Happening]) -> None:
    """All of them, condensed: kinds of deeds in the order they were first done, and what came."""
    moment = draft.moment
    lexicon = moment.lexicon
    last = happenings[-1]
    whole = len(happenings) == len(moment.happenings)
    told = _most_telling(draft, happenings)
    groups = deeds_together(lexicon, [each.action for each in told])
    draft.did_all(told)
    several = len(happenings) > 1
    opening = past_deeds(groups, perfect=several)
    if len(told) < len(happenings):
        opening += f", among other things: {counted(len(happenings), 'action')} in all"
    draft.say(f"So far {opening}" if several else opening)
    came = outcome(moment, last)
    spare = len(groups) > 3 and draft.room > ROOM_FOR_REST
    if groups[-1][0] != _deed(moment, last) and (came or last not in told or spare):
        found = listed([each.text for each in facts_together(lexicon, came)])
        draft.now(came)
        draft.did(last)
        told_last = past_deeds([(_deed(moment, last), 1)])
        draft.say(f"{_just(moment, last)} {told_last}" + (f": {found}" if found else ""))
    if whole and not draft.full:
        _tell_rest(draft, told)


def _deed(moment: Moment, happening: Happening) -> Deed:
    return moment.lexicon.deed(happening.action)


def _most_telling(draft: Draft, happenings: Sequence[Happening]) -> list[Happening]:
    """Those that there is room to tell: going from place to place only where all else is told."""
    moment = draft.moment
    names = list(dict.fromkeys(each.action.split()[0] for each in happenings))
    moving = {name for name in names if is_motion(moment, _of(name, happenings))}
    if len(moving) == len(names):
        moving = set()
    kept: set[str] = set()
    for name in [*(n for n in names if n not in moving), *(n for n in names if n in moving)]:
        tried = [each for each in happenings if each.action.split()[0] in {*kept, name}]
        groups = deeds_together(moment.lexicon, [each.action for each in tried])
        if not kept or len(past_deeds(groups).split()) <= draft.room - ROOM_FOR_REST:
            kept.add(name)
    return [each for each in happenings if each.action.split()[0] in kept]


def _of(name: str, happenings: Sequence[Happening]) -> str:
    return next(each.action for each in happenings if each.action.split()[0] == name)


def _tell_rest(draft: Draft, told: Sequence[Happening]) -> None:
    """What else has changed, or that nothing has."""
    moment = draft.moment
    moment.look_back(moment.fluents)
    known = {each.at for each in told}
    changed = any(
        at not in known and moment.states[at] != moment.states[at - 1]
        for at in range(1, moment.now + 1)
    )
    if not changed:
        draft.now(atom for atom in sorted(moment.fluents) if moment.since(atom) == 0)
        draft.say("Nothing else has changed")
        draft.rest = True
        return
    kept = [atom for atom in sorted(moment.fluents) if moment.since(atom) == 0]
    changing = [a for a, runs in moment.runs.items() if runs != [(0, moment.now)]]
    several = len({moment.lexicon.clause(a).subject for a in changing} - {"I"}) > 1
    verb = f"{'have' if several else 'has'} changed"
    if not say_only(draft, changing, kept, draft.now, verb, others="still"):
        say_facts(draft, kept, draft.now, "still")


def _just(moment: Moment, last: Happening) -> str:
    return "Most recently" if last.at == moment.now else ago(moment.now - last.at)


def is_motion(moment: Moment, action: str) -> bool:
    """Whether an action only takes the robot from one place to another."""
    deed = moment.lexicon.deed(action)
    return len(deed.parts) == 2 and deed.parts[0] == "to"


def _tell_facts(draft: Draft) -> None:
    """Every fact over the time so far: what held from the start, and what came and went."""
    moment = draft.moment
    ended = sorted(
        atom
        for atom, runs in moment.runs.items()
        if moment.changes(atom) and runs[-1][1] < moment.now
    )

    def claim(atoms: Sequence[GroundAtom]) -> None:
        for atom in atoms:
            for start, _ in moment.runs[atom]:
                draft.was(atom, start)

    say_facts(draft, ended, claim, "was", "Earlier")
    say_facts(draft, sorted(moment.fluents), claim, opening="Now")


def tell_whether(draft: Draft, question: Question) -> None:
    """Answer whether, and when, something was done."""
    moment = draft.moment
    lexicon = moment.lexicon
    asked = question.referents
    found = [each for each in moment.happenings if asked.concerns(each.action)]
    if not found:
        draft.evidence.add(moment.steps[-1])
        done = _undone(question, moment)
        started = moment.started
        if started is not None and asked.concerns(started.action):
            draft.evidence.add(moment.started_step)
            draft.actions.add(ActionClaim(started.action, moment.now + 1, "may"))
            draft.say(f"Not yet, but I'm {lexicon.deed(started.action).doing} now")
        else:
            draft.say(
                f"{'No,' if question.yes_no else 'So far'} I haven't {done}"
                + (" so far" if question.yes_no else "")
            )
        return
    draft.did_all(found)
    groups = deeds_together(lexicon, [each.action for each in found])
    number = f", {times(len(found))} in all" if len(found) > 1 and len(groups) > 1 else ""
    last = (
        f"; the last time was {ago(moment.now - found[-1].at)}"
        if len(found) > 1
        else (f", {ago(moment.now - found[-1].at)}")
    )
    draft.say(f"Yes, {past_deeds(groups)}{number}{last}")


def _undone(question: Question, moment: Moment) -> str:
    """`checked mug 3`, `called the support robot`: what was asked about, as a participle."""
    said = []
    for name in question.referents.actions:
        symbol = ActionSymbol(
            f"{name.replace('-', '_')}_executed", name, question.referents.objects
        )
        words = action_words(symbol, moment.lexicon)
        verb, _, rest = words.partition(" ")
        said.append(f"{participle(verb)} {rest}".strip())
    return listed(said, "or") or "done that"


def tell_count(draft: Draft, question: Question) -> None:
    """Answer how often something was done, or whether ever."""
    moment = draft.moment
    asked = question.referents
    if not asked.actions:
        _count_all(draft, question)
        return
    found = [each for each in moment.happenings if asked.concerns(each.action)]
    if not found:
        tell_whether(draft, question)
        return
    draft.did_all(found)
    groups = deeds_together(moment.lexicon, [each.action for each in found])
    opening = "Yes, " if question.yes_no else ""
    said = past_deeds([(deed, 1) for deed, _ in groups])
    if len({each.action for each in found}) == len(found) > 1:
        draft.say(f"{opening}{said}: {times(len(found))} in all")
    else:
        draft.say(f"{opening}{often(said, len(found)) if len(found) > 1 else said + ' once'}")


def _count_all(draft: Draft, question: Question) -> None:
    moment = draft.moment
    asked = question.referents
    if asked.atoms:
        atom = asked.atoms[0]
        runs = moment.runs.get(atom, [])
        draft.evidence.add(moment.steps[-1])
        for start, _ in runs:
            draft.was(atom, start)
        clause = moment.lexicon.clause(atom)
        if not runs:
            draft.now([atom])
            draft.say(f"No, {clause.never()}" if question.yes_no else f"Not once: {clause.never()}")
        else:
            yes = "Yes, " if question.yes_no else ""
            draft.say(f"{yes}{clause.ever()} {times(len(runs))} so far")
        return
    happenings = moment.happenings
    draft.evidence.update(each.step for each in happenings[-1:])
    draft.did_all(happenings, changes=False)
    draft.say(f"So far I've done {counted(len(happenings), 'action')}")


def tell_so_far(draft: Draft, question: Question, *, hoped: bool = True) -> None:
    """Answer whether something asked about has ever been so, and when last.

    hoped: False where the question is whether it was avoided
    """
    moment = draft.moment
    lexicon = moment.lexicon
    atoms = _meant_facts(question, moment)
    draft.evidence.add(moment.steps[-1])
    if not atoms:
        draft.known = False
        draft.say("You asked for nothing about that, as far as I know")
        return
    been = [atom for atom in atoms if atom in moment.runs]
    if not been:
        draft.now(atoms)
        said = listed([lexicon.clause(atom).never() for atom in atoms[:4]])
        no = "No" if hoped else "Yes"
        draft.say(f"{no}, {said}" if question.yes_no else said)
        return
    yes = "" if not question.yes_no else "Yes, " if hoped else "No, "
    for atom in been[:4]:
        runs = moment.runs[atom]
        for start, _ in runs:
            draft.was(atom, start)
        clause = lexicon.clause(atom)
        often_so = f" {times(len(runs))}" if len(runs) > 1 else ""
        if atom in moment.state:
            draft.say(
                f"{yes}{lasting(draft, atom)}"
                if not often_so
                else f"{yes}{clause.ever()}{often_so}, and it is so now"
            )
        else:
            last = ago(moment.now - runs[-1][1])
            draft.say(f"{yes}{clause.ever()}{often_so}, the last time {last}")


def _meant_facts(question: Question, moment: Moment) -> list[GroundAtom]:
    """The facts a question about the past is about: as spelled out, or where I was."""
    asked = question.referents
    if asked.atoms:
        best = asked.atoms[0].split()[0]
        return [atom for atom in asked.atoms if atom.split()[0] == best]
    return [a for a in asked.visits if moment.changes(a)]
