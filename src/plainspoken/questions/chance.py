"""What is not asked of an action: why a fact came about, and what if one did."""

from __future__ import annotations

import re
from collections.abc import Iterable

from plainspoken.planning.policy import NodeId, PolicyNode
from plainspoken.questions.claim import ActionClaim, Claim, Draft
from plainspoken.questions.foresight import Foresight
from plainspoken.questions.future import fork_words, tell_after
from plainspoken.questions.lexicon import split_name
from plainspoken.questions.moment import Happening, Moment
from plainspoken.questions.morphology import counted, listed
from plainspoken.questions.narration import ago, future_deeds, present_deed
from plainspoken.questions.question import Question
from plainspoken.questions.spelling import normal
from plainspoken.world.domain import GroundAtom
from plainspoken.world.event import Instant, ObservationMade, ReportReceived
from plainspoken.world.scene import is_applicable, successors


def _denies(question: Question) -> bool:
    """Whether it is asked of a fact that it is not so."""
    return re.search(r"\b(?:not|never|no longer|no more)\b", normal(question.text)) is not None


def _meant(question: Question) -> list[GroundAtom]:
    """The facts of the predicate that the words fit best.

    "Not clean" is read as what is denied, clean, and not as unclean, which may be but a part of it.
    """
    found = question.referents.atoms
    plain = normal(question.text)
    said = [atom for atom in found if set(split_name(atom.split()[0])) & set(plain.split())]
    best = ((_denies(question) and said) or found)[0].split()[0]
    return [atom for atom in found if atom.split()[0] == best]


# -- why so ------------------------------------------------------------------------------------


def tell_cause(draft: Draft, question: Question) -> bool:
    """Answer what made a fact as it is; False where no fact is spoken of."""
    moment = draft.moment
    if not question.referents.atoms:
        return False
    atoms = _meant(question)
    atom = next((each for each in atoms if each in moment.runs), atoms[0])
    clause = moment.lexicon.clause(atom)
    if atom in moment.static:
        return False
    runs = moment.runs.get(atom)
    if not runs:
        draft.now([atom])
        draft.say(f"{clause.never()}{_still_to_come(draft, atom)}")
        return True
    start, end = runs[-1]
    draft.was(atom, start)
    if end < moment.now and _denies(question):
        _say_cause(draft, end + 1, atom, f"{clause.said(negative=True)} any more")
        return True
    tense = clause.said() if end == moment.now else clause.said("was")
    opening = tense if end == moment.now else f"{tense} until {ago(moment.now - end)}"
    if start == 0:
        draft.say(f"{opening}: it was so from the start{_still_to_end(draft, atom)}")
    else:
        _say_cause(draft, start, atom, opening)
    return True


def _say_cause(draft: Draft, at: Instant, atom: GroundAtom, opening: str) -> None:
    """`The box is full: it came of dropping mug 0 in it two actions ago`."""
    moment = draft.moment
    when = ago(moment.now - at)
    happening = next((each for each in moment.happenings if each.at == at), None)
    if happening is not None:
        draft.did(happening)
        chance = "; whether it does is up to chance" if _by_chance(moment, happening, atom) else ""
        deed = moment.lexicon.deed(happening.action)
        whose = deed.doing if deed.subject == "I" else f"{deed.subject} {deed.doing}"
        draft.say(f"{opening}: it came of {whose} {when}{chance}")
        return
    event = next((e.event for e in moment.entries if e.step == moment.steps[at]), None)
    known = "I was told so" if isinstance(event, ReportReceived) else "I found it so"
    if not isinstance(event, ReportReceived | ObservationMade):
        known = "I found it so after an action that failed"
    draft.evidence.add(moment.steps[at])
    draft.say(f"{opening}, and I don't know why; {known} {when}")


def _by_chance(moment: Moment, happening: Happening, atom: GroundAtom) -> bool:
    """Whether the action could also have left the fact otherwise."""
    before = moment.whole(moment.states[happening.at - 1])
    if not is_applicable(moment.problem, before, happening.action):
        return False
    outcomes = successors(moment.problem, before, happening.action)
    return len({atom in outcome for outcome in outcomes}) > 1


def _still_to_come(draft: Draft, atom: GroundAtom) -> str:
    """Where the plan brings the fact about, if it is sure to."""
    moment = draft.moment
    if moment.node is None or moment.policy is None:
        return ""
    ahead = Foresight(moment.policy, moment.node, moment.now)
    path = ahead.path_to({id for id in ahead.reachable if atom in moment.policy.node(id).state})
    if path is None or atom not in ahead.finally_true:
        return ""
    draft.node(path[-1].id)
    at = moment.now + len(path) - 1
    draft.claims.add(Claim(atom, at, at, "may"))
    return f"; that comes in {counted(len(path) - 1, 'action')} at the earliest"


def _still_to_end(draft: Draft, atom: GroundAtom) -> str:
    """That nothing has been done about a fact so far, where it is so still."""
    return ", and nothing has changed it so far" if atom in draft.moment.state else ""


