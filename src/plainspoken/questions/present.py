"""What is going on: the action in flight or the one next, what was just done, how things stand."""

from __future__ import annotations

import re
from collections.abc import Iterable

from plainspoken.questions.claim import ActionClaim, Draft
from plainspoken.questions.morphology import listed
from plainspoken.questions.narration import facts_together, natural, present_deed
from plainspoken.questions.past import outcome
from plainspoken.questions.question import Question
from plainspoken.questions.reason import purpose_words, reason_for
from plainspoken.questions.spelling import normal
from plainspoken.questions.standing import say_facts
from plainspoken.questions.wish import are_my_places
from plainspoken.world.domain import GroundAtom
from plainspoken.world.symbol import AtomSymbol

_HALTED = re.compile(r"\b(?:paused|stopped|idle|on hold|free|resting|inactive|waiting|stuck)\b")
_GOING = re.compile(r"\b(?:moving|working|running|active|busy|occupied)\b")


def tell_now(draft: Draft, question: Question) -> None:
    """Answer what is going on; whether it is, with yes or no first."""
    moment = draft.moment
    if moment.ended is not None:
        tell_end(draft)
    else:
        _tell_action(draft)
    agreed = question.yes_no and _agree(draft, question)
    if draft.full or not agreed:
        _tell_standing(draft)


def _agree(draft: Draft, question: Question) -> bool:
    """Put yes or no in front, where the question is whether something is under way."""
    asked = question.referents
    started = draft.moment.started
    plain = normal(question.text)
    if asked.actions or asked.objects:
        yes = started is not None and asked.concerns(started.action)
    elif _HALTED.search(plain):
        yes = draft.moment.paused and started is None
    elif _GOING.search(plain):
        yes = started is not None
    else:
        return False
    first = draft.sentences[0]
    own = first if first.startswith("I") else first[0].lower() + first[1:]
    draft.sentences[0] = f"{'Yes' if yes else 'No'}, {own}"
    return True


def tell_end(draft: Draft) -> None:
    """Say that the mission is over, and how."""
    moment = draft.moment
    ended = moment.ended
    if ended is None:
        return
    draft.evidence.add(moment.entries[-1].step)
    match ended.outcome:
        case "finished" if ended.satisfied:
            draft.say("I'm finished: everything you asked for is done")
        case "finished":
            draft.say("I've come to the end, but not everything you asked for is done")
        case "cancelled":
            draft.say("The mission was cancelled, so I've stopped")
        case _:
            draft.say("I've stopped before the end")


def _tell_action(draft: Draft) -> None:
    moment = draft.moment
    lexicon = moment.lexicon
    draft.evidence.add(moment.steps[-1])
    if moment.lost is not None:
        draft.say("The connection to the robot is lost, so this is what was known before")
    if moment.started is not None:
        action = moment.started.action
        draft.evidence.add(moment.started_step)
        draft.actions.add(ActionClaim(action, moment.now + 1, "may"))
        purpose = reason_for(moment)
        words = purpose_words(draft, purpose) if purpose is not None else ""
        doing = f" ({moment.doing})" if moment.doing else ""
        draft.say(f"{present_deed(lexicon.deed(action))}{doing}{words}")
        for step, other in moment.beside:
            draft.evidence.add(step)
            draft.actions.add(ActionClaim(other.action, moment.now + 1, "may"))
            draft.say(f"At the same time, {present_deed(lexicon.deed(other.action))}")
        if moment.overdue:
            draft.say("It takes longer than it should, so I'm giving it up")
        return
    if moment.paused:
        draft.say("I'm paused at the moment")
        return
    parts = []
    if moment.happenings and moment.happenings[-1].at == moment.now:
        last = moment.happenings[-1]
        draft.did(last)
        found = outcome(moment, last)
        draft.now(found)
        said = listed([each.text for each in facts_together(lexicon, found)])
        deed = lexicon.deed(last.action)
        have = "I've just" if deed.subject == "I" else f"{deed.subject} has just"
        parts.append(f"{have} {deed.done}" + (f": {said}" if said else ""))
    node = moment.node
    if node is not None and node.action is not None:
        draft.node(node.id)
        draft.actions.add(ActionClaim(node.action, moment.now + 1, "will"))
        deed = lexicon.deed(node.action)
        will = "I'm about to" if deed.subject == "I" else f"{deed.subject} is about to"
        again = moment.happenings and moment.happenings[-1].action == node.action
        parts.append(f"{will} {'try again' if again and parts else deed.bare}")
    elif moment.chosen is None:
        parts.append("I'm working out how to do what you asked")
    elif not parts:
        parts.append("I'm between two actions")
    draft.say(", and ".join(parts))


def _tell_standing(draft: Draft) -> None:
    """How things stand: where I am, what the action touches, then what the request speaks of."""
    say_facts(draft, ranked(draft, draft.moment.fluents), draft.now)


def ranked(draft: Draft, atoms: Iterable[GroundAtom]) -> list[GroundAtom]:
    """Facts, what matters most first: where I am, what the action touches or is done for."""
    moment = draft.moment
    lexicon = moment.lexicon
    action = moment.started.action if moment.started else None
    if action is None and moment.node is not None:
        action = moment.node.action
    if action is None and moment.happenings and moment.ended is None:
        action = moment.happenings[-1].action
    reason = reason_for(moment)
    later = reason.links[1].action if reason is not None and len(reason.links) > 1 else ""
    touched = {each for each in (action or "").split()[1:] if each != lexicon.me}
    used = touched | {each for each in later.split()[1:] if each != lexicon.me}
    asked = {s.atom for s in moment.letters.symbols if isinstance(s, AtomSymbol)}

    def rank(atom: GroundAtom) -> int:
        arguments = set(atom.split()[1:])
        if are_my_places([atom], lexicon):
            return 0
        for number, things in enumerate((touched, used), start=1):
            if arguments & things and arguments <= things | {lexicon.me}:
                return number
        return 3 if atom in asked else 4

    return sorted(atoms, key=lambda atom: (rank(atom), natural(atom)))
