"""What comes: the sure, the conditional and the possible, told apart."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Sequence
from functools import partial

from plainspoken.planning.policy import PolicyNode
from plainspoken.questions.claim import ActionClaim, Claim, Draft
from plainspoken.questions.foresight import Foresight
from plainspoken.questions.length import Length
from plainspoken.questions.morphology import counted, listed
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
from plainspoken.questions.present import ranked
from plainspoken.questions.prospect import tell_whether_will
from plainspoken.questions.question import Question, Span
from plainspoken.questions.reason import open_atoms
from plainspoken.questions.standing import say_facts, say_only
from plainspoken.world.domain import GroundAction, GroundAtom
from plainspoken.world.event import Instant
from plainspoken.world.symbol import flat

MOST_STEPS = 3
"""Sure actions that a brief answer tells one by one."""
ROOM_FOR_REST = 14
"""Words kept for what stays as it is."""
ROOM_FOR_JOINTS = 6
"""Words that join what is told further: whatever happens, I'll also, and, meanwhile."""
ROOM_FOR_LOOP = 15
"""Words left that there must be for saying what is tried until it works."""


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


def tell_future(draft: Draft, question: Question) -> None:
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
    if re.search(r"\b(?:last|final|very end|in the end|finally)\b", question.text.lower()):
        _tell_end(draft, ahead)
        return
    most = {Length.BRIEF: MOST_STEPS, Length.NORMAL: 2 * MOST_STEPS}.get(draft.length, 12)
    told = _tell_sure(draft, ahead, most, started=started is not None)
    told |= _tell_further(draft, ahead, told)
    if not draft.full:
        _tell_rest(draft, ahead, told)
    else:
        _tell_best(draft, ahead)
        _tell_facts(draft, ahead)


def _tell_sure(draft: Draft, ahead: Foresight, most: int, *, started: bool) -> set[GroundAction]:
    """The next actions as far as they are sure, and the first fork; also which were told."""
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
        return set(actions)
    text = (
        present_deed(deeds[0])
        if len(deeds) == len(actions)
        else present_deed(lexicon.deed(actions[0]))
    )
    if len(actions) > 1:
        rest = joined_runs([lexicon.deed(action) for action in actions[1:]])
        text += "; then " + future_deeds(referring(rest, deeds[0]))
    draft.say("; ".join(filter(None, (text, fork))))
    return set(actions)


def claim_sure(draft: Draft, ahead: Foresight, told: Collection[GroundAction]) -> None:
    """Claim the actions told whose instants are sure, and what they surely bring and end."""
    for index, action in enumerate(ahead.sure_actions):
        if action not in told:
            continue
        draft.actions.add(ActionClaim(action, ahead.now + index + 1, "will"))
        before, after = (
            ahead.sure[index],
            ahead.sure[index + 1] if index + 1 < len(ahead.sure) else frozenset(),
        )
        for atom in after - before:
            _claim_sure_run(draft, ahead, atom, index + 1)
        for atom in before - after:
            _claim_sure_run(draft, ahead, atom, index)


def _claim_sure_run(draft: Draft, ahead: Foresight, atom: GroundAtom, around: int) -> None:
    """Claim an atom over all instants around one at which it is sure; now is for the log to say."""
    if around == 0:
        if atom in draft.moment.state:
            draft.now([atom])
        return
    start = around
    while start > 1 and atom in ahead.sure[start - 1]:
        start -= 1
    run = ahead.sure_run(atom, start)
    if run is not None:
        draft.claims.add(Claim(atom, *run, "will"))
        if start == 1 and atom in draft.moment.state:
            draft.now([atom])


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
        marks = _telling(draft, sorted(outcome.state - others))
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
        said = [about_it(s.text, acted) for s in facts_together(lexicon, marks)]
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
    draft: Draft, ahead: Foresight, told: Collection[GroundAction]
) -> set[GroundAction]:
    """What every execution does later on, as far as there is room, or how it ends."""
    moment = draft.moment
    lexicon = moment.lexicon
    later = sorted(
        (action for action in ahead.unavoidable if action not in told),
        key=lambda action: (is_motion(moment, action), natural(action)),
    )
    later = [*dict.fromkeys(_in_order(ahead, later))]
    shown = _fitting_kinds(draft, ahead, later)
    groups = deeds_together(lexicon, shown)
    claim_sure(draft, ahead, shown)
    sure = len(ahead.sure_actions) == len(ahead.reachable) - 1
    if groups:
        opening = "Later" if sure else "Whatever happens,"
        text = future_deeds(referring([deed for deed, _ in groups]), opening)
        if told and not sure:
            text = re.sub(r"(?<=happens, I'll)", " also", text)
        draft.say(text)
    elif draft.room > 2 * ROOM_FOR_REST:
        goals = [atom for atom in open_atoms(moment.parts, moment) if atom in ahead.finally_true]
        say_facts(draft, goals, lambda atoms: _claim_end(draft, ahead, atoms), "will", "In the end")
    if draft.room > ROOM_FOR_LOOP:
        _tell_loop(draft, ahead, told)
    return set(shown)


def _in_order(ahead: Foresight, actions: Sequence[GroundAction]) -> list[GroundAction]:
    """Actions by their names, the name that comes first before the others."""
    names = [action.split()[0] for action in ahead.unavoidable]
    return sorted(actions, key=lambda action: (names.index(action.split()[0]), natural(action)))


