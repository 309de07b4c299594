"""Why an action is done: the open part of the request it serves, through the links of the policy.

A link is a fact that the action brings about (or ends) and that a later action of the policy
cannot do without. It is found on an execution that the policy allows and checked against the
model: with the fact turned round, the later action is not applicable. The chain ends where an
action brings a part of the request nearer.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from plainspoken.automata.verdict import Part, Verdict
from plainspoken.planning.policy import NodeId, Policy, PolicyNode
from plainspoken.questions.breach import tell_breach
from plainspoken.questions.claim import ActionClaim, Draft
from plainspoken.questions.foresight import Foresight
from plainspoken.questions.moment import Moment
from plainspoken.questions.narration import facts_together, present_deed, referring
from plainspoken.questions.question import Question
from plainspoken.questions.wish import desired, wish_of
from plainspoken.world.domain import GroundAction, GroundAtom
from plainspoken.world.event import Instant
from plainspoken.world.scene import is_applicable
from plainspoken.world.symbol import AtomSymbol

MOST_SEEN = 400
"""Nodes of the policy that are looked at for one link."""
LONGEST = 12
"""Links in one chain."""


@dataclass(frozen=True, slots=True)
class Link:
    """An action, and what the next one of the chain needs of it.

    atom: the fact that it brings about (`made`) or ends; None where it serves the request itself
    node: where the policy does it; at: the instant it would lead to
    """

    action: GroundAction
    node: NodeId
    at: Instant
    atom: GroundAtom | None = None
    made: bool = True


@dataclass(frozen=True, slots=True)
class Reason:
    """The links from an action to a part of the request; the last one has no atom."""

    links: tuple[Link, ...]
    part: Part | None


@dataclass(frozen=True, slots=True)
class _Place:
    node: PolicyNode
    at: Instant
    parts: tuple[Part, ...]


def reason_for(moment: Moment) -> Reason | None:
    """Why the action in flight, or the next one, is done."""
    if moment.node is None or moment.policy is None or moment.node.action is None:
        return None
    place = _Place(moment.node, moment.now, moment.parts)
    return _Search(moment, moment.policy).reason(place)


def reason_then(moment: Moment, node: NodeId, policy_step: int, before: Instant) -> Reason | None:
    """Why an action was chosen at an instant that has passed."""
    policy = moment.policy_at(policy_step)
    if policy is None or node not in policy.by_id:
        return None
    place = _Place(policy.node(node), before, moment.parts_at(before))
    return _Search(moment, policy).reason(place)


class _Search:
    """Looks along one policy for what an action is good for."""

    def __init__(self, moment: Moment, policy: Policy) -> None:
        self._moment = moment
        self._policy = policy
        self._to_stop: dict[NodeId, int] | None = None

    def reason(self, place: _Place) -> Reason | None:
        """The chain from the action of a place to the request, None where none is found."""
        links: list[Link] = []
        for _ in range(LONGEST):
            action = place.node.action
            if action is None:
                break
            served = self._served(place, action)
            if served is not None:
                links.append(Link(action, place.node.id, place.at + 1))
                return Reason(tuple(links), served)
            found = self._next(place, action)
            if found is None:
                break
            link, place = found
            links.append(link)
        return Reason(tuple(links), None) if links else None

    def _outcomes(self, place: _Place, action: GroundAction) -> Iterator[_Place]:
        for id in place.node.successors:
            node = self._policy.node(id)
            yield _Place(node, place.at + 1, self._moment.after(place.parts, node.state, action))

    def _served(self, place: _Place, action: GroundAction) -> Part | None:
        """A part of the request that some outcome of the action brings nearer."""
        letters = self._moment.letters
        seen = letters.read(place.node.state, None)
        for outcome in self._outcomes(place, action):
            gained = letters.read(outcome.node.state, action) - seen
            for before, after in zip(place.parts, outcome.parts, strict=True):
                if before.verdict is not Verdict.OPEN:
                    continue
                if after.verdict in (Verdict.SATISFIED, Verdict.HOLDS_SO_FAR):
                    return before
                path, left = before.closing(), after.closing()
                if path is None or left is None:
                    continue
                if len(left) < len(path) or (path and gained & path[0].positive):
                    return before
        return None

    def _next(self, place: _Place, action: GroundAction) -> tuple[Link, _Place] | None:
        """The nearest later action that cannot do without a change of this one."""
        outcomes = sorted(self._outcomes(place, action), key=lambda each: self._distance(each.node))
        # The outcome that is hoped for gives the reason; the others only where it gives none.
        for hoped in (outcomes[:1], outcomes[1:]):
            found = self._use(place, action, hoped)
            if found is not None:
                return found
        return None

    def _distance(self, node: PolicyNode) -> int:
        """How many actions a stop is away at the least."""
        if self._to_stop is None:
            start = self._policy.node(self._policy.initial)
            self._to_stop = Foresight(self._policy, start, 0).to_stop
        return self._to_stop.get(node.id, 1 << 30)

    def _use(
        self, place: _Place, action: GroundAction, outcomes: Sequence[_Place]
    ) -> tuple[Link, _Place] | None:
        before = place.node.state
        todo: deque[tuple[_Place, frozenset[GroundAtom], frozenset[GroundAtom]]] = deque()
        seen: set[NodeId] = {place.node.id}
        for outcome in outcomes:
            state = outcome.node.state
            todo.append((outcome, state - before, before - state))
        while todo and len(seen) < MOST_SEEN:
            here, made, ended = todo.popleft()
            if here.node.id in seen or not (made or ended):
                continue
            seen.add(here.node.id)
            later = here.node.action
            if later is None:
                continue
            needed = self._needed(here.node, later, made, ended)
            if needed is not None:
                atom, was_made = needed
                link = Link(action, place.node.id, place.at + 1, atom, was_made)
                return link, here
            for outcome in self._outcomes(here, later):
                # Only what lasts from the action to its use is its doing.
                state = outcome.node.state
                todo.append((outcome, made & state, ended - state))
        return None

    def _needed(
        self,
        node: PolicyNode,
        later: GroundAction,
        made: frozenset[GroundAtom],
        ended: frozenset[GroundAtom],
    ) -> tuple[GroundAtom, bool] | None:
        """A change without which the later action would not be applicable."""
        problem = self._moment.problem
        whole = self._moment.whole(node.state)
        for atom in sorted(made):
            if not is_applicable(problem, whole - {atom}, later):
                return atom, True
        for atom in sorted(ended):
            if not is_applicable(problem, whole | {atom}, later):
                return atom, False
        return None


# -- in words ----------------------------------------------------------------------------------


def purpose_words(draft: Draft, reason: Reason) -> str:
    """` so that I can sign off line 1`: the first step of a reason, behind the action."""
    lexicon = draft.moment.lexicon
    goal = further_link(reason)
    if goal is None:
        return ""
    draft.node(goal.node)
    draft.actions.add(ActionClaim(goal.action, goal.at, "may"))
    (deed,) = referring([lexicon.deed(goal.action)], lexicon.deed(reason.links[0].action))
    return f" so that {deed.subject} can {deed.bare}"


def further_link(reason: Reason) -> Link | None:
    """The first later link whose action is of another kind: driving on to drive on is no reason."""
    first = reason.links[0].action.split()[0]
    for link in reason.links[1:]:
        if link.action.split()[0] != first:
            return link
    return None


def tell_why(draft: Draft, question: Question) -> None:
    """Answer why an action is, or was, done."""
    moment = draft.moment
    asked = question.referents
    action = moment.started.action if moment.started else None
    if action is None and moment.node is not None:
        action = moment.node.action
    specific = bool(asked.actions or asked.objects)
    if specific and (action is None or not asked.concerns(action)):
        past = [each for each in moment.happenings if asked.concerns(each.action)]
        if past:
            each = past[-1]
            reason = None
            if each.node is not None:
                reason = reason_then(moment, each.node, each.policy, each.at - 1)
            draft.did(each)
            deed = moment.lexicon.deed(each.action)
            _say_reason(draft, reason, f"{deed.subject} {deed.did}", was=True)
        elif not _tell_planned(draft, question):
            _say_not_doing(draft, question)
        return
    if action is None:
        _say_not_doing(draft, question)
        return
    reason = reason_for(moment)
    deed = moment.lexicon.deed(action)
    if moment.started is not None:
        draft.evidence.add(moment.started_step)
        draft.actions.add(ActionClaim(action, moment.now + 1, "may"))
        _say_reason(draft, reason, present_deed(deed), was=False)
    else:
        draft.actions.add(ActionClaim(action, moment.now + 1, "will"))
        will = "I'll" if deed.subject == "I" else f"{deed.subject} will"
        _say_reason(draft, reason, f"Next {will} {deed.bare}", was=False)


def _tell_planned(draft: Draft, question: Question) -> bool:
    """Why an action is ahead; False where it is not."""
    moment = draft.moment
    if moment.node is None or moment.policy is None:
        return False
    ahead = Foresight(moment.policy, moment.node, moment.now)
    concerned = {
        id
        for id in ahead.reachable
        if (action := moment.policy.node(id).action) and question.referents.concerns(action)
    }
    path = ahead.path_to(concerned) if concerned else None
    if path is None:
        return False
    parts = moment.parts
    for here, after in pairwise(path):
        parts = moment.after(parts, after.state, str(here.action))
    action = str(path[-1].action)
    at = moment.now + len(path) - 1
    reason = _Search(moment, moment.policy).reason(_Place(path[-1], at, parts))
    deed = moment.lexicon.deed(action)
    draft.actions.add(ActionClaim(action, at + 1, "may"))
    helper = "'ll" if deed.subject == "I" else " will"
    if action not in ahead.unavoidable:
        helper = " may"
    _say_reason(draft, reason, f"{deed.subject}{helper} {deed.bare}", was=False, later=True)
    return True


def _say_not_doing(draft: Draft, question: Question) -> None:
    moment = draft.moment
    draft.evidence.add(moment.entries[-1].step)
    asked = question.referents
    if moment.ended is not None and not (asked.actions or asked.objects):
        draft.say("I'm not doing anything any more: the mission is over")
        if moment.ended.outcome == "stopped" and moment.ended.reason:
            draft.say(f"I've stopped because {moment.ended.reason}")
            tell_breach(draft, moment.demands)
    elif question.referents.actions or question.referents.objects:
        draft.known = False
        draft.say("I haven't done that, and it's not in my plan")
    else:
        draft.known = False
        draft.say("I have no plan for what I do next at the moment")


def _say_reason(
    draft: Draft, reason: Reason | None, opening: str, *, was: bool, later: bool = False
) -> None:
    moment = draft.moment
    lexicon = moment.lexicon
    if reason is None:
        draft.known = False
        draft.say(opening)
        draft.say("I can't name one single thing that it is needed for")
        return
    for link in reason.links:
        draft.node(link.node)
    goal = further_link(reason)
    words = ""
    if goal is not None:
        (deed,) = referring([lexicon.deed(goal.action)], lexicon.deed(reason.links[0].action))
        if not was:
            draft.actions.add(ActionClaim(goal.action, goal.at, "may"))
        words = f" so that {deed.subject} {'could' if was else 'can'} {deed.bare}"
    part = ""
    if reason.part is not None:
        part = f"you want {desired(wish_of(moment.demand_of(reason.part).said, lexicon), lexicon)}"
        draft.evidence.add(moment.entries[0].step)
    if words:
        draft.say(f"{opening}{words}{part and f', since {part}'}")
        draft.say("" if was or later else _obstacle(draft, reason))
    else:
        draft.say(f"{opening} because {part}" if part else opening)


def _obstacle(draft: Draft, reason: Reason) -> str:
    """`the box is full`: what stands in the way now and a link of the chain ends."""
    moment = draft.moment
    atoms = [
        link.atom
        for link in reason.links
        if link.atom is not None and not link.made and link.atom in moment.state
    ]
    for atom in atoms:
        blocked = next(
            (
                later.action
                for link, later in zip(reason.links, reason.links[1:], strict=False)
                if link.atom == atom
            ),
            None,
        )
        if blocked is None:
            continue
        draft.now([atom])
        (saying,) = facts_together(moment.lexicon, [atom])
        return f"{saying.text}, and until that changes I can't {moment.lexicon.deed(blocked).bare}"
    return ""


def open_atoms(parts: tuple[Part, ...], moment: Moment) -> list[GroundAtom]:
    """The facts that open parts of the request still wait for."""
    known = {s.id: s.atom for s in moment.letters.symbols if isinstance(s, AtomSymbol)}
    found = []
    for part in parts:
        path = part.closing() if part.verdict is Verdict.OPEN else None
        for guard in path or ():
            found += [known[id] for id in sorted(guard.positive) if id in known]
    return list(dict.fromkeys(found))
