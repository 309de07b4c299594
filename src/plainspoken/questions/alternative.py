"""What is not, or might be: why not another action, why a fact came about, what if one did.

An obstacle that is named is real: with it turned round, the action would be applicable, or the
part of the request unbroken. Where no such single obstacle is found, nothing is claimed.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from plainspoken.automata.verdict import Part, Verdict
from plainspoken.questions.claim import ActionClaim, Draft
from plainspoken.questions.foresight import Foresight
from plainspoken.questions.moment import Moment
from plainspoken.questions.morphology import listed
from plainspoken.questions.narration import ago, facts_together
from plainspoken.questions.question import Question, question_of
from plainspoken.questions.reason import tell_why
from plainspoken.questions.wish import wanted, wish_of
from plainspoken.world.domain import (
    AllOf,
    AnyOf,
    AtomCondition,
    Condition,
    Exists,
    ForAll,
    GroundAction,
    GroundAtom,
    NotCondition,
    Problem,
    State,
    ground,
)
from plainspoken.world.scene import Binding, instances, is_applicable, satisfies, successors

_CONTRAST = re.compile(r" (?:instead of|rather than|and not|but not) .*", re.IGNORECASE)
MOST_TRIED = 400
"""Ground actions that a question may mean, at most."""


# -- why not -----------------------------------------------------------------------------------


def tell_why_not(draft: Draft, question: Question) -> bool:
    """Answer why an action is not done now; False where there is no sure answer."""
    moment = draft.moment
    if not question.referents.actions:
        return False
    if _CONTRAST.search(question.text):
        # What was done rather than something else is best told by what it was for.
        chosen = question_of(_CONTRAST.sub("", question.text), moment.lexicon)
        tell_why(draft, chosen)
        return True
    if moment.ended is not None:
        return _tell_not_needed(draft, question)
    meant = list(_meant(moment, question))
    if not meant:
        return False
    doing = moment.started.action if moment.started else None
    if doing in meant:
        draft.actions.add(ActionClaim(str(doing), moment.now + 1, "may"))
        draft.evidence.add(moment.started_step)
        draft.say(f"I am {moment.lexicon.deed(str(doing)).doing} right now")
        return True
    whole = moment.whole(moment.believed)
    possible = [action for action in meant if is_applicable(moment.problem, whole, action)]
    draft.evidence.add(moment.steps[-1])
    if not possible:
        return _tell_obstacle(draft, meant)
    return _tell_broken(draft, possible[0]) or _tell_later(draft, possible)


def _tell_not_needed(draft: Draft, question: Question) -> bool:
    """Why something was not done in a mission that is over."""
    moment = draft.moment
    asked = question.referents
    done = [each for each in moment.happenings if asked.concerns(each.action)]
    draft.evidence.add(moment.entries[-1].step)
    if done:
        draft.did(done[-1])
        deed = moment.lexicon.deed(done[-1].action)
        draft.say(f"But {deed.subject} {deed.did}, {ago(moment.now - done[-1].at)}")
    elif moment.ended is not None and moment.ended.satisfied:
        draft.say("It wasn't needed: what you asked for is done without it")
    else:
        draft.say("The mission was over before that")
    return True


def _meant(moment: Moment, question: Question) -> Iterator[GroundAction]:
    """The ground actions that a question may mean."""
    tried = 0
    for name in question.referents.actions:
        for schema in moment.problem.action(name):
            for binding in moment.problem.bindings(schema.parameters):
                tried += 1
                if tried > MOST_TRIED:
                    return
                action = " ".join([name, *binding.values()])
                if question.referents.concerns(action):
                    yield action


def _tell_obstacle(draft: Draft, meant: list[GroundAction]) -> bool:
    """Name the conditions that keep the action from being done: the fewest over its instances."""
    moment = draft.moment
    found: list[tuple[int, GroundAction, tuple[tuple[GroundAtom, bool], ...]]] = []
    for action in meant:
        missing = _obstacles(moment, action)
        if missing:
            found.append((len(missing), action, missing))
    if not found:
        return False
    known = _ever(moment)
    # A condition that no plan and no past has met points to another instance of the action.
    sensible = [each for each in found if all(a in known or not w for a, w in each[2])]
    _, action, missing = min(sensible or found)
    draft.now(atom for atom, _ in missing)
    lacking = [atom for atom, wanted_true in missing if wanted_true]
    hindering = [atom for atom, wanted_true in missing if not wanted_true]
    said = [s.text for s in facts_together(moment.lexicon, lacking, negative=True)]
    said += [s.text for s in facts_together(moment.lexicon, hindering)]
    deed = moment.lexicon.deed(action)
    draft.say(f"I can't {deed.bare} now because {listed(said)}")
    then = _turned(moment.whole(moment.believed), missing)
    broken = _broken_part(moment, then, action)
    if broken is not None:
        draft.evidence.add(moment.entries[0].step)
        want = wanted(wish_of(moment.demand_of(broken).said, moment.lexicon), moment.lexicon)
        draft.say(f"Besides, you want {want}")
    return True


def _ever(moment: Moment) -> frozenset[GroundAtom]:
    """The facts that have been so, or may come to be so by the plan."""
    ahead: set[GroundAtom] = set(moment.runs)
    if moment.node is not None and moment.policy is not None:
        for id in Foresight(moment.policy, moment.node, moment.now).reachable:
            ahead |= moment.policy.node(id).state
    return frozenset(ahead)


def _obstacles(moment: Moment, action: GroundAction) -> tuple[tuple[GroundAtom, bool], ...]:
    """The facts to turn round, all of them, for the action to be applicable; none if not enough.

    An atom and whether it would have to become true.
    """
    whole = moment.whole(moment.believed)
    for schema, binding in instances(moment.problem, action):
        turned: list[tuple[GroundAtom, bool]] = []
        changed = whole
        atoms = dict.fromkeys(_atoms_of(schema.precondition, binding, moment.problem))
        for atom in filter(moment.changes, atoms):
            flipped = changed - {atom} if atom in changed else changed | {atom}
            if _met(moment, flipped, action) > _met(moment, changed, action):
                turned.append((atom, atom not in whole))
                changed = flipped
        if turned and is_applicable(moment.problem, changed, action):
            return _needed_only(moment, action, turned)
    return ()


def _met(moment: Moment, state: State, action: GroundAction) -> int:
    """How many of the conditions that the action needs hold in a state."""
    for schema, binding in instances(moment.problem, action):
        condition = schema.precondition
        parts = condition.conditions if isinstance(condition, AllOf) else (condition,)
        return sum(satisfies(state, part, moment.problem, binding) for part in parts)
    return 0


def _needed_only(
    moment: Moment, action: GroundAction, turned: list[tuple[GroundAtom, bool]]
) -> tuple[tuple[GroundAtom, bool], ...]:
    """Without the flips that the action could do without."""
    whole = moment.whole(moment.believed)
    kept = list(turned)
    for each in turned:
        rest = [other for other in kept if other != each]
        if is_applicable(moment.problem, _turned(whole, rest), action):
            kept = rest
    return tuple(kept)


def _turned(state: State, changes: Iterable[tuple[GroundAtom, bool]]) -> State:
    """A state with some facts turned round."""
    for atom, wanted_true in changes:
        state = state | {atom} if wanted_true else state - {atom}
    return state


def _atoms_of(condition: Condition, binding: Binding, problem: Problem) -> Iterator[GroundAtom]:
    """The ground atoms that a condition reads."""
    match condition:
        case AtomCondition():
            yield ground(condition, binding)
        case AllOf(parts) | AnyOf(parts):
            for part in parts:
                yield from _atoms_of(part, binding, problem)
        case NotCondition(part):
            yield from _atoms_of(part, binding, problem)
        case ForAll(parameters, part) | Exists(parameters, part):
            for more in problem.bindings(parameters):
                yield from _atoms_of(part, {**binding, **more}, problem)
        case _:
            return


def _broken_part(moment: Moment, state: State, action: GroundAction) -> Part | None:
    """A part of the request that the action could break if done in a state."""
    for after in successors(moment.problem, state, action):
        later = moment.after(moment.parts, after - moment.static, action)
        for before, part in zip(moment.parts, later, strict=True):
            if part.verdict is Verdict.VIOLATED and before.verdict is not Verdict.VIOLATED:
                return before
    return None


def _tell_broken(draft: Draft, action: GroundAction) -> bool:
    """Say which part of the request the action could break, if it could."""
    moment = draft.moment
    part = _broken_part(moment, moment.whole(moment.believed), action)
    if part is None:
        return False
    want = wanted(wish_of(moment.demand_of(part).said, moment.lexicon), moment.lexicon)
    draft.evidence.add(moment.entries[0].step)
    draft.say(f"I could {moment.lexicon.deed(action).bare}, but you want {want}")
    return True


def _tell_later(draft: Draft, possible: list[GroundAction]) -> bool:
    """Say that the action could be done, and where the plan has it, if anywhere."""
    moment = draft.moment
    if moment.node is None or moment.policy is None or moment.node.action is None:
        return False
    ahead = Foresight(moment.policy, moment.node, moment.now)
    chosen = moment.lexicon.deed(moment.node.action)
    deed = moment.lexicon.deed(possible[0])
    draft.node(moment.node.id)
    draft.actions.add(
        ActionClaim(moment.node.action, moment.now + 1, "may" if moment.started else "will")
    )
    planned = {ahead.policy.node(id).action for id in ahead.reachable} & set(possible)
    doing = f"I'm {chosen.doing}" if moment.started else f"I'll {chosen.bare}"
    if planned & set(ahead.unavoidable):
        draft.say(f"I could {deed.bare} now, but first {doing}; I'll do it later")
    elif planned:
        draft.say(f"I could {deed.bare} now, but first {doing}; I may do it later")
    else:
        draft.say(
            f"I could {deed.bare} now, but my plan gets what you asked for done without it; {doing}"
            + ("" if moment.started else " next")
        )
    return True