def _fitting_kinds(
    draft: Draft, ahead: Foresight, actions: Sequence[GroundAction]
) -> list[GroundAction]:
    """The actions whose kinds there is room to tell, those that tell most in few words first.

    They share the room with what stays as it is.
    """
    lexicon = draft.moment.lexicon
    rivals: list[tuple[int, str, _Told]] = []
    for name in dict.fromkeys(action.split()[0] for action in actions):
        own = [action for action in actions if action.split()[0] == name]
        deeds = [deed for deed, _ in deeds_together(lexicon, own)]
        words = max(len(future_deeds(deeds).split()) - 1, 1)  # "I'll" is said once for all.
        rivals.append((words, name, _told(draft, partial(claim_sure, ahead=ahead, told=own))))
    staying = [atom for atom in ahead.kept if draft.moment.changes(atom)]
    for saying in facts_together(lexicon, staying, "stays"):
        told = _told(draft, partial(_claim_kept, ahead=ahead, atoms=saying.atoms))
        rivals.append((len(saying.text.split()), "", told))
    room = draft.room - ROOM_FOR_JOINTS
    known: _Told = set()
    chosen: set[str] = set()
    while fitting := [each for each in rivals if each[0] <= room]:
        best = max(fitting, key=lambda each: (len(each[2] - known) + 1) / each[0])
        rivals.remove(best)
        room -= best[0]
        known |= best[2]
        chosen.add(best[1])
    return [action for action in actions if action.split()[0] in chosen]


_Told = set[tuple[GroundAtom, Instant]]
"""Facts, each with an instant that it is claimed for."""


def _told(draft: Draft, claim: Callable[[Draft], None]) -> _Told:
    """What a claim would tell that has not been told."""
    trial = Draft(draft.moment, draft.length)
    claim(trial)
    found = {(c.fluent, i) for c in trial.claims for i in range(c.start, c.end + 1)}
    now = draft.moment.now
    known = {(c.fluent, i) for c in draft.claims for i in range(c.start, c.end + 1)}
    return {each for each in found - known if each[1] >= now}


def _claim_end(draft: Draft, ahead: Foresight, atoms: Sequence[GroundAtom]) -> None:
    """Claim what is so at the end, where it is sure when that is."""
    last = ahead.layers[-1]
    if all(node.action is None for node in last) and len(ahead.layers) > 1:
        for atom in atoms:
            _claim_sure_run(draft, ahead, atom, len(ahead.layers) - 1)


def _tell_rest(draft: Draft, ahead: Foresight, told: Collection[GroundAction]) -> None:
    """What stays as it is to the end, come what may; or that all else does."""
    moment = draft.moment
    nodes = [ahead.policy.node(id) for id in ahead.reachable]
    kept = ahead.kept
    staying = [atom for atom in ranked(draft, kept) if moment.changes(atom)]
    if {node.action for node in nodes} - {None} <= set(told):
        _claim_kept(draft, ahead, staying)
        draft.say("Everything else stays as it is")
        draft.rest = True
        return
    changing = frozenset().union(*(node.state for node in nodes)) - kept

    def claim(atoms: Sequence[GroundAtom]) -> None:
        _claim_kept(draft, ahead, atoms)

    if not say_only(draft, changing, staying, claim, "will change", others="stays"):
        say_facts(draft, staying, claim, "stays", "Meanwhile")


def _claim_kept(draft: Draft, ahead: Foresight, atoms: Sequence[GroundAtom]) -> None:
    draft.now(atoms)
    for atom in atoms:
        _claim_sure_run(draft, ahead, atom, 1)


def _tell_loop(draft: Draft, ahead: Foresight, told: Collection[GroundAction]) -> None:
    """Say of the nearest action that may change nothing that it is done until it works."""
    nodes = [ahead.policy.node(id) for id in ahead.reachable]
    again = next((node.action for node in nodes if node.action and ahead.repeats(node)), None)
    if again is None or again in told:
        return
    deed = draft.moment.lexicon.deed(again)
    need = "" if again in ahead.unavoidable else "if need be, "
    draft.say(f"{need}{future_deeds([deed])} as often as it takes")


def _tell_best(draft: Draft, ahead: Foresight) -> None:
    """One way on to the end, the shortest, where chance has a say in it."""
    path = ahead.shortest(ahead.node)
    actions = [node.action for node in path if node.action is not None]
    if len(ahead.sure_actions) >= len(actions):
        return
    claim_path(draft, ahead, path)
    deeds = referring(joined_runs([draft.moment.lexicon.deed(action) for action in actions]))
    number = counted(len(actions), "action")
    draft.say(future_deeds(deeds, f"With luck I'm done in {number}:"))


def _tell_facts(draft: Draft, ahead: Foresight) -> None:
    """How things are now, and what is sure of each instant to come that has not been said of it."""
    moment = draft.moment
    say_facts(draft, sorted(moment.fluents), draft.now, opening="Now")
    for distance in range(1, len(ahead.sure)):
        at = ahead.now + distance
        said = {c.fluent for c in draft.claims if c.start <= at <= c.end and c.certainty != "may"}
        left = sorted(atom for atom in ahead.sure[distance] - said if moment.changes(atom))

        def claim(atoms: Sequence[GroundAtom], distance: int = distance) -> None:
            for atom in atoms:
                _claim_sure_run(draft, ahead, atom, distance)

        opening = "After the next action" if distance == 1 else f"After {distance} actions"
        say_facts(draft, left, claim, "will", opening)
    final = sorted(atom for atom in ahead.finally_true if moment.changes(atom))
    say_facts(draft, final, lambda atoms: _claim_end(draft, ahead, atoms), "will", "When I'm done,")


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
    draft.say(f"The last thing I'll do is {listed(words[:4], 'or')}{chance}")


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