# -- what if -----------------------------------------------------------------------------------


def tell_what_if(draft: Draft, question: Question) -> bool:
    """Answer what is done where a fact comes about; False where none is spoken of or foreseen."""
    moment = draft.moment
    asked = question.referents
    if moment.node is None or moment.policy is None:
        return False
    ahead = Foresight(moment.policy, moment.node, moment.now)
    draft.node(moment.node.id)
    if not asked.atoms:
        return (bool(asked.actions) and tell_after(draft, ahead, question)) or _tell_outcomes(
            draft, ahead, question
        )
    atoms = _meant(question)
    if _denies(question):
        return _tell_if_not(draft, ahead, atoms[0])
    entered = {id for id in ahead.reachable if set(atoms) & ahead.policy.node(id).state}
    if set(atoms) & moment.state:
        _tell_so_already(draft, next(a for a in atoms if a in moment.state), negative=False)
        return True
    path = ahead.path_to(entered)
    clause = moment.lexicon.clause(atoms[0])
    if path is None:
        draft.say(f"As things stand, {clause.said('will', negative=True)} in this mission")
        return True
    atom = next(each for each in atoms if each in path[-1].state)
    at = moment.now + len(path) - 1
    draft.claims.add(Claim(atom, at, at, "may"))
    _say_then(draft, ahead, path, entered)
    return True


def _say_then(
    draft: Draft, ahead: Foresight, path: tuple[PolicyNode, ...], entered: Iterable[NodeId]
) -> None:
    """When it can come about first, and what is done then."""
    distance = len(path) - 1
    nearest = [id for id in entered if ahead.reachable[id] == distance]
    actions = {ahead.policy.node(id).action for id in nearest}
    draft.node(path[-1].id)
    lexicon = draft.moment.lexicon
    then = []
    for action in sorted(each for each in actions if each is not None):
        draft.actions.add(ActionClaim(action, ahead.now + distance + 1, "may"))
        then.append(future_deeds([lexicon.deed(action)]))
    first = f"That can be in {counted(distance, 'action')} at the earliest"
    chance = "depending on how things stand, " if len(then) > 1 else ""
    draft.say(f"{first}; then {chance}{listed(then, 'or')}" if then else f"{first}; then I'm done")


def _tell_so_already(draft: Draft, atom: GroundAtom, *, negative: bool) -> None:
    moment = draft.moment
    draft.now([atom])
    words = f"It's so already: {moment.lexicon.clause(atom).said(negative=negative)}"
    if moment.node is not None and moment.node.action is not None:
        deed = moment.lexicon.deed(moment.node.action)
        going = moment.started is not None
        draft.actions.add(
            ActionClaim(moment.node.action, moment.now + 1, "may" if going else "will")
        )
        words += f", and {present_deed(deed) if going else future_deeds([deed], 'next')}"
    draft.say(words)


def _tell_if_not(draft: Draft, ahead: Foresight, atom: GroundAtom) -> bool:
    """What is done where a fact stays away or ends."""
    moment = draft.moment
    nodes = [ahead.policy.node(id) for id in ahead.reachable]
    deciding = [
        node
        for node in nodes
        if atom not in node.state
        and len({atom in ahead.policy.node(id).state for id in node.successors}) == 2
    ]
    if deciding and atom not in moment.state:
        path = ahead.path_to({deciding[0].id})
        node = deciding[0]
        words = fork_words(draft, ahead, node, len(path or ()) - 1, without=atom)
        if path is not None and words and node.action is not None:
            draft.actions.add(ActionClaim(node.action, ahead.now + len(path), "may"))
            when = "Next" if len(path) == 1 else f"In {counted(len(path) - 1, 'action')}"
            least = "" if len(path) == 1 else " at the earliest"
            deed = moment.lexicon.deed(node.action)
            draft.say(f"{when}{least} {future_deeds([deed])}; {words}")
            return True
    if atom not in moment.state:
        _tell_so_already(draft, atom, negative=True)
        return True
    without = {node.id for node in nodes if atom not in node.state}
    path = ahead.path_to(without)
    draft.now([atom])
    if path is None:
        draft.say(
            f"As things stand, that can't be: {moment.lexicon.clause(atom).said()} to the end"
        )
    else:
        _say_then(draft, ahead, path, without)
    return True


def _tell_outcomes(draft: Draft, ahead: Foresight, question: Question) -> bool:
    """What may come of the next action that involves the things named."""
    asked = question.referents
    if not asked.objects:
        return False
    nodes = {
        id
        for id in ahead.reachable
        if len(ahead.policy.node(id).successors) > 1
        and set(asked.objects) <= set(str(ahead.policy.node(id).action).split()[1:])
    }
    path = ahead.path_to(nodes)
    if path is None:
        return False
    action = str(path[-1].action)
    words = fork_words(draft, ahead, path[-1], len(path) - 1)
    draft.actions.add(ActionClaim(action, ahead.now + len(path), "may"))
    draft.say(f"After {draft.moment.lexicon.deed(action).doing}, {words.removeprefix('then ')}")
    return True
