"""What is going on: the action in flight or the one next, what was just done, how things stand."""

from __future__ import annotations

from collections.abc import Iterable

from plainspoken.questions.claim import ActionClaim, Draft
from plainspoken.questions.morphology import listed
from plainspoken.questions.narration import Saying, facts_together, present_deed
from plainspoken.questions.past import BRIEF, outcome
from plainspoken.questions.question import Question
from plainspoken.questions.reason import purpose_words, reason_for
from plainspoken.world.domain import GroundAtom
from plainspoken.world.symbol import AtomSymbol


def tell_now(draft: Draft, question: Question, *, full: bool) -> None:
    """Answer what is going on."""
    moment = draft.moment
    if moment.ended is not None:
        tell_end(draft)
    else:
        _tell_action(draft)
        _agree(draft, question)
    _tell_standing(draft, full=full)


def _agree(draft: Draft, question: Question) -> None:
    """Put yes or no in front, where the question is whether an action is under way."""
    asked = question.referents
    if question.yes_no and asked.actions:
        started = draft.moment.started
        yes = started is not None and asked.concerns(started.action)
        first = draft.sentences[0]
        own = first if first.startswith("I") else first[0].lower() + first[1:]
        draft.sentences[0] = f"{'Yes' if yes else 'No'}, {own}"


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
    if moment.started is not None:
        action = moment.started.action
        draft.evidence.add(moment.started_step)
        draft.actions.add(ActionClaim(action, moment.now + 1, "may"))
        purpose = reason_for(moment)
        words = purpose_words(draft, purpose) if purpose is not None else ""
        draft.say(f"{present_deed(lexicon.deed(action))}{words}")
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
        parts.append(f"{will} {deed.bare}")
    elif moment.chosen is None:
        parts.append("I'm working out how to do what you asked")
    elif not parts:
        parts.append("I'm between two actions")
    draft.say(", and ".join(parts))


def _tell_standing(draft: Draft, *, full: bool) -> None:
    """How things stand: what the action touches first, then what the request speaks of."""
    moment = draft.moment
    sayings = facts_together(moment.lexicon, ranked(draft, moment.fluents), most=12 if full else 5)
    room = BRIEF - sum(len(sentence.split()) for sentence in draft.sentences)
    chosen: list[Saying] = []
    for saying in sayings:
        room -= len(saying.text.split()) + 1
        if not full and room < 0 and chosen:
            break
        chosen.append(saying)
    for saying in chosen:
        draft.now(saying.atoms)
    draft.say(listed([saying.text for saying in chosen]))


def ranked(draft: Draft, atoms: Iterable[GroundAtom]) -> list[GroundAtom]:
    """Facts, what matters most first: where I am, what changed last, what was asked for."""
    moment = draft.moment
    lexicon = moment.lexicon
    touched = set((moment.started.action if moment.started else "").split()[1:])
    if not touched and moment.happenings:
        touched = set(moment.happenings[-1].action.split()[1:])
    asked = {s.atom for s in moment.letters.symbols if isinstance(s, AtomSymbol)}

    def rank(atom: GroundAtom) -> tuple[int, str]:
        arguments = atom.split()[1:]
        mine = lexicon.clause(atom).subject == "I" and lexicon.place_clause(atom)
        about = all(each in touched or each == lexicon.me for each in arguments)
        return (0 if mine else 1 if about else 2 if atom in asked else 3, atom)

    return sorted(atoms, key=rank)
