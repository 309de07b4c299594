"""What comes: the sure, the conditional and the possible, told apart."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

from plainspoken.planning.policy import PolicyNode
from plainspoken.questions.claim import ActionClaim, Claim, Draft
from plainspoken.questions.foresight import Foresight
from plainspoken.questions.morphology import listed
from plainspoken.questions.narration import (
    about_it,
    deeds_together,
    facts_together,
    future_deeds,
    joined_runs,
    natural,
    present_deed,
    referring,
)
from plainspoken.questions.past import is_motion
from plainspoken.questions.prospect import tell_whether_will
from plainspoken.questions.question import Question, Span
from plainspoken.questions.reason import open_atoms
from plainspoken.world.domain import GroundAction, GroundAtom
from plainspoken.world.symbol import flat

MOST_STEPS = 3
"""Sure actions that a brief answer tells one by one."""
ROOM = 28
"""Words after which a brief answer adds no further sentence."""
MOST_FURTHER = 3
"""Kinds of further deeds that a brief answer names."""


def foresight_of(draft: Draft) -> Foresight | None:
    """What the policy allows from now on; None, and a sentence, where nothing can be foreseen."""
    moment = draft.moment
    if moment.ended is not None:
        draft.evidence.add(moment.entries[-1].step)
        draft.say("Nothing more: the mission is over")
        return None
    if moment.node is None or moment.policy is None:
        draft.known = False
        draft.evidence.add(moment.entries[-1].step)
        draft.say(
            "I don't know yet: things are not as I expected, and I have no new plan so far"
            if moment.chosen
            else "I don't know yet: I'm still making a plan"
        )
        return None
    return Foresight(moment.policy, moment.node, moment.now)


def words_so_far(draft: Draft) -> int:
    """How long an answer in the making is."""
    return sum(len(each.split()) for each in draft.sentences)


def tell_future(draft: Draft, question: Question, *, full: bool) -> None:
    """Answer what will be done."""
    ahead = foresight_of(draft)
    if ahead is None:
        return
    draft.node(ahead.node.id)
    asked = question.referents
    if question.yes_no and (asked.actions or asked.atoms):
        tell_whether_will(draft, ahead, question)
        return
    if (
        question.span is Span.AFTER
        and (asked.actions or asked.objects)
        and tell_after(draft, ahead, question)
    ):
        return
    started = draft.moment.started
    if ahead.node.action is None:
        draft.say("Nothing more: I've done what you asked")
        return
    _claim_ahead(draft, ahead)
    if re.search(r"\b(?:last|final|very end|in the end|finally)\b", question.text.lower()):
        _tell_end(draft, ahead)
        return
    told = _tell_sure(draft, ahead, 12 if full else MOST_STEPS, started=started is not None)
    if full or (question.span is not Span.LAST and words_so_far(draft) < ROOM):
        _tell_further(draft, ahead, told, full=full)
    if full:
        _tell_facts(draft, ahead)


def _tell_sure(draft: Draft, ahead: Foresight, most: int, *, started: bool) -> list[GroundAction]:
    """The next actions as far as they are sure, and the first fork."""
    lexicon = draft.moment.lexicon
    actions = list(ahead.sure_actions[:most])
    claim_sure(draft, ahead, actions)
    # A fork is told where it is reached by one way only; else the words would need a fork before.
    last = len(actions) - 1
    forks = last + 1 == len(ahead.sure_actions) and len(ahead.layers[last]) == 1
    fork = fork_words(draft, ahead, ahead.layers[last][0], last) if forks else ""
    deeds = joined_runs([lexicon.deed(action) for action in actions])
    if not started:
        draft.say("; ".join(filter(None, (future_deeds(referring(deeds), "Next"), fork))))
        return actions
    text = (
        present_deed(deeds[0])
        if len(deeds) == len(actions)
        else present_deed(lexicon.deed(actions[0]))
    )
    if len(actions) > 1:
        rest = joined_runs([lexicon.deed(action) for action in actions[1:]])
        text += "; then " + future_deeds(referring(rest, deeds[0]))
    draft.say("; ".join(filter(None, (text, fork))))
    return actions


def claim_sure(draft: Draft, ahead: Foresight, told: Collection[GroundAction]) -> None:
    """Claim the actions told whose instants are sure, and what is sure of what they touch."""
    for index, action in enumerate(ahead.sure_actions):
        if action not in told:
            continue
        draft.actions.add(ActionClaim(action, ahead.now + index + 1, "will"))
        before, after = (
            ahead.sure[index],
            ahead.sure[index + 1] if index + 1 < len(ahead.sure) else frozenset(),
        )
        arguments = set(action.split()[1:])
        for atom in before | after:
            if set(atom.split()[1:]) <= arguments:
                for start in (max(index, 1), index + 1):
                    run = ahead.sure_run(atom, start)
                    if run is not None:
                        draft.claims.add(Claim(atom, *run, "will"))


def fork_words(
    draft: Draft,
    ahead: Foresight,
    node: PolicyNode,
    distance: int,
    without: GroundAtom | None = None,
) -> str:
    """What the outcomes of a node's action lead to: `if mug 2 is clean, I'll pick it; ...`.

    without: tell only the outcomes in which this atom is not so
    """
    if len(node.successors) < 2:
        return ""
    lexicon = draft.moment.lexicon
    everything = [ahead.policy.node(id) for id in node.successors]
    outcomes = [each for each in everything if without is None or without not in each.state]
    draft.node(node.id)
    parts: dict[str, list[str]] = {}
    acted = lexicon.deed(str(node.action))
    at = ahead.now + distance + 1
    for outcome in outcomes:
        others = frozenset().union(*(o.state for o in everything if o is not outcome))
        marks = sorted(outcome.state - others)
        again = outcome.action == node.action and outcome.state == node.state
        if again:
            then = "I'll try again"
        elif outcome.action is None:
            then = "I'm done"
        else:
            then = future_deeds(referring([lexicon.deed(outcome.action)], acted))
        if not again and outcome.action is not None:
            draft.actions.add(ActionClaim(outcome.action, at + 1, "may"))
        for mark in marks:
            draft.claims.add(Claim(mark, at, at, "may"))
        said = [about_it(s.text, acted) for s in facts_together(lexicon, _telling(draft, marks))]
        if again:
            said = []
        elif not said:
            kept = frozenset.intersection(*(o.state for o in everything if o is not outcome))
            lost = sorted((kept & node.state) - outcome.state)
            said = [
                f"{about_it(each.text, acted)} any more"
                for each in facts_together(lexicon, _telling(draft, lost), negative=True)
            ]
        parts.setdefault(then, []).append(listed(said) if said else "")
    if len(parts) == 1:
        then = next(iter(parts))
        return f"then {then} whatever comes of it" if without is None else f"then {then}"
    ordered = sorted(parts.items(), key=lambda each: "" in each[1])
    if sum("" in conditions for _, conditions in ordered) > 1:
        return "what comes then depends on how that turns out"
    words: list[str] = []
    for then, conditions in ordered:
        if "" in conditions:
            words.append(f"otherwise {then}" if words else f"if nothing changes, {then}")
        else:
            words.append(f"if {listed(conditions, 'or')}, {then}")
    return "; ".join(words)


def _telling(draft: Draft, marks: Sequence[GroundAtom]) -> list[GroundAtom]:
    """The marks of an outcome that say most: those with landmarks, else all."""
    known = [mark for mark in marks if flat(mark) in draft.moment.lexicon.landmarks]
    return (known or list(marks))[:2]


def _tell_further(
    draft: Draft, ahead: Foresight, told: Sequence[GroundAction], *, full: bool
) -> None:
    """What every execution does later on, and how it ends."""
    moment = draft.moment
    lexicon = moment.lexicon
    later = [action for action in ahead.unavoidable if action not in told]
    names = [action.split()[0] for action in later]
    still = sorted(
        (action for action in later if not is_motion(moment, action)),
        key=lambda action: (names.index(action.split()[0]), natural(action)),
    )
    groups = deeds_together(lexicon, still)[: None if full else MOST_FURTHER]
    shown = set(list(dict.fromkeys(action.split()[0] for action in still))[: len(groups)])
    claim_sure(draft, ahead, {action for action in still if action.split()[0] in shown})
    goals = [atom for atom in open_atoms(moment.parts, moment) if atom in ahead.finally_true]
    text = ""
    if groups:
        text = future_deeds([deed for deed, _ in groups], "Whatever happens,")
        if told:
            text = re.sub(r"(?<=happens, I'll)", " also", text)
    ends = [saying.text for saying in facts_together(lexicon, goals, "will")]
    if ends and not groups:
        text = f"In the end {listed(ends)}"
    draft.say(text)
    if full or words_so_far(draft) < ROOM:
        _tell_loop(draft, ahead, told)


def _tell_loop(draft: Draft, ahead: Foresight, told: Sequence[GroundAction]) -> None:
    """Say of the nearest action that may change nothing that it is done until it works."""
    nodes = [ahead.policy.node(id) for id in ahead.reachable]
    again = next((node.action for node in nodes if node.action and ahead.repeats(node)), None)
    if again is None or again in told:
        return
    deed = draft.moment.lexicon.deed(again)
    need = "" if again in ahead.unavoidable else "if need be, "
    draft.say(f"{need}{future_deeds([deed])} as often as it takes")


def _claim_ahead(draft: Draft, ahead: Foresight) -> None:
    """Claim every fact that is sure, as long as it is, and one way on to the end as possible."""
    atoms = frozenset().union(*ahead.sure[1:]) if len(ahead.sure) > 1 else frozenset()
    for atom in atoms:
        start = 1
        while start < len(ahead.sure):
            run = ahead.sure_run(atom, start)
            if run is not None:
                draft.claims.add(Claim(atom, *run, "will"))
                start = run[1] - ahead.now
            start += 1
    claim_path(draft, ahead, ahead.shortest(ahead.node))


def _tell_facts(draft: Draft, ahead: Foresight) -> None:
    """What is so after the next action, and in the end."""
    moment = draft.moment
    first = sorted(ahead.sure[1]) if len(ahead.sure) > 1 else []
    if first:
        said = facts_together(moment.lexicon, first, "will", most=12)
        draft.say(f"After the next action, {listed([s.text for s in said])}")
    final = sorted(ahead.finally_true)
    if final:
        said = facts_together(moment.lexicon, final, "will", most=12)
        draft.say(f"When I'm done, {listed([s.text for s in said])}")


def _tell_end(draft: Draft, ahead: Foresight) -> None:
    """What is done last, and what is so then."""
    lexicon = draft.moment.lexicon
    nodes = [ahead.policy.node(id) for id in ahead.reachable]
    last = {
        node.action
        for node in nodes
        if node.action and any(ahead.policy.node(id).action is None for id in node.successors)
    }
    draft.node(ahead.node.id)
    words = [lexicon.deed(action).bare for action in sorted(last, key=natural)]
    chance = ", depending on how things turn out" if len(words) > 1 else ""
    draft.say(f"The last thing I do is to {listed(words[:4], 'or')}{chance}")


def claim_path(draft: Draft, ahead: Foresight, path: Sequence[PolicyNode]) -> None:
    """Claim one execution as possible: every fact and action along it."""
    for distance, node in enumerate(path):
        if node.action is not None and distance + 1 < len(path):
            draft.actions.add(ActionClaim(node.action, ahead.now + distance + 1, "may"))
    open_since: dict[GroundAtom, int] = {}
    for distance, node in enumerate(path[1:], start=1):
        for atom in node.state - path[distance - 1].state if distance > 1 else node.state:
            open_since[atom] = distance
        following = path[distance + 1].state if distance + 1 < len(path) else frozenset()
        for atom in node.state - following:
            start = open_since.pop(atom)
            draft.claims.add(Claim(atom, ahead.now + start, ahead.now + distance, "may"))


def tell_after(draft: Draft, ahead: Foresight, question: Question) -> bool:
    """What comes after an action that is spoken of; False where it is not ahead."""
    asked = question.referents
    nodes = {
        id
        for id in ahead.reachable
        if (action := ahead.policy.node(id).action) and asked.concerns(action)
    }
    path = ahead.path_to(nodes) if nodes and asked.actions else None
    if path is None:
        return False
    node = path[-1]
    outcomes = [ahead.policy.node(id) for id in node.successors]
    lexicon = draft.moment.lexicon
    claim_path(draft, ahead, (*path, outcomes[0]))
    fork = fork_words(draft, ahead, node, len(path) - 1)
    deed = lexicon.deed(str(node.action))
    if fork:
        draft.say(f"After {deed.doing}, {fork.removeprefix('then ')}")
    elif outcomes[0].action is None:
        draft.say(f"After {deed.doing}, I'm done")
    else:
        draft.actions.add(ActionClaim(outcomes[0].action, ahead.now + len(path) + 1, "may"))
        draft.say(future_deeds([lexicon.deed(outcomes[0].action)], f"After {deed.doing},"))
    return True
