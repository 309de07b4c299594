"""What an answer claims: ground atoms at instants, each true, and the events that show it."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from operator import itemgetter
from typing import Any, Literal

from plainspoken.planning.policy import NodeId
from plainspoken.questions.kind import Kind
from plainspoken.questions.length import Length
from plainspoken.questions.moment import Happening, Moment
from plainspoken.questions.morphology import sentence
from plainspoken.world.domain import GroundAction, GroundAtom
from plainspoken.world.event import Instant, Step

Certainty = Literal["is", "was", "will", "may"]
Evidence = Step | str
"""A step of the log, or `node 12`: a node of the policy."""

MOST_CLAIMED = 1000
"""Actions that one answer claims one by one."""


@dataclass(frozen=True, slots=True, order=True)
class Claim:
    """An atom that is true at every instant from `start` to `end`.

    `will`: in every execution that the policy allows; `may`: in at least one.
    """

    fluent: GroundAtom
    start: Instant
    end: Instant
    certainty: Certainty

    def to_json(self) -> dict[str, Any]:
        return {
            "fluent": self.fluent,
            "from": self.start,
            "to": self.end,
            "certainty": self.certainty,
        }


@dataclass(frozen=True, slots=True, order=True)
class ActionClaim:
    """An action that leads, led or may lead to an instant."""

    action: GroundAction
    at: Instant
    certainty: Certainty

    def to_json(self) -> dict[str, Any]:
        return {"action": self.action, "at": self.at, "certainty": self.certainty}


@dataclass(frozen=True, slots=True)
class Answer:
    """Words, and what they rest on.

    known:  False where the answer is that there is none
    rest:   whether it says that nothing else changes
    denied: atoms that the words say are false, at these instants
    wanted: atoms that would have to be looked at for a better answer
    """

    kind: Kind
    text: str
    claims: tuple[Claim, ...] = ()
    evidence: tuple[Evidence, ...] = ()
    denied: tuple[Claim, ...] = ()
    actions: tuple[ActionClaim, ...] = ()
    known: bool = True
    wanted: tuple[GroundAtom, ...] = ()
    rest: bool = False

    def to_json(self, id: object, question: str, seconds: float) -> dict[str, Any]:
        """The line that `ask --batch` writes."""
        return {
            "id": id,
            "question": question,
            "kind": str(self.kind),
            "answer": self.text,
            "claims": [claim.to_json() for claim in self.claims],
            "evidence": list(self.evidence),
            "denied": [claim.to_json() for claim in self.denied],
            "actions": [claim.to_json() for claim in self.actions],
            "known": self.known,
            "wanted": list(self.wanted),
            "seconds": seconds,
        }


@dataclass
class Draft:
    """An answer in the making. Every atom that comes in is looked up in the log first."""

    moment: Moment
    length: Length = Length.BRIEF
    sentences: list[str] = field(default_factory=list)
    claims: set[Claim] = field(default_factory=set)
    denied: set[Claim] = field(default_factory=set)
    actions: set[ActionClaim] = field(default_factory=set)
    evidence: set[Evidence] = field(default_factory=set)
    known: bool = True
    wanted: set[GroundAtom] = field(default_factory=set)
    rest: bool = False

    @property
    def full(self) -> bool:
        """Whether every fact that matters is wanted."""
        return self.length is Length.FULL

    @property
    def room(self) -> int:
        """Words that there is room for."""
        return self.length.words - sum(len(each.split()) for each in self.sentences)

    def say(self, text: str) -> None:
        """Add a sentence."""
        if text:
            self.sentences.append(sentence(text))

    def now(self, atoms: Iterable[GroundAtom]) -> None:
        """Claim what is true now, since when it is; deny what is not."""
        moment = self.moment
        atoms = [atom for atom in atoms if not moment.is_unsure(atom)]
        moment.look_back(atoms)
        for atom in atoms:
            since = moment.since(atom)
            if atom in moment.state:
                self.claims.add(Claim(atom, since, moment.now, "is"))
            elif atom in moment.static:
                self.claims.add(Claim(atom, 0, moment.now, "is"))
            else:
                self.denied.add(Claim(atom, since, moment.now, "is"))
            self.evidence.add(moment.steps[since])

    def was(self, atom: GroundAtom, at: Instant) -> None:
        """Claim an atom over the whole run of instants around one at which it was true."""
        runs = self.moment.runs.get(atom, [])
        index = bisect_right(runs, at, key=itemgetter(0)) - 1
        if index >= 0 and at <= runs[index][1]:
            start, end = runs[index]
            if self.moment.is_unsure(atom):
                end = min(end, self._last_seen(atom))
                if end < start:
                    return
                self.claims.add(Claim(atom, start, end, "was"))
                self.evidence.add(self.moment.steps[start])
                return
            certainty: Certainty = "is" if end == self.moment.now else "was"
            self.claims.add(Claim(atom, start, end, certainty))
            self.evidence.add(self.moment.steps[start])

    def _last_seen(self, atom: GroundAtom) -> Instant:
        """The instant at which a stale fact was seen last; before s0 where it never was."""
        known = self.moment.known(atom)
        if not known.is_stale:
            return -1
        return bisect_right(self.moment.steps, known.step) - 1

    def did(self, happening: Happening, *, changes: bool = True) -> None:
        """Claim that an action was done, and what it changed."""
        self.actions.add(ActionClaim(happening.action, happening.at, "was"))
        self.evidence.add(happening.step)
        if changes:
            before = self.moment.states[happening.at - 1]
            after = self.moment.states[happening.at]
            for atom in before - after:
                self.was(atom, happening.at - 1)
            for atom in after - before:
                self.was(atom, happening.at)

    def did_all(self, happenings: Sequence[Happening], *, changes: bool = True) -> None:
        """Claim several actions; of very many the first of each and the latest ones.

        Whoever asks about 50,000 actions reads neither as many claims nor waits for them.
        """
        if len(happenings) > MOST_CLAIMED:
            first = {each.action: each for each in reversed(happenings)}
            happenings = [*first.values(), *happenings[-MOST_CLAIMED:]]
        for each in happenings:
            self.did(each, changes=changes)

    def finish(self, kind: Kind) -> Answer:
        """The answer, its claims merged and in order."""
        return Answer(
            kind,
            " ".join(self.sentences),
            tuple(_merged(self.claims)),
            tuple(sorted(self.evidence, key=lambda each: (isinstance(each, str), _rank(each)))),
            tuple(_merged(self.denied)),
            tuple(sorted(self.actions, key=lambda claim: (claim.at, claim))),
            self.known,
            tuple(sorted(self.wanted)),
            self.rest,
        )

    def node(self, id: NodeId) -> None:
        """Note a node of the policy as evidence."""
        self.evidence.add(f"node {id}")
        self.evidence.add(self.moment.chosen_step)


def _rank(evidence: Evidence) -> int:
    return int(evidence.split()[-1]) if isinstance(evidence, str) else evidence


def _merged(claims: Iterable[Claim]) -> list[Claim]:
    """Claims of one atom and certainty joined where their instants touch."""
    found: list[Claim] = []
    for claim in sorted(claims, key=lambda c: (c.fluent, c.certainty, c.start, c.end)):
        last = found[-1] if found else None
        if (
            last is not None
            and claim.certainty != "may"  # Two executions must not become one.
            and (last.fluent, last.certainty) == (claim.fluent, claim.certainty)
            and claim.start <= last.end + 1
        ):
            found[-1] = Claim(last.fluent, last.start, max(last.end, claim.end), last.certainty)
        else:
            found.append(claim)
    return sorted(found, key=lambda c: (c.start, c.fluent, c.end))
