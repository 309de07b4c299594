"""Whether, and when, something will be done or be so."""

from __future__ import annotations

import re

from plainspoken.questions.claim import ActionClaim, Claim, Draft
from plainspoken.questions.foresight import Foresight
from plainspoken.questions.morphology import counted
from plainspoken.questions.narration import ago, deeds_together, future_deeds, past_deeds
from plainspoken.questions.question import Question


def tell_whether_will(draft: Draft, ahead: Foresight, question: Question) -> None:
    """Answer whether something will be done, or be so."""
    asked = question.referents
    if asked.actions:
        _whether_action(draft, ahead, question)
        return
    lexicon = draft.moment.lexicon
    for atom in asked.atoms[:4]:
        clause = lexicon.clause(atom)
        nodes = {
            id
            for id in ahead.reachable
            if atom in ahead.policy.node(id).state and id != ahead.node.id
        }
        if atom in ahead.finally_true:
            soon = ahead.path_to(nodes)
            when = f", in {counted(len(soon) - 1, 'action')} at the earliest" if soon else ""
            if soon:
                at = ahead.now + len(soon) - 1
                draft.claims.add(Claim(atom, at, at, "may"))
            yes = "Yes: by" if question.yes_no else "By"
            draft.say(f"{yes} the end {clause.said('will')}{when}")
            if atom in draft.moment.state:
                draft.now([atom])
        elif (path := ahead.path_to(nodes)) is not None:
            distance = len(path) - 1
            draft.claims.add(Claim(atom, ahead.now + distance, ahead.now + distance, "may"))
            draft.say(
                f"Perhaps: {clause.said('may')}, in {counted(distance, 'action')} at the earliest"
            )
        else:
            draft.say(f"No, {clause.said('will', negative=True)} in this mission")


def _whether_action(draft: Draft, ahead: Foresight, question: Question) -> None:
    asked = question.referents
    lexicon = draft.moment.lexicon
    concerned = [
        (distance, action)
        for id, distance in ahead.reachable.items()
        if (action := ahead.policy.node(id).action) and asked.concerns(action)
    ]
    if concerned and re.search(r"\babout to\b", question.text.lower()) and min(concerned)[0]:
        draft.say(f"No, {future_deeds([lexicon.deed(str(ahead.node.action))], 'next')}")
        draft.actions.add(ActionClaim(str(ahead.node.action), ahead.now + 1, "may"))
        return
    if not concerned:
        done = [each for each in draft.moment.happenings if asked.concerns(each.action)]
        if done:
            draft.did_all(done)
            said = past_deeds(deeds_together(lexicon, [each.action for each in done]))
            draft.say(f"Not again: {said} {ago(draft.moment.now - done[-1].at)}")
        else:
            draft.say("No, that's not in my plan")
        return
    sure = [action for action in ahead.unavoidable if asked.concerns(action)]
    least = min(concerned)[0]
    when = (
        "as the next thing"
        if least == 0
        else f"after {counted(least, 'more action')} at the earliest"
    )
    nearest = min(concerned)[1]
    if sure:
        deeds = deeds_together(lexicon, sure)
        yes = "Yes, " if question.yes_no else ""
        draft.say(f"{yes}{future_deeds([deed for deed, _ in deeds])} {when}")
    else:
        deed = lexicon.deed(nearest)
        draft.say(f"Perhaps: it depends on how things turn out; I may {deed.bare} {when}")
    certainty = "will" if ahead.sure_actions[least : least + 1] == (nearest,) else "may"
    draft.actions.add(
        ActionClaim(nearest, ahead.now + least + 1, "will" if certainty == "will" else "may")
    )


def tell_when_ahead(draft: Draft, question: Question) -> bool:
    """Answer when something will be done; False where it is not ahead."""
    moment = draft.moment
    if moment.node is None or moment.policy is None:
        return False
    ahead = Foresight(moment.policy, moment.node, moment.now)
    if question.referents.atoms and not question.referents.actions:
        draft.node(ahead.node.id)
        tell_whether_will(draft, ahead, question)
        return True
    actions = {ahead.policy.node(id).action for id in ahead.reachable}
    if not any(action and question.referents.concerns(action) for action in actions):
        return False
    draft.node(ahead.node.id)
    _whether_action(draft, ahead, question)
    return True
